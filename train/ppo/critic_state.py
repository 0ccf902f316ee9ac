"""What a centralised critic sees beside a robot's observation: the whole truth of its match, from home's side."""

from __future__ import annotations

import numpy as np

from soccer_env import truth_state
from soccer_env.match import Match


def with_state(observations: np.ndarray, state: np.ndarray) -> np.ndarray:
    """Return observations (M, H, n) with the state (M, s) of their match behind each."""
    told = np.broadcast_to(state[:, None], (*observations.shape[:2], state.shape[1]))
    return np.concatenate([observations, told], axis=2)


def team_state(match: Match, players: int) -> np.ndarray:
    """Return `state()` (M, s) with room for `players` a side, turned so that home plays towards +x."""
    records = {"matches": match.matches, "balls": match.balls, "robots": match.robots}
    return truth_state.states(match.settings, records, "home", players)


def last_state(match: Match, players: int) -> np.ndarray:
    """Return the states (E, s) with which the matches that have just ended did so, as `team_state` does."""
    return truth_state.states(match.settings, match.final, "home", players)
