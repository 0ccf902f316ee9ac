"""Ball holding: a ball that is trapped for longer than 3 s, by a goalkeeper in its own area 5 s.

The book: a robot that leaves too little open space round the ball for more than 3 s is removed for 30 s. A goalkeeper
with a foot in its own area may hold the ball for 5 s, and is then put on the halfway line at once. Holds count as one
unless the robot lets go for about as long as it held. Half of the ball outside the robot's hull is enough space; a ball
between the forepaws of an ERS-210 always has it. So we count while the ball is trapped:

* the ball lies between the forepaws and goes along although the robot turns, steps aside or goes back instead of
  walking ahead. A robot that stands, for instance to kick, neither holds nor lets go;
* or no paw of an opponent could reach the ball: robot and boards cover it on all sides, whether or not the robot
  touches it, as in the book.

A ball that is pushed ahead is free to roll away, as in the paper's dribbling [Sacks 2001, 3.3], and a ball that an
opponent touches is not trapped. Unlike the book, a ball that no opponent is near is not held either: the book punishes
holding because others cannot play the ball, and a robot alone at a board keeps nobody off. The 50 cm that a robot may
carry the ball in the book are a rule of their own (`carrying`).

`k`: the league's constants.
"""

from math import cos, pi, sin

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import cosine_and_sine, length
from soccer_env.physics.contacts import outline_gap_of
from soccer_env.referee.fouls.legged.areas import in_own_area
from soccer_env.referee.fouls.legged.pushing import squared_ball_distance
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.types import Foul

HOLDING = int(Foul.HOLDING)
FREE, KEPT, TRAPPED = -1.0, 0.0, 1.0  # direction in which the clock runs
WALKS = 0.25  # [1] of a top speed, below which a robot stands, assumed
SIDES = 16  # directions from which a paw may reach the ball


@inlined
def judge_holding(match, ball, robots, events, robot_events, k):
    """Whistle robots that have held the ball for too long, or carried it too far."""
    reach = k.body_reach + k.ball_radius + 2.0 * k.body_tip_radius  # no paw fits between at this distance
    for r in range(robots.shape[0]):
        robot = robots[r]
        near = robot.active == 1 and squared_ball_distance(ball, robot) < reach * reach
        if k.rules_carrying == 1 and carries_too_far(robot, k):
            whistle(match, robots, events, robot_events, r, HOLDING)
        if not near and robot.holding == 0.0:
            continue
        way = judge_hold(ball, robots, r, robot_events, k) if near else FREE
        robot.holding = max(robot.holding + way * k.dt, 0.0)
        if (
            way == TRAPPED
            and k.rules_holding == 1
            and robot.holding > allowed_holding_time(match, robot, k) + 0.5 * k.dt
        ):
            whistle(match, robots, events, robot_events, r, HOLDING)


@compiled
def allowed_holding_time(match, robot, k):
    """Return the time [s] for which a robot may hold the ball at its present position."""
    keeps = robot.keeper == 1 and in_own_area(match, robot, k, 1)
    return k.rules_keeper_holding_time if keeps else k.rules_holding_time


@compiled
def judge_hold(ball, robots, r, robot_events, k):
    """Return whether a robot traps the ball, leaves it free, or neither: TRAPPED, FREE or KEPT."""
    kept_off, near = False, k.rules_holding_distance
    for other in range(robots.shape[0]):
        if robots[other].team != robots[r].team and robots[other].active == 1:
            if robot_events[other].touch == 1:
                return FREE
            kept_off = kept_off or squared_ball_distance(ball, robots[other]) < near * near
    if not kept_off:
        return FREE
    robot = robots[r]
    ahead = robot.walk.forward > WALKS * k.drive_forward
    if robot.has_ball == 1 and not ahead and turns_or_sidesteps(robot, k):
        return TRAPPED
    if is_covered(robot, ball, k):
        return TRAPPED
    return KEPT if robot.has_ball == 1 and not ahead else FREE


@compiled
def turns_or_sidesteps(robot, k):
    """Tell whether a robot turns, steps aside or goes back."""
    back = robot.walk.forward < -WALKS * k.drive_backward
    aside = abs(robot.walk.left) > WALKS * k.drive_sideways
    return back or aside or abs(robot.walk.turn) > WALKS * k.drive_turn


@compiled
def is_covered(robot, ball, k):
    """Tell whether a robot and the boards cover all sides of the ball, so that no other paw reaches it."""
    room = k.body_tip_radius + k.legs * k.pitch_board_foot
    far = k.ball_radius + k.body_tip_radius
    x, y = 0.5 * k.pitch_length - room - far, 0.5 * k.pitch_width - room - far
    if abs(ball.x) < x and abs(ball.y) < y:
        return False  # no board is near, and a robot alone cannot cover the ball
    cosine, sine = cosine_and_sine(robot.heading)
    for side in range(SIDES):
        angle = robot.heading + (side + 0.5) * 2.0 * pi / SIDES
        x, y = ball.x + far * cos(angle), ball.y + far * sin(angle)
        if has_room(x, y, room, k) and outline_gap_of(robot, k, x, y, cosine, sine) >= k.body_tip_radius:
            return False
    return True


@compiled
def has_room(x, y, room, k):
    """Tell whether a place is at least `room` [m] from all boards."""
    if abs(x) <= 0.5 * k.pitch_length - room:
        return abs(y) <= 0.5 * k.pitch_width - room
    return abs(y) <= 0.5 * k.pitch_goal_width - room and abs(x) <= 0.5 * k.pitch_length + k.pitch_goal_depth - room


@compiled
def carries_too_far(robot, k):
    """Tell whether a robot has carried the ball too far from the place where it took the ball."""
    if robot.active == 0 or robot.has_ball == 0:
        robot.carry_x, robot.carry_y = robot.x, robot.y
        return False
    return length(robot.x - robot.carry_x, robot.y - robot.carry_y) > k.rules_carrying_distance
