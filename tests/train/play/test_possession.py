"""Spells, touches and kicks: recordings made by hand, each with a known answer."""

import pytest

from soccer_env.train.play.possession import escorts, kicks, spells, touches
from soccer_env.types import Phase
from tests.train.play.recordings import blank

RATE = 50  # [1/s] of the middle size


def test_a_spell_goes_on_over_a_short_break_and_ends_with_a_long_one_or_a_whistle() -> None:
    play = blank(500, matches=2)
    for first, last in ((0, 100), (120, 150), (200, 250)):  # breaks of 0.4 s and of 1 s
        play.robots["has_ball"][first:last, 0, 1] = 1
    play.robots["has_ball"][:, 1, 0], play.matches["phase"][300:, 1] = 1, Phase.CORNER_KICK
    found = spells(play)
    assert [ones.tolist() for ones in found["spells"]] == [pytest.approx([3.0, 1.0]), pytest.approx([6.0])]
    assert found["held"] == pytest.approx([3.6, 6.0])


def test_who_goes_with_the_ball_beside_an_opponent_is_escorted_while_that_one_is_near_and_he_moves() -> None:
    play = blank(300)
    play.robots["has_ball"][:, 0, 0], play.robots["vx"][:250, 0, 0] = 1, 0.4
    play.robots["x"][:, 0, 0], play.robots["x"][:, 0, 1] = 0.0, 9.0
    play.robots["team"][:, 0, 1] = 1
    play.robots["x"][100:, 0, 1] = 0.6
    play.robots["x"][150:155, 0, 1] = 0.8  # a break of 0.1 s
    assert [ones.tolist() for ones in escorts(play)["escorts"]] == [pytest.approx([3.0])]
    play.robots["team"][:] = 0
    assert [ones.tolist() for ones in escorts(play)["escorts"]] == [[]]


def test_a_touch_counts_anew_after_a_second_without_and_for_every_robot() -> None:
    play = blank(300)
    for step, robot in ((0, 0), (1, 0), (40, 0), (120, 0), (121, 1)):  # 0.8 s, then 1.6 s later
        play.deeds["touch"][step, 0, robot] = 1
        play.matches["last_touch_robot"][step:, 0] = robot
    assert touches(play)["touches"].tolist() == [3]
    assert touches(play)["changes"].tolist() == [1]


def test_kicks_are_counted_with_the_speed_of_the_ball_after_them() -> None:
    play = blank(10, matches=2)
    play.deeds["kick"][[2, 7], 1, 0] = 1
    play.balls["vx"][2, 1], play.balls["vy"][7, 1] = 3.0, -4.0
    found = kicks(play)
    assert found["kicks"].tolist() == [0, 2]
    assert [ones.tolist() for ones in found["kick_speeds"]] == [[], pytest.approx([3.0, 4.0])]
