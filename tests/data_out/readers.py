"""Read every format that a match is exported to, by its own documentation alone: places in m, speeds in m/s.

Each reader returns arrays by name, a row for each row of the file: `frame` of the recording and whatever the format
tells of `ball` (T, 2), `robots` (T, R, 2), NaN where a robot is missing, `speeds` (T, R), `owner` (T,) and so on.
"""

from __future__ import annotations

import base64
import csv
import json
import zlib
from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.data_out import kloppy_tracking
from soccer_env.data_out.collect import MatchRecording
from soccer_env.data_out.standard import KICK_OFF, write_standard
from soccer_env.data_out.table_files import write_tables
from soccer_env.data_out.tables import match_tables
from soccer_env.replay import Replay
from soccer_env.shows.browser.collect import collect_page_data

Told = dict[str, np.ndarray]
NAN = float("nan")


def frame_at(stamp: str, rate: int) -> int:
    """Return the control step of a time of the recording."""
    return round((datetime.fromisoformat(stamp.replace("Z", "+00:00")) - KICK_OFF).total_seconds() * rate)


def from_csv(_: Replay, found: MatchRecording, folder: Path) -> Told:
    path = write_tables([match_tables(found)], folder / "x.csv")["tracking"]
    with path.open(encoding="utf-8", newline="") as file:
        return frames_from_table([*csv.DictReader(file)], len(found.players), lambda text: float(text or NAN))


def from_parquet(_: Replay, found: MatchRecording, folder: Path) -> Told:
    from pyarrow import parquet

    path = write_tables([match_tables(found)], folder / "x.parquet")["tracking"]
    rows = parquet.read_table(path).to_pylist()
    return frames_from_table(rows, len(found.players), lambda x: NAN if x is None else float(x))


def frames_from_table(rows: list[dict[str, Any]], robots: int, number: Any) -> Told:
    """Return a tracking table, frame by frame: the ball and then the robots."""
    shape = (-1, robots + 1)
    of_frames = ("frame", "time", "period", "clock", "home_direction")
    names = (*of_frames, "x", "y", "vx", "vy", "heading")
    numbers = {name: np.array([number(row[name]) for row in rows]).reshape(shape) for name in names}
    names = ("in_play", "has_ball", "on_pitch")
    flags = {name: np.array([row[name] in (True, "true") for row in rows]).reshape(shape) for name in names}
    place, velocity = (np.stack([numbers[x], numbers[y]], axis=-1) for x, y in (("x", "y"), ("vx", "vy")))
    return {
        **{name: numbers[name][:, 0] for name in of_frames},
        "in_play": flags["in_play"][:, 0], "has_ball": flags["has_ball"][:, 1:], "on_pitch": flags["on_pitch"][:, 1:],
        "ball": place[:, 0], "every_robot": place[:, 1:], "headings": numbers["heading"][:, 1:],
        "ball_velocity": velocity[:, 0], "velocities": velocity[:, 1:],
    }  # fmt: skip


def from_standard(_: Replay, found: MatchRecording, folder: Path) -> Told:
    lines = (write_standard(found, folder / "x.cdf") / "tracking.jsonl").read_text().splitlines()
    rows = [json.loads(line) for line in lines]
    names = {player.name: player.row for player in found.players}
    robots, speeds = np.full((len(rows), len(names), 2), NAN), np.full((len(rows), len(names)), NAN)
    for at, row in enumerate(rows):
        for side in ("home", "away"):
            for one in row["teams"][side]["players"]:
                robots[at, names[one["id"]]], speeds[at, names[one["id"]]] = (one["x"], one["y"]), one["vel"]
    return {
        "frame": np.array([frame_at(row["timestamp"], found.league.control_rate) for row in rows]),
        "period": np.array([{"first_half": 1, "second_half": 2}[row["period"]] for row in rows]),
        "turned_ball": np.array([(row["ball"]["x"], row["ball"]["y"]) for row in rows]),
        "turned_robots": robots, "speeds": speeds, "in_play": np.array([row["ball"]["status"] for row in rows]),
    }  # fmt: skip


def from_kloppy(replay: Replay, found: MatchRecording, _: Path) -> Told:
    dataset = kloppy_tracking(replay)
    names = {player.name: player.row for player in found.players}
    shape = (len(dataset.frames), len(names))
    robots, speeds, headings = np.full((*shape, 2), NAN), np.full(shape, NAN), np.full(shape, NAN)
    for at, frame in enumerate(dataset.frames):
        for player, one in frame.players_data.items():
            row = names[player.player_id]
            robots[at, row], speeds[at, row] = (one.coordinates.x, one.coordinates.y), one.speed
            headings[at, row] = one.other_data["heading"]
    frames, owners = dataset.frames, {"home": 0, "away": 1}
    since = [f.period.start_timestamp.total_seconds() + f.timestamp.total_seconds() for f in frames]
    return {
        "frame": np.rint(np.array(since) * found.league.control_rate), "robots": robots, "speeds": speeds,
        "period": np.array([frame.period.id for frame in frames]),
        "ball": np.array([(frame.ball_coordinates.x, frame.ball_coordinates.y) for frame in frames]),
        "ball_speed": np.array([frame.ball_speed for frame in frames]),
        "owner": np.array([owners[f.ball_owning_team.team_id] if f.ball_owning_team else -1 for f in frames]),
        "in_play": np.array([frame.ball_state.value == "alive" for frame in frames]),
    }  # fmt: skip


def from_page(replay: Replay, found: MatchRecording, _: Path) -> Told:
    page = collect_page_data(replay)
    columns, robots = page["columns"], len(page["robots"])
    planes = np.frombuffer(zlib.decompress(base64.b64decode(page["tables"]["places"])), np.uint8).astype(int)
    folded = (planes[: len(planes) // 2] + 256 * planes[len(planes) // 2 :]).reshape(-1, page["rows"])
    table = np.cumsum(np.where(folded % 2, -(folded + 1) // 2, folded // 2), axis=1).astype(np.int16).T
    general = dict(zip(columns["general"], table.T, strict=False))
    each = table[:, len(columns["general"]) :].reshape(-1, robots, len(columns["each"]))
    parts = dict(zip(columns["each"], np.moveaxis(each, 2, 0), strict=True))
    scored = np.array([one[0] for one in page["events"] if one[1] == "goal"])
    frame = page["every"] * np.arange(page["rows"])
    shown = ~(np.abs(frame[:, None] - scored) <= page["every"]).any(axis=1)  # else the places before the goal
    flags = {name: parts["state"] & bit > 0 for name, bit in columns["states"].items()}
    told = {
        "frame": frame, "ball": np.stack([general["ball_x"], general["ball_y"]], axis=-1) / 1000.0,
        "every_robot": np.stack([parts["x"], parts["y"]], axis=-1) / 1000.0, "headings": parts["heading"] / 1000.0,
        "clock": general["clock"] / 10.0, "period": general["half"] + 1, "home_direction": general["direction"],
        "score": np.stack([general["score_home"], general["score_away"]], axis=-1),
        "has_ball": flags["has_ball"], "on_pitch": flags["active"],
    }  # fmt: skip
    return {name: numbers[shown] for name, numbers in told.items()}


READERS = {"csv": from_csv, "parquet": from_parquet, "cdf": from_standard}
READERS |= {"kloppy": from_kloppy, "page": from_page}
