"""Where the ball lies and how far it comes back: recordings made by hand, each with a known answer."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.train.play import ball
from soccer_env.types import Phase
from tests.train.play.recordings import blank, put, roll

LEGGED = find_league("legged-2001")
RATE = LEGGED.control_rate


def test_time_in_play_leaves_out_placing_waiting_and_matches_that_are_over() -> None:
    play = blank(100, matches=2)
    play.live[90:, 1] = False
    play.matches["phase"][:20, 0] = Phase.THROW_IN
    play.matches["placing"][20:25, 0] = 1
    assert ball.times(play)["played"] == pytest.approx([2.0, 1.8])
    assert ball.times(play)["in_play"] == pytest.approx([1.5, 1.8])


def test_goals_and_whistles_of_a_match_that_is_over_do_not_count() -> None:
    play = blank(10)
    play.events["goal"][[2, 9]], play.live[5:] = 1, False
    play.events["restart"][[2, 4]], play.events["separated"][3] = Phase.KICK_OFF, 1
    assert ball.goals(play)["goals"].tolist() == [1]
    assert ball.whistles(play)["restarts"].tolist() == [2]
    assert ball.whistles(play)["separations"].tolist() == [1]


def test_a_ball_of_one_centimetre_a_second_lies_still_and_one_of_three_does_not() -> None:
    play = blank(100)
    play.balls["vx"][:40], play.balls["vy"][40:] = 0.01, -0.03
    assert ball.lying(play)["still"] == pytest.approx([0.8])


def test_a_ball_19_cm_from_a_line_is_at_it_and_one_near_two_lines_in_the_corner() -> None:
    half_length, half_width = LEGGED.pitch.length / 2, LEGGED.pitch.width / 2
    play = blank(4, league=LEGGED)
    roll(play, [0.0, half_length - 0.19, half_length - 0.24, half_length + 0.1], [0.79 * half_width, 0.0, 0.77, 0.0])
    assert ball.at_boards(play)["at_boards"] * RATE == pytest.approx([2.0])
    assert ball.at_boards(play)["in_corner"] * RATE == pytest.approx([1.0])


def path_to_board(back: float) -> np.ndarray:
    """Return y of a ball that rolls at 0.8 m/s to the board for a second, then comes back so far [m] at 0.4 m/s."""
    contact = LEGGED.pitch.width / 2 - LEGGED.ball.radius
    there = contact - 0.8 * np.arange(RATE - 1, -1, -1) / RATE
    return np.concatenate((there, contact - np.minimum(0.4 * np.arange(1, 3 * RATE) / RATE, back)))


def test_a_ball_comes_12_cm_back_from_a_board() -> None:
    path = path_to_board(0.12)
    play = blank(len(path), league=LEGGED)
    roll(play, 0.5, path)
    assert [ones.tolist() for ones in ball.off_boards(play)["off_boards"]] == [pytest.approx([0.12])]


def test_a_rebound_ends_where_a_robot_touches_and_none_is_counted_that_a_robot_had_a_part_in() -> None:
    path = path_to_board(0.12)
    play = blank(len(path), matches=2, league=LEGGED)
    roll(play, 0.5, path)
    play.deeds["touch"][RATE + 1, 0, 1] = 1  # a step after the ball has begun to come back
    play.deeds["touch"][RATE - 2, 1, 0] = 1
    first, second = ball.off_boards(play)["off_boards"]
    assert first.tolist() == pytest.approx([0.4 / RATE])
    assert second.tolist() == []


def test_a_ball_that_goes_into_the_goal_does_not_rebound() -> None:
    path = path_to_board(0.12) + LEGGED.pitch.length / 2 - LEGGED.pitch.width / 2
    play = blank(len(path), league=LEGGED)
    roll(play, path, 0.0)
    assert ball.off_boards(play)["off_boards"][0].tolist() == []


@pytest.mark.parametrize(("kick", "speed", "expected"), [(0, 4.0, [0.5]), (1, 4.0, []), (0, 1.0, [])])
def test_a_quick_ball_leaves_a_robot_by_half_a_metre_unless_it_is_kicked(
    kick: int, speed: float, expected: list[float]
) -> None:
    rate = find_league("middle-size-2006").control_rate
    there = 1.0 + speed * np.arange(rate - 1, -1, -1) / rate
    back = 1.0 + np.minimum(2.0 * np.arange(1, rate) / rate, 0.5)
    play = blank(2 * rate - 1)
    put(play, 0, 0.0, 0.0)
    roll(play, np.concatenate((there, back)), 0.0)
    play.deeds["touch"][rate - 1, 0, 0] = 1
    play.deeds["kick"][rate - 1, 0, 0] = kick
    assert ball.off_robots(play)["off_robots"][0].tolist() == pytest.approx(expected)
