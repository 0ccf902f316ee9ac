"""Robots that drive into opponents: charging, and charging the goalkeeper.

FIFA's Law 12 of 2005, as far as a referee of robots can see it. Driving into an opponent hard, or for longer than a
moment, is a foul; a robot that stands, or is run into, is never guilty. The robot of each team nearest to the ball may
fight for the ball. No robot may drive into the goalkeeper in its goal area. Speeds and times are assumed.

The speed of driving into a robot is the wheels' speed towards it, less the speed at which that robot drives away.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import cosine_and_sine, length, out_of_frame
from soccer_env.physics.contacts import touches
from soccer_env.referee.areas import in_goal_area

NEVER, CHARGES, CHARGES_HARD, CHARGES_KEEPER = 0, 1, 2, 3


@inlined
def find_charging(match, ball, robots, robot_events, touching, k):
    """Run the clocks of charging; return the row of the worst offender, or -1, and its offence."""
    row, worst = -1, NEVER
    if k.rules_charging == 0 and k.rules_keeper_charge == 0:
        return row, worst
    for r in range(robots.shape[0]):
        offence = NEVER
        if robot_events[r].collision == 1 and robots[r].active == 1:
            offence = judge_charging_robot(match, ball, robots, touching, r, k)
        elif robots[r].charging > 0.0:
            robots[r].charging = max(robots[r].charging - k.dt, 0.0)
        if offence > worst:
            row, worst = r, offence
    return row, worst


@compiled
def judge_charging_robot(match, ball, robots, touching, r, k):
    """Return the offence of robot r against the opponents that it touches."""
    offence, speed = NEVER, 0.0
    for other in range(robots.shape[0]):
        if robots[other].team == robots[r].team or robots[other].active == 0:
            continue
        into = charging_speed(robots[r], robots[other], k)
        if into < k.rules_charging_speed or not touches(touching, r, other):
            continue
        keeper = robots[other].keeper == 1 and in_goal_area(match, robots[other], robots[other].team, k)
        if keeper and k.rules_keeper_charge == 1:
            offence = CHARGES_KEEPER
        speed = max(speed, into)
    if speed == 0.0 or fights_for_ball(ball, robots, r, k):
        robots[r].charging = max(robots[r].charging - k.dt, 0.0)
        return offence
    fresh = robots[r].charging == 0.0
    robots[r].charging += k.dt
    if offence == NEVER and k.rules_charging == 1:
        if fresh and speed >= k.rules_charging_hard:
            offence = CHARGES_HARD
        elif robots[r].charging >= k.rules_charging_time - 0.5 * k.dt:
            offence = CHARGES
    return offence


@compiled
def charging_speed(robot, other, k):
    """Return the speed at which a robot drives into another [m/s]; 0 if they are far apart."""
    x, y = other.x - robot.x, other.y - robot.y
    away = length(x, y)
    if away > 2.0 * k.body_reach + k.dt * k.drive_forward or away < 1e-6:
        return 0.0
    vx, vy = wanted_velocity(robot)
    other_vx, other_vy = wanted_velocity(other)
    return (vx * x + vy * y - max(other_vx * x + other_vy * y, 0.0)) / away


@compiled
def wanted_velocity(robot):
    """Return the velocity that a robot's legs or wheels want [m/s, field frame]."""
    return out_of_frame(robot.walk.forward, robot.walk.left, *cosine_and_sine(robot.heading))


@compiled
def fights_for_ball(ball, robots, r, k):
    """Tell whether robot r is its team's nearest to the ball, and near enough to fight for it."""
    own = length(robots[r].x - ball.x, robots[r].y - ball.y)
    if own > k.rules_charging_exempt:
        return False
    for mate in range(robots.shape[0]):
        same = mate != r and robots[mate].team == robots[r].team and robots[mate].active == 1
        if same and length(robots[mate].x - ball.x, robots[mate].y - ball.y) < own:
            return False
    return True
