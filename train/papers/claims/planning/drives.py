"""Drives past moving robots on real bases: by either planner, with inertia, delay and sensors.  [Heinemann 2006, 3]

A field player of heinemann-2006 drives to a still ball. Obstacles come to its way about when it does, at 0.5 to 5 m/s
("robots in RoboCup are moving at speeds up to 5 m/s"); they keep their velocities, whatever is in their way.
"""

from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.claims.planning.runs import BODY, CROSSERS, LATE
from soccer_env.train.papers.staging import MIDDLE, begin_scene, put, put_ball, stage_team
from soccer_env.train.papers.verdicts import Samples

KINDS = {"crossing": (1, 0.25, 0.75), "oncoming": (1, 0.83, 1.0), "traffic": (3, 0.25, 1.0)}  # others, courses [pi rad]
DRIVES = 24  # of each kind in a batch
FAR = 5.5  # [m] of the ball
LOOK, LONGEST = 0.5, 8.0  # [s] before the start and of a drive at most
THERE = 1.3  # [m] from the ball: plans end 1.2 m from it
EDGE = (5.7, 3.7)  # [m] beyond which obstacles stand
ROOM = 0.8  # [m] of obstacles from the ball, which they would push
AGAINST = -0.8  # cosine of a course that comes from beyond the ball
RETREAT = 0.001  # [m] in a cycle that count as driving away
BEND = 5  # cycles between two points of the driven way, for its turn
TEAMS: dict[str, dict[str, Any]] = {"old": {"planner": "static"}, "new": {}}  # Weigel's planner, the paper's
DRIVE_TEXT = (
    f"{DRIVES} drives a batch in each of three scenes, by sensors and particles: a field player of the team drives to "
    f"a still ball {FAR:g} m away; one robot crosses the way, or comes against it, or three come from all sides but "
    f"behind, at {CROSSERS[0]:g} to {CROSSERS[1]:g} m/s, at the way when the player would be, to {LATE:g} s"
)


def draw_drives(batch: Batch, kind: str) -> dict[str, np.ndarray]:
    """Draw drives: signs of the way along x and its y (M,); places, courses, speeds and times of obstacles (M, n)."""
    rng, (count, low, high) = batch.rng(list(KINDS).index(kind)), KINDS[kind]
    shape, drive = (DRIVES, count), find_league(MIDDLE).drive
    sign, y = rng.choice([-1.0, 1.0], DRIVES), rng.uniform(-1.0, 1.0, DRIVES)
    far, late, speed = (
        rng.uniform(0.3, 0.7, shape) * FAR,
        rng.uniform(-LATE, LATE, shape),
        rng.uniform(*CROSSERS, shape),
    )
    course = np.pi * rng.uniform(low, high, shape) * rng.choice([-1.0, 1.0], shape)
    ux, uy = sign[:, None] * np.cos(course), np.sin(course)
    x = sign[:, None] * (far - 0.5 * FAR)
    when = far / drive.forward + 0.5 * drive.forward / drive.acceleration + late  # its speed grows evenly
    back = [(edge + np.sign(u) * at) / np.maximum(np.abs(u), 1e-9) for edge, u, at in
            zip(EDGE, (ux, uy), (x, y[:, None]), strict=True)]  # fmt: skip
    ahead = np.where(np.cos(course) < AGAINST, np.maximum(FAR - far - ROOM, ROOM), np.inf)  # behind it lies the ball
    run = np.minimum(np.minimum(*back), np.minimum(ahead, speed * (when + LOOK)))
    return {"sign": sign, "y": y, "x": x, "ux": ux, "uy": uy, "speed": speed, "start": when - run / speed, "when": when}


