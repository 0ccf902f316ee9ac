"""Runs of a robot that goes for a ball and is stopped on the way, for the claims on collisions.  [Sacks 2001, 3]

A walking robot slides past another sooner or later, and moves a standing robot by millimetres. Claims about a stuck
robot therefore hold it (`immobilise_robots`: its legs slip), or fix the robot in its way (`set_up_blocked_path`).
"""

from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import BACK, ROTATE
from soccer_env.match import Match
from soccer_env.match.staging import constants_of, memory_of, set_mass, team_settings_of
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.staging import begin_scene, point_ahead, put, put_ball, stage, stage_team

HEAVY = 1e4  # [kg], [kg m2]
NO_GRIP = 1e-6  # [m/s2] traction of legs that slip on the spot
ABREAST = 0.16  # [m] sideways distance at which two robots just pass each other
OVERLAP = 0.08  # [m] greatest overlap of bodies: with more the ball is hidden
POST, BEYOND = (0.33, 0.4), (0.22, 0.35)  # [m] of the robot in the way, and of the ball beyond it
AHEAD, ANGLE = (0.5, 0.7), (np.pi / 6.0, 2.0 * np.pi / 3.0)  # [m] of the ball before a camera, [rad] between ways
WAYS = 0.4  # [rad] of a blocked path off the goal's direction, at most
START = -0.9  # [m] x of the robot at the start


def set_up_seekers(batch: Batch, matches: int, **settings: Any) -> Match:
    """Set up matches in which sacks-2001, with the given settings, plays robot 0, and an opponent stands still."""
    return stage_team(batch, "sacks-2001", settings, matches=matches)


def is_recovering(match: Match) -> np.ndarray:
    """Tell in which matches (M,) robot 0 is recovering from a collision."""
    behaviour = memory_of(match)["behaviour"]
    return (behaviour >= BACK) & (behaviour <= ROTATE)


def immobilise_robots(match: Match) -> None:
    """Immobilise all robots: from now on their legs slip; they can still turn."""
    constants_of(match)["drive_traction"] = constants_of(match)["drive_thrust"] = NO_GRIP
    for name in ("vx", "vy"):
        match.robots[name] = 0.0
    match.rebuild()


def set_up_walk(batch: Batch, matches: int, nearest: float, farthest: float, **settings: Any) -> Match:
    """Set up matches in which robot 0 walks to a still ball, `nearest` to `farthest` [m] ahead of its camera."""
    rng = batch.rng()
    match = set_up_seekers(batch, matches, **settings)
    heading = rng.uniform(-0.5, 0.5, matches)
    put(match, 0, START, rng.uniform(-0.3, 0.3, matches), heading, forward=match.league.drive.forward)
    far = rng.uniform(nearest, farthest, matches) + match.league.head.camera_ahead
    put_ball(match, *point_ahead(match, 0, far, rng.uniform(-0.3, 0.3, matches)))
    begin_scene(match, placed=True)
    return match


def set_up_converging(batch: Batch, matches: int, **settings: Any) -> Match:
    """Set up matches in which two opponents walk to a still ball ahead of both, on paths that meet at an angle.

    Both are players of sacks-2001, with the given settings.
    """
    rng = batch.rng(4)
    team = make_team("sacks-2001", **settings)
    match = stage(batch, matches=matches, controllers={"home": team, "away": team}, keeper=0)
    x, y = rng.uniform(-0.5, 0.5, matches), rng.uniform(-0.3, 0.3, matches)
    way, between = rng.uniform(-np.pi, np.pi, matches), rng.choice([-1.0, 1.0], matches) * rng.uniform(*ANGLE, matches)
    for r, off in ((0, 0.0), (1, between)):
        far = rng.uniform(*AHEAD, matches) + match.league.head.camera_ahead
        place = x - far * np.cos(way + off), y - far * np.sin(way + off)
        put(match, r, *place, way + off, forward=match.league.drive.forward)
    put_ball(match, x, y)
    begin_scene(match, placed=True)
    return match


def set_up_blocked_path(batch: Batch, matches: int, **settings: Any) -> Match:
    """Set up matches in which an immovable robot stands in robot 0's path to a still ball.

    The immovable robot stands beside the straight path, so that the ball is seen past it, and the bodies overlap by up
    to OVERLAP; paths are up to WAYS off the goal's direction.
    """
    rng = batch.rng()
    match = set_up_seekers(batch, matches, **settings)
    way, side = rng.uniform(-WAYS, WAYS, matches), rng.choice([-1.0, 1.0], matches)
    x, y = rng.uniform(-0.6, 0.3, matches), rng.uniform(-0.2, 0.2, matches)
    ahead, aside = rng.uniform(*POST, matches), side * (ABREAST - rng.uniform(0.0, OVERLAP, matches))
    put(match, 0, x, y, way)
    post_x = x + ahead * np.cos(way) - aside * np.sin(way)
    post_y = y + ahead * np.sin(way) + aside * np.cos(way)
    put(match, 1, post_x, post_y, way + np.pi + rng.uniform(-0.3, 0.3, matches))
    put_ball(match, *point_ahead(match, 0, ahead + rng.uniform(*BEYOND, matches), 0.0))
    begin_scene(match, placed=True)
    set_mass(match, (1,), HEAVY, HEAVY)
    return match


def begin_recovery(match: Match, rows: Any = slice(None), r: int = 0) -> None:
    """Make the player of robot r begin a recovery now, as if it had noticed that it is stuck."""
    memory, steps = memory_of(match, r), team_settings_of(match, r)["back_steps"][0]
    memory["behaviour"][rows] = BACK
    memory["clock"][rows] = 0.0
    memory["stuck"][rows] = 0
    memory["tries"][rows] = 1
    memory["left"][rows] = steps * match.league.drive.gait_steps * match.league.dt
