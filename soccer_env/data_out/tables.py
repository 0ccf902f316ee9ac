"""Tidy tables: one row for each frame and object, and one for each event, with a unit and a meaning for each column.

Places are in the field frame, in metres: origin at the centre spot, x along the pitch, y to the left of x. They are
not turned: teams change sides at half-time, and `home_direction` says in which direction home attacks.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.data_out.belief_errors import BeliefErrors
from soccer_env.data_out.collect import PHASES, SIDES, MatchRecording
from soccer_env.data_out.events import NOBODY

Table = dict[str, np.ndarray]  # a column (rows,) by name
OWN, BALL = "own", "ball"
PLACES = ("x", "y", "end_x", "end_y")  # of an event


@dataclass(frozen=True)
class Column:
    """A column of a table: words (empty where they do not apply), whole numbers, numbers (else NaN) or flags."""

    name: str
    text: str
    kind: str = "text"  # or "whole", "number", "flag"
    unit: str = ""  # of numbers


WHEN = (
    Column("match", "name of the match: its file's, without the ending"),
    Column("frame", "0 at the start of the recording, n after control step n", "whole"),
    Column("time", "time since the recording began", "number", "s"),
    Column("period", "1 first half, 2 second half, 5 penalty shoot-out", "whole"),
    Column("clock", "time of play in this period", "number", "s"),
)
TRACKING = (
    *WHEN,
    Column("phase", "phase of play: play, or the restart that is waited for"),
    Column("in_play", "whether the ball is in play", "flag"),
    Column("home_direction", "+1: home attacks +x in this frame, -1: it attacks -x", "whole"),
    Column("object", "ball, or the robot: home_0, away_2"),
    Column("team", "home or away; empty for the ball"),
    Column("number", "of the robot in its team, from 0; -1 for the ball", "whole"),
    Column("x", "along the pitch, from the centre spot", "number", "m"),
    Column("y", "across the pitch, from the centre spot", "number", "m"),
    Column("heading", "where the robot faces, counter-clockwise from +x; missing for the ball", "number", "rad"),
    Column("vx", "velocity along x", "number", "m/s"),
    Column("vy", "velocity along y", "number", "m/s"),
    Column("on_pitch", "false for a robot that is sent off or serves a penalty", "flag"),
    Column("has_ball", "whether the ball lies in the robot's pocket or at its kicker", "flag"),
)
EVENTS = (
    *WHEN,
    Column("event", "kick, pass, interception, shot, save, goal, foul, restart, ball_out, in_play, separation, ..."),
    Column("team", "home or away, whose event it is: of a foul who committed it, of a restart who takes it"),
    Column("robot", "home_0, away_2; empty where no single robot did it"),
    Column("x", "the ball along the pitch: of passes and shots where it was played", "number", "m"),
    Column("y", "the ball across the pitch", "number", "m"),
    Column(
        "outcome",
        "pass: successful, intercepted; shot: goal, saved, blocked, off_target; goal, foul, restart: its kind",
    ),
    Column("end_frame", "of passes and shots: the frame in which it was decided; -1 for others", "whole"),
    Column("end_x", "where the ball was then", "number", "m"),
    Column("end_y", "where the ball was then", "number", "m"),
    Column("receiver", "robot at which a pass arrived, a mate or an opponent"),
    Column("home_score", "goals of home after the frame", "whole"),
    Column("away_score", "goals of away after the frame", "whole"),
)
BELIEFS = (
    *WHEN,
    Column("robot", "who believes it: home_0, away_2"),
    Column("object", "own (its place), ball, teammate or opponent; of players a row for each that it believes in"),
    Column("believed_x", "own: in its team's frame, own goal behind; else ahead of the robot", "number", "m"),
    Column("believed_y", "own: in its team's frame; else to the left of the robot; missing if unknown", "number", "m"),
    Column("true_x", "the truth beside believed_x; of a player the nearest one of the team", "number", "m"),
    Column("true_y", "the truth beside believed_y", "number", "m"),
    Column("error", "distance between both", "number", "m"),
    Column("range", "true distance from the robot; 0 for its own place", "number", "m"),
    Column("age", "time since it was seen; missing if it was not seen yet", "number", "s"),
    Column("confidence", "0 to 100; missing for players", "number"),
)
TABLES = {"tracking": TRACKING, "events": EVENTS, "beliefs": BELIEFS}


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
        "outcome": word_array([event.outcome for event in events]),
        "end_frame": np.array([event.end_frame for event in events], np.int64),
        "receiver": word_array([names.get(event.receiver, "") for event in events]),
        "home_score": recording.score[frames, 0],
        "away_score": recording.score[frames, 1],
        **{name: np.array([getattr(event, name) for event in events], np.float64) for name in PLACES},
    }
    return {column.name: table[column.name] for column in EVENTS}


def word_array(values: list[Any]) -> np.ndarray:
    """Return a list of words as a column, an array of objects."""
    column = np.empty(len(values), object)
    column[:] = values
    return column


def belief_table(recording: MatchRecording, errors: BeliefErrors) -> Table:
    """Return the table of beliefs: for each noted frame and robot its own place, the ball, and each player tracked."""
    shown = np.ones(errors.error.shape, bool)
    shown[..., 2:] = ~np.isnan(errors.believed[..., 2:, 0])
    rows, robots, objects = np.nonzero(shown)
    frames = recording.noted[rows]
    kinds = np.where(errors.teammate, "teammate", "opponent").astype(object)
    kinds[..., 0], kinds[..., 1] = OWN, BALL
    when = frame_columns(recording)
    table: Table = {column.name: when[column.name][frames] for column in WHEN}
    table["robot"] = word_array([player.name for player in recording.players])[robots]
    table["object"] = kinds[rows, robots, objects]
    for at, axis in enumerate("xy"):
        table[f"believed_{axis}"], table[f"true_{axis}"] = errors.believed[shown][:, at], errors.true[shown][:, at]
    age = np.where(np.isfinite(errors.age), errors.age, np.nan)
    table |= {"error": errors.error[shown], "range": errors.range[shown], "age": age[shown]}
    table["confidence"] = errors.confidence[shown]
    return table


def match_tables(recording: MatchRecording) -> dict[str, Table]:
    """Return the tables of a match by name; that of beliefs if they were collected."""
    tables = {"tracking": tracking_table(recording), "events": event_table(recording)}
    beliefs = recording.beliefs
    return tables if beliefs is None else {**tables, "beliefs": belief_table(recording, beliefs)}
