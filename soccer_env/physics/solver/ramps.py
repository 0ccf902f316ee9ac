"""The ball on the sloped feet of boards: it climbs a ramp, comes to rest there for a moment, and rolls back down.

Seen from the side, a ramp of 45 degrees before a board; `ramp` is its width in plan:

                  |  board            On the ramp a rolling ball is driven back at g sin 45 / (1 + shell) along the
                /|                    slope, times cos 45 in plan. It meets the ramp before its centre is over the
        o     /  |                    foot: floor and slope touch a ball whose centre is r tan 22.5 off the foot.
    --------+----+
             ramp

The ball loses speed where floor and slope meet: of the speed v of its centre only v cos 45 goes on along the slope, and
that is v cos2 45 = v / 2 in plan. It rolls back without a further loss in plan. In plan alone, this blow is spread over
the climb: the ball that climbs is slowed 1 / cos4 45 = 4 times as much as it is driven back, so that it climbs as far
and comes back as fast, at half of its speed. Assumed: the ball neither hops nor slips on the ramp.

A slow ball crosses the foot, climbs and turns within one substep, in which Chipmunk moves it at one speed. So what it
loses follows from its way, not from the time; if it touches nothing, it is put back to where it turned; and it gets no
faster than the height from which it rolls allows. Otherwise a ball that creeps onto a ramp would come back faster.

At the mouth of a goal a ramp ends with an upright face: it stops a ball that would roll onto the ramp from the side.

`k`: the league's constants.
"""

from __future__ import annotations

from math import sqrt

from soccer_env.compiled import compiled
from soccer_env.leagues.league import AHEAD_OF_RAMP
from soccer_env.physics.engine.memory import (
    BODY_MASS_INVERSE,
    BODY_SHIFT_X,
    BODY_SHIFT_Y,
    BODY_VX,
    BODY_VY,
    BODY_X,
    BODY_Y,
    number_at,
    store,
)

GRAVITY = 9.81  # [m/s2]
IN_PLAN = 0.5  # [1] sin 45 cos 45: share of gravity that acts in plan
OFF_END = 1e-6  # [m] before the end of a ramp at which it stops a ball: rounding does not put that on the ramp
CLIMB = 4.0  # [1] 1 / cos4 45: how much more a climbing ball is slowed than a returning one is driven


@compiled
def way_up_ends(x, y, k):
    """Return how far beyond the foot of the ramp before a goal line a ball at x, y is [m]; 0 or less: not on it.

    There is no ramp in the mouths of the goals.
    """
    if k.pitch_ramp <= 0.0 or abs(y) <= 0.5 * k.pitch_goal_width:
        return 0.0
    return abs(x) - 0.5 * k.pitch_length + k.pitch_ramp + AHEAD_OF_RAMP * k.ball_radius


@compiled
def way_up_sides(y, k):
    """Return how far beyond the foot of the ramp before a touchline a ball at y is [m]; 0 or less: not on it."""
    if k.pitch_ramp <= 0.0:
        return 0.0
    return abs(y) - 0.5 * k.pitch_width + k.pitch_ramp + AHEAD_OF_RAMP * k.ball_radius


@compiled
def roll_off_ramps(solver, k, dt):
    """Slow a ball that climbs the ramps before boards, and drive back a ball that lies there, for dt [s].

    Return how far it is beyond where it turned, along both axes [m, m]. A ball in a corner touches two ramps.
    """
    beyond_x = beyond_y = 0.0
    if k.pitch_ramp <= 0.0:
        return beyond_x, beyond_y
    ball = solver.ball
    x, y = number_at(ball + BODY_X), number_at(ball + BODY_Y)
    up_end, up_side = way_up_ends(x, y, k), way_up_sides(y, k)
    if (up_end <= 0.0 and up_side <= 0.0) or number_at(ball + BODY_MASS_INVERSE) < 0.5 * solver.ball_lightness:
        return beyond_x, beyond_y  # the floor, or a ball that the referee holds
    slope = GRAVITY * IN_PLAN / (1.0 + k.ball_shell)  # [m/s2]
    if up_end > 0.0:
        speed, over = number_at(ball + BODY_VY), abs(y) - 0.5 * k.pitch_goal_width + OFF_END
        if speed * y > 0.0 and over <= abs(speed) * dt + OFF_END:  # out of the mouth
            store(ball + BODY_VY, 0.0)
            solver.roll_y -= speed
            return beyond_x, over if y > 0.0 else -over
        speed, end = number_at(ball + BODY_VX), 1.0 if x > 0.0 else -1.0
        turned, beyond = roll_on_ramp(end * speed, up_end, slope, dt)
        store(ball + BODY_VX, end * turned)
        solver.roll_x += end * turned - speed
        beyond_x = end * beyond
    if up_side > 0.0:
        speed, end = number_at(ball + BODY_VY), 1.0 if y > 0.0 else -1.0
        turned, beyond = roll_on_ramp(end * speed, up_side, slope, dt)
        store(ball + BODY_VY, end * turned)
        solver.roll_y += end * turned - speed
        beyond_y = end * beyond
    return beyond_x, beyond_y


@compiled
def put_back_on_ramp(ball, beyond_x, beyond_y):
    """Put a ball that touches nothing back to where it turned on a ramp."""
    if beyond_x != 0.0:
        x = number_at(ball + BODY_X) - beyond_x
        store(ball + BODY_X, x)
        store(ball + BODY_SHIFT_X, x)
    if beyond_y != 0.0:
        y = number_at(ball + BODY_Y) - beyond_y
        store(ball + BODY_Y, y)
        store(ball + BODY_SHIFT_Y, y)


@compiled
def roll_on_ramp(speed, up, slope, dt):
    """Return a ball's speed up a ramp [m/s] at the end of a substep, and how far it is beyond where it turned [m].

    `speed`: at which it has moved; `up`: how far it is beyond the foot [m]; `slope`: what drives it back [m/s2].
    """
    if speed <= 0.0:
        return max(speed - slope * dt, -sqrt(speed * speed + 2.0 * slope * up)), 0.0
    climbed = min(speed * dt, up)
    left = speed * speed - 2.0 * CLIMB * slope * climbed
    if left > 0.0:
        return sqrt(left), 0.0
    return 0.0, climbed - speed * speed / (2.0 * CLIMB * slope)
