"""Matches as arrays of records over time, a block of matches at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.train.play.gaps import Gaps, measure_gaps
from soccer_env.train.play.settings import Conditions
from soccer_env.types import BALL, EVENTS, MATCH, ROBOT, ROBOT_EVENTS, Phase

REPORT_EVERY = 50  # steps between two movements of the progress bar


def part_of(record: np.dtype, *names: str) -> np.dtype:
    """Return the dtype of some fields of a record, packed."""
    return np.dtype([(name, record[name]) for name in names])


MOMENT = part_of(MATCH, "phase", "placing", "last_touch_robot")
BALL_MOMENT = part_of(BALL, "x", "y", "vx", "vy")
ROBOT_MOMENT = part_of(
    ROBOT,
    "x",
    "y",
    "heading",
    "vx",
    "vy",
    "team",
    "keeper",
    "active",
    "target",
    "walk",
    "gait_phase",
    "kick_clock",
    "fallen",
    "has_ball",
)
WHISTLES = part_of(EVENTS, "goal", "separated", "restart")
DEEDS = part_of(ROBOT_EVENTS, "touch", "kick", "returned")


@dataclass(frozen=True)
class Recording:
    """M matches of T control steps with R robots: how they stood after each step, and what happened in it."""

    league: League
    live: np.ndarray  # (T, M) False once the match was over
    matches: np.ndarray  # (T, M) MOMENT
    balls: np.ndarray  # (T, M) BALL_MOMENT
    robots: np.ndarray  # (T, M, R) ROBOT_MOMENT
    events: np.ndarray  # (T, M) WHISTLES
    deeds: np.ndarray  # (T, M, R) DEEDS

    @cached_property
    def in_play(self) -> np.ndarray:
        """Return where (T, M) the ball is in play: no restart is being placed or waited for."""
        found: np.ndarray = self.live & (self.matches["phase"] == Phase.PLAY) & (self.matches["placing"] == 0)
        return found

    @cached_property
    def gaps(self) -> Gaps:
        """Return how far ball, robots and boards are apart."""
        return measure_gaps(self.league, self.balls, self.robots)

    @cached_property
    def ball_distance(self) -> np.ndarray:
        """Return the distance (T, M, R) [m] of each robot's centre from the ball."""
        x, y = (self.robots[name] - self.balls[name][..., None] for name in ("x", "y"))
        found: np.ndarray = np.hypot(x, y)
        return found

    def steps(self, seconds: float) -> int:
        """Return how many control steps a time [s] takes, at least one."""
        return max(1, round(seconds * self.league.control_rate))

    def seconds(self, flags: np.ndarray) -> np.ndarray:
        """Return for how long (M,) [s] a flag (T, M) holds."""
        found: np.ndarray = flags.sum(axis=0) * self.league.dt
        return found


def start(conditions: Conditions, seeds: Sequence[int]) -> Match:
    """Return matches at their kick-offs, one for each seed."""
    home, away = conditions.players
    return Match(
        conditions.league,
        home=home,
        away=away,
        matches=len(seeds),
        seeds=np.array(seeds, np.uint64),
        controllers=conditions.teams,
        senses=conditions.senses,
        pose=conditions.pose,
        placement=conditions.placement,
        minutes=conditions.minutes,
    )


def record(
    conditions: Conditions,
    seeds: Sequence[int],
    advance: Callable[[float], None] = lambda steps: None,
) -> Recording:
    """Play a block of matches to the end; `advance` gets match steps done."""
    match = start(conditions, seeds)
    moments = []
    for steps, live in enumerate(running(match), start=1):
        moments.append((live, *moment_of(match)))
        if steps % REPORT_EVERY == 0:
            advance(REPORT_EVERY * len(seeds))
    match.close()
    return Recording(match.league, *(np.stack(column) for column in zip(*moments, strict=True)))


def running(match: Match) -> Iterator[np.ndarray]:
    """Step matches to the end of the last; yield after each step which (M,) of them it moved on."""
    while not match.terminated.all():
        live = ~match.terminated
        match.step(None)
        yield live


def moment_of(match: Match) -> tuple[np.ndarray, ...]:
    """Return copies of what a recording keeps of matches as they stand."""
    kept = (
        (match.matches, MOMENT),
        (match.balls, BALL_MOMENT),
        (match.robots, ROBOT_MOMENT),
        (match.events, WHISTLES),
        (match.robot_events, DEEDS),
    )
    return tuple(records[list(kind.names or ())].astype(kind) for records, kind in kept)
