"""Angles wrap, vectors turn into frames and out of them, and a point of a frame is where its axes say."""

from math import cos, pi, sin

import pytest

from soccer_env.geometry import into_frame, out_of_frame, point_of_frame, step_toward, wrap

QUARTER = cos(pi / 2), sin(pi / 2)  # a frame whose heading is a quarter turn to the left


def test_for_who_faces_along_y_x_lies_to_the_right_and_what_is_ahead_along_y() -> None:
    assert into_frame(1.0, 0.0, *QUARTER) == pytest.approx((0.0, -1.0), abs=1e-15)
    assert out_of_frame(1.0, 0.0, *QUARTER) == pytest.approx((0.0, 1.0), abs=1e-15)
    assert out_of_frame(0.0, 1.0, *QUARTER) == pytest.approx((-1.0, 0.0), abs=1e-15)
    frame = cos(0.7), sin(0.7)
    assert out_of_frame(*into_frame(0.3, -0.8, *frame), *frame) == pytest.approx((0.3, -0.8), abs=1e-15)
    assert point_of_frame(1.0, 0.5, 2.0, 0.25, *QUARTER) == pytest.approx((0.75, 2.5), abs=1e-15)


def test_mirrored_frames_turn_mirrored_vectors_into_mirrored_ones_to_the_last_bit() -> None:
    cosine, sine = cos(0.3), sin(0.3)
    for turn in (into_frame, out_of_frame):
        x, y = turn(0.9, 0.4, cosine, sine)
        assert turn(0.9, -0.4, cosine, -sine) == (x, -y)
    x, y = point_of_frame(0.2, 0.1, 0.9, 0.4, cosine, sine)
    assert point_of_frame(0.2, -0.1, 0.9, -0.4, cosine, -sine) == (x, -y)


def test_angles_wrap_into_one_turn_whose_end_is_pi() -> None:
    assert wrap(pi) == pi and wrap(-pi) == pi
    assert wrap(1.5 * pi) == pytest.approx(-0.5 * pi) and wrap(-7.5 * pi) == pytest.approx(0.5 * pi)


def test_a_value_moves_towards_its_goal_by_one_step_and_never_beyond() -> None:
    assert [step_toward(0.0, 1.0, 0.25), step_toward(0.9, 1.0, 0.25), step_toward(1.0, -1.0, 0.5)] == [0.25, 1.0, 0.5]
