"""The other players that a middle-size robot tracks.  [Heinemann et al. 2006, 1]  MH06

    frame     tracks go on, each carried by the odometry
    readings  the nearest pair of reading and track of the same team first, as long as they are within the gate
    left over readings start tracks, the nearest players keep the slots; unseen ones coast, fade and are forgotten

The filter of slot i lies in place i of the memory and moves with it when tracks are sorted, nearest first.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import inf, sqrt

import numpy as np

from soccer_env.belief.omni.tracking import (
    correct_track,
    place_at_exposure,
    place_of_sighting,
    predict,
    start,
    to_present_frame,
)
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, length, wrap
from soccer_env.records.beliefs import UNKNOWN, forget
from soccer_env.records.percepts import OTHERS
from soccer_env.types import MAX_TEAM

SURE = 100.0  # confidence of what is seen
PLAYER_SPEED = 1.5  # [m/s] sd of the speed of a player of whom only one reading is known, assumed
SLOTS = 2 * MAX_TEAM  # room for tracks, at most

READING = np.dtype(
    [  # scratch: a player in the picture
        ("x", "f8"),  # [m] robot frame of now
        ("y", "f8"),  # [m]
        ("taken", "i8"),  # 1: it belongs to a track
        ("off", "f8", (SLOTS,)),  # [m2] squared, from the tracks as they were at the exposure; inf: no pair
    ]
)


@compiled
def believe_players(percept, tracks, filters, motions, frames, scratch, k, s, w):
    """Update the tracks of other players from the percept.  MH06

    The picture counts as `frames` old; scratch: OTHERS READINGs, one TRACK and one FILTER.
    """
    readings, spare_tracks, spare_filters = scratch
    predict_players(tracks, filters, motions[percept.body.frame % motions.shape[0]], k, s, w)
    count = convert_sighted_players(percept, motions, frames, readings)
    mates, everyone = k.teammate_slots, k.teammate_slots + k.opponent_slots
    update_team_tracks(percept, tracks, filters, readings, count, 1, 0, mates, frames * k.dt, k, s, w)
    update_team_tracks(percept, tracks, filters, readings, count, 0, mates, everyone, frames * k.dt, k, s, w)
    fade_unseen_players(tracks, filters, k, w)
    sort_players(tracks, filters, spare_tracks, spare_filters, 0, mates)
    sort_players(tracks, filters, spare_tracks, spare_filters, mates, everyone)


@compiled
def predict_players(tracks, filters, motion, k, s, w):
    """Predict the tracked players one frame ahead, in the frame of the moving robot."""
    for slot in range(tracks.shape[0]):
        track, filter = tracks[slot], filters[slot]
        filter.seen = 0
        if track.present == 0:
            filter.readings, track.number = 0, UNKNOWN
            continue
        if filter.readings == 0:  # a team-mate told of it
            vx, vy = track.vx, track.vy
            start(track, filter, track.x, track.y, PLAYER_SPEED, s)
            track.vx, track.vy = vx, vy
        predict(track, filter, motion, w.player_agility, 0.0, k, s)
        to_present_frame(track, motion)
        track.age += k.dt
        if track.number != UNKNOWN:  # its heading was told
            track.heading = wrap(track.heading - np.float64(motion.turn))


@compiled
def convert_sighted_players(percept, motions, frames, readings):
    """Convert the players in the picture to present positions, as if they stood still; return the number of players."""
    count = 0
    while count < OTHERS and percept.players[count].seen == 1:
        reading = readings[count]
        reading.x, reading.y = place_of_sighting(percept.players[count], motions, percept.body.frame, frames)
        reading.taken = 0
        count += 1
    return count


@compiled
def update_team_tracks(percept, tracks, filters, readings, count, teammate, first, last, late, k, s, w):
    """Update the tracks of one team, slots `first` to `last` - 1, from the readings with the team's marker.  MH06

    A pair of which each is the other's nearest is taken, again and again: the same pairs as the nearest pair first.
    """
    age, most = np.float64(percept.age), w.gate * w.gate
    measure_track_distances(percept, tracks, filters, readings, count, teammate, first, last, late)
    again = True
    while again:
        again = False
        for slot in range(first, last):
            best = nearest_reading(readings, count, slot, most) if tracks[slot].present == 1 else -1
            if best >= 0 and nearest_track(readings[best], first, last) == slot:
                off = sqrt(readings[best].off[slot])
                take_pair(readings, count, best, slot, first, last)
                filters[slot].seen = 1
                x, y = readings[best].x, readings[best].y
                correct_player(tracks[slot], filters[slot], x, y, off, late, age, k, s, w)
                again = True
    for best in range(count):
        if readings[best].taken == 0 and percept.players[best].teammate == teammate:
            add_player(tracks, filters, readings[best].x, readings[best].y, teammate, first, last, age, s)


@compiled
def measure_track_distances(percept, tracks, filters, readings, count, teammate, first, last, late):
    """Compute the squared distances [m2] between readings and tracks of a team; inf to an empty slot."""
    for slot in range(first, last):
        present = tracks[slot].present == 1
        x, y = place_at_exposure(tracks[slot], late)
        for i in range(count):
            dx, dy = readings[i].x - x, readings[i].y - y
            near = present and percept.players[i].teammate == teammate
            readings[i].off[slot] = dx * dx + dy * dy if near else inf


@compiled
def nearest_reading(readings, count, slot, most):
    """Return the index of the reading nearest to a track, less than `most` [m2] off; -1 for none."""
    best = -1
    for i in range(count):
        if readings[i].off[slot] < most:
            best, most = i, readings[i].off[slot]
    return best


@compiled
def nearest_track(reading, first, last):
    """Return the slot of the track nearest to a reading."""
    best = first
    for slot in range(first + 1, last):
        if reading.off[slot] < reading.off[best]:
            best = slot
    return best


@compiled
def take_pair(readings, count, best, slot, first, last):
    """Take a reading and a track out of the search for pairs."""
    readings[best].taken = 1
    for i in range(count):
        readings[i].off[slot] = inf
    for other in range(first, last):
        readings[best].off[other] = inf


@compiled
def correct_player(track, filter, x, y, off, late, age, k, s, w):
    """Correct a track by a reading; restart it after `surprise_count` readings in a row off by over `surprise`."""
    filter.surprises = filter.surprises + 1 if off > w.surprise else 0
    if filter.surprises >= w.surprise_count:
        start(track, filter, x, y, PLAYER_SPEED, s)
    elif filter.surprises == 0:
        correct_track(track, filter, x, y, late, max(track.age - age, k.dt), s, w)
    else:
        filter.seen = 2  # it is there, but not where it was thought to be
        return
    track.age, track.confidence = age, SURE


@compiled
def add_player(tracks, filters, x, y, teammate, first, last, age, s):
    """Start a track in an empty slot, or replace the farthest player if that player is farther than the new player."""
    place, farthest = -1, x * x + y * y
    for slot in range(first, last):
        track = tracks[slot]
        if track.present == 0:
            place = slot
            break
        square = track.x * track.x + track.y * track.y
        if square > farthest:
            place, farthest = slot, square
    if place < 0:
        return
    track, filter = tracks[place], filters[place]
    start(track, filter, x, y, PLAYER_SPEED, s)
    filter.seen = 1
    track.present = 1
    track.teammate = teammate
    track.keeper = 0
    track.number = UNKNOWN
    track.heading = 0.0
    track.age = age
    track.confidence = SURE


@compiled
def fade_unseen_players(tracks, filters, k, w):
    """Lower the confidence in unseen players, forget players unseen for long, and compute distances and bearings."""
    for slot in range(tracks.shape[0]):
        track = tracks[slot]
        if track.present == 1 and filters[slot].seen != 1:
            track.confidence = max(track.confidence - w.fading * k.dt, 0.0)
            if track.age > w.ghost_time:
                forget(track)
                filters[slot].readings = 0
        if track.present == 1:
            track.distance, track.bearing = length(track.x, track.y), atan2(track.y, track.x)


@compiled
def sort_players(tracks, filters, spare_tracks, spare_filters, first, last):
    """Sort the tracks of a team with their filters, nearest first and empty slots last."""
    for slot in range(first + 1, last):
        place = slot
        while place > first and is_sorted_before(tracks[place], tracks[place - 1]):
            spare_tracks[0], spare_filters[0] = tracks[place], filters[place]
            tracks[place], filters[place] = tracks[place - 1], filters[place - 1]
            tracks[place - 1], filters[place - 1] = spare_tracks[0], spare_filters[0]
            place -= 1


@compiled
def is_sorted_before(one, other):
    """Tell whether a track sorts before another: used slots before empty slots, then near before far."""
    return one.present == 1 and (other.present == 0 or one.distance < other.distance)
