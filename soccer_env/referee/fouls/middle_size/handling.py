"""Limits for a robot with the ball: it does not enclose it, go back with it, or dribble it without end.

The rules of the middle size, remembered: at most a third of the ball's diameter lies within the convex hull of a
robot, except for a moment to stop the ball; a robot goes back with the ball at most 0.5 m. The limit of 3 m for
dribbling came later. Assumed: the time for which more of the ball may lie within the hull. A robot that an opponent
pushes back while its wheels drive forward does not go back.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import cosine_and_sine, into_frame, length

FAIR, SURROUNDS, DRIBBLES = 0, 1, 2
FREE = 2.0  # [ball radii] gap between robot and ball at which the robot has lost the ball, assumed


@inlined
def find_handling(ball, robots, k):
    """Run the clocks of handling; return the row of an offender, or -1, and its offence."""
    row, what = -1, FAIR
    if k.rules_handling == 0 and k.rules_dribble_limit == 0:
        return row, what
    near = k.body_reach + (1.0 + FREE) * k.ball_radius
    for r in range(robots.shape[0]):
        x, y = ball.x - robots[r].x, ball.y - robots[r].y
        if robots[r].active == 0 or x * x + y * y > near * near:
            robots[r].handling = robots[r].backed = robots[r].dribbled = 0.0
            continue
        offence = judge_handling_robot(robots[r], k, x, y)
        if offence != FAIR:
            row, what = r, offence
    return row, what


@compiled
def judge_handling_robot(robot, k, x, y):
    """Run the clocks of a robot near the ball; return its offence."""
    cosine, sine = cosine_and_sine(robot.heading)
    ahead, left = into_frame(x, y, cosine, sine)
    deep = ball_share_within(k, ahead, left) > k.rules_handling_share
    robot.handling = robot.handling + k.dt if deep else 0.0
    if robot.has_ball == 1:
        speed, _ = into_frame(robot.vx, robot.vy, cosine, sine)
        robot.backed += k.dt * max(min(-speed, -robot.walk.forward), 0.0)
        robot.dribbled += k.dt * length(robot.vx, robot.vy)
    late = robot.handling >= k.rules_handling_time - 0.5 * k.dt
    if k.rules_handling == 1 and (late or robot.backed > k.rules_handling_back):
        return SURROUNDS
    if k.rules_dribble_limit == 1 and robot.dribbled > k.rules_dribble_distance:
        return DRIBBLES
    return FAIR


@compiled
def ball_share_within(k, ahead, left):
    """Return the share of the ball's diameter that lies within a robot's convex hull, seen from its front.

    The front of the hull is the line that touches both tips of the guide; a ball within it lies between them.
    """
    if abs(left) > k.body_tip_y or ahead < k.body_disc_x:
        return 0.0
    depth = k.body_tip_x + k.body_tip_radius - (ahead - k.ball_radius)
    return max(depth, 0.0) / (2.0 * k.ball_radius)
