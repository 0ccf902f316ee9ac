"""How wrong robots are: the beliefs of every robot beside the truth, of a running match and of the notes of a replay.

The ball and other players are compared in the robot's own frame, its pose in its team's frame (own goal behind).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.thoughts.thought import NEVER, NoteReader
from soccer_env.thoughts.thoughts import CENTI, MILLI, TABLE, TRACK, Notes
from soccer_env.types import HOME

Records = Any  # an array of records, or a dict of arrays, with the same names


@dataclass(frozen=True)
class BeliefErrors:
    """Beliefs beside the truth of M matches with R robots, for O objects: own pose, ball, then a track in each slot.

    NaN where a robot believes nothing: a pose or ball of confidence 0, a slot that is not in use (there the truth is
    NaN as well); all of a robot that is off the field is NaN. A track is compared with the nearest player of its team,
    as it need not know whom it sees.
    """

    believed: np.ndarray  # (M, R, O, 2) [m] x, y: of ball and players in the robot's frame, of itself in the team frame
    true: np.ndarray  # (M, R, O, 2) [m]
    heading: np.ndarray  # (M, R) [rad] error of the own heading, -pi to pi
    age: np.ndarray  # (M, R, O) [s] since it was seen; 0 of the own pose
    confidence: np.ndarray  # (M, R, O) 0 to 100
    teammate: np.ndarray  # (M, R, O) whether it is a track of a team-mate

    @property
    def error(self) -> np.ndarray:
        """Return the distance of what is believed from the truth (M, R, O) [m]."""
        return np.asarray(np.hypot(*np.moveaxis(self.believed - self.true, -1, 0)))

    @property
    def range(self) -> np.ndarray:
        """Return the true distance of ball and players from the robot (M, R, O) [m]; 0 of the own pose."""
        distance = np.asarray(np.hypot(*np.moveaxis(self.true, -1, 0)))
        distance[..., 0] = 0.0
        return distance


def errors_of(match: Match) -> BeliefErrors:
    """Return the beliefs of all robots beside the truth, now; ValueError if no robot of the match has senses."""
    return compare(match.robots, match.balls, match.matches["home_direction"], match.beliefs, match.tracks)


def errors_in(notes: Notes, robots: Records, balls: Records, home_direction: np.ndarray) -> BeliefErrors:
    """Return the beliefs of a replay's notes beside the truth, with a row for each of N notes; the truth likewise.

    Notes are whole millimetres, milliradians and hundredths of a second (of players, tenths).
    """
    read = NoteReader.of(notes)
    columns = {name: notes.numbers[..., at].astype(np.float64) for at, name in enumerate(TABLE)}
    pose = [columns[name] / MILLI for name in ("x", "y", "heading")]
    thinks = np.stack([read.thinks(row) for row in notes.numbers])
    slots = notes.numbers[..., len(TABLE) : len(TABLE) + len(TRACK) * notes.slots].astype(np.float64)
    slots = slots.reshape(*slots.shape[:2], notes.slots, len(TRACK))
    x, y = to_robot_frame(pose, columns["ball_x"] / MILLI, columns["ball_y"] / MILLI)
    known = thinks * columns["ball_confidence"] / CENTI
    age = np.where(columns["ball_age"] / CENTI < NEVER, columns["ball_age"] / CENTI, np.inf)
    direction = home_direction[:, None] * np.where(robots["team"] == HOME, 1.0, -1.0)
    heading = pose[2] + np.where(direction > 0.0, 0.0, pi)
    own = {"x": direction * pose[0], "y": direction * pose[1], "heading": heading}
    own["confidence"] = thinks * columns["confidence"] / CENTI
    player_x, player_y = to_robot_frame([one[..., None] for one in pose], slots[..., 0] / MILLI, slots[..., 1] / MILLI)
    tracks = {"x": player_x, "y": player_y, "teammate": slots[..., 2] > 0.0, "present": slots[..., 2] != 0.0}
    tracks["age"] = np.maximum(np.abs(slots[..., 2]) - 1.0, 0.0) / 10.0
    tracks["confidence"] = np.full(player_x.shape, np.nan)  # not noted
    beliefs = {"own": own, "ball": {"x": x, "y": y, "confidence": known, "age": age}}
    return compare(robots, balls, home_direction, beliefs, tracks)


def compare(
    robots: Records, balls: Records, home_direction: np.ndarray, beliefs: Records, tracks: Records
) -> BeliefErrors:
    """Return beliefs and tracks (M, R) beside the truth: robots (M, R), balls (M,) and directions of home (M,)."""
    own, ball = beliefs["own"], beliefs["ball"]
    direction = home_direction[:, None] * np.where(robots["team"] == HOME, 1.0, -1.0)
    heading = np.where(direction > 0.0, robots["heading"], robots["heading"] + pi)
    nobody, plays = np.zeros(heading.shape), robots["active"] == 1
    known = by_object(own["confidence"] > 0.0, ball["confidence"] > 0.0, tracks["present"] == 1)[..., None]
    believed = by_object(places_of(own), places_of(ball), places_of(tracks))
    true_ball = in_robot_frame(robots, places_of(balls)[:, None, None])[:, :, 0]
    true = by_object(direction[..., None] * places_of(robots), true_ball, nearest_players(robots, tracks))
    return BeliefErrors(
        believed=np.where(known & plays[..., None, None], believed, np.nan),
        true=np.where(plays[..., None, None], true, np.nan),
        heading=np.where(plays, (own["heading"] - heading + pi) % (2.0 * pi) - pi, np.nan),
        age=by_object(nobody, ball["age"], tracks["age"]),
        confidence=by_object(own["confidence"], ball["confidence"], tracks["confidence"]),
        teammate=by_object(nobody == 1.0, nobody == 1.0, tracks["teammate"] == 1),
    )


def by_object(own: np.ndarray, ball: np.ndarray, tracks: np.ndarray) -> np.ndarray:
    """Return values of own pose and ball (M, R, ...) and of tracks (M, R, S, ...) as one array (M, R, O, ...)."""
    return np.concatenate([own[:, :, None], ball[:, :, None], tracks], axis=2)


def places_of(records: Records) -> np.ndarray:
    """Return the places (..., 2) of records with x and y."""
    return np.stack([records["x"], records["y"]], axis=-1)


def in_robot_frame(robots: Records, places: np.ndarray) -> np.ndarray:
    """Return places (M, 1, N, 2) in the frame of each robot (M, R, N, 2); `robots`: (M, R)."""
    pose = [robots[name][..., None] for name in ("x", "y", "heading")]
    return np.stack(to_robot_frame(pose, places[..., 0], places[..., 1]), axis=-1)


def to_robot_frame(
    pose: Sequence[np.ndarray], place_x: np.ndarray, place_y: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return places of the field frame in the frame of robots; pose: x, y, heading."""
    x, y, heading = pose
    cosine, sine, across, along = np.cos(heading), np.sin(heading), place_x - x, place_y - y
    return cosine * across + sine * along, cosine * along - sine * across


def nearest_players(robots: Records, tracks: Records) -> np.ndarray:
    """Return for each track (M, R, S) the true place of the nearest active player of its team (M, R, S, 2)."""
    others = in_robot_frame(robots, places_of(robots)[:, None])  # (M, R, R, 2)
    mates = robots["team"][:, :, None] == robots["team"][:, None]
    meant = mates[:, :, None] == (tracks["teammate"] == 1)[..., None]  # (M, R, S, R)
    meant &= (robots["active"] == 1)[:, None, None] & ~np.eye(others.shape[1], dtype=bool)[:, None]
    apart = np.linalg.norm(others[:, :, None] - places_of(tracks)[..., None, :], axis=-1)
    apart[~meant | (tracks["present"] != 1)[..., None]] = np.inf
    found = np.take_along_axis(others, apart.argmin(axis=-1)[..., None], axis=2)
    return np.where(np.isfinite(apart.min(axis=-1))[..., None], found, np.nan)
