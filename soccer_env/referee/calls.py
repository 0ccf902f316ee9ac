"""The referee's calls: touches, goals, out of play, stuck and dropped balls, the end of a half.

Each rule reads the truth of one match and either does nothing or notes an event and calls a restart, which
`referee.restarts` carries out. The direction in which home attacks makes one rule serve both teams.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.referee.fouls.goals import goal_counts, is_kick_off_shot, is_own_goal
from soccer_env.referee.restart_call import call_restart, other_team
from soccer_env.referee.shoot_out import begin_shoot_out, end_match, is_shoot_out_due, judge_penalty
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase

PLAY, OVER, DROP_BALL = int(Phase.PLAY), int(Phase.OVER), int(Phase.DROP_BALL)
KICK_OFF, THROW_IN = int(Phase.KICK_OFF), int(Phase.THROW_IN)
GOAL_KICK, CORNER_KICK = int(Phase.GOAL_KICK), int(Phase.CORNER_KICK)
ASIDE = 0.25  # [1] of the pitch's width, from the middle to a ball dropped after an annulled goal, assumed


@compiled
def judge_match(match, ball, robots, events, k, toucher):
    """Apply the rules to one match after a control step; `toucher`: row of the robot that touched the ball, or -1."""
    events.ball_x, events.ball_y = ball.x, ball.y
    match.clock += k.dt if match.shoot_out == 0 else 0.0
    match.phase_clock += k.dt
    if toucher >= 0:
        events.touch_team = robots[toucher].team
    if events.restart != 0:  # a foul was whistled: the ball is dead
        return
    if toucher >= 0:
        match.last_touch_team = robots[toucher].team
        match.last_touch_robot = toucher
        match.idle_clock = 0.0
    else:
        match.idle_clock += k.dt
    if match.placing == 0:
        if match.phase != PLAY:
            watch_restart(match, ball, events, k)
        if match.shoot_out > 0:
            in_goal, out = goal_scored(ball, k), out_of_play(ball, k)
            judge_penalty(match, ball, events, k, in_goal, out)
        else:
            judge_ball(match, ball, robots, events, k)
    if match.over == 0 and match.shoot_out == 0 and match.clock >= match.half_length - 0.5 * k.dt:
        end_half(match, events, k)


@compiled
def judge_ball(match, ball, robots, events, k):
    """Call a goal, a ball out of play, or a stuck ball."""
    if goal_scored(ball, k):
        judge_goal(match, ball, robots, events, k)
    elif k.walled == 0 and k.rules_out_of_play == 1 and out_of_play(ball, k):
        give_restart_for_out(match, ball, events, k)
    elif k.rules_dropped_ball == 1 and ball_stuck(match, ball, k):
        events.stuck = 1
        x, y = drop_place(ball, k)
        call_restart(match, events, DROP_BALL, NO_TEAM, x, y)


@compiled
def goal_scored(ball, k):
    """Tell whether the whole ball is over a goal line, between the posts."""
    return abs(ball.x) > 0.5 * k.pitch_length + k.ball_radius and abs(ball.y) < 0.5 * k.pitch_goal_width


@compiled
def out_of_play(ball, k):
    """Tell whether the whole ball is over a touchline or goal line."""
    return abs(ball.y) > 0.5 * k.pitch_width + k.ball_radius or abs(ball.x) > 0.5 * k.pitch_length + k.ball_radius


@compiled
def judge_goal(match, ball, robots, events, k):
    """Count a goal for the team that attacks the goal with the ball, or annul the goal."""
    scorer = HOME if (ball.x > 0.0) == (match.home_direction > 0.0) else AWAY
    if goal_counts(match, ball, robots, k, scorer):
        give_goal(match, events, k, scorer)
        return
    events.annulled = 1
    if is_kick_off_shot(match, k, scorer):
        call_restart(match, events, KICK_OFF, other_team(scorer), 0.0, 0.0)
    elif k.walled == 1:  # on the halfway line, as for a ball that is out: neither team gains
        call_restart(match, events, DROP_BALL, NO_TEAM, 0.0, (ASIDE if ball.y > 0.0 else -ASIDE) * k.pitch_width)
    elif is_own_goal(match, robots, scorer):
        give_corner(match, ball, events, k, scorer)
    else:
        give_goal_kick(match, ball, events, k, other_team(scorer))


@compiled
def give_goal(match, events, k, scorer):
    """Count a goal for a team; the other team kicks off."""
    match.score[scorer] += 1
    events.goal = scorer
    events.scorer = match.last_touch_robot
    call_restart(match, events, KICK_OFF, other_team(scorer), 0.0, 0.0)
    if k.end_at_goal == 1:
        match.over = 1
        match.phase = OVER


@compiled
def give_restart_for_out(match, ball, events, k):
    """Call a throw-in, goal kick or corner kick, depending on the team that touched the ball last."""
    events.out = 1
    side_y = 1.0 if ball.y > 0.0 else -1.0
    side_x = 1.0 if ball.x > 0.0 else -1.0
    half_length, half_width = 0.5 * k.pitch_length, 0.5 * k.pitch_width
    defender = AWAY if side_x * match.home_direction > 0.0 else HOME
    last = match.last_touch_team
    if abs(ball.x) <= half_length + k.ball_radius:
        taker = other_team(last) if last != NO_TEAM else defender
        x = min(max(ball.x, -half_length + k.rules_corner_offset), half_length - k.rules_corner_offset)
        call_restart(match, events, THROW_IN, taker, x, side_y * half_width)
    elif last == defender:
        give_corner(match, ball, events, k, other_team(defender))
    else:
        give_goal_kick(match, ball, events, k, defender)


@compiled
def give_goal_kick(match, ball, events, k, defender):
    """Call a goal kick on the side of the goal on which the ball crossed the line."""
    x = 0.5 * k.pitch_length - k.rules_goal_kick_x
    side_x, side_y = 1.0 if ball.x > 0.0 else -1.0, 1.0 if ball.y > 0.0 else -1.0
    call_restart(match, events, GOAL_KICK, defender, side_x * x, side_y * k.rules_goal_kick_y)


@compiled
def give_corner(match, ball, events, k, attacker):
    """Call a corner kick on the side of the goal on which the ball crossed the line."""
    x, y = 0.5 * k.pitch_length - k.rules_corner_offset, 0.5 * k.pitch_width - k.rules_corner_offset
    side_x, side_y = 1.0 if ball.x > 0.0 else -1.0, 1.0 if ball.y > 0.0 else -1.0
    call_restart(match, events, CORNER_KICK, attacker, side_x * x, side_y * y)


@compiled
def ball_stuck(match, ball, k):
    """Tell whether the ball in play has stayed near one point for too long."""
    x, y = ball.x - match.still_x, ball.y - match.still_y
    near = k.rules_stuck_radius
    if match.phase != PLAY or x * x + y * y > near * near:
        match.still_x = ball.x
        match.still_y = ball.y
        match.still_clock = 0.0
        return False
    match.still_clock += k.dt
    return match.still_clock >= k.rules_stuck_time - 0.5 * k.dt


@compiled
def drop_place(ball, k):
    """Return the place at which a stuck ball is dropped [m, m, field frame].

    * A ball near a board is moved straight away from the board, to the rules' `drop_distance`: robots have room on
      each side of the ball. In a corner the ball is moved away from both boards.
    * A ball before a goal is dropped on the line of the goal area parallel to the goal line, so that no robot gets a
      free shot from nearer. The laws of football have it so (Law 8, remembered); the legged league only has a penalty
      area, and its book of 2008 puts a ball that is stuck with a goalkeeper on the centre spot.
    """
    side_x = 1.0 if ball.x > 0.0 else -1.0
    depth, width = k.pitch_goal_area_depth, k.pitch_goal_area_width
    if depth <= 0.0:
        depth, width = k.pitch_penalty_depth, k.pitch_penalty_width
    line = 0.5 * k.pitch_length - depth
    if abs(ball.x) > line and abs(ball.y) < 0.5 * width:
        return side_x * line, ball.y
    x, y = 0.5 * k.pitch_length - k.rules_drop_distance, 0.5 * k.pitch_width - k.rules_drop_distance
    return clip(ball.x, -x, x), clip(ball.y, -y, y)


@compiled
def watch_restart(match, ball, events, k):
    """Resume play when the ball has moved or the time for the restart is up; a dropped ball is in play at once."""
    x, y = ball.x - match.restart_x, ball.y - match.restart_y
    moved = x * x + y * y > k.rules_in_play_distance * k.rules_in_play_distance
    if moved or match.phase == DROP_BALL or match.phase_clock >= k.rules_restart_time - 0.5 * k.dt:
        match.phase = PLAY
        match.phase_clock = 0.0
        match.restart_team = NO_TEAM
        events.in_play = 1


@compiled
def end_half(match, events, k):
    """End a half: change ends and kick off, or blow the final whistle."""
    if match.half == 0:
        match.half = 1
        match.clock = 0.0
        match.home_direction = -match.home_direction
        events.half_time = 1
        call_restart(match, events, KICK_OFF, other_team(match.kick_off_team), 0.0, 0.0)
    elif is_shoot_out_due(match, k):
        begin_shoot_out(match, events, k)
    else:
        end_match(match, events)
