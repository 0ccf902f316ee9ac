"""A match in the Common Data Format [Anzer et al. 2025, arXiv 2505.15820], version 0.3.2: a folder of four files.

| file | what it holds |
|---|---|
| meta.json | pitch, players, periods and sides |
| match.json | the match sheet: result, players, goals, cards |
| tracking.jsonl | a line for each frame: robots on the pitch and the ball [m] |
| event.jsonl | a line for each pass, shot, interception, save, foul and whistle |

The format needs one direction of play: home attacks +x in all periods, so places of the second half are turned by
180 degrees (`left_team_id` names the team that really plays on the left). It needs dates: every match begins at the
arbitrary date KICK_OFF. The format has goals as shots, so a goal without a shot (carried or bumped in) becomes a shot
of its scorer, and so does an own goal.
"""

import json
from collections.abc import Iterator
from contextlib import nullcontext
from datetime import datetime, timedelta, timezone
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.data_out.collect import SHOOT_OUT, SIDES, MatchRecording, Player
from soccer_env.data_out.events import NOBODY, Event
from soccer_env.guards.whole_files import atomic_folder, write_atomically
from soccer_env.match.arguments import version

VERSION = "0.3.2"  # of the Common Data Format
KICK_OFF = datetime(2000, 1, 1, tzinfo=timezone.utc)
FILES = ("meta.json", "match.json", "tracking.jsonl", "event.jsonl")
PERIODS = {1: "first_half", 2: "second_half", SHOOT_OUT: "shootout"}
OUTCOMES = {"goal": "successful", "saved": "saved", "blocked": "blocked", "off_target": "wide"}
REFEREE = "referee"
WHISTLES = {"half_time": "half_time", "final_whistle": "final_whistle"}
DIGITS = 4  # of a metre: tenths of a millimetre


def write_standard(recording: MatchRecording, folder: Path) -> Path:
    """Write a match as four files of a folder, which replaces an earlier folder, whole or not at all.

    In a folder with other files the four files are replaced one by one.
    """
    match = CommonDataMatch(recording)
    sheets = (json.dumps(sheet, indent=2) + "\n" for sheet in (match.meta(), match.sheet()))
    contents = dict(zip(FILES, [*sheets, json_lines(match.tracking()), json_lines(match.events())], strict=True))
    shared = folder.exists() and not {file.name for file in folder.iterdir()} <= contents.keys()
    with nullcontext(folder) if shared else atomic_folder(folder) as written:
        for name, content in contents.items():
            write_atomically(written / name, content)
    return folder


def json_lines(records: Iterator[dict[str, Any]]) -> str:
    """Return records as JSON, one a line."""
    return "".join(json.dumps(record, separators=(",", ":"), allow_nan=False) + "\n" for record in records)


