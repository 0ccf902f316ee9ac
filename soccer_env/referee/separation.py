"""Pull apart robots that have collided and do not come free, so that neither side gains.  [Sacks 2001, 1]  MS55

"The referee can, in many circumstances, separate robots that have collided after a set time". Unlike the paper, which
does not name the circumstances, the referee always does so; the set time is assumed. The ball stays, and play goes on.

Of two opponents the attacker is moved: the robot whose team attacks the goal of the half in which the ball lies. There
only the defender could lose a goal by being moved. A goalkeeper in its own penalty area is never moved; then the other
robot is, wherever the ball lies. Possession does not count: an attack that got nowhere for so long has no claim to go
on, and a defender in its way keeps its place.

The robot is moved to the nearest free place at the rules' distance from the opponent, no nearer to the goal that it
attacks, and no nearer to the ball within that distance. No other robot is moved.

Of two team-mates whose legs hold each other the robot farther from the ball is moved, just far enough to be free;
team-mates that merely push each other are left alone.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, length
from soccer_env.physics.contacts import touches
from soccer_env.referee.areas import in_penalty_area
from soccer_env.referee.places import HAIR, MARGIN, assign_free_places, empty_bans
from soccer_env.referee.restarts import keep_present_pose, put_robot


@compiled
def watch_contacts(robots, robot_events, touching, k):
    """Count each robot's time in contact with an opponent or in the legs of a mate, less its time out of contact.

    Robots that push each other lose contact for moments, which does not free them. `touching`: see `find_collisions`.
    """
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot_events[r].collision == 1 and (touches_opponent(robots, touching, r, k) or in_legs_of_mate(robots, r)):
            robot.locked += k.dt
        elif robot.locked > 0.0:
            robot.locked = max(robot.locked - k.dt, 0.0)


@compiled
def touches_opponent(robots, touching, r, k):
    """Tell whether robot r touches an opponent."""
    for other in range(robots.shape[0]):
        opponent = robots[other].team != robots[r].team
        if opponent and touches(touching, r, other) and is_near(robots[r], robots[other], k):
            return True
    return False


@compiled
def in_legs_of_mate(robots, r):
    """Tell whether robot r and a team-mate hold each other by the legs."""
    for other in range(robots.shape[0]):
        if other != r and robots[other].team == robots[r].team and legs_hold(robots, r, other):
            return True
    return False


@compiled
def legs_hold(robots, r, other):
    """Tell whether a leg of one of two robots is caught between the legs of the other."""
    caught = robots[r].caught_by == other + 1 or robots[other].caught_by == r + 1
    return caught and robots[r].active == 1 and robots[other].active == 1


@compiled
def is_near(robot, other, k):
    """Tell whether two active robots are near enough to touch."""
    x, y = other.x - robot.x, other.y - robot.y
    near = 2.0 * k.body_reach + MARGIN
    return other.active == 1 and robot.active == 1 and x * x + y * y < near * near


@compiled
def is_overdue(robot, k):
    """Tell whether a robot has been in contact for too long."""
    return robot.active == 1 and robot.locked >= k.rules_contact_time - 0.5 * k.dt


@compiled
def are_locked(robots, r, other, k):
    """Tell whether two robots have held each other for too long."""
    if r == other or not (is_overdue(robots[r], k) and is_overdue(robots[other], k)):
        return False
    if robots[r].team == robots[other].team:
        return legs_hold(robots, r, other)
    return is_near(robots[r], robots[other], k)


@compiled
def pull_apart(ball, robots, match, k):
    """Pull robots apart that have been in contact for too long; tell whether any robot was moved.  MS55"""
    count, overdue = robots.shape[0], False
    for r in range(count):
        overdue = overdue or is_overdue(robots[r], k)
    if not overdue:
        return False
    bans, settled, goal_gap = empty_bans(count, count + 1)
    settled[:] = True
    for r in range(count):
        keep_present_pose(robots[r])
        for other in range(count):
            if are_locked(robots, r, other, k) and has_to_go(match, ball, robots, r, other, k):
                settled[r] = False
                ban_near_robot(robots, bans, r, other, k)
    stays = settled.copy()
    for r in range(count):
        if not settled[r]:
            ban_near_ball(ball, robots[r], bans[r], k)
            side = attack_direction(match, robots[r].team)
            goal_gap[r] = length(robots[r].x - side * 0.5 * k.pitch_length, robots[r].y)
    assign_free_places(match, robots, settled, bans, goal_gap, k)
    moved = False
    for r in range(count):
        if not stays[r]:
            moved = True
            place_pulled_robot(robots, r, k)
    return moved


@compiled
def has_to_go(match, ball, robots, r, other, k):
    """Tell whether the referee has to move robot r, not the robot `other`, when the two hold each other."""
    robot, its = robots[r], robots[other]
    if robot.keeper == 1 and in_penalty_area(match, robot, robot.team, k):
        return False
    if its.keeper == 1 and in_penalty_area(match, its, its.team, k):
        return True
    away, its_away = length(robot.x - ball.x, robot.y - ball.y), length(its.x - ball.x, its.y - ball.y)
    if robot.team == its.team:
        return away > its_away or (away == its_away and r > other)
    attack = attack_direction(match, robot.team) * ball.x
    if attack == 0.0:  # on the halfway line: the robot farther from its own goal goes
        attack = attack_direction(match, robot.team) * (robot.x + its.x)
    return attack > 0.0


@compiled
def ban_near_robot(robots, bans, r, other, k):
    """Ban robot r from places too near to the robot `other`, from which the referee pulls it apart.

    Team-mates, who hold each other by the legs, only have to come free.
    """
    bans[r, other, 0], bans[r, other, 1] = robots[other].x, robots[other].y
    if robots[r].team == robots[other].team:
        bans[r, other, 2] = 2.0 * k.body_reach + MARGIN
    else:
        bans[r, other, 2] = k.rules_separation + k.body_reach


@compiled
def ban_near_ball(ball, robot, bans, k):
    """Ban a robot from places nearer to the ball than it was, within the rules' distance at a dropped ball."""
    ball_row = bans.shape[0] - 1
    clear = k.body_reach + k.ball_radius + MARGIN
    away = min(length(robot.x - ball.x, robot.y - ball.y) - HAIR, k.rules_separation + k.body_reach)
    bans[ball_row, 0], bans[ball_row, 1], bans[ball_row, 2] = ball.x, ball.y, max(away, clear)


@compiled
def place_pulled_robot(robots, r, k):
    """Put robot r at its new place, and clear the time in contact of robot r and of those it was pulled from.

    The other robots keep everything else: the referee has not moved them.
    """
    for other in range(robots.shape[0]):
        if are_locked(robots, r, other, k):
            robots[other].locked = 0.0
    put_robot(robots[r])
