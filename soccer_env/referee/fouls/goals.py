"""Whether a ball in the goal counts.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled


@compiled
def goal_counts(match, ball, robots, k, scorer):
    """Tell whether a goal of a team counts."""
    return True
