"""The PettingZoo API of a match: `parallel_env`, and `env` and `raw_env` for one agent at a time (AEC).

| | |
|---|---|
| agents | `home_0`, ..., `away_0`, ...: every robot that no team plays |
| observation | one float32 vector in [-1, 1] a robot, see `soccer_env.observations.layout`, or a user's own |
| action | Box(4) or Box(7), Discrete (also skills), or MultiDiscrete (`actions="multi"`); see `soccer_env.actions` |
| reward | weighted terms, see `soccer_env.rewards.TERMS` |
| state | the whole truth of the match in [-1, 1], see `soccer_env.match.truth_state` |

`infos[agent]` are numbers under keys that never change, which `soccer_env.api.infos` lists: "active", "score_for",
"phase", "opponent", "reward_goal", "event_goal" ...; infos="full" adds statistics of play. Where actions are
indices, "action_mask" is the mask by which PettingZoo samples, `action_space(agent).sample(mask)`. "nested": dicts in
words: "active", "score" (own goals, the opponents'), "phase", "opponent" (the team's name, or "learner"; flat infos
have its place in `env.opponent_names`), "rewards" (term -> weighted reward), "events" (only events of this step) and,
at the end of an episode, "statistics" and "maps" (`statistics.maps.maps_of`) from the side of the agent's team.
infos="none" is the fastest. Finite actions outside [-1, 1] are clipped.

Version history: v0, the first.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from gymnasium import logger
from gymnasium.spaces import Box
from pettingzoo import AECEnv, ParallelEnv

from soccer_env.api import report
from soccer_env.api.infos import add_action_masks, make_report
from soccer_env.api.opponents import OpponentNames, changed_by
from soccer_env.api.report import Infos
from soccer_env.api.shown import ShowsMatch
from soccer_env.api.turn_env import OrderedSoccer, TurnSoccer
from soccer_env.guards.names import Made
from soccer_env.guards.turns import with_signals_held
from soccer_env.match import Match
from soccer_env.match.arguments import (
    EnvArguments,
    InfoKind,
    MatchArguments,
    MatchSetup,
    reduce_by_settings,
    select_fields,
    takes_fields_of,
)  # fmt: skip
from soccer_env.observations.own import copy_arrays, index_arrays, space_from_form

FLOATS = "fd"  # dtype characters of float32 and float64


class ParallelSoccer(ShowsMatch, ParallelEnv[str, np.ndarray, Any]):
    """A PettingZoo ParallelEnv of one match (M = 1, autoreset "off"); `parallel_env` makes match and env together."""

    metadata: dict[str, Any] = {"name": "soccer_v0", "render_modes": [*report.RENDER_MODES], "is_parallelizable": True}

    def __init__(self, match: Match, render_mode: str | None = None, infos: Any = "flat", overlays: Any = None) -> None:
        if match.count != 1 or match.autoreset != "off":
            raise ValueError(f"needs 1 match and autoreset 'off', got {match.count} and {match.autoreset!r}")
        if not match.learns.any():
            raise ValueError("teams play all robots, so no agent is left: step a Match instead, or watch")
        self.match, self.arguments = match, match.arguments
        self.render_mode = report.check_render_mode(render_mode)
        self.screen = report.MatchScreen(match, overlays)
        self.metadata = {**self.metadata, "render_fps": self.screen.fps}
        rows = np.flatnonzero(match.learns)
        self.possible_agents = [match.agents[row] for row in rows]
        self.agents: list[str] = []
        forms = {match.agents[row]: match.seen.group_of(row).form for row in rows.tolist()}
        self.observation_spaces: dict[str, Any] = {agent: space_from_form(form) for agent, form in forms.items()}
        self.action_spaces = {agent: match.settings.actions.space() for agent in self.possible_agents}
        self.state_space = Box(-1.0, 1.0, match.state().shape[1:], np.float32)
        self.info_kind = report.check_infos_kind(infos)
        self._met = OpponentNames(match, rows)
        self._report = make_report(self.info_kind, match, rows, self._met)
        self._rows = slice(rows[0], rows[-1] + 1) if len(rows) == rows[-1] - rows[0] + 1 else rows
        kind = match.settings.actions
        self._action_shape, self._indices = kind.shape, len(kind.parts) > 0
        self._actions = np.zeros((1, len(match.agents), *kind.shape), np.int64 if self._indices else float)
        self._flat = self._actions[0, self._rows].reshape(-1) if isinstance(self._rows, slice) else None  # a view
        self._begun = False

    def observation_space(self, agent: str) -> Any:
        """Return the agent's observation space, the same object at each call."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Any:
        """Return the agent's action space, the same object at each call."""
        return self.action_spaces[agent]

    @with_signals_held
    def reset(
        self, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, np.ndarray], Infos]:
        """Begin an episode; return observations and infos by agent.

        A seed restarts the random streams of the match; without one the match goes on to its next episode. The option
        "match_seed" is one of a Match's `seeds`: this env then plays that match. The option "opponents" is a team, its
        name or a Lineup that plays against the learners from now on; "home" and "away" are numbers of robots, within
        max_players; "scene" is a scene. `match` is then another object. ValueError, and the running episode goes on,
        for anything else.
        """
        wanted = report.check_options(options, report.OPTIONS)
        if seed is not None and "match_seed" in wanted:
            raise ValueError("reset takes a seed or the option match_seed, got both")
        match = changed_by(self.match, wanted)
        match.reset(seed=seed, seeds=[wanted["match_seed"]] if "match_seed" in wanted else None)
        if match is not self.match:
            self.match.close()
            self.match = match
            self.screen.turn_to(match)
        self._store_opponents()
        self.agents, self._begun = list(self.possible_agents), True
        self._show()
        return self._observations(), self._infos()

    def _store_opponents(self) -> None:
        """Store the opponents of an episode that has begun or was loaded."""
        self._met.turn_to(self.match)
        if self._report is not None:
            self._report.turn_to(self.match)

    @with_signals_held
    def step(
        self, actions: Mapping[str, Any]
    ) -> tuple[dict[str, np.ndarray], dict[str, float], dict[str, bool], dict[str, bool], Infos]:
        """Play one step; return observations, rewards, terminations, truncations and infos by agent.

        All agents end together, and `agents` is then empty. ValueError names the agent whose action is missing,
        unknown, of a wrong shape or not finite, RuntimeError asks for a reset; both change nothing.
        """
        if not self.agents:
            raise RuntimeError(f"step {'after the end of the episode' if self._begun else 'before reset'}: call reset")
        agents, match = self.agents, self.match
        match.step(self._gather_actions(actions))
        terminated, truncated = bool(match.terminated[0]), bool(match.truncated[0])
        rewards = dict(zip(agents, match.rewards[0, self._rows].tolist(), strict=True))
        infos = self._infos()
        if terminated or truncated:
            self.agents = []
        self._show()
        terminations, truncations = dict.fromkeys(agents, terminated), dict.fromkeys(agents, truncated)
        return self._observations(), rewards, terminations, truncations, infos

    def save(self) -> bytes:
        """Return everything that the episode's future depends on; RuntimeError before reset.

        As by `Match.save`, the physics of the running episode is rebuilt, which changes its future.
        """
        if not self._begun:
            raise RuntimeError("save before reset: call reset")
        return self.match.save()

    @with_signals_held
    def load(self, saved: bytes) -> tuple[dict[str, np.ndarray], Infos]:
        """Go on from a save of this or an equal env, even after the end; return observations and infos by agent.

        ValueError, and the running episode goes on, for anything else.
        """
        self.match.load(saved)
        self._store_opponents()
        over = self.match.terminated[0] or self.match.truncated[0]
        self.agents, self._begun = [] if over else list(self.possible_agents), True
        self._show()
        return self._observations(), self._infos()

    def _observations(self) -> dict[str, Any]:
        """Return a new array, or a dict of new arrays, for each agent: callers may write into them."""
        match, agents = self.match, self.possible_agents
        if isinstance(match.observations, np.ndarray):
            return dict(zip(agents, match.observations[0, self._rows].copy(), strict=True))
        rows = np.arange(len(match.agents))[self._rows].tolist()
        by_agent = {
            agent: match.seen.of_robot(match.observations, row) for agent, row in zip(agents, rows, strict=True)
        }
        return {agent: copy_arrays(index_arrays(seen, 0)) for agent, seen in by_agent.items()}

    def _infos(self) -> Infos:
        if self._report is None:
            return {agent: {} for agent in self.possible_agents}
        return add_action_masks(self._report.infos(), self.match)

    def _gather_actions(self, actions: Any) -> np.ndarray:
        """Return the actions in the form of `Match.step`; ValueError names the wrong action."""
        usual = self._fast_actions(actions)
        if usual is not None and self._flat is not None:
            np.concatenate(usual, out=self._flat)
            return self._actions
        if usual is None:
            report.check_agents(actions, self.agents)
            usual = [self.check_action(agent, actions[agent]) for agent in self.agents]
        self._actions[0, self._rows] = np.array(usual)
        return self._actions

    def _fast_actions(self, actions: Any) -> list[np.ndarray] | None:
        """Return the actions in order if all are float arrays of the right shape, else None; a fast path."""
        if self._indices or type(actions) is not dict or len(actions) != len(self.agents):
            return None
        ordered = []
        for agent in self.agents:
            action = actions.get(agent)
            if type(action) is not np.ndarray or action.shape != self._action_shape or action.dtype.char not in FLOATS:
                return None
            ordered.append(action)
        return ordered

    def check_action(self, agent: str, action: Any) -> Any:
        """Return one agent's action as numbers, or as indices; ValueError names the agent and the value."""
        numbers = self.match.settings.actions.given(action, agent)
        if not np.isfinite(numbers).all():
            raise ValueError(f"action of {agent} must be finite, got {numbers.tolist()}")
        return numbers

    def state(self, side: str | None = None) -> np.ndarray:
        """Return the whole truth as one vector in [-1, 1], from the view of a side, see `Match.state`."""
        return np.asarray(self.match.state(side)[0])

    @property
    def state_names(self) -> list[str]:
        """Return the names of the entries of `state()`."""
        return self.match.state_names

    @property
    def opponent_names(self) -> list[str]:
        """Return the names of all opponents so far; "opponent" in flat infos is an index into them, 0 for a learner.

        Then come the teams, those of a Lineup in order; opponents of later resets are appended.
        """
        return self._met.names

    def get_env_info(self) -> dict[str, int | None]:
        """Return the sizes of state, observation, actions and team that PyMARL asks for, see `Match.get_env_info`."""
        return self.match.get_env_info()

    def render(self) -> np.ndarray | None:
        """Return a frame (H, W, 3) uint8, or show it in a window and return None, as `render_mode` says."""
        if self.render_mode is None:
            logger.warn("render was called without a render_mode; it can be 'rgb_array' or 'human'")
            return None
        if not self._begun:
            raise RuntimeError("render before reset: call reset")
        if self.render_mode == "rgb_array":
            return self.screen.frame()
        self.screen.show()
        return None

    def _show(self) -> None:
        if self.render_mode == "human":
            self.screen.show()

    def close(self) -> None:
        """Close the window; safe to repeat."""
        self.screen.close()

    def __reduce__(self) -> Made:
        """Pickle the env by its settings: a copy needs a reset."""
        settings = {**select_fields(self.match.arguments, MatchArguments), "render_mode": self.render_mode}
        return reduce_by_settings(_rebuild_env, {**settings, "infos": self.info_kind, "overlays": self.screen.overlays})

    @property
    def unwrapped(self) -> ParallelSoccer:
        """Return the env itself; `env.unwrapped.match` is the match inside all wrappers."""
        return self


