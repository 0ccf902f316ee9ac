"""The matches of a run: in this process, or shared among the workers of a cluster.

Each worker plays a `SoccerVecEnv` of some of the blocks. Rows, seeds, saves and results are those of one environment of
all blocks, bit for bit.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.train.cluster import Tasks, Workers
from soccer_env.train.ppo.curriculum import Curriculum
from soccer_env.train.ppo.match_blocks import Result, split_matches
from soccer_env.train.ppo.reporting.tally import Tally, size_numbers
from soccer_env.train.ppo.vec_env import SoccerVecEnv


def open_matches(workers: Workers, curriculum: Curriculum, given: dict[str, Any]) -> Matches:
    """Return the training environment with these settings of a `SoccerVecEnv`, which the workers play."""
    if isinstance(workers, int):
        return SoccerVecEnv(**given, threads=workers)
    return SharedMatches(workers, curriculum, given)


class SharedMatches:
    """The blocks of a `SoccerVecEnv`, shared among workers of a cluster; the methods are those that training calls."""

    def __init__(self, tasks: Tasks, curriculum: Curriculum, given: dict[str, Any]) -> None:
        blocks = split_matches(given["players"], given["matches"])
        rows = [count * sizes[0] for sizes, count in blocks]
        self.num_envs = sum(rows)
        self.size_of_row = np.repeat(size_numbers([sizes for sizes, _ in blocks]), rows)
        self._curriculum, self._parts = curriculum, share_blocks(rows, tasks.cores)
        self._rows = [slice(sum(rows[: part.start]), sum(rows[: part.stop])) for part in self._parts]
        calls = [(curriculum, given, part) for part in self._parts]
        self._held = tasks.hold(Part, calls, prepare=(compile_matches, (curriculum, given)))
        self.observation_space = self._ask("observation_space")[0]
        self._results: list[Result] = []

    def reset(self) -> np.ndarray:
        """Begin episodes in all matches; return the observations (rows, n) for the first decision."""
        return np.concatenate(self._ask("reset", self._curriculum.state()))

    def step_async(self, actions: np.ndarray) -> None:
        """Begin a step of all matches with the actions (rows, ...)."""
        for held, rows in zip(self._held, self._rows, strict=True):
            held.begin("step", actions[rows])

    def step_wait(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, list[dict[str, Any]]]:
        """Return observations, rewards, dones (rows,) and infos of the step."""
        seen, rewards, dones, infos, results = zip(*(held.result() for held in self._held), strict=True)
        self._results += sum(results, [])
        return np.concatenate(seen), np.concatenate(rewards), np.concatenate(dones), sum(infos, [])

    def action_masks(self) -> np.ndarray:
        """Return masks (rows, n) of the actions that are allowed, where actions are choices."""
        return np.concatenate(self._ask("action_masks"))

    def take_results(self) -> list[Result]:
        """Return the results of the episodes that ended since the last call of this method."""
        taken, self._results = self._results, []
        return taken

    def take_tallies(self) -> list[Tally]:
        """Return the tally of each block since the last call of this method."""
        return sum(self._ask("take_tallies"), [])

    def playing(self) -> list[str]:
        """Return the name of the present opponent in each match."""
        return sum(self._ask("playing"), [])

    def save(self) -> dict[str, Any]:
        """Return the full state of the environment as plain values; workers that die begin again from it."""
        state = self._curriculum.state()
        saved = self._ask("save", state)
        for held, part in zip(self._held, saved, strict=True):
            held.begin_from("load", state, part)
        return {name: sum((part[name] for part in saved), []) for name in saved[0]}

    def rebuild(self) -> None:
        """Rebuild the matches as `save` does."""
        self._ask("rebuild", self._curriculum.state())

    def load(self, saved: dict[str, Any]) -> np.ndarray:
        """Restore a state from `save`; return the observations. ValueError for a save with other settings."""
        of_part = zip(self._held, self._parts, self._rows, strict=True)
        for held, part, rows in of_part:
            own = {name: saved[name][rows] for name in ("returns", "lengths")}
            held.begin("load", self._curriculum.state(), {"matches": saved["matches"][part], **own})
        return np.concatenate([held.result() for held in self._held])

    def close(self) -> None:
        """End the workers."""
        for held in self._held:
            held.close()

    def _ask(self, method: str, *arguments: Any) -> list[Any]:
        """Call a method of all parts at once; return their answers."""
        for held in self._held:
            held.begin(method, *arguments)
        return [held.result() for held in self._held]


Matches = SoccerVecEnv | SharedMatches


class Part:
    """Some of the blocks, on a worker, with a copy of the run's opponents that follows the curriculum of the run."""

    def __init__(self, curriculum: Curriculum, given: dict[str, Any], part: slice) -> None:
        self._curriculum = curriculum
        self.matches = SoccerVecEnv(**given, part=part)
        self.take_tallies, self.playing = self.matches.take_tallies, self.matches.playing
        self.action_masks = self.matches.action_masks

    def observation_space(self) -> Any:
        """Return the space of the observations of a row."""
        return self.matches.observation_space

    def reset(self, curriculum: dict[str, Any]) -> np.ndarray:
        """Take over the curriculum; begin episodes."""
        self._curriculum.restore(curriculum)
        return self.matches.reset()

    def step(self, actions: np.ndarray) -> tuple[Any, ...]:
        """Play a step; return what it returned, and the results of ended episodes."""
        return *self.matches.step(actions), self.matches.take_results()

    def save(self, curriculum: dict[str, Any]) -> dict[str, Any]:
        """Take over the curriculum; save the matches."""
        self._curriculum.restore(curriculum)
        return self.matches.save()

    def rebuild(self, curriculum: dict[str, Any]) -> None:
        """Take over the curriculum; rebuild the matches."""
        self._curriculum.restore(curriculum)
        self.matches.rebuild()

    def load(self, curriculum: dict[str, Any], saved: dict[str, Any]) -> np.ndarray:
        """Take over the curriculum; load the matches."""
        self._curriculum.restore(curriculum)
        return self.matches.load(saved)


def compile_matches(curriculum: Curriculum, given: dict[str, Any]) -> None:
    """Play one step at each team size, which compiles all that the matches need."""
    for sizes in given["players"]:
        matches = SoccerVecEnv(**{**given, "players": [sizes], "matches": 1})
        still = matches.matches[0].settings.actions.still(1, sizes[0])
        matches.reset()
        matches.step(still[0])
        matches.close()


def share_blocks(rows: Sequence[int], workers: int) -> list[slice]:
    """Share blocks of so many rows among workers, as neighbours and about equally; return the blocks of each."""
    middles = (np.cumsum(rows) - 0.5 * np.array(rows)) / sum(rows)
    worker = (middles * workers).astype(int)
    edges = [0, *(np.flatnonzero(np.diff(worker)) + 1).tolist(), len(rows)]
    return [slice(*pair) for pair in zip(edges[:-1], edges[1:], strict=True)]
