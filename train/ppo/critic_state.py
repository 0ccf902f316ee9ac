"""The additional input to a centralised critic: the true state of the match, seen from the team's side."""

from typing import Any

import numpy as np

from soccer_env.match import Match, truth_state


def append_state(observations: np.ndarray, match: Match, records: Any, players: int) -> np.ndarray:
    """Append to each observation (M, L, n) the state (M, s), seen from the robot's side; home's robots come first.

    records: of the match now, or of episodes that have ended (`match.final`); players: slots a side in the state.
    """
    home = match.settings.home
    sides = [truth_state.states(match.settings, records, "home", players)] * home
    if observations.shape[1] > home:
        sides += [truth_state.states(match.settings, records, "away", players)] * match.settings.away
    return np.concatenate([observations, np.stack(sides, axis=1)], axis=2)
