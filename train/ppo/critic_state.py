"""The additional input to a centralised critic: the true state of the match, seen from the team's side."""

from typing import Any

import numpy as np

from soccer_env.guards.checking import check_whole_number
from soccer_env.match import Match, truth_state
from soccer_env.types import MAX_TEAM


def room_for(state: bool | int, largest: int) -> int:
    """Return the slots a side in the state: 0 without one, for the largest team (True), or the asked number."""
    if state is False or state is True:
        return largest * state
    return check_whole_number("state", state, largest, MAX_TEAM) if state else 0


def append_state(observations: np.ndarray, match: Match, records: Any, players: int) -> np.ndarray:
    """Append to each observation (M, L, n) the state (M, s), seen from the robot's side; home's robots come first.

    records: of the match now, or of episodes that have ended (`match.final`); players: slots a side in the state.
    """
    home = match.settings.home
    sides = [truth_state.states(match.settings, records, "home", players)] * home
    if observations.shape[1] > home:
        sides += [truth_state.states(match.settings, records, "away", players)] * match.settings.away
    return np.concatenate([observations, np.stack(sides, axis=1)], axis=2)
