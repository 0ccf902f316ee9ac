"""What a centralised critic sees beside a robot's observation: the whole truth of its match, from its team's side."""

from typing import Any

import numpy as np

from soccer_env.match import Match, truth_state


def with_state(observations: np.ndarray, match: Match, records: Any, players: int) -> np.ndarray:
    """Return observations (M, L, n) of home's robots, and maybe away's, with their side's state (M, s) behind each.

    records: the match's own, or those of episodes that have ended (`match.final`); players: room a side.
    """
    home = match.settings.home
    sides = [truth_state.states(match.settings, records, "home", players)] * home
    if observations.shape[1] > home:
        sides += [truth_state.states(match.settings, records, "away", players)] * match.settings.away
    return np.concatenate([observations, np.stack(sides, axis=1)], axis=2)


def records_of(match: Match) -> dict[str, np.ndarray]:
    """Return the records that states are told from, as they stand."""
    return {"matches": match.matches, "balls": match.balls, "robots": match.robots}
