"""What meets what, and the numbers by which Chipmunk gets the elasticity and friction of each pair that meets.

Chipmunk multiplies the numbers of two shapes. So that the products are those that the league states, each kind of
shape gets a factor, for elasticity and for friction alike:

    robot   r = sqrt(robot_robot)                          r r = robot_robot
    ball    b = ball_robot / r                             b r = ball_robot
    what the ball meets: a board, a post, a net            w = ball_board / b and so on
    what robots meet: all of these                         w = robot_board / r

Boards, posts and nets therefore stand twice in a Space, once for the ball and once for robots, told apart by
categories.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import pymunk

from soccer_env.leagues.materials import Materials, Pair

LEAST = 1e-6  # [1] what a factor that is divided by stands for at least: robot_robot or ball_robot of 0 act as that

BALL = 1 << 0
BODY = 1 << 1  # a robot's trunk; with its posts where it is a hull; others are found apart, `solver/posts.py`
BALL_WALL = 1 << 2  # boards, posts and nets as the ball meets them
BODY_WALL = 1 << 3  # the same as robots meet them
MEETS = {BALL: BODY | BALL_WALL, BODY: BALL | BODY | BODY_WALL, BALL_WALL: BALL, BODY_WALL: BODY}


class Surface(NamedTuple):
    """The factors of a shape [1]."""

    elasticity: float
    friction: float

    def over(self, other: Surface) -> Surface:
        """Return what gives this when multiplied with another."""
        return Surface(self.elasticity / other.elasticity, self.friction / other.friction)


class Surfaces(NamedTuple):
    """The factors of each kind of shape."""

    robot: Surface
    ball: Surface
    board: Surface  # as the ball meets it
    post: Surface
    net: Surface
    edge: Surface  # all of these as robots meet them


def surfaces_of(materials: Materials) -> Surfaces:
    """Return factors whose products are the pairs that a league states."""
    pairs = {name: Surface(pair.elasticity, pair.friction) for name, pair in materials.pairs().items()}
    square = at_least(materials.robot_robot)
    robot = Surface(sqrt(square.elasticity), sqrt(square.friction))
    ball = at_least(materials.ball_robot).over(robot)
    board, post, net = (pairs[f"ball_{what}"].over(ball) for what in ("board", "post", "net"))
    return Surfaces(robot, ball, board, post, net, pairs["robot_board"].over(robot))


def at_least(pair: Pair) -> Surface:
    """Return the numbers of a pair that others are divided by: none is 0."""
    return Surface(max(pair.elasticity, LEAST), max(pair.friction, LEAST))


def finish(shape: pymunk.Shape, surface: Surface, category: int) -> pymunk.Shape:
    """Give a shape its surface, and what it meets."""
    shape.elasticity, shape.friction = surface
    shape.filter = pymunk.ShapeFilter(categories=category, mask=MEETS[category])
    return shape
