r"""The paws of a walking robot: a trot, in which diagonal pairs of legs swing in turn.  MS51

A cycle is a gait step. For half of it a paw stands on the ground while the body passes over it: seen from the body the
paw goes back from half a stroke ahead of its stance to half a stroke behind. For the other half it swings forward,
over the ground at twice the speed of the walk. The left forepaw and the right hind paw swing first, then the other two.
In a mirrored match (handedness -1) left and right change places, also in the numbers of the legs, so that a loop over
the legs does the mirrored thing.

    half a stroke ahead           /\          /\
    stance                       /  \        /  \      a paw that swings first
    half a stroke behind        /    \      /    \
                               0  1/2  1  3/2   2      gait steps

The paper's robots walk in steps of half a second, each of which shifts the robot as a whole (Sacks 2001, 4.3.2).
Assumed: robots trot, and paws go back and forth at constant speeds.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled

LEGS = 4  # left fore, right fore, left hind, right hind; mirrored: right fore first
TIPS = 2  # the forelegs, or the two tips of a body without legs


@compiled
def stance(k, leg, handedness):
    """Return the place of a leg in mid-stroke [m, m], robot frame."""
    side = handedness if leg % 2 == 0 else -handedness
    return (k.body_tip_x, side * k.body_tip_y) if leg < 2 else (k.body_hind_x, side * k.body_hind_y)


@compiled
def paw_offset(robot, k, leg, handedness):
    """Return the offset of a paw from its stance [m, m], robot frame, at the end of the control step.

    The stroke is the path of the ground under the stance in half a gait step; in a turn each paw has its own stroke.
    """
    x, y = stance(k, leg, handedness)
    half = stroke_place(robot.gait_phase, k.gait_steps, leg) * 0.25 * k.gait_steps * k.dt
    return half * (robot.walk.forward - robot.walk.turn * y), half * (robot.walk.left + robot.walk.turn * x)


@compiled
def stroke_place(phase, gait_steps, leg):
    """Return the place of a leg in its stroke, 1 fore to -1 hind, `phase` control steps into a gait step."""
    done = (phase % gait_steps) / gait_steps
    ahead = 4.0 * done - 1.0 if done <= 0.5 else 3.0 - 4.0 * done
    return ahead if leg == 0 or leg == 3 else -ahead


@compiled
def most_swing(k):
    """Return the greatest offset of a paw from its stance [m], at full speed and full turn rate; 0 without legs."""
    fastest = max(k.drive_forward, k.drive_backward, k.drive_sideways) + k.drive_turn * k.body_reach
    return 0.25 * k.gait_steps * k.dt * fastest if k.legs == 1 else 0.0
