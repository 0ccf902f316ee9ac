"""`save` and `load` of the environments: an episode goes on where it was, in an env of the same settings."""

import hashlib
import json
from typing import Any

import gymnasium
import numpy as np
import pytest

import soccer_env
from soccer_env import soccer_v0
from soccer_env.api.turn_env import MAGIC
from tests.scenes.staging import refused

SOLO = f"{soccer_env.__name__}/Legged2001-2v2-v0"


def equal(one: Any, other: Any) -> bool:
    """Tell whether observations, rewards and infos are the same, whatever they are made of."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(equal(one[key], other[key]) for key in one)
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(equal, one, other))
    return np.array_equal(one, other)


def drawn(env: Any, count: int) -> list[Any]:
    rng = np.random.default_rng(3)
    agents = getattr(env, "possible_agents", None)
    if agents is None:
        return [rng.uniform(-1.0, 1.0, env.action_space.shape).astype("f4") for _ in range(count)]
    return [{agent: rng.uniform(-1.0, 1.0, 4).astype("f4") for agent in agents} for _ in range(count)]


def made(kind: str, **settings: Any) -> Any:
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


@pytest.mark.parametrize("kind", ["parallel", "solo", "vector"])
def test_what_cannot_be_saved_or_loaded_is_said(kind: str) -> None:
    env, other = made(kind), made(kind, minutes=3.0)
    with pytest.raises(RuntimeError, match="save before reset: call reset"):
        env.save()
    env.reset(seed=1)
    other.reset(seed=1)
    for bad, message in ((other.save(), "minutes 3.0 there, "), (b"no", "not a save"), (None, "a save is bytes")):
        with refused(env.match, message):
            env.load(bad)


SETTINGS: dict[str, Any] = {"home": 2, "away": 1, "max_cycles": 6}


def act(env: Any, count: int, seed: int = 4) -> list[Any]:
    """Let so many agents act, those whose episode has ended as PettingZoo has it; return what each saw before."""
    rng, found = np.random.default_rng(seed), []
    for _ in range(count):
        if not env.agents:
            break
        seen, *rest, _ = env.last()
        over = rest[1] or rest[2]
        found.append((env.agent_selection, seen.tolist(), *rest, list(env.agents)))
        action = rng.uniform(-1.0, 1.0, 4).astype("f4")
        env.step(None if over else action)
    return [*found, env.unwrapped.match.state_hash()]


@pytest.mark.parametrize("maker", [soccer_v0.env, soccer_v0.raw_env])
@pytest.mark.parametrize("after", [0, 1, 3, 7, 18, 19, 20])
def test_an_episode_goes_on_within_a_turn_and_after_its_end(maker: Any, after: int) -> None:
    env, other = maker(**SETTINGS), maker(**SETTINGS)
    env.reset(seed=1)
    act(env, after)
    saved = env.save()
    future = act(env, 30, seed=5)
    for one in (env, other):  # env's episode has ended, other's has not begun
        one.load(saved)
        assert act(one, 30, seed=5) == future
    other.reset(seed=2)
    assert other.agents == ["home_0", "home_1", "away_0"]


def forged(saved: bytes, **changes: Any) -> bytes:
    """Return a save whose turn says something else, with a sum that is right."""
    start = len(MAGIC) + 4
    end = start + int.from_bytes(saved[len(MAGIC) : start], "little")
    header = json.dumps(json.loads(saved[start:end]) | changes).encode()
    body = MAGIC + len(header).to_bytes(4, "little") + header + saved[end:-32]
    return body + hashlib.sha256(body).digest()


@pytest.mark.parametrize(
    "changes",
    [
        {"agents": ["home_9"]}, {"agents": ["home_1", "home_0", "away_0"]}, {"agents": None}, {"selected": "home_9"},
        {"skipped": "nobody"}, {"rewards": {"home_0": "many", "home_1": 0, "away_0": 0}}, {"rewards": {}},
        {"rewards": 3}, {"terminations": {"home_0": None, "home_1": False, "away_0": False}}, {"acted": {}},
        {"acted": {"home_0": [0.0, 1.0]}}, {"acted": {"home_0": [float("nan")] * 4}}, {"acted": [1]},
    ],
)  # fmt: skip
def test_a_forged_turn_is_refused_and_the_episode_goes_on(changes: dict[str, Any]) -> None:
    env: Any = soccer_v0.env(**SETTINGS)
    env.reset(seed=1)
    act(env, 4)
    saved = env.save()
    env.load(forged(saved))
    with refused(env.unwrapped.match, ""):
        env.load(forged(saved, **changes))
    assert env.agent_selection == "home_1"


def test_saves_of_others_and_damaged_ones_are_refused() -> None:
    env, larger = soccer_v0.env(**SETTINGS), soccer_v0.env(home=3, away=1)
    with pytest.raises(RuntimeError, match="save before reset: call reset"):
        env.save()  # type: ignore[attr-defined]
    env.reset(seed=1), larger.reset(seed=1)
    saved: Any = env.save()  # type: ignore[attr-defined]
    for bad, message in (
        (larger.save(), "does not fit"),  # type: ignore[attr-defined]
        (saved[:-1], "damaged"),
        (env.unwrapped.save(), "env of turns"),  # type: ignore[attr-defined]
        (None, "a save is bytes, got NoneType"),
    ):
        with pytest.raises(ValueError, match=message):
            env.load(bad)  # type: ignore[attr-defined]
    assert env.agent_selection == "home_0"
