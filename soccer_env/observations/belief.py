"""observe="belief": a robot's belief, laid out like observe="truth", with confidences and ages.

Places and speeds come from the belief. Readings of the own body (gait phase, head, kicker, last command) are exact, and
so are the referee's clocks.

`k`: the league's constants.
"""

from math import inf, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, cosine_and_sine, from_polar, into_frame
from soccer_env.leagues.constants import has_ranger
from soccer_env.leagues.league import League
from soccer_env.observations.body import write_command, write_joints, write_status_flags
from soccer_env.observations.entry import (
    NONE,
    ROBOT,
    TURN,
    Entry,
    X,
    Y,
    copy_to_group,
    entries_dtype,
    slot_counts,
    slot_entries,
)
from soccer_env.observations.row import record_view
from soccer_env.observations.truth import BALL, GAME, GOALS, NEAR, OWN, PLAYER, SLOW
from soccer_env.types import MAX_TEAM, Phase

PLAY = int(Phase.PLAY)
AGE = 1.0  # [s] half-way point of the soft scale for ages, assumed
SURE = 100.0
SHORT, LONG = 1.0, 10.0  # [s] half-way points of the soft scales for the referee's clocks, assumed

BRIEF, LASTING = "soft: t / (t + 1 s)", "soft: t / (t + 10 s)"
OWN_MORE = copy_to_group("own pose", Entry("own_confidence", "confidence in the own pose", "100", NONE))
BALL_MORE = copy_to_group(
    "ball",
    Entry("ball_raw_x", "latest reading of the ball, ahead", "soft: x / (|x| + a tenth of the diagonal)", ROBOT, X),
    Entry("ball_raw_y", "the same to the left", "soft: y / (|y| + a tenth of the diagonal)", ROBOT, Y),
    Entry("ball_radial", "rate of the ball's distance", "soft: v / (|v| + a tenth of its top speed)", NONE),
    Entry("ball_angular", "rate of the ball's bearing", "soft: w / (|w| + 1 rad/s)", ROBOT, TURN),
    Entry("ball_confidence", "confidence in the ball", "100", NONE),
    Entry("ball_age", "time since the ball was seen", BRIEF, NONE),
)
STILL = "time for which the ball has stayed in place, as the rule of stuck balls counts"
TRESPASS = "time for which the robot has been in an area where it may not stay, as the referee counts"
CARD = "1 after a yellow card, with which the next one sends the robot off; else 0"
BARRED = "1: the robot has taken the restart, and may not touch the ball before another robot has; else 0"
CLOCKS = copy_to_group(
    "clocks",
    Entry("own_pushing", "time for which the robot has pushed an opponent, as the referee counts", BRIEF, NONE),
    Entry("own_holding", "time for which the robot has held the ball, as the referee counts", BRIEF, NONE),
    Entry("own_trespass", TRESPASS, BRIEF, NONE),
    Entry("own_penalty", "time left of the own penalty", LASTING, NONE),
    Entry("own_card", CARD, "1", NONE),
    Entry("own_barred", BARRED, "1", NONE),
    Entry("ball_still", STILL, LASTING, NONE),
)
PLAYER_MORE = (
    Entry("confidence", "confidence in this player", "100", NONE),
    Entry("age", "time since it was seen", BRIEF, NONE),
)
NOBODY = "nearness of somebody whom the ranger alone knows of; 0: nobody"
OBSTACLE = copy_to_group(  # of robots with an infrared ranger
    "obstacle",
    Entry("obstacle_near", NOBODY, "soft: a / (distance + a), a = a tenth of the diagonal", NONE),
    Entry("obstacle_cos", "cosine of its bearing; 0 if there is nobody", "1", ROBOT, X),
    Entry("obstacle_sin", "sine of its bearing; 0 if there is nobody", "1", ROBOT, Y),
)
FIXED = OWN + OWN_MORE + BALL + BALL_MORE + GOALS + GAME + CLOCKS
BELIEVED_PLAYER = PLAYER + PLAYER_MORE
FIXED_ROW, OBSTACLE_ROW, PLAYER_ROW = entries_dtype(FIXED), entries_dtype(OBSTACLE), entries_dtype(BELIEVED_PLAYER)
FIXED_SIZE, OBSTACLE_SIZE, PLAYER_SIZE = len(FIXED), len(OBSTACLE), len(BELIEVED_PLAYER)


