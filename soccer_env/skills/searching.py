"""How the chaser finds a ball that it has not seen for a while: turn all the way round, then look from elsewhere.

`k`: the league's constants; `play`: the team's settings.
"""

from math import atan2

from soccer_env.compiled import compiled
from soccer_env.geometry import length, wrap
from soccer_env.skills.moves import go, leave_boards
from soccer_env.skills.sight import side_of

LOST = 2.0  # [s] unseen after which the ball is searched for, assumed
SEARCH = 0.9  # [1] of the top turn rate while searching, assumed: the camera still has each place in many pictures
FULL_TURN = 6.3  # [rad]
LONGEST_WALK = 10.0  # [s] to the next place to look from, assumed
LOOKOUT = 0.25  # [pitch lengths] of a field player's lookouts from the centre, assumed
THERE = 2.0  # [body reaches] from a lookout at which the search on the spot begins anew, assumed


@compiled
def search_for_ball(belief, command, sight, memory, k, play):
    """Turn a full circle, always to one side; then walk to a lookout and turn again.

    A camera on a head sees little more than the field before the robot; a robot that sees all round walks at once.
    """
    if memory.search_side == 0.0:
        begin_search(belief, sight, memory, k)
    if memory.turned < FULL_TURN and k.head_pan_limit > 0.0:
        command.turn = SEARCH * memory.search_side * sight.pace
        memory.turned += abs(command.turn) * k.drive_turn * sight.elapsed
        leave_boards(command, sight, k)
        return
    if memory.search_clock == 0.0:
        memory.lookout = -side_of(sight.x) * LOOKOUT * k.pitch_length
    memory.search_clock += sight.elapsed
    x = memory.lookout
    if belief.situation.keeper == 1:
        x = -0.5 * k.pitch_length + play.keeper_line * k.body_reach
    go(command, sight, k, play, x, 0.0, 0.0 if belief.situation.keeper == 1 else atan2(-sight.y, x - sight.x), 0.0)
    if memory.search_clock > LONGEST_WALK or length(x - sight.x, sight.y) < THERE * k.body_reach:
        memory.search_clock = memory.turned = 0.0


@compiled
def begin_search(belief, sight, memory, k):
    """Choose the side to turn to: where the ball was last, or towards the centre spot if it was never seen."""
    bearing = sight.bearing
    if belief.ball.confidence <= 0.0:
        bearing = wrap(atan2(-sight.y, -sight.x) - sight.heading)
    memory.search_side = side_of(bearing)
    memory.turned = memory.search_clock = 0.0


@compiled
def end_search(memory):
    """Note that the ball is found."""
    memory.search_side = 0.0
