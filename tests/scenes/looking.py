"""Measures of the bodies of a match, for tests: speeds, energies, outlines and how deep bodies overlap."""

from typing import Any

import numpy as np

from soccer_env import Match
from soccer_env.leagues import League
from soccer_env.leagues.constants import constants_of
from soccer_env.physics.contacts import paws_gap
from soccer_env.physics.engine.space import robot_moment
from tests.scenes.outlines import ball_board_gaps, robot_board_gaps, robot_gaps


def speed(records: np.ndarray) -> np.ndarray:
    """Return the speed of balls or robots [m/s]."""
    return np.hypot(records["vx"], records["vy"])


def distance(records: np.ndarray, x: Any, y: Any) -> np.ndarray:
    """Return how far balls or robots are from a point [m]."""
    return np.hypot(records["x"] - x, records["y"] - y)


def energy(match: Match) -> np.ndarray:
    """Return the kinetic energy (M,) of ball and robots [J], rolling and spinning included."""
    league, ball, robots = match.league, match.balls, match.robots
    moving = ball["vx"] ** 2 + ball["vy"] ** 2
    rolling = league.ball.shell * (ball["roll_x"] ** 2 + ball["roll_y"] ** 2)
    spinning = league.ball.shell * league.ball.radius**2 * ball["spin"] ** 2
    driving = league.body.mass * (robots["vx"] ** 2 + robots["vy"] ** 2) + robot_moment(league) * robots["omega"] ** 2
    return 0.5 * league.ball.mass * (moving + rolling + spinning) + 0.5 * driving.sum(axis=1)


def outline(league: League) -> np.ndarray:
    """Return points (N, 2) along the outlines of a robot's trunk and posts, robot frame."""
    body, angle = league.body, np.linspace(-np.pi, np.pi, 721)
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    posts = [place + body.tip_radius * ring for place in np.array(body.posts)]
    if body.corners:
        return np.concatenate([edges(np.array(body.corners)), *posts])
    middles = body.disc_x - np.linspace(0.0, body.disc_back, 200 if body.disc_back else 1)
    trunk = np.concatenate([(x, 0.0) + body.disc_radius * ring for x in middles])
    away = np.abs(trunk[:, 0] - np.clip(trunk[:, 0], middles.min(), middles.max()))
    on_edge = np.hypot(away, trunk[:, 1]) > body.disc_radius - 1e-9
    return np.concatenate([trunk[on_edge], *posts])


def edges(corners: np.ndarray) -> np.ndarray:
    """Return points (N, 2) along the edges of a hull."""
    share = np.linspace(0.0, 1.0, 500)[:, None, None]
    return (corners + share * (np.roll(corners, -1, axis=0) - corners)).reshape(-1, 2)


def overlaps(league: League, ball: np.void, robots: np.ndarray, handedness: float = 1.0) -> dict[str, float]:
    """Return how deep bodies of one match overlap [m]: "ball robot", "ball wall", "robot robot", "robot wall".

    By geometry alone: legs in mid-stroke to robots and walls, and where they are in their stroke to the ball.
    """
    k = constants_of(league)[0]
    to_robots = [paws_gap(robot, k, ball["x"], ball["y"], handedness) for robot in robots if robot["active"] == 1]
    found = {
        "ball robot": np.array(to_robots),
        "ball wall": ball_board_gaps(league, np.array([ball])),
        "robot robot": robot_gaps(league, robots[None]),
        "robot wall": robot_board_gaps(league, robots[None]),
    }
    return {pair: max(0.0, -float(gap.min(initial=np.inf))) for pair, gap in found.items()}


def deepest_overlaps(match: Match) -> dict[str, float]:
    """Return the deepest overlaps [m] in all matches."""
    hands = match.matches["handedness"]
    found = [overlaps(match.league, match.balls[m], match.robots[m], float(hands[m])) for m in range(match.count)]
    return {pair: max(one[pair] for one in found) for pair in found[0]}
