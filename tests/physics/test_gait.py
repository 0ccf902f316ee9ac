"""The trot, and legs that stand between those of another robot: held in every direction but straight apart."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.physics.gait import LEGS, most_swing, paw_offset, stance
from tests.scenes.leagues import LEGGED, MIDDLE, endless, steady
from tests.scenes.staging import place, play, put, put_ball, record_each_step, robot_actions, stage, stand, steps_in

LEFT_FORE, RIGHT_FORE, LEFT_HIND, RIGHT_HIND = range(LEGS)
AT_FULL_SPEED = 24  # control steps after which a robot walks as it was asked to, gait steps of 8


def walker(forward: float = 0.0, left: float = 0.0, turn: float = 0.0, handedness: float = 1.0) -> Match:
    """Return a match in which robot 0 has walked on an endless pitch without slip until its speed is constant."""
    match = stage(steady(endless(LEGGED)))
    match.matches["handedness"] = handedness
    place(match, ball=(50.0, 50.0), robots={0: (0.0, 0.0, 0.7)})
    play(match, actions=robot_actions(match, forward=forward, left=left, turn=turn), steps=AT_FULL_SPEED)
    return match


def cycle(match: Match, forward: float = 0.0, left: float = 0.0, turn: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Return where the paws are over one gait step: off their stance (9, 4, 2), and on the field (9, 4, 2)."""
    k = constants_of(match.league)[0]
    handedness, off, places = float(match.matches["handedness"][0]), [], []
    for step in range(match.league.drive.gait_steps + 1):
        if step > 0:
            match.step(robot_actions(match, forward=forward, left=left, turn=turn))
        robot = match.robots[0, 0]
        offsets = np.array([paw_offset(robot, k, leg, handedness) for leg in range(LEGS)])
        cosine, sine = np.cos(robot["heading"]), np.sin(robot["heading"])
        paws = offsets + [stance(k, leg, handedness) for leg in range(LEGS)]
        off.append(offsets)
        places.append(paws @ np.array([[cosine, sine], [-sine, cosine]]) + (robot["x"], robot["y"]))
    return np.array(off), np.array(places)


@pytest.mark.parametrize("direction", [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.6, -0.8)])
def test_ms51_a_paw_in_its_stance_stands_still_and_one_that_swings_is_twice_as_fast_as_the_walk(direction) -> None:
    walk = {"forward": direction[0], "left": direction[1]}
    match = walker(**walk)
    speed = np.hypot(match.robots["vx"][0, 0], match.robots["vy"][0, 0])
    _, places = cycle(match, **walk)
    speeds = np.hypot(*np.moveaxis(np.diff(places, axis=0), -1, 0)) / match.league.dt
    first, second = [LEFT_FORE, RIGHT_HIND], [RIGHT_FORE, LEFT_HIND]
    np.testing.assert_allclose(speeds[:4, first], 2.0 * speed, rtol=1e-9)
    np.testing.assert_allclose(speeds[4:, first], 0.0, atol=1e-9)
    np.testing.assert_allclose(speeds[4:, second], 2.0 * speed, rtol=1e-9)
    np.testing.assert_allclose(speeds[:4, second], 0.0, atol=1e-9)


def test_ms51_at_12_cm_per_s_and_steps_of_half_a_second_a_stroke_is_3_cm() -> None:
    match = walker(forward=1.0)
    assert match.robots["vx"][0, 0] / np.cos(0.7) == pytest.approx(0.12)
    off, _ = cycle(match, forward=1.0)
    assert off[:, :, 1].tolist() == np.zeros((9, 4)).tolist()
    ahead = [-0.015, -0.0075, 0.0, 0.0075, 0.015, 0.0075, 0.0, -0.0075, -0.015]
    np.testing.assert_allclose(off[:, LEFT_FORE, 0], ahead, atol=1e-12)
    np.testing.assert_allclose(off[:, RIGHT_HIND], off[:, LEFT_FORE], atol=1e-12)
    np.testing.assert_allclose(off[:, [RIGHT_FORE, LEFT_HIND]], -off[:, [LEFT_FORE, RIGHT_HIND]], atol=1e-12)


