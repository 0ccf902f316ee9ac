"""A small SoccerVecEnv for tests, and random play on it; stable-baselines3 is imported on first use."""

from typing import Any

import numpy as np

MIXED = ((1, 1), (3, 2))  # team sizes


def rows(**settings: Any) -> Any:
    """Return 4 matches of 2 against 2 in which learners see the truth."""
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

    fields: dict[str, Any] = {"players": ((2, 2),), "matches": 4, "observe": "truth", "senses": "ideal", "seed": 3}
    return SoccerVecEnv(**{**fields, **settings})


def draw(env: Any, rng: np.random.Generator) -> np.ndarray:
    return rng.uniform(-1.0, 1.0, (env.num_envs, *env.action_space.shape)).astype(np.float32)


def play(env: Any, steps: int, seed: int = 0) -> list[Any]:
    """Return what random actions bring, step by step, from where the matches stand."""
    rng = np.random.default_rng(seed)
    return [env.step(draw(env, rng)) for _ in range(steps)]


def assert_same_play(one: list[Any], other: list[Any]) -> bool:
    pairs = zip(one, other, strict=True)
    return all(np.array_equal(a[part], b[part]) for a, b in pairs for part in range(3))