def _rebuild_env(*, render_mode: str | None, infos: InfoKind, overlays: Any, **settings: Any) -> ParallelSoccer:
    """Make the env again from its pickled settings."""
    return ParallelSoccer(Match(**settings), render_mode, infos, overlays)


@takes_fields_of(EnvArguments)
def parallel_env(arguments: EnvArguments) -> ParallelSoccer:
    """Return one match as a PettingZoo ParallelEnv; ValueError names the wrong setting and the allowed values."""
    return ParallelSoccer(
        Match(**select_fields(arguments, MatchSetup)), arguments.render_mode, arguments.infos, arguments.overlays
    )


@takes_fields_of(EnvArguments)
def raw_env(arguments: EnvArguments) -> AECEnv[str, np.ndarray, Any]:
    """Return one match as a PettingZoo AECEnv, with the settings of `parallel_env`."""
    return TurnSoccer(parallel_env(**select_fields(arguments, EnvArguments)))


@takes_fields_of(EnvArguments)
def env(arguments: EnvArguments) -> AECEnv[str, np.ndarray, Any]:
    """Return `raw_env` with PettingZoo's check of the order of calls, with the settings of `parallel_env`."""
    return OrderedSoccer(raw_env(**select_fields(arguments, EnvArguments)))


__all__ = ["ParallelSoccer", "TurnSoccer", "env", "parallel_env", "raw_env"]
