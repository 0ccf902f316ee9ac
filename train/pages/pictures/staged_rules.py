"""A situation that a referee has to judge: a match under rules, and what its robots do."""

from collections.abc import Mapping, Sequence

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.match import Match, staging
from soccer_env.types import Phase

Pose = tuple[float, float, float]  # [m, m, rad]
Staged = tuple[Match, np.ndarray]  # one match, and the actions (1, R, 4) of its robots


def stage_rule(
    league: League,
    places: Sequence[Pose],
    ball: tuple[float, float],
    robots: Mapping[int, Pose],
    ahead: Mapping[int, float],
    running: bool = False,
    rules: str = "league",
    **records: float,
) -> Staged:
    """Return a match in play, half of its robots a side, and its actions.

    `ball` [m, m], `robots` pose by row, the others at their `places`; `ahead` how fast who goes, in -1 to 1, if
    `running` from the start; `records` are fields of the match.
    """
    match = Match(league, home=len(places) // 2, away=len(places) // 2, seed=1, rules=rules)
    staging.set_phase(match, Phase.PLAY)
    for row, place in enumerate(places):
        speed = ahead.get(row, 0.0) * league.drive.forward if running else 0.0
        staging.put(match, row, *robots.get(row, place), forward=speed)
    staging.put_ball(match, *ball)
    for name, value in records.items():
        match.matches[name] = value
    staging.begin(match)
    actions = np.zeros((1, len(places), 4))
    for row, share in ahead.items():
        actions[0, row, 0] = share
    return match, actions
