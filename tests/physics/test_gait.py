"""The trot: a paw in its stance stands still over the ground, one that swings goes at twice the speed of the walk."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.physics.gait import LEGS, most_swing, paw_offset, stance
from tests.scenes.staging import LEGGED, MIDDLE, asking, endless, place, play, stage, steady

LEFT_FORE, RIGHT_FORE, LEFT_HIND, RIGHT_HIND = range(LEGS)
AT_FULL_SPEED = 24  # control steps after which a robot walks as it was asked to, gait steps of 8


def walker(forward: float = 0.0, left: float = 0.0, turn: float = 0.0, handedness: float = 1.0) -> Match:
    """Return a match in which robot 0 has walked on an endless pitch without slip until its speed is constant."""
    match = stage(steady(endless(LEGGED)))
    match.matches["handedness"] = handedness
    place(match, ball=(50.0, 50.0), robots={0: (0.0, 0.0, 0.7)})
    play(match, actions=asking(match, forward=forward, left=left, turn=turn), steps=AT_FULL_SPEED)
    return match


def cycle(match: Match, forward: float = 0.0, left: float = 0.0, turn: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Return where the paws are over one gait step: off their stance (9, 4, 2), and on the field (9, 4, 2)."""
    k = constants_of(match.league)[0]
    handedness, off, places = float(match.matches["handedness"][0]), [], []
    for step in range(match.league.drive.gait_steps + 1):
        if step > 0:
            match.step(asking(match, forward=forward, left=left, turn=turn))
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


def test_the_paws_of_a_robot_that_stands_are_where_they_stand() -> None:
    off, _ = cycle(walker())
    assert not off.any()


def test_in_a_mirrored_match_the_legs_of_the_other_side_swing_first() -> None:
    """They have the numbers of their mirror images."""
    one, _ = cycle(walker(forward=0.8, left=0.3, turn=0.5), forward=0.8, left=0.3, turn=0.5)
    other, _ = cycle(walker(0.8, -0.3, -0.5, handedness=-1.0), forward=0.8, left=-0.3, turn=-0.5)
    np.testing.assert_array_equal(one, other * (1.0, -1.0))
    assert abs(one).max() > 0.01


def test_no_paw_swings_farther_than_it_can() -> None:
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


def test_legs_need_gait_steps_in_which_a_swing_ends_with_a_control_step() -> None:
    league = find_league(LEGGED)
    with pytest.raises(ValueError, match=r"Drive\.gait_steps must be even for a body with legs, got 7"):
        replace(league, drive=replace(league.drive, gait_steps=7))
    replace(find_league("legged-2001-smooth"), drive=replace(league.drive, gait_steps=7))
