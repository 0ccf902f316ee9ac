"""observe="belief": what a robot believes, in the order of observe="truth", with confidences and ages.

Where the truth says where things are, a belief says where the robot thinks they are. What a robot feels of its own
body (gait phase, head, kicker, its last command) is exact.
"""

from __future__ import annotations

from math import cos, inf, sin, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.leagues.constants import has_ranger
from soccer_env.leagues.league import League
from soccer_env.observations.body import write_command, write_duty, write_joints
from soccer_env.observations.entry import Entry, slot_entries
from soccer_env.observations.truth import BALL, GAME, GOALS, NEAR, OWN, PLAYER, SLOW
from soccer_env.types import Phase

PLAY = int(Phase.PLAY)
AGE = 1.0  # [s] half-way point of the soft scale for ages, assumed
SURE = 100.0

OWN_MORE = (("own_confidence", "confidence in the own pose", "100"),)
BALL_MORE = (
    ("ball_raw_x", "latest reading of the ball, ahead, finer when near", "soft"),
    ("ball_raw_y", "latest reading of the ball, to the left, finer when near", "soft"),
    ("ball_radial", "rate of the ball's distance", "soft: v / (|v| + a tenth of its top speed)"),
    ("ball_angular", "rate of the ball's bearing", "soft: w / (|w| + 1 rad/s)"),
    ("ball_confidence", "confidence in the ball", "100"),
    ("ball_age", "time since the ball was seen", "soft: t / (t + 1 s)"),
)
PLAYER_MORE = (
    ("confidence", "confidence in this player", "100"),
    ("age", "time since it was seen", "soft: t / (t + 1 s)"),
)
OBSTACLE = (  # of robots with an infrared ranger
    ("obstacle_near", "nearness of somebody whom the ranger alone knows of; 0: nobody", "soft: a / (distance + a)"),
    ("obstacle_cos", "cosine of its bearing; 0 if there is nobody", "1"),
    ("obstacle_sin", "sine of its bearing; 0 if there is nobody", "1"),
)
FIXED = OWN + OWN_MORE + BALL + BALL_MORE + GOALS + GAME
BELIEVED_PLAYER = PLAYER + PLAYER_MORE


def entries(league: League) -> list[Entry]:
    """Return the entries of a robot's observation in a league, in order."""
    rows = FIXED + (OBSTACLE if has_ranger(league) else ())
    return [Entry(*row) for row in rows] + slot_entries(league, BELIEVED_PLAYER)


@compiled
def observe_belief_slice(beliefs, tracks, robots, observations, constants, half_length, rows, first, last):
    """Write the observations (M, R, n) of some robots of a slice of matches; of `robots` only what a body feels."""
    k = constants[0]
    diagonal = sqrt(k.pitch_length * k.pitch_length + k.pitch_width * k.pitch_width)
    for m in range(first, last):
        for r in rows:
            belief, row = beliefs[m, r], observations[m, r]
            at = write_body(robots[m, r], belief, row, k)
            at = write_ball(belief.ball, row, k, diagonal, at)
            at = write_goals(belief.own, row, k, diagonal, at)
            at = write_game(belief.situation, row, half_length, at)
            if k.ranger == 1:
                at = write_obstacle(belief.obstacle, row, diagonal, at)
            for slot in range(k.teammate_slots + k.opponent_slots):
                at = write_player(tracks[m, r, slot], row, k, diagonal, at)


@compiled
def write_body(robot, belief, row, k):
    """Write what the robot believes and feels of itself; return where the next entry goes."""
    own = belief.own
    row[0] = clip(own.x / (0.5 * k.pitch_length + k.pitch_goal_depth), -1.0, 1.0)
    row[1] = clip(own.y / (0.5 * k.pitch_width + k.pitch_band_side), -1.0, 1.0)
    row[2], row[3] = cos(own.heading), sin(own.heading)
    row[4], row[5] = clip(own.forward / k.drive_forward, -1.0, 1.0), clip(own.left / k.drive_forward, -1.0, 1.0)
    row[6] = clip(own.turn / k.drive_turn, -1.0, 1.0)
    at = write_joints(robot, row, k, 7)
    row[at] = belief.ball.held
    at = write_duty(1 if robot.fallen <= 0.0 else 0, belief.situation.active, belief.situation.keeper, row, at + 1)
    at = write_command(robot, row, at)
    row[at] = own.confidence / SURE
    return at + 1


