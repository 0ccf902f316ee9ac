"""What the referee's hand does to play: recordings made by hand, each with a known answer."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.train.play import referee
from soccer_env.train.play.figures import work_out
from soccer_env.types import AWAY, HOME, Phase
from tests.train.play.recordings import blank, put

RATE = find_league("middle-size-2006").control_rate


def test_a_goal_six_seconds_after_a_separation_follows_from_it_and_a_later_one_does_not() -> None:
    play = blank(40 * RATE, matches=2)
    play.events["separated"][10 * RATE] = 1
    play.events["goal"][16 * RATE, 0] = HOME
    play.events["goal"][16 * RATE + 1, 1] = AWAY
    found = referee.after_separations(play)
    assert found["goals_soon"].tolist() == [1, 0] and found["goals_else"].tolist() == [0, 1]
    assert found["time_soon"] == pytest.approx([6.0, 6.0]) and found["time_else"] == pytest.approx([34.0, 34.0])
    rates = [work_out(figure, found).value for figure in referee.MEASURES[0].figures]
    assert rates == pytest.approx([60 / 12, 60 / 68, 60 / 12 - 60 / 68])


def test_a_goal_in_the_step_of_a_separation_does_not_follow_from_it() -> None:
    play = blank(10 * RATE)
    play.events["separated"][RATE], play.events["goal"][RATE] = 1, HOME
    assert referee.after_separations(play)["goals_soon"].tolist() == [0]


def test_who_is_carried_and_how_far_and_that_driving_and_penalties_do_not_count() -> None:
    play = blank(30, robots=4)
    for r, away in enumerate((0.9, 0.1, 0.5, 0.7)):
        put(play, r, np.where(np.arange(30) < 10, 0.0, away), float(r))
    play.events["restart"][10], play.events["separated"][20] = Phase.DROP_BALL, 1
    play.deeds["returned"][10, 0, 2] = 1
    play.robots["active"][:10, :, 3] = 0
    assert referee.carried_at_drops(play)["carried_at_drops"][0].tolist() == pytest.approx([0.9])
    assert referee.carried_apart(play)["carried_apart"][0].tolist() == []


def test_a_keeper_that_is_carried_far_and_concedes() -> None:
    play = blank(60 * RATE, matches=3, robots=2)
    play.robots["keeper"][..., 1], play.robots["team"][..., 1] = 1, AWAY
    put(play, 1, np.where(np.arange(60 * RATE) < RATE, 0.0, 0.9), 0.0)
    play.events["restart"][RATE] = play.events["restart"][2 * RATE] = Phase.DROP_BALL
    play.events["goal"][26 * RATE, 0] = HOME
    play.events["goal"][26 * RATE + 1, 1] = HOME
    play.events["goal"][20 * RATE, 2] = AWAY
    found = referee.keepers_at_drops(play)
    assert found["drops"].tolist() == [2, 2, 2] and found["keeper_drops"].tolist() == [1, 1, 1]
    assert found["conceded"].tolist() == [1, 0, 0]
