"""The Gymnasium API for one learner in each of many matches, straight over the batched core."""

from typing import Any, Literal

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from soccer_env.api.infos import FlatInfoArrays
from soccer_env.api.nested_arrays import NestedInfoArrays
from soccer_env.api.opponents import OpponentNames, changed_by
from soccer_env.api.report import MatchScreen, check_infos_kind, check_options, check_render_mode
from soccer_env.api.shown import ShowsMatch
from soccer_env.guards.names import Made
from soccer_env.guards.turns import with_signals_held
from soccer_env.gymnasium_envs import choose_learner
from soccer_env.match import Match
from soccer_env.match.arguments import (
    InfoKind,
    VectorArguments,
    init_takes_fields_of,
    reduce_by_settings,
    select_fields,
)
from soccer_env.observations.own import copy_arrays, index_arrays, space_from_form

MODES: dict[AutoresetMode, Literal["next_step", "same_step"]] = {
    AutoresetMode.NEXT_STEP: "next_step",
    AutoresetMode.SAME_STEP: "same_step",
}
OPTIONS = ("match_seeds", "opponents", "home", "away", "scene")  # of reset


class SoccerVectorEnv(ShowsMatch, VectorEnv[np.ndarray, Any, np.ndarray]):
    """One learner in each of `num_envs` matches, straight over the batched core.

    `help(SoccerVectorEnv.__init__)` explains the settings, the fields of `VectorArguments`. Infos have Gymnasium's
    form: an array for each key of `SoloSoccer`'s infos, and a mask `_key` of the matches that have it. In nested infos
    "score" is (num_envs, 2); "statistics" and "maps" belong to ended episodes (SameStep: in "final_info").
    "action_mask" is (num_envs, n): the choices of all indices of an action, one after the other.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"]}

    @init_takes_fields_of(VectorArguments)
    def __init__(self, arguments: VectorArguments) -> None:
        self.arguments = arguments
        mode = check_mode(arguments.autoreset_mode)
        self.render_mode = check_render_mode(arguments.render_mode, ("rgb_array",))
        self.agent, settings = choose_learner(arguments)
        limits = [steps for steps in (arguments.max_cycles, arguments.max_episode_steps) if steps is not None]
        settings["max_cycles"] = min(limits, default=None)
        self.match = Match(**settings, matches=arguments.num_envs, threads=arguments.threads, autoreset=MODES[mode])
        self.num_envs = self.match.count
        self._row = self.match.agents.index(self.agent)
        self._met = OpponentNames(self.match, np.array([self._row]))
        self._report = make_report(check_infos_kind(arguments.infos), self.match, self._row, self._met)
        self._screen = MatchScreen(self.match)
        self.metadata = {**self.metadata, "autoreset_mode": mode, "render_fps": self._screen.fps}
        self.single_observation_space = space_from_form(self.match.seen.group_of(self._row).form)
        self.single_action_space = self.match.settings.actions.space()
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        kind = self.match.settings.actions
        self._indices = len(kind.parts) > 0
        shape = self.num_envs, len(self.match.agents), *kind.shape
        self._actions = np.zeros(shape, np.int64 if self._indices else np.float64)
        self._begun = False

    def __reduce__(self) -> Made:
        """Copy by settings: the copy needs a reset."""
        return reduce_by_settings(SoccerVectorEnv, select_fields(self.arguments, VectorArguments))

    @with_signals_held
    def reset(self, *, seed: Any = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin an episode in all matches; return observations (num_envs, n) and infos.

        seed: one seed for all matches (match 0 equals `SoloSoccer` with this seed), or a seed for each match, which
        then equals `SoloSoccer` with that seed. The option "match_seeds" takes the `seeds` of a Match, "opponents" a
        team or Lineup that plays from now on, "home" and "away" numbers of robots within max_players, "scene" a scene.
        ValueError, and the running episodes go on, for anything else.
        """
        wanted = check_options(options, OPTIONS)
        seeds = wanted.get("match_seeds")
        if seed is not None and seeds is not None:
            raise ValueError("reset takes a seed or the option match_seeds, got both")
        match = changed_by(self.match, wanted)
        if isinstance(seed, (list, tuple, np.ndarray)):
            match.reset(seeds=seeds_of_matches(seed))
        else:
            match.reset(seed=seed, seeds=seeds)
            super().reset(seed=None if seed is None else int(seed))
        if match is not self.match:
            self.match.close()
            self.match = match
            self._screen.turn_to(match)
            self._met.turn_to(match)
            self._report = make_report(check_infos_kind(self.arguments.infos), match, self._row, self._met)
        self._begun = True
        return self._observations(), self._infos()

    @with_signals_held
    def step(self, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Play one step of all matches; return observations (num_envs, n), rewards, terminated, truncated, infos.

        ValueError names the match with a wrong action, RuntimeError asks for a reset; both change nothing.
        """
        if not self._begun:
            raise RuntimeError("step before reset: call reset")
        self._actions[:, self._row] = self._check(actions)
        _, rewards, terminated, truncated = self.match.step(self._actions)
        infos = self._infos()
        ended = terminated | truncated
        if ended.any():
            same_step = self.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP
            if same_step:
                infos = self._add_final(infos)
            elif self._report is not None:
                infos |= self._report.ended(ended)
        return self._observations(), rewards[:, self._row].copy(), terminated.copy(), truncated.copy(), infos

    @property
    def opponent_names(self) -> list[str]:
        """Return the names of all opponents so far, which "opponent" in flat infos indexes; 0 is a learner."""
        return self._met.names

    def save(self, rows: Any = None) -> bytes:
        """Return a save of all matches or of some, as `Match.save` does; their physics is rebuilt."""
        if not self._begun:
            raise RuntimeError("save before reset: call reset")
        return self.match.save(rows)

    @with_signals_held
    def load(self, saved: bytes, rows: Any = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Go on from a save, in all matches or in some, as `Match.load` does; return observations and infos of all.

        ValueError, and no change, for anything else.
        """
        if rows is not None and not self._begun:
            raise RuntimeError("load of some matches before reset: call reset")
        self.match.load(saved, rows)
        self._begun = True
        return self._observations(), self._infos()

    def _check(self, actions: Any) -> np.ndarray:
        """Return the learners' actions (num_envs, ...), checked for type and shape; Match checks their values."""
        try:
            numbers = np.asarray(actions)
        except (TypeError, ValueError) as error:
            raise ValueError(f"actions must be numbers of shape {self.action_space.shape}, got {actions!r}") from error
        if numbers.dtype.kind not in ("iu" if self._indices else "fiu") or numbers.shape != self.action_space.shape:
            word = "integers" if self._indices else "numbers"
            got = f"{numbers.dtype} of shape {numbers.shape}"
            raise ValueError(f"actions of {self.agent} must be {word} of shape {self.action_space.shape}, got {got}")
        return numbers

    def _observations(self) -> Any:
        """Return the learners' observations (num_envs, n) in a new array, or in a dict of new arrays."""
        return copy_arrays(self.match.seen.of_robot(self.match.observations, self._row))

    def _infos(self) -> dict[str, Any]:
        if self._report is None:
            return {}
        infos = self._report.infos()
        if self._indices:
            infos["action_mask"] = self.match.action_masks()[:, self._row]
            infos["_action_mask"] = np.ones(self.num_envs, bool)
        return infos

    def _add_final(self, infos: dict[str, Any]) -> dict[str, Any]:
        """Add the last observation and info of ended matches, and move their reward terms into that info."""
        report, match = self._report, self.match
        for index, m in enumerate(match.ended):
            last = {
                "final_obs": copy_arrays(
                    index_arrays(match.seen.of_robot(match.final["observations"], self._row), index)
                ),
                "final_info": {} if report is None else report.last(index),
            }
            if report is not None and self._indices:
                last["final_info"]["action_mask"] = match.final["action_masks"][index, self._row]
            infos = self._add_info(infos, last, int(m))
        if report is not None:
            report.forget(infos, match.ended)
        return infos

    def render(self) -> tuple[Any, ...] | None:
        """Return a frame (H, W, 3) uint8 of each match."""
        if self.render_mode is None:
            gymnasium.logger.warn("render was called without a render_mode; it can be 'rgb_array'")
            return None
        if not self._begun:
            raise RuntimeError("render before reset: call reset")
        return tuple(self._screen.frame(m) for m in range(self.num_envs))

    def close_extras(self, **ignored: Any) -> None:
        """End the worker threads of the Match."""
        if hasattr(self, "match"):  # Gymnasium 1.2 also closes envs whose __init__ failed
            self.match.close()


def make_report(
    infos: InfoKind, match: Match, row: int, met: OpponentNames
) -> FlatInfoArrays | NestedInfoArrays | None:
    """Return the report that makes the infos of a robot (row) in each match."""
    if infos == "none":
        return None
    return NestedInfoArrays(match, row) if infos == "nested" else FlatInfoArrays(match, row, infos == "full", met)


def check_mode(mode: str | AutoresetMode) -> AutoresetMode:
    """Return the autoreset mode; ValueError names the known modes."""
    for known, name in MODES.items():
        if mode in (known, known.value, name):
            return known
    raise ValueError(f"autoreset_mode must be one of {', '.join(known.value for known in MODES)}, got {mode!r}")


def seeds_of_matches(seeds: Any) -> list[int]:
    """Return for each seed of a list the seed of its match; ValueError for a wrong seed."""
    from soccer_env.random_numbers import seeds_for

    match_seeds = []
    for seed in seeds:
        if isinstance(seed, bool) or not isinstance(seed, (int, np.integer)) or seed < 0:
            raise ValueError(f"each seed must be a whole number of 0 or more, got {seed!r}")
        match_seeds.append(int(seeds_for(int(seed), 1)[0]))
    return match_seeds


__all__ = ["SoccerVectorEnv"]
