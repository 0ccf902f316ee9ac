"""Follow the ball from robot to robot: shots, saves, passes, interceptions.

A ball is on its way (in flight) from a kick until a robot plays it again. A push starts a flight as well if it leaves
the ball free, faster than robots move and faster than the weakest kick: a dribbled ball rolls more slowly.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, length
from soccer_env.leagues.robot import DRIVE_KINDS
from soccer_env.statistics.maps import note_shot
from soccer_env.statistics.records import LONG_AGO, Aim, Outcome

GAIT = DRIVE_KINDS["gait"]
ELSEWHERE, AT_GOAL, ON_TARGET = int(Aim.ELSEWHERE), int(Aim.AT_GOAL), int(Aim.ON_TARGET)
OFF_TARGET, SAVED, BLOCKED = int(Outcome.OFF_TARGET), int(Outcome.SAVED), int(Outcome.BLOCKED)
FREE = 0.25  # [s] without a touch after which a ball is free, assumed
PASS_LEGS, PASS_WHEELS = 0.3, 1.0  # [m] least length of a pass
BESIDE = 0.25  # [1] of the goal's width: a ball that misses a post by more is no shot, assumed
SWING = 0.5  # [s] after a kick in which touches by the kicker belong to the kick, assumed
DEFLECTED = 1.0  # [s] after the first touch by another robot in which a goal still counts for the kick, assumed
LONGEST = 5.0  # [s] of the longest flight, assumed


@compiled
def follow_ball(match, ball, robot, row, events, k, tally, trail):
    """Follow the ball in a control step; `row` is the row of the `robot` that touched the ball, or -1."""
    step = match.step
    if row >= 0:
        note_touch(step, robot, row, events.ball_x, events.ball_y, k, tally, trail)
        if trail.kicker >= 0:
            begin_flight(match, ball, trail.kicker, trail.kicker_team, events, k, tally, trail)
            trail.kicker = -1
    elif trail.player >= 0 and trail.flight < 0 and is_freed_by_push(step, ball, k, trail):
        begin_flight(match, ball, trail.player, trail.player_team, events, k, tally, trail)
    if trail.flight >= 0 and is_flight_over(step, k, trail):
        end_flight(tally, trail)


@compiled
def is_freed_by_push(step, ball, k, trail):
    """Tell whether the ball has just come free after a push as fast as a kick, which is no dribble."""
    least = max(k.drive_forward, k.kicker_slowest)
    return ball.vx * ball.vx + ball.vy * ball.vy > least * least and step - trail.touched == seconds_to_steps(FREE, k)


@compiled
def seconds_to_steps(seconds, k):
    """Convert a time [s] to control steps, rounded."""
    return int(seconds / k.dt + 0.5)


@compiled
def is_flight_over(step, k, trail):
    """Tell whether the ball's flight has lasted too long, in total or since a deflection."""
    return step - trail.flight_step > seconds_to_steps(LONGEST, k) or (
        trail.deflected != LONG_AGO and step - trail.deflected > seconds_to_steps(DEFLECTED, k)
    )


@compiled
def note_touch(step, robot, row, x, y, k, tally, trail):
    """Record that a robot touches the ball at x, y [m, field frame], and count its pass, save or block."""
    if trail.player >= 0 and trail.player != row:
        count_received_pass(step, robot.team, row, x, y, k, tally, trail)
    if trail.flight >= 0 and row != trail.flight:
        if trail.deflected == LONG_AGO:
            trail.deflected = step
            keeper = robot.keeper == 1 and robot.team != trail.flight_team
            trail.saved = 1 if keeper and trail.aim == ON_TARGET else 0
            if trail.shot >= 0:
                tally.maps.shots[trail.shot].outcome = SAVED if trail.saved == 1 else BLOCKED
    elif trail.flight >= 0 and step - trail.flight_step > seconds_to_steps(SWING, k):
        end_flight(tally, trail)
    trail.player, trail.player_team, trail.touched = row, robot.team, step
    trail.played_x, trail.played_y = x, y
    trail.since_restart[robot.team] |= 1 << row


@compiled
def count_received_pass(step, team, row, x, y, k, tally, trail):
    """Count a pass that reaches a robot (row), a mate or an opponent; a shot does not count as a pass."""
    least = PASS_LEGS if k.drive_kind == GAIT else PASS_WHEELS
    x, y = x - trail.played_x, y - trail.played_y
    shot = trail.flight == trail.player and trail.aim != ELSEWHERE
    if shot or step - trail.touched < seconds_to_steps(FREE, k) or x * x + y * y <= least * least:
        return
    tally.passes_tried[trail.player_team] += 1
    tally.maps.passes[trail.player, row] += 1
    if team == trail.player_team:
        tally.passes[team] += 1
    else:
        tally.interceptions[team] += 1


@compiled
def begin_flight(match, ball, row, team, events, k, tally, trail):
    """Begin a flight of the ball, played by the robot in row `row`; count the shot if it is one."""
    if trail.flight >= 0:
        end_flight(tally, trail)
    trail.flight, trail.flight_team, trail.flight_step = row, team, match.step
    trail.deflected, trail.saved = LONG_AGO, 0
    trail.aim = ELSEWHERE
    if events.restart == 0:
        trail.aim = predict_aim(ball, attack_direction(match, team), k)
    trail.shot = -1
    if trail.aim != ELSEWHERE:
        tally.shots[team] += 1
        note_shot(match, row, team, OFF_TARGET, tally, trail)
    if trail.aim == ON_TARGET:
        tally.on_target[team] += 1


@compiled
def end_flight(tally, trail):
    """End the ball's flight; count a save if the goalkeeper was first to touch a shot on target."""
    if trail.flight >= 0 and trail.saved == 1:
        tally.saves[1 - trail.flight_team] += 1
    trail.flight, trail.saved = -1, 0


@compiled
def predict_aim(ball, direction, k):
    """Predict where an untouched ball rolls (Aim), for a team that attacks in a direction (+1 or -1 along x).

    It slides at mu g until it rolls, at v less shell / (1 + shell) of its slip, and then slows down by the rolling
    resistance; the path is taken as straight.
    """
    ahead = direction * ball.vx
    if ahead <= 0.0:
        return ELSEWHERE
    way = 0.5 * k.pitch_length + k.ball_radius - direction * ball.x
    share = k.ball_shell / (1.0 + k.ball_shell)
    later_x = ball.vx - share * (ball.vx - ball.roll_x)
    later_y = ball.vy - share * (ball.vy - ball.roll_y)
    later = length(later_x, later_y)
    squared = ball.vx * ball.vx + ball.vy * ball.vy
    reach = max(squared - later * later, 0.0) / (2.0 * k.ball_sliding) + later * later / (2.0 * k.ball_rolling)
    if way > reach * ahead / length(ball.vx, ball.vy):
        return ELSEWHERE
    y = abs(ball.y + way * ball.vy / ahead)
    if y < 0.5 * k.pitch_goal_width:
        return ON_TARGET
    return AT_GOAL if y < (0.5 + BESIDE) * k.pitch_goal_width else ELSEWHERE
