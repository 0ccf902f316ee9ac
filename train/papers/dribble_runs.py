"""Runs of a robot that dribbles with the ball between its paws, and the fate of the ball.  [Sacks 2001, 4.3]

All are staged: the referee calls goals alone (PATIENT), nobody is whistled for holding a ball or pulled apart, and no
stuck ball is called. Only runs of a drill with opponents that play for the ball until a goal (S31) use the rules of
play.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import DRIBBLE
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.match import Match
from soccer_env.match.arguments import Senses
from soccer_env.match.staging import memory_of
from soccer_env.scenes import Scene, find_scene, judging
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.staging import LEGGED, begin_scene, make_matches, put, put_ball, wrap_angle
from soccer_env.train.papers.verdicts import Samples
from soccer_env.types import HOME

NO_SHOTS = {"shoots": False}  # a team that keeps dribbling instead of shooting
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


def place_with_ball(match: Match, x: Any = START, y: Any = 0.0, heading: Any = 0.0) -> None:
    """Put robot 0 at a pose [m, rad], with the ball at its chest."""
    put(match, 0, x, y, heading)
    reach = match.league.body.front + match.league.ball.radius + 0.001
    put_ball(match, x + reach * np.cos(heading), y + reach * np.sin(heading))


def start_dribbling(match: Match) -> None:
    """Set the memory of a sacks team's first player as if it had just felt the ball and begun to dribble."""
    if not match.learns[0]:
        memory = memory_of(match)
        memory["begun"] = memory["attacks"] = 1
        memory["behaviour"] = DRIBBLE
        memory["had_ball"] = memory["role_clock"] = 0.0


def record_dribble(match: Match, seconds: float, actions: np.ndarray | None = None, moved: Any = None) -> DribbleRecord:
    """Play for `seconds` and record robot 0's path; `moved(step)` may move other robots before each step."""
    begin_scene(match, placed=True)
    start_dribbling(match)
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
    metres, lost = np.zeros((2, way.x.shape[1]))
    kept_until, holding = np.full(len(lost), np.inf), np.zeros(len(lost), bool)
    for has, dribbles, gap, step in zip(way.has_ball, way.dribbles, way.gap, way.step, strict=True):
        holding |= has & dribbles
        metres += np.where(holding & dribbles, step, 0.0)
        gone = holding & (gap > LOST)
        lost += gone
        kept_until = np.where(gone & ~np.isfinite(kept_until), metres, kept_until)
        holding &= ~gone
    early = kept_until < COUNTED
    return {"metres": metres, "lost": lost, "tried": early | (metres >= COUNTED), "kept": ~early & (metres >= COUNTED)}


# Runs of the dribbling drills

STEP = SacksSettings().step_length  # [m] of a dribbler
TOP = 0.12  # [m/s] of a walker at strength 1: the top speed ahead of the legged league
PAPER = 0.06  # [m/s] of movers in the drills
LONGEST = 40.0  # [s] of a run
HELD = 0.5  # [1] of a full step: a robot that moves less during a contact is stopped by it, assumed
TURNED = 0.09  # [rad] least turn of another robot by a contact: 5 degrees, more than by its gait, assumed


def start_drill(
    batch: Batch, scene: str | Scene, settings: dict[str, Any], matches: int, mover: float,
    senses: Senses = "sensors", opponents: str | None = None, rules: str | None = None,
) -> Match:  # fmt: skip
    """Return matches at the start of a drill's scene, never ended by the drill's test; movers walk at `mover` [m/s].

    `opponents`: a team that replaces the drill's opponents; `rules`: a rule set that replaces the drill's rules.
    """
    named = find_scene(scene)
    sides: dict[str, Any] = {"home": make_team("sacks-2001", **settings)}
    for row, name in enumerate(named.opponents):
        sides[f"away_{row}"] = "still" if name == "still" else f"walker@{mover / TOP:g}"
    if opponents is not None:
        sides = {"home": sides["home"], "away": opponents}
    match = make_matches(
        batch, LEGGED, rules or named.rules, matches=matches, home=1, away=len(named.opponents), scene=named,
        senses=senses, controllers=sides,
    )  # fmt: skip
    start_dribbling(match)
    return match


