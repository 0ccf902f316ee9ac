"""`save` and `load` of the environments: an episode goes on where it was, in an env of the same settings."""

from typing import Any

import gymnasium
import numpy as np
import pytest

import soccer_env
from soccer_env import soccer_v0

SOLO = f"{soccer_env.__name__}/Legged2001-2v2-v0"


def equal(one: Any, other: Any) -> bool:
    """Tell whether observations, rewards and infos are the same, whatever they are made of."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(equal(one[key], other[key]) for key in one)
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(equal, one, other))
    return np.array_equal(one, other)


def drawn(env: Any, count: int) -> list[Any]:
    """Return random actions of all agents, or of one env."""
    rng = np.random.default_rng(3)
    agents = getattr(env, "possible_agents", None)
    if agents is None:
        return [rng.uniform(-1.0, 1.0, env.action_space.shape).astype("f4") for _ in range(count)]
    return [{agent: rng.uniform(-1.0, 1.0, 4).astype("f4") for agent in agents} for _ in range(count)]


def made(kind: str, **settings: Any) -> Any:
    """Return an env of one kind."""
    if kind == "parallel":
        return soccer_v0.parallel_env(home=2, away=1, controllers={"away": "chaser"}, **settings)
    if kind == "solo":
        return gymnasium.make(SOLO, **settings).unwrapped
    return gymnasium.make_vec(SOLO, num_envs=3, **settings)


@pytest.mark.parametrize("kind", ["parallel", "solo", "vector"])
def test_an_env_goes_on_from_a_save(kind: str) -> None:
    env, other = made(kind, max_cycles=30), made(kind, max_cycles=30)
    actions = drawn(env, 30)
    env.reset(seed=1)
    for action in actions[:10]:
        env.step(action)
    saved = env.save()
    future = [env.step(action) for action in actions[10:]]
    for one in (env, other):  # env's episode has ended, other's has not begun
        one.load(saved)
        assert equal([*map(repr, [one.step(action) for action in actions[10:]])], [*map(repr, future)])


def test_what_load_returns_is_what_step_returned() -> None:
    env = made("parallel")
    env.reset(seed=1)
    for action in drawn(env, 9):
        observations, _, _, _, infos = env.step(action)
    seen, told = env.load(env.save())
    assert equal(seen, observations) and env.agents == ["home_0", "home_1"]
    assert [info["phase"] for info in told.values()] == [info["phase"] for info in infos.values()]


def test_a_save_of_an_episode_that_has_ended_leaves_nobody_to_act() -> None:
    env, other = made("parallel", max_cycles=2), made("parallel", max_cycles=2)
    env.reset(seed=1)
    for action in drawn(env, 2):
        env.step(action)
    other.reset(seed=2)
    other.load(env.save())
    assert other.agents == []
    with pytest.raises(RuntimeError, match="after the end of the episode: call reset"):
        other.step(drawn(env, 1)[0])


def test_one_match_of_a_vector_env_goes_into_others() -> None:
    envs = made("vector")
    envs.reset(seed=1)
    for actions in drawn(envs, 5):
        envs.step(actions)
    seen, infos = envs.load(envs.save(rows=0), rows=[1, 2])
    assert np.array_equal(seen[1], seen[0]) and np.array_equal(seen[2], seen[0]) and len(infos["phase"]) == 3


@pytest.mark.parametrize("kind", ["parallel", "solo", "vector"])
def test_what_cannot_be_saved_or_loaded_is_said(kind: str) -> None:
    env, other = made(kind), made(kind, minutes=3.0)
    with pytest.raises(RuntimeError, match="save before reset: call reset"):
        env.save()
    env.reset(seed=1)
    other.reset(seed=1)
    before = env.match.state_hash()
    for bad, message in ((other.save(), "minutes 3.0 there, "), (b"no", "not a save"), (None, "a save is bytes")):
        with pytest.raises(ValueError, match=message):
            env.load(bad)
    assert env.match.state_hash() == before
