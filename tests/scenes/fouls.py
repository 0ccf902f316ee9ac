"""Stage fouls for tests: one rule of the legged league at a time, and what is whistled."""

from math import pi

import numpy as np

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.types import Foul
from tests.scenes.staging import LEGGED, put, put_ball, stage, stand

BODY = find_league(LEGGED).body
PITCH = find_league(LEGGED).pitch
NOSES = 2.0 * (BODY.tip_x + BODY.tip_radius) + 0.002  # [m] between the centres of two robots whose paws touch
POCKET = BODY.front + find_league(LEGGED).ball.radius + 0.001  # [m] of a ball between the forepaws from the centre
KEEPER, OTHER_KEEPER = 0, 3  # rows of 3 against 3; home is 0 to 2 and attacks +x
FOOT_IN = 0.5 * PITCH.length - PITCH.penalty_depth  # [m] where the penalty area begins


def court(rules: str, matches: int = 1, league: str = LEGGED, **settings: object) -> Match:
    """Return 3 against 3 under the simple rules and what is said, without dropped balls; nobody is on the pitch."""
    match = stage(league, matches, 3, 3, rules=f"simple:dropped_ball=False,{rules}", **settings)
    put_ball(match, 0.0, -0.88)
    match.robots["trespass"] = 0.0  # the kick-off gave them time to walk out of where it put them
    return match


def face(match: Match, r: int, other: int, x: float, y: float = 0.4) -> None:
    """Put robot r at x [m], facing +x, and another right before its paws, facing it."""
    put(match, r, x, y, 0.0)
    put(match, other, x + NOSES, y, pi)


def asks(match: Match, **walks: float) -> np.ndarray:
    """Return actions: robot r asks for r<r>=forward, in -1 to 1; the others stand."""
    actions = stand(match)
    for name, forward in walks.items():
        actions[:, int(name[1:]), 0] = forward
    return actions


def fouls(match: Match, actions: np.ndarray, seconds: float) -> list[tuple[float, int, Foul]]:
    """Play on; return (second, row, foul) of all whistles of match 0."""
    found = []
    for step in range(round(seconds * match.league.control_rate)):
        match.step(actions)
        for r in np.flatnonzero(match.robot_events["foul"][0]):
            found.append(((step + 1) * match.league.dt, int(r), Foul(match.robot_events["foul"][0, r])))
    return found


def rows(found: list[tuple[float, int, Foul]]) -> list[int]:
    """Return the rows of those who were whistled, in order."""
    return [row for _, row, _ in found]
