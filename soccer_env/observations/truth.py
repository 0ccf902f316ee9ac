"""observe="truth": everything a robot could wish to know, without error.

Other players fill the league's slots, nearest first; players beyond the slots are dropped, farthest first. `entries`
names every number; the compiled writer below follows it line by line.
"""

from __future__ import annotations

from math import cos, inf, sin, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.frames import direction_of
from soccer_env.geometry import clip
from soccer_env.leagues.league import League
from soccer_env.observations.body import COMMAND, DUTY, JOINTS, write_command, write_duty, write_joints
from soccer_env.observations.entry import Entry, slot_entries
from soccer_env.perception.ideal import nearest_players, seconds_left
from soccer_env.types import MAX_TEAM, NO_TEAM, Phase

PLAY = int(Phase.PLAY)
NEAR = 0.1  # [1] of the pitch's diagonal: half-way point of the soft scale for positions, assumed
SLOW = 0.1  # [1] of the ball's top speed: half-way point of the soft scale for ball speeds, assumed


OWN = (
    ("own_x", "own position, towards the opponent's goal", "half length plus goal depth"),
    ("own_y", "own position, to the left", "half width plus band"),
    ("own_cos", "cosine of the own heading", "1"),
    ("own_sin", "sine of the own heading", "1"),
    ("own_forward", "own speed ahead", "top speed ahead"),
    ("own_left", "own speed to the left", "top speed ahead"),
    ("own_turn", "own turn rate", "top turn rate"),
    *JOINTS,
    ("has_ball", "1: the ball lies in the pocket or at the kicker", "1"),
    *DUTY,
    *COMMAND,
)
BALL = (
    ("ball_x", "ball ahead", "diagonal of the pitch"),
    ("ball_y", "ball to the left", "diagonal of the pitch"),
    ("ball_near_x", "ball ahead, finer when near", "soft: x / (|x| + a tenth of the diagonal)"),
    ("ball_near_y", "ball to the left, finer when near", "soft"),
    ("ball_cos", "cosine of the ball's bearing", "1"),
    ("ball_sin", "sine of the ball's bearing", "1"),
    ("ball_near", "nearness of the ball", "soft: a / (distance + a)"),
    ("ball_vx", "ball speed over the ground, along the robot", "soft: v / (|v| + a tenth of its top speed)"),
    ("ball_vy", "ball speed over the ground, to the left", "soft"),
)
GOALS = (
    ("goal_x", "centre of the opponent's goal, ahead", "diagonal of the pitch"),
    ("goal_y", "centre of the opponent's goal, to the left", "diagonal of the pitch"),
    ("own_goal_x", "centre of the own goal, ahead", "diagonal of the pitch"),
    ("own_goal_y", "centre of the own goal, to the left", "diagonal of the pitch"),
)
GAME = (
    ("in_play", "1 in play, -1 a restart", "1"),
    ("restart", "1 our restart, -1 theirs, 0 neither", "1"),
    ("placing", "1 while robots are driven to their places", "1"),
    ("time_left", "play left, 1 at the first kick-off; 1 always without an end", "the match"),
    ("score", "goals for less goals against", "soft: d / (|d| + 2)"),
)
PLAYER = (
    ("present", "1: the slot is in use; else all its entries are 0", "1"),
    ("x", "ahead", "diagonal of the pitch"),
    ("y", "to the left", "diagonal of the pitch"),
    ("vx", "speed over the ground, along the robot", "top speed ahead"),
    ("vy", "speed over the ground, to the left", "top speed ahead"),
    ("cos", "cosine of its heading, seen from the robot", "1"),
    ("sin", "sine of its heading, seen from the robot", "1"),
)
FIXED = OWN + BALL + GOALS + GAME
PLAYER_SIZE = len(PLAYER)


def entries(league: League) -> list[Entry]:
    """Return the entries of a robot's observation in a league, in order."""
    return [Entry(*row) for row in FIXED] + slot_entries(league, PLAYER)


@compiled
def observe_truth(match, ball, robots, observations, k, axes, rows, squares):
    """Write the truth as each robot of a match would like to see it into observations (R, n).

    Room to work in: `axes` (R, 2) for cosine and sine of the headings, `rows` and `squares` to sort players.
    """
    for r in range(robots.shape[0]):
        axes[r, 0], axes[r, 1] = cos(robots[r].heading), sin(robots[r].heading)
    diagonal = sqrt(k.pitch_length * k.pitch_length + k.pitch_width * k.pitch_width)
    for r in range(robots.shape[0]):
        row = observations[r]
        at = write_own(match, robots[r], row, k, axes[r, 0], axes[r, 1])
        at = write_ball(robots[r], ball, row, k, axes[r, 0], axes[r, 1], diagonal, at)
        at = write_goals(match, robots[r], row, k, axes[r, 0], axes[r, 1], 1.0 / diagonal, at)
        at = write_game(match, robots[r], row, at)
        found = nearest_players(robots, r, 1, k.teammate_slots, rows, squares)
        at = write_players(robots, r, row, k, axes, 1.0 / diagonal, at, rows, found, k.teammate_slots)
        found = nearest_players(robots, r, 0, k.opponent_slots, rows, squares)
        at = write_players(robots, r, row, k, axes, 1.0 / diagonal, at, rows, found, k.opponent_slots)


