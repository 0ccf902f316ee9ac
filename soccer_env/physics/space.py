"""A pymunk Space for one match: boards, goals, ball and robots, always added in the same order.

Bodies are added as ball, robot 0, robot 1, ...; that order is the order of rows in every body array. A Space is made
anew at each reset: one that is reset in place remembers its past and breaks reproducibility.
"""

from __future__ import annotations

from math import pi
from typing import Any

import pymunk

from soccer_env.leagues.league import League

BOARD = 0.5  # [m] thickness of boards, so that nothing passes through one within a substep
OVERLAP_LEFT = 1e-12  # [1] share of an overlap left after 1 s, assumed; Chipmunk's 0.0018 buries a ball in a scrum
PARKED_X = 50.0  # [m] where inactive robots stand, one beside the other
PARKED_STEP = 2.0  # [m]


def build_space(league: League, ball: Any, robots: Any) -> pymunk.Space:
    """Return a fresh Space with the ball and the robots in the state of their records, robots (R,)."""
    space = pymunk.Space()
    space.iterations = league.substeps.iterations
    space.collision_slop = league.substeps.slop
    space.collision_bias = OVERLAP_LEFT
    space.add(*boards(space.static_body, league))
    ball_body = pymunk.Body(league.ball.mass, pymunk.moment_for_circle(league.ball.mass, 0.0, league.ball.radius))
    space.add(ball_body, surface(pymunk.Circle(ball_body, league.ball.radius), league.ball))
    ball_body.position, ball_body.angle = (float(ball["x"]), float(ball["y"])), float(ball["angle"])
    ball_body.velocity = float(ball["vx"]), float(ball["vy"])
    ball_body.angular_velocity = float(ball["spin"])
    for robot in robots:
        body = pymunk.Body(league.body.mass, robot_moment(league))
        space.add(body, *robot_shapes(body, league))
        body.position, body.angle = (float(robot["x"]), float(robot["y"])), float(robot["heading"])
        body.velocity, body.angular_velocity = (float(robot["vx"]), float(robot["vy"])), float(robot["omega"])
    return space


def surface(shape: pymunk.Shape, material: Any) -> pymunk.Shape:
    """Give a shape the elasticity and friction of a ball or body."""
    shape.elasticity, shape.friction = material.elasticity, material.friction
    return shape


def robot_moment(league: League) -> float:
    """Return the moment of inertia of a robot [kg m2]: a disc of half its reach squared, or its hull."""
    body = league.body
    if body.corners:
        return float(pymunk.moment_for_poly(body.mass, body.corners))
    return 0.5 * body.mass * body.disc_radius * body.disc_radius


def robot_shapes(body: pymunk.Body, league: League) -> list[pymunk.Shape]:
    """Return the hull or disc of a robot and the two tips of its pocket."""
    outline = league.body
    shapes: list[pymunk.Shape] = [
        pymunk.Poly(body, outline.corners)
        if outline.corners
        else pymunk.Circle(body, outline.disc_radius, (outline.disc_x, 0.0))
    ]
    if outline.tip_radius > 0.0:
        shapes += [pymunk.Circle(body, outline.tip_radius, (outline.tip_x, side * outline.tip_y)) for side in (1, -1)]
    return [surface(shape, outline) for shape in shapes]


def boards(static: pymunk.Body, league: League) -> list[pymunk.Shape]:
    """Return the boards round the pitch and the goals."""
    pitch = league.pitch
    shapes = walled_ends(static, league) if pitch.walled else banded_ends(static, league)
    half_length, half_width = pitch.length / 2 + pitch.band_end, pitch.width / 2 + pitch.band_side
    for side in (1, -1):
        shapes.append(
            box(static, -half_length - BOARD, half_length + BOARD, side * half_width, side * (half_width + BOARD))
        )
    for shape in shapes:
        shape.elasticity, shape.friction = pitch.wall_elasticity, pitch.wall_friction
    for side in (1, -1):
        back = box(
            static,
            side * (pitch.length / 2 + pitch.goal_depth),
            side * (pitch.length / 2 + pitch.goal_depth + BOARD),
            -pitch.goal_width / 2,
            pitch.goal_width / 2,
        )
        back.elasticity, back.friction = pitch.net_elasticity, pitch.wall_friction
        shapes.append(back)
    return shapes


def walled_ends(static: pymunk.Body, league: League) -> list[pymunk.Shape]:
    """Return the boards on the goal lines; their inner edges are the goals' sides."""
    pitch = league.pitch
    near, far = pitch.length / 2, pitch.length / 2 + pitch.goal_depth + BOARD
    return [
        box(static, end * near, end * far, side * pitch.goal_width / 2, side * (pitch.width / 2 + BOARD))
        for end in (1, -1)
        for side in (1, -1)
    ]


def banded_ends(static: pymunk.Body, league: League) -> list[pymunk.Shape]:
    """Return the boards behind the goal lines and the posts with the goals' side nets."""
    pitch = league.pitch
    line, edge = pitch.length / 2, pitch.length / 2 + max(pitch.band_end, pitch.goal_depth)
    shapes: list[pymunk.Shape] = []
    for end in (1, -1):
        for side in (1, -1):
            y = side * (pitch.goal_width / 2 + pitch.post_radius)
            start, stop = (end * (line + pitch.post_radius), y), (end * (line + pitch.goal_depth), y)
            shapes.append(pymunk.Segment(static, start, stop, pitch.post_radius))
            shapes.append(
                box(
                    static,
                    end * edge,
                    end * (edge + BOARD),
                    side * pitch.goal_width / 2,
                    side * (pitch.width / 2 + pitch.band_side + BOARD),
                )
            )
    return shapes


def box(static: pymunk.Body, x1: float, x2: float, y1: float, y2: float) -> pymunk.Shape:
    """Return a static board that spans the two corners [m]."""
    left, right, low, high = min(x1, x2), max(x1, x2), min(y1, y2), max(y1, y2)
    return pymunk.Poly(static, [(left, low), (right, low), (right, high), (left, high)])


def parking_place(row: int) -> tuple[float, float, float]:
    """Return the pose [m, m, rad] of an inactive robot, well off the field."""
    return PARKED_X + PARKED_STEP * row, PARKED_X, pi / 2
