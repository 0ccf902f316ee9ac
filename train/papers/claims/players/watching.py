"""Stage robots that look at other players, and compare their beliefs with the truth, for all matches at once.

Robot 0, of the home team, is the observer; the claim moves its head.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.legged_sensors import RESOLUTIONS, SMALLEST_HEIGHT, SMALLEST_WIDTH
from soccer_env.match import Match
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.staging import LEGGED
from soccer_env.train.papers.true_sight import camera_of, look_at_point

NONE = np.inf  # [m] gap to a player that nobody remembers
STICKER = find_league(LEGGED).sensors.trunk_sticker_middle  # [m] height at which a player is looked at


def stage_watchers(batch: Batch, matches: int, *, home: int = 1, away: int = 1, **settings: Any) -> Match:
    """Set up matches in which home uses its sensors, robot 0 stands in the middle, and there is no ball."""
    settings = {"senses": {"home": "sensors", "away": "ideal"}, "actions": "full", **settings}
    match = staging.stage(batch, matches=matches, home=home, away=away, **settings)
    for name, value in (("x", 50.0), ("y", 50.0), ("vx", 0.0), ("vy", 0.0), ("roll_x", 0.0), ("roll_y", 0.0)):
        match.balls[name] = value  # far behind the boards, at rest
    staging.put(match, 0, 0.0, 0.0, batch.rng(9).uniform(-np.pi, np.pi, matches))
    return match


def put_facing(match: Match, r: int, distance: Any, bearing: Any, view: Any) -> None:
    """Put robot r at a distance [m] and bearing [rad] from robot 0, so that robot 0 sees it at angle `view` [rad].

    View 0 is head-on, a half-turn is from behind.
    """
    x, y = staging.point_ahead(match, 0, distance, bearing)
    staging.put(match, r, x, y, staging.wrap_angle(match.robots["heading"][:, 0] + bearing + np.pi - view))


def stage_player(batch: Batch, matches: int, distance: Any, bearing: Any, view: Any, **settings: Any) -> Match:
    """Set up matches (`stage_watchers`) with one opponent, robot 1, put as `put_facing` says, and begin the scene."""
    match = stage_watchers(batch, matches, **settings)
    put_facing(match, 1, distance, bearing, view)
    staging.begin_scene(match)
    return match


def view_of(match: Match, r: int) -> np.ndarray:
    """Return the angle (M,) [rad] from which robot 0 sees robot r: 0 head-on, a half-turn from behind."""
    eye = match.robots[:, 0]
    return staging.distance_to_point(match, r, eye["x"], eye["y"])[1]


def look_at(match: Match, actions: np.ndarray, r: int = 1, height: float = STICKER) -> None:
    """Turn the head of robot 0 to robot r: fill columns 4 to 6 of actions (M, R, 7)."""
    look_at_point(match, actions, 0, match.robots["x"][:, r], match.robots["y"][:, r], height)


def distance_to_robot(match: Match, r: int = 1) -> np.ndarray:
    """Return the true distance (M,) [m] of robot r from robot 0."""
    return staging.distance_to_point(match, 0, match.robots["x"][:, r], match.robots["y"][:, r])[0]


def stare(match: Match, actions: np.ndarray, settle: float, seconds: float) -> Iterator[int]:
    """Let robot 0 stare at robot 1; yield each step of `seconds`, after `settle` [s] before them."""
    return staging.watch(match, seconds, actions, settle, lambda step: look_at(match, actions))


def slots_of(match: Match, teammates: bool = False) -> np.ndarray:
    """Return robot 0's memory slots (M, slots), with their tracks, for opponents or for team-mates."""
    first = match.league.slots.teammates
    return match.tracks[:, 0, :first] if teammates else match.tracks[:, 0, first:]


def is_fresh(match: Match, slots: np.ndarray) -> np.ndarray:
    """Tell which slots hold a player seen in this frame."""
    return np.asarray((slots["present"] == 1) & (slots["age"] < 0.5 * match.league.dt))


def nearest_seen(match: Match) -> tuple[np.ndarray, np.ndarray]:
    """Return distance [m] and bearing [rad] (M,) of the opponent seen in this frame, NaN without an opponent.

    The nearest of several counts: it has the largest blob; the others are ghosts or stand behind it.
    """
    slots = slots_of(match)
    distance = np.where(is_fresh(match, slots), slots["distance"], np.inf)
    best = distance.argmin(axis=1)
    rows = np.arange(len(best))
    seen = np.isfinite(distance[rows, best])
    return np.where(seen, distance[rows, best], np.nan), np.where(seen, slots["bearing"][rows, best], np.nan)


