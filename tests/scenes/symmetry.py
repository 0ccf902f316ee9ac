"""The two symmetries of a match: a left-right mirror, and a half-turn with the teams swapped.

    records = Records.of(match)
    mirrored(records)   y -> -y: what was left is right; each lateral noise draw is mirrored too (handedness)
    turned(records)     the field turned by 180 degrees, home and away swapped with their noise (equal team sizes)

Both return copies. `assert_same` compares records field by field, angles as angles. For the other arrays:
`mirrored_beliefs`, `mirrored_tracks`, `mirrored_actions`, `mirrored_observations`; a half-turn leaves all of them, and
percepts (`mirrored_percepts`), as they are but for the order of the rows, `swapped_rows`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.observations import Entry
from soccer_env.observations.reflection import observation_signs
from soccer_env.types import NO_TEAM

MIRROR, HALF_TURN = 1e-12, 1e-9  # largest differences of mirrored and of turned matches

ANGLES = {"heading", "place_heading", "bearing", "filtered_bearing", "angle"}  # [rad], equal modulo a whole turn
WALK_LATERAL = ("left", "turn")  # what a mirror turns round in a walk or command
TEAM_CODES = ("restart_team", "kick_off_team", "last_touch_team", "whistled", "kick_off_shot")
EVENT_TEAM_CODES = ("goal", "restart_team", "touch_team", "foul_team")


@dataclass
class Records:
    """The records of M matches: matches (M,), balls (M,), robots (M, R)."""

    matches: np.ndarray
    balls: np.ndarray
    robots: np.ndarray

    @classmethod
    def of(cls, match: Any) -> Records:
        return cls(match.matches.copy(), match.balls.copy(), match.robots.copy())

    def put_into(self, match: Any) -> None:
        """Make them the records of a Match, and rebuild its physics."""
        match.matches[:], match.balls[:], match.robots[:] = self.matches, self.balls, self.robots
        match.rebuild()


# Left-right mirror


def mirrored(records: Records) -> Records:
    """Return the records as a mirror along the x axis shows them."""
    matches, balls, robots = records.matches.copy(), records.balls.copy(), records.robots.copy()
    negate(matches, "restart_y", "still_y", "local_y", "handedness")
    negate(balls, "y", "vy", "roll_y", "angle", "spin")
    negate(robots, "y", "heading", "vy", "omega", "pan", "place_y", "place_heading", "kick_side")
    for name in ("command", "delayed", "target", "walk"):  # slips are factors and stay
        negate(robots[name], *WALK_LATERAL)
    negate(robots["command"], "pan")
    negate(robots["gaze"], "pan")
    return Records(matches, balls, robots)


def negate(records: np.ndarray, *names: str) -> None:
    for name in names:
        records[name] = -records[name]


def mirrored_beliefs(beliefs: np.ndarray) -> np.ndarray:
    """Return beliefs (M, R) as the mirrored robots hold them."""
    beliefs = beliefs.copy()
    negate(beliefs["own"], "y", "heading", "left", "turn")
    negate(beliefs["ball"], "bearing", "filtered_bearing", "y", "vy", "angular")
    negate(beliefs["obstacle"], "bearing")
    return beliefs


def mirrored_tracks(tracks: np.ndarray) -> np.ndarray:
    """Return tracks (M, R, slots) as the mirrored robots hold them."""
    tracks = tracks.copy()
    negate(tracks, "bearing", "y", "vy", "heading")
    return tracks


def mirrored_percepts(percepts: np.ndarray, lines: int = 0) -> np.ndarray:
    """Return percepts (M, R) as the mirrored robots get them; `lines` directions are searched for white lines."""
    percepts = percepts.copy()
    negate(percepts["body"], "handedness", "left", "turn", "y", "heading")
    if "pan" in (percepts.dtype.names or ()):
        negate(percepts, "pan")
        for name in ("ball", "teammates", "opponents", "own_goal", "opponent_goal", "landmarks"):
            blobs = percepts[name].copy()
            percepts[name]["left"], percepts[name]["right"] = -blobs["right"], -blobs["left"]
        percepts["landmarks"] = percepts["landmarks"][..., [1, 0, 3, 2, 5, 4]]
        return percepts
    for name in ("ball", "own_goal", "opponent_goal", "players"):
        negate(percepts[name], "bearing")
    percepts["lines"][..., :lines] = percepts["lines"][..., [-i % lines for i in range(lines)]]
    return percepts


def mirrored_states(states: np.ndarray) -> np.ndarray:
    """Return what sensors remember (M, R) as those of the mirrored robots do."""
    states = states.copy()
    negate(states["pose_error"], "y", "heading")
    return states


def mirrored_actions(actions: np.ndarray) -> np.ndarray:
    """Return actions (..., 4 or 7) as the mirrored robots give them: left, turn and pan change sign."""
    signs = np.array([1.0, -1.0, -1.0, 1.0, 1.0, -1.0, 1.0])
    return actions * signs[: actions.shape[-1]]


def mirrored_observations(observations: np.ndarray, entries: list[Entry]) -> np.ndarray:
    """Return observations (..., n) of the truth or of beliefs as the mirrored robots make them."""
    return observations * observation_signs(entries).astype(observations.dtype)


# Half-turn with the teams swapped


def turned(records: Records) -> Records:
    """Return the records turned by 180 degrees about the centre spot, home and away swapped; equal team sizes only."""
    matches, balls, robots = records.matches.copy(), records.balls.copy(), swapped_rows(records.robots)
    negate(matches, "restart_x", "restart_y", "still_x", "still_y", "local_x", "local_y")
    negate(balls, "x", "y", "vx", "vy", "roll_x", "roll_y")
    negate(robots, "x", "y", "vx", "vy", "place_x", "place_y")
    robots["heading"], robots["place_heading"] = opposite(robots["heading"]), opposite(robots["place_heading"])
    robots["team"] = 1 - robots["team"]
    robots["caught_by"] = 1 + other_row(robots["caught_by"] - 1, robots.shape[1])  # 0: by nobody
    for name in TEAM_CODES:
        matches[name] = other_team(matches[name])
    matches["score"] = matches["score"][:, ::-1]
    for name in ("last_touch_robot", "taker"):
        matches[name] = other_row(matches[name], robots.shape[1])
    matches["shoot_out_score"] = matches["shoot_out_score"][..., ::-1]
    return Records(matches, balls, robots)  # home (that was away) attacks the way it did: home_direction stays


def swapped_rows(array: np.ndarray) -> np.ndarray:
    """Return an array (M, R, ...) with the rows of away before those of home."""
    half = array.shape[1] // 2
    return np.concatenate([array[:, half:], array[:, :half]], axis=1)


def opposite(angle: np.ndarray) -> np.ndarray:
    return np.where(angle > 0.0, angle - np.pi, angle + np.pi)


def other_team(code: np.ndarray) -> np.ndarray:
    """Return the code of the other team; none stays none."""
    return np.where(code == NO_TEAM, NO_TEAM, 1 - code)


def other_row(row: np.ndarray, robots: int) -> np.ndarray:
    """Return the row that a robot has once the teams are swapped; none stays none."""
    return np.where(row < 0, row, (row + robots // 2) % robots)


def turned_events(events: np.ndarray, robots: int) -> np.ndarray:
    """Return events (M,) with the teams swapped and the ball turned."""
    events = events.copy()
    for name in EVENT_TEAM_CODES:
        events[name] = other_team(events[name])
    events["scorer"] = other_row(events["scorer"], robots)
    negate(events, "ball_x", "ball_y")
    return events


def mirrored_events(events: np.ndarray) -> np.ndarray:
    """Return events (M,) with the ball mirrored."""
    events = events.copy()
    negate(events, "ball_y")
    return events


# In place


def mirror(match: Any) -> None:
    mirrored(Records.of(match)).put_into(match)


def turn(match: Any) -> None:
    """Turn a Match of equal teams by 180 degrees and swap the teams."""
    turned(Records.of(match)).put_into(match)


# Comparing


def assert_same(one: np.ndarray, other: np.ndarray, tolerance: float, where: str = "") -> None:
    """Raise AssertionError that names the first field in which two arrays differ by more than a tolerance."""
    assert one.dtype == other.dtype and one.shape == other.shape
    if one.dtype.names is None:
        assert_close(one, other, tolerance, where)
        return
    for name in one.dtype.names:
        assert_same(one[name], other[name], tolerance, f"{where}.{name}" if where else name)


def assert_same_records(one: Records, other: Records, tolerance: float) -> None:
    """Assert that matches, balls and robots are the same."""
    for name in ("matches", "balls", "robots"):
        assert_same(getattr(one, name), getattr(other, name), tolerance, name)


def assert_close(one: np.ndarray, other: np.ndarray, tolerance: float, where: str) -> None:
    if one.dtype.kind != "f":
        assert (one == other).all(), f"{where} differs"
        return
    with np.errstate(invalid="ignore"):  # inf - inf
        difference = np.where(one == other, 0.0, one - other)
    if where.rpartition(".")[2] in ANGLES:
        difference = (difference + np.pi) % (2.0 * np.pi) - np.pi
    worst = abs(difference).max(initial=0.0)
    assert worst <= tolerance, f"{where} differs by {worst}"
