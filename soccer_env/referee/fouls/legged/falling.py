"""Falling over: a robot that an opponent pushes may fall; it lies still and gets up, or is put on its feet.

The book: a fallen robot has 5 s to begin to get up; if it does not, it is put on the halfway line at once, without a
time penalty. A robot is down for the league's `drive.fall_time`.

Falls are drawn here: the probability is the impulse with which opponents walk into the robot (mass, thrust of the legs,
share of the top speed, time) times the league's `drive.fall` [1/(N s)]; the physics has no falls. The league has 0: no
source says how often an ERS-210 fell, and its four paws stand wider than it is high.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.random_numbers import draw_uniform
from soccer_env.referee.fouls.legged.contact import walk_speed_towards
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.types import Foul, RobotStream

FALLEN = int(Foul.FALLEN)
FALL = int(RobotStream.FALL)


@inlined
def judge_falling(match, robots, events, robot_events, k):
    """Draw falls of pushed robots, and whistle robots that lie for too long."""
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot.fallen > 0.0:
            lain = k.drive_fall_time - robot.fallen
            if lain > k.rules_fallen_time + 0.5 * k.dt:
                whistle(match, robots, events, robot_events, r, FALLEN)
        elif k.drive_fall > 0.0 and robot_events[r].pushed == 1:
            impulse = impulse_on(robots, robot_events, r, k)
            if draw_uniform(robot.noise, FALL) < k.drive_fall * impulse:
                robot.fallen = k.drive_fall_time
                robot.kick_clock = 0.0


@compiled
def impulse_on(robots, robot_events, r, k):
    """Return the impulse [N s] of opponents that walk into robot r in this step."""
    total, near = 0.0, 2.0 * k.body_reach + k.ball_radius
    for other in range(robots.shape[0]):
        x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
        if robots[other].team != robots[r].team and robot_events[other].pushes > 0 and x * x + y * y < near * near:
            share = max(walk_speed_towards(robots[other], robots[r]), 0.0) / k.drive_forward
            total += share * k.body_mass * k.drive_thrust * k.dt
    return total
