"""MatchBatch: the records of M matches with their pymunk Spaces, and the stages of a step for a slice of matches.

    act -> sense -> tell -> believe -> observe

MatchBatch knows nothing of teams: commands lie in the robots' records before a step, events and rewards in the arrays
after it. The beliefs of a robot are one row of `beliefs` and `tracks`, filled by the robot's provider:

    senses="ideal"      the truth, when the row is read (`read`)
    senses="sensors"    percepts and memory, after every step (`senses.py`), if a team or learner uses them
    unused              rows that are never read stay empty
"""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from soccer_env.guards.interrupts import SignalsHeld
from soccer_env.match.episodes import start_match
from soccer_env.match.senses import UNUSED, Senses
from soccer_env.match.settings import Settings
from soccer_env.match.step import (
    BROKEN,
    PUT_ELSEWHERE,
    PhysicsArrays,
    StepNumbers,
    StepOutcome,
    begin_slice,
    finish_slice,
    step_slice,
)
from soccer_env.match.variation import Variation, vary_league
from soccer_env.observations.belief import observe_belief_slice
from soccer_env.observations.truth import observe_slice
from soccer_env.perception.ideal import believe_truth_slice
from soccer_env.physics.engine.space import build_space
from soccer_env.physics.engine.space_batch import Backend, SpaceBatch
from soccer_env.physics.exchange import write_poses_of_matches
from soccer_env.records.beliefs import BELIEF, TRACK
from soccer_env.records.world import World
from soccer_env.rewards import COUNT, POTENTIALS
from soccer_env.scenes import SceneRandom
from soccer_env.statistics.records import FRESH
from soccer_env.types import QUIET, ROBOT_EVENTS

Advance = Callable[[float, np.ndarray, int, int], None]  # steps the Spaces: dt [s], substeps (M,), first, last


