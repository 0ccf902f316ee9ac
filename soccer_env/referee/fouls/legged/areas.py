"""Illegal defender: a field player in its own penalty area.  Illegal attacker: one that camps in the opponents'.

The book: only the goalkeeper may be in its team's penalty area; a field player is in it with both feet (of four: two,
as in the legged books), whether or not the goalkeeper is there too, and is taken out for 30 s; not so a defender whom
an opponent pushed in. The book gives no time; a second passes here until the referee is sure, assumed. Whom an
opponent or the referee put there has time to walk out. A team that lines up without a goalkeeper has no such area.

None of the books at hand has an illegal attacker in the legged league: the rule is there, and off.

`k`: the league's constants.
"""

from math import cos, sin

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import direction_of, point_of_frame
from soccer_env.physics.gait import LEGS, stance
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.referee.restarts import TO_WALK_OUT
from soccer_env.types import Foul

DEFENDER, ATTACKER = int(Foul.ILLEGAL_DEFENDER), int(Foul.ILLEGAL_ATTACKER)
FEET = 2  # of four that make a field player stand in the area


@inlined
def judge_areas(match, ball, robots, events, robot_events, k):
    """Whistle field players that stay in a penalty area in which they may not."""
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot.active == 0 or robot.keeper == 1:
            continue
        foul = trespass_of(match, ball, robots, r, k)
        if foul == 0:
            robot.trespass = max(robot.trespass - k.dt, 0.0)
            continue
        robot.trespass += k.dt
        if robot_events[r].pushed == 1:
            robot.trespass = -TO_WALK_OUT
        limit = k.rules_illegal_defender_time if foul == DEFENDER else k.rules_illegal_attacker_time
        if robot.trespass > limit + 0.5 * k.dt:
            whistle(match, robots, events, robot_events, r, foul)


@compiled
def trespass_of(match, ball, robots, r, k):
    """Return the foul that a field player commits if it stays where it is, or 0."""
    robot, end = robots[r], -direction_of(match, robots[r].team)
    if k.rules_illegal_defender == 1 and in_area(robot, k, end, FEET) and has_keeper(robots, robot.team):
        return DEFENDER
    if k.rules_illegal_attacker == 1 and in_area(robot, k, -end, FEET) and not is_inside(ball.x, ball.y, k, -end):
        return ATTACKER
    return 0


@compiled
def has_keeper(robots, team):
    """Tell whether a team lined up with a goalkeeper, be it out or not."""
    found = False
    for r in range(robots.shape[0]):
        found = found or (robots[r].team == team and robots[r].keeper == 1)
    return found


@compiled
def in_own_area(match, robot, k, feet):
    """Tell whether a robot has at least so many feet in its own penalty area or goal."""
    return in_area(robot, k, -direction_of(match, robot.team), feet)


@compiled
def in_area(robot, k, end, feet):
    """Tell whether a robot has at least so many feet in the penalty area or goal at an end of the pitch (+1 or -1)."""
    line, side = 0.5 * k.pitch_length - k.pitch_penalty_depth, 0.5 * k.pitch_penalty_width
    if end * robot.x + k.body_reach < line or abs(robot.y) - k.body_reach > side:
        return False  # as most robots, most of the time
    cosine, sine = cos(robot.heading), sin(robot.heading)
    found = 0
    for leg in range(LEGS):
        ahead, left = foot(k, leg)
        x, y = point_of_frame(robot.x, robot.y, ahead, left, cosine, sine)
        found += 1 if is_inside(x, y, k, end) else 0
    return found >= feet


@compiled
def foot(k, leg):
    """Return where a foot stands in mid-stroke [m, m], robot frame; a body of one piece has hind feet like its fore."""
    if leg < 2 or k.body_hind_y > 0.0:
        return stance(k, leg, 1.0)
    ahead, left = stance(k, leg - 2, 1.0)
    return -ahead, left


@compiled
def is_inside(x, y, k, end):
    """Tell whether a place lies in the penalty area or the goal at an end of the pitch; its lines belong to it."""
    return end * x >= 0.5 * k.pitch_length - k.pitch_penalty_depth and abs(y) <= 0.5 * k.pitch_penalty_width
