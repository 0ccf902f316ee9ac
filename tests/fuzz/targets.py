"""Matches that forged saves are loaded into: both leagues, the memories of all shipped teams, every kind of senses."""

from __future__ import annotations

import random
from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env import Match
from tests.fuzz.children import Task
from tests.fuzz.forging import changed, not_a_number, parts_of

STEPS = (5, 60, 200)  # control steps after which saves are made
ON = 12  # control steps that a forged one is played on
SACKS = {"home_0": "sacks-2001", "home_1": "sacks-2001-tuned", "home_2": "sacks-2001-future"}
SIMPLE = {"away_0": "random", "away_1": "walker", "away_2": "still"}
HEINEMANN = {"home_0": "heinemann-2006", "home_1": "weigel-2001", "home_2": "random"}
SETTINGS: dict[str, dict[str, Any]] = {
    "sacks": {"home": 3, "away": 3, "controllers": {**SACKS, **SIMPLE}, "pose": "particles"},
    "learned": {"home": 2, "away": 2, "controllers": {"home": "learned", "away": "chaser"}, "senses": "ideal"},
    "learners": {"home": 2, "away": 1, "observe": "percepts", "opponents": "chaser", "autoreset": "same_step"},
    "truth": {"home": 1, "away": 1, "matches": 3, "max_players": 3},
    "heinemann": {"league": "middle-size-2006", "home": 3, "away": 2, "controllers": {**HEINEMANN, "away": "chaser"},
                  "pose": "particles"},
    "omni": {"league": "middle-size-2006", "home": 2, "away": 2, "observe": "percepts", "opponents": "chaser"},
    "belief": {"league": "middle-size-2006", "home": 1, "away": 1, "observe": "belief", "opponents": "heinemann-2006"},
}  # fmt: skip


@dataclass
class Target:
    """A match and saves of it."""

    name: str
    match: Match
    saves: list[bytes]

    def forge(self, draw: random.Random) -> tuple[str, Task]:
        """Return words for a forged save, and the task to load and play it."""
        saved = draw.choice(self.saves)
        forged, told = changed(saved, parts_of(saved, self.match, memory=True), len(self.match.agents), draw)
        return f"{self.name}: {told}", lambda: load_and_play(self.match, forged)


def make_target(name: str) -> Target:
    """Return a match that has been played for a while, with saves on the way."""
    match = Match(**SETTINGS[name], seed=7)
    saves = []
    for step in range(max(STEPS)):
        match.step(actions_of(match, step))
        if step + 1 in STEPS:
            saves.append(match.save())
    assert load_and_play(match, saves[0]) == ""  # here, so that children find all code compiled and loaded
    return Target(name, match, saves)


def actions_of(match: Match, step: int) -> np.ndarray | None:
    """Return random actions, the same for the same step."""
    shape = (match.count, len(match.agents), match.settings.actions.size)
    return np.random.default_rng(step).uniform(-1.0, 1.0, shape)


def load_and_play(match: Match, forged: bytes) -> str:
    """Load a forged save, play on and begin a new episode; return what is wrong."""
    match.load(forged)
    wrong = not_a_number(match)
    for step in range(0 if wrong else ON):
        match.step(actions_of(match, step))
    match.state()
    match.save()
    wrong = wrong or not_a_number(match)
    match.reset()
    return wrong or not_a_number(match)
