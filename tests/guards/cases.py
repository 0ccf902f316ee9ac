"""What is interrupted: each `Case` makes a match or an env, what is done with it in turn, and all that it shows."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from soccer_env import Match, Rewards, soccer_v0
from soccer_env.api.gymnasium_vector import SoccerVectorEnv
from soccer_env.gymnasium_envs import SoloSoccer
from soccer_env.match.saving.saves import saved_arrays
from soccer_env.replay import Recorder

Do = Callable[[int], Any]  # from the number of the trial


class Case(NamedTuple):
    """Something that is interrupted: what it is, the matches inside, and what is done with it in turn."""

    subject: Any
    matches: Callable[[], list[Match]]
    does: list[Do]


def seen(value: Any) -> Any:
    """Return anything that a match or an env shows, as plain values that can be compared."""
    if isinstance(value, np.ndarray):
        if value.dtype == object:
            return seen(value.tolist())
        return value.shape, str(value.dtype.itemsize), hash(value.tobytes())
    if isinstance(value, np.generic):
        return value.tobytes()
    if isinstance(value, Mapping):
        return [(str(key), seen(value[key])) for key in value]
    if isinstance(value, (list, tuple)):
        return [seen(part) for part in value]
    return repr(value) if isinstance(value, (str, int, float, bool, type(None))) else type(value).__name__


def of_match(match: Match) -> list[Any]:
    """Return all that a match shows, its recording included."""
    final = {name: match.final[name] for name in ("observations", "matches", "robots", "terms") if name in match.final}
    shown = [match.rewards, match.terms, match.observations, match.ended, final, match.started]
    written = match.recorder
    if written is not None:
        shown += [written.commands, written.gazes, written.hashes, [(n, rows) for n, rows, _ in written.log]]
        shown += [written.thoughts.steps, written.thoughts.rows] if written.thoughts else []
    return seen([dict(saved_arrays(match, True)), *shown])


ENV = (  # attributes of envs that change in a step
    "agents", "_begun", "agent_selection", "rewards", "_cumulative_rewards", "terminations", "truncations",
    "_returns", "_lengths", "opponents", "results",
)  # fmt: skip


def look(case: Case) -> str:
    """Return a hash of all that is to be seen of a case."""
    shown = [of_match(match) for match in case.matches()]
    env = {name: getattr(case.subject, name) for name in ENV if hasattr(case.subject, name)}
    if not isinstance(case.subject, Match):
        shown.append(seen(env))
    return hashlib.sha256(repr(shown).encode()).hexdigest()


def of_one(match: Match, *does: Do) -> Case:
    return Case(match, lambda: [match], list(does))


def acted(match: Match) -> Do:
    """Return what steps a match with actions that the trial decides."""
    shape = *match.rewards.shape, 4

    def step(n: int) -> Any:
        actions = np.random.default_rng(n).uniform(-1.0, 1.0, shape) if match.learns.any() else None
        return match.step(actions)

    return step


def stepped(league: str = "legged-2001", **settings: Any) -> Callable[[], Case]:
    def make() -> Case:
        match = Match(league, **{"home": 1, "away": 1, "seed": 1, "senses": "ideal", **settings})
        return of_one(match, acted(match))

    return make


def reset(league: str, **settings: Any) -> Callable[[], Case]:
    """Return what makes a case of resets: to the next episode, and to another seed."""

    def make() -> Case:
        match = Match(league, **{"home": 1, "away": 1, "seed": 1, "senses": "ideal", **settings})
        return of_one(match, lambda n: match.reset(), lambda n: match.reset(seed=n), acted(match))

    return make


def recorded() -> Case:
    match = Match("legged-2001", home=1, away=1, seed=1, senses="ideal")
    Recorder(match)
    return of_one(match, *[acted(match)] * 3, lambda n: match.reset(), lambda n: match.save())


def saved() -> Case:
    match = Match("legged-2001", home=1, away=1, matches=3, seed=1, senses="ideal")
    bits = match.save()
    step = acted(match)
    return of_one(
        match, step, lambda n: match.save(), step, lambda n: match.load(bits), step, lambda n: match.rebuild(),
        step, lambda n: match.branch([0], match, at=[2]) and None, lambda n: match.branch([1], match, noise=n) and None,
    )  # fmt: skip


def branched() -> Case:
    match, other = (Match("legged-2001", home=1, away=1, matches=2, seed=s, senses="ideal") for s in (1, 2))
    does = [acted(match), acted(other), lambda n: match.branch([n % 2], other) and None]
    return Case(match, lambda: [match, other], does)


def paid(match: Match) -> np.ndarray:
    """Return the reward of a user's own: a signal that comes here comes at once."""
    return sum(match.robots["x"] for _ in range(20)) / 20.0  # type: ignore[return-value]


