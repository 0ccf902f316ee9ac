"""Detection that a robot is stuck, because the ball does not come nearer.  [Sacks 2001, 3.3]  MS19, MS20, MS22

The planner tests this only while the robot tries to get to the ball (MS22).

`k`: the league's constants; `play`: the team's settings.
"""

from math import cos, sin

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length

INTERVAL = 1.0 / 3.0  # [s] between two velocities of the ball, Sacks 2001, 3.2
FORGOTTEN = 1.5 - INTERVAL  # [s] unseen after which its velocity is forgotten, to a reading, Sacks 2001, 3.2
ROUNDING = 1e-9


@compiled
def note_gap(ball, memory, elapsed):
    """Note the time until a ball that reappears has a velocity: its first reading is only stored.  MS17"""
    memory.unmeasured = 2.0 * INTERVAL if ball.age > FORGOTTEN else max(memory.unmeasured - elapsed, 0.0)


@compiled
def watch_approach(ball, memory, k, play, elapsed):
    """Update both counters of an approach: readings without progress, and time near the ball.

    MS19: +1 if the radial velocity is near zero or positive, -1 if it is significantly less than zero, never below
    zero; between the two the counter rests, and without a velocity. The bands do not widen with the error of a
    velocity. However large the error, the count falls in the long run for a robot that nears the ball faster than the
    middle between the bands, and rises for a robot that stands.
    """
    if is_near(ball, k, play):  # MS20
        memory.near += elapsed
    else:
        memory.near = max(memory.near - elapsed, 0.0)
    memory.reading += elapsed
    if memory.reading < INTERVAL - ROUNDING:
        return
    memory.reading = max(memory.reading - INTERVAL, 0.0)
    if ball.age > INTERVAL or memory.unmeasured > ROUNDING:
        return
    if ball.radial > -play.near_zero:
        memory.stuck += 1
    elif ball.radial < -play.clearly:
        memory.stuck = max(memory.stuck - 1, 0)


@compiled
def is_stuck(ball, memory, k, play):
    """Tell whether the robot is stuck: the first counter is over its limit, and near the ball the second too.  MS20"""
    if memory.stuck < play.stuck_count:
        return False
    return play.two_counters == 0 or not is_near(ball, k, play) or memory.near >= play.near_time


@compiled
def is_near(ball, k, play):
    """Tell whether the ball is near enough for shorter steps, by the filtered distance.  MS20"""
    return distance_from_camera(ball.filtered_distance, ball.filtered_bearing, k) < play.near


@compiled
def distance_from_camera(distance, bearing, k):
    """Convert a ball's distance [m] from the body's middle to the distance from the camera, head level and ahead.

    The paper's ranges are readings, which count from the camera.
    """
    return length(distance * cos(bearing) - k.head_camera_ahead, distance * sin(bearing))


@compiled
def share_of_step(ball, k, play):
    """Return the fraction [1] of a full step for the approach: proportional to the distance near the ball.

    "our robots take smaller steps when they get close to the ball to avoid inadvertently kicking it away, and thus the
    ball's relative velocity drops close to zero": 35 cm is where "its step size begins to decrease", `near_step` of a
    full one where it has become as small as it gets.  MS21
    """
    gap = distance_from_camera(ball.distance, ball.bearing, k)
    return clip(gap / max(play.near, ROUNDING), play.near_step, 1.0)


@compiled
def reset_approach_counters(memory):
    """Reset both counters of the approach to zero."""
    memory.stuck = 0
    memory.near = 0.0
    memory.reading = 0.0
