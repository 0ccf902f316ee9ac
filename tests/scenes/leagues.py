"""The leagues that tests play in, and leagues with something taken out."""

from dataclasses import replace

import pytest

from soccer_env.leagues import League
from soccer_env.match.staging import league_without_calls as league_without_calls

LEGGED, MIDDLE = "legged-2001", "middle-size-2006"
LEAGUES = (LEGGED, MIDDLE)
each_league = pytest.mark.parametrize("name", LEAGUES)


def endless(league: str | League) -> League:
    """Return the league, with a patient referee, on a pitch so large that nothing reaches its edge."""
    found = league_without_calls(league)
    return replace(found, pitch=replace(found.pitch, length=400.0, width=400.0))


def boarded(league: str | League) -> League:
    """Return the league with upright boards on its lines, no band and no ramps, and a patient referee."""
    found = league_without_calls(league)
    return replace(
        found, pitch=replace(found.pitch, walled=True, band_side=0.0, band_end=0.0, ramp=0.0, board_foot=0.0)
    )


def steady(league: str | League) -> League:
    """Return the league, with a patient referee, where no robot slips and all kicks are alike."""
    found = league_without_calls(league)
    kicker = replace(found.kicker, spread=0.0, speed_spread=0.0, miss=0.0)
    return replace(found, drive=replace(found.drive, slip=0.0), kicker=kicker)


def icy(league: str | League) -> League:
    """Return the league, with a patient referee, on a carpet without friction."""
    found = league_without_calls(league)
    return replace(found, ball=replace(found.ball, rolling=0.0, sliding=1e-9, pivot=0.0))
