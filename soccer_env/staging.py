"""Put robots and ball of running matches somewhere, for claims and tests.

Records are set directly; `match.rebuild()` then rebuilds the physics from them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import NEVER, League
from soccer_env.match import Match
from soccer_env.physics.space import parking_place
from soccer_env.types import NO_TEAM


def patient(league: str | League) -> League:
    """Return the league with a referee who never calls a stuck ball and pulls nobody apart."""
    found = find_league(league)
    return replace(found, rules=replace(found.rules, stuck_time=NEVER, contact_time=NEVER))


def set_phase(match: Match, phase: int) -> None:
    """Set the phase of play, nobody to take a restart."""
    match.matches["phase"], match.matches["restart_team"] = phase, NO_TEAM
    match.matches["phase_clock"] = 0.0


def send_off(match: Match, rows: Iterable[int]) -> None:
    """Park robots off the field."""
    for r in rows:
        match.robots["active"][:, r] = 0
        match.robots["x"][:, r], match.robots["y"][:, r], match.robots["heading"][:, r] = parking_place(r)


def put(match: Match, r: Any, x: Any, y: Any, heading: Any = 0.0, forward: Any = 0.0, left: Any = 0.0) -> None:
    """Put robot r (or several) of every match on the field [m, rad, field frame], walking [m/s, robot frame]."""
    robots = match.robots
    robots["active"][:, r] = 1
    robots["x"][:, r], robots["y"][:, r], robots["heading"][:, r] = x, y, heading
    cosine, sine = np.cos(heading), np.sin(heading)
    robots["vx"][:, r], robots["vy"][:, r] = cosine * forward - sine * left, sine * forward + cosine * left
    robots["omega"][:, r] = 0.0
    for name, speed in (("forward", forward), ("left", left), ("turn", 0.0)):
        robots["walk"][name][:, r] = robots["target"][name][:, r] = speed
        robots["delayed"][name][:, r] = np.asarray(speed)[..., None]


def put_ball(match: Match, x: Any, y: Any, vx: Any = 0.0, vy: Any = 0.0, rolls: bool = True) -> None:
    """Put the ball of every match somewhere [m, field frame], rolling [m/s], or sliding as after a kick."""
    ball = match.balls
    ball["x"], ball["y"], ball["vx"], ball["vy"] = x, y, vx, vy
    ball["roll_x"], ball["roll_y"] = (vx, vy) if rolls else (0.0, 0.0)
    ball["spin"] = 0.0
    match.matches["still_x"], match.matches["still_y"], match.matches["still_clock"] = x, y, 0.0
