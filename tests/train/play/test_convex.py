"""Signed distances of convex shapes, against what a ruler says."""

from math import hypot, sqrt

import numpy as np
import pytest

from soccer_env.train.play.convex import Shape, gap

SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
DIAMOND = ((0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0))


def shape(*corners: tuple[float, float], radius: float = 0.0, x: float = 0.0, y: float = 0.0) -> Shape:
    return Shape(np.array(corners) + (x, y), radius)


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        (shape((0, 0), radius=0.2), shape((3, 4), radius=0.3), 4.5),
        (shape((0, 0), radius=0.2), shape((0.3, 0), radius=0.3), -0.2),
        (shape(*SQUARE), shape((2, 0), radius=0.25), 0.75),
        (shape(*SQUARE), shape((1.3, 1.4)), 0.5),  # off a corner
        (shape(*SQUARE), shape((0.9, 0.2), radius=0.05), -0.15),  # its centre inside
        (shape((0, 0), (2, 0), radius=0.1), shape((1, 0.5), radius=0.1), 0.3),  # a capsule's side
        (shape((0, 0), (2, 0), radius=0.1), shape((2.3, 0.4), radius=0.1), 0.3),  # and its end
        (shape((0, 0), (1, 0)), shape((3, 0), (4, 0)), 2.0),  # two in one line
        (shape((-1, 0), (1, 0), radius=0.1), shape((0, -1), (0, 1), radius=0.1), -1.2),  # crossed
        (shape(*SQUARE), shape(*SQUARE, x=3.0, y=3.0), sqrt(2.0)),
        (shape(*SQUARE), shape(*SQUARE, x=1.7, y=0.4), -0.3),
        (shape(*SQUARE), shape(*DIAMOND, x=2.5), 0.5),
        (shape(*SQUARE), shape(*DIAMOND, x=1.25, y=1.25), -0.5 / sqrt(2.0)),  # parted best along the slope
    ],
)
def test_the_gap_of_two_shapes_is_their_distance_or_minus_the_depth_of_their_overlap(
    first: Shape, second: Shape, expected: float
) -> None:
    assert gap(first, second) == pytest.approx(expected)
    assert gap(second, first) == pytest.approx(expected)


def test_gaps_of_many_shapes_are_found_at_once() -> None:
    centres = np.random.default_rng(3).normal(size=(50, 1, 2))
    found = gap(shape((0, 0), radius=0.5), Shape(centres, 0.25))
    assert found == pytest.approx([hypot(x, y) - 0.75 for x, y in centres[:, 0]])
