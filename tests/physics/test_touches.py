"""Who touched the ball, who had it, which robots met; and the tests' own measure of overlap against a ruler."""

from math import sqrt

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.physics.contacts import TOUCH_GAP, ball_gap, paws_gap
from soccer_env.types import AWAY, BALL, HOME, NO_TEAM, ROBOT
from tests.scenes.leagues import LEGGED, MIDDLE, boarded, each_league, endless, steady
from tests.scenes.outlines import Shape, ball_board_gaps, gap, robot_board_gaps, robot_gaps
from tests.scenes.staging import (
    outline,
    place,
    play,
    put,
    put_ball,
    record_each_step,
    robot_actions,
    stage,
    stand,
)

MANY = 200
FLANK = outline(find_league(LEGGED))[:, 1].max()  # [m]


def run_until_touched(match, seconds):
    """Return which robots (M, R) ever touched the ball, and whether robots changed the ball's velocity (M,)."""
    return record_each_step(match, lambda: match.robot_events["touch"] == 1, seconds).any(axis=0)


@pytest.mark.parametrize(("name", "top"), [(LEGGED, 2.0), (MIDDLE, 11.0)])
def test_a_bounce_within_one_control_step_is_a_touch_by_that_robot(name, top):
    match = stage(endless(name), MANY)
    rng = np.random.default_rng(1)
    heading, angle = rng.uniform(-np.pi, np.pi, (2, MANY))
    body, r = match.league.body, match.league.ball.radius
    put(match, 0, 0.0, 0.0, heading)
    put(match, 1, -5.0, 5.0)
    away = body.reach + r + rng.uniform(0.05, 0.4, MANY)
    v = rng.uniform(0.5, 1.0, MANY) * top
    place(match, ball=(away * np.cos(angle), away * np.sin(angle), -v * np.cos(angle), -v * np.sin(angle)))
    touched = run_until_touched(match, 1.0 if name == LEGGED else 0.3)
    assert touched[:, 0].all() and not touched[:, 1].any()
    assert (match.matches["last_touch_team"] == HOME).all() and (match.matches["last_touch_robot"] == 0).all()


def test_a_fast_ball_on_a_robot_that_drives_away_is_a_touch():
    """A trap: the ball nearly stops, the robot moves on, and at the end of the step they are apart."""
    match = stage(endless(MIDDLE), MANY)
    rng = np.random.default_rng(2)
    u = rng.uniform(0.5, 2.6, MANY)
    put(match, 1, 0.0, 0.0, np.pi, forward=u)
    place(match, ball=(rng.uniform(0.5, 0.9, MANY), rng.uniform(-0.1, 0.1, MANY), -rng.uniform(6.0, 11.0, MANY), 0.0))
    touches = record_each_step(
        match, lambda: match.robot_events["touch"][:, 1], 0.4, robot_actions(match, r=1, forward=u / 2.6)
    )
    assert touches.any(axis=0).all()
    assert (match.matches["last_touch_team"] == AWAY).all()


@each_league
def test_a_bounce_off_a_board_is_nobodys_touch(name):
    match = stage(boarded(name), MANY)
    rng = np.random.default_rng(3)
    pitch, body, r = match.league.pitch, match.league.body, match.league.ball.radius
    edge, v = pitch.width / 2, rng.uniform(0.3, 0.9, MANY) * match.league.ball.top_speed
    put(match, 0, 0.0, edge - 0.6 * rng.uniform(1.0, 2.0, MANY), 0.0)
    put(match, 1, -1.0, edge - 2.0 * body.reach, 0.0)
    place(match, ball=(body.reach + r + 0.06, edge - r - rng.uniform(0.05, 0.2, MANY), rng.uniform(0.0, 0.5, MANY), v))
    bounced = np.zeros(MANY, bool)
    for _ in range(3):
        match.step(stand(match))
        bounced |= match.balls["vy"] < 0.0
        assert not match.robot_events["touch"].any() and (match.events["touch_team"] == NO_TEAM).all()
    assert bounced.mean() > 0.7


def test_a_ball_off_a_board_has_not_touched_the_robot_that_it_rolls_towards_nor_one_that_hugs_the_board():
    match = stage(LEGGED)
    put(match, 0, 0.0, 1.0 - 0.042 - 0.042 - 0.05 - FLANK, 0.0)  # its flank is 5 cm from a ball at the board
    place(match, ball=(0.0, 0.93, 0.0, 1.5))
    match.step(stand(match))
    assert match.balls["vy"][0] < 0.0, "it has come back from the board"
    assert not match.robot_events["touch"].any()
    match = stage(LEGGED, MANY)
    rng = np.random.default_rng(1)
    put(match, 0, 0.0, 1.0 - FLANK - match.league.foot - 0.005, 0.0)
    v, angle = rng.uniform(1.0, 2.0, MANY), rng.uniform(1.0, np.pi / 2, MANY)
    place(match, ball=(0.22, 1.0 - 0.042 - rng.uniform(0.05, 0.12, MANY), v * np.cos(angle), v * np.sin(angle)))
    for _ in range(3):
        match.step(stand(match))
        assert not match.robot_events["touch"].any()


