"""A still thing stays where it is while the robot walks round it."""

import math

import pytest

from soccer_env.belief.odometry import move_point


def test_a_step_ahead_brings_a_thing_nearer() -> None:
    assert move_point(1.0, 0.2, 0.3, 0.0, 0.0) == (0.7, 0.2)


def test_a_quarter_turn_to_the_left_puts_what_was_ahead_on_the_right() -> None:
    assert move_point(1.0, 0.0, 0.0, 0.0, math.pi / 2) == pytest.approx((0.0, -1.0), abs=1e-15)


def test_the_turn_comes_after_the_displacement_in_the_axes_of_before() -> None:
    assert move_point(1.0, 0.5, 1.0, 0.0, math.pi / 2) == pytest.approx((0.5, 0.0), abs=1e-15)


@pytest.mark.parametrize("steps", [4, 16, 160])
def test_after_a_whole_circle_the_point_is_where_it_was(steps: int) -> None:
    x, y, turn = 0.8, -0.3, 2.0 * math.pi / steps
    for _ in range(steps):
        x, y = move_point(x, y, 0.05, 0.01, turn)
    assert (x, y) == pytest.approx((0.8, -0.3), abs=1e-12)


def test_two_motions_are_the_same_as_one() -> None:
    half = move_point(*move_point(0.9, 0.4, 0.1, -0.05, 0.3), 0.2, 0.1, -0.7)
    ahead, left = 0.1 + math.cos(0.3) * 0.2 - math.sin(0.3) * 0.1, -0.05 + math.sin(0.3) * 0.2 + math.cos(0.3) * 0.1
    assert half == pytest.approx(move_point(0.9, 0.4, ahead, left, -0.4), abs=1e-15)


def test_a_mirrored_motion_moves_a_mirrored_point_to_the_mirrored_place() -> None:
    x, y = move_point(0.9, 0.4, 0.1, -0.05, 0.3)
    assert move_point(0.9, -0.4, 0.1, 0.05, -0.3) == (x, -y)
