"""All rules about fouls in their order, once a control step, before the ball is judged.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.types import Phase

PLAY = int(Phase.PLAY)


@compiled
def judge_fouls(match, ball, robots, events, robot_events, k):
    """Whistle for the fouls of a step; tell whether robots were moved."""
    return False
