"""The fate of robots that were held in play: the future of sampled moments, with the recovery and without."""

from collections.abc import Callable
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import BACK, ROTATE, SIDESTEP
from soccer_env.match import Match
from soccer_env.match.staging import memory_of
from soccer_env.train.papers.claim import Batch, shared
from soccer_env.train.papers.claims.stuck import sampled
from soccer_env.train.papers.claims.stuck.runs import begin_recovery
from soccer_env.train.papers.claims.stuck.sampled import HELD, MATCHES, MOST
from soccer_env.train.papers.staging import play, wrap_angle
from soccer_env.train.papers.verdicts import Samples
from soccer_env.types import AWAY, HOME, NO_TEAM

FUTURE = 24.0  # [s] of a branch
FREE_TIME = 1.0  # [s] of walking as commanded, without contact, after which a robot is free; assumed
AS_COMMANDED = 0.5  # [1] least share of the way that its legs walk, assumed
NUMBERS = ("got", "freed", "began", "aside", "over", "again", "tries", "goals", "before", "after", "at ball")


class Fate:
    """Events in the future of one robot in each match: times [s] since the sampled moment (N,), NaN for no event."""

    def __init__(self, match: Match, robots: np.ndarray) -> None:
        self.match, self.robots, self.rows = match, robots, np.arange(match.count)
        self.watch = sampled.MotionWindow(match)
        self.found = {name: np.full(match.count, np.nan) for name in NUMBERS}
        self.found["tries"][:] = self.found["goals"][:] = 0.0
        self.found["before"] = misalignment(match, robots)
        self.clear, self.was_back = np.zeros(match.count), np.zeros(match.count, bool)
        self.ended = np.zeros(match.count, bool)  # by a goal: what follows is another situation

    def look(self, now: float) -> None:
        """Record the events of a control step at the time `now` [s]."""
        match, at = self.match, (self.rows, self.robots)
        self.watch.look()
        doing = sampled.behaviours(match)[at]
        recovers = (doing >= BACK) & (doing <= ROTATE)
        begins = (doing == BACK) & ~self.was_back & ~self.ended
        self.was_back = doing == BACK
        self.first("began", begins, now)
        self.found["tries"] += begins & np.isnan(self.found["got"])
        self.first("aside", doing == SIDESTEP, now)
        self.first("over", ~recovers & ~np.isnan(self.found["began"]), now)
        fresh = self.found["over"] == now
        self.found["after"][fresh] = misalignment(match, self.robots)[fresh]
        alone = has_ball_alone(match, self.robots)
        self.first("got", alone, now)
        fresh = self.found["got"] == now
        self.found["at ball"][fresh] = misalignment(match, self.robots)[fresh]
        self.first("freed", self.goes_freely(recovers) | alone, now)
        if self.watch.full():
            self.first("again", self.watch.held()[at] & (self.found["over"] + 1.0 <= now), now)
        scored = match.events["goal"]
        ours = np.where(scored == match.robots["team"][at], 1.0, -1.0)
        self.found["goals"] += np.where((scored != NO_TEAM) & ~self.ended, ours, 0.0)
        self.ended |= scored != NO_TEAM

    def first(self, name: str, happens: np.ndarray, now: float) -> None:
        """Record the time of an event's first occurrence."""
        self.found[name][happens & ~self.ended & np.isnan(self.found[name])] = now

    def goes_freely(self, recovers: np.ndarray) -> np.ndarray:
        """Tell which robots have moved as commanded for FREE_TIME, without contact."""
        match, at = self.match, (self.rows, self.robots)
        robot = match.robots[at]
        commanded = np.hypot(robot["walk"]["forward"], robot["walk"]["left"])
        goes = np.hypot(robot["vx"], robot["vy"]) >= AS_COMMANDED * commanded
        free = goes & ~recovers & (match.robot_events["collision"][at] == 0) & (robot["active"] == 1)
        self.clear = np.where(free, self.clear + match.league.dt, 0.0)
        return self.clear >= FREE_TIME


def has_ball_alone(match: Match, robots: np.ndarray) -> np.ndarray:
    """Tell which of the robots, one in each match, have the ball while no opponent has it."""
    at = (np.arange(match.count), robots)
    has = match.robots["has_ball"] == 1
    theirs = (has & (match.robots["team"] != match.robots["team"][at][:, None])).any(axis=1)
    return np.asarray(has[at] & ~theirs)


def misalignment(match: Match, robots: np.ndarray) -> np.ndarray:
    """Return the angles (M,) [deg] between the directions from robots to the ball and from the ball to their goals."""
    robot, ball = match.robots[np.arange(match.count), robots], match.balls
    ahead = match.matches["home_direction"] * np.where(robot["team"] == HOME, 1.0, -1.0)
    to_ball = np.arctan2(ball["y"] - robot["y"], ball["x"] - robot["x"])
    to_goal = np.arctan2(-ball["y"], ahead * match.league.pitch.length / 2 - ball["x"])
    return np.asarray(np.degrees(np.abs(wrap_angle(to_ball - to_goal))))


@shared("moments", most=1024)
def follow_moments(
    batch: Batch, *, begun: bool = False, kind: int = HELD, random_sides: bool = False, **settings: Any
) -> Samples:
    """Return the fates of robots held at sampled moments, (MATCHES, MOST) each; `settings`: settings of their team.

    NaN: no such moment, or no event. `kind`: HELD or TRIPPED; `begun`: robots begin to recover at once, as if they had
    noticed; `random_sides`: they step aside to a random side.
    """
    moments = sampled.sample_moments(batch)
    before = np.tril(moments.match[:, None] == moments.match[None, :], -1)
    place = before.sum(axis=1)  # of each moment within its match
    found = {
        name: np.full((MATCHES, MOST), np.nan) for name in (*NUMBERS, "near", "still", "touching", "theirs", "held")
    }
    for team in (HOME, AWAY):
        of_team = moments.team == team
        rows = np.flatnonzero((moments.kind == kind) & of_team)
        if len(rows) == 0:
            continue
        fate = run_branch(
            sampled.branch(batch, moments, rows, team, settings), moments.robot[rows], batch, begun, random_sides
        )
        at = (moments.match[rows], place[rows])
        for name, values in fate.items():
            found[name][at] = values
        for name in ("near", "still", "touching", "theirs", "held"):
            found[name][at] = getattr(moments, name)[rows]
    return found


def run_branch(match: Match, robots: np.ndarray, batch: Batch, begun: bool, random_sides: bool) -> Samples:
    """Play a branch to its end and return the fates of its robots."""
    if begun:
        for r in np.unique(robots):
            begin_recovery(match, robots == r, int(r))
    side = batch.rng(3).choice([-1.0, 1.0], match.count)
    fate = Fate(match, robots)
    for step in play(match, FUTURE):
        fate.look((step + 1) * match.league.dt)
        if random_sides:
            for r in np.unique(robots):
                memory = memory_of(match, int(r))
                steps = (memory["behaviour"] == SIDESTEP) & (robots == r)
                memory["side"][steps] = side[steps]
    match.close()
    return fate.found


def count_hits(found: Samples, hit: Callable[[Samples], np.ndarray], **flags: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the numbers of moments with flags such as still=1.0, and of hits among them, by match (MATCHES,)."""
    there: np.ndarray = np.isfinite(found["near"])
    for name, value in flags.items():
        there = there & (found[name] == value)
    return there.sum(axis=1).astype(float), (there & hit(found)).sum(axis=1).astype(float)
