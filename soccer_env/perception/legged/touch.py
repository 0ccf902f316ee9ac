"""The touch sensors of a legged robot: at head, chin, back and feet only.  [Sacks 2001, 1]  MS06

An ERS-210 has two pressure sensors on its head and a switch under the mouth, on the back and at each paw (touretzkyds/
Tekkotsu, Shared/ERS210Info.h; tekkotsu.org/robots/ERS2xx.html). None of them is on the outline with which robots run
into each other, so that a collision presses nothing: hence the paper uses the ball's velocity (3).

    head    nothing in a match presses it from above
    chin    a ball under the mouth. With the kinematics of the ERS-210 the lowest head stays above one on the ground
    back    whoever puts the robot down starts it with that switch: rule book of 2004, assumed for 2001
    feet    a paw's switch lies under it and is closed while the paw stands: remembered, unverified. All four of a robot
            that stands, two of one that trots, none of one that lies on its side. A board or a ball before a paw does
            not press it

`k`: the league's constants; `s`: settings of the sensors.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, from_polar, into_frame
from soccer_env.optics.head_camera import tilt_point

LEGS = 4
GAP = 0.004  # [m] a ball this near presses the switch, assumed: the gap of a touch


@compiled
def feel_touch(ball, robot, touch, k, s):
    """Compute the readings of a robot's touch sensors (TOUCH).  MS06"""
    touch.head = 0
    touch.chin = 1 if chin_touches_ball(ball, robot, k, s) else 0
    touch.back = robot.placed
    touch.feet = count_standing_paws(robot)


@compiled
def count_standing_paws(robot):
    """Return the number of paws on the ground: 4, 2 in a trot (one diagonal), 0 lying."""
    if robot.fallen > 0.0:
        return 0
    walks = robot.walk.forward != 0.0 or robot.walk.left != 0.0 or robot.walk.turn != 0.0
    return LEGS // 2 if walks else LEGS


@compiled
def chin_touches_ball(ball, robot, k, s):
    """Tell whether the ball touches the chin: the lower edge of the head's face, where the mouth is."""
    reach = k.ball_radius + GAP
    x, y = ball.x - robot.x, ball.y - robot.y
    near = s.neck_ahead + s.camera_ahead + s.head_size + reach
    if robot.fallen > 0.0 or x * x + y * y > near * near:
        return False
    below = s.camera_up - 0.5 * s.head_size
    level, steep = cosine_and_sine(robot.tilt)
    forward, height = tilt_point(s.camera_ahead, below, level, steep, s.neck_height)
    x, y = into_frame(x, y, *cosine_and_sine(robot.heading))
    ahead, left = from_polar(forward, robot.pan)
    x -= s.neck_ahead + ahead
    y -= left
    up = k.ball_radius - height
    return x * x + y * y + up * up <= reach * reach
