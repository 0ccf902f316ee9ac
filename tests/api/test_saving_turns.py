"""`save` and `load` of the AEC env: a turn goes on where it was, with the actions of those that have acted."""

import hashlib
import json
from typing import Any

import numpy as np
import pytest

from soccer_env import soccer_v0
from soccer_env.api.turn_env import MAGIC

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


def test_discrete_actions_wait_in_a_save_too() -> None:
    env, other = (soccer_v0.env(**SETTINGS, actions="discrete") for _ in range(2))
    env.reset(seed=1)
    env.step(np.int64(3))
    other.load(env.save())
    for one in (env, other):
        one.step(5), one.step(0)
    assert env.unwrapped.match.state_hash() == other.unwrapped.match.state_hash()


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
        {"agents": ["home_9"]},
        {"agents": ["home_1", "home_0", "away_0"]},
        {"selected": "home_9"},
        {"skipped": "nobody"},
        {"rewards": {"home_0": "many", "home_1": 0, "away_0": 0}},
        {"rewards": {}},
        {"rewards": 3},
        {"terminations": {"home_0": None, "home_1": False, "away_0": False}},
        {"acted": {"home_0": [0.0, 1.0]}},
        {"acted": {"home_0": [float("nan")] * 4}},
        {"acted": {}},
        {"acted": [1]},
        {"agents": None},
    ],
)
def test_a_forged_turn_is_refused_and_the_episode_goes_on(changes: dict[str, Any]) -> None:
    env: Any = soccer_v0.env(**SETTINGS)
    env.reset(seed=1)
    act(env, 4)
    saved, before = env.save(), env.unwrapped.match.state_hash()
    env.load(forged(saved))
    with pytest.raises(ValueError):
        env.load(forged(saved, **changes))
    assert env.unwrapped.match.state_hash() == before and env.agent_selection == "home_1"


def test_saves_of_others_and_damaged_ones_are_refused() -> None:
    env, larger = soccer_v0.env(**SETTINGS), soccer_v0.env(home=3, away=1)
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


def test_nothing_is_saved_before_a_reset() -> None:
    with pytest.raises(RuntimeError, match="save before reset: call reset"):
        soccer_v0.env(**SETTINGS).save()  # type: ignore[attr-defined]