def places_of(match: Match, robots: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the places of some robots, x and y (M, n) [m] in robot 0's frame."""
    return into_robot_frames(match.robots[:, :1], match.robots["x"][:, robots], match.robots["y"][:, robots])


def into_robot_frames(eye: np.ndarray, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Convert points of the field frame to the frames of robots `eye`: metres ahead, metres to the left."""
    cosine, sine = np.cos(eye["heading"]), np.sin(eye["heading"])
    dx, dy = x - eye["x"], y - eye["y"]
    return cosine * dx + sine * dy, cosine * dy - sine * dx


def gaps_to(match: Match, slots: np.ndarray, robots: Any) -> np.ndarray:
    """Return the distances (M, slots, n) [m] between slots and the true places of robots; `NONE` for empty slots."""
    x, y = places_of(match, robots)
    gaps = np.hypot(slots["x"][:, :, None] - x[:, None, :], slots["y"][:, :, None] - y[:, None, :])
    return np.where(slots["present"][:, :, None] == 1, gaps, NONE)


def matched_distances(gaps: np.ndarray, limit: float) -> np.ndarray:
    """Return the distance between each player and its matched slot (M, n), `NONE` for a player without a slot.

    gaps (M, slots, n). Greedy: closest pair first, each slot and player at most once, pairs within `limit` only.
    """
    left = np.where(gaps <= limit, gaps, NONE)
    count, slots, players = left.shape
    nearest, rows = np.full((count, players), NONE), np.arange(count)
    for _ in range(min(slots, players)):
        pair = left.reshape(count, -1).argmin(axis=1)
        slot, player = pair // players, pair % players
        gap = left[rows, slot, player]
        ok = np.isfinite(gap)
        nearest[rows[ok], player[ok]] = gap[ok]
        left[rows[ok], slot[ok], :] = NONE
        left[rows[ok], :, player[ok]] = NONE
    return nearest


def blob_directions(match: Match) -> tuple[np.ndarray, np.ndarray]:
    """Return bearings and elevations (M, blobs) [rad] of opponents' blobs from robot 0's camera, NaN without a blob.

    The geometry of soccer_env.optics.head_camera for all robots at once; a test compares the two.
    """
    percept, s = match.percepts[:, 0], match.league.sensors
    blobs = percept["opponents"]
    pan = percept["pan"][:, None].astype(float)
    tilt = percept["tilt"][:, None].astype(float)
    finer = 1 << RESOLUTIONS[s.resolution]
    left = (blobs["left"].astype(float) + blobs["right"]) / (SMALLEST_WIDTH * finer) * np.tan(0.5 * s.view_width)
    up = (blobs["high"].astype(float) + blobs["low"]) / (SMALLEST_HEIGHT * finer) * np.tan(0.5 * s.view_height)
    ahead, high = np.cos(tilt) - up * np.sin(tilt), np.sin(tilt) + up * np.cos(tilt)
    there = blobs["area"] > 0
    bearing, elevation = staging.wrap_angle(pan + np.arctan2(left, ahead)), np.arctan2(high, np.hypot(ahead, left))
    return np.where(there, bearing, np.nan), np.where(there, elevation, np.nan)


def distances_from_camera(match: Match, robots: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the true distances along the ground [m] and bearings [rad] (M, n) of some robots from robot 0's camera."""
    camera, _ = camera_of(match)
    dx, dy = match.robots["x"][:, robots] - camera[:, :1], match.robots["y"][:, robots] - camera[:, 1:2]
    return np.hypot(dx, dy), staging.wrap_angle(np.arctan2(dy, dx) - match.robots["heading"][:, :1])


def blob_heights(match: Match) -> np.ndarray:
    """Return the heights over the ground (M, blobs) [m] of opponents' blobs' middles, if all blobs show robot 1."""
    away, _ = distances_from_camera(match, [1])
    camera, _ = camera_of(match)
    return np.asarray(camera[:, 2:] + away * np.tan(blob_directions(match)[1]))


def blob_owners(match: Match, robots: Any) -> np.ndarray:
    """Return for each opponents' blob (M, blobs) the index in `robots` of the robot nearest sideways, -1: no blob."""
    bearing, _ = blob_directions(match)
    away, true = distances_from_camera(match, robots)
    aside = np.abs(staging.wrap_angle(bearing[:, :, None] - true[:, None, :])) * away[:, None, :]
    return np.where(np.isfinite(bearing), np.argmin(np.nan_to_num(aside, nan=NONE), axis=2), -1)


def slot_bearings(match: Match, slots: np.ndarray) -> np.ndarray:
    """Return the bearings (M, slots) [rad] of slots' places from robot 0's camera, not from its body's centre."""
    camera, _ = camera_of(match)
    ahead, left = into_robot_frames(match.robots[:, 0], camera[:, 0], camera[:, 1])
    return np.asarray(np.arctan2(slots["y"] - left[:, None], slots["x"] - ahead[:, None]))
