"""Scenes of the point simulator, for points and for robots: a dribbler on its way to the goal.  [Sacks 2001, 4.3]

Team frame: the dribbler comes from -x; its destination in the goal lies at x = 1.6 m.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001 import forces
from soccer_env.baselines.sacks_2001.memory import DRIBBLE
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.match.staging import memory_of
from soccer_env.train.papers.claim import Arrows, Batch, Curve, Figure
from soccer_env.train.papers.claims.field.point_world import PointRuns, PointWorld, count_flips, players
from soccer_env.train.papers.dribble_runs import NO_SHOTS, DribbleRecord, place_with_ball, record_dribble
from soccer_env.train.papers.staging import LEGGED, put, stage_team, still_actions, wrap_angle

SCENES = 256  # of a batch
SECONDS = 70.0  # [s] of a run: 2.8 m at 7 cm/s take 40
FIELD: Any = forces  # the team's own formulas
START = -1.2  # [m] x of the dribbler
ASIDE = 0.05  # [m] greatest distance of its start from the middle
ASKEW = 0.35  # [rad] greatest rotation of a gap: 20 degrees
TOUCH = 0.23  # [m] between two middles at which bodies touch: 16 cm to the paws, 8 cm to a flank
UNIT = 1.0 / (1.0 / 0.8 + 1.0 / 1.0)  # [m] where a player's force is 1 with the paper's constants
WALL_UNIT = 1.0 / (1.0 / 0.2 + 1.0 / 0.35)  # [m] where a wall's force is 1
NO_CUT_OFF = {"cut_off": False, "player_gain": UNIT, "wall_gain": WALL_UNIT}  # k2/x is 1 where the paper's forces are
SPEEDS = (0.03, 0.12)  # [m/s] of movers, up to a robot's top speed
NOISE = 0.08  # [1] of the range: the bound of S35
BLOBS = 0.2  # [1] share of decisions that see a player who is not there, assumed


def run_points(
    rng: np.random.Generator, start: np.ndarray, crowd: np.ndarray, world: dict[str, Any] | None = None, **play: Any
) -> PointRuns:
    """Run points from start (M, 2) past a crowd (M, P); `world`: fields of PointWorld, `play`: settings of the team."""
    return PointWorld(SacksSettings(**play), **(world or {})).run(start, crowd, SECONDS, rng)


def starts(rng: np.random.Generator, count: int = SCENES, aside: float = ASIDE) -> np.ndarray:
    """Draw the starts of dribblers (M, 2) [m], up to `aside` off the middle line."""
    return np.column_stack([np.full(count, START), rng.uniform(-aside, aside, count)])


def player_near_path(rng: np.random.Generator, nearest: float, widest: float, count: int = SCENES) -> np.ndarray:
    """Return one standing player (M, 1) near the middle of the path, `nearest` to `widest` [m] beside the path."""
    y = rng.uniform(nearest, widest, count) * rng.choice([-1.0, 1.0], count)
    return players(np.stack([rng.uniform(-0.3, 0.3, count), y], axis=-1)[:, None])


def gap_ahead(rng: np.random.Generator, narrowest: float, widest: float, askew: float = ASKEW) -> np.ndarray:
    """Return two standing players (M, 2) across the path, within `askew` [rad]; the gap [m] counts between middles."""
    half, angle = 0.5 * rng.uniform(narrowest, widest, SCENES), askew * rng.uniform(-1.0, 1.0, SCENES)
    x, y = rng.uniform(-0.3, 0.3, SCENES), rng.uniform(-0.05, 0.05, SCENES)
    sides = [np.stack([x - s * half * np.sin(angle), y + s * half * np.cos(angle)], axis=-1) for s in (1.0, -1.0)]
    return players(np.stack(sides, axis=1))


def approaching_player(rng: np.random.Generator) -> np.ndarray:
    """Return a player (M, 1) that comes from ahead, straight for the dribbler's start."""
    place = np.stack([rng.uniform(-0.2, 1.0, SCENES), rng.uniform(-0.3, 0.3, SCENES)], axis=-1)
    goal = np.stack([np.full(SCENES, START), rng.uniform(-0.15, 0.15, SCENES)], axis=-1)
    return players(place[:, None], velocities_towards(place, goal, rng)[:, None])


