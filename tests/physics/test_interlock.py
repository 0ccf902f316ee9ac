"""Legs that stand between the legs of another robot are held there, in every direction but straight apart."""

import numpy as np
import pytest

from soccer_env import Match
from tests.scenes.staging import LEGGED, asking, endless, play, put, put_ball, stage, stand, steady, steps_in

DEEP, BESIDE = 0.010, 0.021  # [m] from a leg's axis to the line between two legs: less than its radius, and more
SIDES = ("fore", "left")  # of the robot between whose legs another one's leg stands
WALKS = {  # of the one that is held
    "left": (0.0, 1.0, 0.0), "right": (0.0, -1.0, 0.0), "ahead": (1.0, 0.0, 0.0),
    "turning left": (0.0, 0.0, 1.0), "turning right": (0.0, 0.0, -1.0), "ahead and left": (0.8, 0.6, 0.0),
}  # fmt: skip
HELD = 2e-3  # [m] along the line between two legs
TURNED = 0.006  # [m] farther in: two robots that hold a leg of each other are held between the two, and may turn there


def caught(side: str, out: float = DEEP, matches: int = 1) -> Match:
    """Return a match in which the left forepaw of robot 0 is `out` [m] before a gap between two legs of robot 1.

    Robot 1 stands in the middle and heads along x; robot 0 looks into the gap.
    """
    match = stage(steady(endless(LEGGED)), matches)
    body = match.league.body
    put(match, 1, 0.0, 0.0)
    put_ball(match, 50.0, 50.0)
    if side == "fore":
        put(match, 0, body.tip_x + out + body.tip_x, body.tip_y, np.pi)
    else:  # both forepaws between its legs
        put(match, 0, 0.07 - body.tip_y, line_of_left_legs(match, 0.07) + out + body.tip_x, -np.pi / 2)
    match.rebuild()
    return match


def line_of_left_legs(match: Match, x: float) -> float:
    """Return how far to the left the line from the fore to the hind leg is [m] at a place ahead of the centre [m]."""
    body = match.league.body
    share = (x - body.hind_x) / (body.tip_x - body.hind_x)
    return float(body.hind_y + share * (body.tip_y - body.hind_y))


def leg(match: Match) -> np.ndarray:
    """Return where the left forepaw of robot 0 stands in the frame of robot 1 (2,) [m]."""
    one, other = match.robots[0]
    body, turn = match.league.body, one["heading"]
    x = one["x"] + np.cos(turn) * body.tip_x - np.sin(turn) * body.tip_y - other["x"]
    y = one["y"] + np.sin(turn) * body.tip_x + np.cos(turn) * body.tip_y - other["y"]
    turn = -other["heading"]
    return np.array([np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y])


def way(match: Match, seconds: float, forward: float = 0.0, left: float = 0.0, turn: float = 0.0) -> np.ndarray:
    """Let robot 0 walk for a time [s]; return how its leg has moved in the frame of robot 1 (steps, 2) [m]."""
    places = [leg(match)]
    for _ in range(steps_in(match, seconds)):
        match.step(asking(match, forward=forward, left=left, turn=turn))
        places.append(leg(match))
    return np.array(places) - places[0]


def along_and_out(side: str, moved: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return motion (steps, 2) along the line between the two legs and out of the gap [m]."""
    return (moved[:, 1], moved[:, 0]) if side == "fore" else (moved[:, 0], moved[:, 1])


@pytest.mark.parametrize("walk", WALKS)
@pytest.mark.parametrize("side", SIDES)
def test_ms51_a_leg_between_two_legs_of_another_robot_moves_straight_out_or_not_at_all(side, walk):
    """A robot that pulls aside turns round the leg that is held, and so comes out of the gap at last."""
    match = caught(side)
    forward, left, turn = WALKS[walk]
    along, out = along_and_out(side, way(match, 1.5, forward, left, turn))
    within = np.maximum.accumulate(out) < match.league.body.tip_radius - DEEP
    assert within.sum() > steps_in(match, 0.6), "so long that a free leg would have gone"
    assert abs(along[within]).max() < HELD
    assert out.min() > -TURNED


@pytest.mark.parametrize("side", SIDES)
def test_ms51_it_comes_free_straight_apart(side):
    match = caught(side)
    along, out = along_and_out(side, way(match, 3.0, forward=-1.0))
    assert out[-1] == pytest.approx(free_way(match), abs=2e-3), "as if nothing had held it"
    assert abs(along).max() < 1e-3
    assert not match.robots["caught_by"].any()


def free_way(match: Match) -> float:
    """Return how far a robot that nobody holds walks back in 3 s [m]."""
    alone = stage(match.league, ball=(50.0, 50.0), robots={0: (0.0, 0.0)})
    play(alone, 3.0, asking(alone, forward=-1.0))
    return float(-alone.robots["x"][0, 0])


@pytest.mark.parametrize("side", SIDES)
def test_ms51_a_leg_beside_the_gap_is_free(side):
    match = caught(side, BESIDE)
    along, _ = along_and_out(side, way(match, 1.5, left=1.0))
    assert not match.robots["caught_by"].any()
    assert abs(along).max() > 0.015


def test_a_leg_that_has_come_twice_its_width_out_is_free_before_the_gait_step_ends():
    """And so is one whose robot the referee has carried away; one just within reach is still held."""
    match = caught("fore")
    match.step(stand(match))
    assert (match.robots["caught_by"] > 0).any()
    moved = {}
    for out in (0.025, 0.045, 1.0):  # [m] from the line between the legs; they are held up to 2 times 20 mm
        carried = caught("fore", out)
        for name in ("caught_by", "caught_leg", "caught_gap"):
            carried.robots[name] = match.robots[name]
        carried.robots["gait_phase"] = 1
        carried.robots["vy"][:, 0] = 0.2
        carried.rebuild()
        moved[out] = abs(way(carried, 0.0625))[-1, 1]
    assert moved[1.0] > 0.006, "it slides"
    assert moved[0.045] == pytest.approx(moved[1.0], rel=0.05) and moved[0.025] < 0.5 * moved[1.0]
