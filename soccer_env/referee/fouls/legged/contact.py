"""Who walks into whom: what all rules about pushing are built on.

A robot pushes an opponent when the two touch and the walk that its legs make leads it into the other. What its body
does is not asked: who is shoved pushes nobody, and who turns on the spot does not either.

`k`: the league's constants.
"""

from math import cos, sin

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import length, out_of_frame
from soccer_env.physics.contacts import TOUCH_GAP, touches
from soccer_env.referee.fouls.legged.areas import in_own_area

PRESS = 0.25  # [1] of the top speed, towards the other, above which a walk leads into it, assumed
PLAYER, KEEPER = 1, 2  # who is pushed: anybody, a goalkeeper in its own area


@inlined
def note_pushes(match, ball, robots, robot_events, touching, k):
    """Mark who walks into an opponent, and who is walked into; a goalkeeper also through the ball between the two."""
    near = 2.0 * k.body_reach + TOUCH_GAP
    for r in range(robots.shape[0]):
        if robot_events[r].collision == 1:
            for other in range(r + 1, robots.shape[0]):
                if robot_events[other].collision == 0 or robots[r].team == robots[other].team:
                    continue
                x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
                if x * x + y * y < near * near and touches(touching, r, other):
                    note_push(match, robots, robot_events, r, other, k)
                    note_push(match, robots, robot_events, other, r, k)
        if robots[r].keeper == 1 and robot_events[r].touch == 1:
            note_pushes_through_ball(match, ball, robots, robot_events, r, k)


@compiled
def note_push(match, robots, robot_events, r, other, k):
    """Mark robot r if it walks into an opponent that it touches."""
    if walks_into(robots[r], robots[other], k):
        keeper = robots[other].keeper == 1 and in_own_area(match, robots[other], k, 1)
        robot_events[r].pushes = max(robot_events[r].pushes, KEEPER if keeper else PLAYER)
        robot_events[other].pushed = 1


@compiled
def note_pushes_through_ball(match, ball, robots, robot_events, keeper, k):
    """Mark those who push a goalkeeper that is in its own area indirectly, through the ball that both touch."""
    for r in range(robots.shape[0]):
        if robots[r].team == robots[keeper].team or robot_events[r].touch == 0 or robot_events[r].pushes == KEEPER:
            continue
        x, y = ball.x - robots[r].x, ball.y - robots[r].y
        between = x * (robots[keeper].x - ball.x) + y * (robots[keeper].y - ball.y) > 0.0
        if between and walks_into(robots[r], robots[keeper], k) and in_own_area(match, robots[keeper], k, 1):
            robot_events[r].pushes = KEEPER
            robot_events[keeper].pushed = 1


@compiled
def walks_into(robot, other, k):
    """Tell whether the walk of a robot leads it towards another."""
    if robot.stands == 1:
        return False
    return press_of(robot, other) > PRESS * k.drive_forward


@compiled
def press_of(robot, other):
    """Return the part of a robot's walk towards another [m/s]."""
    x, y = other.x - robot.x, other.y - robot.y
    walk_x, walk_y = out_of_frame(robot.walk.forward, robot.walk.left, cos(robot.heading), sin(robot.heading))
    return (walk_x * x + walk_y * y) / max(length(x, y), 1e-6)


@compiled
def run_clock(clock, runs, dt):
    """Return a clock [s] that runs, or that runs back to zero: who lets go for as long as it pushed starts anew."""
    return clock + dt if runs else max(clock - dt, 0.0)
