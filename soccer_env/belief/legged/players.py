"""The other players in a legged robot's belief.  [Sacks 2001, 4.1]  MS02, MS03, MS08, MS28 to MS36

Every frame: the players in memory are moved by the robot's own steps and grow older, the blobs of each jersey colour
are sorted into players (`grouping.py`), each gets a place, and replaces the likeliest player in memory (`matching.py`).
Places are polar, relative to the robot (MS02). Vision shows neither numbers nor goalkeepers nor headings, and
velocities are not estimated: these fields stay unknown or 0.

The old memory, `slots` "nearest", knows a single player of each team: whichever is nearest at the moment.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import cos, tan

import numpy as np

from soccer_env.belief.legged.grouping import COMBINED, box_of_player, largest_blob_of_player, largest_ungrouped_blob
from soccer_env.belief.legged.matching import likeliest_slot
from soccer_env.belief.legged.surface import chest_to_middle
from soccer_env.belief.odometry import read_odometry
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, cosine_and_sine, from_polar, into_frame, length
from soccer_env.guards.ranges import COUNT, ranged_record
from soccer_env.leagues.legged_sensors import PLAYER_VIEWS, SLOTS
from soccer_env.optics.head_camera import camera_place, direction_of_pixel, focal_x, focal_y
from soccer_env.records.beliefs import clear_slots
from soccer_env.records.percepts import BLOBS, POSE_TOLD

SURE = 100.0  # confidence of what is seen, Sacks 2001, 2  MS03
NEAREST = SLOTS["nearest"]
SIDE = PLAYER_VIEWS["side"]

PLAYERS_MEMORY = ranged_record(
    [
        ("teammates", "i2", COUNT),  # told apart in this frame's picture, whether there was a slot for each or not
        ("opponents", "i2", COUNT),  # the same
    ]
)


@compiled
def believe_players(percept, own, tracks, memory, k, s, w, table):
    """Update the tracks (slots,) of other players from the percept of a frame.  MS28

    tracks: TRACK, team-mates' slots first; memory: PLAYERS_MEMORY; table: CALIBRATION. `own` is not needed: places are
    relative to the robot. A robot that lies on its side or is sent off does not look; a carried robot forgets.
    """
    body = percept.body
    last = k.teammate_slots + k.opponent_slots
    if body.pose == POSE_TOLD:
        clear_slots(tracks, 0, last)
    if w.player_odometry == 1:
        move_tracks(tracks, body, last)
    age_tracks(tracks, last, k, w)
    memory.teammates = memory.opponents = 0
    if body.active == 1 and body.upright == 1:
        memory.teammates = remember_seen_players(
            percept, percept.teammates, tracks, 0, k.teammate_slots, 1, k, s, w, table
        )
        memory.opponents = remember_seen_players(
            percept, percept.opponents, tracks, k.teammate_slots, last, 0, k, s, w, table
        )


@compiled
def move_tracks(tracks, body, last):
    """Correct all players in memory, in the robot frame, for the robot's own motion since the last frame.  MS36"""
    forward, left, turn = read_odometry(body)
    if forward == 0.0 and left == 0.0 and turn == 0.0:
        return
    cosine, sine = cosine_and_sine(turn)
    for slot in range(last):
        if tracks[slot].present == 1:
            x, y = into_frame(tracks[slot].x - forward, tracks[slot].y - left, cosine, sine)
            set_track_place(tracks[slot], x, y)


@compiled
def set_track_place(track, x, y):
    """Set the position of a track: x, y [m] in the robot frame, and the paper's polar coordinates.  MS02"""
    track.x, track.y = x, y
    track.distance, track.bearing = length(x, y), atan2(y, x)


@compiled
def age_tracks(tracks, last, k, w):
    """Add a frame to the age of all tracks, and lower the confidence in unseen players.  MS03

    Players unseen for `ghost_time` are forgotten, unlike in the paper, where only another player frees a slot.
    """
    for slot in range(last):
        track = tracks[slot]
        if track.present == 1:
            track.age += k.dt
            track.confidence = max(SURE - w.fading * track.age, 0.0)
            if track.age >= w.ghost_time:
                clear_slots(tracks, slot, slot + 1)