class MatchBatch:
    """The records of M matches of R robots: records (M,) and (M, R), rewards (M, R), observations (M, R, n)."""

    def __init__(self, settings: Settings, matches: int, robots: int, observed: int, backend: Backend | None) -> None:
        self.settings = settings
        self.world = World.empty(matches, robots)
        self.matches, self.balls, self.robots, self.events, self.robot_events = self.world
        self.everyone = np.arange(robots)
        league = settings.league
        self.beliefs = np.zeros((matches, robots), BELIEF)
        self.tracks = np.zeros((matches, robots, league.slots.teammates + league.slots.opponents), TRACK)
        self.ideal = np.repeat([senses == "ideal" for senses in settings.senses], settings.rows)  # (R,) flags
        self.senses: Senses | None = None  # where a team or a learner uses its sensors
        self.physics = SpaceBatch(matches, robots + 1, backend)
        self.constants, self.weights = settings.constants(), settings.rewards.weights()
        self.leagues = [league] * matches  # of the present episodes
        self.factors: dict[str, np.ndarray] = {}  # (M,) by the names of the variation
        if settings.variation is not None:  # after the league's own constants those of each match
            self.constants = self.constants.repeat(1 + matches)
            self.factors = {name: np.ones(matches) for name in settings.variation.plain}
        self._allocate_outcome(observed)

    def _allocate_outcome(self, observed: int) -> None:
        """Allocate the arrays for learners, and bundle all arrays that a step reads and writes."""
        count, robots = self.robots.shape
        terms = COUNT + len(self.settings.rewards.extra)  # a user's own terms come after ours
        self.rewards, self.terms = np.zeros((count, robots)), np.zeros((count, robots, terms))
        self.observations = np.zeros((count, robots, observed), np.float32)
        self.terminated, self.truncated = np.zeros(count, bool), np.zeros(count, bool)
        self.statistics = np.full(count, FRESH)
        self._sees_truth = self.settings.observe == "truth"  # then the step itself observes
        seen = self.observations if self._sees_truth else np.zeros((count, robots, 0), np.float32)
        outcome = StepOutcome(self.rewards, self.terms, seen, self.terminated, self.truncated, self.statistics)
        numbers = StepNumbers(self.constants, self.weights, self.settings.limit, not self.settings.observes_clock)
        self._discounts: bool | None = None  # whether the next control step discounts
        physics = PhysicsArrays(self.physics.bodies, self.physics.velocities, self.physics.solvers)
        self._truth = tuple(self.world)
        self._step = self._truth, tuple(physics), tuple(outcome), tuple(numbers)

    def use_sensors(self, sides: tuple[int, ...]) -> None:
        """Switch the robots of some teams (HOME, AWAY) from true poses to simulated sensors, from now on."""
        self.senses = Senses(self.settings, self.world, self.constants, self.beliefs, self.tracks, sides)

    # Starting

    def discount(self, last: bool) -> None:
        """Set whether shaping rewards discount in the next control step; `last`: the last step of an action."""
        if last != self._discounts:
            self.weights["gamma"] = self.settings.rewards.gamma if last else 1.0
            self._discounts = last  # last of all: an error before this line changes nothing

    def start(self, m: int, seed: int, episode: int) -> None:
        """Begin an episode in match m, with a new physics Space."""
        at = slice(m, m + 1)
        records = self.matches[at], self.balls[at], self.robots[at]
        start_match(self.settings, self.constants, *records, seed, episode)
        if self.senses is not None:
            self.senses.start(m)
        self.build_spaces([m])
        self.events[m], self.statistics[m] = QUIET, FRESH
        self.robot_events[m] = np.zeros((), ROBOT_EVENTS)
        self.terminated[m] = self.truncated[m] = False

    def sense_first_frame(self, m: int) -> None:
        """Compute the first percepts, beliefs and observations of a new episode of match m."""
        record, ball = self.matches[m], self.balls[m].copy()
        shows = self.settings.scene.of_episode(int(record["seed"]), int(record["episode"])).shows
        if shows is not None:
            shows(self.settings.league, self.balls[m], self.robots[m], SceneRandom(record))
        if self.senses is not None:
            self.senses.step(m, m + 1)
        self.balls[m] = ball
        self.observe_anew(m, m + 1)

    def build_spaces(self, rows: Iterable[int]) -> None:
        """Rebuild the physics Spaces of the matches `rows` from their records; existing Spaces are reset and reused."""
        used, variation = [], self.settings.variation
        for m in rows:
            if variation is not None:
                self._vary(m, variation)
            if self.physics.reusable(m) and (variation is None or not variation.in_space):
                used.append(m)
                continue
            with SignalsHeld():
                self.physics.set_space(m, build_space(self.leagues[m], self.balls[m], self.robots[m]))
                self.physics.attach_solver(m, self.leagues[m], self.constants[m + 1 :] if variation else self.constants)
        if used:
            again = np.array(used, np.int64)
            write_poses_of_matches(self.balls, self.robots, self.physics.bodies, again)
            self.physics.put_back(again)

    def _vary(self, m: int, variation: Variation) -> None:
        """Give match m the numbers of its present episode."""
        factors = variation.factors(self.matches[m])
        for name, factor in factors.items():
            self.factors[name][m] = factor
        self.leagues[m] = league = vary_league(self.settings.league, factors)
        self.constants[m + 1] = self.settings.constants(league)[0]
        if self.senses is not None:
            self.senses.vary(m, league)

    # One control step of a slice of matches

    def act(self, first: int, last: int) -> None:
        """Carry out the commands of a slice of matches: drive, physics, referee, restarts, rewards."""
        if self.senses is not None:
            self.senses.asleep[first:last] = self.matches["over"][first:last]
        if self.physics.backend == "c":
            self._check(step_slice(self.physics.links, *self._step, first, last))
        else:
            self.act_in_stages(first, last, self.physics.step_slice)

    def act_in_stages(self, first: int, last: int, advance: Advance) -> None:
        """Carry out the commands as `act` does, but let `advance` run the physics between two compiled halves."""
        count = len(self.matches)
        before, substeps = np.zeros((count, *POTENTIALS)), np.zeros(count, np.int64)
        begin_slice(*self._step, before, substeps, first, last)
        advance(self.settings.league.dt, substeps, first, last)
        results = substeps.copy()
        finish_slice(*self._step, before, results, first, last)
        for m in np.flatnonzero(results == PUT_ELSEWHERE):
            self.physics.write_bodies(int(m))
        self._check(int(np.argmax(results == BROKEN)) if (results == BROKEN).any() else -1)

    def _check(self, broken: int) -> None:
        """Raise RuntimeError if the physics of match `broken` gave numbers that are not finite; -1: no match."""
        if broken >= 0:
            step = self.matches["step"][broken]
            raise RuntimeError(f"the physics of match {broken} broke down at step {step}; please report this")

    def sense(self, first: int, last: int) -> None:
        """Compute the percepts of the robots that use their sensors, for a slice of matches."""
        if self.senses is not None:
            self.senses.sense(first, last)

    def tell(self, first: int, last: int) -> None:
        """Write phase, score and clock into the beliefs of the robots that use their sensors."""
        if self.senses is not None:
            self.senses.tell(first, last)

    def believe(self, first: int, last: int) -> None:
        """Update the beliefs of the robots that use their sensors."""
        if self.senses is not None:
            self.senses.believe(first, last)

    def observe(self, first: int, last: int) -> None:
        """Write the learners' observations, except observations of the truth, which `act` has already written."""
        if not self._sees_truth:
            self.observe_anew(first, last)

    # Reading

    def read(self, rows: np.ndarray, first: int, last: int) -> None:
        """Fill the beliefs of robots with ideal senses among `rows` from the truth; others are filled already."""
        ideal = rows[self.ideal[rows]]
        if len(ideal):
            believe_truth_slice(self._truth, self.beliefs, self.tracks, self.constants, ideal, first, last)

    def read_all(self) -> tuple[np.ndarray, np.ndarray]:
        """Return beliefs (M, R) and tracks (M, R, slots) of all robots; ValueError if no robot has beliefs."""
        if self.senses is None and not self.ideal.any():
            raise ValueError(UNUSED)
        self.read(self.everyone, 0, len(self.matches))
        return self.beliefs, self.tracks

    def observe_anew(self, first: int, last: int) -> None:
        """Write the observations of a slice of matches again, from the current records."""
        if self.observations.shape[2]:
            self.write_observations(self.observations, self.settings.observe, self.everyone, first, last)

    def write_observations(self, out: np.ndarray, observe: Any, rows: np.ndarray, first: int, last: int) -> None:
        """Write observations into out (M, R, n): of the truth for all robots, of other kinds only for `rows`."""
        if observe == "truth":
            observe_slice(self.matches, self.balls, self.robots, out, self.constants, first, last)
            return
        self.read(rows, first, last)
        if observe == "percepts" and self.senses is not None:
            self.senses.observe_percepts(out, rows, first, last)
        elif observe == "belief":
            rows = rows[self.believing[rows]]
            observe_belief_slice(
                self.beliefs, self.tracks, self.matches, self.robots, out, self.constants,
                self.settings.half_length, (self.settings.home, self.settings.away), rows, first, last,
            )  # fmt: skip

    @property
    def believing(self) -> np.ndarray:
        """Return flags (R,): 1 for each robot that has beliefs."""
        return self.ideal if self.senses is None else self.ideal | self.senses.believes


