"""Which shapes collide, and the factors from which Chipmunk computes elasticity and friction of each pair.

Chipmunk multiplies the numbers of two shapes. Each kind of shape gets a factor, for elasticity and for friction alike,
so that the products are the numbers of the league:

    robot                                      r = sqrt(robot_robot)          r r = robot_robot
    ball                                       b = ball_robot / r             b r = ball_robot
    board, post or net for the ball            w = ball_board / b and so on
    board, post or net for robots              w = robot_board / r

So each board, post and net is in a Space twice, once for the ball and once for robots, told apart by categories.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import pymunk

from soccer_env.leagues.materials import Materials, Pair

LEAST = 1e-6  # [1] robot_robot and ball_robot below this act as this: factors are divided by them

BALL = 1 << 0
BODY = 1 << 1  # a robot's trunk, with its posts if it is a hull; else `solver/posts.py` finds the posts
BALL_WALL = 1 << 2  # boards, posts and nets as the ball meets them
BODY_WALL = 1 << 3  # boards, posts and nets as robots meet them
MEETS = {BALL: BODY | BALL_WALL, BODY: BALL | BODY | BODY_WALL, BALL_WALL: BALL, BODY_WALL: BODY}


class Surface(NamedTuple):
    """The factors of a shape for elasticity and friction [1]."""

    elasticity: float
    friction: float

    def over(self, other: Surface) -> Surface:
        """Return the factors that, multiplied by those of `other`, give the factors of this surface."""
        return Surface(self.elasticity / other.elasticity, self.friction / other.friction)


class Surfaces(NamedTuple):
    """The factors of each kind of shape."""

    robot: Surface
    ball: Surface
    board: Surface  # board, post and net as the ball meets them
    post: Surface
    net: Surface
    edge: Surface  # board, post and net as robots meet them


def surfaces_of(materials: Materials) -> Surfaces:
    """Return factors whose products are the pairs of a league's materials."""
    pairs = {name: Surface(pair.elasticity, pair.friction) for name, pair in materials.pairs().items()}
    square = bounded_numbers(materials.robot_robot)
    robot = Surface(sqrt(square.elasticity), sqrt(square.friction))
    ball = bounded_numbers(materials.ball_robot).over(robot)
    board, post, net = (pairs[f"ball_{what}"].over(ball) for what in ("board", "post", "net"))
    return Surfaces(robot, ball, board, post, net, pairs["robot_board"].over(robot))


def bounded_numbers(pair: Pair) -> Surface:
    """Return the numbers of a pair, each at least LEAST, so that other numbers can be divided by them."""
    return Surface(max(pair.elasticity, LEAST), max(pair.friction, LEAST))


def finish_shape(shape: pymunk.Shape, surface: Surface, category: int) -> pymunk.Shape:
    """Set a shape's surface, its category and the categories that it collides with; return the shape."""
    shape.elasticity, shape.friction = surface
    shape.filter = pymunk.ShapeFilter(categories=category, mask=MEETS[category])
    return shape
