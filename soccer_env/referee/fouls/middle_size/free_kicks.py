"""Free kicks: for the team that did not commit the foul, where it happened.

FIFA's Law 13 of 2005: opponents keep their distance, but for those on their own goal line between the posts; a free
kick within the opponents' goal area is taken from that area's line, from the point nearest to the foul. In the own
goal area it is moved there too (any point of it may be chosen there). The opponents' distance, the time to take it
and how far the ball has to go are those of the other restarts.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.referee.restart_call import call_restart, other_team
from soccer_env.types import Phase

FREE_KICK = int(Phase.FREE_KICK)


@compiled
def give_free_kick(match, events, k, culprit_team, x, y):
    """Call a free kick for the opponents of a team, at a point of the field [m] or where it is moved to."""
    x, y = spot(k, x, y)
    call_restart(match, events, FREE_KICK, other_team(culprit_team), x, y)


@compiled
def spot(k, x, y):
    """Return where a free kick for a foul at a point is taken [m]: on the pitch, not within a goal area."""
    edge_x, edge_y = 0.5 * k.pitch_length - k.rules_corner_offset, 0.5 * k.pitch_width - k.rules_corner_offset
    x, y = clip(x, -edge_x, edge_x), clip(y, -edge_y, edge_y)
    line = 0.5 * k.pitch_length - k.pitch_goal_area_depth
    if abs(x) > line and abs(y) < 0.5 * k.pitch_goal_area_width:
        x = line if x > 0.0 else -line
    return x, y
