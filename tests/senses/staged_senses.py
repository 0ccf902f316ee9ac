"""Matches whose robots use their sensors, for the tests of all that they sense and believe."""

from typing import Any

import numpy as np

from soccer_env import Match

LEAGUES = ("legged-2001", "middle-size-2006")


def sensing_matches(league: str, matches: int = 4, home: int = 3, away: int = 3, **settings: Any) -> Match:
    """Return matches whose robots all use their sensors."""
    return Match(league, home=home, away=away, matches=matches, **{"seed": 5, "observe": "belief", **settings})


def random_actions(match: Match, steps: int, seed: int = 0) -> np.ndarray:
    """Return actions (steps, M, R, 4), each kept for half a second."""
    rng, hold = np.random.default_rng(seed), match.league.control_rate // 2
    kept = rng.uniform(-1.0, 1.0, (steps // hold + 1, match.count, match.robots.shape[1], 4))
    return np.repeat(kept, hold, axis=0)[:steps]


def look_again(match: Match) -> None:
    """Let all robots forget, and take a first look at the field as it is."""
    for m in range(match.count):
        match.batch.senses.start(m)
    match.batch.senses.step(0, match.count)
