"""`Cast`: the league and teams of a match; `Snapshot`: one moment of it. From a live match or a replay."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import pi, tan
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.leagues.robot_kind import POLAR
from soccer_env.match import Match
from soccer_env.match.settings import to_plain_types
from soccer_env.records.percepts import LINES
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.teams import Explanation, explanation_of, shipped_team
from soccer_env.thoughts.thought import NoteReader, Thought

if TYPE_CHECKING:
    from soccer_env.thoughts.thoughts import RecordedMatch

PIXELS = re.compile(r"([1-9]\d{1,3})x([1-9]\d{1,3})")


class Snapshot(NamedTuple):
    """Copies of the records of the first match at one moment."""

    match: np.void
    ball: np.void
    robots: np.ndarray  # (R,)
    note: np.ndarray | None = None  # (R, C) int16 thoughts of the robots, see `soccer_env.thoughts`


def take_snapshot(match: Match, note: np.ndarray | None = None) -> Snapshot:
    """Return a shot of the first match now."""
    return Snapshot(match.matches[0].copy(), match.balls[0].copy(), match.robots[0].copy(), note)


class Camera(NamedTuple):
    """A camera on a head."""

    view: float  # [rad] width of the field of view
    neck: float  # [m] axis of the head, ahead of the robot's middle
    width: float  # [px] of its picture
    height: float  # [px]

    @property
    def focal(self) -> float:
        """Return the focal length for widths [px]."""
        return 0.5 * self.width / tan(0.5 * self.view)


def camera_of(sensors: object) -> Camera | None:
    """Return the camera of some sensor settings; None for an omnidirectional or unknown camera."""
    settings = sensors if isinstance(sensors, Mapping) else {}
    view, neck = settings.get("view_width"), settings.get("neck_ahead")
    pixels = PIXELS.fullmatch(str(settings.get("resolution")))
    if not isinstance(view, (int, float)) or not isinstance(neck, (int, float)) or pixels is None:
        return None
    if not (0.0 < view < pi and abs(neck) < 1.0):
        return None
    return Camera(float(view), float(neck), float(pixels[1]), float(pixels[2]))


class TeamPart(NamedTuple):
    """A team: its name, its explanation and its settings."""

    name: str
    explanation: Explanation | None
    settings: np.ndarray | None


@dataclass(frozen=True)
class Cast:
    """The constant facts of a match: the league, the teams, and the meaning of notes."""

    league: League
    agents: Sequence[str]
    camera: Camera | None
    ranger: bool  # whether robots have an infrared ranger
    parts: Mapping[int, TeamPart]  # of robots that a team plays
    reader: NoteReader | None = None
    constants: np.ndarray = field(default_factory=lambda: np.zeros(0))
    why_no_notes: str = ""
    line_directions: int = LINES  # in which an omnidirectional camera looks for white lines

    @property
    def rays(self) -> list[str]:
        """Return the names of the note groups that are drawn as rays: sightings, but not the obstacle of a ranger."""
        groups = [] if self.reader is None else self.reader.groups
        return [name for name, _, parts in groups if parts == POLAR and name != "obstacle"]

    def thought(self, shot: Snapshot, r: int) -> Thought | None:
        """Return the thought of robot r, None if it was not noted."""
        if self.reader is None or shot.note is None:
            return None
        return self.reader.thought(shot.note, r)

    def selected_row(self, flags: OverlayFlags, shot: Snapshot) -> int:
        """Return the row of the selected robot, by default the nearest to the ball; ValueError for an unknown robot."""
        agent = flags.agent
        if agent is not None:
            if agent not in self.agents:
                raise ValueError(f"robot must be one of {', '.join(self.agents)}, or ball, got {flags.robot!r}")
            return list(self.agents).index(agent)
        robots = shot.robots
        away = np.hypot(robots["x"] - shot.ball["x"], robots["y"] - shot.ball["y"])
        away = np.where((robots["active"] == 1) & self.rows_with_beliefs(shot), away, np.inf)
        return int(np.argmin(away))

    def rows_with_beliefs(self, shot: Snapshot) -> np.ndarray:
        """Return flags (R,) of the robots with beliefs; all True if no robot has beliefs."""
        everybody = np.ones(len(shot.robots), bool)
        if self.reader is None or shot.note is None:
            return everybody
        thinking = self.reader.thinks(shot.note)
        return thinking if thinking.any() else everybody


def cast_of(match: Match, reader: NoteReader | None) -> Cast:
    """Return the cast of a match that is played now."""
    parts = {}
    for squad in match.squads:
        for r in squad.players.tolist():
            explanation = None if squad.lineup is not None else explanation_of(squad.team)
            parts[r] = TeamPart(squad.team.name, explanation, getattr(squad.team, "settings", None))
    league, sensors = match.league, to_plain_types(match.league.sensors)
    ranger, why = bool(getattr(league.sensors, "HAS_RANGER", False)), "nobody here believes anything"
    camera, directions = camera_of(sensors), count_line_directions(sensors)
    return Cast(league, match.agents, camera, ranger, parts, reader, match.batch.constants, why, directions)


def cast_of_replay(replay: RecordedMatch, match: Match, reader: NoteReader | None) -> Cast:
    """Return the cast of a replay, whose running match is `match`. Teams are found by name, with their own settings.

    Only shipped teams are looked up: a name in a file loads nothing else.
    """
    settings, sensors = replay.settings, replay.settings["league"].get("sensors")
    teams = settings.get("teams")
    parts = {}
    for row, agent in enumerate(match.agents):
        name = str(teams[agent]) if isinstance(teams, dict) and agent in teams else None
        team = None if name is None else shipped_team(name)
        if name is not None:
            parts[row] = TeamPart(name, None if team is None else explanation_of(team), getattr(team, "settings", None))
    why = "this replay keeps no thoughts: soccer record does"
    league, camera, directions = match.league, camera_of(sensors), count_line_directions(sensors)
    ranger = bool(league.body.legs)  # the legged robots, which have a head with a ranger in it
    return Cast(league, match.agents, camera, ranger, parts, reader, constants_of(league), why, directions)


def count_line_directions(sensors: object) -> int:
    """Return the number of directions in which sensors look for white lines."""
    lines = sensors.get("lines") if isinstance(sensors, Mapping) else None
    return lines if isinstance(lines, int) and 1 <= lines <= LINES else LINES
