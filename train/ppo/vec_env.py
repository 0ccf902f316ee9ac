"""A stable-baselines3 VecEnv directly over the batched matches: one row for each learning robot of each match.

    rows = blocks of matches of one team size x matches x home robots; the away robots are played by opponents inside,
           or learn as well and come behind those of home

No dicts, no processes: matches are stepped by compiled loops on one thread or more. All robots of a match begin and
end together. An action is kept for `action_repeat` control steps; a match that ends within them begins anew at once,
and its robots stand until the next decision. The first decision comes so long before the first repeat ends as a command
takes to reach the legs. `agents.learned` plays in this rhythm, and so do later episodes of whole numbers of repeats.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from gymnasium import spaces

try:
    from stable_baselines3.common.vec_env import VecEnv
except ModuleNotFoundError as error:
    raise ImportError(f'SoccerVecEnv needs stable-baselines3: pip install "soccer_env[train]" ({error})') from error

from soccer_env.agents.learned import first_decision_step
from soccer_env.guards.checking import short_repr
from soccer_env.guards.names import Made
from soccer_env.guards.workers import Workers
from soccer_env.match import Match
from soccer_env.match.saving import calls_python, reduce_by_save, signals_wait
from soccer_env.match.truth_state import records_of
from soccer_env.random_numbers import seeds_for
from soccer_env.rewards import Rewards, find_rewards
from soccer_env.train.ppo.critic_state import append_state, room_for
from soccer_env.train.ppo.match_blocks import Result, begin, check_request, playing, split_matches, taken, undo_on_error
from soccer_env.train.ppo.reporting.tally import Tally, make_tallies, size_numbers


class SoccerVecEnv(VecEnv):
    """Matches whose home robots learn, or the robots of both sides, as rows of one environment.

    players: team sizes (home, away); matches are shared so that each size has as many home robots; opponents: a team,
    its name, a `Lineup` whose weights choose anew for each episode, or None: both sides learn (self-play), the rows of
    home first in each match; gamma: discount of one step, which the shaping of `rewards` takes over; state: append the
    state from the robot's own side, `Match.state("home")` or "away", to every observation, for a centralised critic,
    with room for the largest team (True) or for this number of robots a side; stagger: begin the first episodes at
    different times of play. max_cycles counts steps of `action_repeat` control steps. Other settings are those of
    `Match` (observe="truth" and starts="training" unless told otherwise). `results` collects how episodes ended until
    somebody takes them. Every reset plays the episodes of the seed again. part: the blocks of matches that are played
    here, while other processes play the others.

        env = SoccerVecEnv(players=[(2, 2)], matches=64, opponents="chaser", action_repeat=8, minutes=2.0)
        model = A2C("MlpPolicy", env).learn(100_000)
        model.save("mine.zip")  # soccer evaluate --home mine.zip:action_repeat=8,at_once=False --senses ideal
    """

    _given: dict[str, Any]

    def __new__(cls, league: Any = "legged-2001", **settings: Any) -> SoccerVecEnv:
        """Create an environment that stores its settings, so that it can be copied."""
        made = super().__new__(cls)
        made._given = {"league": league, **settings}
        return made

    def __init__(
        self,
        league: Any = "legged-2001",
        *,
        players: Sequence[tuple[int, int]] = ((3, 3),),
        matches: int = 64,
        opponents: Any = "chaser",
        action_repeat: int = 1,
        gamma: float = 0.99,
        rewards: Rewards | str = "default",
        state: bool | int = False,
        stagger: bool = False,
        seed: int = 0,
        threads: int = 1,
        part: slice = slice(None),
        **settings: Any,
    ) -> None:
        self.repeat, self.stagger, self.results, self.render_mode = action_repeat, stagger, list[Result](), None
        check_request(players, opponents is None, action_repeat, threads, settings)
        every = split_matches(players, matches)
        blocks, self._first = every[part], sum(count for _, count in every[: part.start or 0])  # the first match here
        inner = max(1, threads // len(blocks))  # threads of a block; more than one where there are few blocks
        if settings.get("max_cycles") is not None:
            settings["max_cycles"] *= action_repeat
        self.matches = [
            Match(
                league, home=home, away=away, matches=count, opponents=opponents, threads=inner, seed=seed,
                autoreset="same_step", rewards=replace(find_rewards(rewards), gamma=gamma),
                **{"starts": "training", **settings},
            )
            for (home, away), count in blocks
        ]  # fmt: skip
        self._workers = Workers(1 if any(map(calls_python, self.matches)) else min(threads, len(blocks)))
        self.room = room_for(state, max(match.settings.max_players for match in self.matches))
        self.learners = [m.settings.home + m.settings.away * (opponents is None) for m in self.matches]  # first rows
        self.observed = len(self.matches[0].observation_names)  # entries before the state
        self.first_decision = first_decision_step(self.matches[0].league.delay_steps, action_repeat)
        rows = [match.count * learners for match, learners in zip(self.matches, self.learners, strict=True)]
        self.size_of_row = np.repeat(size_numbers([size for size, _ in blocks]), rows)
        self._order = np.argsort([-match.count * len(match.agents) for match in self.matches]).tolist()  # longest first
        self.edges = np.concatenate([[0], np.cumsum(rows)]).tolist()
        self.opponents, self.tallies = [playing(match) for match in self.matches], make_tallies(self)
        kind = self.matches[0].settings.actions
        self._actions = np.zeros((self.edges[-1], *kind.shape), np.int64 if kind.parts else np.float64)
        seen = spaces.Box(-1.0, 1.0, self._observations().shape[1:], np.float32)
        super().__init__(self.edges[-1], seen, kind.space())
        self._seed, self._asked = seed, False  # whether a step was asked for
        self._returns, self._lengths = np.zeros(self.num_envs), np.zeros(self.num_envs, np.int64)

    # The interface of stable-baselines3

    def seed(self, seed: int | None = None) -> Sequence[int | None]:
        """Set the seed for the next reset."""
        self._seed = self._seed if seed is None else seed
        return [self._seed] * self.num_envs

    def reset(self) -> np.ndarray:
        """Begin episodes in all matches; return the observations (rows, n) for the first decision."""
        with undo_on_error(self.matches, self.opponents, "reset"):
            seeds = seeds_for(self._seed, self._first + len(self.playing()))[self._first :]
            for match in self.matches:
                begin(match, seeds[: match.count], self.first_decision, self.stagger * self.repeat)
                seeds = seeds[match.count :]
            self.opponents[:] = [playing(match) for match in self.matches]
            self._returns[:], self._lengths[:] = 0.0, 0
            return self._observations()

    def step_async(self, actions: np.ndarray) -> None:
        """Set the actions for the next step, (rows, 4 or 7) or indices (rows,), (rows, 4); ValueError names a row."""
        self._actions[:] = taken(actions, self._actions, self.matches)
        self._asked = True

    def step_wait(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, list[dict[str, Any]]]:
        """Play `action_repeat` control steps of all matches; return observations, rewards, dones (rows,) and infos.

        If a user's code raises an error, the step is undone in all matches. RuntimeError without `step_async` before.
        """
        if not self._asked:
            raise RuntimeError("step_wait needs the actions of the step: call step_async first, or step")
        rewards, dones = np.zeros(self.num_envs, np.float32), np.zeros(self.num_envs, bool)
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        with undo_on_error(self.matches, self.opponents, "step"):
            waits = all(signals_wait(match, "step") for match in self.matches)  # else one may compile: not in a thread
            workers = self._workers if waits else Workers(1)
            results = workers.map(lambda index: self._play(index, rewards, dones, infos), self._order)
            return self._update_infos(dict(zip(self._order, results, strict=True)), rewards, dones, infos)

    def _update_infos(
        self, results: dict[int, list[Result]], rewards: np.ndarray, dones: np.ndarray, infos: Any
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, list[dict[str, Any]]]:
        """Update returns, lengths and infos after a step of all blocks; return the values of `step_wait`."""
        for index in range(len(self.matches)):
            self.results += results[index]
        self._returns += rewards
        self._lengths += 1
        for row in np.flatnonzero(dones):
            infos[row]["episode"] = {"r": float(self._returns[row]), "l": int(self._lengths[row]), "t": 0.0}
        self._returns[dones], self._lengths[dones] = 0.0, 0
        observations = self._observations()
        self._asked = False
        return observations, rewards, dones, infos

    def _play(self, index: int, rewards: np.ndarray, dones: np.ndarray, infos: list[dict[str, Any]]) -> list[Result]:
        """Play a step of one block of matches, write its rewards and dones, and return results of ended episodes."""
        results: list[Result] = []
        match, learners = self.matches[index], self.learners[index]
        rows = slice(self.edges[index], self.edges[index + 1])
        stand = match.settings.actions.still(match.count, len(match.agents))
        actions = stand.copy()
        actions[:, :learners] = self._actions[rows].reshape(match.count, learners, *self._actions.shape[1:])
        gained, over = rewards[rows].reshape(match.count, learners), np.zeros(match.count, bool)
        for step in range(self.repeat):
            _, paid, terminated, _ = match.step(actions, last=step == self.repeat - 1)
            self.tallies[index].add(match)
            gained += np.where(over[:, None], 0.0, paid[:, :learners])
            if len(match.ended):
                results += self._write_terminal_infos(index, terminated, over, infos)
                over[match.ended], actions[match.ended] = True, stand[match.ended]
        dones[rows] = np.repeat(over, learners)
        return results

    def _write_terminal_infos(
        self, index: int, terminated: np.ndarray, over: np.ndarray, infos: list[dict[str, Any]]
    ) -> list[Result]:
        """Write the last observations of ended matches into the infos of their rows; return the matches' results."""
        results = []
        match, learners = self.matches[index], self.learners[index]
        last = match.final["observations"][:, :learners]
        if self.room:
            last = append_state(last, match, match.final, self.room)
        for i, m in enumerate(match.ended):
            if over[m]:
                continue
            first, opponent = self.edges[index] + int(m) * learners, self.opponents[index][m]
            for r in range(learners):
                infos[first + r]["terminal_observation"] = last[i, r]
                infos[first + r]["TimeLimit.truncated"] = not terminated[m]
                infos[first + r]["opponent"] = opponent
            record, players = match.final["matches"][i], (match.settings.home, match.settings.away)
            minutes = float(record["step"]) * match.league.dt / 60.0
            goals_for, goals_against = map(int, record["score"])
            results.append(Result(players, opponent, goals_for, goals_against, minutes))
        self.opponents[index] = playing(match)
        return results

    def _observations(self) -> np.ndarray:
        """Return the observations (rows, n) of all learners as a new array."""
        parts = []
        for match, learners in zip(self.matches, self.learners, strict=True):
            seen = match.observations[:, :learners]
            if self.room:
                seen = append_state(seen, match, records_of(match), self.room)
            parts.append(seen.reshape(match.count * learners, -1))
        return np.concatenate(parts)

    def take_results(self) -> list[Result]:
        """Return the results of the episodes that ended since the last call of this method."""
        taken, self.results = self.results, []
        return taken

    def take_tallies(self) -> list[Tally]:
        """Return the tally of each block since the last call of this method."""
        taken, self.tallies = self.tallies, make_tallies(self)
        return taken

    def playing(self) -> list[str]:
        """Return the name of the present opponent in each match."""
        return [name for names in self.opponents for name in names]

    def action_masks(self) -> np.ndarray:
        """Return masks (rows, n) of the actions that are allowed, where actions are choices."""
        pairs = zip(self.matches, self.learners, strict=True)
        return np.concatenate([np.concatenate(match.action_masks()[:, :count]) for match, count in pairs])

    # Methods of VecEnv for environments that are separate objects; here they are rows

    def close(self) -> None:
        """End the threads that play the matches."""
        self._workers.shutdown()
        for match in self.matches:
            match.close()

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """Return an attribute of this environment, once for each requested row."""
        return [getattr(self, attr_name)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Raise AttributeError: rows have no attributes of their own."""
        raise AttributeError(f"rows of a SoccerVecEnv have no attribute {attr_name!r} of their own")

    def env_method(self, method_name: str, *method_args: Any, indices: Any = None, **method_kwargs: Any) -> list[Any]:
        """Return the mask of each row for "action_masks", as sb3-contrib asks; AttributeError for other methods."""
        if method_name == "action_masks":
            return list(self.action_masks()[[*self._get_indices(indices)]])
        raise AttributeError(f"rows of a SoccerVecEnv have no method {method_name!r} of their own")

    def env_is_wrapped(self, wrapper_class: Any, indices: Any = None) -> list[bool]:
        """Return False for each requested row, since rows have no wrappers."""
        return [False] * len(list(self._get_indices(indices)))

    def __repr__(self) -> str:
        given = ", ".join(f"{name}={short_repr(value)}" for name, value in self._given.items())
        return f"<SoccerVecEnv of {self.num_envs} robots in {len(self.playing())} matches: {given}>"

    def _repr_png_(self) -> bytes | None:
        """Return a picture of the first match for a notebook, or None if it cannot be drawn."""
        return self.matches[0]._repr_png_()

    # Saving

    def save(self) -> dict[str, Any]:
        """Return the full state of the environment as plain values, and rebuild the matches from it."""
        return {
            "matches": [match.save() for match in self.matches],
            "returns": self._returns.tolist(),
            "lengths": self._lengths.tolist(),
        }

    def rebuild(self) -> None:
        """Rebuild the matches as `save` does."""
        for match in self.matches:
            match.rebuild()

    def load(self, saved: dict[str, Any]) -> np.ndarray:
        """Restore a state from `save`; return the observations. ValueError for a save with other settings."""
        with undo_on_error(self.matches, self.opponents, "load"):
            for match, bits in zip(self.matches, saved["matches"], strict=True):
                match.load(bits)
            self.opponents[:] = [playing(match) for match in self.matches]
            self._returns[:], self._lengths[:] = saved["returns"], saved["lengths"]
            return self._observations()

    def __reduce__(self) -> Made:
        """Pickle or copy by settings and `save`, so that copies play on identically."""
        return reduce_by_save(self, type(self), {**self._given, "seed": self._seed})
