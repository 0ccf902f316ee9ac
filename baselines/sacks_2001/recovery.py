"""Recovery of a stuck robot: step back, sidestep or rotate, approach again.  [Sacks 2001, 3.4]  MS23 to MS25

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, ROTATE, SIDESTEP
from soccer_env.baselines.sacks_2001.stuck import reset_approach_counters
from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, into_frame, length
from soccer_env.skills.sight import side_of

FACING = 0.15  # [rad] to the ball: within it a robot faces the ball, assumed
ASIDE = 0.6  # [m] within which players count when a side is chosen, assumed


@compiled
def begin_recovery(memory, k, play):
    """Begin the recovery by steps backwards: set their duration and the clock.  MS23"""
    reset_approach_counters(memory)
    memory.tries += 1
    memory.behaviour, memory.clock = BACK, 0.0
    memory.left = play.back_steps * k.gait_steps * k.dt


@compiled
def go_on_recovering(belief, tracks, memory, k, play, elapsed):
    """Choose the next behaviour of the recovery when the present behaviour is over; APPROACH ends it.  MS23, MS25"""
    memory.left -= elapsed
    bearing = belief.ball.bearing
    if memory.behaviour == ROTATE and abs(bearing) < FACING:
        memory.left = 0.0
    if memory.left > 0.0:
        return
    step = k.gait_steps * k.dt
    if memory.behaviour != BACK:
        memory.behaviour = APPROACH
        reset_approach_counters(memory)
    elif abs(bearing) > play.rotate_beyond:  # MS25
        memory.behaviour = ROTATE
        memory.left = play.rotate_steps * step
        memory.side = side_of(bearing)
    else:
        memory.behaviour, memory.left = SIDESTEP, play.side_steps * step
        memory.side = side_to_step(belief, tracks, k, play)
    memory.clock = 0.0


@compiled
def side_to_step(belief, tracks, k, play):
    """Return the side, +1 left or -1 right, whose sidestep brings the ball between robot and opponents' goal.  MS24

    On that side the line from the goal through the ball passes the robot. sacks-2001-future chooses the side with fewer
    players, if the numbers differ.
    """
    own, ball = belief.own, belief.ball
    if play.free_side == 1:
        crowd = surplus_on_left(tracks, play)
        if crowd != 0:
            return -1.0 if crowd > 0 else 1.0
    cosine, sine = cosine_and_sine(own.heading)
    to_x, to_y = 0.5 * k.pitch_length - own.x, -own.y
    ahead, left = into_frame(to_x, to_y, cosine, sine)
    ahead, left = ahead - ball.x, left - ball.y  # from ball to goal
    away = max(length(ahead, left), 1e-6)
    return side_of(ball.y - ball.distance * left / away)


@compiled
def surplus_on_left(tracks, play):
    """Return the number of nearby players on the left minus the number on the right."""
    crowd = 0
    for slot in range(tracks.shape[0]):
        track = tracks[slot]
        if track.present == 1 and track.age <= play.player_age and track.distance < ASIDE:
            crowd += 1 if track.y > 0.0 else -1
    return crowd
