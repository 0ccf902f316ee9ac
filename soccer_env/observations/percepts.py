"""observe="percepts": what a robot's sensors delivered in this frame, without any memory.

The legged robots see blobs in a picture, the middle-size robots bearings and distances. What a robot feels of its
body comes first; where it stands is among it only while the noisy pose is a percept (`pose="percept"`).
"""

from __future__ import annotations

from math import cos, sin

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.leagues.league import League
from soccer_env.leagues.legged_sensors import LeggedSensors
from soccer_env.observations.belief import write_game
from soccer_env.observations.body import COMMAND, DUTY, JOINTS, write_command, write_duty, write_joints
from soccer_env.observations.entry import Entry
from soccer_env.observations.truth import GAME
from soccer_env.percept_types import BLOBS, LANDMARKS, LEGGED_PERCEPT, OTHERS

BODY = (
    ("pose_known", "1: a pose was given in this frame; else its entries are 0", "1"),
    ("own_x", "given position, towards the opponent's goal", "half length plus goal depth"),
    ("own_y", "given position, to the left", "half width plus band"),
    ("own_cos", "cosine of the given heading", "1"),
    ("own_sin", "sine of the given heading", "1"),
    ("odometry_forward", "displacement ahead since the last frame", "top speed ahead"),
    ("odometry_left", "displacement to the left", "top speed ahead"),
    ("odometry_turn", "turn", "top turn rate"),
    *JOINTS,
    ("touch", "1: a touch sensor is pressed", "1"),
    ("held", "1: the light barrier at the kicker is broken (middle size)", "1"),
    *DUTY,
    *COMMAND,
)
BLOB = (
    ("seen", "1: there is such a blob; else its entries are 0", "1"),
    ("x", "middle of the blob, to the left", "half the picture's width"),
    ("y", "middle of the blob, up", "half the picture's height"),
    ("width", "width", "the picture's width"),
    ("height", "height", "the picture's height"),
)
RANGER = (
    ("infrared_valid", "1: the infrared ranger gave a reading", "1"),
    ("infrared", "its range", "its greatest valid range"),
)
SIGHTING = (
    ("seen", "1: it is in the picture; else its entries are 0", "1"),
    ("cos", "cosine of its bearing", "1"),
    ("sin", "sine of its bearing", "1"),
    ("near", "nearness", "soft: a / (distance + a), a 2 m"),
)
HALF = 2.0  # [m] half-way point of the soft scale for distances in the mirror's picture, assumed
COLOURS = ("ball", "teammates", "opponents", "own_goal", "opponent_goal")
KINDS = {BLOBS: COLOURS, LANDMARKS: ("landmarks",)}


def entries(league: League) -> list[Entry]:
    """Return the entries of a robot's observation in a league, in order."""
    found = [Entry(*row) for row in BODY]
    if isinstance(league.sensors, LeggedSensors):
        found += [Entry(*row) for row in RANGER]
        for count, names in KINDS.items():
            found += [entry for name in names for entry in numbered(name, count, BLOB)]
    else:
        found += [entry for name in ("ball", "own_goal", "opponent_goal") for entry in numbered(name, 1, SIGHTING)]
        slots = min(league.slots.teammates + league.slots.opponents, OTHERS)
        found += numbered("player", slots, (*SIGHTING, ("teammate", "1 team-mate, -1 opponent, by its marker", "1")))
        line = ("line", "distance of the first white line in this direction, 1 if none is seen", "greatest range")
        found += [Entry(f"line_{i}", *line[1:]) for i in range(league.sensors.lines)]
    return found + [Entry(*row) for row in GAME]


def numbered(name: str, count: int, rows: tuple[tuple[str, str, str], ...]) -> list[Entry]:
    """Return the entries of several things of one kind."""
    each = [f"{name}_{i}" for i in range(count)] if count > 1 else [name]
    named = [(one, one.replace("_", " ")) for one in each]
    return [Entry(f"{one}_{part}", f"{words}: {text}", scale) for one, words in named for part, text, scale in rows]


