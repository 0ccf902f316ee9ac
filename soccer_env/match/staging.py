"""Stage running matches for experiments: place robots and ball, and reach the internal records of a match.

    put(match, 0, x=0.0, y=0.0); put_ball(match, 0.5, 0.0)      set records directly
    begin(match)                                                update bodies and senses from the records

Claims (`train/papers/staging.py`) and tests (`tests/scenes/staging.py`) build on this file and reach the internals of
a match through it alone, so that the internals may move.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.leagues.rules import rule_set
from soccer_env.match import Match
from soccer_env.match.squads import Squad
from soccer_env.physics.parking import parking_place
from soccer_env.scenes.scene import PATIENT as PATIENT
from soccer_env.types import NO_TEAM


def league_without_calls(league: str | League) -> League:
    """Return the league with a lenient referee: no stuck ball, no fouls, no separated robots."""
    preset = find_league(league)
    return replace(preset, rules=rule_set(preset.rules, PATIENT))


def set_phase(match: Match, phase: int) -> None:
    """Set the phase of play, with no team to take a restart."""
    match.matches["phase"], match.matches["restart_team"] = phase, NO_TEAM
    match.matches["phase_clock"] = 0.0


def send_off(match: Match, rows: Iterable[int]) -> None:
    """Park robots off the field."""
    for r in rows:
        match.robots["active"][:, r] = 0
        match.robots["x"][:, r], match.robots["y"][:, r], match.robots["heading"][:, r] = parking_place(r)


def put(match: Match, r: Any, x: Any, y: Any, heading: Any = 0.0, forward: Any = 0.0, left: Any = 0.0) -> None:
    """Place robot r (or several) in every match [m, rad, field frame], walking at forward, left [m/s, robot frame]."""
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
    """Place the ball in every match [m, field frame], rolling at (vx, vy) [m/s], or sliding as after a kick."""
    ball = match.balls
    ball["x"], ball["y"], ball["vx"], ball["vy"] = x, y, vx, vy
    ball["roll_x"], ball["roll_y"] = (vx, vy) if rolls else (0.0, 0.0)
    ball["spin"] = 0.0
    match.matches["still_x"], match.matches["still_y"] = x, y
    match.matches["still_clock"] = 0.0


def begin_scene(match: Match, placed: bool = False) -> None:
    """Begin a staged scene: move the bodies to the poses in the records, and clear percepts and beliefs.

    `placed`: robots know where they stand, as after a restart, and take their first look.
    """
    match.rebuild()
    if match.batch.senses is not None:
        for m in range(match.count):
            match.batch.senses.start(m)
    if placed:
        match.robots["placed"] = match.robots["active"]
        for m in range(match.count):
            match.batch.sense_first_frame(m)


# Internal records of a match, as views: to be read and changed


def squad_of(match: Match, r: int) -> Squad:
    """Return the squad that plays robot r; ValueError if no team plays robot r."""
    for squad in match.squads:
        if r in squad.players:
            return squad
    raise ValueError(f"robot {r} is played from outside: no team of the match remembers anything for it")


def memory_of(match: Match, r: int = 0) -> np.ndarray:
    """Return the memory (M,) of robot r's team for robot r, a record of the team's own dtype."""
    squad = squad_of(match, r)
    memory: np.ndarray = squad.memory[:, int(np.flatnonzero(squad.players == r)[0])]
    return memory


def team_settings_of(match: Match, r: int = 0) -> np.ndarray:
    """Return the settings (rows,) that the compiled team of robot r uses."""
    settings: np.ndarray = squad_of(match, r).settings
    return settings


def sensors_of(match: Match) -> np.ndarray:
    """Return the sensor settings (1,) that the running match uses."""
    settings: np.ndarray = _senses_of(match).sensors
    return settings


def memory_settings_of(match: Match) -> np.ndarray:
    """Return the settings (1,) of the robots' memory that the running match uses to form beliefs."""
    settings: np.ndarray = _senses_of(match).memory_settings
    return settings


def constants_of(match: Match) -> np.ndarray:
    """Return the league's constants (1,) that the running match uses."""
    return match.batch.constants


def set_mass(match: Match, rows: Iterable[int], mass: float, moment: float) -> None:
    """Set mass [kg] and moment of inertia [kg m2] of robots, until their physics Space is rebuilt."""
    match.batch.physics.forget()
    for space in match.batch.physics.spaces:
        bodies = [] if space is None else list(space.bodies)
        for r in rows:
            body = bodies[1 + r]  # the ball comes first
            body.mass, body.moment = mass, moment


def _senses_of(match: Match) -> Any:
    """Return the senses of a match; ValueError if no robot uses its sensors."""
    if match.batch.senses is None:
        raise ValueError("nobody in this match uses its sensors")
    return match.batch.senses
