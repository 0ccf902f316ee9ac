"""Whatever is out of reach, unseen or in the way, nothing stalls and no field player stands still for long."""

from collections.abc import Callable
from math import cos, pi, sin
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.heinemann_2006.memory import ATTACKER, MEMORY, SCRATCH
from soccer_env.baselines.heinemann_2006.playing import DETOUR, LEAST_RADIUS, PATIENCE, STAYS, go_round, note_standing
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.types import COMMAND, Phase
from tests.baselines.heinemann_2006.test_goalkeeper import settings
from tests.scenes.staging import MIDDLE

K = constants_of(find_league(MIDDLE))[0]
STEP, STANDS, LONGEST = 0.02, 0.05, 10.0  # [s], [m/s], [s]
NO_BALL = {"ball_miss": 1.0, "false_balls": 0.0}


def stage(home: int, away: int, other: str = "still", **more: Any) -> Match:
    """Return a match in play of the team against another; nobody calls anything."""
    match = Match(MIDDLE, home=home, away=away, matches=2, seed=3, rules="none",
                  controllers={"home": "heinemann-2006", "away": other}, **more)  # fmt: skip
    match.matches["phase"] = int(Phase.PLAY)
    return match


def put(match: Match, first: int, places: list[tuple[float, float]], ball: tuple[float, float] = (0.5, 0.3)) -> Match:
    """Put players, from the one with a number on, and the ball."""
    for i, (x, y) in enumerate(places):
        match.robots["x"][:, first + i], match.robots["y"][:, first + i] = x, y
    match.balls["x"], match.balls["y"] = ball
    match.rebuild()
    return match


def ring(count: int, x: float, y: float) -> list[tuple[float, float]]:
    """Return the places of robots about a point that leave no gap for another."""
    return [(x + 0.6 * cos(2.0 * pi * i / count), y + 0.6 * sin(2.0 * pi * i / count)) for i in range(count)]


def longest_stand(match: Match, home: int, seconds: float) -> float:
    """Return for how long [s] at most a field player stood still that is not a supporter at its place."""
    stood, most = np.zeros((match.count, home)), 0.0
    for _ in range(round(seconds / STEP)):
        match.step()
        robots, memory = match.robots[:, :home], match.squads[0].memory[:, :home]
        assert np.isfinite(robots["x"]).all() and np.isfinite(robots["command"]["forward"]).all()
        waits = (memory["arrived"] == 1) & (memory["role"] != ATTACKER)
        moves = np.hypot(robots["vx"], robots["vy"]) > STANDS
        stood = np.where((robots["keeper"] == 1) | waits | moves, 0.0, stood + STEP)
        most = max(most, float(stood.max()))
    match.close()
    return most


BLOCKED: dict[str, tuple[int, Callable[[], Match]]] = {
    "a ball in a ring of robots": (6, lambda: put(stage(6, 6), 6, ring(6, 0.5, 0.3))),
    "the same, by sensors": (6, lambda: put(stage(6, 6, senses="sensors"), 6, ring(6, 0.5, 0.3))),
    "a ball never seen": (6, lambda: stage(6, 6, senses="sensors", sensors=NO_BALL)),
    "a ball never seen, somebody where it is looked for": (
        3,
        lambda: put(stage(3, 3, senses="sensors", sensors=NO_BALL), 4, [(3.0, 0.0), (-3.0, 0.0)], (0.0, 3.5)),
    ),
    "a ball outside the field": (4, lambda: put(stage(4, 2), 5, [(3.0, 0.0)], (1.0, 4.7))),
    "a robot alone": (2, lambda: stage(2, 1)),
}


@pytest.mark.parametrize("scene", BLOCKED)
def test_no_field_player_stands_still_for_long_whose_place_is_out_of_reach_or_who_has_lost_the_ball(scene: str) -> None:
    home, made = BLOCKED[scene]
    assert longest_stand(made(), home, 25.0) < LONGEST


def test_who_stands_away_from_its_place_goes_round_the_ball_after_a_while_and_always_to_one_side() -> None:
    scratch, memory, command = (np.zeros(1, dtype)[0] for dtype in (SCRATCH, MEMORY, COMMAND))
    sight, told, play = scratch["sight"], scratch["told"], settings()
    told["phase"], sight["elapsed"], sight["pace"] = int(Phase.PLAY), STEP, 1.0
    sight["x"], sight["y"], sight["cosine"] = -0.4, -0.3, 1.0
    steps = round(PATIENCE / STEP)
    for _ in range(steps - 1):
        note_standing(told, memory, sight)
    assert memory["detour"] == 0.0
    sight["y"], sight["vy"] = -0.3 + 0.9 * STAYS, 1.0  # its wheels spin: only where it believes to be tells it
    for _ in range(3):
        note_standing(told, memory, sight)
    assert memory["detour_side"] == 1.0 and memory["detour"] == pytest.approx(DETOUR, abs=3 * STEP)
    sight["y"] = -0.3
    for _ in range(steps + 3):
        note_standing(told, memory, sight)
    assert memory["detour"] > 0.0 and memory["detour_side"] == 1.0
    go_round(command, memory, K, play, scratch)
    plan = scratch["plan"][0]
    assert plan["target"]["x"] == pytest.approx(0.6 * LEAST_RADIUS)
    assert plan["target"]["y"] == pytest.approx(-0.8 * LEAST_RADIUS)
