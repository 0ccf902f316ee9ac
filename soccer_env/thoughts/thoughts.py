"""Notes of the robots' percepts, beliefs and decisions, taken several times a second, for people to look at.

A replay repeats commands, so thoughts cannot be computed from it. `Thoughts` notes them while the match runs, as whole
numbers of 16 bits; the replay plays the same without notes. Only the first match of several is noted.
"""

import json
from collections.abc import Iterator, Mapping
from typing import Any, Protocol

import numpy as np

from soccer_env.leagues.robot_kind import Group
from soccer_env.match import Match
from soccer_env.match.squads import Squad
from soccer_env.teams import explanation_of
from soccer_env.thoughts.groups import checked_groups, count_columns, group_columns, note_groups, noted_percepts
from soccer_env.types import HOME

PER_SECOND = 5  # [1/s] notes, at least
MOST = 32767  # of 16 bits
MILLI, CENTI = 1000.0, 100.0  # [1] steps in a metre or radian; in a second, a unit of confidence or of a command
TABLE = (  # columns of each robot; lengths in mm, angles in mrad, times in 10 ms, all in the field frame
    "x", "y", "heading", "confidence", "ball_x", "ball_y", "ball_confidence", "ball_age",
    "sees", "players", "marks", "infrared", "spread", "narrow", "axis", "forward", "left", "turn", "kick",
)  # fmt: skip
TRACK = ("x", "y", "age")  # of each slot: age in 0.1 s, 1 and more, below 0 of an opponent; 0: an empty slot
SEES = {"ball": 1, "own_goal": 2, "opponent_goal": 4, "held": 8, "thinks": 16}  # bits of `sees`
MOST_FIELDS = 12  # of a team's memory


