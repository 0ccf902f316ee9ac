"""The ball on the carpet: it slides after a blow until it rolls, then slows down at a constant rate.

Friction acts for half a control step before the contacts are solved and for half a step after them: the speed is then
exact at the ends of a step, and the stopping distance is exactly v^2 / 2a.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.geometry import length, step_toward


@compiled
def slow_down(ball, k, seconds):
    """Apply the carpet's friction to a ball for a time [s]."""
    ball.spin = step_toward(ball.spin, 0.0, k.ball_pivot * seconds)
    slip_x, slip_y = ball.vx - ball.roll_x, ball.vy - ball.roll_y
    slip = length(slip_x, slip_y)
    if slip > 0.0:
        seconds = slide(ball, k, seconds, slip_x, slip_y, slip)
    if seconds > 0.0:
        roll(ball, k, seconds)


@compiled
def slide(ball, k, seconds, slip_x, slip_y, slip):
    """Let the ball slide until it rolls or the time is up; return the time left [s].

    Friction mu g slows the ball and, through its inertia shell * m r^2, spins it up by mu g / shell.
    """
    gain = 1.0 + 1.0 / k.ball_shell
    used = min(seconds, slip / (k.ball_sliding * gain))
    change = k.ball_sliding * used / slip
    ball.vx -= change * slip_x
    ball.vy -= change * slip_y
    if used < seconds:
        ball.roll_x, ball.roll_y = ball.vx, ball.vy
    else:
        ball.roll_x += change / k.ball_shell * slip_x
        ball.roll_y += change / k.ball_shell * slip_y
    return seconds - used


@compiled
def roll(ball, k, seconds):
    """Slow a rolling ball by the rolling resistance."""
    speed = length(ball.vx, ball.vy)
    loss = k.ball_rolling * seconds
    factor = 0.0 if loss >= speed else 1.0 - loss / speed
    ball.vx *= factor
    ball.vy *= factor
    ball.roll_x, ball.roll_y = ball.vx, ball.vy


@compiled
def limit_speed(ball, k):
    """Limit the ball to its top speed."""
    speed = length(ball.vx, ball.vy)
    if speed > k.ball_top_speed:
        ball.vx *= k.ball_top_speed / speed
        ball.vy *= k.ball_top_speed / speed


@compiled
def stop_ball(ball):
    """Stop the ball."""
    ball.vx = ball.vy = ball.roll_x = ball.roll_y = ball.spin = 0.0
