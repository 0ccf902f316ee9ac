"""Apply all rules about fouls in their order, once a control step, before the ball is judged.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.referee.fouls.legged.book import judge_legged
from soccer_env.referee.fouls.middle_size.book import judge_middle_size


@compiled
def judge_fouls(match, ball, robots, events, robot_events, touching, k):
    """Whistle for the fouls of a step; tell whether robots were moved. `touching`: see `find_collisions`."""
    moved = judge_legged(match, ball, robots, events, robot_events, touching, k)
    return judge_middle_size(match, ball, robots, events, robot_events, touching, k) or moved
