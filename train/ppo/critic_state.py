"""What a centralised critic sees beside a robot's observation: the whole truth of its match, from home's side."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from soccer_env import truth_state
from soccer_env.match import Match


def with_state(observations: np.ndarray, state: np.ndarray) -> np.ndarray:
    """Return observations (M, H, n) with the state (M, s) of their match behind each."""
    told = np.broadcast_to(state[:, None], (*observations.shape[:2], state.shape[1]))
    return np.concatenate([observations, told], axis=2)


def team_state(match: Match, players: int) -> np.ndarray:
    """Return `state()` (M, s) with room for `players` a side, turned so that home plays towards +x."""
    return turned_state(match, players, {name: getattr(match, name) for name in ("matches", "balls", "robots")})


def last_state(match: Match, players: int) -> np.ndarray:
    """Return the states (E, s) with which the matches that have just ended did so, as `team_state` does."""
    return turned_state(match, players, match.final)


def turned_state(match: Match, players: int, records: dict[str, np.ndarray]) -> np.ndarray:
    """Return the states (n, s) of n records of a match, turned so that home plays towards +x."""
    told = SimpleNamespace(
        settings=SimpleNamespace(max_players=players, rows=match.settings.rows), league=match.league,
        count=len(records["matches"]), matches=records["matches"], balls=records["balls"], robots=records["robots"],
    )  # fmt: skip
    turns = records["matches"]["home_direction"][:, None] < 0.0
    state: np.ndarray = np.where(turns, turn_signs(players), np.float32(1.0)) * truth_state.write(told)
    return state


def turn_signs(players: int) -> np.ndarray:
    """Return -1 for the entries of a state that a half-turn of the field turns round, else 1."""
    return np.array([entry.half_turn for entry in truth_state.entries(players)], np.float32)