class CommonDataMatch:
    """A match in the words of the Common Data Format."""

    def __init__(self, recording: MatchRecording) -> None:
        self.recording = recording
        self.periods = recording.periods
        self.direction = recording.match["home_direction"]
        self.shot_in = {(event.end_frame, event.team) for event in recording.events if event.outcome == "goal"}

    def time(self, frame: int) -> str:
        """Return the time of a frame as UTC."""
        at = KICK_OFF + timedelta(seconds=frame / self.recording.league.control_rate)
        return at.isoformat(timespec="microseconds").replace("+00:00", "Z")

    def period(self, frame: int) -> str:
        """Return the name of the period of a frame."""
        return PERIODS[int(self.periods[frame])]

    def place(self, frame: int, x: float, y: float) -> tuple[float, float]:
        """Return a place [m] in the frame in which home attacks +x."""
        sign = float(self.direction[frame])
        return round(sign * x, DIGITS) + 0.0, round(sign * y, DIGITS) + 0.0

    def meta(self) -> dict[str, Any]:
        """Return the content of meta.json."""
        recording, pitch = self.recording, self.recording.league.pitch
        vendor = {"version": version(), "name": "soccer_env"}
        periods = [self.about_period(period) for period in self.numbers()]
        return {
            "competition": {"id": "soccer_env", "name": "soccer_env"},
            "season": {"id": "none"},
            "match": {
                "id": recording.name,
                "kickoff_time": self.time(0),
                "periods": periods,
                "whistles": [
                    {"type": period["period"], "sub_type": sub_type, "time": period[f"{sub_type}_time"]}
                    for period in periods
                    for sub_type in ("start", "end")
                ],
            },
            "teams": {
                side: {"id": side, "name": team, "players": [self.about(player) for player in self.of(side)]}
                for side, team in zip(("home", "away"), recording.teams, strict=True)
            },
            "venue": {
                "id": recording.league.name, "pitch_length": float(pitch.length), "pitch_width": float(pitch.width),
            },
            "meta": {
                "video": None, "landmarks": None, "ball": None, "meta": vendor, "cdf": {"version": VERSION},
                "tracking": {**vendor, "fps": recording.league.control_rate, "collection_timing": "live"},
                "event": {**vendor, "collection_timing": "post_match"},
            },
        }  # fmt: skip

    def numbers(self) -> list[int]:
        """Return the numbers of the recorded periods."""
        periods: list[int] = np.unique(self.periods).tolist()
        return periods

    def about_period(self, period: int) -> dict[str, Any]:
        """Return the entry of a period in meta.json."""
        frames = np.flatnonzero(self.periods == period)
        first, last = int(frames[0]), int(frames[-1])
        left, right = ("home", "away") if self.direction[last] > 0.0 else ("away", "home")
        return {
            "period": PERIODS[period], "play_direction": "left_right", "left_team_id": left, "right_team_id": right,
            "start_time": self.time(first), "end_time": self.time(last),
            "frame_id_start": first, "frame_id_end": last,
        }  # fmt: skip

    def of(self, side: str) -> list[Player]:
        """Return the robots of a side."""
        return [player for player in self.recording.players if player.side == side]

    def about(self, player: Player) -> dict[str, Any]:
        """Return the entry of a robot in meta.json."""
        starter = bool(self.recording.robots["active"][0, player.row] == 1)
        return {
            "id": player.name, "team_id": player.side, "jersey_number": player.number, "is_starter": starter,
            "first_name": player.side, "last_name": str(player.number),
        }  # fmt: skip

    def sheet(self) -> dict[str, Any]:
        """Return the content of match.json."""
        recording = self.recording
        home, away = (int(goals) for goals in recording.score[-1])
        first = recording.score[self.periods == 1]
        half = first[-1].tolist() if len(first) else [0, 0]
        played = (recording.robots["active"] == 1).any(axis=0)
        return {
            "match": {
                "id": recording.name,
                "status": {"is_neutral": True, "has_extratime": False, "has_shootout": False},
                "result": {
                    "final": {
                        "home": home, "away": away,
                        "winning_team_id": None if home == away else "home" if home > away else "away",
                    },
                    "first_half": dict(zip(("home", "away"), half, strict=True)),
                    "second_half": {"home": home - half[0], "away": away - half[1]},
                },
            },
            "teams": {
                side: {
                    "id": side,
                    "players": [
                        {**self.about(player), "has_played": bool(played[player.row])} for player in self.of(side)
                    ],
                }
                for side in ("home", "away")
            },
            "officials": [{"id": REFEREE, "type": "main_referee"}],
            "events": {"goals": list(self.goals()), "substitutions": None, "cards": None},
            "meta": {"vendor": "soccer_env"},
        }  # fmt: skip

    def goals(self) -> Iterator[dict[str, Any]]:
        """Yield the goals of the match sheet; the scorer is "unknown" if no robot touched the ball."""
        for goal in self.recording.events:
            if goal.kind == "goal":
                yield {
                    "time": self.time(goal.frame), "period": self.period(goal.frame), "team_id": SIDES[goal.team],
                    "player_id": self.name(goal.row), "assist_id": None, "is_penalty": False,
                    "is_own_goal": goal.outcome == "own_goal",
                    "score": dict(zip(("home", "away"), self.recording.score[goal.frame].tolist(), strict=True)),
                }  # fmt: skip

    def name(self, row: int) -> str:
        """Return the id of a robot (row), "unknown" for nobody."""
        return self.recording.players[row].name if row != NOBODY else "unknown"

    def tracking(self) -> Iterator[dict[str, Any]]:
        """Yield the lines of tracking.jsonl."""
        recording, in_play = self.recording, self.recording.in_play
        sides = [(side, self.of(side)) for side in ("home", "away")]
        speeds = np.hypot(recording.robots["vx"], recording.robots["vy"])
        for frame in range(len(recording)):
            x, y = self.place(frame, recording.ball[frame, 0], recording.ball[frame, 1])
            yield {
                "frame_id": frame, "timestamp": self.time(frame), "period": self.period(frame),
                "match": {"id": recording.name},
                "teams": {
                    side: {"id": side, "players": [self.tracked_place(frame, player, speeds) for player in players
                                                   if recording.robots["active"][frame, player.row] == 1]}
                    for side, players in sides
                },
                "ball": {"x": x, "y": y, "z": recording.league.ball.radius, "status": bool(in_play[frame])},
            }  # fmt: skip

    def tracked_place(self, frame: int, player: Player, speeds: np.ndarray) -> dict[str, Any]:
        """Return the place of a robot in a frame."""
        robots, row = self.recording.robots, player.row
        x, y = self.place(frame, robots["x"][frame, row], robots["y"][frame, row])
        return {"id": player.name, "x": x, "y": y, "vel": round(float(speeds[frame, row]), DIGITS)}

    def events(self) -> Iterator[dict[str, Any]]:
        """Yield the lines of event.jsonl."""
        number = 0
        for event in self.recording.events:
            fields = self.event_fields(event)
            if fields is None:
                continue
            number += 1
            yield {
                "match": {"id": self.recording.name},
                "meta": {"is_synced": True},
                "event": {"id": f"event_{number}", **fields},
                "tracking": {"frame_id": event.frame},
            }

    def event_fields(self, event: Event) -> dict[str, Any] | None:
        """Return the fields of an event in the format; None for an event that the format does not have."""
        if event.kind == "pass":
            return self.played(event, "pass", None, event.outcome, event.outcome == "successful")
        if event.kind == "shot":
            return self.played(event, "shot", None, OUTCOMES[event.outcome], event.outcome == "goal")
        if event.kind == "goal" and (event.frame, event.team) not in self.shot_in:
            own = event.outcome == "own_goal"
            return self.played(event, "shot", None, "own_goal" if own else "successful", not own)
        if event.kind == "interception":
            return self.played(event, "defending", "interception", "interception", True)
        if event.kind == "save":
            return self.played(event, "goalkeeping", "save", "save", True)
        if event.kind == "foul":
            return self.called(event, "foul", event.outcome)
        if event.kind in WHISTLES:
            return self.called(event, WHISTLES[event.kind], "end")
        return None

    def common(self, event: Event) -> dict[str, Any]:
        """Return the fields that all events have."""
        x, y = self.place(event.frame, event.x, event.y)
        return {
            "time": self.time(event.frame), "period": self.period(event.frame), "x": x, "y": y,
            "receiver_id": None, "receiver_time": None, "receiver_team_id": None,
            "x_end": None, "y_end": None, "body_part": None, "related_event_ids": None,
        }  # fmt: skip

    def called(self, event: Event, sub_type: str, outcome: str) -> dict[str, Any]:
        """Return the fields of a call of the referee."""
        return {
            **self.common(event), "type": "referee", "sub_type": sub_type, "outcome_type": outcome,
            "is_successful": True, "official_id": REFEREE,
        }  # fmt: skip

    def played(self, event: Event, kind: str, sub_type: str | None, outcome: str, good: bool) -> dict[str, Any]:
        """Return the fields of an event in which a robot plays the ball."""
        fields = {
            **self.common(event), "type": kind, "sub_type": sub_type, "outcome_type": outcome, "is_successful": good,
            "player_id": self.name(event.row), "team_id": SIDES[event.team],
        }  # fmt: skip
        if kind in ("pass", "shot"):
            end = event.end_frame if event.end_frame != NOBODY else event.frame
            x, y = (event.end_x, event.end_y) if event.end_frame != NOBODY else (event.x, event.y)
            fields["x_end"], fields["y_end"] = self.place(end, x, y)
            fields["body_part"] = "other"
        if event.receiver != NOBODY:
            fields |= {
                "receiver_id": self.name(event.receiver), "receiver_time": self.time(event.end_frame),
                "receiver_team_id": self.recording.players[event.receiver].side,
            }  # fmt: skip
        return fields