def parallel(n_agents: int = 2) -> Case:
    env = soccer_v0.parallel_env(home=1, away=1, senses="ideal", max_cycles=4)
    env.reset(seed=1)

    def step(n: int) -> Any:
        if not env.agents:
            return env.reset()
        rng = np.random.default_rng(n)
        return env.step({agent: rng.uniform(-1.0, 1.0, 4).astype(np.float32) for agent in env.agents})

    return Case(env, lambda: [env.match], [step])


def in_turns() -> Case:
    env = soccer_v0.raw_env(home=1, away=1, senses="ideal", max_cycles=4)
    env.reset(seed=1)

    def step(n: int) -> Any:
        if not env.agents:
            return env.reset()
        over = env.terminations[env.agent_selection] or env.truncations[env.agent_selection]
        return env.step(None if over else np.random.default_rng(n).uniform(-1.0, 1.0, 4).astype(np.float32))

    return Case(env, lambda: [env.env.match], [step])


def alone() -> Case:
    env = SoloSoccer(home=1, away=1, senses="ideal", opponents="chaser", max_cycles=4)
    env.reset(seed=1)

    def step(n: int) -> Any:
        return env.step(np.full(4, 0.5)) if n % 5 else env.reset()

    return Case(env, lambda: [env.match], [step])


def vector(mode: str) -> Callable[[], Case]:
    def make() -> Case:
        given: dict[str, Any] = {"senses": "ideal", "opponents": "chaser", "max_cycles": 4, "autoreset_mode": mode}
        env = SoccerVectorEnv(num_envs=3, home=1, away=1, **given)
        env.reset(seed=1)
        return Case(env, lambda: [env.match], [lambda n: env.step(np.random.default_rng(n).uniform(-1.0, 1.0, (3, 4)))])

    return make


def trained() -> Case:
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

    env = SoccerVecEnv(players=[(1, 1)], matches=4, senses="ideal", action_repeat=3, max_cycles=4, threads=2)
    env.reset()
    step: Do = lambda n: env.step(np.random.default_rng(n).uniform(-1.0, 1.0, (env.num_envs, 4)))  # noqa: E731
    return Case(env, lambda: env.matches, [step, step, step, lambda n: env.reset()])


CHASERS = {"controllers": {"home": "chaser", "away": "chaser"}}
BELIEF = {"home": 2, "away": 2, "matches": 4, "senses": "sensors", "observe": "belief"}
CASES: dict[str, Callable[[], Case]] = {
    "reset, legged 1v1": reset("legged-2001"),
    "reset, middle size 1v1": reset("middle-size-2006"),
    "step, legged 1v1": stepped(),
    "step, middle size 1v1": stepped("middle-size-2006"),
    "step, 2v2 x 4, belief": stepped(**BELIEF),
    "reset, 2v2 x 4, belief": reset("legged-2001", **BELIEF),
    "step, 3v3 x 4, teams": stepped(home=3, away=3, matches=4, **CHASERS),
    "action_repeat=4": stepped(action_repeat=4, matches=3, autoreset="same_step", max_cycles=3),
    "same_step": stepped(matches=4, autoreset="same_step", max_cycles=3),
    "next_step": stepped(matches=4, autoreset="next_step", max_cycles=3),
    "threads=2": stepped(matches=8, threads=2, autoreset="same_step", max_cycles=7),
    "recorder": recorded,
    "save, load, branch, rebuild": saved,
    "branch into another": branched,
    "a reward in Python": stepped(rewards=Rewards(extra={"own": paid}), matches=2, autoreset="same_step", max_cycles=4),
    "parallel env": parallel,
    "env of turns": in_turns,
    "Gymnasium": alone,
    "Gymnasium vector, same_step": vector("SameStep"),
    "Gymnasium vector, next_step": vector("NextStep"),
    "SoccerVecEnv": trained,
}