class ActionSums:
    """Sums of the rewards, and the latest events, over the control steps of one action."""

    def __init__(self, batch: MatchBatch) -> None:
        self._rewards = batch.rewards, batch.terms
        self._events = (batch.events, QUIET), (batch.robot_events, np.zeros((), ROBOT_EVENTS))
        self._sums: list[np.ndarray] = []
        self._latest: list[np.ndarray] = []

    def add(self) -> None:
        """Add the rewards and events of the last control step to the sums."""
        if not self._sums:
            self._sums = [values.copy() for values in self._rewards]
            self._latest = [events.copy() for events, _ in self._events]
            return
        for total, values in zip(self._sums, self._rewards, strict=True):
            total += values
        for latest, (events, quiet) in zip(self._latest, self._events, strict=True):
            overwrite_happened_events(latest, events, quiet)

    def replace_last_step(self) -> None:
        """Replace the rewards and events of the last control step by those of the whole action."""
        for total, values in zip(self._sums, self._rewards, strict=True):
            values[:] = total
        for latest, (events, _) in zip(self._latest, self._events, strict=True):
            events[:] = latest


def overwrite_happened_events(kept: np.ndarray, new: np.ndarray, quiet: np.ndarray) -> None:
    """Overwrite each field of `kept` in which `new` reports an event, that is differs from `quiet`."""
    for name in new.dtype.names or ():
        happened = new[name] != quiet[name]
        kept[name][happened] = new[name][happened]