@each_league
def test_a_ball_that_passes_close_by_is_not_touched_and_a_kicked_one_is_though_gone_at_the_end_of_the_step(name):
    match = stage(endless(name))
    side, r = outline(match.league)[:, 1].max(), match.league.ball.radius
    put(match, 0, 0.0, 0.0, 0.0)
    place(match, ball=(-1.0, side + r + 0.01, match.league.ball.top_speed, 0.0))
    touched = run_until_touched(match, 1.5)
    assert match.balls["x"][0] > 0.3 and not touched.any()
    match = stage(steady(name))
    put(match, 1, 0.0, 0.0, 0.0)
    put_ball(match, match.league.body.front + match.league.ball.radius + 0.02, 0.0)
    match.robots["has_ball"][:, 1] = 1
    match.rebuild()
    while not match.robot_events["kick"].any():
        match.step(robot_actions(match, r=1, kick=1.0))
    assert match.robot_events["touch"].tolist() == [[0, 1]]
    assert match.events["touch_team"][0] == AWAY and match.matches["last_touch_robot"][0] == 1


@each_league
def test_of_two_that_touch_the_ball_the_nearer_is_the_last_and_robots_that_meet_have_a_collision(name):
    match = stage(name, 2)
    apart = match.league.body.front + match.league.ball.radius
    put(match, 0, [-apart - 0.0005, -apart - 0.003], 0.0, 0.0)
    put(match, 1, [apart + 0.003, apart + 0.0005], 0.0, np.pi)
    place(match, ball=(0.0, 0.0))
    match.step(stand(match))
    assert match.robot_events["touch"].sum(axis=1).tolist() == [2, 2]
    assert match.events["touch_team"].tolist() == [HOME, AWAY]
    match = stage(name, 1, home=2, away=2)
    reach = match.league.body.reach
    put(match, 0, 0.0, 0.0, 0.0)
    put(match, 2, 2.0 * reach + 0.01, 0.0, np.pi)
    put(match, 1, -2.5 * reach, 3.0 * reach, 0.0)
    place(match, ball=(0.3, -0.6))
    match.step(stand(match))
    assert not match.robot_events["collision"].any()
    play(match, 2.0, robot_actions(match, r=0, forward=1.0))
    assert match.robot_events["collision"].tolist() == [[1, 0, 1, 0]]


@each_league
def test_the_gap_to_the_ball_is_its_distance_from_the_outline(name):
    league = find_league(name)
    constants = constants_of(league)[0]
    match, points, outside = stage(league), outline(league), 0
    for x, y, heading, bx, by in np.random.default_rng(4).uniform(-1.0, 1.0, (200, 5)):
        put(match, 0, x, y, heading)
        cosine, sine = np.cos(heading), np.sin(heading)
        turned = points @ np.array([[cosine, sine], [-sine, cosine]]) + (x, y)
        gap = ball_gap(match.robots[0, 0], constants, bx, by)
        if gap > -league.ball.radius:  # its centre is not inside
            outside += 1
            expected = np.hypot(turned[:, 0] - bx, turned[:, 1] - by).min() - league.ball.radius
            assert gap == pytest.approx(expected, abs=2e-4)
    assert outside > 150


def test_ms51_a_paw_touches_the_ball_where_it_is_in_its_stroke():
    """Of two balls beside where it stands the one that it has swung to, 15 mm off, is touched."""
    match = stage(endless(LEGGED))
    body, k = match.league.body, constants_of(match.league)[0]
    put(match, 0, 0.0, 0.0, 0.0)
    match.robots["walk"]["forward"][:, 0], match.robots["gait_phase"][:, 0] = 0.12, 4
    robot, beside = match.robots[0, 0], body.tip_y + body.tip_radius + match.league.ball.radius
    for side, swung in ((1.0, 0.015), (-1.0, -0.015)):  # the left forepaw is ahead, the right one behind
        assert paws_gap(robot, k, body.tip_x + swung, side * beside, 1.0) == pytest.approx(0.0, abs=1e-12)
        assert paws_gap(robot, k, body.tip_x - swung, side * beside, 1.0) > TOUCH_GAP
        assert paws_gap(robot, k, body.tip_x - swung, side * beside, -1.0) == pytest.approx(0.0, abs=1e-12)
        assert ball_gap(robot, k, body.tip_x, side * beside) == pytest.approx(0.0, abs=1e-12)


SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
DIAMOND = ((0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0))


def shape(*corners: tuple[float, float], radius: float = 0.0, x: float = 0.0, y: float = 0.0) -> Shape:
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
def test_the_gap_of_two_shapes_is_their_distance_or_minus_the_depth_of_their_overlap(first, second, expected) -> None:
    assert gap(first, second) == pytest.approx(expected)
    assert gap(second, first) == pytest.approx(expected)


def at(record: np.dtype, places: list[tuple[float, float]], heading: float = 0.0) -> np.ndarray:
    """Return records that lie or stand at some places [m]."""
    found = np.zeros(len(places), record)
    found["x"], found["y"] = np.transpose(places)
    if "heading" in (record.names or ()):
        found["heading"], found["active"] = heading, 1
    return found


def test_boards_posts_and_nets_are_where_the_pitch_says_and_two_back_to_back_overlap_by_their_discs() -> None:
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
