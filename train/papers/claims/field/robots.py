"""The scenes of the point simulator with robots, ball and sensors: the full simulator.  [Sacks 2001, 4.3]"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import DRIBBLE
from soccer_env.match.staging import memory_of
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.claims.field.point_world import count_flips
from soccer_env.train.papers.claims.field.points import SCENES
from soccer_env.train.papers.dribble_runs import NO_SHOTS, DribbleRecord, place_with_ball, record_dribble
from soccer_env.train.papers.staging import put, stage_team, still_actions, wrap_angle

ROBOTS = 24  # runs of a batch
SECONDS = 40.0  # [s] of a run: 1.5 m at 7 cm/s take 21
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

    return RobotRuns(record_dribble(match, SECONDS, actions, note), np.array(off))