def players_on_both_sides(rng: np.random.Generator) -> np.ndarray:
    """Return two players (M, 2): one stands on one side of the path, the other comes from the other side."""
    side = rng.choice([-1.0, 1.0], SCENES)
    stands = np.stack([rng.uniform(-0.4, 0.2, SCENES), side * rng.uniform(0.05, 0.3, SCENES)], axis=-1)
    comes = np.stack([rng.uniform(-0.2, 0.8, SCENES), -side * rng.uniform(0.2, 0.7, SCENES)], axis=-1)
    velocity = velocities_towards(comes, np.stack([rng.uniform(-0.9, -0.3, SCENES), np.zeros(SCENES)], axis=-1), rng)
    return players(np.stack([stands, comes], axis=1), np.stack([0.0 * velocity, velocity], axis=1))


def velocities_towards(place: np.ndarray, goal: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Return velocities (M, 2) from places towards goals, with random speeds within SPEEDS."""
    way = goal - place
    return np.asarray(way / np.linalg.norm(way, axis=-1, keepdims=True) * rng.uniform(*SPEEDS, (SCENES, 1)))


def collided(runs: PointRuns) -> np.ndarray:
    """Tell in which runs the bodies would have touched (M,)."""
    return runs.clearance < TOUCH


def is_clean(runs: PointRuns) -> np.ndarray:
    """Tell in which runs the dribbler came to the goal and touched nobody (M,)."""
    return np.asarray(runs.arrived & ~collided(runs))


def draw_field(title: str, places: Any, plays: dict[str, dict[str, Any]], y: float = 0.0, **play: Any) -> Figure:
    """Return a picture of the forces over the field round players at rest at places (P, 2) [m], and of paths there.

    `plays`: the team's settings for each path, which begins at START, y [m]; `play`: its settings for the forces.
    """
    crowd, curves = players(places), []
    for name, settings in plays.items():
        path = run_points(np.random.default_rng(0), np.array([[START, y]]), crowd, **settings).path[:, 0]
        way = path[np.isfinite(path[:, 0])]
        curves.append(Curve(name, list(way[:, 0]), list(way[:, 1])))
    for i, one in enumerate(crowd[0]):
        curves.append(Curve("player" if i == 0 else f"player {i + 1}", [one["x"]], [one["y"]]))
    arrows = force_arrows(crowd, SacksSettings(**play))
    return Figure(title, "x [m], towards the goal", "y [m]", tuple(curves), arrows=arrows)


def force_arrows(crowd: np.ndarray, settings: SacksSettings) -> Arrows:
    """Return the directions of the total force, before any limit, on a grid over the field."""
    play, k = settings.record()[0], constants_of(find_league(LEGGED))[0]
    xs, ys = np.meshgrid(np.linspace(-1.2, 1.2, 25), np.linspace(-0.8, 0.8, 17))
    rows = []
    for x, y in zip(xs.ravel(), ys.ravel(), strict=True):
        goal = 0.5 * k["pitch_length"] + 0.1 - x, -y
        wall = 0.0, FIELD.wall_force(y, 0.5 * k["pitch_width"], play)
        force = np.add(FIELD.goal_force(*goal, play), wall)
        for one in crowd[0]:
            force = force + FIELD.player_force(one["x"] - x, one["y"] - y, *goal, play)
        rows.append((x, y, *(force / max(float(np.hypot(*force)), 1e-9))))
    return Arrows(*(list(column) for column in zip(*rows, strict=True)))


# The same scenes with robots, ball and sensors: the full simulator

ROBOTS = 24  # runs of a batch
ROBOT_SECONDS = 40.0  # [s] of a run: 1.5 m at 7 cm/s take 21
PASSED = 0.55  # [m] x beyond which a dribbler has passed the others, who stand before x = 0.3
GOAL_X = 1.6  # [m] x of a dribbler's destination


@dataclass(frozen=True)
class RobotRuns:
    """Runs of M dribbling robots over T control steps."""

    way: DribbleRecord
    off: np.ndarray  # (T, M) [rad] of the decided way off the goal's direction; NaN: it does not dribble

    @property
    def passed(self) -> np.ndarray:
        """Tell in which steps each dribbler has passed the others, now or before (T, M)."""
        return np.maximum.accumulate((self.way.x > PASSED) | self.way.goal, axis=0)

    @property
    def arrived(self) -> np.ndarray:
        """Tell which dribblers passed the others (M,)."""
        return np.asarray(self.passed[-1])

    @property
    def collided(self) -> np.ndarray:
        """Tell which dribblers touched another robot before they had passed (M,)."""
        return np.asarray((self.way.touches & ~self.passed).any(axis=0))

    @property
    def is_clean(self) -> np.ndarray:
        """Tell which dribblers passed the others without a touch (M,)."""
        return np.asarray(self.arrived & ~self.collided)

    @property
    def flips(self) -> np.ndarray:
        """Count the changes between left and right of the goal while dribbling (M,)."""
        return count_flips(np.where(self.passed, 0.0, self.off))

    @property
    def deviation(self) -> np.ndarray:
        """Return the greatest distance [m] from the straight path to the goal before the others are passed (M,)."""
        x, y = self.way.x, self.way.y
        to_x, to_y = GOAL_X - x[0], -y[0]
        across = np.abs(to_x * (y - y[0]) - to_y * (x - x[0])) / np.hypot(to_x, to_y)
        return np.asarray(np.where(self.passed, 0.0, across).max(axis=0))

    @property
    def retreat(self) -> np.ndarray:
        """Return by how far each dribbler falls back from the goal at most, before it passes the others (M,) [m]."""
        distance = np.hypot(GOAL_X - self.way.x, self.way.y)
        back = np.where(self.passed, 0.0, distance - np.minimum.accumulate(distance, axis=0))
        return np.asarray(back.max(axis=0))


def pad_with_nan(values: np.ndarray) -> np.ndarray:
    """Pad values of robots to (SCENES,), with NaN for the scenes that only points play."""
    padded = np.full(SCENES, np.nan)
    padded[: len(values)] = values
    return padded


def run_robots(
    batch: Batch, start: np.ndarray, crowd: np.ndarray, senses: str = "sensors", count: int = ROBOTS, **play: Any
) -> RobotRuns:
    """Let a robot of sacks-2001 with settings `play` dribble from start (M, 2) past a still or moving crowd (M, P).

    Only the first `count` scenes are played.
    """
    start, crowd = start[:count], crowd[:count]
    count, others = crowd.shape
    match = stage_team(
        batch, "sacks-2001", NO_SHOTS | play, opponents=None, matches=count, away=others, keeper=0, senses=senses
    )
    place_with_ball(match, start[:, 0], start[:, 1], np.arctan2(-start[:, 1], GOAL_X - start[:, 0]))
    actions = still_actions(match)
    for i in range(others):
        one = crowd[:, i]
        speed = np.hypot(one["vx"], one["vy"])
        faces = np.where(speed > 0.0, np.arctan2(one["vy"], one["vx"]), np.pi)
        put(match, 1 + i, one["x"], one["y"], faces, forward=speed)
        actions[:, 1 + i, 0] = speed / match.league.drive.forward
    off: list[np.ndarray] = []

    def note(step: int) -> None:
        memory, robot = memory_of(match), match.robots[:, 0]
        goal = np.arctan2(-robot["y"], GOAL_X - robot["x"])
        off.append(np.where(memory["behaviour"] == DRIBBLE, wrap_angle(memory["way"] - goal), np.nan))

    return RobotRuns(record_dribble(match, ROBOT_SECONDS, actions, note), np.array(off))
