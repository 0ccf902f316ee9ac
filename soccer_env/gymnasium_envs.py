"""The Gymnasium faces: `SoloSoccer`, one learner in one match, and `SoccerVectorEnv`, one learner in each of many.

Ids: `soccer_env/Legged2001-1v1-v0` to `-6v6-v0` and `soccer_env/MiddleSize2006-1v1-v0` to `-6v6-v0`, for
`gymnasium.make` and `gymnasium.make_vec`; `home=` and `away=` give any other sizes. Everybody but the learner is played
by a team. Spaces, rewards and infos are those of the agent in `soccer_v0.parallel_env`, transition by transition.

`import soccer_env` imports this file to register the ids, so it leaves the match (and numba) to the constructors.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import gymnasium
import numpy as np
import pettingzoo
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

LEAGUES = {"Legged2001": "legged-2001", "MiddleSize2006": "middle-size-2006"}
SIZES = range(1, 7)  # robots a side of the registered ids
MODES = {AutoresetMode.NEXT_STEP: "next_step", AutoresetMode.SAME_STEP: "same_step"}
OPTIONS = ("match_seeds",)  # of the vector env's reset


def register() -> None:
    """Register the ids with Gymnasium and with PettingZoo, where it has a registry; nothing is imported for it."""
    for name, league in LEAGUES.items():
        for size in SIZES:
            known_as = f"soccer_env/{name}-{size}v{size}-v0"
            if known_as not in gymnasium.registry:
                gymnasium.register(
                    known_as,
                    entry_point="soccer_env.gymnasium_envs:SoloSoccer",
                    vector_entry_point="soccer_env.gymnasium_envs:SoccerVectorEnv",
                    kwargs={"league": league, "home": size, "away": size},
                )
    if hasattr(pettingzoo, "register") and "soccer_env/soccer-v0" not in pettingzoo.parallel_registry:
        pettingzoo.register("parallel", "soccer_env/soccer-v0", "soccer_env.soccer_v0:parallel_env")
        pettingzoo.register("aec", "soccer_env/soccer-v0", "soccer_env.soccer_v0:env")


def choose_learner(
    agent: str | None,
    league: Any,
    home: int | None,
    away: int | None,
    opponents: Any,
    teammates: Any,
    controllers: Mapping[str, Any] | None,
    settings: dict[str, Any],
) -> tuple[str, dict[str, Any]]:
    """Return the learner, home's last robot unless `agent` names it, and who plays everybody else, as `controllers`."""
    from soccer_env.settings import make_settings

    checked = make_settings(league, home=home, away=away, **settings)
    sizes = {"home": checked.home, "away": checked.away}
    agents = [f"{side}_{number}" for side, size in sizes.items() for number in range(size)]
    agent = f"home_{checked.home - 1}" if agent is None else agent
    if agent not in agents:
        raise ValueError(f"unknown agent {agent!r}; known: {', '.join(agents)}")
    if controllers is not None and not (isinstance(controllers, Mapping) and agent not in controllers):
        raise ValueError(f"controllers must map agents or sides other than {agent} to teams, got {controllers!r}")
    own, other = ("home", "away") if agent.startswith("home") else ("away", "home")
    players = {own: teammates, other: opponents, **(controllers or {}), agent: None}
    for other_agent in agents:
        if other_agent != agent and players.get(other_agent, players[other_agent.split("_")[0]]) is None:
            raise ValueError(
                f"{agent} is the one learner, so a team has to play {other_agent}: give opponents, teammates"
            )
    return agent, players


