"""How far ball, robots and boards are apart, on records made by hand."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.physics.gait import paw_offset
from soccer_env.train.play.gaps import NEAR
from soccer_env.train.play.outlines import posts_of, swung, trunk_of
from soccer_env.types import ROBOT
from tests.train.play.recordings import blank, put, roll

LEAGUE, LEGGED = find_league("middle-size-2006"), find_league("legged-2001")
BODY, BALL, PITCH = LEAGUE.body, LEAGUE.ball, LEAGUE.pitch


def test_a_ball_that_sinks_into_the_back_of_a_disc_overlaps_by_that() -> None:
    play = blank(2)
    back = BODY.disc_radius - BODY.disc_x
    put(play, 0, 1.0, 0.0, pi / 2)  # looks along y, so that its back is below it
    roll(play, 1.0, [-(back + BALL.radius) + 0.004, -(back + BALL.radius) - 0.003])
    assert play.gaps.ball_robot[:, 0, 0] == pytest.approx([-0.004, 0.003])
    assert np.isinf(play.gaps.ball_robot[:, 0, 1]).all()


def test_a_ball_between_the_tips_is_as_near_as_the_nearest_of_them() -> None:
    play = blank(1)
    put(play, 0, 0.0, 0.0)
    roll(play, BODY.tip_x, BODY.tip_y - BODY.tip_radius - BALL.radius - 0.001)
    assert play.gaps.ball_robot[0, 0, 0] <= 0.001


def test_two_robots_back_to_back_overlap_by_the_depth_of_their_discs() -> None:
    play = blank(1, robots=3)
    apart = 2.0 * (BODY.disc_radius - BODY.disc_x) - 0.006
    put(play, 0, 0.0, 0.0)
    put(play, 2, -apart, 0.0, pi)
    assert play.gaps.pairs.tolist() == [[0, 1], [0, 2], [1, 2]]
    assert play.gaps.robot_robot[0, 0] == pytest.approx([np.inf, -0.006, np.inf])


def test_who_is_not_on_the_field_touches_nobody() -> None:
    play = blank(1)
    put(play, 0, 0.0, 0.0)
    put(play, 1, 0.1, 0.0)
    play.robots["active"][:, :, 1] = 0
    assert np.isinf(play.gaps.robot_robot).all()
    assert np.isinf(play.gaps.ball_robot[..., 1]).all()


def test_boards_posts_and_nets_are_where_the_pitch_says() -> None:
    places = [
        (0.0, PITCH.width / 2 + PITCH.band_side - BALL.radius + 0.002, -0.002),  # the board aside
        (PITCH.length / 2 + PITCH.band_end - BALL.radius + 0.003, 3.0, -0.003),  # the board behind the line
        (PITCH.length / 2 + PITCH.goal_depth - BALL.radius + 0.004, 0.0, -0.004),  # the net
        (PITCH.length / 2 - BALL.radius + 0.001, PITCH.goal_width / 2 + PITCH.post_radius, -0.001),  # a post
        (0.0, 0.0, np.inf),
    ]
    play = blank(len(places))
    roll(play, [x for x, _, _ in places], [y for _, y, _ in places])
    assert play.gaps.ball_board[:, 0] == pytest.approx([gap for _, _, gap in places])


def test_a_ball_in_a_walled_goal_touches_no_board_but_those_of_the_goal() -> None:
    pitch, radius = LEGGED.pitch, LEGGED.ball.radius
    play = blank(3, league=LEGGED)
    inside, side = pitch.length / 2 + 0.1, pitch.goal_width / 2 - radius
    roll(play, [inside, inside, pitch.length / 2 - radius + 0.005], [0.0, side + 0.003, pitch.goal_width])
    assert play.gaps.ball_board[:, 0] == pytest.approx([np.inf, -0.003, -0.005])


def test_a_robot_against_a_board_overlaps_by_what_reaches_beyond_it() -> None:
    play = blank(2)
    edge = PITCH.width / 2 + PITCH.band_side
    back = BODY.disc_radius - BODY.disc_x
    put(play, 0, 0.0, [edge - back + 0.005, edge - back - 2 * NEAR], -pi / 2)  # its back to the board
    assert play.gaps.robot_board[:, 0, 0] == pytest.approx([-0.005, np.inf])


def test_a_trunk_drawn_out_backwards_and_hind_posts_are_part_of_an_outline() -> None:
    fields = {"tip_x": 0.06, "tip_y": 0.05, "tip_radius": 0.02, "hind_x": -0.06, "hind_y": 0.04}
    trunk = {"disc_radius": 0.05, "disc_x": 0.04, "disc_back": 0.1, "front": 0.09, "reach": 0.12}
    body = replace(BODY, **fields, **trunk)
    assert trunk_of(body).corners == pytest.approx(np.array([(-0.06, 0.0), (0.04, 0.0)]))
    posts = posts_of(body)
    assert [one.corners[0].tolist() for one in posts] == [[0.06, 0.05], [0.06, -0.05], [-0.06, 0.04], [-0.06, -0.04]]
    assert [one.radius for one in posts] == [0.02] * 4


def test_posts_of_legs_swing_as_the_gait_of_the_physics_does() -> None:
    robots = np.zeros(40, ROBOT)
    rng = np.random.default_rng(5)
    robots["gait_phase"] = rng.integers(0, 3 * LEGGED.drive.gait_steps, 40)
    for name in ("forward", "left", "turn"):
        robots["walk"][name] = rng.uniform(-0.1, 0.1, 40)
    k, still = constants_of(LEGGED)[0], posts_of(LEGGED.body)
    for leg, post in enumerate(swung(LEGGED, robots)):
        offsets = [paw_offset(one, k, leg, 1.0) for one in robots]
        assert post.corners[:, 0] - still[leg].corners[0] == pytest.approx(np.array(offsets))
        assert np.abs(offsets).max() > 0.005


def test_the_ball_meets_a_post_where_it_has_swung_to_and_robots_where_it_stands() -> None:
    body, drive = LEGGED.body, LEGGED.drive
    play = blank(2, league=LEGGED)
    put(play, 0, 0.0, 0.0)
    play.robots["walk"]["forward"][1, 0, 0] = drive.forward
    play.robots["gait_phase"][1, 0, 0] = drive.gait_steps // 2  # the left forepaw is at the fore end of its stroke
    roll(play, body.tip_x + body.tip_radius + LEGGED.ball.radius + 0.001, body.tip_y)
    put(play, 1, 2.0 * (body.tip_x + body.tip_radius) + 0.002, 0.0, pi)
    stroke = 0.25 * drive.gait_steps * LEGGED.dt * drive.forward
    assert play.gaps.ball_robot[:, 0, 0] == pytest.approx([0.001, 0.001 - stroke])
    assert play.gaps.robot_robot[:, 0, 0] == pytest.approx([0.002, 0.002])


@pytest.mark.parametrize("league", ["legged-2001", "legged-2001-smooth"])
def test_posts_of_legs_meet_the_foot_of_a_board_and_other_bodies_its_face(league: str) -> None:
    found = find_league(league)
    body, foot = found.body, found.pitch.board_foot if found.body.legs else 0.0
    assert (foot > 0.0) == (league == "legged-2001")
    widest = body.tip_y + body.tip_radius
    play = blank(1, league=found)
    put(play, 0, 0.0, found.pitch.width / 2 - foot - widest + 0.004)
    assert play.gaps.robot_board[0, 0, 0] == pytest.approx(-0.004)
