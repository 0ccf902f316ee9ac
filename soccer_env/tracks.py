"""Slots for other players: how one is emptied, whoever fills it."""

from __future__ import annotations

from soccer_env.compiled import compiled

UNKNOWN = -1  # number of a player who has not been identified


@compiled
def clear_slots(tracks, first, last):
    """Mark slots from `first` to before `last` as unused."""
    for slot in range(first, last):
        forget(tracks[slot])


@compiled
def forget(track):
    """Empty a slot: a TRACK of nobody."""
    track.present = track.teammate = track.keeper = 0
    track.number = UNKNOWN
    track.distance = track.bearing = track.x = track.y = track.vx = track.vy = track.heading = 0.0
    track.confidence = track.age = 0.0
