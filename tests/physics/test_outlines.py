"""The tests' own measure of overlap: signed distances of shapes, against what a ruler says."""

from math import sqrt

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.types import BALL, ROBOT
from tests.scenes.outlines import Shape, ball_board_gaps, gap, robot_board_gaps, robot_gaps

SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
DIAMOND = ((0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0))


def shape(*corners: tuple[float, float], radius: float = 0.0, x: float = 0.0, y: float = 0.0) -> Shape:
    """Return a shape, moved to (x, y)."""
    return Shape(np.array(corners) + (x, y), radius)


@pytest.mark.parametrize(("first", "second", "expected"), [
    (shape((0, 0), radius=0.2), shape((3, 4), radius=0.3), 4.5),
    (shape((0, 0), radius=0.2), shape((0.3, 0), radius=0.3), -0.2), (shape(*SQUARE), shape((2, 0), radius=0.25), 0.75),
    (shape(*SQUARE), shape((1.3, 1.4)), 0.5),  # off a corner
    (shape(*SQUARE), shape((0.9, 0.2), radius=0.05), -0.15),  # its centre inside
    (shape((0, 0), (2, 0), radius=0.1), shape((1, 0.5), radius=0.1), 0.3),  # a capsule's side
    (shape((0, 0), (2, 0), radius=0.1), shape((2.3, 0.4), radius=0.1), 0.3),  # and its end
    (shape((0, 0), (1, 0)), shape((3, 0), (4, 0)), 2.0),  # two in one line
    (shape((-1, 0), (1, 0), radius=0.1), shape((0, -1), (0, 1), radius=0.1), -1.2),  # crossed
    (shape(*SQUARE), shape(*SQUARE, x=3.0, y=3.0), sqrt(2.0)), (shape(*SQUARE), shape(*SQUARE, x=1.7, y=0.4), -0.3),
    (shape(*SQUARE), shape(*DIAMOND, x=2.5), 0.5),
    (shape(*SQUARE), shape(*DIAMOND, x=1.25, y=1.25), -0.5 / sqrt(2.0)),  # parted best along the slope
])  # fmt: skip
def test_the_gap_of_two_shapes_is_their_distance_or_minus_the_depth_of_their_overlap(
    first: Shape, second: Shape, expected: float
) -> None:
    assert gap(first, second) == pytest.approx(expected)
    assert gap(second, first) == pytest.approx(expected)


def at(record: np.dtype, places: list[tuple[float, float]], heading: float = 0.0) -> np.ndarray:
    """Return records that lie or stand at some places [m]."""
    found = np.zeros(len(places), record)
    found["x"], found["y"] = np.transpose(places)
    if "heading" in (record.names or ()):
        found["heading"], found["active"] = heading, 1
    return found


def test_boards_posts_and_nets_are_where_the_pitch_says() -> None:
    league = find_league("middle-size-2006")
    pitch, radius = league.pitch, league.ball.radius
    places = [
        (0.0, pitch.width / 2 + pitch.band_side - radius + 0.002, -0.002),  # the board aside
        (pitch.length / 2 + pitch.band_end - radius + 0.003, 3.0, -0.003),  # the board behind the line
        (pitch.length / 2 + pitch.goal_depth - radius + 0.004, 0.0, -0.004),  # the net
        (pitch.length / 2 - radius + 0.001, pitch.goal_width / 2 + pitch.post_radius, -0.001),  # a post
    ]
    found = ball_board_gaps(league, at(BALL, [(x, y) for x, y, _ in places]))
    assert found == pytest.approx([gap for _, _, gap in places])


def test_two_robots_back_to_back_overlap_by_the_depth_of_their_discs_unless_one_is_off_the_field() -> None:
    league = find_league("middle-size-2006")
    apart = 2.0 * (league.body.disc_radius - league.body.disc_x) - 0.006
    robots = at(ROBOT, [(0.0, 0.0), (-apart, 0.0)])[None]
    robots["heading"][:, 1] = np.pi
    assert robot_gaps(league, robots) == pytest.approx(np.array([[-0.006]]))
    robots["active"][:, 1] = 0
    assert np.isinf(robot_gaps(league, robots)).all()


@pytest.mark.parametrize("name", ["legged-2001", "legged-2001-smooth"])
def test_posts_of_legs_meet_the_foot_of_a_board_and_other_bodies_its_face(name: str) -> None:
    league = find_league(name)
    body, foot = league.body, league.pitch.board_foot if league.body.legs else 0.0
    assert (foot > 0.0) == (name == "legged-2001")
    y = league.pitch.width / 2 - foot - (body.tip_y + body.tip_radius) + 0.004
    assert robot_board_gaps(league, at(ROBOT, [(0.0, y)])[None]) == pytest.approx(np.array([[-0.004]]))
