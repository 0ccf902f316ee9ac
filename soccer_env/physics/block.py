"""A goalkeeper's block: it lies down on its chest with its forelegs spread, and cannot walk meanwhile.  MS53

A legged goalkeeper blocks when its command asks for a kick and its kicker does not reach the ball, in leagues with a
`Block`. Once begun, the motion runs to its end, each joint at a constant speed:

    spread   1      ____________
                   /            \
             0    /              \
               raise    hold    recover         kick_clock counts down to 0, kick_strength is 0

At spread 1 a foreleg is a straight line from shoulder to paw, seen from above; before that the part of the leg that is
low enough to stop a ball grows from the paw inwards. The head keeps its height: lowering it is left out.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.physics.gait import LEGS, TIPS, most_swing, paw_offset, stance


@compiled
def may_block(robot, k):
    """Tell whether a robot asks for a block and can start one: a goalkeeper whose kicker does not reach the ball."""
    asks = robot.command.kick > 0.0 and robot.command.kick >= k.kicker_least
    able = robot.active == 1 and robot.fallen <= 0.0 and robot.keeper == 1 and k.block_raise_time > 0.0
    return asks and able and robot.has_ball == 0


@compiled
def begin_block(robot, k):
    """Start a block."""
    robot.kick_clock = k.block_raise_time + k.block_hold_time + k.block_recover_time
    robot.kick_strength = 0.0


@compiled
def is_blocking(robot, k):
    """Tell whether a robot is in a block, from its first motion to its last."""
    return k.block_raise_time > 0.0 and robot.kick_clock > 0.0 and robot.kick_strength == 0.0


@compiled
def foreleg_spread(robot, k, later):
    """Return how far a robot's forelegs will be spread after a time [s]: 0 not at all, 1 fully."""
    if not is_blocking(robot, k):
        return 0.0
    left = robot.kick_clock - later
    gone = k.block_raise_time + k.block_hold_time + k.block_recover_time - left
    return clip(min(gone / k.block_raise_time, left / k.block_recover_time), 0.0, 1.0)


@compiled
def paw_shift(k, leg, spread, handedness):
    """Return how far a block moves a paw from its stance [m, m], robot frame."""
    if leg >= TIPS:
        return 0.0, 0.0
    side = handedness if leg == 0 else -handedness
    return spread * (k.block_paw_x - k.body_tip_x), side * spread * (k.block_paw_y - k.body_tip_y)


@compiled
def paws_off_stance(robots, k, handedness, paws):
    """Write the offsets of the paws of robots (R,) from their stance [m], due to stroke and block, into (R, 4, 2).

    The order is left fore, right fore, left hind, right hind, also in a mirrored match, which numbers the right first.
    """
    for r in range(robots.shape[0]):
        spread = foreleg_spread(robots[r], k, 0.0)
        for leg in range(LEGS):
            x, y = paw_offset(robots[r], k, leg, handedness)
            out_x, out_y = paw_shift(k, leg, spread, handedness)
            place = leg if handedness > 0.0 else leg ^ 1
            paws[r, place, 0], paws[r, place, 1] = x + out_x, y + out_y


@compiled
def leg_vector(k, leg, spread, handedness):
    """Return the vector [m, m] from a paw to the upper end of the part of its leg that stops a ball, robot frame."""
    side = handedness if leg == 0 else -handedness
    return spread * (k.block_shoulder_x - k.block_paw_x), side * spread * (k.block_shoulder_y - k.block_paw_y)


@compiled
def nearest_leg_fraction(x, y, leg_x, leg_y):
    """Return where a leg is nearest to the point x, y: 0 at its paw, 1 at its upper end.
    The point x, y and the leg's upper end leg_x, leg_y [m] are relative to the paw.
    """
    size = leg_x * leg_x + leg_y * leg_y
    return clip((x * leg_x + y * leg_y) / size, 0.0, 1.0) if size > 0.0 else 0.0


@compiled
def forelegs_gap(robot, k, ahead, left, handedness, swings):
    """Return the distance [m] of a point, robot frame, from the forelegs of a blocking robot.

    With `swings` 1 the legs are at their present place in the stroke, with 0 in mid-stroke.
    """
    spread = foreleg_spread(robot, k, 0.0)
    gap = 1e9
    for leg in range(TIPS):
        x, y = stance(k, leg, handedness)
        swing_x, swing_y = paw_offset(robot, k, leg, handedness)
        out_x, out_y = paw_shift(k, leg, spread, handedness)
        x, y = ahead - x - out_x - swings * swing_x, left - y - out_y - swings * swing_y
        leg_x, leg_y = leg_vector(k, leg, spread, handedness)
        share = nearest_leg_fraction(x, y, leg_x, leg_y)
        gap = min(gap, length(x - share * leg_x, y - share * leg_y) - k.body_tip_radius)
    return gap


@compiled
def most_reach(k):
    """Return the greatest distance [m] of a robot's outline from its origin, blocking if the league has a block."""
    if k.block_raise_time <= 0.0:
        return k.body_reach
    return max(k.body_reach, length(k.block_paw_x, k.block_paw_y) + k.body_tip_radius)


@compiled
def most_reach_walking(k):
    """Return the greatest distance [m] of a robot's outline from its origin, at any point of the legs' stroke."""
    return max(k.body_reach + most_swing(k), most_reach(k))
