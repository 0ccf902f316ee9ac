"""The Gymnasium API for one learner in one match, `SoloSoccer`; `api/ids.py` has its ids.

Teams play all other robots. Spaces, rewards and infos equal those of the agent in `soccer_v0.parallel_env`.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import gymnasium
import numpy as np
from gymnasium.envs.registration import EnvSpec

from soccer_env.api.shown import ShowsMatch
from soccer_env.guards.checking import check_names
from soccer_env.guards.names import Made
from soccer_env.guards.turns import with_signals_held
from soccer_env.match.arguments import (
    LearnerSetup,
    MatchSetup,
    SoloArguments,
    init_takes_fields_of,
    reduce_by_settings,
    select_fields,
)


def choose_learner(arguments: LearnerSetup) -> tuple[str, dict[str, Any]]:
    """Return the learner (home's last robot unless `agent` names another) and the settings of its match."""
    from soccer_env.match.settings import make_settings

    checked, controllers = make_settings(arguments), arguments.controllers
    sizes = {"home": checked.home, "away": checked.away}
    agents = [f"{side}_{number}" for side, size in sizes.items() for number in range(size)]
    agent = f"home_{checked.home - 1}" if arguments.agent is None else arguments.agent
    check_names("agent", [agent], agents)
    if controllers is not None and not (isinstance(controllers, Mapping) and agent not in controllers):
        raise ValueError(f"controllers must map agents or sides other than {agent} to teams, got {controllers!r}")
    own, other = ("home", "away") if agent.startswith("home") else ("away", "home")
    players = {own: arguments.teammates, other: arguments.opponents, **(controllers or {}), agent: None}
    for other_agent in agents:
        if other_agent != agent and players.get(other_agent, players[other_agent.split("_")[0]]) is None:
            raise ValueError(
                f"{agent} is the one learner, so a team has to play {other_agent}: give opponents, teammates"
            )
    settings = {**select_fields(arguments, MatchSetup), "opponents": None, "teammates": None, "controllers": players}
    return agent, settings


class SoloSoccer(ShowsMatch, gymnasium.Env[np.ndarray, Any]):
    """One learner in one match: a `soccer_v0.parallel_env` in which teams play all other robots.

    `help(SoloSoccer.__init__)` explains the settings, the fields of `SoloArguments`; ValueError names a wrong setting.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array", "human"]}
    _spec: EnvSpec | None = None

    @init_takes_fields_of(SoloArguments)
    def __init__(self, arguments: SoloArguments) -> None:
        from soccer_env.soccer_v0 import parallel_env

        self.arguments = arguments
        self.agent, settings = choose_learner(arguments)
        shown = {"render_mode": arguments.render_mode, "infos": arguments.infos, "overlays": arguments.overlays}
        self._parallel = parallel_env(**settings, **shown)
        self.match, self.render_mode = self._parallel.match, arguments.render_mode
        self.metadata = {**self.metadata, "render_fps": self._parallel.metadata["render_fps"]}
        self.observation_space = self._parallel.observation_space(self.agent)
        self.action_space = self._parallel.action_space(self.agent)

    @property
    def spec(self) -> EnvSpec | None:
        """Return the spec of `gymnasium.make`, with our `max_cycles` as `max_episode_steps` for wrappers."""
        return self._spec

    @spec.setter
    def spec(self, spec: EnvSpec | None) -> None:
        steps = self.match.settings.max_cycles
        self._spec = spec if spec is None or steps is None else replace(spec, max_episode_steps=steps)

    @with_signals_held
    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin an episode, see `ParallelSoccer.reset`; return observation and info."""
        observations, infos = self._parallel.reset(seed, options)
        self.match = self._parallel.match
        super().reset(seed=None if seed is None else int(seed))
        return observations[self.agent], infos[self.agent]

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Play one step, see `ParallelSoccer.step`; return observation, reward, terminated, truncated, info."""
        observations, rewards, terminated, truncated, infos = self._parallel.step({self.agent: action})
        agent = self.agent
        return observations[agent], rewards[agent], terminated[agent], truncated[agent], infos[agent]

    def save(self) -> bytes:
        """Return a save of the episode, see `ParallelSoccer.save`; the physics is rebuilt."""
        return self._parallel.save()

    @with_signals_held
    def load(self, saved: bytes) -> tuple[np.ndarray, dict[str, Any]]:
        """Go on from a save, see `ParallelSoccer.load`; return observation and info."""
        observations, infos = self._parallel.load(saved)
        return observations[self.agent], infos[self.agent]

    @property
    def opponent_names(self) -> list[str]:
        """Return the names of all opponents so far; "opponent" in flat infos is an index into them, 0 for a learner."""
        return self._parallel.opponent_names

    def __reduce__(self) -> Made:
        """Pickle the env by its settings: a copy needs a reset."""
        return reduce_by_settings(SoloSoccer, select_fields(self.arguments, SoloArguments))

    def render(self) -> Any:
        """Return a picture of the match or show it in a window, see `ParallelSoccer.render`."""
        return self._parallel.render()

    def close(self) -> None:
        """Close the window; safe to repeat."""
        self._parallel.close()


__all__ = ["SoloSoccer"]
