"""One agent acts after the other (PettingZoo's AEC), over `soccer_v0.ParallelSoccer`; saves between turns."""

from __future__ import annotations

import hashlib
import json
import math
from typing import TYPE_CHECKING, Any

import numpy as np
from pettingzoo.utils.agent_selector import AgentSelector
from pettingzoo.utils.conversions import parallel_to_aec_wrapper
from pettingzoo.utils.wrappers import OrderEnforcingWrapper

from soccer_env.guards.names import Made
from soccer_env.guards.turns import with_signals_held

if TYPE_CHECKING:
    from soccer_env.soccer_v0 import ParallelSoccer

MAGIC = b"soccer_env turns 1\n"
SHARED = ("terminations", "truncations", "rewards", "_cumulative_rewards")  # by agent, of the last step


class TurnSoccer(parallel_to_aec_wrapper[str, np.ndarray, Any]):
    """Agents act one after the other, then the match is stepped. A wrong action is refused at once."""

    env: ParallelSoccer
    agents: list[str]

    def __repr__(self) -> str:
        return repr(self.env).replace("ParallelSoccer", "TurnSoccer", 1)

    def _repr_png_(self) -> bytes | None:
        return self.env._repr_png_()

    def __reduce__(self) -> Made:
        """Copy by settings: the copy needs a reset."""
        return TurnSoccer, (self.env,)

    @property
    def opponent_names(self) -> list[str]:
        """Return the names of all opponents so far, which "opponent" in infos indexes."""
        return self.env.opponent_names

    @with_signals_held
    def reset(self, seed: int | None = None, options: Any = None) -> None:
        """Begin an episode, as `ParallelSoccer.reset` says."""
        super().reset(seed, options)  # type: ignore[no-untyped-call]

    @with_signals_held
    def step(self, action: Any) -> None:
        """Take the action of `agent_selection`; ValueError, and no change, if the action is wrong."""
        agent = self.agent_selection
        if not (self.terminations[agent] or self.truncations[agent]):
            self.env.check_action(agent, action)
        elif action is not None:
            raise ValueError(f"the episode of {agent} has ended: its action must be None, got {action!r}")
        super().step(action)

    def save(self) -> bytes:
        """Return a save of the episode and of the actions in this turn; the physics is rebuilt, as by `Match.save`."""
        match = self.env.save()
        acted = {agent: None if action is None else np.asarray(action).tolist() for agent, action in self._done()}
        skipped = getattr(self, "_skip_agent_selection", None)
        turn = {"agents": self.agents, "selected": self.agent_selection if self.agents else "", "skipped": skipped}
        turn |= {"acted": acted} | {name: getattr(self, name) for name in SHARED}
        header = json.dumps(turn).encode()
        body = MAGIC + len(header).to_bytes(4, "little") + header + match
        return body + hashlib.sha256(body).digest()

    def _done(self) -> list[tuple[str, Any]]:
        """Return agent and action of the agents that have acted in this turn."""
        ended = self.agents and self.terminations[self.agent_selection] | self.truncations[self.agent_selection]
        if ended or not self.agents:
            return []
        before = self.agents[: self.agents.index(self.agent_selection)]
        return [(agent, self._actions[agent]) for agent in before]

    @with_signals_held
    def load(self, saved: bytes) -> None:
        """Go on from a save of this or an equal env, before a reset too; ValueError, and no change, for other saves."""
        turn, match = self._opened(saved)
        self._observations, self.infos = self.env.load(match)
        self.possible_agents, self.agents = self.env.possible_agents, turn["agents"]
        self._live_agents = list(self.env.agents)
        self._actions = {agent: turn["acted"].get(agent) for agent in self.agents}
        self._agent_selector = AgentSelector(list(self.possible_agents))
        for _ in range(self.possible_agents.index(turn["selected"]) + 1 if self.agents else 0):
            self.agent_selection = self._agent_selector.next()
        self._skip_agent_selection = turn["skipped"]
        for name in SHARED:
            setattr(self, name, turn[name])
        self.new_agents, self.new_values = [], {}

    def _opened(self, saved: Any) -> tuple[dict[str, Any], bytes]:
        """Return the turn and the match of a save; ValueError unless they fit this env."""
        if not isinstance(saved, bytes):
            raise ValueError(f"a save is bytes, got {type(saved).__name__}")
        body, digest, start = saved[:-32], saved[-32:], len(MAGIC) + 4
        if not saved.startswith(MAGIC) or hashlib.sha256(body).digest() != digest:
            raise ValueError("this is not a save of an env of turns (AEC) of soccer_env, or it is damaged")
        end = start + int.from_bytes(body[len(MAGIC) : start], "little")
        try:
            turn = json.loads(body[start:end])
            self._check(turn)
        except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
            raise ValueError(
                f"this save does not fit the env, whose agents are {', '.join(self.possible_agents)}: {error}"
            ) from error
        return turn, body[end:]

    def _check(self, turn: Any) -> None:
        """Raise ValueError, TypeError or the like unless the turn of a save fits this env."""
        known, agents = self.env.possible_agents, turn["agents"]
        selected, here = turn["selected"], set(agents)
        if not here <= set(known) or len(here) != len(agents) or (agents and selected not in here):
            raise ValueError("its agents differ")
        for name in SHARED:
            for agent, value in turn[name].items():
                kinds = (bool,) if name.endswith("ations") else (int, float)
                if agent not in known or type(value) not in kinds or not math.isfinite(value):
                    raise ValueError(f"its {name} differ")
            if not here <= turn[name].keys():
                raise ValueError(f"its {name} lack agents")
        over = any(turn[name][agent] for agent in agents for name in SHARED[:2])
        before = [] if over or not agents else known[: known.index(selected)]
        if agents != known and not over and agents:  # agents leave only at the end
            raise ValueError("its agents differ")
        if list(turn["acted"]) != before or turn["skipped"] not in (None, *known):
            raise ValueError("other agents have acted")
        for agent, action in turn["acted"].items():
            self.env.check_action(agent, action)


class OrderedSoccer(OrderEnforcingWrapper[str, np.ndarray, Any]):
    """A `TurnSoccer` with PettingZoo's check of the order of calls."""

    env: TurnSoccer

    def __repr__(self) -> str:
        return repr(self.env).replace("TurnSoccer", "OrderedSoccer", 1)

    def __str__(self) -> str:
        return str(self.env)

    def _repr_png_(self) -> bytes | None:
        return self.env._repr_png_()

    def __reduce__(self) -> Made:
        """Copy by settings: the copy needs a reset."""
        return OrderedSoccer, (self.env,)

    @with_signals_held
    def reset(self, seed: int | None = None, options: Any = None) -> None:
        """Begin an episode, as `ParallelSoccer.reset` says."""
        super().reset(seed, options)

    @with_signals_held
    def load(self, saved: bytes) -> None:
        """Go on from a save, see `TurnSoccer.load`; needs no reset before."""
        self.env.load(saved)
        self._has_reset = True
