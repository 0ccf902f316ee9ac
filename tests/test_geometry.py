"""Angles wrap, vectors turn into frames and out of them, and a point of a frame is where its axes say."""

import math
from itertools import product
from math import cos, pi, sin

import numpy as np
import pytest

from soccer_env.geometry import (
    atan2,
    cosine_and_sine,
    from_polar,
    into_frame,
    out_of_frame,
    point_of_frame,
    step_toward,
    wrap,
    wrap_once,
)

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


def test_cosine_sine_and_arc_tangent_are_those_of_math_in_all_directions() -> None:
    rng = np.random.default_rng(0)
    for reach in (4.0, 1e3, 1e6):
        for angle in rng.uniform(-reach, reach, 2000):
            assert cosine_and_sine(angle) == pytest.approx((math.cos(angle), math.sin(angle)), abs=3e-16)
    for size, angle in zip(10.0 ** rng.uniform(-9, 9, 2000), rng.uniform(-4.0, 4.0, 2000), strict=True):
        x, y = from_polar(size, angle)
        assert atan2(y, x) == pytest.approx(math.atan2(y, x), abs=5e-16)
        assert atan2(-y, x) == -atan2(y, x) and cosine_and_sine(-angle)[0] == cosine_and_sine(angle)[0]
    for y, x in product((-1.0, -0.0, 0.0, 1.0), repeat=2):
        assert (x == y == 0.0) or atan2(y, x) == math.atan2(y, x)
    assert all(map(math.isfinite, (*cosine_and_sine(1e300), *cosine_and_sine(-3e38))))


def test_one_turn_at_most_brings_an_angle_of_three_half_turns_back() -> None:
    for angle in np.linspace(-9.4, 9.4, 101):
        assert abs(wrap_once(angle)) <= math.pi
        assert wrap_once(angle) == pytest.approx(wrap(angle), abs=1e-14)
