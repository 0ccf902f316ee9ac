"""League presets and how to find them by name."""

from __future__ import annotations

from soccer_env.known_names import unknown
from soccer_env.leagues import legged_2001, middle_size_2006
from soccer_env.leagues.league import BallModel, League, Pitch, Rules, Slots, Substeps
from soccer_env.leagues.robot import Body, Drive, Head, Kicker

LEAGUES: dict[str, League] = {
    league.name: league
    for league in (
        legged_2001.LEAGUE,
        middle_size_2006.LEAGUE,
        legged_2001.INNER,
        legged_2001.LEGS,
        middle_size_2006.OLD_BASE,
    )
}


def find_league(league: str | League) -> League:
    """Return the league of that name, or the league itself; ValueError says which names exist."""
    if isinstance(league, League):
        return league
    if not isinstance(league, str) or league not in LEAGUES:
        raise ValueError(unknown("league", league, LEAGUES))
    return LEAGUES[league]


__all__ = [
    "LEAGUES",
    "BallModel",
    "Body",
    "Drive",
    "Head",
    "Kicker",
    "League",
    "Pitch",
    "Rules",
    "Slots",
    "Substeps",
    "find_league",
]
