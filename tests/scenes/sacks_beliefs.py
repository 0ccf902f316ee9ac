"""Random beliefs and tracks for the tests of sacks-2001: likely ones, and extreme ones that no sensor would give."""

from typing import Any

import numpy as np

from soccer_env.records.beliefs import BELIEF, TRACK

MEMORY_LATERAL = ("aim_error", "side", "way", "way_side", "aside", "turn")  # what a mirror turns round in a memory


def draw_beliefs(rng: np.random.Generator, shape: Any, reach: float = 1.0) -> np.ndarray:
    """Return beliefs of that shape; `reach` scales every length: 1 is the field's size."""
    beliefs = np.zeros(shape, BELIEF)
    own, ball, situation = beliefs["own"], beliefs["ball"], beliefs["situation"]
    own["x"], own["y"] = reach * rng.uniform(-1.5, 1.5, shape), reach * rng.uniform(-1.0, 1.0, shape)
    own["heading"] = rng.uniform(-np.pi, np.pi, shape)
    for name in ("forward", "left", "turn"):
        own[name] = reach * rng.normal(0.0, 0.1, shape)
    own["confidence"] = rng.uniform(0.0, 100.0, shape)
    ball["held"] = rng.random(shape) < 0.4
    ball["distance"] = np.where(ball["held"] == 1, 0.147, reach * rng.uniform(0.1, 2.5, shape))
    ball["bearing"] = np.where(ball["held"] == 1, 0.1, 1.0) * rng.uniform(-np.pi, np.pi, shape)
    ball["filtered_distance"] = ball["distance"] * rng.uniform(0.9, 1.1, shape)
    ball["filtered_bearing"] = ball["bearing"] + rng.normal(0.0, 0.05, shape)
    ball["x"], ball["y"] = ball["distance"] * np.cos(ball["bearing"]), ball["distance"] * np.sin(ball["bearing"])
    for name in ("vx", "vy", "radial", "angular"):
        ball[name] = reach * rng.normal(0.0, 0.1, shape)
    ball["confidence"] = rng.choice([0.0, 50.0, 100.0], shape)
    ball["age"] = rng.choice([0.0, 0.5, 3.0], shape, p=(0.8, 0.1, 0.1))
    situation["active"], situation["ours"] = 1, rng.choice([-1.0, 0.0, 1.0], shape)
    situation["phase"], situation["keeper"] = rng.choice([0, 0, 0, 1, 5], shape), rng.random(shape) < 0.3
    situation["number"], situation["teammates"], situation["opponents"] = rng.integers(0, 3, shape), 2, 3
    beliefs["heard"]["distance"], beliefs["heard"]["age"] = rng.uniform(0.0, 2.0, shape), rng.choice([0.5, 9.0], shape)
    obstacle = beliefs["obstacle"]
    obstacle["distance"] = np.where(rng.random(shape) < 0.3, rng.uniform(0.1, 0.5, shape), 0.0)
    obstacle["bearing"] = np.where(obstacle["distance"] > 0.0, rng.normal(0.0, 0.5, shape), 0.0)
    return beliefs


def draw_tracks(rng: np.random.Generator, shape: Any, slots: int, reach: float = 1.0) -> np.ndarray:
    """Return tracks (*shape, slots), some of them empty or old, some nearer than bodies allow."""
    size = (*np.atleast_1d(shape), slots)
    tracks = np.zeros(size, TRACK)
    tracks["present"], tracks["teammate"] = rng.random(size) < 0.7, np.arange(slots) < 2
    tracks["keeper"], tracks["number"] = rng.random(size) < 0.2, -1
    tracks["distance"] = reach * 10.0 ** rng.uniform(-2.0, 0.5, size)
    tracks["bearing"] = rng.uniform(-np.pi, np.pi, size)
    tracks["x"] = tracks["distance"] * np.cos(tracks["bearing"])
    tracks["y"] = tracks["distance"] * np.sin(tracks["bearing"])
    for name in ("vx", "vy"):
        tracks[name] = reach * rng.normal(0.0, 0.1, size)
    tracks["age"] = rng.choice([0.0, 2.0, 6.0], size)
    return tracks
