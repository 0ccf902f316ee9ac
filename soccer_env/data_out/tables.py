"""Tidy tables: one row for each frame and object, and one for each event, with a unit and a meaning for each column.

Places are in the field frame, in metres: origin at the centre spot, x along the pitch, y to the left of x. They are
not turned: teams change sides at half-time, and `home_direction` says in which direction home attacks.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.data_out.collect import PHASES, SIDES, MatchRecording
from soccer_env.data_out.events import NOBODY

Table = dict[str, np.ndarray]  # a column (rows,) by name
BALL = "ball"


@dataclass(frozen=True)
class Column:
    """A column of a table; kind: "text", "whole", "number" or "flag"; unit: of numbers, "" for none."""

    name: str
    kind: str
    unit: str
    text: str


def number_column(name: str, unit: str, text: str) -> Column:
    """Return a column of numbers; NaN where the number does not apply."""
    return Column(name, "number", unit, text)


def whole_number_column(name: str, text: str) -> Column:
    """Return a column of whole numbers."""
    return Column(name, "whole", "", text)


def word_column(name: str, text: str) -> Column:
    """Return a column of words; empty where the word does not apply."""
    return Column(name, "text", "", text)


WHEN = (
    word_column("match", "name of the match: its file's, without the ending"),
    whole_number_column("frame", "0 at the start of the recording, n after control step n"),
    number_column("time", "s", "time since the recording began"),
    whole_number_column("period", "1 first half, 2 second half, 5 penalty shoot-out"),
    number_column("clock", "s", "time of play in this period"),
)
TRACKING = (
    *WHEN,
    word_column("phase", "phase of play: play, or the restart that is waited for"),
    Column("in_play", "flag", "", "whether the ball is in play"),
    whole_number_column("home_direction", "+1: home attacks +x in this frame, -1: it attacks -x"),
    word_column("object", "ball, or the robot: home_0, away_2"),
    word_column("team", "home or away; empty for the ball"),
    whole_number_column("number", "of the robot in its team, from 0; -1 for the ball"),
    number_column("x", "m", "along the pitch, from the centre spot"),
    number_column("y", "m", "across the pitch, from the centre spot"),
    number_column("heading", "rad", "where the robot faces, counter-clockwise from +x; missing for the ball"),
    number_column("vx", "m/s", "velocity along x"),
    number_column("vy", "m/s", "velocity along y"),
    Column("on_pitch", "flag", "", "false for a robot that is sent off or serves a penalty"),
    Column("has_ball", "flag", "", "whether the ball lies in the robot's pocket or at its kicker"),
)
EVENTS = (
    *WHEN,
    word_column(
        "event", "kick, pass, interception, shot, save, goal, foul, restart, ball_out, in_play, separation, ..."
    ),
    word_column("team", "home or away, whose event it is: of a foul who committed it, of a restart who takes it"),
    word_column("robot", "home_0, away_2; empty where no single robot did it"),
    number_column("x", "m", "the ball along the pitch: of passes and shots where it was played"),
    number_column("y", "m", "the ball across the pitch"),
    word_column(
        "outcome",
        "pass: successful, intercepted; shot: goal, saved, blocked, off_target; goal, foul, restart: its kind",
    ),
    whole_number_column("end_frame", "of passes and shots: the frame in which it was decided; -1 for others"),
    number_column("end_x", "m", "where the ball was then"),
    number_column("end_y", "m", "where the ball was then"),
    word_column("receiver", "robot at which a pass arrived, a mate or an opponent"),
    whole_number_column("home_score", "goals of home after the frame"),
    whole_number_column("away_score", "goals of away after the frame"),
)
TABLES = {"tracking": TRACKING, "events": EVENTS}


def tracking_table(recording: MatchRecording) -> Table:
    """Return the tracking table: one row for each frame and object, frame by frame, the ball first."""
    frames, robots = recording.robots["x"].shape
    objects = robots + 1
    every = np.repeat(np.arange(frames), objects)
    names = np.array([BALL, *(player.name for player in recording.players)], object)
    sides = np.array(["", *(player.side for player in recording.players)], object)
    numbers = np.array([-1, *(player.number for player in recording.players)])
    table: Table = {name: values[every] for name, values in frame_columns(recording).items()}
    table["object"], table["team"] = np.tile(names, frames), np.tile(sides, frames)
    table["number"] = np.tile(numbers, frames)
    for at, name in enumerate(("x", "y", "vx", "vy")):
        table[name] = interleave_columns(recording.ball[:, at], recording.robots[name])
    table["heading"] = interleave_columns(np.full(frames, np.nan), recording.robots["heading"])
    table["on_pitch"] = interleave_columns(np.ones(frames, bool), recording.robots["active"] == 1)
    table["has_ball"] = interleave_columns(np.zeros(frames, bool), recording.robots["has_ball"] == 1)
    return {column.name: table[column.name] for column in TRACKING}


def frame_columns(recording: MatchRecording) -> Table:
    """Return the columns (T,) that describe each frame."""
    phases = np.array([PHASES[phase] for phase in range(max(PHASES) + 1)], object)
    return {
        "match": np.full(len(recording), recording.name, object),
        "frame": np.arange(len(recording)),
        "time": recording.time,
        "period": recording.periods,
        "clock": recording.match["clock"],
        "phase": phases[recording.match["phase"]],
        "in_play": recording.in_play,
        "home_direction": recording.match["home_direction"].astype(np.int64),
    }


def interleave_columns(ball: np.ndarray, robots: np.ndarray) -> np.ndarray:
    """Interleave values of the ball (T,) and of robots (T, R) frame by frame into one column (T * (R + 1),)."""
    return np.concatenate([ball[:, None], robots], axis=1).ravel()


def event_table(recording: MatchRecording) -> Table:
    """Return the table of events: one row for each event, in the order of frames."""
    events, when = recording.events, frame_columns(recording)
    frames = np.array([event.frame for event in events], np.int64)
    names = {NOBODY: "", **{player.row: player.name for player in recording.players}}
    table: Table = {column.name: when[column.name][frames] for column in WHEN}
    table |= {
        "event": word_array([event.kind for event in events]),
        "team": word_array([SIDES.get(event.team, "") for event in events]),
        "robot": word_array([names.get(event.row, "") for event in events]),
        "x": np.array([event.x for event in events], np.float64),
        "y": np.array([event.y for event in events], np.float64),
        "outcome": word_array([event.outcome for event in events]),
        "end_frame": np.array([event.end_frame for event in events], np.int64),
        "end_x": np.array([event.end_x for event in events], np.float64),
        "end_y": np.array([event.end_y for event in events], np.float64),
        "receiver": word_array([names.get(event.receiver, "") for event in events]),
        "home_score": recording.score[frames, 0],
        "away_score": recording.score[frames, 1],
    }
    return {column.name: table[column.name] for column in EVENTS}


def word_array(values: list[Any]) -> np.ndarray:
    """Return a list of words as a column, an array of objects."""
    column = np.empty(len(values), object)
    column[:] = values
    return column


def match_tables(recording: MatchRecording) -> dict[str, Table]:
    """Return both tables of a match by name."""
    return {"tracking": tracking_table(recording), "events": event_table(recording)}