def entries(league: League) -> list[Entry]:
    """Return the entries of a robot's observation in a league, in order."""
    return [*FIXED, *(OBSTACLE if has_ranger(league) else ()), *slot_entries(*slot_counts(league), BELIEVED_PLAYER)]


def every_entry() -> list[Entry]:
    """Return all entries that observe="belief" has in any league."""
    return [*FIXED, *OBSTACLE, *slot_entries(MAX_TEAM, MAX_TEAM, BELIEVED_PLAYER)]


@compiled
def observe_belief_slice(
    beliefs, tracks, matches, robots, observations, constants, half_length, sizes, rows, first, last
):  # fmt: skip
    """Write the observations (M, R, n) of the robots in `rows`.

    Of `robots` only exact readings of the body are used, and of `matches` and `robots` what the referee counts.
    sizes: the numbers of robots of home and of away, which every robot knows. Slots for more players than there are
    stay empty, also where a robot believes in more.
    """
    k = constants[0]
    diagonal = sqrt(k.pitch_length * k.pitch_length + k.pitch_width * k.pitch_width)
    for m in range(first, last):
        for r in rows:
            belief = beliefs[m, r]
            observation = observations[m, r]
            at = FIXED_SIZE
            row = record_view(observation, 0, FIXED_ROW)
            write_body(robots[m, r], belief, row, k)
            write_ball(belief.ball, row, k, diagonal)
            write_goals(belief.own, row, k, diagonal)
            write_game(belief.situation, row, half_length)
            write_clocks(matches[m], robots[m, r], belief.situation, r, row)
            if k.ranger == 1:
                write_obstacle(belief.obstacle, record_view(observation, at, OBSTACLE_ROW), diagonal)
                at += OBSTACLE_SIZE
            team = robots[m, r].team
            for slot in range(k.teammate_slots + k.opponent_slots):
                others = sizes[team] - 1 if slot < k.teammate_slots else k.teammate_slots + sizes[1 - team]
                row_of_player = record_view(observation, at, PLAYER_ROW)
                write_player(tracks[m, r, slot], 1.0 if slot < others else 0.0, row_of_player, k, diagonal)
                at += PLAYER_SIZE


@compiled
def write_body(robot, belief, row, k):
    """Write the robot's believed pose and the readings of its body into an observation."""
    own = belief.own
    row.own_x = clip(own.x / (0.5 * k.pitch_length + k.pitch_goal_depth), -1.0, 1.0)
    row.own_y = clip(own.y / (0.5 * k.pitch_width + k.pitch_band_side), -1.0, 1.0)
    row.own_cos, row.own_sin = cosine_and_sine(own.heading)
    row.own_forward = clip(own.forward / k.drive_forward, -1.0, 1.0)
    row.own_left = clip(own.left / k.drive_forward, -1.0, 1.0)
    row.own_turn = clip(own.turn / k.drive_turn, -1.0, 1.0)
    write_joints(robot, row, k)
    row.has_ball = belief.ball.held
    write_status_flags(1 if robot.fallen <= 0.0 else 0, belief.situation.active, belief.situation.keeper, row)
    write_command(robot, row)
    row.own_confidence = own.confidence / SURE


@compiled
def write_ball(ball, row, k, diagonal):
    """Write the ball's believed position and velocity into an observation."""
    near, slow = NEAR * diagonal, SLOW * k.ball_top_speed
    distance = sqrt(ball.x * ball.x + ball.y * ball.y)
    away = max(distance, 1e-9)
    row.ball_x, row.ball_y = clip(ball.x / diagonal, -1.0, 1.0), clip(ball.y / diagonal, -1.0, 1.0)
    row.ball_near_x, row.ball_near_y = soft_scale(ball.x, near), soft_scale(ball.y, near)
    row.ball_cos, row.ball_sin = clip(ball.x / away, -1.0, 1.0), clip(ball.y / away, -1.0, 1.0)
    row.ball_near = near / (distance + near)
    row.ball_vx, row.ball_vy = soft_scale(ball.vx, slow), soft_scale(ball.vy, slow)
    x, y = from_polar(ball.distance, ball.bearing)
    row.ball_raw_x, row.ball_raw_y = soft_scale(x, near), soft_scale(y, near)
    row.ball_radial, row.ball_angular = soft_scale(ball.radial, slow), soft_scale(ball.angular, 1.0)
    row.ball_confidence, row.ball_age = ball.confidence / SURE, soft_age(ball.age)


