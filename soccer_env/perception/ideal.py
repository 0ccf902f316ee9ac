"""Ideal senses, senses="ideal": write the truth into beliefs and tracks, as a sensor without error would.

Everything is relative to the robot, and its own pose is in its team's frame (own goal behind), so that a team never
learns which side it plays on. Every robot is told how the match stands, with sensors too.

`k`: the league's constants.
"""

from math import inf, pi

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, attack_direction, cosine_and_sine, into_frame, length, wrap
from soccer_env.records.ball_words import word_for_distance
from soccer_env.records.beliefs import clear_slots
from soccer_env.records.world import World
from soccer_env.types import MAX_TEAM, NO_TEAM

SURE = 100.0  # confidence of what is seen  MS03


@compiled
def believe_truth_slice(world, beliefs, tracks, constants, rows, first, last):
    """Fill the beliefs (M, R) and tracks (M, R, slots) of the robots `rows` with the truth, in a slice of matches."""
    world = World(*world)
    players, squares = np.empty(MAX_TEAM, np.int64), np.empty(MAX_TEAM)
    for m in range(first, last):
        match = world.matches[m]
        ball = world.balls[m]
        robots = world.robots[m]
        for r in rows:
            believe_truth(match, ball, robots, beliefs[m], tracks[m, r], constants[0], r, players, squares)


@compiled
def tell_match_state(world, beliefs, asleep, rows, first, last):
    """Write phase, score and clock into the beliefs of the robots `rows`, except in matches that are `asleep` (M,)."""
    world = World(*world)
    for m in range(first, last):
        match, robots = world.matches[m], world.robots[m]
        if not asleep[m]:
            for r in rows:
                fill_match_state(match, robots, beliefs[m, r].situation, r)


@compiled
def believe_truth(match, ball, robots, beliefs, tracks, k, r, rows, squares):
    """Fill robot r's belief and its (slots,) tracks with the truth; `rows` and `squares` are scratch for sorting."""
    robot, belief = robots[r], beliefs[r]
    cosine, sine = cosine_and_sine(robot.heading)
    fill_own_pose(match, robot, belief.own, cosine, sine)
    fill_ball(robot, ball, belief.ball, cosine, sine)
    fill_match_state(match, robots, belief.situation, r)
    fill_heard_distance(ball, robots, belief.heard, r)
    belief.obstacle.distance = belief.obstacle.bearing = 0.0  # the tracks show every player
    fill_tracks(robots, tracks, k, r, cosine, sine, 1, 0, k.teammate_slots, rows, squares)
    fill_tracks(robots, tracks, k, r, cosine, sine, 0, k.teammate_slots, k.opponent_slots, rows, squares)


@compiled
def fill_own_pose(match, robot, own, cosine, sine):
    """Write the robot's true pose, in its team's frame, and its true speeds into its belief."""
    side = attack_direction(match, robot.team)
    own.x, own.y = side * robot.x, side * robot.y
    own.heading = robot.heading if side > 0.0 else wrap(robot.heading + pi)
    own.forward, own.left = into_frame(robot.vx, robot.vy, cosine, sine)
    own.turn = robot.omega
    own.confidence = SURE


@compiled
def fill_ball(robot, ball, believed, cosine, sine):
    """Write the ball's true position and velocity, relative to the robot, into a belief."""
    x, y = ball.x - robot.x, ball.y - robot.y
    ahead, left = into_frame(x, y, cosine, sine)
    believed.x, believed.y = ahead, left
    believed.vx, believed.vy = into_frame(ball.vx, ball.vy, cosine, sine)
    distance, bearing = length(ahead, left), atan2(left, ahead)
    believed.distance = believed.filtered_distance = distance
    believed.bearing = believed.filtered_bearing = bearing
    vx, vy = ball.vx - robot.vx, ball.vy - robot.vy
    away = max(distance, 1e-9)
    believed.radial = (x * vx + y * vy) / away
    believed.angular = (x * vy - y * vx) / (away * away) - robot.omega
    believed.confidence, believed.age = SURE, 0.0
    believed.held = robot.has_ball


@compiled
def fill_match_state(match, robots, known, r):
    """Write the state of the match that robot r may know into its belief: phase, score, time, player numbers."""
    team = robots[r].team
    known.phase = match.phase
    known.placing = match.placing
    known.phase_clock = match.phase_clock
    known.ours = 0.0 if match.restart_team == NO_TEAM else (1.0 if match.restart_team == team else -1.0)
    known.seconds_left = seconds_left(match)
    known.goals_for, known.goals_against = match.score[team], match.score[1 - team]
    known.number, known.keeper = robots[r].number, robots[r].keeper
    known.active, known.penalty = robots[r].active, robots[r].penalty
    known.teammates = known.opponents = 0
    for other in range(robots.shape[0]):
        if robots[other].active == 1 and other != r:
            if robots[other].team == team:
                known.teammates += 1
            else:
                known.opponents += 1


@compiled
def fill_heard_distance(ball, robots, heard, r):
    """Write the ball's true distance from the nearest team-mate, as if radio reports had no delay or error."""
    nearest = inf
    for other in range(robots.shape[0]):
        if other != r and robots[other].team == robots[r].team and robots[other].active == 1:
            nearest = min(nearest, length(ball.x - robots[other].x, ball.y - robots[other].y))
    heard.word, heard.distance = word_for_distance(nearest), nearest
    heard.age = inf if nearest == inf else 0.0


@compiled
def seconds_left(match):
    """Return the playing time left until the final whistle [s]; inf for an endless match."""
    if match.half_length == inf:
        return inf
    return max((2 - match.half) * match.half_length - match.clock, 0.0)


@compiled
def nearest_players(robots, r, same_team, slots, rows, squares):
    """Fill `rows` with the `slots` nearest active team-mates or opponents, nearest first; return how many there are.

    `same_team` 1 asks for team-mates of robot r, 0 for opponents; equal distances go by row. `squares` is a scratch
    array for their squared distances.
    """
    count = 0
    for other in range(robots.shape[0]):
        mate = 1 if robots[other].team == robots[r].team else 0
        if other == r or mate != same_team or robots[other].active == 0:
            continue
        x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
        square = x * x + y * y
        place = count if count < slots else slots
        while place > 0 and square < squares[place - 1]:
            if place < slots:
                rows[place], squares[place] = rows[place - 1], squares[place - 1]
            place -= 1
        if place < slots:
            rows[place], squares[place] = other, square
            count = min(count + 1, slots)
    return count


@compiled
def fill_tracks(robots, tracks, k, r, cosine, sine, same_team, first, slots, rows, squares):
    """Fill `slots` tracks, starting with index `first`, with the nearest team-mates or opponents, nearest first."""
    count = nearest_players(robots, r, same_team, slots, rows, squares)
    for slot in range(count):
        fill_track(robots[r], robots[rows[slot]], tracks[first + slot], cosine, sine)
        tracks[first + slot].teammate = same_team
    clear_slots(tracks, first + count, first + slots)


@compiled
def fill_track(robot, other, track, cosine, sine):
    """Fill a track with the true state of another player, relative to the robot."""
    x, y = other.x - robot.x, other.y - robot.y
    track.x, track.y = into_frame(x, y, cosine, sine)
    track.distance, track.bearing = length(track.x, track.y), atan2(track.y, track.x)
    track.vx, track.vy = into_frame(other.vx, other.vy, cosine, sine)
    track.heading = wrap(other.heading - robot.heading)
    track.present = 1
    track.keeper = other.keeper
    track.number = other.number
    track.confidence, track.age = SURE, 0.0
