"""Scenes for the planners; points that travel through them, single plans, and drives on real bases.  [H. 2006, 3]

Obstacles are rows of x, y [m], vx, vy [m/s]; the middle of the pitch is at 0, 0. In a drive, with inertia, delay and
sensors, a field player of heinemann-2006 drives to a still ball. Obstacles come to its way about when it does, at 0.5
to 5 m/s ("robots in RoboCup are moving at speeds up to 5 m/s"); they keep their velocities, whatever is in their way.
"""

from collections.abc import Callable
from functools import partial
from math import cos, pi, sin
from typing import Any, NamedTuple

import numpy as np

from soccer_env.baselines.weigel_2001.planner import Plan, Planner, PlannerSettings, Travel
from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.train.papers.claim import FIRST, Batch, compare, join_batches
from soccer_env.train.papers.staging import MIDDLE, begin_scene, put, put_ball, stage_team
from soccer_env.train.papers.verdicts import Samples

BODY = 0.5  # [m] between the middles of two robots that touch
WAY = 5.0  # [m] from robot to target, as in the paper's figure
CROSSERS = (0.5, 5.0)  # [m/s] of an obstacle: robots moved at up to 5 m/s, Heinemann 2006, 3  MH25
LATE = 0.3  # [s] by which it comes earlier or later than the robot, at most, assumed
SLOW = 0.3  # [m/s] of slow traffic at most
SLOW_OBSTACLES = 4
STAYS = 4.0  # [s] for which it leaves the target free, twice the time of the straight way
ROOM = 0.9  # [m] free of slow traffic around robot and target, assumed


class Scene(NamedTuple):
    """The input of a planner: the robot's start, its target, and the obstacles."""

    robot: tuple[float, float]
    target: tuple[float, float]
    obstacles: list[tuple[float, float, float, float]]


# Crossings of the straight way as in the paper's figure: chosen with a sketch of the planner, 2 of 260 draws
CANONICAL = {
    "a": Scene((-3.0, 0.0), (3.0, 0.0), [(-0.31, 1.15, 0.0, -2.13)]),
    "b": Scene((-3.0, 0.0), (2.0, 0.0), [(-1.15, 0.63, 0.0, -2.15)]),
}


def turned_scene(rng: np.random.Generator, obstacles: list[tuple[float, float, float, float]]) -> Scene:
    """Rotate a scene, given with its path of WAY metres along x, at random, and move it near the pitch's middle."""
    way = rng.uniform(-pi, pi)
    x, y = rng.uniform(-0.5, 0.5, 2) - 0.5 * WAY * np.array([cos(way), sin(way)])

    def place(ahead: float, left: float) -> tuple[float, float]:
        return float(x + cos(way) * ahead - sin(way) * left), float(y + sin(way) * ahead + cos(way) * left)

    def turn(ahead: float, left: float) -> tuple[float, float]:
        return float(cos(way) * ahead - sin(way) * left), float(sin(way) * ahead + cos(way) * left)

    rows = [(*place(ox, oy), *turn(vx, vy)) for ox, oy, vx, vy in obstacles]
    return Scene(place(0.0, 0.0), place(WAY, 0.0), rows)


def crossing(rng: np.random.Generator, speed: float) -> Scene:
    """Draw a scene in which an obstacle crosses the straight path as a robot of `speed` [m/s] comes to this point."""
    far = rng.uniform(0.3, 0.7) * WAY
    when = far / speed + rng.uniform(-LATE, LATE)
    v, way = rng.uniform(*CROSSERS), rng.choice([-1.0, 1.0]) * rng.uniform(pi / 4, 3 * pi / 4)
    vx, vy = v * cos(way), v * sin(way)
    return turned_scene(rng, [(far - when * vx, -when * vy, vx, vy)])


