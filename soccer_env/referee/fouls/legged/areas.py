"""Illegal defender: a field player in its own penalty area.  Illegal attacker: a robot that stays in the opponents'.

The book: only the goalkeeper may be in its team's penalty area. A field player with both feet in the area (two of four,
as in the legged books) is taken out for 30 s, wherever the goalkeeper is; a defender that an opponent pushed in is not.
The book gives no time; here the referee waits a second, assumed. A robot that an opponent or the referee put there has
time to walk out. A team that lines up without a goalkeeper has no such area.

No book at hand has an illegal attacker in the legged league: the rule exists, and is off.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import attack_direction, cosine_and_sine, point_of_frame
from soccer_env.physics.gait import LEGS, stance
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.referee.restarts import TO_WALK_OUT
from soccer_env.types import Foul

DEFENDER, ATTACKER = int(Foul.ILLEGAL_DEFENDER), int(Foul.ILLEGAL_ATTACKER)
FEET = 2  # of four: with so many a field player stands in the area


@inlined
def judge_areas(match, ball, robots, events, robot_events, k):
    """Whistle field players that stay in a penalty area that is forbidden to them."""
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot.active == 0 or robot.keeper == 1:
            continue
        foul = trespass_foul(match, ball, robots, r, k)
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
def trespass_foul(match, ball, robots, r, k):
    """Return the foul that a field player commits if it stays where it is, or 0."""
    robot, end = robots[r], -attack_direction(match, robots[r].team)
    if k.rules_illegal_defender == 1 and in_area(robot, k, end, FEET) and has_keeper(robots, robot.team):
        return DEFENDER
    if k.rules_illegal_attacker == 1 and in_area(robot, k, -end, FEET) and not is_inside(ball.x, ball.y, k, -end):
        return ATTACKER
    return 0


@compiled
def has_keeper(robots, team):
    """Tell whether a team lined up with a goalkeeper, active or not."""
    lined_up = False
    for r in range(robots.shape[0]):
        lined_up = lined_up or (robots[r].team == team and robots[r].keeper == 1)
    return lined_up


@compiled
def in_own_area(match, robot, k, feet):
    """Tell whether a robot has at least `feet` feet in its own penalty area or goal."""
    return in_area(robot, k, -attack_direction(match, robot.team), feet)


@compiled
def in_area(robot, k, end, feet):
    """Tell whether a robot has at least `feet` feet in the penalty area or goal at an end of the pitch (+1 or -1)."""
    line, side = 0.5 * k.pitch_length - k.pitch_penalty_depth, 0.5 * k.pitch_penalty_width
    if end * robot.x + k.body_reach < line or abs(robot.y) - k.body_reach > side:
        return False  # most robots, most of the time
    cosine, sine = cosine_and_sine(robot.heading)
    inside = 0
    for leg in range(LEGS):
        ahead, left = foot(k, leg)
        x, y = point_of_frame(robot.x, robot.y, ahead, left, cosine, sine)
        inside += 1 if is_inside(x, y, k, end) else 0
    return inside >= feet


@compiled
def foot(k, leg):
    """Return the place of a foot in mid-stroke [m, m], robot frame; without legs hind feet mirror the fore feet."""
    if leg < 2 or k.body_hind_y > 0.0:
        return stance(k, leg, 1.0)
    ahead, left = stance(k, leg - 2, 1.0)
    return -ahead, left


@compiled
def is_inside(x, y, k, end):
    """Tell whether a place lies in the penalty area or the goal at an end of the pitch; its lines belong to it."""
    return end * x >= 0.5 * k.pitch_length - k.pitch_penalty_depth and abs(y) <= 0.5 * k.pitch_penalty_width