def test_ms51_a_robot_that_turns_on_the_spot_moves_its_paws_round_its_centre() -> None:
    """Along straight strokes, so that a paw in its stance slips by what differs from an arc."""
    match = walker(turn=1.0)
    k = constants_of(match.league)[0]
    off, places = cycle(match, turn=1.0)
    for leg in range(LEGS):
        x, y = stance(k, leg, 1.0)
        stroke = 0.8 * 0.25 * np.hypot(x, y)  # [m] 0.8 rad/s for a quarter of a second
        assert np.hypot(*off[0, leg]) == pytest.approx(0.5 * stroke)
        assert off[0, leg] @ (x, y) == pytest.approx(0.0, abs=1e-12)
    assert np.hypot(*(places[0] - places[4])[[RIGHT_FORE, LEFT_HIND]].T).max() < 0.001


def test_the_paws_of_a_robot_that_stands_rest_and_in_a_mirrored_match_the_other_legs_swing_first() -> None:
    """They have the numbers of their mirror images."""
    off, _ = cycle(walker())
    assert not off.any()
    one, _ = cycle(walker(forward=0.8, left=0.3, turn=0.5), forward=0.8, left=0.3, turn=0.5)
    other, _ = cycle(walker(0.8, -0.3, -0.5, handedness=-1.0), forward=0.8, left=-0.3, turn=-0.5)
    np.testing.assert_array_equal(one, other * (1.0, -1.0))
    assert abs(one).max() > 0.01


def test_no_paw_swings_farther_than_it_can_and_a_swing_ends_with_a_control_step() -> None:
    match = stage(endless(LEGGED), 50, robots={0: (0.0, 0.0), 1: (10.0, 0.0)})
    k, rng = constants_of(match.league)[0], np.random.default_rng(1)
    farthest = 0.0
    for _ in range(10):
        actions = rng.choice([-1.0, 1.0], (50, 2, 4))
        play(match, actions=actions, steps=8)
        offsets = [paw_offset(robot, k, leg, 1.0) for robot in match.robots.flat for leg in range(LEGS)]
        farthest = max(farthest, np.hypot(*np.transpose(offsets)).max())
    assert 0.6 * most_swing(k) < farthest <= most_swing(k)
    assert most_swing(constants_of(find_league(MIDDLE))[0]) == 0.0
    league = find_league(LEGGED)
    with pytest.raises(ValueError, match=r"Drive\.gait_steps must be even for a body with legs, got 7"):
        replace(league, drive=replace(league.drive, gait_steps=7))
    replace(find_league("legged-2001-smooth"), drive=replace(league.drive, gait_steps=7))


DEEP, BESIDE = 0.010, 0.021  # [m] from a leg's axis to the line between two legs: less than its radius, and more
SIDES = ("fore", "left")  # of the robot between whose legs another one's leg stands
WALKS = {  # of the one that is held
    "left": (0.0, 1.0, 0.0), "right": (0.0, -1.0, 0.0), "ahead": (1.0, 0.0, 0.0),
    "turning left": (0.0, 0.0, 1.0), "turning right": (0.0, 0.0, -1.0), "ahead and left": (0.8, 0.6, 0.0),
}  # fmt: skip
HELD = 3e-3  # [m] along the line between two legs, while the other one pulls with all its traction
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
    start, asked = leg(match), robot_actions(match, forward=forward, left=left, turn=turn)
    return np.array([start, *record_each_step(match, lambda: leg(match), seconds, asked)]) - start


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
    play(alone, 3.0, robot_actions(alone, forward=-1.0))
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
        carried.robots["vy"][:, 0] = 0.3
        carried.rebuild()
        moved[out] = abs(way(carried, 0.0625))[-1, 1]
    assert moved[1.0] > 0.006, "it slides"
    assert moved[0.045] == pytest.approx(moved[1.0], rel=0.05) and moved[0.025] < 0.5 * moved[1.0]
