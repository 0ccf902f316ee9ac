"""Runs of a robot that makes for a ball and is stopped on the way, for the claims on collisions.  [Sacks 2001, 3]

Two robots that push against each other slide past each other here sooner or later, for a standing robot holds its
ground no better than a walking one pushes. Where a claim is about a robot that is stuck, it is therefore held
(`hold`: its legs slip), or what it walks into is (`anchor`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, ROTATE
from soccer_env.match import Match
from soccer_env.teams import CompiledTeam, make_team
from soccer_env.train.reproduce.claim import Batch
from soccer_env.train.reproduce.staging import LEGGED, ahead_of, begin, put, put_ball, stage

HEAVY = 1e4  # [kg], [kg m2]
NO_GRIP = 1e-6  # [m/s2] traction of legs that slip on the spot
ABREAST = 0.16  # [m] aside at which two robots just pass each other
OVERLAP = 0.08  # [m] of bodies at most: with more the ball is hidden
POST, BEYOND = (0.33, 0.4), (0.22, 0.35)  # [m] of the one in the way, and of the ball beyond it
START = -0.9  # [m] x of the robot at the start


def seekers(batch: Batch, matches: int, others: int = 1, **settings: Any) -> Match:
    """Return matches in which sacks-2001, with settings by name, plays robot 0, and opponents stand still."""
    sides = {"home": make_team("sacks-2001", **settings), "away": "still"}
    return stage(batch, LEGGED, matches=matches, away=others, controllers=sides)


def begin_seeking(match: Match) -> None:
    """Let the scene begin with robots that know where they were put."""
    begin(match)
    match.robots["placed"] = match.robots["active"]
    for m in range(match.count):
        match.batch.look_first(m)


def mind(match: Match) -> np.ndarray:
    """Return what the player of robot 0 remembers (M,), the team's own record."""
    memory: np.ndarray = match.squads[0].memory[:, 0]
    return memory


def recovers(match: Match) -> np.ndarray:
    """Return where (M,) the player of robot 0 is recovering from a collision."""
    behaviour = mind(match)["behaviour"]
    return (behaviour >= BACK) & (behaviour <= ROTATE)


def approaches(match: Match) -> np.ndarray:
    """Return where (M,) the player of robot 0 tries to get to the ball."""
    found: np.ndarray = mind(match)["behaviour"] == APPROACH
    return found


def hold(match: Match) -> None:
    """Immobilise robots: from now on they go nowhere, whatever their legs do; they can still turn."""
    match.batch.constants["drive_traction"] = NO_GRIP
    for name in ("vx", "vy"):
        match.robots[name] = 0.0
    match.rebuild()


def anchor(match: Match, rows: Sequence[int]) -> None:
    """Make robots so heavy that nobody pushes them aside."""
    for space in match.batch.physics.spaces:
        bodies = [] if space is None else list(space.bodies)
        for r in rows:
            body = bodies[1 + r]  # the ball comes first
            body.mass, body.moment = HEAVY, HEAVY


def walk_up(batch: Batch, matches: int, nearest: float, farthest: float, **settings: Any) -> Match:
    """Return matches in which robot 0 walks towards a still ball `nearest` to `farthest` [m] ahead."""
    rng = batch.rng()
    match = seekers(batch, matches, **settings)
    heading = rng.uniform(-0.5, 0.5, matches)
    put(match, 0, START, rng.uniform(-0.3, 0.3, matches), heading, forward=match.league.drive.forward)
    put_ball(match, *ahead_of(match, 0, rng.uniform(nearest, farthest, matches), rng.uniform(-0.3, 0.3, matches)))
    begin_seeking(match)
    return match


def behind_post(batch: Batch, matches: int, ways: float = 0.4, **settings: Any) -> Match:
    """Return matches in which a robot that nobody pushes aside stands in robot 0's way to a still ball.

    It stands aside of the straight way, so far that the ball is seen past it, and their bodies overlap by up to
    OVERLAP; the ways (M,) [rad] are up to `ways` off the goal's direction.
    """
    rng = batch.rng()
    match = seekers(batch, matches, **settings)
    way, side = rng.uniform(-ways, ways, matches), rng.choice([-1.0, 1.0], matches)
    x, y = rng.uniform(-0.6, 0.3, matches), rng.uniform(-0.2, 0.2, matches)
    ahead, aside = rng.uniform(*POST, matches), side * (ABREAST - rng.uniform(0.0, OVERLAP, matches))
    put(match, 0, x, y, way)
    post_x, post_y = x + ahead * np.cos(way) - aside * np.sin(way), y + ahead * np.sin(way) + aside * np.cos(way)
    put(match, 1, post_x, post_y, way + np.pi + rng.uniform(-0.3, 0.3, matches))
    put_ball(match, *ahead_of(match, 0, ahead + rng.uniform(*BEYOND, matches), 0.0))
    begin_seeking(match)
    anchor(match, (1,))
    return match


def recover(match: Match, rows: Any = slice(None)) -> None:
    """Let the player of robot 0 begin a recovery now, as if it had noticed that it is stuck."""
    memory, team = match.squads[0].memory, match.squads[0].team
    assert isinstance(team, CompiledTeam)
    memory["behaviour"][rows, 0], memory["clock"][rows, 0], memory["stuck"][rows, 0] = BACK, 0.0, 0
    memory["tries"][rows, 0] = 1
    memory["left"][rows, 0] = team.settings["back_steps"][0] * match.league.drive.gait_steps * match.league.dt