@compiled
def write_ball(ball, row, k, diagonal, at):
    """Write where the ball is believed to lie and to go."""
    near, slow = NEAR * diagonal, SLOW * k.ball_top_speed
    distance = sqrt(ball.x * ball.x + ball.y * ball.y)
    away = max(distance, 1e-9)
    row[at], row[at + 1] = clip(ball.x / diagonal, -1.0, 1.0), clip(ball.y / diagonal, -1.0, 1.0)
    row[at + 2], row[at + 3] = soft(ball.x, near), soft(ball.y, near)
    row[at + 4], row[at + 5] = clip(ball.x / away, -1.0, 1.0), clip(ball.y / away, -1.0, 1.0)
    row[at + 6] = near / (distance + near)
    row[at + 7], row[at + 8] = soft(ball.vx, slow), soft(ball.vy, slow)
    row[at + 9] = soft(ball.distance * cos(ball.bearing), near)
    row[at + 10] = soft(ball.distance * sin(ball.bearing), near)
    row[at + 11], row[at + 12] = soft(ball.radial, slow), soft(ball.angular, 1.0)
    row[at + 13], row[at + 14] = ball.confidence / SURE, soft_age(ball.age)
    return at + 15


@compiled
def write_goals(own, row, k, diagonal, at):
    """Write where the two goals lie, seen from the believed pose."""
    cosine, sine, goal = cos(own.heading), sin(own.heading), 0.5 * k.pitch_length
    for side in range(2):
        x, y = (goal if side == 0 else -goal) - own.x, -own.y
        row[at + 2 * side] = clip((cosine * x + sine * y) / diagonal, -1.0, 1.0)
        row[at + 2 * side + 1] = clip((cosine * y - sine * x) / diagonal, -1.0, 1.0)
    return at + 4


@compiled
def write_game(situation, row, half_length, at):
    """Write the state of the game."""
    difference = 1.0 * (situation.goals_for - situation.goals_against)
    row[at] = 1.0 if situation.phase == PLAY else -1.0
    row[at + 1] = situation.ours
    row[at + 2] = situation.placing
    row[at + 3] = 1.0 if half_length == inf else clip(situation.seconds_left / (2.0 * half_length), 0.0, 1.0)
    row[at + 4] = soft(difference, 2.0)
    return at + 5


@compiled
def write_obstacle(obstacle, row, diagonal, at):
    """Write the obstacle that the ranger tells of; without one it is zeros.  MS49"""
    near, bearing = NEAR * diagonal, np.float64(obstacle.bearing)
    there = 1.0 if obstacle.distance > 0.0 else 0.0
    row[at] = there * near / (obstacle.distance + near)
    row[at + 1], row[at + 2] = there * cos(bearing), there * sin(bearing)
    return at + 3


@compiled
def write_player(track, row, k, diagonal, at):
    """Write one slot; an empty one is zeros."""
    used = 1.0 if track.present == 1 else 0.0
    speed = 1.0 / k.drive_forward
    row[at] = used
    row[at + 1] = used * clip(track.x / diagonal, -1.0, 1.0)
    row[at + 2] = used * clip(track.y / diagonal, -1.0, 1.0)
    row[at + 3], row[at + 4] = used * clip(track.vx * speed, -1.0, 1.0), used * clip(track.vy * speed, -1.0, 1.0)
    row[at + 5], row[at + 6] = used * cos(track.heading), used * sin(track.heading)
    row[at + 7], row[at + 8] = used * track.confidence / SURE, used * soft_age(track.age)
    return at + 9


@compiled
def soft(value, half):
    """Return the value on a scale that never ends at 1: `half` gives one half."""
    return value / (abs(value) + half)


@compiled
def soft_age(age):
    """Return an age on a soft scale; one without end is 1."""
    return 1.0 if age == inf else age / (age + AGE)
