"""The obstacles that a way is planned round: the other robots, where they are believed to be and to go.  MH06, MH15

    "the position of the obstacles is no longer static for the whole planning process"    [Heinemann 2006, 3]

They are the robot's own tracks: what its camera saw, and where its team-mates say by radio that they are.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.weigel_2001.planner.records import MOST_OBSTACLES
from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.skills.moves import FOUGHT_FOR


@compiled
def note_crowd(scratch, k, play, fights):
    """Fill the obstacles from what is seen; whoever fights for the ball plans no way round those who have it."""
    sight, count = scratch.sight, 0
    for i in range(sight.others):
        at_ball = length(sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y) < FOUGHT_FOR
        if count == MOST_OBSTACLES or (fights and at_ball and (sight.mate[i] == 1 or sight.field[i] == 1)):
            continue
        one = scratch.crowd[count]
        one.x, one.y = sight.other_x[i], sight.other_y[i]
        one.vx, one.vy = bounded(sight.other_vx[i], sight.other_vy[i], play)
        one.radius = k.body_reach + play.keeps_off
        count += 1
    scratch.count = count


@compiled
def bounded(vx, vy, play):
    """Return a believed velocity [m/s], no faster than robots drive: a mistaken pair of readings is faster.  MH25"""
    if play.velocity == 0:
        return 0.0, 0.0
    speed = length(vx, vy)
    if speed <= play.fastest:
        return vx, vy
    return play.fastest * vx / speed, play.fastest * vy / speed
