"""Find robots that walk into opponents, the basis of all rules about pushing.

A robot pushes an opponent when the two touch and the walk of its legs leads into the opponent. The motion of its body
does not count: a robot that is shoved, or turns on the spot, pushes nobody.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import attack_direction, cosine_and_sine, length, out_of_frame
from soccer_env.physics.contacts import TOUCH_GAP, touches
from soccer_env.referee.fouls.legged.areas import FEET, in_area, is_inside

PRESS = 0.25  # [1] of the top speed: a walk towards an opponent above this leads into it, assumed
PLAYER, KEEPER = 1, 2  # the pushed robot: any opponent, a goalkeeper that keeps its goal


@inlined
def note_pushes(match, ball, robots, robot_events, touching, k):
    """Mark robots that push an opponent, or a goalkeeper through the ball, and mark the pushed robots."""
    near = 2.0 * k.body_reach + TOUCH_GAP
    for r in range(robots.shape[0]):
        if robot_events[r].collision == 1:
            for other in range(r + 1, robots.shape[0]):
                if robot_events[other].collision == 0 or robots[r].team == robots[other].team:
                    continue
                x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
                if x * x + y * y < near * near and touches(touching, r, other):
                    note_push(match, ball, robots, robot_events, r, other, k)
                    note_push(match, ball, robots, robot_events, other, r, k)
        if robots[r].keeper == 1 and robot_events[r].touch == 1:
            note_pushes_through_ball(match, ball, robots, robot_events, r, k)


@compiled
def note_push(match, ball, robots, robot_events, r, other, k):
    """Mark robot r if it walks into an opponent that it touches."""
    if walks_into(robots[r], robots[other], k):
        keeper = robots[other].keeper == 1 and keeps_goal(match, ball, robots[other], robots[r], k)
        robot_events[r].pushes = max(robot_events[r].pushes, KEEPER if keeper else PLAYER)
        robot_events[other].pushed = 1


@compiled
def note_pushes_through_ball(match, ball, robots, robot_events, keeper, k):
    """Mark robots that push a goalkeeper in its own area through the ball that both touch."""
    for r in range(robots.shape[0]):
        if robots[r].team == robots[keeper].team or robot_events[r].touch == 0 or robot_events[r].pushes == KEEPER:
            continue
        x, y = ball.x - robots[r].x, ball.y - robots[r].y
        between = x * (robots[keeper].x - ball.x) + y * (robots[keeper].y - ball.y) > 0.0
        through = between and walks_into(robots[r], robots[keeper], k)
        if through and keeps_goal(match, ball, robots[keeper], robots[r], k):
            robot_events[r].pushes = KEEPER
            robot_events[keeper].pushed = 1


@compiled
def keeps_goal(match, ball, keeper, attacker, k):
    """Tell whether an attacker may not push a goalkeeper: one of its feet is in its area, and the ball or the attacker.

    The attacker is in the area with two feet. A goalkeeper that duels for a ball outside its area, with an opponent
    outside it, is pushed like any player.
    """
    end = -attack_direction(match, keeper.team)
    if not in_area(keeper, k, end, 1):
        return False
    return is_inside(ball.x, ball.y, k, end) or in_area(attacker, k, end, FEET)


@compiled
def walks_into(robot, other, k):
    """Tell whether the walk of a robot leads it towards another."""
    if robot.stands == 1:
        return False
    return walk_speed_towards(robot, other) > PRESS * k.drive_forward


@compiled
def walk_speed_towards(robot, other):
    """Return the component of a robot's walk towards another robot [m/s]."""
    x, y = other.x - robot.x, other.y - robot.y
    walk_x, walk_y = out_of_frame(robot.walk.forward, robot.walk.left, *cosine_and_sine(robot.heading))
    return (walk_x * x + walk_y * y) / max(length(x, y), 1e-6)


@compiled
def run_clock(clock, runs, dt):
    """Return a clock [s] advanced by dt if it runs, else turned back by dt towards zero."""
    return clock + dt if runs else max(clock - dt, 0.0)