def slow_traffic(rng: np.random.Generator) -> Scene:
    """Draw a scene with obstacles that move slowly in any direction, the first of them near the straight path."""
    rows: list[tuple[float, float, float, float]] = []
    while len(rows) < SLOW_OBSTACLES:
        wide = 0.3 if not rows else 1.5
        x, y = rng.uniform(0.8, WAY - 0.8), rng.uniform(-wide, wide)
        v, way = rng.uniform(0.0, SLOW), rng.uniform(-pi, pi)
        if min(np.hypot(x + t * v * cos(way) - WAY, y + t * v * sin(way)) for t in np.linspace(0.0, STAYS, 9)) < ROOM:
            continue
        apart = min((np.hypot(x - ox, y - oy) for ox, oy, _, _ in rows), default=9.0)
        if min(np.hypot(x, y), np.hypot(x - WAY, y), apart) > ROOM:
            rows.append((float(x), float(y), float(v * cos(way)), float(v * sin(way))))
    return turned_scene(rng, rows)


def still_obstacle(rng: np.random.Generator) -> Scene:
    """Draw a scene with one standing obstacle on the straight path or a little beside the path."""
    return turned_scene(rng, [(float(rng.uniform(0.35, 0.65) * WAY), float(rng.uniform(-0.2, 0.2)), 0.0, 0.0)])


def robot_row_or_cup(rng: np.random.Generator) -> Scene:
    """Draw a scene with a row of two or three touching robots across the path, or a cup of nine about the target."""
    kind = rng.integers(3)
    middle = float(rng.uniform(0.4, 0.6) * WAY)
    if kind < 2:
        count = 2 + kind
        return turned_scene(rng, [(middle, BODY * (i - 0.5 * (count - 1)), 0.0, 0.0) for i in range(count)])
    bottom = WAY - 0.85
    rows = [(bottom, BODY * i, 0.0, 0.0) for i in range(-2, 3)]
    rows += [(bottom + BODY * i, side * 2.0 * BODY, 0.0, 0.0) for i in (1, 2) for side in (-1.0, 1.0)]
    return turned_scene(rng, rows)


SPEED = PlannerSettings().speed  # [m/s] of the robot
SCENES = 200  # single plans of a batch
PLANNED = f"{SCENES} crossings a batch, of one obstacle and a way of {WAY:g} m, each planned once"
LONGEST = 15.0  # [s] of a travel: three times the canonical ones
PLANNERS: dict[str, dict[str, Any]] = {"old": {"time_variant": False}, "new": {}}  # Weigel's, the paper's
Draw = Callable[[np.random.Generator], Scene]
CROSSING: Draw = partial(crossing, speed=SPEED)


def scenes_of(batch: Batch, draw: Draw, count: int) -> list[Scene]:
    """Draw `count` scenes of a batch with the function `draw`."""
    rng = batch.rng()
    return [draw(rng) for _ in range(count)]


def travel(scene: Scene, **changes: Any) -> Travel:
    """Return the travel of a point through a scene, led by a planner with the settings `changes`."""
    return Planner(**changes).travel(*scene, seconds=LONGEST)


def plan(scene: Scene, **changes: Any) -> Plan:
    """Return the plan for one scene by a planner with the settings `changes`."""
    return Planner(**changes).plan(*scene)


def plans_of(batch: Batch, draw: Draw = CROSSING, **changes: Any) -> list[Plan]:
    """Return one plan for each scene of a batch, by a planner with the settings `changes`."""
    planner = Planner(**changes)
    return [planner.plan(*scene) for scene in scenes_of(batch, draw, SCENES)]


def side_changes(travels: Travel) -> int:
    """Return how often the plans of a travel change the side on which they pass the first obstacle.

    The side of the obstacle, seen along the path, counts where the planned path is nearest to it; a plan that stays
    more than a metre away has no side.
    """
    sides = [passing_side(travels, cycle) for cycle in range(len(travels.stations) - 1)]
    there = [side for side in sides if side != 0]
    return sum(a != b for a, b in zip(there, there[1:], strict=False))


