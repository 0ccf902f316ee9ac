"""Match: M matches side by side, reset and step, without dicts.

    commands -> drive -> physics -> referee -> restart -> rewards -> sense -> observe

The records are public arrays (see `types`): `match.balls["x"]` is (M,), `match.robots["heading"]` (M, R). One match
is M = 1; match m of many is bit for bit the match that runs alone with its seed.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from soccer_env import saving, truth_state
from soccer_env.actions import take_actions
from soccer_env.episodes import start_match
from soccer_env.observations import layout, observe_slice
from soccer_env.physics.space import build_space
from soccer_env.physics.space_batch import SpaceBatch, Way
from soccer_env.players import assign, believe_slice, empty_beliefs, make_squads, run_kernel, run_python
from soccer_env.random_numbers import seeds_for
from soccer_env.rewards import TERMS
from soccer_env.settings import Settings, make_settings
from soccer_env.step import begin_slice, finish_slice, step_slice
from soccer_env.types import BALL, EVENTS, MATCH, ROBOT, ROBOT_EVENTS

Transition = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]
BLOCK = 64  # matches whose stages run one after the other, so that their Spaces stay in the cache; measured


class Match:
    """M matches of one league, stepped together.

    Keyword settings are those of `soccer_v0.parallel_env`, and: matches, threads, seeds (M,) instead of seed, minutes
    of play, autoreset "off", "next_step" or "same_step", physics way "c" or "batch". ValueError names what is wrong.
    """

    def __init__(
        self,
        league: Any = "legged-2001",
        *,
        matches: int = 1,
        threads: int = 1,
        seed: int | None = None,
        seeds: Any = None,
        home: int | None = None,
        away: int | None = None,
        opponents: Any = None,
        teammates: Any = None,
        controllers: Any = None,
        way: Way | None = None,
        **settings: Any,
    ) -> None:
        if not (isinstance(matches, (int, np.integer)) and matches >= 1):
            raise ValueError(f"matches must be at least 1, got {matches!r}")
        if not (isinstance(threads, (int, np.integer)) and 1 <= threads <= 256):
            raise ValueError(f"threads must be 1 to 256, got {threads!r}")
        self.settings: Settings = make_settings(league, home=home, away=away, **settings)
        self.league, self.count, self.threads = self.settings.league, int(matches), int(threads)
        self.agents = [
            f"{side}_{number}"
            for side, rows in zip(("home", "away"), self.settings.rows, strict=True)
            for number in range(rows)
        ]
        self._make_arrays(way)
        self._make_players(assign(self.agents, opponents, teammates, controllers))
        self._pool = ThreadPoolExecutor(self.threads) if self.threads > 1 else None
        self._started = False
        self.recorder: Any = None
        self.reset(seed=seed, seeds=seeds)

    def _make_arrays(self, way: Way | None) -> None:
        count, robots = self.count, len(self.agents)
        self.matches, self.balls = np.zeros(count, MATCH), np.zeros(count, BALL)
        self.robots = np.zeros((count, robots), ROBOT)
        self.events, self.robot_events = np.zeros(count, EVENTS), np.zeros((count, robots), ROBOT_EVENTS)
        self.rewards, self.terms = np.zeros((count, robots)), np.zeros((count, robots, len(TERMS)))
        self.terminated, self.truncated = np.zeros(count, bool), np.zeros(count, bool)
        self.seeds = np.zeros(count, np.uint64)
        custom = not isinstance(self.settings.observe, str)
        names = list(self.settings.observe.names) if custom else [entry.name for entry in layout(self.league)]
        self.observation_names: list[str] = names
        self.observations = np.zeros((count, robots, len(names)), np.float32)
        self._written = np.zeros((count, robots, 0), np.float32) if custom else self.observations
        self._constants, self._weights = self.settings.constants(), self.settings.rewards.weights()
        self._physics = SpaceBatch(count, robots + 1, way)
        self._beliefs, self._tracks = empty_beliefs(count, robots, self.league)

    def _make_players(self, who: dict[str, Any]) -> None:
        self.squads = make_squads(self.agents, who, self.league, self.count)
        self.learns = np.array([agent not in who for agent in self.agents], np.int64)
        self._readers = np.array([r for squad in self.squads for r in squad.players], np.int64)
        self._everyone = np.arange(len(self.agents))
        self._numbers = np.zeros((self.count, len(self.agents), self.settings.actions.size))

    # Starting

    def reset(self, seed: int | None = None, seeds: Any = None) -> np.ndarray:
        """Begin new episodes in all matches; return observations (M, R, n).

        With a seed (or seeds (M,)) the matches start their streams anew; without, each goes on to its next episode.
        The very first reset without a seed draws one from the system.
        """
        if seeds is not None:
            seeds = np.asarray(seeds)
            if seeds.shape != (self.count,) or seeds.dtype.kind not in "iu" or (seeds < 0).any():
                raise ValueError(f"seeds must be {self.count} whole numbers of 0 or more, got {seeds!r}")
            self.seeds[:] = seeds
        elif seed is not None or not self._started:
            if seed is not None and (isinstance(seed, bool) or not isinstance(seed, (int, np.integer)) or seed < 0):
                raise ValueError(f"seed must be a whole number of 0 or more, got {seed!r}")
            self.seeds[:] = seeds_for(None if seed is None else int(seed), self.count)
        fresh = seed is not None or seeds is not None or not self._started
        self._started = True
        for m in range(self.count):
            self._start(m, 0 if fresh else int(self.matches["episode"][m]) + 1)
        self.rewards[:] = 0.0
        self.terms[:] = 0.0
        if self.recorder is not None:
            self.recorder.note_seating(range(self.count))
        return self._observe(0, self.count)

    def _start(self, m: int, episode: int) -> None:
        """Begin an episode in match m, in a Space of its own."""
        at = slice(m, m + 1)
        start_match(
            self.settings,
            self._constants,
            self.matches[at],
            self.balls[at],
            self.robots[at],
            int(self.seeds[m]),
            episode,
        )
        self._physics.set_space(m, build_space(self.league, self.balls[m], self.robots[m]))
        self.events[m] = np.zeros((), EVENTS)
        self.robot_events[m] = np.zeros((), ROBOT_EVENTS)
        self.terminated[m] = self.truncated[m] = False
        for squad in self.squads:
            squad.memory[m] = np.zeros((), squad.memory.dtype)

    def reseat(self, rows: Any = None) -> None:
        """Rebuild Spaces from the records (of all matches).

        The running match then shares its future with every copy of them.
        """
        rows = range(self.count) if rows is None else rows
        for m in rows:
            self._physics.set_space(m, build_space(self.league, self.balls[m], self.robots[m]))
        if self.recorder is not None:
            self.recorder.note_seating(rows)

    # Stepping

    def step(self, actions: Any = None) -> Transition:
        """Advance all matches by `action_repeat` control steps.

        actions: (M, R, 4 or 7) in [-1, 1] for all robots (rows that teams play are ignored), discrete (M, R)
        integers, or None if teams play them all. Returns observations (M, R, n) float32, rewards (M, R), terminated
        (M,), truncated (M,), the match's own arrays, valid until the next step. ValueError for actions of a wrong
        shape or that are not finite.
        """
        numbers = self.check_actions(actions)
        if self.settings.autoreset == "next_step":
            ended = np.flatnonzero(self.terminated | self.truncated)
            if len(ended):
                return self._step_and_restart(numbers, ended)
        self._advance(numbers)
        if self.settings.autoreset == "same_step":
            ended = np.flatnonzero(self.terminated | self.truncated)
            if len(ended):
                return self._restart_same_step(ended)
        return self.observations, self.rewards, self.terminated, self.truncated

    def check_actions(self, actions: Any) -> np.ndarray:
        """Return the actions as (M, R, 4 or 7) float64; ValueError names the first agent whose action is wrong."""
        if actions is None:
            if self.learns.any():
                agent = self.agents[int(np.argmax(self.learns))]
                raise ValueError(f"actions are missing for {agent}: no team plays it")
            return self._numbers
        if self.settings.actions.name == "discrete":
            return self._expand(actions)
        numbers = np.asarray(actions)
        if numbers.dtype.kind not in "fiu" or numbers.shape != self._numbers.shape:
            raise ValueError(
                f"actions must be numbers of shape {self._numbers.shape}, got {numbers.dtype} {numbers.shape}"
            )
        numbers = numbers.astype(np.float64, copy=False)
        if not np.isfinite(numbers.sum()):
            bad = np.argwhere(~np.isfinite(numbers) & (self.learns[:, None] == 1))
            if len(bad):
                m, r, column = bad[0]
                raise ValueError(f"action of {self.agents[r]} in match {m} is not finite: {numbers[m, r].tolist()}")
            numbers = np.where(np.isfinite(numbers), numbers, 0.0)
        return numbers

    def _expand(self, actions: Any) -> np.ndarray:
        """Return discrete actions (M, R) as numbers (M, R, 4)."""
        from soccer_env.actions import DISCRETE_TABLE, discrete_index

        numbers = np.asarray(actions)
        if numbers.shape != (self.count, len(self.agents)):
            raise ValueError(f"actions must be integers of shape {(self.count, len(self.agents))}, got {numbers.shape}")
        if numbers.dtype.kind not in "iu" or numbers.min() < 0 or numbers.max() >= len(DISCRETE_TABLE):
            for m, r in np.ndindex(numbers.shape):
                discrete_index(numbers[m, r], f"{self.agents[r]} in match {m}")
        expanded: np.ndarray = DISCRETE_TABLE[numbers]
        return expanded

    def _advance(self, numbers: np.ndarray) -> None:
        """Run `action_repeat` control steps; rewards add up, an ended match waits."""
        repeat = self.settings.action_repeat
        if repeat == 1:
            self._control_step(numbers)
            return
        total, terms = np.zeros_like(self.rewards), np.zeros_like(self.terms)
        ended = np.zeros((2, self.count), bool)
        for _ in range(repeat):
            self._control_step(numbers)
            open_ = ~ended.any(axis=0)
            total[open_] += self.rewards[open_]
            terms[open_] += self.terms[open_]
            ended |= np.stack([self.terminated, self.truncated])
        self.rewards[:], self.terms[:] = total, terms
        self.terminated[:], self.truncated[:] = ended

    def _control_step(self, numbers: np.ndarray) -> None:
        """Run one control step of all matches, in blocks, on one thread or several."""
        python = [squad for squad in self.squads if not squad.compiled]
        if python:
            self._believe(np.concatenate([squad.players for squad in python]), 0, self.count)
            for squad in python:
                run_python(squad, self.league, self._beliefs, self._tracks, self.robots)
        if self.recorder is not None:
            self._decide(numbers, 0, self.count)
            self.recorder.note_commands(self.robots["command"])
        if self._pool is None or self.count < 2 * self.threads:
            self._run(numbers, 0, self.count)
        else:
            edges = np.linspace(0, self.count, self.threads + 1).astype(int)
            jobs = [
                self._pool.submit(self._run, numbers, first, last)
                for first, last in zip(edges[:-1], edges[1:], strict=True)
            ]
            for job in jobs:
                job.result()
        self._finish_extras()
        if self.recorder is not None:
            self.recorder.note_state(self)

    def _run(self, numbers: np.ndarray, first: int, last: int) -> None:
        """Step a slice of matches, block by block."""
        for start in range(first, last, BLOCK):
            stop = min(start + BLOCK, last)
            if self.recorder is None:
                self._decide(numbers, start, stop)
            if self._physics.way == "c":
                self._step_compiled(start, stop)
            else:
                self._step_batch(start, stop)

    def _decide(self, numbers: np.ndarray, first: int, last: int) -> None:
        """Fill the commands of a slice: learners' actions, and compiled teams."""
        take_actions(self.robots, numbers, first, last, self.learns)
        if len(self._readers):
            self._believe(self._readers, first, last)
            for squad in self.squads:
                if squad.compiled:
                    run_kernel(squad, self._beliefs, self._tracks, self.robots, self._constants, first, last)

    def _believe(self, rows: np.ndarray, first: int, last: int) -> None:
        believe_slice(
            self.matches, self.balls, self.robots, self._beliefs, self._tracks, self._constants, rows, first, last
        )

    def _step_compiled(self, first: int, last: int) -> None:
        physics = self._physics
        self._check(
            step_slice(
                self.matches,
                self.balls,
                self.robots,
                self.events,
                self.robot_events,
                physics.links,
                physics.bodies,
                physics.velocities,
                self._constants,
                self._weights,
                self.terms,
                self.rewards,
                self._written,
                self.terminated,
                self.truncated,
                self.settings.limit,
                first,
                last,
            )
        )

    def _step_batch(self, first: int, last: int) -> None:
        """Step through the public `pymunk.batch`, between two compiled halves."""
        physics, count = self._physics, self.count
        before, substeps, moved = np.zeros((count, 2, 2)), np.zeros(count, np.int64), np.zeros(count, bool)
        begin_slice(
            self.matches,
            self.balls,
            self.robots,
            self.events,
            self.robot_events,
            physics.velocities,
            self._constants,
            self.terms,
            self.rewards,
            before,
            substeps,
            first,
            last,
        )
        physics.step_slice(self.league.dt, substeps, first, last)
        self._check(
            finish_slice(
                self.matches,
                self.balls,
                self.robots,
                self.events,
                self.robot_events,
                physics.bodies,
                physics.velocities,
                self._constants,
                self._weights,
                self.terms,
                self.rewards,
                self._written,
                self.terminated,
                self.truncated,
                self.settings.limit,
                before,
                substeps,
                moved,
                first,
                last,
            )
        )
        for m in np.flatnonzero(moved[first:last]) + first:
            physics.write_bodies(int(m))

    def _check(self, broken: int) -> None:
        if broken >= 0:
            raise RuntimeError(
                f"the physics of match {broken} broke down at step {self.matches['step'][broken]}: a bug of soccer_env"
            )

    def _finish_extras(self) -> None:
        """Add what Python computes: reward terms and observations of one's own."""
        for term in self.settings.rewards.extra.values():
            self.rewards += np.broadcast_to(np.asarray(term(self), np.float64), self.rewards.shape)
        if not isinstance(self.settings.observe, str):
            self._observe(0, self.count)

    # Starting again

    def _step_and_restart(self, numbers: np.ndarray, ended: np.ndarray) -> Transition:
        """Step all matches, then begin new episodes in those that had ended, which get no reward for this step."""
        self._advance(numbers)
        self._begin_again(ended)
        self.rewards[ended] = 0.0
        self.terms[ended] = 0.0
        return self.observations, self.rewards, self.terminated, self.truncated

    def _restart_same_step(self, ended: np.ndarray) -> Transition:
        """Begin new episodes at once; `final_observations` keeps the last ones of those that ended (rows `ended`)."""
        self.ended, self.final_observations = ended, self.observations[ended].copy()
        self.final_events = self.events[ended].copy()
        terminated, truncated = self.terminated.copy(), self.truncated.copy()
        self._begin_again(ended)
        return self.observations, self.rewards, terminated, truncated

    def _begin_again(self, ended: np.ndarray) -> None:
        for m in ended:
            self._start(int(m), int(self.matches["episode"][m]) + 1)
            self._observe(int(m), int(m) + 1)
        if self.recorder is not None:
            self.recorder.note_seating(ended)

    # Looking

    def _observe(self, first: int, last: int) -> np.ndarray:
        """Write the observations of a slice anew and return all."""
        if isinstance(self.settings.observe, str):
            observe_slice(self.matches, self.balls, self.robots, self.observations, self._constants, first, last)
        else:
            self.observations[:] = self.settings.observe(self)
        return self.observations

    @property
    def beliefs(self) -> np.ndarray:
        """Return what every robot believes (M, R)."""
        self._believe(self._everyone, 0, self.count)
        return self._beliefs

    @property
    def tracks(self) -> np.ndarray:
        """Return what every robot believes about other players (M, R, slots)."""
        self._believe(self._everyone, 0, self.count)
        return self._tracks

    def state(self) -> np.ndarray:
        """Return the whole truth (M, n) float32 in [-1, 1], with room for max_players a side and present flags."""
        return truth_state.write(self)

    # Saving

    def save(self) -> bytes:
        """Return everything that the future depends on, and reseat the running matches on it."""
        saved = saving.dump(self)
        self.reseat()
        return saved

    def load(self, saved: bytes) -> None:
        """Go on from what `save` returned; ValueError (and no change) if it is damaged or from other settings."""
        saving.restore(self, saved)
        self.reseat()
        self._observe(0, self.count)

    def state_hash(self, m: int | None = None) -> str:
        """Return a hash of the state of all matches, or of match m."""
        return saving.state_hash(self, m)

    def close(self) -> None:
        """End the threads."""
        if self._pool is not None:
            self._pool.shutdown()
            self._pool = None