@compiled
def observe_legged_slice(percepts, beliefs, robots, observations, constants, sensors, half_length, rows, first, last):
    """Write the observations (M, R, n) of some legged robots; of `beliefs` only what they are told of the game."""
    k, s = constants[0], sensors[0]
    for m in range(first, last):
        for r in rows:
            percept, row = percepts[m, r], observations[m, r]
            at = write_body(percept.body, robots[m, r], row, k)
            row[at] = 1.0 if percept.infrared > 0.0 else 0.0
            row[at + 1] = clip(percept.infrared / s.infrared_far, 0.0, 1.0)
            at = write_blobs(percept.ball, row, s, at + 2)
            at = write_blobs(percept.teammates, row, s, at)
            at = write_blobs(percept.opponents, row, s, at)
            at = write_blobs(percept.own_goal, row, s, at)
            at = write_blobs(percept.opponent_goal, row, s, at)
            at = write_blobs(percept.landmarks, row, s, at)
            write_game(beliefs[m, r].situation, row, half_length, at)


@compiled
def observe_omni_slice(percepts, beliefs, robots, observations, constants, sensors, half_length, rows, first, last):
    """Write the observations (M, R, n) of some middle-size robots; of `beliefs` only what they are told of the game."""
    k, s = constants[0], sensors[0]
    for m in range(first, last):
        for r in rows:
            percept, row = percepts[m, r], observations[m, r]
            at = write_body(percept.body, robots[m, r], row, k)
            at = write_sighting(percept.ball, row, at)
            at = write_sighting(percept.own_goal, row, at)
            at = write_sighting(percept.opponent_goal, row, at)
            for slot in range(min(k.teammate_slots + k.opponent_slots, OTHERS)):
                player = percept.players[slot]
                at = write_sighting(player, row, at)
                row[at] = player.seen * (2.0 * player.teammate - 1.0)
                at += 1
            for i in range(s.lines):
                row[at + i] = clip(percept.lines[i] / s.line_range, 0.0, 1.0) if percept.lines[i] > 0.0 else 1.0
            write_game(beliefs[m, r].situation, row, half_length, at + s.lines)


@compiled
def write_body(body, robot, row, k):
    """Write what the robot feels of itself; return where the next entry goes."""
    known = 1.0 if body.pose > 0 else 0.0
    row[0] = known
    row[1] = known * clip(body.x / (0.5 * k.pitch_length + k.pitch_goal_depth), -1.0, 1.0)
    row[2] = known * clip(body.y / (0.5 * k.pitch_width + k.pitch_band_side), -1.0, 1.0)
    row[3], row[4] = known * cos(body.heading), known * sin(body.heading)
    row[5] = clip(body.forward / (k.drive_forward * k.dt), -1.0, 1.0)
    row[6] = clip(body.left / (k.drive_forward * k.dt), -1.0, 1.0)
    row[7] = clip(body.turn / (k.drive_turn * k.dt), -1.0, 1.0)
    at = write_joints(robot, row, k, 8)
    row[at], row[at + 1] = body.touch, body.held
    at = write_duty(body.upright, body.active, robot.keeper, row, at + 2)
    return write_command(robot, row, at)


@compiled
def write_blobs(blobs, row, s, at):
    """Write the blobs of a colour."""
    width, height = 44.0 * 2.0**s.resolution, 36.0 * 2.0**s.resolution
    for i in range(blobs.shape[0]):
        blob = blobs[i]
        seen = 1.0 if blob.area > 0 else 0.0
        row[at] = seen
        row[at + 1] = seen * (blob.left + blob.right) / width
        row[at + 2] = seen * (blob.high + blob.low) / height
        row[at + 3], row[at + 4] = seen * (blob.left - blob.right) / width, seen * (blob.high - blob.low) / height
        at += 5
    return at


@compiled
def write_sighting(sighting, row, at):
    """Write a thing in the mirror's picture."""
    seen = 1.0 if sighting.seen == 1 else 0.0
    row[at] = seen
    row[at + 1], row[at + 2] = seen * cos(sighting.bearing), seen * sin(sighting.bearing)
    row[at + 3] = seen * HALF / (sighting.distance + HALF)
    return at + 4


def observe_kernel(percept: np.dtype):  # type: ignore[no-untyped-def]
    """Return the compiled writer for a kind of percept."""
    return observe_legged_slice if percept is LEGGED_PERCEPT else observe_omni_slice