def passing_side(travels: Travel, cycle: int) -> int:
    """Return +1 if a cycle's plan passes with the first obstacle on its left, -1 on its right, 0 if it is not near."""
    path = travels.planned(cycle)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    one = travels.obstacles[0]
    t = cycle * 0.02 + along / travels.settings.speed
    x, y = one["x"] + t * one["vx"] - path[:, 0], one["y"] + t * one["vy"] - path[:, 1]
    nearest = int(np.argmin(np.hypot(x, y)))
    if np.hypot(x[nearest], y[nearest]) > 1.0 or nearest in (0, len(path) - 1):
        return 0
    way = path[nearest + 1] - path[nearest - 1]
    across = way[0] * y[nearest] - way[1] * x[nearest]
    return int(np.sign(across))


def travel_results(travels: list[Travel]) -> Samples:
    """Return results of travels (M,): arrival, collision, smallest gap [m], time [s], length [m], turn [degrees] ..."""
    figures = {"arrived": "arrived", "gap": "clearance", "time": "time", "length": "length", "away": "cycles_away"}
    found = {key: np.array([getattr(one, part) for one in travels], float) for key, part in figures.items()}
    turn = np.array([np.degrees(one.turn) for one in travels], float)
    return found | {"hit": (found["gap"] < 0.0).astype(float), "turn": turn}


# Drives past moving robots on real bases

KINDS = {"crossing": (1, 0.25, 0.75), "oncoming": (1, 0.83, 1.0), "traffic": (3, 0.25, 1.0)}  # others, courses [pi rad]
DRIVES = 24  # of each kind in a batch
FAR = 5.5  # [m] of the ball
LOOK, DRIVE_LONGEST = 0.5, 8.0  # [s] before the start and of a drive at most
THERE = 1.3  # [m] from the ball: plans end 1.2 m from it
EDGE = (5.7, 3.7)  # [m] beyond which obstacles stand
BALL_ROOM = 0.8  # [m] of obstacles from the ball, which they would push
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
    far, late = rng.uniform(0.3, 0.7, shape) * FAR, rng.uniform(-LATE, LATE, shape)
    speed = rng.uniform(*CROSSERS, shape)
    course = np.pi * rng.uniform(low, high, shape) * rng.choice([-1.0, 1.0], shape)
    ux, uy = sign[:, None] * np.cos(course), np.sin(course)
    x = sign[:, None] * (far - 0.5 * FAR)
    when = far / drive.forward + 0.5 * drive.forward / drive.acceleration + late  # its speed grows evenly
    back = [(edge + np.sign(u) * at) / np.maximum(np.abs(u), 1e-9) for edge, u, at in
            zip(EDGE, (ux, uy), (x, y[:, None]), strict=True)]  # fmt: skip
    # behind it lies the ball
    ahead = np.where(np.cos(course) < AGAINST, np.maximum(FAR - far - BALL_ROOM, BALL_ROOM), np.inf)
    run = np.minimum(np.minimum(*back), np.minimum(ahead, speed * (when + LOOK)))
    return {"sign": sign, "y": y, "x": x, "ux": ux, "uy": uy, "speed": speed, "start": when - run / speed, "when": when}


def move_obstacles(match: Match, drives: dict[str, np.ndarray], now: float) -> None:
    """Put the obstacles where they are `now` [s]; those that have come to the pitch's edge, or to the ball, stand."""
    gone = drives["speed"] * (np.maximum(now, drives["start"]) - drives["when"])
    x, y = drives["x"] + gone * drives["ux"], drives["y"][:, None] + gone * drives["uy"]
    inside = (np.abs(x) < EDGE[0]) & (np.abs(y) < EDGE[1]) | (gone < 0.0)
    clear = np.hypot(match.balls["x"][:, None] - x, match.balls["y"][:, None] - y) > BALL_ROOM
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
    for step in range(-round(LOOK * rate), round(DRIVE_LONGEST * rate)):
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
    drives = compare(TEAMS, lambda settings: join_batches([drive(batch, kind, settings) for kind in KINDS]), FIRST)
    return {"kind": np.repeat(np.arange(len(KINDS)), DRIVES), **drives}
