"""Shapes of a Space: what meets what, and that a blow shows the elasticity and friction that the league states."""

from dataclasses import replace
from math import pi

import numpy as np
import pymunk
import pytest

from soccer_env.leagues import League, Materials, Pair, find_league
from soccer_env.physics.engine.space import build_space, robot_moment
from soccer_env.physics.engine.surfaces import surfaces_of
from soccer_env.types import BALL, ROBOT
from tests.scenes.staging import LEGGED, MIDDLE, each_league, league_without_calls, play, robot_actions, stage

PAIRS = ("ball_board", "ball_post", "ball_net", "ball_robot", "robot_robot", "robot_board")
each_pair = pytest.mark.parametrize("pair", PAIRS)
SUBSTEP = 1e-4  # [s]


def world(league: League, ball: tuple, *robots: tuple) -> tuple[pymunk.Space, list[pymunk.Body]]:
    """Return a Space without carpet, and its bodies: the ball at x, y [m], robots at x, y, heading."""
    balls, players = np.zeros(1, BALL), np.zeros(len(robots), ROBOT)
    balls["x"], balls["y"] = ball
    for robot, pose in zip(players, robots, strict=True):
        robot["x"], robot["y"], robot["heading"] = pose
    space = build_space(league, balls[0], players)
    return space, list(space.bodies)


def scene(name: str, pair: str, **numbers: float) -> tuple[League, pymunk.Space, pymunk.Body, pymunk.Body]:
    """Return a body that is about to meet a face ahead (+x) head-on, and what it meets: 0.2 mm lie between them.

    Away from the numbers asked for, the league's own. Posts need a goal that has some. Whatever has legs meets boards
    and robots with the middle of a smooth trunk here, so that the blow goes through its centre.
    """
    league = find_league(name)
    stated = replace(getattr(league.materials, pair), **numbers)
    body = replace(league.body, tip_radius=0.0, hind_y=0.0, legs=False)
    pitch = replace(league.pitch, walled=pair != "ball_post")
    league = replace(league, materials=replace(league.materials, **{pair: stated}), body=body, pitch=pitch)
    radius, front, gap, far = league.ball.radius, league.body.front, 2e-4, (-1.0, 0.0, 0.0)
    edge = pitch.length / 2 + pitch.band_end * (not pitch.walled)
    aside = 0.75 * pitch.goal_width
    if pair == "robot_robot":
        space, bodies = world(league, (-1.0, 0.5), (0.0, 0.0, 0.0), (2.0 * front + gap, 0.0, pi))
        return league, space, bodies[1], bodies[2]
    if pair == "robot_board":
        space, bodies = world(league, (-1.0, 0.5), (pitch.length / 2 - front - gap, aside, 0.0))
        return league, space, bodies[1], space.static_body
    places = {
        "ball_board": (edge - radius - gap, aside),
        "ball_post": (pitch.length / 2 - radius - gap, pitch.goal_width / 2 + pitch.post_radius),
        "ball_net": (pitch.length / 2 + pitch.goal_depth - radius - gap, 0.0),
        "ball_robot": (-1.0 - pitch.length / 8, 0.0),
    }
    x, y = places[pair]
    robot = (x + radius + gap + front, y, pi) if pair == "ball_robot" else far
    space, bodies = world(league, (x, y), robot)
    return league, space, bodies[0], bodies[1] if pair == "ball_robot" else space.static_body


@each_league
@each_pair
@pytest.mark.parametrize("elasticity", [None, 0.0, 0.37])
def test_bodies_part_with_the_share_of_their_speed_that_the_league_states(name, pair, elasticity):
    changed = {} if elasticity is None else {"elasticity": elasticity}
    league, space, body, other = scene(name, pair, **changed)
    body.velocity = 0.8, 0.0
    for _ in range(100):
        space.step(SUBSTEP)
    stated = getattr(league.materials, pair).elasticity
    assert other.velocity.x - body.velocity.x == pytest.approx(0.8 * stated, abs=2e-6)
    assert body.velocity.y == pytest.approx(0.0, abs=1e-9)


@each_league
@each_pair
@pytest.mark.parametrize("friction", [None, 0.0, 0.13])
def test_a_blow_that_slides_loses_along_the_surface_what_the_league_states_of_its_impulse(name, pair, friction):
    """Of a fast slide no friction of a short blow makes an end: its impulse is friction times that along the normal."""
    changed = {} if friction is None else {"friction": friction}
    league, space, body, _ = scene(name, pair, **changed)
    stated = getattr(league.materials, pair)
    body.velocity = 0.5, 3.0
    found = None
    while found is None:
        space.step(SUBSTEP)
        found = impulse_on(body)
    along, across = found
    assert across == pytest.approx(stated.friction * along, rel=1e-5, abs=2e-6 * along)


