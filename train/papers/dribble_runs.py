"""Runs of a robot that dribbles with the ball between its paws, and the fate of the ball.  [Sacks 2001, 4.3]

All are staged: the referee calls goals alone (PATIENT), nobody is whistled for holding a ball or pulled apart.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import DRIBBLE
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.match.staging import memory_of
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.staging import begin_scene, put, put_ball, stage
from soccer_env.train.papers.verdicts import Samples

NO_SHOTS = {"shoots": False}  # a team that keeps dribbling instead of shooting
# Distances to other players from middle to middle, equal right ahead to those of the team's first version here
FROM_MIDDLE = {"distance_from": "middle", "blocked_range": 0.40}  # [m]
WAYS: dict[str, dict[str, Any]] = {"": {}, "middle ": FROM_MIDDLE}  # prefix of the samples: settings
LOST = 0.10  # [m] between the ball and the chest beyond which the ball is lost, assumed
START = -1.2  # [m] x of the dribbler
COUNTED = 1.0  # [m] over which the ball should be kept


@dataclass
class DribbleRecord:
    """The history of a run, arrays (T, M): one dribbler, robot 0, and the ball."""

    x: np.ndarray  # [m] field frame
    y: np.ndarray  # [m]
    gap: np.ndarray  # [m] from the chest to the ball's surface, between their centres' line
    has_ball: np.ndarray  # bool
    dribbles: np.ndarray  # bool: it has decided to dribble
    touches: np.ndarray  # bool: it touches another robot
    ball_x: np.ndarray  # [m]
    ball_y: np.ndarray  # [m]
    goal: np.ndarray  # bool: a goal of its team was scored

    @property
    def step(self) -> np.ndarray:
        """Return the distance [m] that the robot moves in each control step."""
        return np.hypot(np.diff(self.x, axis=0, prepend=self.x[:1]), np.diff(self.y, axis=0, prepend=self.y[:1]))


def set_up_dribblers(
    batch: Batch, league: League, matches: int, others: int, settings: dict[str, Any], **more: Any
) -> Match:
    """Set up matches in which sacks-2001 with `settings` plays robot 0, and `others` opponents stand still."""
    team = make_team("sacks-2001", **settings)
    sides = {"home": team, "away": more.pop("away_team", "still")}
    return stage(batch, league, matches=matches, away=others, controllers=sides, keeper=0, **more)


def place_with_ball(match: Match, x: Any = START, y: Any = 0.0, heading: Any = 0.0) -> None:
    """Put robot 0 at a pose [m, rad], with the ball at its chest."""
    put(match, 0, x, y, heading)
    reach = match.league.body.front + match.league.ball.radius + 0.001
    put_ball(match, x + reach * np.cos(heading), y + reach * np.sin(heading))


def begin_dribbling(match: Match) -> None:
    """Begin the scene: the robots know their places, and robot 0's player already dribbles."""
    begin_scene(match, placed=True)
    start_dribbling(match)


def start_dribbling(match: Match) -> None:
    """Set the memory of a sacks team's first player as if it had just felt the ball and begun to dribble."""
    if not match.learns[0]:
        memory = memory_of(match)
        memory["begun"] = memory["attacks"] = 1
        memory["behaviour"] = DRIBBLE
        memory["had_ball"] = memory["role_clock"] = 0.0


def record_dribble(match: Match, seconds: float, actions: np.ndarray | None = None, moved: Any = None) -> DribbleRecord:
    """Play for `seconds` and record robot 0's path; `moved(step)` may move other robots before each step."""
    begin_dribbling(match)
    rows: list[tuple[np.ndarray, ...]] = []
    for step in range(round(seconds * match.league.control_rate)):
        if moved is not None:
            moved(step)
        match.step(actions)
        rows.append(read_step(match))
    match.close()
    return DribbleRecord(*(np.array(column) for column in zip(*rows, strict=True)))


def read_step(match: Match) -> tuple[np.ndarray, ...]:
    """Return the fields of Way for the current step."""
    robot, ball = match.robots[:, 0], match.balls
    away = np.hypot(ball["x"] - robot["x"], ball["y"] - robot["y"])
    gap = away - match.league.body.front - match.league.ball.radius
    dribbles = np.ones(match.count, bool) if match.learns[0] else memory_of(match)["behaviour"] == DRIBBLE
    fields = (robot["x"], robot["y"], gap, robot["has_ball"] == 1, dribbles, match.robot_events["collision"][:, 0] == 1)
    scored = match.matches["score"][:, 0] > 0
    return tuple(np.array(value) for value in (*fields, ball["x"], ball["y"], scored))


def losses(way: DribbleRecord) -> Samples:
    """Count in each run (M,) the metres dribbled and the balls lost, and whether the first metre kept the ball.

    A ball is lost when it was between the paws of a dribbling robot and is then LOST away; the robot can lose it again
    once it has it back.
    """
    matches = way.x.shape[1]
    metres = np.zeros(matches)
    lost = np.zeros(matches)
    kept_until = np.full(matches, np.inf)
    holding = np.zeros(matches, bool)
    for has, dribbles, gap, step in zip(way.has_ball, way.dribbles, way.gap, way.step, strict=True):
        holding |= has & dribbles
        metres += np.where(holding & dribbles, step, 0.0)
        gone = holding & (gap > LOST)
        lost += gone
        kept_until = np.where(gone & ~np.isfinite(kept_until), metres, kept_until)
        holding &= ~gone
    early = kept_until < COUNTED
    return {"metres": metres, "lost": lost, "tried": early | (metres >= COUNTED), "kept": ~early & (metres >= COUNTED)}
