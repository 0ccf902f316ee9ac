"""Tidy tables: one row for each frame and object, and one for each event, with a unit and a meaning for each column.

Places are in the field frame, in metres: origin at the centre spot, x along the pitch, y to the left of x. They are
not turned: teams change sides at half-time, and `home_direction` says in which direction home attacks.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.data_out.collect import PHASES, SIDES, Collected
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


def number(name: str, unit: str, text: str) -> Column:
    """Return a column of numbers; NaN where the number does not apply."""
    return Column(name, "number", unit, text)


def whole(name: str, text: str) -> Column:
    """Return a column of whole numbers."""
    return Column(name, "whole", "", text)


def word(name: str, text: str) -> Column:
    """Return a column of words; empty where the word does not apply."""
    return Column(name, "text", "", text)


WHEN = (
    word("match", "name of the match: its file's, without the ending"),
    whole("frame", "0 at the start of the recording, n after control step n"),
    number("time", "s", "time since the recording began"),
    whole("period", "1 first half, 2 second half, 5 penalty shoot-out"),
    number("clock", "s", "time of play in this period"),
)
TRACKING = (
    *WHEN,
    word("phase", "phase of play: play, or the restart that is waited for"),
    Column("in_play", "flag", "", "whether the ball is in play"),
    whole("home_direction", "+1: home attacks +x in this frame, -1: it attacks -x"),
    word("object", "ball, or the robot: home_0, away_2"),
    word("team", "home or away; empty for the ball"),
    whole("number", "of the robot in its team, from 0; -1 for the ball"),
    number("x", "m", "along the pitch, from the centre spot"),
    number("y", "m", "across the pitch, from the centre spot"),
    number("heading", "rad", "where the robot faces, counter-clockwise from +x; missing for the ball"),
    number("vx", "m/s", "velocity along x"),
    number("vy", "m/s", "velocity along y"),
    Column("on_pitch", "flag", "", "false for a robot that is sent off or serves a penalty"),
    Column("has_ball", "flag", "", "whether the ball lies in the robot's pocket or at its kicker"),
)
EVENTS = (
    *WHEN,
    word("event", "kick, pass, interception, shot, save, goal, foul, restart, ball_out, in_play, separation, ..."),
    word("team", "home or away, whose event it is: of a foul who committed it, of a restart who takes it"),
    word("robot", "home_0, away_2; empty where no single robot did it"),
    number("x", "m", "the ball along the pitch: of passes and shots where it was played"),
    number("y", "m", "the ball across the pitch"),
    word(
        "outcome",
        "pass: successful, intercepted; shot: goal, saved, blocked, off_target; goal, foul, restart: its kind",
    ),
    whole("end_frame", "of passes and shots: the frame in which it was decided; -1 for others"),
    number("end_x", "m", "where the ball was then"),
    number("end_y", "m", "where the ball was then"),
    word("receiver", "robot at which a pass arrived, a mate or an opponent"),
    whole("home_score", "goals of home after the frame"),
    whole("away_score", "goals of away after the frame"),
)
TABLES = {"tracking": TRACKING, "events": EVENTS}


def tracking_table(recording: Collected) -> Table:
    """Return the tracking table: one row for each frame and object, frame by frame, the ball first."""
    frames, robots = recording.robots["x"].shape
    objects = robots + 1
    every = np.repeat(np.arange(frames), objects)
    names = np.array([BALL, *(player.name for player in recording.players)], object)
    sides = np.array(["", *(player.side for player in recording.players)], object)
    numbers = np.array([-1, *(player.number for player in recording.players)])
    table: Table = {name: values[every] for name, values in moments(recording).items()}
    table["object"], table["team"] = np.tile(names, frames), np.tile(sides, frames)
    table["number"] = np.tile(numbers, frames)
    for at, name in enumerate(("x", "y", "vx", "vy")):
        table[name] = beside(recording.ball[:, at], recording.robots[name])
    table["heading"] = beside(np.full(frames, np.nan), recording.robots["heading"])
    table["on_pitch"] = beside(np.ones(frames, bool), recording.robots["active"] == 1)
    table["has_ball"] = beside(np.zeros(frames, bool), recording.robots["has_ball"] == 1)
    return {column.name: table[column.name] for column in TRACKING}


def moments(recording: Collected) -> Table:
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


def beside(ball: np.ndarray, robots: np.ndarray) -> np.ndarray:
    """Interleave values of the ball (T,) and of robots (T, R) frame by frame into one column (T * (R + 1),)."""
    return np.concatenate([ball[:, None], robots], axis=1).ravel()


def event_table(recording: Collected) -> Table:
    """Return the table of events: one row for each event, in the order of frames."""
    events, when = recording.events, moments(recording)
    frames = np.array([event.frame for event in events], np.int64)
    names = {NOBODY: "", **{player.row: player.name for player in recording.players}}
    table: Table = {column.name: when[column.name][frames] for column in WHEN}
    table |= {
        "event": words([event.kind for event in events]),
        "team": words([SIDES.get(event.team, "") for event in events]),
        "robot": words([names.get(event.row, "") for event in events]),
        "x": np.array([event.x for event in events], np.float64),
        "y": np.array([event.y for event in events], np.float64),
        "outcome": words([event.outcome for event in events]),
        "end_frame": np.array([event.end_frame for event in events], np.int64),
        "end_x": np.array([event.end_x for event in events], np.float64),
        "end_y": np.array([event.end_y for event in events], np.float64),
        "receiver": words([names.get(event.receiver, "") for event in events]),
        "home_score": recording.score[frames, 0],
        "away_score": recording.score[frames, 1],
    }
    return {column.name: table[column.name] for column in EVENTS}


def words(values: list[Any]) -> np.ndarray:
    """Return a list of words as a column, an array of objects."""
    column = np.empty(len(values), object)
    column[:] = values
    return column


def tables_of(recording: Collected) -> dict[str, Table]:
    """Return both tables of a match by name."""
    return {"tracking": tracking_table(recording), "events": event_table(recording)}
