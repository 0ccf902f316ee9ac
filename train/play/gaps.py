"""How far ball, robots and boards are apart, by geometry alone: below 0 they overlap by so much."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, product
from typing import NamedTuple

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.train.play.convex import Shape, gap
from soccer_env.train.play.outlines import board_shapes, has_legs, placed, posts_of, swung, trunk_of

SWING = 0.05  # [m] more than any leg swings
NEAR = 0.02  # [m] what is farther apart than this need not be known exactly: inf


class Gaps(NamedTuple):
    """Distances [m] in M matches of T steps; inf where they are above NEAR or a robot is not on the field."""

    ball_robot: np.ndarray  # (T, M, R)
    robot_robot: np.ndarray  # (T, M, P) of all pairs
    ball_board: np.ndarray  # (T, M) posts and nets count as boards
    robot_board: np.ndarray  # (T, M, R)
    pairs: np.ndarray  # (P, 2) rows of the robots of each pair


def measure_gaps(league: League, balls: np.ndarray, robots: np.ndarray) -> Gaps:
    """Return all gaps of records: balls (T, M), robots (T, M, R)."""
    pairs = np.array(list(combinations(range(robots.shape[-1]), 2)), np.int64).reshape(-1, 2)
    return Gaps(
        ball_robot=ball_robot_gaps(league, balls, robots),
        robot_robot=robot_robot_gaps(league, robots, pairs),
        ball_board=ball_board_gaps(league, balls),
        robot_board=robot_board_gaps(league, robots),
        pairs=pairs,
    )


def ball_robot_gaps(league: League, balls: np.ndarray, robots: np.ndarray) -> np.ndarray:
    """Return the gaps (T, M, R) between ball and robots; posts of legs are where the gait has swung them."""
    distance = np.hypot(robots["x"] - balls["x"][..., None], robots["y"] - balls["y"][..., None])
    near = (distance < league.body.reach + SWING + league.ball.radius + NEAR) & (robots["active"] == 1)
    touched = np.broadcast_to(balls[..., None], robots.shape)[near]
    shapes = at_poses([trunk_of(league.body), *swung(league, robots[near])], robots[near])
    return filled(near, least_gap(shapes, [disc(touched, league.ball.radius)]))


def robot_robot_gaps(league: League, robots: np.ndarray, pairs: np.ndarray) -> np.ndarray:
    """Return the gaps (T, M, P) between the robots of each pair, posts standing still."""
    standing = [trunk_of(league.body), *posts_of(league.body)]
    one, other = robots[..., pairs[:, 0]], robots[..., pairs[:, 1]]
    near = np.hypot(one["x"] - other["x"], one["y"] - other["y"]) < 2.0 * league.body.reach + NEAR
    near &= (one["active"] == 1) & (other["active"] == 1)
    return filled(near, least_gap(at_poses(standing, one[near]), at_poses(standing, other[near])))


def ball_board_gaps(league: League, balls: np.ndarray) -> np.ndarray:
    """Return the gaps (T, M) between ball and boards."""
    near = away_from_middle(league, balls, league.ball.radius)
    return filled(near, least_gap([disc(balls[near], league.ball.radius)], board_shapes(league.pitch)))


def robot_board_gaps(league: League, robots: np.ndarray) -> np.ndarray:
    """Return the gaps (T, M, R) between robots and boards; posts of legs meet the feet of the boards."""
    foot = league.pitch.board_foot if has_legs(league.body) else 0.0
    near = away_from_middle(league, robots, league.body.reach + foot) & (robots["active"] == 1)
    trunk, posts = at_poses([trunk_of(league.body)], robots[near]), at_poses(posts_of(league.body), robots[near])
    of_trunk = least_gap(trunk, board_shapes(league.pitch))
    return filled(near, np.minimum(of_trunk, least_gap(posts, board_shapes(league.pitch, foot))))


def away_from_middle(league: League, things: np.ndarray, reach: float) -> np.ndarray:
    """Return which things, that reach so far [m], may be near a board or post."""
    length, width = league.pitch.length / 2, league.pitch.width / 2 + league.pitch.band_side
    far_aside = np.abs(things["y"]) > width - reach - NEAR
    found: np.ndarray = far_aside | (np.abs(things["x"]) > length - reach - NEAR)
    return found


def at_poses(shapes: Sequence[Shape], robots: np.ndarray) -> list[Shape]:
    """Return shapes of the robot frame in the field frame, for robots (N,)."""
    return [placed(shape, robots) for shape in shapes]


def disc(things: np.ndarray, radius: float) -> Shape:
    """Return discs around things (N,)."""
    return Shape(np.stack((things["x"], things["y"]), axis=-1)[:, None, :], radius)


def least_gap(some: Sequence[Shape], others: Sequence[Shape]) -> np.ndarray:
    """Return the least gap (N,) between any shape of the one list and any of the other."""
    found: np.ndarray = np.min([gap(one, other) for one, other in product(some, others)], axis=0)
    return found


def filled(near: np.ndarray, gaps: np.ndarray) -> np.ndarray:
    """Return gaps (N,) at the places where `near` holds, inf elsewhere and above NEAR."""
    found = np.full(near.shape, np.inf)
    found[near] = np.where(gaps < NEAR, gaps, np.inf)
    return found