@compiled
def remember_seen_players(percept, blobs, tracks, first, last, teammate, k, s, w, table):
    """Group the blobs of one colour into players and store the players; return their number.  MS28

    Slots from `first` to before `last` are this team's. Players come largest blob first. The old memory keeps only the
    nearest player in view, in the first slot.
    """
    done = seen = 0
    nearest_x = nearest_y = nearest = 0.0
    for _ in range(BLOBS):
        i = largest_ungrouped_blob(blobs, done)
        if i < 0:
            break
        done |= 1 << i
        if largest_blob_of_player(blobs, i, w.grouping) != i:
            continue
        x, y = player_position(percept, blobs, i, k, s, w, table)
        seen += 1
        if w.slots != NEAREST:
            remember_player(tracks, likeliest_slot(tracks, first, last, x, y, w), x, y, teammate)
        elif seen == 1 or length(x, y) < nearest:
            nearest_x = x
            nearest_y = y
            nearest = length(x, y)
    if w.slots == NEAREST and seen > 0 and first < last:
        remember_player(tracks, first, nearest_x, nearest_y, teammate)
    return seen


@compiled
def remember_player(tracks, slot, x, y, teammate):
    """Store a player seen at x, y [m], robot frame, in a slot; do nothing for slot -1 (no slot is left)."""
    if slot < 0:
        return
    track = tracks[slot]
    track.present = 1
    track.teammate = teammate
    track.keeper = 0
    track.number = -1
    set_track_place(track, x, y)
    track.vx = track.vy = track.heading = 0.0
    track.confidence, track.age = SURE, 0.0


@compiled
def player_position(percept, blobs, i, k, s, w, table):
    """Return the position x, y [m], robot frame, of the player whose largest blob is i.

    The direction is head angles plus place in the picture (MS08); ranges count from the camera, which moves with the
    neck.
    """
    pan, tilt = np.float64(percept.pan), np.float64(percept.tilt)
    left, right, high, low = box_of_player(blobs, i, w)
    bearing, _ = direction_of_pixel(0.5 * (left + right), 0.5 * (high + low), pan, tilt, s)
    ahead, aside, _ = camera_place(pan, tilt, s)
    if w.player_infrared == 1 and is_player_in_beam(percept, left, right, high, low, s, w):
        away = range_by_infrared(percept, tilt, k)
    else:
        away = range_by_height(high - low, w, table)
    x, y = from_polar(away, bearing)
    return ahead + x, aside + y


@compiled
def range_by_height(height, w, table):
    """Return the range [m] from the camera to the centre of a player whose box is `height` [px] high.  MS33

    Only the height counts, since the width depends on the view; the table was made head-on ("front"), the most common
    view, in which stickers look slightly smaller: from the side a player seems closer than it is, the safer error.
    """
    combined = w.player_blob == COMBINED
    if w.player_view == SIDE:
        ranges = table.player_side_all if combined else table.player_side
    else:
        ranges = table.player_front_all if combined else table.player_front
    return ranges[min(max(height, 0), ranges.shape[0] - 1)]


@compiled
def is_player_in_beam(percept, left, right, high, low, s, w):
    """Tell whether a box [px] covers the picture's centre while the ranger measures a near object.  MS35

    A centre within `centred` of the box counts as covered. A reading of 0 means no reading.
    """
    if not 0.0 < percept.infrared < w.player_infrared_far:
        return False
    edge = tan(w.centred)
    aside, above = edge * focal_x(s), edge * focal_y(s)
    return right - aside <= 0.0 <= left + aside and low - above <= 0.0 <= high + above


@compiled
def range_by_infrared(percept, tilt, k):
    """Return the range [m] along the ground to the centre of a player whose surface the ranger meets.  MS35

    The paper takes "the reading from the infrared distance sensor", and so does `surface_distance` (surface.py); half a
    body is added because tracks hold middles, however they were measured.
    """
    return np.float64(percept.infrared) * cos(tilt) + chest_to_middle(k)
