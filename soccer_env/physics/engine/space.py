"""A pymunk Space for one match: boards, goals, ball and robots, always added in the same order.

Bodies are added as ball, robot 0, robot 1, ...; that order is the order of rows in every body array. A Space whose
bodies are just put elsewhere remembers its past and breaks reproducibility: `engine/reseat.py` makes it forget.

A robot is a disc or capsule here; what its posts touch, legs or tips of a guide, is found apart (`solver/posts.py`).
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
    finish,
    surfaces_of,
)
from soccer_env.physics.solver.records import OVERLAP_LEFT

BOARD = 0.5  # [m] thickness of boards, so that nothing passes through one within a substep


def build_space(league: League, ball: Any, robots: Any) -> pymunk.Space:
    """Return a fresh Space with the ball and the robots in the state of their records, robots (R,).

    Bodies are in their places before they are added: all in one place, their shapes would be neighbours of each other,
    and the pool of such pairs would grow and be scattered for good.
    """
    space = pymunk.Space()
    space.iterations = league.substeps.iterations
    space.collision_slop = league.substeps.slop
    space.collision_bias = OVERLAP_LEFT
    surfaces = surfaces_of(league.materials)
    space.add(*surroundings(space.static_body, league, surfaces))
    ball_body = pymunk.Body(league.ball.mass, league.ball.shell * league.ball.mass * league.ball.radius**2)
    ball_body.position, ball_body.angle = (float(ball["x"]), float(ball["y"])), float(ball["angle"])
    space.add(ball_body, finish(pymunk.Circle(ball_body, league.ball.radius), surfaces.ball, BALL))
    ball_body.velocity = float(ball["vx"]), float(ball["vy"])
    ball_body.angular_velocity = float(ball["spin"])
    for robot in robots:
        body = pymunk.Body(league.body.mass, robot_moment(league))
        body.position, body.angle = (float(robot["x"]), float(robot["y"])), float(robot["heading"])
        space.add(body, *robot_shapes(body, league, surfaces.robot))
        body.velocity, body.angular_velocity = (float(robot["vx"]), float(robot["vy"])), float(robot["omega"])
    return space


def robot_moment(league: League) -> float:
    """Return the moment of inertia of a robot [kg m2]: what the body says, or else that of its hull or disc."""
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
    if not loose_posts(outline):
        shapes += [pymunk.Circle(body, outline.tip_radius, place) for place in outline.posts]
    return [finish(shape, surface, BODY) for shape in shapes]


def loose_posts(outline: Body) -> tuple[tuple[float, float], ...]:
    """Return the posts [m] of a body that are no shapes here but found apart: all, unless the body is a hull."""
    return () if outline.corners else outline.posts


def trunk(body: pymunk.Body, outline: Body) -> pymunk.Shape:
    """Return the hull, disc or capsule of a robot."""
    if outline.corners:
        return pymunk.Poly(body, outline.corners)
    if outline.disc_back > 0.0:
        rear, front = (outline.disc_x - outline.disc_back, 0.0), (outline.disc_x, 0.0)
        return pymunk.Segment(body, rear, front, outline.disc_radius)
    return pymunk.Circle(body, outline.disc_radius, (outline.disc_x, 0.0))


def surroundings(static: pymunk.Body, league: League, surfaces: Surfaces) -> list[pymunk.Shape]:
    """Return boards, posts and nets: as the ball meets them, then as robots do."""
    pitch, shapes = league.pitch, []
    kinds = ((surfaces.board, boards(static, pitch)), (surfaces.post, goal_posts(static, pitch)))
    for surface, found in (*kinds, (surfaces.net, nets(static, pitch))):
        shapes += [finish(shape, surface, BALL_WALL) for shape in found]
    found = [*boards(static, pitch), *goal_posts(static, pitch), *nets(static, pitch)]
    return shapes + [finish(shape, surfaces.edge, BODY_WALL) for shape in found]


def boards(static: pymunk.Body, pitch: Pitch) -> list[pymunk.Shape]:
    """Return the boards round the pitch; on a walled one their inner edges on the goal lines are the goals' sides."""
    half_length, half_width = pitch.length / 2 + pitch.band_end, pitch.width / 2 + pitch.band_side
    near = pitch.length / 2 if pitch.walled else pitch.length / 2 + max(pitch.band_end, pitch.goal_depth)
    far = near + BOARD + (pitch.goal_depth if pitch.walled else 0.0)
    shapes = [
        box(static, end * near, end * far, side * pitch.goal_width / 2, side * (half_width + BOARD))
        for end in (1, -1)
        for side in (1, -1)
    ]
    for side in (1, -1):
        face, back = side * half_width, side * (half_width + BOARD)
        shapes.append(box(static, -half_length - BOARD, half_length + BOARD, face, back))
    return shapes


def goal_posts(static: pymunk.Body, pitch: Pitch) -> list[pymunk.Shape]:
    """Return the posts with the goals' side nets; a walled pitch has none but the ends of its boards."""
    line, y = pitch.length / 2, pitch.goal_width / 2 + pitch.post_radius
    if pitch.walled:
        return []
    return [
        pymunk.Segment(
            static,
            (end * (line + pitch.post_radius), side * y),
            (end * (line + pitch.goal_depth), side * y),
            pitch.post_radius,
        )
        for end in (1, -1)
        for side in (1, -1)
    ]


def nets(static: pymunk.Body, pitch: Pitch) -> list[pymunk.Shape]:
    """Return the backs of the goals."""
    near, half = pitch.length / 2 + pitch.goal_depth, pitch.goal_width / 2
    return [box(static, end * near, end * (near + BOARD), -half, half) for end in (1, -1)]


def box(static: pymunk.Body, x1: float, x2: float, y1: float, y2: float) -> pymunk.Shape:
    """Return a static board that spans the two corners [m]."""
    left, right, low, high = min(x1, x2), max(x1, x2), min(y1, y2), max(y1, y2)
    return pymunk.Poly(static, [(left, low), (right, low), (right, high), (left, high)])
