"""A pymunk Space for one match: boards, goals, ball and robots, always added in the same order.

Bodies are added as ball, robot 0, robot 1, ...; rows of body arrays have this order. A Space whose bodies are only
moved keeps traces of its past and breaks reproducibility: `engine/reseat.py` removes them.

A robot is a disc or capsule here; `solver/posts.py` finds the contacts of its posts, which are legs or tips of a guide.
"""

from __future__ import annotations

from typing import Any

import pymunk

from soccer_env.leagues.league import League, Pitch
from soccer_env.leagues.robot import Body
from soccer_env.physics.engine.surfaces import (
    BALL,
    BALL_WALL,
    BODY,
    BODY_WALL,
    Surface,
    Surfaces,
    finish_shape,
    surfaces_of,
)
from soccer_env.physics.solver.records import OVERLAP_LEFT

BOARD = 0.5  # [m] thickness of boards, so that nothing passes through one within a substep


def build_space(league: League, ball: Any, robots: Any) -> pymunk.Space:
    """Return a new Space with the ball and the robots in the state of their records, robots (R,).

    Bodies get their places before they are added: added in one place, all their shapes would be neighbours, and
    Chipmunk's pool of such pairs would stay large and scattered.
    """
    space = pymunk.Space()
    space.iterations = league.substeps.iterations
    space.collision_slop = league.substeps.slop
    space.collision_bias = OVERLAP_LEFT
    surfaces = surfaces_of(league.materials)
    space.add(*static_shapes(space.static_body, league, surfaces))
    ball_body = pymunk.Body(league.ball.mass, league.ball.shell * league.ball.mass * league.ball.radius**2)
    ball_body.position, ball_body.angle = (float(ball["x"]), float(ball["y"])), float(ball["angle"])
    space.add(ball_body, finish_shape(pymunk.Circle(ball_body, league.ball.radius), surfaces.ball, BALL))
    ball_body.velocity = float(ball["vx"]), float(ball["vy"])
    ball_body.angular_velocity = float(ball["spin"])
    for robot in robots:
        body = pymunk.Body(league.body.mass, robot_moment(league))
        body.position, body.angle = (float(robot["x"]), float(robot["y"])), float(robot["heading"])
        space.add(body, *robot_shapes(body, league, surfaces.robot))
        body.velocity, body.angular_velocity = (float(robot["vx"]), float(robot["vy"])), float(robot["omega"])
    return space


def robot_moment(league: League) -> float:
    """Return the moment of inertia of a robot [kg m2], from the inertia of its body, else from its hull or disc."""
    body = league.body
    if body.inertia > 0.0:
        return body.mass * body.inertia
    if body.corners:
        return float(pymunk.moment_for_poly(body.mass, body.corners))
    return 0.5 * body.mass * body.disc_radius * body.disc_radius


def robot_shapes(body: pymunk.Body, league: League, surface: Surface) -> list[pymunk.Shape]:
    """Return the shapes of a robot: its disc or capsule, or its hull with its posts."""
    outline = league.body
    shapes = [trunk(body, outline)]
    if not posts_outside_space(outline):
        shapes += [pymunk.Circle(body, outline.tip_radius, place) for place in outline.posts]
    return [finish_shape(shape, surface, BODY) for shape in shapes]


def posts_outside_space(outline: Body) -> tuple[tuple[float, float], ...]:
    """Return the posts [m] of a body that are not shapes in the Space: all posts, or none if the body is a hull."""
    return () if outline.corners else outline.posts


def trunk(body: pymunk.Body, outline: Body) -> pymunk.Shape:
    """Return the shape of a robot's trunk: a hull, disc or capsule."""
    if outline.corners:
        return pymunk.Poly(body, outline.corners)
    if outline.disc_back > 0.0:
        rear, front = (outline.disc_x - outline.disc_back, 0.0), (outline.disc_x, 0.0)
        return pymunk.Segment(body, rear, front, outline.disc_radius)
    return pymunk.Circle(body, outline.disc_radius, (outline.disc_x, 0.0))


def static_shapes(static: pymunk.Body, league: League, surfaces: Surfaces) -> list[pymunk.Shape]:
    """Return the shapes of boards, posts and nets: first the copies for the ball, then the copies for robots."""
    kinds = ((surfaces.board, boards), (surfaces.post, goal_posts), (surfaces.net, nets))
    of_ball = [
        finish_shape(shape, surface, BALL_WALL) for surface, make in kinds for shape in make(static, league.pitch)
    ]
    of_robots = [
        finish_shape(shape, surfaces.edge, BODY_WALL) for _, make in kinds for shape in make(static, league.pitch)
    ]
    return of_ball + of_robots


def boards(static: pymunk.Body, pitch: Pitch) -> list[pymunk.Shape]:
    """Return the boards round the pitch; on a walled pitch those on the goal lines end as the sides of the goals."""
    half_length, half_width = pitch.length / 2 + pitch.band_end, pitch.width / 2 + pitch.band_side
    near = pitch.length / 2 if pitch.walled else pitch.length / 2 + max(pitch.band_end, pitch.goal_depth)
    far = near + BOARD + (pitch.goal_depth if pitch.walled else 0.0)
    shapes = [
        static_box(static, end * near, end * far, side * pitch.goal_width / 2, side * (half_width + BOARD))
        for end in (1, -1)
        for side in (1, -1)
    ]
    for side in (1, -1):
        face, back = side * half_width, side * (half_width + BOARD)
        shapes.append(static_box(static, -half_length - BOARD, half_length + BOARD, face, back))
    return shapes


def goal_posts(static: pymunk.Body, pitch: Pitch) -> list[pymunk.Shape]:
    """Return the goal posts with the side nets; on a walled pitch the ends of the boards stand in for them."""
    line, y = pitch.length / 2, pitch.goal_width / 2 + pitch.post_radius
    if pitch.walled:
        return []
    front, back = line + pitch.post_radius, line + pitch.goal_depth
    return [
        pymunk.Segment(static, (end * front, side * y), (end * back, side * y), pitch.post_radius)
        for end in (1, -1)
        for side in (1, -1)
    ]


def nets(static: pymunk.Body, pitch: Pitch) -> list[pymunk.Shape]:
    """Return the shapes of the backs of the goals."""
    near, half = pitch.length / 2 + pitch.goal_depth, pitch.goal_width / 2
    return [static_box(static, end * near, end * (near + BOARD), -half, half) for end in (1, -1)]


def static_box(static: pymunk.Body, x1: float, x2: float, y1: float, y2: float) -> pymunk.Shape:
    """Return a static rectangle between two values of x and of y [m]."""
    left, right, low, high = min(x1, x2), max(x1, x2), min(y1, y2), max(y1, y2)
    return pymunk.Poly(static, [(left, low), (right, low), (right, high), (left, high)])
