"""The team frame: own goal behind, opponent's goal ahead."""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.types import HOME


@compiled
def direction_of(match, team):
    """Return +1 if the team attacks +x now, -1 if it attacks -x."""
    return match.home_direction if team == HOME else -match.home_direction