@compiled
def observe_slice(matches, balls, robots, observations, constants, first, last):
    """Write the observations (M, R, n) of a slice of matches."""
    axes, rows, squares = np.empty((robots.shape[1], 2)), np.empty(MAX_TEAM, np.int64), np.empty(MAX_TEAM)
    for m in range(first, last):
        observe_truth(matches[m], balls[m], robots[m], observations[m], constants[0], axes, rows, squares)


@compiled
def write_own(match, robot, row, k, cosine, sine):
    """Write what the robot knows of itself; return where the next entry goes."""
    side = direction_of(match, robot.team)
    row[0] = clip(side * robot.x / (0.5 * k.pitch_length + k.pitch_goal_depth), -1.0, 1.0)
    row[1] = clip(side * robot.y / (0.5 * k.pitch_width + k.pitch_band_side), -1.0, 1.0)
    row[2], row[3] = side * cosine, side * sine
    row[4] = clip((cosine * robot.vx + sine * robot.vy) / k.drive_forward, -1.0, 1.0)
    row[5] = clip((cosine * robot.vy - sine * robot.vx) / k.drive_forward, -1.0, 1.0)
    row[6] = clip(robot.omega / k.drive_turn, -1.0, 1.0)
    at = write_joints(robot, row, k, 7)
    row[at] = robot.has_ball
    at = write_duty(1 if robot.fallen <= 0.0 else 0, robot.active, robot.keeper, row, at + 1)
    return write_command(robot, row, at)


@compiled
def write_ball(robot, ball, row, k, cosine, sine, diagonal, at):
    """Write where the ball lies and how it moves."""
    x, y = ball.x - robot.x, ball.y - robot.y
    ahead, left = cosine * x + sine * y, cosine * y - sine * x
    near = NEAR * diagonal
    distance = sqrt(x * x + y * y)
    away = max(distance, 1e-9)
    row[at], row[at + 1] = clip(ahead / diagonal, -1.0, 1.0), clip(left / diagonal, -1.0, 1.0)
    row[at + 2], row[at + 3] = ahead / (abs(ahead) + near), left / (abs(left) + near)
    row[at + 4], row[at + 5] = clip(ahead / away, -1.0, 1.0), clip(left / away, -1.0, 1.0)
    row[at + 6] = near / (distance + near)
    forward, aside = cosine * ball.vx + sine * ball.vy, cosine * ball.vy - sine * ball.vx
    slow = SLOW * k.ball_top_speed
    row[at + 7], row[at + 8] = forward / (abs(forward) + slow), aside / (abs(aside) + slow)
    return at + 9


@compiled
def write_goals(match, robot, row, k, cosine, sine, scale, at):
    """Write where the two goals lie."""
    goal = 0.5 * k.pitch_length * direction_of(match, robot.team)
    x, y = goal - robot.x, -robot.y
    row[at] = clip((cosine * x + sine * y) * scale, -1.0, 1.0)
    row[at + 1] = clip((cosine * y - sine * x) * scale, -1.0, 1.0)
    x = -goal - robot.x
    row[at + 2] = clip((cosine * x + sine * y) * scale, -1.0, 1.0)
    row[at + 3] = clip((cosine * y - sine * x) * scale, -1.0, 1.0)
    return at + 4


@compiled
def write_game(match, robot, row, at):
    """Write the state of the game as the robot's team sees it."""
    ours = 1.0 if match.restart_team == robot.team else -1.0
    difference = np.float64(match.score[robot.team] - match.score[1 - robot.team])
    row[at] = 1.0 if match.phase == PLAY else -1.0
    row[at + 1] = 0.0 if match.restart_team == NO_TEAM else ours
    row[at + 2] = match.placing
    row[at + 3] = 1.0 if match.half_length == inf else seconds_left(match) / (2.0 * match.half_length)
    row[at + 4] = difference / (abs(difference) + 2.0)
    return at + 5


@compiled
def write_players(robots, r, row, k, axes, scale, at, rows, found, slots):
    """Write the `found` players of a kind, nearest first, into their slots; the rest of the slots are zeros."""
    cosine, sine = axes[r, 0], axes[r, 1]
    speed = 1.0 / k.drive_forward
    for slot in range(found):
        other = rows[slot]
        x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
        vx, vy = robots[other].vx, robots[other].vy
        row[at] = 1.0
        row[at + 1] = clip((cosine * x + sine * y) * scale, -1.0, 1.0)
        row[at + 2] = clip((cosine * y - sine * x) * scale, -1.0, 1.0)
        row[at + 3] = clip((cosine * vx + sine * vy) * speed, -1.0, 1.0)
        row[at + 4] = clip((cosine * vy - sine * vx) * speed, -1.0, 1.0)
        row[at + 5] = clip(cosine * axes[other, 0] + sine * axes[other, 1], -1.0, 1.0)
        row[at + 6] = clip(cosine * axes[other, 1] - sine * axes[other, 0], -1.0, 1.0)
        at += PLAYER_SIZE
    rest = PLAYER_SIZE * (slots - found)
    for column in range(at, at + rest):
        row[column] = 0.0
    return at + rest
