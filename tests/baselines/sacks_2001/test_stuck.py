"""How a player of sacks-2001 notices that it is stuck: by counting readings in which the ball does not come nearer."""

import pytest

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, DRIBBLE, SUPPORT
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from tests.scenes.sacks_mind import Mind

COUNT = SacksSettings().stuck_count
READING = 1.0 / 3.0  # [s] between two readings
FAR = 0.5  # [m] from the ball, and not near it


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


def test_ms20_the_second_counter_begins_anew_at_35_cm() -> None:
    mind = Mind(stuck_count=1000)
    mind.see_ball(0.34)
    mind.think(3.0)
    assert mind.memory["near"] == pytest.approx(3.0, abs=0.1)
    mind.see_ball(0.36)
    mind.think()
    assert mind.memory["near"] == 0.0


def test_ms21_steps_are_shorter_within_35_cm() -> None:
    mind = Mind()
    mind.see_ball(0.36)
    far = mind.think()[0, 0]
    mind.see_ball(0.34)
    near = mind.think()[0, 0]
    assert near == pytest.approx(SacksSettings().near_step * far) and near < far


def test_ms22_only_who_tries_to_get_to_the_ball_counts() -> None:
    supporter, dribbler, attacker = Mind(), Mind(), Mind()
    supporter.belief["heard"]["distance"], supporter.belief["heard"]["age"] = 0.2, 0.1
    dribbler.see_ball(0.147, held=1)
    for mind in (supporter, attacker):
        mind.see_ball(FAR)
    for mind in (supporter, dribbler, attacker):
        mind.think(2.0)
    assert supporter.memory["behaviour"] == SUPPORT and dribbler.memory["behaviour"] == DRIBBLE
    assert supporter.memory["stuck"] == dribbler.memory["stuck"] == 0 < attacker.memory["stuck"]


def test_ms22_who_went_on_to_something_else_begins_to_count_anew() -> None:
    mind = Mind()
    mind.see_ball(FAR)
    mind.think(2.0)
    mind.see_ball(0.147, held=1)
    mind.think(0.5)
    assert mind.memory["stuck"] == 0
