"""A goalkeeper's block: it lies down on its chest with its forelegs spread, and cannot walk meanwhile.  MS53

Asked for by the kick of a legged goalkeeper's command while the ball is out of its kicker's reach, in leagues whose
`Block` says how. The motion runs off once it has begun, at constant speeds as joints have them:

    spread   1      ____________
                   /            \
             0    /              \
               raise    hold    recover         kick_clock counts down to 0, kick_strength is 0

At spread 1 a foreleg is a straight line from shoulder to paw, seen from above; on the way there the part of it that is
low enough for a ball grows from the paw inwards. Left out: the head, which keeps its height above the floor.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.physics.gait import LEGS, TIPS, most_swing, paw_offset, stance


@compiled
def may_block(robot, k):
    """Tell whether a robot asks for a block that it can start: a goalkeeper whose kicker does not reach the ball."""
    asks = robot.command.kick > 0.0 and robot.command.kick >= k.kicker_least
    able = robot.active == 1 and robot.fallen <= 0.0 and robot.keeper == 1 and k.block_raise_time > 0.0
    return asks and able and robot.has_ball == 0


@compiled
def begin_block(robot, k):
    """Start the motion."""
    robot.kick_clock = k.block_raise_time + k.block_hold_time + k.block_recover_time
    robot.kick_strength = 0.0


@compiled
def is_blocking(robot, k):
    """Tell whether a robot is in a block, its legs on their way included."""
    return k.block_raise_time > 0.0 and robot.kick_clock > 0.0 and robot.kick_strength == 0.0


@compiled
def spread_of(robot, k, later):
    """Return how far a robot's forelegs are spread a time [s] from now: 0 not at all, 1 as far as they go."""
    if not is_blocking(robot, k):
        return 0.0
    left = robot.kick_clock - later
    gone = k.block_raise_time + k.block_hold_time + k.block_recover_time - left
    return clip(min(gone / k.block_raise_time, left / k.block_recover_time), 0.0, 1.0)


@compiled
def paw_out(k, leg, spread, handedness):
    """Return how far a block takes a paw off its stance [m, m], robot frame."""
    if leg >= TIPS:
        return 0.0, 0.0
    side = handedness if leg == 0 else -handedness
    return spread * (k.block_paw_x - k.body_tip_x), side * spread * (k.block_paw_y - k.body_tip_y)


@compiled
def paws_off_stance(robots, k, handedness, paws):
    """Write how far the paws of robots (R,) are off their stance [m], by their stroke and by a block, into (R, 4, 2).

    Left fore, right fore, left hind, right hind, in a mirrored match as well, where legs are numbered the other way.
    """
    for r in range(robots.shape[0]):
        spread = spread_of(robots[r], k, 0.0)
        for leg in range(LEGS):
            x, y = paw_offset(robots[r], k, leg, handedness)
            out_x, out_y = paw_out(k, leg, spread, handedness)
            place = leg if handedness > 0.0 else leg ^ 1
            paws[r, place, 0], paws[r, place, 1] = x + out_x, y + out_y


@compiled
def leg_back(k, leg, spread, handedness):
    """Return the vector [m, m] from a paw to the other end of what a ball meets of its leg, robot frame."""
    side = handedness if leg == 0 else -handedness
    return spread * (k.block_shoulder_x - k.block_paw_x), side * spread * (k.block_shoulder_y - k.block_paw_y)


@compiled
def share_along(x, y, leg_x, leg_y):
    """Return at which share of a leg, a vector from its paw, the point nearest to x, y lies, seen from the paw [m]."""
    size = leg_x * leg_x + leg_y * leg_y
    return clip((x * leg_x + y * leg_y) / size, 0.0, 1.0) if size > 0.0 else 0.0


@compiled
def forelegs_gap(robot, k, ahead, left, handedness, swings):
    """Return the distance [m] of a point, robot frame, from the forelegs of a robot that blocks.

    In their stroke if it counts (swings 1), or in the middle of it (0).
    """
    spread = spread_of(robot, k, 0.0)
    gap = 1e9
    for leg in range(TIPS):
        x, y = stance(k, leg, handedness)
        swing_x, swing_y = paw_offset(robot, k, leg, handedness)
        out_x, out_y = paw_out(k, leg, spread, handedness)
        x, y = ahead - x - out_x - swings * swing_x, left - y - out_y - swings * swing_y
        leg_x, leg_y = leg_back(k, leg, spread, handedness)
        share = share_along(x, y, leg_x, leg_y)
        gap = min(gap, length(x - share * leg_x, y - share * leg_y) - k.body_tip_radius)
    return gap


@compiled
def most_reach(k):
    """Return the greatest distance [m] of a robot's outline from its origin, in a block if the league has one."""
    if k.block_raise_time <= 0.0:
        return k.body_reach
    return max(k.body_reach, length(k.block_paw_x, k.block_paw_y) + k.body_tip_radius)


@compiled
def most_reach_walking(k):
    """Return the same with legs in their stroke [m]."""
    return max(k.body_reach + most_swing(k), most_reach(k))