def move_obstacles(match: Match, drives: dict[str, np.ndarray], now: float) -> None:
    """Put the obstacles where they are `now` [s]; those that have come to the pitch's edge, or to the ball, stand."""
    gone = drives["speed"] * (np.maximum(now, drives["start"]) - drives["when"])
    x, y = drives["x"] + gone * drives["ux"], drives["y"][:, None] + gone * drives["uy"]
    inside = (np.abs(x) < EDGE[0]) & (np.abs(y) < EDGE[1]) | (gone < 0.0)
    clear = np.hypot(match.balls["x"][:, None] - x, match.balls["y"][:, None] - y) > ROOM
    for i in range(x.shape[1]):
        r, goes = 2 + i, inside[:, i] & clear[:, i]
        course = np.arctan2(drives["uy"][:, i], drives["ux"][:, i])
        speed = np.where(goes & (now >= drives["start"][:, i]), drives["speed"][:, i], 0.0)
        stays = (match.robots["active"][:, r] == 1) & ~goes
        put(match, r, np.where(stays, match.robots["x"][:, r], x[:, i]),
            np.where(stays, match.robots["y"][:, r], y[:, i]), course, forward=speed)  # fmt: skip
    match.rebuild()


def drive(batch: Batch, kind: str, settings: dict[str, Any]) -> Samples:
    """Let the team with `settings` drive; return smallest gaps [m], times [s], turns [degrees], cycles away (M,)."""
    drives, count = draw_drives(batch, kind), KINDS[kind][0]
    match = stage_team(batch, "heinemann-2006", settings, MIDDLE, opponents=None, matches=DRIVES, home=2, away=count)
    facing = np.where(drives["sign"] > 0.0, 0.0, np.pi)
    start = -0.5 * FAR * drives["sign"], drives["y"], facing
    put(match, 1, *start)
    put_ball(match, 0.5 * FAR * drives["sign"], drives["y"])
    move_obstacles(match, drives, -LOOK)
    begin_scene(match, placed=True)
    rate, rows = match.league.control_rate, []
    over = np.zeros(DRIVES, bool)
    for step in range(-round(LOOK * rate), round(LONGEST * rate)):
        if step <= 0:
            put(match, 1, *start)
        move_obstacles(match, drives, step / rate)
        match.step(np.zeros((DRIVES, 2 + count, match.settings.actions.size)))
        robots = match.robots
        gap = np.hypot(robots["x"][:, 2:] - robots["x"][:, 1:2], robots["y"][:, 2:] - robots["y"][:, 1:2]).min(axis=1)
        left = np.hypot(match.balls["x"] - robots["x"][:, 1], match.balls["y"] - robots["y"][:, 1])
        if step >= 0:
            values = np.stack([robots["x"][:, 1], robots["y"][:, 1], gap - BODY, left])
            rows.append(np.where(over, np.nan, values))
        over |= left < THERE
        if over.all():
            break
    match.close()
    return results_of(np.array(rows), match.league.dt)


def results_of(way: np.ndarray, dt: float) -> Samples:
    """Return the results of drives from x, y, gap and distance left [m] (T, 4, M), NaN once they have arrived."""
    path = way[::BEND, :2]
    step = np.diff(path, axis=0)
    course = np.where(np.hypot(step[:, 0], step[:, 1]) > 0.02, np.arctan2(step[:, 1], step[:, 0]), np.nan)
    turn = np.zeros(way.shape[2])
    for m in range(way.shape[2]):
        known = course[np.isfinite(course[:, m]), m]
        turn[m] = np.abs((np.diff(known) + np.pi) % (2.0 * np.pi) - np.pi).sum()
    gap = np.nanmin(way[:, 2], axis=0)
    return {
        "hit": (gap < 0.0).astype(float), "gap": gap, "time": dt * np.isfinite(way[:, 3]).sum(axis=0),
        "turn": np.degrees(turn), "away": (np.diff(way[:, 3], axis=0) > RETREAT).sum(axis=0).astype(float),
    }  # fmt: skip


def drive_with_both_planners(batch: Batch) -> Samples:
    """Return the results of both planners' drives, "old ..." and "new ...", and the number in KINDS of each scene."""
    samples: Samples = {"kind": np.repeat(np.arange(len(KINDS)), DRIVES)}
    for name, settings in TEAMS.items():
        found = [drive(batch, kind, settings) for kind in KINDS]
        samples |= {f"{name} {key}": np.concatenate([one[key] for one in found]) for key in found[0]}
    return samples
