"""observe="truth": the whole state of the match, without error.

Other players fill the league's slots, nearest first; players beyond the slots are dropped, farthest first. `entries`
names every number, and the compiled writers below write each by its name.

`k`: the league's constants.
"""

from math import inf, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, clip, cosine_and_sine, into_frame
from soccer_env.leagues.league import League
from soccer_env.observations.body import COMMAND, DUTY, JOINTS, write_command, write_joints, write_status_flags
from soccer_env.observations.entry import (
    NONE,
    ROBOT,
    TEAM,
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
from soccer_env.perception.ideal import nearest_players, seconds_left
from soccer_env.types import MAX_TEAM, NO_TEAM, Phase

PLAY = int(Phase.PLAY)
NEAR = 0.1  # [1] of the pitch's diagonal: half-way point of the soft scale for positions, assumed
SLOW = 0.1  # [1] of the ball's top speed: half-way point of the soft scale for ball speeds, assumed

DIAGONAL, SOFT_SPEED = "diagonal of the pitch", "soft: v / (|v| + a tenth of its top speed)"

OWN = (
    *copy_to_group(
        "own pose",
        Entry("own_x", "own position, towards the opponent's goal", "half length plus goal depth", TEAM, X),
        Entry("own_y", "own position, to the left", "half width plus band", TEAM, Y),
        Entry("own_cos", "cosine of the own heading", "1", TEAM, X),
        Entry("own_sin", "sine of the own heading", "1", TEAM, Y),
        Entry("own_forward", "own speed ahead", "top speed ahead", ROBOT, X),
        Entry("own_left", "own speed to the left", "top speed ahead", ROBOT, Y),
        Entry("own_turn", "own turn rate", "top turn rate", ROBOT, TURN),
    ),
    *JOINTS,
    *copy_to_group("ball", Entry("has_ball", "1: the ball lies in the pocket or at the kicker", "1", NONE)),
    *DUTY,
    *COMMAND,
)
BALL = copy_to_group(
    "ball",
    Entry("ball_x", "ball ahead", DIAGONAL, ROBOT, X),
    Entry("ball_y", "ball to the left", DIAGONAL, ROBOT, Y),
    Entry("ball_near_x", "ball ahead, finer when near", "soft: x / (|x| + a tenth of the diagonal)", ROBOT, X),
    Entry("ball_near_y", "ball to the left, finer when near", "soft: y / (|y| + a tenth of the diagonal)", ROBOT, Y),
    Entry("ball_cos", "cosine of the ball's bearing", "1", ROBOT, X),
    Entry("ball_sin", "sine of the ball's bearing", "1", ROBOT, Y),
    Entry("ball_near", "nearness of the ball", "soft: a / (distance + a), a = a tenth of the diagonal", NONE),
    Entry("ball_vx", "ball speed over the ground, along the robot", SOFT_SPEED, ROBOT, X),
    Entry("ball_vy", "ball speed over the ground, to the left", SOFT_SPEED, ROBOT, Y),
)
GOALS = copy_to_group(
    "goals",
    Entry("goal_x", "centre of the opponent's goal, ahead", DIAGONAL, ROBOT, X),
    Entry("goal_y", "centre of the opponent's goal, to the left", DIAGONAL, ROBOT, Y),
    Entry("own_goal_x", "centre of the own goal, ahead", DIAGONAL, ROBOT, X),
    Entry("own_goal_y", "centre of the own goal, to the left", DIAGONAL, ROBOT, Y),
)
GAME = copy_to_group(
    "game",
    Entry("in_play", "1 in play, -1 a restart", "1", NONE),
    Entry("restart", "1 our restart, -1 theirs, 0 neither", "1", NONE),
    Entry("placing", "1 while robots are driven to their places", "1", NONE),
    Entry("time_left", "play left, 1 at the first kick-off; 1 always without an end", "the match", NONE),
    Entry("score", "goals for less goals against", "soft: d / (|d| + 2)", NONE),
)
PLAYER = (
    Entry("present", "1: the slot is in use; else all its entries are 0", "1", NONE, present=True),
    Entry("x", "ahead", DIAGONAL, ROBOT, X),
    Entry("y", "to the left", DIAGONAL, ROBOT, Y),
    Entry("vx", "speed over the ground, along the robot", "top speed ahead", ROBOT, X),
    Entry("vy", "speed over the ground, to the left", "top speed ahead", ROBOT, Y),
    Entry("cos", "cosine of its heading, seen from the robot", "1", ROBOT, X),
    Entry("sin", "sine of its heading, seen from the robot", "1", ROBOT, Y),
)
FIXED = OWN + BALL + GOALS + GAME
FIXED_ROW = entries_dtype(FIXED)  # the records that writers fill
GAME_ROW = entries_dtype(GAME)
PLAYER_ROW = entries_dtype(PLAYER)
FIXED_SIZE, PLAYER_SIZE = len(FIXED), len(PLAYER)


def entries(league: League) -> list[Entry]:
    """Return the entries of a robot's observation in a league, in order."""
    return [*FIXED, *slot_entries(*slot_counts(league), PLAYER)]


def every_entry() -> list[Entry]:
    """Return all entries that observe="truth" has in any league."""
    return [*FIXED, *slot_entries(MAX_TEAM, MAX_TEAM, PLAYER)]


@compiled
def observe_truth(match, ball, robots, observations, k, axes, rows, squares):
    """Write the observations (R, n) of all robots of one match from the truth, relative to each robot.

    Scratch arrays: `axes` (R, 2) for cosine and sine of the headings, `rows` and `squares` to sort players.
    """
    for r in range(robots.shape[0]):
        axes[r, 0], axes[r, 1] = cosine_and_sine(robots[r].heading)
    diagonal = sqrt(k.pitch_length * k.pitch_length + k.pitch_width * k.pitch_width)
    for r in range(robots.shape[0]):
        observation, at = observations[r], FIXED_SIZE
        row = record_view(observation, 0, FIXED_ROW)
        write_own_body(match, robots[r], row, k, axes[r, 0], axes[r, 1])
        write_ball(robots[r], ball, row, k, axes[r, 0], axes[r, 1], diagonal)
        write_goals(match, robots[r], row, k, axes[r, 0], axes[r, 1], 1.0 / diagonal)
        write_game(match, robots[r], row)
        count = nearest_players(robots, r, 1, k.teammate_slots, rows, squares)
        at = write_players(robots, r, observation, k, axes, 1.0 / diagonal, at, rows, count, k.teammate_slots)
        count = nearest_players(robots, r, 0, k.opponent_slots, rows, squares)
        write_players(robots, r, observation, k, axes, 1.0 / diagonal, at, rows, count, k.opponent_slots)


@compiled
def observe_slice(matches, balls, robots, observations, constants, first, last):
    """Write the observations (M, R, n) of a slice of matches."""
    axes = np.empty((robots.shape[1], 2))
    rows = np.empty(MAX_TEAM, np.int64)
    squares = np.empty(MAX_TEAM)
    for m in range(first, last):
        observe_truth(matches[m], balls[m], robots[m], observations[m], constants[0], axes, rows, squares)


@compiled
def write_own_body(match, robot, row, k, cosine, sine):
    """Write the robot's own pose, velocity and body state into an observation."""
    side = attack_direction(match, robot.team)
    row.own_x = clip(side * robot.x / (0.5 * k.pitch_length + k.pitch_goal_depth), -1.0, 1.0)
    row.own_y = clip(side * robot.y / (0.5 * k.pitch_width + k.pitch_band_side), -1.0, 1.0)
    row.own_cos, row.own_sin = side * cosine, side * sine
    forward, left = into_frame(robot.vx, robot.vy, cosine, sine)
    row.own_forward = clip(forward / k.drive_forward, -1.0, 1.0)
    row.own_left = clip(left / k.drive_forward, -1.0, 1.0)
    row.own_turn = clip(robot.omega / k.drive_turn, -1.0, 1.0)
    write_joints(robot, row, k)
    row.has_ball = robot.has_ball
    write_status_flags(1 if robot.fallen <= 0.0 else 0, robot.active, robot.keeper, row)
    write_command(robot, row)


@compiled
def write_ball(robot, ball, row, k, cosine, sine, diagonal):
    """Write the ball's true position and velocity into an observation."""
    x, y = ball.x - robot.x, ball.y - robot.y
    ahead, left = into_frame(x, y, cosine, sine)
    near = NEAR * diagonal
    distance = sqrt(x * x + y * y)
    away = max(distance, 1e-9)
    row.ball_x, row.ball_y = clip(ahead / diagonal, -1.0, 1.0), clip(left / diagonal, -1.0, 1.0)
    row.ball_near_x, row.ball_near_y = ahead / (abs(ahead) + near), left / (abs(left) + near)
    row.ball_cos, row.ball_sin = clip(ahead / away, -1.0, 1.0), clip(left / away, -1.0, 1.0)
    row.ball_near = near / (distance + near)
    forward, aside = into_frame(ball.vx, ball.vy, cosine, sine)
    slow = SLOW * k.ball_top_speed
    row.ball_vx, row.ball_vy = forward / (abs(forward) + slow), aside / (abs(aside) + slow)


@compiled
def write_goals(match, robot, row, k, cosine, sine, scale):
    """Write the true positions of the two goals into an observation."""
    goal = 0.5 * k.pitch_length * attack_direction(match, robot.team)
    ahead, left = into_frame(goal - robot.x, -robot.y, cosine, sine)
    row.goal_x, row.goal_y = clip(ahead * scale, -1.0, 1.0), clip(left * scale, -1.0, 1.0)
    ahead, left = into_frame(-goal - robot.x, -robot.y, cosine, sine)
    row.own_goal_x, row.own_goal_y = clip(ahead * scale, -1.0, 1.0), clip(left * scale, -1.0, 1.0)


@compiled
def write_game(match, robot, row):
    """Write the state of the match, as the robot's team sees it, into an observation."""
    ours = 1.0 if match.restart_team == robot.team else -1.0
    difference = np.float64(match.score[robot.team] - match.score[1 - robot.team])
    row.in_play = 1.0 if match.phase == PLAY else -1.0
    row.restart = 0.0 if match.restart_team == NO_TEAM else ours
    row.placing = match.placing
    row.time_left = 1.0 if match.half_length == inf else seconds_left(match) / (2.0 * match.half_length)
    row.score = difference / (abs(difference) + 2.0)


@compiled
def write_players(robots, r, observation, k, axes, scale, at, rows, count, slots):
    """Write `count` players, nearest first, into slots from index `at`, then zeros; return the next index."""
    cosine, sine = axes[r, 0], axes[r, 1]
    speed = 1.0 / k.drive_forward
    for slot in range(count):
        other, row = rows[slot], record_view(observation, at + slot * PLAYER_SIZE, PLAYER_ROW)
        x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
        row.present = 1.0
        ahead, left = into_frame(x, y, cosine, sine)
        row.x, row.y = clip(ahead * scale, -1.0, 1.0), clip(left * scale, -1.0, 1.0)
        ahead, left = into_frame(robots[other].vx, robots[other].vy, cosine, sine)
        row.vx, row.vy = clip(ahead * speed, -1.0, 1.0), clip(left * speed, -1.0, 1.0)
        ahead, left = into_frame(axes[other, 0], axes[other, 1], cosine, sine)
        row.cos, row.sin = clip(ahead, -1.0, 1.0), clip(left, -1.0, 1.0)
    end = at + slots * PLAYER_SIZE
    for column in range(at + count * PLAYER_SIZE, end):
        observation[column] = 0.0
    return end