@compiled
def write_goals(own, row, k, diagonal):
    """Write the positions of the two goals, relative to the believed pose, into an observation."""
    cosine, sine = cosine_and_sine(own.heading)
    goal = 0.5 * k.pitch_length
    ahead, left = into_frame(goal - own.x, -own.y, cosine, sine)
    row.goal_x, row.goal_y = clip(ahead / diagonal, -1.0, 1.0), clip(left / diagonal, -1.0, 1.0)
    ahead, left = into_frame(-goal - own.x, -own.y, cosine, sine)
    row.own_goal_x, row.own_goal_y = clip(ahead / diagonal, -1.0, 1.0), clip(left / diagonal, -1.0, 1.0)


@compiled
def write_game(situation, row, half_length):
    """Write the state of the match (phase, score, time) into an observation."""
    difference = 1.0 * (situation.goals_for - situation.goals_against)
    row.in_play = 1.0 if situation.phase == PLAY else -1.0
    row.restart = situation.ours
    row.placing = situation.placing
    row.time_left = 1.0 if half_length == inf else clip(situation.seconds_left / (2.0 * half_length), 0.0, 1.0)
    row.score = soft_scale(difference, 2.0)


@compiled
def write_clocks(match, robot, situation, r, row):
    """Write what the referee counts of robot r into an observation; each league has its own pushing and holding."""
    row.own_pushing = soft_scale(max(robot.pushing, robot.keeper_pushing, robot.charging), SHORT)
    row.own_holding = soft_scale(max(robot.holding, robot.handling), SHORT)
    row.own_trespass = soft_scale(max(robot.trespass, robot.area_clock, robot.crowd_clock), SHORT)
    row.own_penalty = soft_scale(situation.penalty, LONG)
    row.own_card = robot.yellow % 2
    row.own_barred = 1.0 if match.taker == r and match.phase == PLAY else 0.0
    row.ball_still = soft_scale(match.still_clock, LONG)


@compiled
def write_obstacle(obstacle, row, diagonal):
    """Write the obstacle in front of the infrared ranger into an observation; zeros without an obstacle.  MS49"""
    near, bearing = NEAR * diagonal, np.float64(obstacle.bearing)
    there = 1.0 if obstacle.distance > 0.0 else 0.0
    row.obstacle_near = there * near / (obstacle.distance + near)
    row.obstacle_cos, row.obstacle_sin = from_polar(there, bearing)


@compiled
def write_player(track, exists, row, k, diagonal):
    """Write one tracked player into its slot of an observation; an unused track, or exists=0, gives zeros."""
    used = exists if track.present == 1 else 0.0
    speed = 1.0 / k.drive_forward
    row.present = used
    row.x, row.y = used * clip(track.x / diagonal, -1.0, 1.0), used * clip(track.y / diagonal, -1.0, 1.0)
    row.vx, row.vy = used * clip(track.vx * speed, -1.0, 1.0), used * clip(track.vy * speed, -1.0, 1.0)
    row.cos, row.sin = from_polar(used, track.heading)
    row.confidence, row.age = used * track.confidence / SURE, used * soft_age(track.age)


@compiled
def soft_scale(value, half):
    """Map a value to value / (|value| + half), between -1 and 1, so that `half` becomes 0.5."""
    return value / (abs(value) + half)


@compiled
def soft_age(age):
    """Map an age from [0, inf] to [0, 1], smoothly; an infinite age becomes 1."""
    return 1.0 if age == inf else age / (age + AGE)