def impulse_on(body: pymunk.Body) -> tuple[float, float] | None:
    """Return the impulse of the first contact of a body along the normal and across it [N s], None without one."""
    found: list[tuple[float, float]] = []

    def note(arbiter: pymunk.Arbiter) -> None:
        impulse, normal = arbiter.total_impulse, arbiter.contact_point_set.normal
        found.append((abs(impulse.dot(normal)), abs(impulse.cross(normal))))

    body.each_arbiter(note)
    return found[0] if found and found[0][0] > 0.0 else None


@each_league
def test_factors_multiply_to_the_pairs_that_the_league_states(name):
    materials = find_league(name).materials
    soft = replace(materials, robot_robot=Pair(0.0, 0.0), ball_board=Pair(0.0, 0.0), robot_board=Pair(0.0, 0.0))
    for stated in (materials, soft):
        found, least = surfaces_of(stated), 1e-6
        ball, robot = found.ball, found.robot
        partners = [(ball, other) for other in (found.board, found.post, found.net, robot)]
        partners += [(robot, robot), (robot, found.edge)]
        for pair, (one, other) in zip(PAIRS, partners, strict=True):
            for number in ("elasticity", "friction"):
                product = getattr(one, number) * getattr(other, number)
                wanted = getattr(getattr(stated, pair), number)
                wanted = max(wanted, least) if pair == "robot_robot" else wanted
                assert product == pytest.approx(wanted, rel=1e-12, abs=0.0)


@pytest.mark.parametrize("bad", [None, 0.5, (0.5, 0.3)])
def test_materials_are_six_pairs_and_a_pair_must_be_one(bad):
    assert tuple(find_league(LEGGED).materials.pairs()) == PAIRS == tuple(Materials.__dataclass_fields__)
    for pair in PAIRS:
        with pytest.raises(ValueError, match=rf"Materials\.{pair} must be a Pair, got"):
            replace(find_league(LEGGED).materials, **{pair: bad})
    with pytest.raises(ValueError, match=r"League\.materials must be Materials, got"):
        replace(find_league(LEGGED), materials=bad)


def test_a_legged_robot_is_a_trunk_a_smooth_one_a_hull_with_tips_and_a_league_that_is_gone_says_so():
    with pytest.raises(ValueError, match="legged-2001 has legs now, legged-2001-smooth the body without them"):
        find_league("legged-2001-legs")
    smooth, league = find_league("legged-2001-smooth"), find_league(LEGGED)
    assert replace(smooth, name=league.name, body=league.body) == league and league.body.legs
    assert not smooth.body.legs and not find_league(MIDDLE).body.legs
    league = find_league(LEGGED)
    _, (_, robot, other) = world(league, (0.0, 0.0), (0.5, 0.0, 0.0), (-0.5, 0.0, 0.0))
    assert len(robot.shapes) == len(other.shapes) == 1
    _, (_, smooth) = world(find_league("legged-2001-smooth"), (0.0, 0.0), (0.5, 0.0, 0.0))
    assert len(smooth.shapes) == 3
    assert robot_moment(league) == robot.moment == pytest.approx(1.45 * (0.27**2 + 0.155**2) / 12.0)


def walked_up(league: League, x: float, y: float) -> float:
    """Return where the foremost paws of a robot are [m] that has walked along +y until something stopped it."""
    match = stage(league_without_calls(league), ball=(-1.0, -0.8), robots={0: (x, y, pi / 2)})
    play(match, 5.0, robot_actions(match, forward=1.0))
    return float(match.robots["y"][0, 0]) + league.body.tip_x + league.body.tip_radius


def test_ms51_paws_step_up_a_ramp_by_25_mm_and_trunk_and_ball_meet_the_upright_board():
    league = find_league(LEGGED)
    edge, foot, pressed = league.pitch.width / 2, league.pitch.board_foot, 0.003  # [m] and how far paws are pressed in
    assert foot == pytest.approx(league.pitch.ramp - 0.025)
    assert walked_up(league, 0.0, 0.6) == pytest.approx(edge - foot, abs=pressed)
    assert walked_up(find_league("legged-2001-upright"), 0.0, 0.6) == pytest.approx(edge, abs=pressed)
    assert walked_up(find_league("legged-2001-smooth"), 0.0, 0.6) == pytest.approx(edge, abs=pressed)
    space, (ball, _) = world(league, (0.0, 0.8), (-1.0, 0.0, 0.0))  # a Space alone knows no ramps
    ball.velocity, farthest = (0.0, 0.5), 0.0
    for _ in range(1000):
        space.step(1e-3)
        farthest = max(farthest, ball.position.y)
    assert farthest == pytest.approx(edge - league.ball.radius, abs=0.001)
