"""The data of a page: tables of places over time, events, the field, the teams.

Tables hold whole numbers of 16 bits: lengths in mm, angles in mrad, clocks in 0.1 s.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.match.arguments import version
from soccer_env.render.captions import PHASES
from soccer_env.render.frame import one_line
from soccer_env.render.overlays.cast import camera_of, count_line_directions
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.render.robots import robot_pieces
from soccer_env.shows.browser.events import EventCollector
from soccer_env.shows.browser.fields import ForceFrames, pack_table
from soccer_env.thoughts.thoughts import SEES, TABLE, TRACK, Notes, round_to_int16
from soccer_env.types import Phase

if TYPE_CHECKING:
    from soccer_env.replay.replay_file import Replay

PER_SECOND = 25  # [1/s] rows of the table of places, at most
GENERAL = ("ball_x", "ball_y", "clock", "half", "phase", "team", "score_home", "score_away", "direction", "touch")
EACH = ("x", "y", "heading", "pan", "state")  # of a robot
STATES = {"active": 1, "has_ball": 2, "fallen": 4, "kicks": 8}  # bits of `state`
MILLI, DECI = 1000.0, 10.0


def collect_page_data(
    replay: Replay, note: Callable[[int], None] | None = None, flags: OverlayFlags | None = None
) -> dict[str, Any]:
    """Play the first match of a replay and return the data of a page; `flags`: the overlays at first."""
    playing = replay.play()
    match = next(playing)
    every = max(1, match.league.control_rate // PER_SECOND)
    stories, rows, last = EventCollector(match, replay.teams), [place_row(match)], match.robots[0].copy()
    notes = replay.notes()
    fields = ForceFrames(replay, match, notes, flags)
    staged: np.ndarray | None = None  # the row before a restart after a goal moved all robots, since the last row
    for step, match in enumerate(playing, 1):
        stories.listen(match, step, last)
        if match.events["restart"][0] and match.events["goal"][0] >= 0:
            staged = place_row(match, last)
        if step % every == 0:
            rows.append(place_row(match) if staged is None else staged)
            staged = None
        fields.look(match, step)
        last = match.robots[0].copy()
        if note is not None:
            note(1)
    return {
        **about(match, replay),
        "every": every,
        "rows": len(rows),
        "columns": {"general": GENERAL, "each": EACH, "states": STATES},
        "events": stories.events,
        "shown": None if flags is None or not flags.any else {**asdict(flags), "robot": flags.agent},
        "thoughts": None if notes is None else note_columns(notes),
        "fields": fields.about() if fields.any else None,
        "tables": page_tables(rows, notes, fields),
    }


def page_tables(rows: list[np.ndarray], notes: Notes | None, fields: ForceFrames) -> dict[str, str]:
    """Return the tables of places, thoughts and fields by name, packed as text."""
    tables = {"places": pack_table(np.stack(rows))}
    if notes is not None:
        tables["thoughts"] = pack_table(notes.numbers.reshape(len(notes.numbers), -1))  # (T, R * C)
    if fields.any:
        tables["fields"] = fields.packed()
    return tables


def note_columns(notes: Notes) -> dict[str, Any]:
    """Return the control steps of the notes, and the meaning of the columns of their table."""
    about = {"steps": notes.steps.tolist(), "slots": notes.slots, "fields": notes.fields, "groups": notes.groups}
    return about | {"table": TABLE, "track": TRACK, "sees": SEES}


def place_row(match: Match, robots: np.ndarray | None = None) -> np.ndarray:
    """Return a row (C,) int16 of the table of places, of the first match; `robots`: records from before a goal."""
    record, ball, event = match.matches[0], match.balls[0], match.events[0]
    x, y = (ball["x"], ball["y"]) if robots is None else (event["ball_x"], event["ball_y"])
    robots = match.robots[0] if robots is None else robots
    general = [MILLI * x, MILLI * y, DECI * record["clock"], record["half"], record["phase"], record["restart_team"]]
    general += [*record["score"], record["home_direction"], record["last_touch_robot"]]
    kicks = (robots["kick_clock"] > 0.0) & (robots["kick_strength"] > 0.0)
    flags = (robots["active"] == 1, robots["has_ball"] == 1, robots["fallen"] > 0.0, kicks)
    state = sum(np.where(flag, bit, 0) for flag, bit in zip(flags, STATES.values(), strict=True))
    each = [MILLI * robots[name] for name in EACH[:-1]]
    return np.concatenate(
        [round_to_int16(np.array(general, float)), round_to_int16(np.stack([*each, state], axis=1)).ravel()]
    )


def about(match: Match, replay: Replay) -> dict[str, Any]:
    """Return teams, league, field and robots; names come from a file, and the page shows them only as text."""
    league, robots = match.league, match.robots[0]
    sensors = replay.settings["league"].get("sensors")  # the league of a replay has none
    camera = camera_of(sensors)
    on_head: dict[str, Any] = {"view": 0.0, "neck": 0.0, "focal": 1.0, "image": [0, 0]}  # [rad], [m], [px]
    if camera is not None:
        size = [camera.width, camera.height]
        on_head = {"view": camera.view, "neck": camera.neck, "focal": camera.focal, "image": size}
    return {
        "version": version(),
        "recorded": one_line(replay.made_by)[:40],
        "teams": [one_line(name)[:120] for name in replay.teams],
        "league": one_line(league.name)[:120],
        "rate": league.control_rate,
        "steps": len(replay),
        "half_length": float(match.matches["half_length"][0]) if np.isfinite(match.matches["half_length"][0]) else None,
        "robots": [[int(robot["team"]), int(robot["number"]), int(robot["keeper"])] for robot in robots],
        "phases": {int(phase): words for phase, words in PHASES.items()} | {int(Phase.OVER): "final whistle"},
        "pitch": field_dimensions(league),
        "body": robot_outlines(league),
        **on_head,
        "directions": count_line_directions(sensors),
    }


def field_dimensions(league: League) -> dict[str, Any]:
    """Return the dimensions of the field [m]."""
    pitch = league.pitch
    names = (
        "length", "width", "goal_width", "goal_depth", "penalty_depth", "penalty_width", "circle", "walled",
        "goal_area_depth", "goal_area_width", "band_side", "band_end", "line",
    )  # fmt: skip
    return {name: getattr(pitch, name) for name in names} | {"ball": league.ball.radius}


def robot_outlines(league: League) -> dict[str, Any]:
    """Return the outlines of a robot [m, robot frame]: pieces with their role, lowest first."""
    parts = robot_pieces(league.body, 0.0, walks=bool(league.body.legs))
    pieces = [[part.role, [[round(x, 3), round(y, 3)] for x, y in part.outline]] for part in parts]
    body = league.body
    return {"pieces": pieces, "legs": bool(body.legs), "reach": body.reach, "disc": [body.disc_x, body.disc_radius]}