class SoloSoccer(gymnasium.Env[np.ndarray, Any]):
    """One learner in one match; a `soccer_v0.parallel_env` inside whose other robots are played by teams.

    agent: the learner, home's last robot by default. opponents, teammates: teams, and controllers as in
    `soccer_v0.parallel_env`, which takes all further settings. ValueError names what is wrong.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array", "human"]}

    def __init__(
        self,
        *,
        league: Any = "legged-2001",
        home: int | None = None,
        away: int | None = None,
        agent: str | None = None,
        opponents: Any = "chaser",
        teammates: Any = "chaser",
        controllers: Mapping[str, Any] | None = None,
        render_mode: str | None = None,
        **settings: Any,
    ) -> None:
        from soccer_env.soccer_v0 import parallel_env

        self.agent, players = choose_learner(agent, league, home, away, opponents, teammates, controllers, settings)
        self._parallel = parallel_env(
            league=league, home=home, away=away, controllers=players, render_mode=render_mode, **settings
        )
        self.match, self.render_mode = self._parallel.match, render_mode
        self.metadata = {**self.metadata, "render_fps": self._parallel.metadata["render_fps"]}
        self.observation_space = self._parallel.observation_space(self.agent)
        self.action_space = self._parallel.action_space(self.agent)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin an episode, as `ParallelSoccer.reset` says; return observation and info."""
        observations, infos = self._parallel.reset(seed, options)
        super().reset(seed=None if seed is None else int(seed))
        return observations[self.agent], infos[self.agent]

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Play one step, as `ParallelSoccer.step` says; return observation, reward, terminated, truncated, info."""
        observations, rewards, terminated, truncated, infos = self._parallel.step({self.agent: action})
        agent = self.agent
        return observations[agent], rewards[agent], terminated[agent], truncated[agent], infos[agent]

    def render(self) -> Any:
        """Return a frame or show it, as `ParallelSoccer.render` says."""
        return self._parallel.render()

    def close(self) -> None:
        """Close the window; safe to repeat."""
        self._parallel.close()


class SoccerVectorEnv(VectorEnv[np.ndarray, Any, np.ndarray]):
    """One learner in each of `num_envs` matches, straight over the batched core.

    autoreset_mode: "NextStep" or "SameStep" (or Gymnasium's AutoresetMode). threads: that step the matches. The other
    settings are those of `SoloSoccer`. Infos are Gymnasium's: an array for each key, and a mask `_key` of the matches
    that have it; "score" is (num_envs, 2).
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"]}

    def __init__(
        self,
        num_envs: int = 1,
        *,
        league: Any = "legged-2001",
        home: int | None = None,
        away: int | None = None,
        agent: str | None = None,
        opponents: Any = "chaser",
        teammates: Any = "chaser",
        controllers: Mapping[str, Any] | None = None,
        autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP,
        threads: int = 1,
        render_mode: str | None = None,
        **settings: Any,
    ) -> None:
        from soccer_env.match import Match
        from soccer_env.soccer_v0 import Report, Screen, check_render_mode

        mode = check_mode(autoreset_mode)
        self.render_mode = check_render_mode(render_mode, ("rgb_array",))
        self.agent, players = choose_learner(agent, league, home, away, opponents, teammates, controllers, settings)
        self.match = Match(
            league,
            home=home,
            away=away,
            controllers=players,
            matches=num_envs,
            threads=threads,
            autoreset=MODES[mode],
            **settings,
        )
        self.num_envs = self.match.count
        self._row = self.match.agents.index(self.agent)
        self._report = Report(self.match, np.array([self._row]))
        self._screen = Screen(self.match)
        self.metadata = {**self.metadata, "autoreset_mode": mode, "render_fps": self._screen.fps}
        size = len(self.match.observation_names)
        self.single_observation_space = gymnasium.spaces.Box(-1.0, 1.0, (size,), np.float32)
        self.single_action_space = self.match.settings.actions.space()
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self._discrete = self.match.settings.actions.name == "discrete"
        shape = () if self._discrete else (self.match.settings.actions.size,)
        kind = np.int64 if self._discrete else np.float64
        self._actions = np.zeros((self.num_envs, len(self.match.agents), *shape), kind)
        self._begun = False

    def reset(self, *, seed: Any = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin an episode in all matches; return observations (num_envs, n) and infos.

        seed: a number that all matches follow from (match 0 as `SoloSoccer` with it), or one for each, with which it
        is `SoloSoccer` with that seed. The option "match_seeds" takes a Match's `seeds` as they are. ValueError, and
        the running episodes go on, for anything else.
        """
        from soccer_env.soccer_v0 import check_options

        seeds = check_options(options, OPTIONS).get("match_seeds")
        if seed is not None and seeds is not None:
            raise ValueError("reset takes a seed or the option match_seeds, got both")
        if isinstance(seed, (list, tuple, np.ndarray)):
            self.match.reset(seeds=seeds_of_each(seed))
        else:
            self.match.reset(seed=seed, seeds=seeds)
            super().reset(seed=None if seed is None else int(seed))
        self._begun = True
        return self._observations(), self._infos()

    def step(self, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Play one step of all matches; return observations (num_envs, n), rewards, terminated, truncated, infos.

        ValueError names the match whose action is no good, RuntimeError tells that reset is due; nothing has changed.
        """
        if not self._begun:
            raise RuntimeError("step before reset: call reset")
        self._actions[:, self._row] = self._check(actions)
        _, rewards, terminated, truncated = self.match.step(self._actions)
        infos = self._infos()
        if self.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP and (terminated | truncated).any():
            infos = self._add_final(infos)
        return self._observations(), rewards[:, self._row].copy(), terminated.copy(), truncated.copy(), infos

    def _check(self, actions: Any) -> np.ndarray:
        """Return the learners' actions (num_envs, ...); Match looks at their values."""
        try:
            numbers = np.asarray(actions)
        except (TypeError, ValueError) as error:
            raise ValueError(f"actions must be numbers of shape {self.action_space.shape}, got {actions!r}") from error
        if numbers.dtype.kind not in ("iu" if self._discrete else "fiu") or numbers.shape != self.action_space.shape:
            word = "integers" if self._discrete else "numbers"
            got = f"{numbers.dtype} of shape {numbers.shape}"
            raise ValueError(f"actions of {self.agent} must be {word} of shape {self.action_space.shape}, got {got}")
        return numbers

    def _observations(self) -> np.ndarray:
        """Return the learners' observations (num_envs, n), in an array of their own."""
        return self.match.observations[:, self._row].copy()

    def _infos(self) -> dict[str, Any]:
        """Return what `Report.infos` says of each match, in Gymnasium's arrays and masks."""
        from soccer_env.soccer_v0 import PHASES

        match, row = self.match, self._row
        score = match.matches["score"].copy()
        shares = zip(match.term_names, match.terms[:, row].T.copy(), strict=True)
        return self._masked(
            {
                "active": match.robots["active"][:, row] == 1,
                "events": self._events(),
                "rewards": self._masked(dict(shares)),
                "score": score if self.agent.startswith("home") else score[:, ::-1].copy(),
                "phase": np.array(PHASES, object)[match.matches["phase"]],
            }
        )

    def _masked(self, values: dict[str, Any]) -> dict[str, Any]:
        """Return values that all matches have, each followed by its mask."""
        return {name: item for key, value in values.items() for name, item in ((key, value), (f"_{key}", self._all()))}

    def _all(self) -> np.ndarray:
        return np.ones(self.num_envs, bool)

    def _events(self) -> dict[str, Any]:
        """Return the events that happened in some match: a word or True where it happened, and the mask."""
        from soccer_env.soccer_v0 import NO_EVENTS
        from soccer_env.types import QUIET

        match, found = self.match, {}
        for name in QUIET.dtype.names or ():
            codes = match.events[name]
            mask = codes != QUIET[name]
            if name in NO_EVENTS or not mask.any():
                continue
            words = self._report.words.get(name)
            found[name], found[f"_{name}"] = mask.copy() if words is None else spell(words, codes, mask), mask
        for name in match.robot_events.dtype.names or ():
            mask = match.robot_events[name][:, self._row] == 1
            if mask.any():
                found[name], found[f"_{name}"] = mask.copy(), mask
        return found

    def _add_final(self, infos: dict[str, Any]) -> dict[str, Any]:
        """Add the last observation and info of the matches that ended, and take their reward terms to that info."""
        match, final = self.match, self.match.final
        for index, m in enumerate(match.ended):
            records = (final[name][index] for name in ("matches", "robots", "events", "robot_events", "terms"))
            info = self._report.of(*records)[self.agent]
            info["score"] = np.array(info["score"])
            last = final["observations"][index, self._row].copy()
            infos = self._add_info(infos, {"final_obs": last, "final_info": info}, int(m))
        for name in match.term_names:
            infos["rewards"][name][match.ended] = 0.0
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
        """End the threads."""
        self.match.close()


def check_mode(mode: str | AutoresetMode) -> AutoresetMode:
    """Return the autoreset mode; ValueError names those that exist."""
    for known, name in MODES.items():
        if mode in (known, known.value, name):
            return known
    raise ValueError(f"autoreset_mode must be one of {', '.join(known.value for known in MODES)}, got {mode!r}")


def seeds_of_each(seeds: Any) -> list[int]:
    """Return the match seeds of matches that have a seed each; ValueError for one that is no seed."""
    from soccer_env.random_numbers import seeds_for

    found = []
    for seed in seeds:
        if isinstance(seed, bool) or not isinstance(seed, (int, np.integer)) or seed < 0:
            raise ValueError(f"each seed must be a whole number of 0 or more, got {seed!r}")
        found.append(int(seeds_for(int(seed), 1)[0]))
    return found


def spell(words: Sequence[str], codes: np.ndarray, mask: np.ndarray) -> np.ndarray:
    """Return the words of the codes where the mask is set, None elsewhere (num_envs,)."""
    spelled = np.full(len(codes), None, object)
    spelled[mask] = np.array(words, object)[codes[mask]]
    return spelled


__all__ = ["SoccerVectorEnv", "SoloSoccer", "register"]
