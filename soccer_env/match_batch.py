"""MatchBatch: the records of M matches with the Spaces under them, and how a slice of them is stepped.

It knows nothing of who plays: commands lie in the robots' records before a step, and what happened lies in the arrays
after it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from soccer_env.episodes import start_match
from soccer_env.observations.belief import observe_belief_slice
from soccer_env.observations.truth import observe_slice
from soccer_env.physics.space import build_space
from soccer_env.physics.space_batch import Backend, SpaceBatch
from soccer_env.rewards import COUNT, POTENTIALS
from soccer_env.senses import UNUSED, Senses
from soccer_env.settings import Settings
from soccer_env.squads import believe_slice, empty_beliefs
from soccer_env.step import begin_slice, finish_slice, step_slice
from soccer_env.types import BALL, EVENTS, MATCH, QUIET, ROBOT, ROBOT_EVENTS

Advance = Callable[[float, np.ndarray, int, int], None]  # moves the Spaces on: dt [s], substeps (M,), first, last


class MatchBatch:
    """M matches of R robots each: records (M,) and (M, R), rewards (M, R), observations (M, R, n)."""

    def __init__(self, settings: Settings, matches: int, robots: int, observed: int, backend: Backend | None) -> None:
        self.settings = settings
        self.matches, self.balls = np.zeros(matches, MATCH), np.zeros(matches, BALL)
        self.robots = np.zeros((matches, robots), ROBOT)
        self.events, self.robot_events = np.zeros(matches, EVENTS), np.zeros((matches, robots), ROBOT_EVENTS)
        terms = COUNT + len(settings.rewards.extra)  # those of a user's own lie behind ours
        self.rewards, self.terms = np.zeros((matches, robots)), np.zeros((matches, robots, terms))
        self.observations = np.zeros((matches, robots, observed), np.float32)
        sees_truth = settings.observe == "truth"  # then the step itself observes
        self._truth_seen = self.observations if sees_truth else np.zeros((matches, robots, 0), np.float32)
        self.senses: Senses | None = None  # where a team or a learner uses its sensors
        home, ideal = settings.rows[0], [senses == "ideal" for senses in settings.senses]
        self._ideal_rows = np.repeat(ideal, [home, robots - home])
        # filled with the truth when they are read
        self._ideal = empty_beliefs(matches if any(ideal) else 0, robots, settings.league)
        self.terminated, self.truncated = np.zeros(matches, bool), np.zeros(matches, bool)
        self.constants, self.weights = settings.constants(), settings.rewards.weights()
        self.physics = SpaceBatch(matches, robots + 1, backend)

    def discount(self, last: bool) -> None:
        """Let the shaping of the coming control step discount, as the last one of an action does, or not."""
        self.weights["gamma"] = self.settings.rewards.gamma if last else 1.0

    def start(self, m: int, seed: int, episode: int) -> None:
        """Begin an episode in match m, in a Space of its own."""
        at = slice(m, m + 1)
        records = self.matches[at], self.balls[at], self.robots[at]
        start_match(self.settings, self.constants, *records, seed, episode)
        if self.senses is not None:
            self.senses.start(m, self.robots)
        self.build_spaces([m])
        self.events[m] = QUIET
        self.robot_events[m] = np.zeros((), ROBOT_EVENTS)
        self.terminated[m] = self.truncated[m] = False

    def build_spaces(self, rows: Iterable[int]) -> None:
        """Rebuild the Spaces of some matches from their records."""
        for m in rows:
            self.physics.set_space(m, build_space(self.settings.league, self.balls[m], self.robots[m]))

    def step(self, first: int, last: int) -> None:
        """Run one control step of a slice of matches."""
        if self.senses is not None:
            self.senses.asleep[first:last] = self.matches["over"][first:last]
        if self.physics.backend == "c":
            self._step_at_once(first, last)
        else:
            self.step_in_stages(first, last, self.physics.step_slice)
        self.look(first, last)

    def _step_at_once(self, first: int, last: int) -> None:
        """Step a slice in one compiled call, match by match."""
        physics = self.physics
        broken = step_slice(
            self.matches, self.balls, self.robots, self.events, self.robot_events,
            physics.links, physics.bodies, physics.velocities, self.constants, self.weights,
            self.terms, self.rewards, self._truth_seen, self.terminated, self.truncated,
            self.settings.limit, first, last,
        )  # fmt: skip
        self._check(broken)

    def step_in_stages(self, first: int, last: int, advance: Advance) -> None:
        """Step a slice with the physics left to `advance`, between two compiled halves."""
        physics, count = self.physics, len(self.matches)
        before, substeps, moved = np.zeros((count, *POTENTIALS)), np.zeros(count, np.int64), np.zeros(count, bool)
        begin_slice(
            self.matches, self.balls, self.robots, self.events, self.robot_events, physics.velocities,
            self.constants, self.terms, self.rewards, before, substeps, first, last,
        )  # fmt: skip
        advance(self.settings.league.dt, substeps, first, last)
        broken = finish_slice(
            self.matches, self.balls, self.robots, self.events, self.robot_events,
            physics.bodies, physics.velocities, self.constants, self.weights,
            self.terms, self.rewards, self._truth_seen, self.terminated, self.truncated,
            self.settings.limit, before, substeps, moved, first, last,
        )  # fmt: skip
        self._check(broken)
        for m in np.flatnonzero(moved[first:last]) + first:
            physics.write_bodies(int(m))

    def look(self, first: int, last: int) -> None:
        """Let the robots of a slice sense, believe and, unless learners see the truth, observe."""
        if self.senses is not None:
            self.senses.step(self, first, last)
        if not self._truth_seen.shape[2]:
            self.observe(first, last)

    def look_first(self, m: int) -> None:
        """Let the robots of a match that has just begun sense, believe and observe."""
        if self.senses is not None:
            self.senses.step(self, m, m + 1)
        self.observe(m, m + 1)

    def believe_truth(self, rows: np.ndarray, first: int, last: int) -> None:
        """Fill the beliefs of those of some robots that have ideal senses."""
        ideal = rows[self._ideal_rows[rows]]
        if len(ideal):
            believe_slice(self.matches, self.balls, self.robots, *self._ideal, self.constants, ideal, first, last)

    def minds(self, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return beliefs (M, R) and tracks (M, R, slots) that hold for some robots."""
        ideal = self._ideal_rows[rows]
        if self.senses is None or ideal.all():
            return self._ideal
        if not ideal.any():
            return self.senses.beliefs, self.senses.tracks
        beliefs, tracks = self.senses.beliefs.copy(), self.senses.tracks.copy()
        at = rows[ideal]
        beliefs[:, at], tracks[:, at] = self._ideal[0][:, at], self._ideal[1][:, at]
        return beliefs, tracks

    def all_minds(self) -> tuple[np.ndarray, np.ndarray]:
        """Return beliefs (M, R) and tracks (M, R, slots) of all robots; ValueError if nobody uses any."""
        if self.senses is None and "ideal" not in self.settings.senses:
            raise ValueError(UNUSED)
        everyone = np.arange(self.robots.shape[1])
        self.believe_truth(everyone, 0, len(self.matches))
        return self.minds(everyone)

    def observe(self, first: int, last: int) -> None:
        """Write the observations of a slice anew."""
        if self.observations.shape[2]:
            everyone = np.arange(self.robots.shape[1])
            self.write_observations(self.observations, self.settings.observe, everyone, first, last)

    def write_observations(self, out: np.ndarray, observe: str, rows: np.ndarray, first: int, last: int) -> None:
        """Write what some robots of a slice observe into out (M, R, n): of the truth everybody's, else of `rows`."""
        if observe == "truth":
            observe_slice(self.matches, self.balls, self.robots, out, self.constants, first, last)
        elif observe == "percepts" and self.senses is not None:
            self.senses.observe_percepts(self, out, rows, first, last)
        elif observe == "belief":
            self._observe_beliefs(out, rows, first, last)

    def _observe_beliefs(self, out: np.ndarray, rows: np.ndarray, first: int, last: int) -> None:
        """Write what robots believe: from the sensors of those that use them, from the truth for ideal ones."""
        self.believe_truth(rows, first, last)
        sensing = rows[:0] if self.senses is None else rows[self.senses.used[rows]]
        for told, those in ((self._ideal, rows[self._ideal_rows[rows]]), (self.senses, sensing)):
            if len(those):
                beliefs, tracks = (told.beliefs, told.tracks) if isinstance(told, Senses) else self._ideal
                observe_belief_slice(
                    beliefs, tracks, self.robots, out, self.constants, self.settings.half_length, those, first, last
                )

    def _check(self, broken: int) -> None:
        """Raise RuntimeError if the physics of a match gave numbers that are not finite: a bug of ours."""
        if broken >= 0:
            step = self.matches["step"][broken]
            raise RuntimeError(f"the physics of match {broken} broke down at step {step}; please report this")


def keep_latest(kept: np.ndarray, new: np.ndarray, quiet: np.ndarray) -> None:
    """Write into `kept` the events of `new` that happened."""
    for name in new.dtype.names or ():
        happened = new[name] != quiet[name]
        kept[name][happened] = new[name][happened]