class Thoughts:
    """The notes of one match, one every `every` control steps.

    `shown` maps fields of the teams' memories to the words for their values, () for a plain number; None: the fields
    that a team's explanation shows, or all whole numbers of its memory. `grouped=False` leaves out percepts of the
    camera and plans (see `groups`), which take most of the time.
    """

    def __init__(self, match: Match, shown: Mapping[str, tuple[str, ...]] | None = None, grouped: bool = True) -> None:
        self.every = max(1, match.league.control_rate // PER_SECOND)
        has_beliefs = match.batch.senses is not None or match.batch.ideal.any()
        self.slots = int(match.tracks.shape[2]) if has_beliefs else 0
        self.fields = [memory_fields(match, r, shown) for r in range(len(match.agents))]
        self.groups = note_groups(match) if self.slots and grouped else []
        self.steps: list[int] = []
        self.rows: list[np.ndarray] = []  # each (R, C) int16

    def note(self, match: Match, step: int) -> None:
        """Take a note of the match after a control step, if a note is due."""
        if step % self.every == 0 and self.slots:
            self.steps.append(step)
            self.rows.append(self.look(match))

    def look(self, match: Match) -> np.ndarray:
        """Return the present notes of all robots of the first match, (R, C) int16."""
        columns = [*match_columns(match), *track_columns(match, self.slots)]
        more = round_to_int16(group_columns(match, self.groups))
        return np.column_stack([round_to_int16(np.stack(columns, axis=1)), more, memory_columns(match, self.fields)])

    def cut(self, step: int) -> None:
        """Drop the notes taken after a control step."""
        while self.steps and self.steps[-1] > step:
            self.steps.pop()
            self.rows.pop()

    def packed(self) -> dict[str, np.ndarray]:
        """Return the notes as arrays for a file, stored as changes from note to note, which compress well."""
        return packed(self.steps, np.stack(self.rows), self.slots, self.fields, self.groups) if self.rows else {}


def packed(
    steps: list[int], numbers: np.ndarray, slots: int, fields: list[list[list[Any]]], groups: list[Group]
) -> dict[str, np.ndarray]:
    """Return notes (T, R, C) as arrays for a file, stored as changes from note to note."""
    about = {"steps": steps, "slots": slots, "fields": fields, "groups": groups}
    changes = np.diff(numbers, axis=0, prepend=np.int16(0))
    return {
        "thoughts": np.ascontiguousarray(np.moveaxis(changes, 0, -1)),  # (R, C, T), wraps round
        "thoughts_about": np.frombuffer(json.dumps(about).encode(), np.uint8),
    }


class Notes:
    """The notes in a file: `numbers` (T, R, C) int16, taken after the control steps `steps` (T,)."""

    def __init__(self, arrays: Mapping[str, np.ndarray], robots: int) -> None:
        about = json.loads(arrays["thoughts_about"].tobytes())
        changes = arrays["thoughts"]
        self.slots, self.fields = int(about["slots"]), [checked_fields(fields) for fields in about["fields"]]
        self.groups = checked_groups(about.get("groups", []))  # files of older versions have none
        self.steps = np.array(about["steps"], np.int64)
        width = len(TABLE) + self.slots * len(TRACK) + count_columns(self.groups)
        width += max((len(fields) for fields in self.fields), default=0)
        if changes.dtype != np.int16 or changes.shape != (robots, width, len(self.steps)) or len(self.fields) != robots:
            raise ValueError(f"its thoughts are {changes.dtype} {changes.shape}, not int16 of {robots} robots")
        self.numbers = np.cumsum(np.moveaxis(changes, -1, 0), axis=0, dtype=np.int16)

    def between(self, first: int, last: int) -> dict[str, np.ndarray]:
        """Return the notes after step `first` up to step `last`, packed, with steps counted from `first`."""
        inside = (self.steps > first) & (self.steps <= last)
        if not inside.any():
            return {}
        return packed((self.steps[inside] - first).tolist(), self.numbers[inside], self.slots, self.fields, self.groups)


class RecordedMatch(Protocol):
    """The protocol of a recorded match, which `soccer_env.replay.Replay` implements."""

    settings: dict[str, Any]

    @property
    def teams(self) -> tuple[str, str]:
        """Return the names of the teams home and away."""

    def notes(self) -> Notes | None:
        """Return the notes of the robots; None if they were not recorded."""

    def play(self) -> Iterator[Match]:
        """Yield the match at its start and after every control step; ValueError if it differs from the recording."""


def checked_fields(fields: Any) -> list[list[Any]]:
    """Return names, words and units of the fields of a robot's memory, checked; ValueError if they are malformed."""
    checked: list[list[Any]] = [[str(name), [str(word) for word in words], float(step)] for name, words, step in fields]
    if len(checked) > MOST_FIELDS or not all(field[2] > 0.0 for field in checked):
        raise ValueError("the fields of its thoughts are damaged")
    return checked


def memory_fields(match: Match, r: int, shown: Mapping[str, tuple[str, ...]] | None) -> list[list[Any]]:
    """Return the recorded fields of robot r's memory, each as [name, words for its values, steps in a unit]."""
    noted: list[list[Any]] = []
    for squad in fixed_team_squads(match):
        explanation = explanation_of(squad.team)
        known = explanation.shown if shown is None and explanation is not None else shown
        for path, kind in record_leaves(squad.memory.dtype) if r in squad.players else ():
            name = path.rpartition(".")[2]
            if (known is None and kind == "i" and name != "begun") or (known is not None and name in known):
                noted.append([path, list((known or {}).get(name, ())), 1.0 if kind in "iu" else CENTI])
    return noted[:MOST_FIELDS]


def fixed_team_squads(match: Match) -> list[Squad]:
    """Return the squads with one fixed team, without lineups, whose team and memory change."""
    return [squad for squad in match.squads if squad.lineup is None]


def record_leaves(dtype: np.dtype, path: str = "") -> list[tuple[str, str]]:
    """Return the dotted path and the dtype kind of each single number of a record."""
    numbers: list[tuple[str, str]] = []
    for name in dtype.names or ():
        inner = dtype[name]
        if inner.names:
            numbers += record_leaves(inner, f"{path}{name}.")
        elif inner.shape == () and inner.kind in "iuf":
            numbers.append((path + name, inner.kind))
    return numbers


def match_columns(match: Match) -> list[np.ndarray]:
    """Return the columns of TABLE for the robots of the first match, each (R,), before rounding."""
    robots, beliefs = match.robots[0], match.beliefs[0]
    sign = np.where((robots["team"] == HOME) == (match.matches["home_direction"][0] > 0.0), 1.0, -1.0)
    own, heading = own_poses(match)
    ball_x, ball_y = to_field_frame(own, heading, beliefs["ball"])
    columns = [MILLI * own[0], MILLI * own[1], MILLI * heading, CENTI * beliefs["own"]["confidence"]]
    columns += [MILLI * ball_x, MILLI * ball_y, CENTI * beliefs["ball"]["confidence"], CENTI * beliefs["ball"]["age"]]
    columns += sighting_columns(match) + particle_spread(match, sign)
    return columns + [CENTI * robots["command"][name] for name in ("forward", "left", "turn", "kick")]


def own_poses(match: Match) -> tuple[tuple[np.ndarray, np.ndarray], np.ndarray]:
    """Return the believed positions and headings of all robots [m, rad], field frame, each (R,)."""
    robots, own = match.robots[0], match.beliefs[0]["own"]
    sign = np.where((robots["team"] == HOME) == (match.matches["home_direction"][0] > 0.0), 1.0, -1.0)
    heading = own["heading"] + np.where(sign > 0.0, 0.0, np.pi)
    return (sign * own["x"], sign * own["y"]), np.arctan2(np.sin(heading), np.cos(heading))


def track_columns(match: Match, slots: int) -> list[np.ndarray]:
    """Return the columns of TRACK for each slot of the robots' tracks, each (R,), before rounding."""
    columns: list[np.ndarray] = []
    own, heading = own_poses(match)
    for slot in range(slots):
        track = match.tracks[0, :, slot]
        x, y = to_field_frame(own, heading, track)
        age = np.where(track["teammate"] == 1, 1.0, -1.0) * (1.0 + np.minimum(10.0 * track["age"], MOST - 1))
        columns += [np.where(track["present"] == 1, values, 0.0) for values in (MILLI * x, MILLI * y, age)]
    return columns


def to_field_frame(
    own: tuple[np.ndarray, np.ndarray], heading: np.ndarray, thing: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Convert positions from the robots' frames to the field frame, by the robots' believed poses."""
    cosine, sine = np.cos(heading), np.sin(heading)
    return own[0] + cosine * thing["x"] - sine * thing["y"], own[1] + sine * thing["x"] + cosine * thing["y"]


def round_to_int16(numbers: np.ndarray) -> np.ndarray:
    """Round numbers to int16, clipped to the range from -MOST to MOST."""
    return np.asarray(np.rint(np.nan_to_num(np.clip(numbers, -MOST, MOST))).astype(np.int16))


def sighting_columns(match: Match) -> list[np.ndarray]:
    """Return four columns (R,): flags SEES, numbers of seen players and landmarks (or lines), infrared range [mm]."""
    robots = match.robots[0]
    bits = np.where(match.batch.believing, SEES["thinks"], 0) | np.where(robots["has_ball"] == 1, SEES["held"], 0)
    none, noted = np.zeros(len(robots)), noted_percepts(match)
    if match.batch.senses is None or noted is None:
        return [bits, none, none, none]
    saw = noted.seen(match.batch.senses.percepts[0])
    for name in ("ball", "own_goal", "opponent_goal"):
        bits = bits | np.where(getattr(saw, name), SEES[name], 0)
    return [bits, saw.players, saw.marks, MILLI * saw.range]


def particle_spread(match: Match, sign: np.ndarray) -> list[np.ndarray]:
    """Return the spread of each robot's particles: larger and smaller deviation [mm], axis of the larger [mrad]."""
    senses = match.batch.senses
    if senses is None or senses.particles.shape[2] < 2:
        return [np.zeros(len(sign))] * 3
    x, y = (sign[:, None] * senses.particles[0][name] for name in ("x", "y"))
    x, y = x - x.mean(axis=1, keepdims=True), y - y.mean(axis=1, keepdims=True)
    across, along, mixed = (x * x).mean(axis=1), (y * y).mean(axis=1), (x * y).mean(axis=1)
    middle, apart = (across + along) / 2, np.hypot((across - along) / 2, mixed)
    least = np.sqrt(np.maximum(middle - apart, 0.0))
    return [MILLI * np.sqrt(middle + apart), MILLI * least, MILLI * 0.5 * np.arctan2(2.0 * mixed, across - along)]


def memory_columns(match: Match, fields: list[list[list[Any]]]) -> np.ndarray:
    """Return the recorded fields of the robots' memories, (R, fields) int16."""
    numbers = np.zeros((len(fields), max((len(names) for names in fields), default=0)))
    for squad in fixed_team_squads(match):
        for place, r in enumerate(squad.players):
            for column, (path, _, step) in enumerate(fields[r]):
                value = squad.memory[0, place]
                for name in path.split("."):
                    value = value[name]
                numbers[r, column] = step * float(value)
    return round_to_int16(numbers)
