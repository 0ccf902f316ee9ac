"""Pull apart robots that have collided and do not come free, so that neither side gains.  [Sacks 2001, 1]  MS55

"The referee can, in many circumstances, separate robots that have collided after a set time". Unlike there it is in all
circumstances, for the paper does not say which, and the set time is assumed. The ball stays where it is and play goes
on.

Who is moved: of two opponents the attacker, whose team attacks the goal of the half in which the ball lies. There the
defender alone could lose a goal by being moved, and a goalkeeper in its own penalty area is never moved: then it is
the other, wherever the ball lies. Who has the ball does not count: an attack that got nowhere for so long has no claim
to go on, and a defender that stands in its way keeps its place.

Where to: the nearest free place at the rules' distance from the opponent, no nearer to the goal that the robot attacks
and no nearer to the ball, unless that is out of its reach already. Nobody else is touched.

Of two team-mates whose legs hold each other the one farther from the ball is set free likewise, as near as it can be;
team-mates that merely push each other are left alone.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import direction_of, length
from soccer_env.physics.contacts import touches
from soccer_env.referee.areas import in_penalty_area
from soccer_env.referee.places import HAIR, MARGIN, new_bans, settle
from soccer_env.referee.restarts import put_robot, stay


@compiled
def watch_contacts(robots, robot_events, touching, k):
    """Count for how long each robot has been in contact with an opponent or in the legs of a mate, less the time out.

    Robots that push against each other lose contact for moments, which does not free them. `touching` is what
    `find_collisions` found.
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
    """Tell whether two robots stand so near that they may touch."""
    x, y = other.x - robot.x, other.y - robot.y
    near = 2.0 * k.body_reach + MARGIN
    return other.active == 1 and robot.active == 1 and x * x + y * y < near * near


@compiled
def is_overdue(robot, k):
    """Tell whether a robot has been in contact for too long."""
    return robot.active == 1 and robot.locked >= k.rules_contact_time - 0.5 * k.dt


@compiled
def are_locked(robots, r, other, k):
    """Tell whether two robots hold each other for too long."""
    if r == other or not (is_overdue(robots[r], k) and is_overdue(robots[other], k)):
        return False
    if robots[r].team == robots[other].team:
        return legs_hold(robots, r, other)
    return is_near(robots[r], robots[other], k)


@compiled
def pull_apart(ball, robots, match, k):
    """Pull robots in contact for too long apart, to the rules' distance; tell whether anybody was moved.  MS55"""
    count, found = robots.shape[0], False
    for r in range(count):
        found = found or is_overdue(robots[r], k)
    if not found:
        return False
    bans, settled, goal_gap = new_bans(count, count + 1)
    settled[:] = True
    for r in range(count):
        stay(robots[r])
        for other in range(count):
            if are_locked(robots, r, other, k) and has_to_go(match, ball, robots, r, other, k):
                settled[r] = False
                ban_other(robots, bans, r, other, k)
    moved = settled.copy()
    for r in range(count):
        if not settled[r]:
            ban_ball(ball, robots[r], bans[r], k)
            side = direction_of(match, robots[r].team)
            goal_gap[r] = length(robots[r].x - side * 0.5 * k.pitch_length, robots[r].y)
    settle(match, robots, settled, bans, goal_gap, k)
    found = False
    for r in range(count):
        if not moved[r]:
            found = True
            release(robots, r, k)
    return found


@compiled
def has_to_go(match, ball, robots, r, other, k):
    """Tell whether it is robot r of two that hold each other that has to go."""
    robot, its = robots[r], robots[other]
    if robot.keeper == 1 and in_penalty_area(match, robot, robot.team, k):
        return False
    if its.keeper == 1 and in_penalty_area(match, its, its.team, k):
        return True
    away, its_away = length(robot.x - ball.x, robot.y - ball.y), length(its.x - ball.x, its.y - ball.y)
    if robot.team == its.team:
        return away > its_away or (away == its_away and r > other)
    attack = direction_of(match, robot.team) * ball.x
    if attack == 0.0:  # on the halfway line: the one that is farther from its own goal
        attack = direction_of(match, robot.team) * (robot.x + its.x)
    return attack > 0.0


@compiled
def ban_other(robots, bans, r, other, k):
    """Keep robot r from where it would stand too near to the one that it was pulled from.

    Of team-mates, who hold each other by the legs, so much is asked as sets them free.
    """
    bans[r, other, 0], bans[r, other, 1] = robots[other].x, robots[other].y
    if robots[r].team == robots[other].team:
        bans[r, other, 2] = 2.0 * k.body_reach + MARGIN
    else:
        bans[r, other, 2] = k.rules_separation + k.body_reach


@compiled
def ban_ball(ball, robot, bans, k):
    """Keep a robot from coming nearer to the ball than it was, within the distance that the rules ask of a drop."""
    ball_row = bans.shape[0] - 1
    clear = k.body_reach + k.ball_radius + MARGIN
    away = min(length(robot.x - ball.x, robot.y - ball.y) - HAIR, k.rules_separation + k.body_reach)
    bans[ball_row, 0], bans[ball_row, 1], bans[ball_row, 2] = ball.x, ball.y, max(away, clear)


@compiled
def release(robots, r, k):
    """Put robot r at its new place, and forget for how long it and those that it was pulled from have been in contact.

    The others stay as they are: the referee has not touched them.
    """
    for other in range(robots.shape[0]):
        if are_locked(robots, r, other, k):
            robots[other].locked = 0.0
    put_robot(robots[r])
