"""The task of most examples, to score into an empty goal within ten seconds, and a test of what was learned."""

from collections.abc import Callable
from typing import Any

import numpy as np

from soccer_env import Match, Rewards

CONTROL_STEPS = 500  # 10 s of 50 a second, until an episode is cut
EMPTY_GOAL: dict[str, Any] = {
    "league": "middle-size-2006",
    "scene": "empty-goal",
    "episode": "drill",  # ends with the goal
    "away": 1,
    "opponents": "still",
    "action_repeat": 5,  # ten decisions a second
    "max_cycles": CONTROL_STEPS // 5,
    "rewards": Rewards(goal=10.0, progress=20.0, approach=40.0),  # large, for learners that do not normalise them
}
SOLO = {name: value for name, value in EMPTY_GOAL.items() if name not in ("league", "away")}  # beside the id's own
SOLO_ID = "soccer_env:soccer_env/MiddleSize2006-1v1-v0"  # the module first, so that worker processes find the id


def share_scored(act: Callable[[Any], Any], home: int = 1, action_repeat: int = 5, episodes: int = 200) -> float:
    """Return the share of episodes in which home scores; `act` maps observations (n, size) to actions (n, 4)."""
    settings = {**EMPTY_GOAL, "action_repeat": action_repeat, "max_cycles": None}
    match = Match(**settings, home=home, matches=episodes, seed=1000)
    actions = np.zeros((episodes, home + 1, 4))  # the row of the opponent is ignored
    for _ in range(CONTROL_STEPS // action_repeat):  # a match that has ended stands still
        seen = match.observations[:, :home].reshape(episodes * home, -1)
        actions[:, :home] = np.clip(act(seen), -1.0, 1.0).reshape(episodes, home, 4)
        match.step(actions)
    return float(np.mean(match.matches["score"][:, 0] > 0))
