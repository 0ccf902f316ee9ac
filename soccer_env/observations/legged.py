"""observe="percepts" of legged robots: blobs in the picture of the head camera, and an infrared range.

`k`: the league's constants; `s`: settings of the sensors.
"""

from dataclasses import replace

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.leagues.league import League
from soccer_env.observations.belief import write_game
from soccer_env.observations.entry import CAMERA, NONE, SIDE, Entry, Y, copy_to_group, entries_dtype, object_entries
from soccer_env.observations.percepts import BODY, BODY_ROW, BODY_SIZE, write_body
from soccer_env.observations.row import record_view
from soccer_env.observations.truth import GAME, GAME_ROW
from soccer_env.records.percepts import BLOBS, LANDMARKS

RANGER = copy_to_group(
    "infrared ranger",
    Entry("infrared_valid", "1: the infrared ranger gave a reading", "1", NONE),
    Entry("infrared", "its range", "its greatest valid range", NONE),
)
TOUCH = copy_to_group(
    "touch sensors",
    Entry("touch_head", "1: the switch on the head is pressed", "1", NONE),
    Entry("touch_chin", "1: the one under the chin", "1", NONE),
    Entry("touch_back", "1: the one on the back", "1", NONE),
    Entry("touch_feet", "paws that stand", "4", NONE),
)
BLOB = (
    Entry("seen", "1: there is such a blob; else its entries are 0", "1", NONE),
    Entry("x", "middle of the blob, to the left", "half the picture's width", CAMERA, Y),
    Entry("y", "middle of the blob, up", "half the picture's height", CAMERA),
    Entry("width", "width", "the picture's width", NONE),
    Entry("height", "height", "the picture's height", NONE),
)
LANDMARK = tuple(replace(entry, frame=CAMERA, axis=SIDE) for entry in BLOB)  # landmarks stand on both sides
COLOURS = ("ball", "teammates", "opponents", "own_goal", "opponent_goal")
RANGER_ROW, TOUCH_ROW, BLOB_ROW = (
    entries_dtype(RANGER),
    entries_dtype(TOUCH),
    entries_dtype(BLOB),
)  # for the writers below
RANGER_SIZE, TOUCH_SIZE, BLOB_SIZE = len(RANGER), len(TOUCH), len(BLOB)


def entries(league: League) -> list[Entry]:
    """Return the entries of a legged robot's observation, in order; they are the same in every league."""
    blobs = [entry for colour in COLOURS for entry in object_entries(colour, BLOBS, BLOB)]
    return [*BODY, *RANGER, *TOUCH, *blobs, *object_entries("landmarks", LANDMARKS, LANDMARK), *GAME]


@compiled
def observe_slice(percepts, beliefs, robots, observations, constants, sensors, half_length, rows, first, last):
    """Write the observations (M, R, n) of legged robots; of `beliefs` only the state of the match is used."""
    k, s = constants[0], sensors[0]
    for m in range(first, last):
        for r in rows:
            percept, observation = percepts[m, r], observations[m, r]
            write_body(percept.body, robots[m, r], record_view(observation, 0, BODY_ROW), k)
            write_ranger(percept, record_view(observation, BODY_SIZE, RANGER_ROW), s)
            at = BODY_SIZE + RANGER_SIZE
            write_touch(percept.touch, record_view(observation, at, TOUCH_ROW))
            at = write_blobs(percept.ball, observation, s, at + TOUCH_SIZE)
            at = write_blobs(percept.teammates, observation, s, at)
            at = write_blobs(percept.opponents, observation, s, at)
            at = write_blobs(percept.own_goal, observation, s, at)
            at = write_blobs(percept.opponent_goal, observation, s, at)
            at = write_blobs(percept.landmarks, observation, s, at)
            write_game(beliefs[m, r].situation, record_view(observation, at, GAME_ROW), half_length)


@compiled
def write_ranger(percept, row, s):
    """Write the reading of the infrared ranger into an observation."""
    row.infrared_valid = 1.0 if percept.infrared > 0.0 else 0.0
    row.infrared = clip(percept.infrared / s.infrared_far, 0.0, 1.0)


@compiled
def write_touch(touch, row):
    """Write the readings of the touch sensors into an observation."""
    row.touch_head, row.touch_chin, row.touch_back = touch.head, touch.chin, touch.back
    row.touch_feet = 0.25 * touch.feet


@compiled
def write_blobs(blobs, observation, s, at):
    """Write the blobs of one colour into the observation, starting at index `at`; return the next index."""
    width, height = 44.0 * 2.0**s.resolution, 36.0 * 2.0**s.resolution
    for i in range(blobs.shape[0]):
        blob, row = blobs[i], record_view(observation, at, BLOB_ROW)
        seen = 1.0 if blob.area > 0 else 0.0
        row.seen = seen
        row.x, row.y = seen * (blob.left + blob.right) / width, seen * (blob.high + blob.low) / height
        row.width, row.height = seen * (blob.left - blob.right) / width, seen * (blob.high - blob.low) / height
        at += BLOB_SIZE
    return at
