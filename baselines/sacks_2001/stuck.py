"""How a robot notices that it is stuck: the ball does not come nearer.  [Sacks 2001, 3.3]  MS19, MS20, MS22

Tested only while it tries to get to the ball (MS22): whoever calls decides that.

`play`: the team's settings.
"""

from __future__ import annotations

from soccer_env.compiled import compiled

INTERVAL = 1.0 / 3.0  # [s] between two velocities of the ball, Sacks 2001, 3.2
VELOCITY_NOISE = 0.21  # [1/(m s)] sd of the filtered radial velocity over distance squared, at 88x72, simulated
ROUNDING = 1e-9


@compiled
def watch_approach(ball, memory, play, elapsed):
    """Move both counters by what the ball did in `elapsed` [s] of approach: net readings, time near the ball.

    MS19: +1 if the radial velocity is near zero or positive, -1 if it is clearly negative, never below zero. Between
    the two bands the counter rests. The lower one widens with the error of the velocity, which grows with the square
    of the distance.
    """
    memory.near = memory.near + elapsed if ball.distance < play.near else 0.0  # MS20
    memory.reading += elapsed
    if memory.reading < INTERVAL - ROUNDING:
        return
    memory.reading = max(memory.reading - INTERVAL, 0.0)
    if ball.age > INTERVAL:
        return
    noise = VELOCITY_NOISE * ball.filtered_distance * ball.filtered_distance
    if ball.radial > -play.near_zero:
        memory.stuck += 1
    elif ball.radial < -play.clearly - play.noise_share * noise:
        memory.stuck = max(memory.stuck - 1, 0)


@compiled
def is_stuck(ball, memory, play):
    """Tell whether the robot is stuck: the first counter has tripped, and near the ball the second one too.  MS20"""
    if memory.stuck < play.stuck_count:
        return False
    return play.two_counters == 0 or ball.distance >= play.near or memory.near >= play.near_time


@compiled
def forget_approach(memory):
    """Begin to count anew."""
    memory.stuck = 0
    memory.near = 0.0
    memory.reading = 0.0
