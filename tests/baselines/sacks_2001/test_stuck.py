"""How a player of sacks-2001 notices that it is stuck: by counting readings in which the ball does not come nearer."""

from statistics import NormalDist

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, DRIBBLE, SHOOT, SUPPORT
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from tests.scenes.sacks_mind import LEAGUE, RATE, Mind

COUNT = SacksSettings().stuck_count
HAS_BALL = (DRIBBLE, SHOOT)  # what is done with a ball that is not gone for
READING = 1.0 / 3.0  # [s] between two readings
FAR = 0.6  # [m] from the ball, and not near it
CAMERA = LEAGUE.head.camera_ahead  # [m] from which a ball is near or not
NOISE = 0.21  # [1/(m s)] sd of the filtered radial velocity over distance squared, at 88x72, simulated


@pytest.mark.parametrize("radial", [0.0, 0.1, -0.02])
def test_ms19_a_ball_that_does_not_come_nearer_is_counted_until_the_robot_is_stuck(radial: float) -> None:
    mind = Mind()
    mind.see_ball(FAR, radial=radial)
    mind.think(COUNT * READING - 0.2)
    assert mind.memory["stuck"] == COUNT - 1 and mind.memory["behaviour"] == APPROACH
    mind.think(0.4)
    assert mind.memory["behaviour"] == BACK


def test_ms19_a_ball_that_clearly_comes_nearer_is_taken_off_and_the_count_is_never_below_zero() -> None:
    mind = Mind()
    mind.see_ball(FAR)
    mind.think(5 * READING + 0.1)
    assert mind.memory["stuck"] == 5
    mind.see_ball(FAR, radial=-0.12)
    mind.think(3 * READING)
    assert mind.memory["stuck"] == 2
    mind.think(9 * READING)
    assert mind.memory["stuck"] == 0
    mind.see_ball(FAR)
    mind.think(2 * READING)
    assert mind.memory["stuck"] == 2


def test_ms19_between_the_bands_the_count_rests() -> None:
    mind = Mind()
    mind.see_ball(FAR)
    mind.think(3 * READING + 0.1)
    mind.see_ball(FAR, radial=-0.04)
    mind.think(9 * READING)
    assert mind.memory["stuck"] == 3


@pytest.mark.parametrize("distance", [0.6, 1.8, 2.5])
def test_ms19_however_wrong_velocities_are_the_count_falls_for_who_walks_and_rises_for_who_stands(
    distance: float,
) -> None:
    errors = [NOISE * distance**2 * NormalDist().inv_cdf((i + 0.5) / 400) for i in range(400)]
    for speed, falls in ((LEAGUE.drive.forward, True), (0.0, False)):
        mind = Mind(stuck_count=10_000)
        mind.stand_at(-1.4, 0.0)
        mind.memory["stuck"] = begun = 1000
        for error in errors:
            mind.see_ball(distance, radial=error - speed)
            mind.memory["reading"] = READING
            mind.think()
        assert (mind.memory["stuck"] < begun) == falls


def test_ms20_near_the_ball_both_counters_must_agree() -> None:
    one, two = Mind(two_counters=False), Mind()
    for mind in (one, two):
        mind.see_ball(0.3)
        mind.think(COUNT * READING + 0.2)
    assert one.memory["behaviour"] == BACK and two.memory["behaviour"] == APPROACH
    two.think(SacksSettings().near_time - COUNT * READING - 0.3)
    assert two.memory["behaviour"] == APPROACH
    two.think(0.3)
    assert two.memory["behaviour"] == BACK


def test_ms20_the_second_counter_is_time_within_35_cm_of_the_camera_and_time_beyond_is_taken_off() -> None:
    mind = Mind(stuck_count=1000)
    mind.see_ball(CAMERA + 0.34)
    mind.think(3.0)
    assert mind.memory["near"] == pytest.approx(3.0)
    mind.see_ball(CAMERA + 0.36)
    mind.think()
    assert mind.memory["near"] == pytest.approx(3.0 - 1.0 / RATE)
    mind.think(4.0)
    assert mind.memory["near"] == 0.0
    mind.see_ball(CAMERA + 0.34, bearing=0.5)  # aside it is farther from the camera than ahead
    mind.think()
    assert mind.memory["near"] == 0.0


def test_ms20_one_reading_beyond_35_cm_neither_ends_the_time_nor_makes_a_robot_think_itself_stuck() -> None:
    mind = Mind()
    mind.see_ball(CAMERA + 0.3)
    mind.think(5.0)
    mind.belief["ball"]["distance"] = CAMERA + 0.4  # one estimate; the mean of the last four is still near
    mind.think()
    assert mind.memory["near"] == pytest.approx(5.0 + 1.0 / RATE) and mind.memory["behaviour"] == APPROACH


def test_ms21_within_35_cm_steps_shrink_with_the_distance_until_the_ball_hardly_comes_nearer() -> None:
    speeds = []
    for gap in (0.36, 0.349, 0.175, 0.05, 0.01):
        mind = Mind()
        mind.see_ball(CAMERA + gap)
        speeds.append(mind.think()[0, 0])
    share = np.array(speeds) / speeds[0]
    least = SacksSettings().near_step
    np.testing.assert_allclose(share, [1.0, 0.349 / 0.35, 0.5, least, least], rtol=1e-6)
    assert speeds[-1] * LEAGUE.drive.forward <= SacksSettings().near_zero + 1e-9


def test_ms21_who_has_just_had_the_ball_walks_on_at_full_pace() -> None:
    mind = Mind()
    mind.see_ball(CAMERA + 0.01)
    mind.memory["begun"], mind.memory["had_ball"] = 1, 0.1
    mind.belief["obstacle"]["distance"] = 0.2  # an opponent before it: the ball is contested
    assert mind.think()[0, 0] == pytest.approx(1.0)


def test_ms22_only_who_tries_to_get_to_the_ball_counts() -> None:
    supporter, dribbler, attacker = Mind(), Mind(shoots=False), Mind()
    supporter.belief["heard"]["distance"], supporter.belief["heard"]["age"] = 0.2, 0.1
    dribbler.see_ball(0.147, held=1)
    for mind in (supporter, attacker):
        mind.see_ball(FAR)
    for mind in (supporter, dribbler, attacker):
        mind.think(2.0)
    assert supporter.memory["behaviour"] == SUPPORT and dribbler.memory["behaviour"] in HAS_BALL
    assert supporter.memory["stuck"] == dribbler.memory["stuck"] == 0 < attacker.memory["stuck"]


def test_ms22_who_went_on_to_something_else_begins_to_count_anew() -> None:
    for other in ("possession", "support"):
        mind = Mind(stuck_count=1000)
        mind.see_ball(FAR)
        mind.think(2.0)
        assert mind.memory["stuck"] > 0
        if other == "possession":
            mind.see_ball(0.147, held=1)
        else:
            mind.belief["heard"]["distance"], mind.belief["heard"]["age"] = 0.2, 0.1
        mind.think(2.0)
        assert mind.memory["stuck"] == 0 and mind.memory["behaviour"] in (*HAS_BALL, SUPPORT)