class Contacts:
    """Record of the dribbler's contacts in the runs of a drill, and of their effects."""

    def __init__(self, match: Match) -> None:
        self.headings = match.robots["heading"][:, 1:].copy()  # [rad] at the start: only the dribbler turns by itself
        self.trail: list[tuple[np.ndarray, ...]] = []  # x, y [m] of robot 0 and whether it touches, over a gait step
        # whether it touched somebody, and whether a contact stopped it for a gait step, or turned another
        self.touched, self.hindered = np.zeros((2, match.count), bool)

    def note(self, match: Match, running: np.ndarray) -> None:
        """Update the record after a control step, for the runs that still go on."""
        robot, others, gait = match.robots[:, 0], match.robots[:, 1:], int(match.league.drive.gait_steps)
        touches = match.robot_events["collision"][:, 0] == 1
        self.touched |= running & touches
        self.trail = [*self.trail[-gait:], (robot["x"].copy(), robot["y"].copy(), touches)]
        x, y, _ = self.trail[0]
        touching = np.array([touch for _, _, touch in self.trail]).any(axis=0)
        full = len(self.trail) > gait
        made = np.hypot(robot["x"] - x, robot["y"] - y) if full else np.inf
        turned = np.abs(wrap_angle(others["heading"] - self.headings)).max(axis=1) > TURNED
        self.hindered |= running & touching & (turned | (made < HELD * STEP))


class RunEnds:
    """How the runs of a drill end; arrays (M,)."""

    def __init__(self, match: Match) -> None:
        # beyond everybody with the ball or in the goal; the ball was far for a while
        self.past, self.lost = np.zeros((2, match.count), bool)
        self.away, self.seconds = np.zeros((2, match.count))  # [s] for which the ball has been far, and until the end
        self.nearest = np.full(match.count, np.inf)  # [m] least distance between the middles of bodies

    def note(self, match: Match, running: np.ndarray) -> None:
        """Update the ends after a control step, for the runs that still go on."""
        robot, ball = match.robots[:, 0], match.balls
        beyond = ball["x"] > match.robots["x"][:, 1:].max(axis=1) + judging.PAST
        self.past |= running & ((beyond & (robot["has_ball"] == 1)) | (match.events["goal"] == HOME))
        near = np.hypot(ball["x"] - robot["x"], ball["y"] - robot["y"]) <= judging.LOST
        self.away = np.where(near, 0.0, self.away + match.league.dt)
        self.lost |= running & ~self.past & (self.away > judging.LOST_TIME)
        self.seconds += running * match.league.dt
        others = match.robots[:, 1:]
        gap = np.hypot(others["x"] - robot["x"][:, None], others["y"] - robot["y"][:, None]).min(axis=1)
        self.nearest = np.where(running, np.minimum(self.nearest, gap), self.nearest)


def play_drill(
    batch: Batch, scene: str | Scene, settings: dict[str, Any], matches: int, mover: float = PAPER,
    senses: Senses = "sensors",
) -> Samples:  # fmt: skip
    """Let sacks-2001, with `settings` and without shots, play a drill's scene; return results (M,).

    Judged like the drill, but a touch ends nothing: "past", "lost", "seconds" and "nearest" as in Ends; "clean": past
    without a touch; "touched": touch before the end; "free": past, and no contact stopped it or turned another robot.
    """
    match = start_drill(batch, scene, NO_SHOTS | settings, matches, mover, senses)
    ends, contacts = RunEnds(match), Contacts(match)
    for _ in range(round(LONGEST * match.league.control_rate)):
        running = ~(ends.past | ends.lost)
        if not running.any():
            break
        match.step()
        contacts.note(match, running)
        ends.note(match, running)
    match.close()
    clean, free = ends.past & ~contacts.touched, ends.past & ~contacts.hindered
    samples = {name: getattr(ends, name) for name in ("past", "lost", "seconds", "nearest")}
    samples |= {"clean": clean, "free": free, "touched": contacts.touched}
    return {name: values.astype(float) for name, values in samples.items()}
