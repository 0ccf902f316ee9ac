"""Notes of what robots think, written by hand, and casts that read them: nothing is played, no team decides."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.robot_kind import Group
from soccer_env.render.overlays.cast import Camera, Cast, TeamPart
from soccer_env.robot_kinds.legged import GROUPS as LEGGED
from soccer_env.robot_kinds.omni import GROUPS as OMNI
from soccer_env.teams import DecisionInputs, Explanation
from soccer_env.thoughts.groups import PLAN, count_columns
from soccer_env.thoughts.thought import NoteReader
from soccer_env.thoughts.thoughts import SEES, TABLE, TRACK
from tests.scenes.staging import LEGGED as LEGGED_LEAGUE
from tests.scenes.staging import MIDDLE

SLOTS = 4
MEMORY = [["behaviour", ["shoot", "back", "support"], 1.0], ["role", ["attacker", "supporter"], 1.0]]
MEMORY += [[name, [], 10.0] for name in ("rank", "tries", "skill.detour", "skill.wriggle", "skill.back_off")]
SILENT = (-1, -1, 0, 0, 0, 0, 0)
CAMERA = Camera(1.0053096491487339, 0.075, 88.0, 72.0)


def pull_to_target(mind: DecisionInputs, target: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return forces (P, 2) to a target, off players, ball and obstacle, each by all that the mind knows of it."""
    own, ball, obstacle = (mind.beliefs[name][0] for name in ("own", "ball", "obstacle"))
    cosine, sine = np.cos(own["heading"]), np.sin(own["heading"])
    forces = 0.3 * (target - points) + (0.07 * own["x"], 0.05 * own["y"])
    things = [(ball["x"], ball["y"], -0.2)]
    for track in mind.tracks[0]:
        weight = track["present"] * (1.0 + 0.3 * track["teammate"] - 0.1 * track["age"] + 0.02 * track["bearing"])
        things.append((track["x"], track["y"], weight * (1.0 + 0.1 * track["distance"])))
    bearing, distance = float(obstacle["bearing"]), float(obstacle["distance"])
    things.append((distance * np.cos(bearing), distance * np.sin(bearing), 0.4 * (distance > 0.0)))
    for ahead, left, weight in things:
        place = (own["x"] + cosine * ahead - sine * left, own["y"] + sine * ahead + cosine * left)
        away = points - place
        forces += weight * away / (0.2 + (away * away).sum(axis=1, keepdims=True))
    return forces


def no_plan(mind: DecisionInputs) -> np.ndarray:
    """Return no way: notes have them."""
    return np.zeros((0, 2))


GOES = TeamPart("goes", Explanation(plan=no_plan, forces=pull_to_target, needs_target=True), np.zeros(1))
PULLS = TeamPart("pulls", Explanation(forces=pull_to_target), np.zeros(1))
MUTE = TeamPart("mute", None, None)


def cast_for(league: str, home: int, away: int, parts: Mapping[int, TeamPart], **changes: Any) -> Cast:
    """Return who plays, with a reader of all groups of the league."""
    legged = league == LEGGED_LEAGUE
    agents = [f"home_{n}" for n in range(home)] + [f"away_{n}" for n in range(away)]
    groups = [*(LEGGED if legged else OMNI), *PLAN]
    reader = NoteReader(SLOTS, [MEMORY for _ in agents], groups)
    given = {"camera": CAMERA if legged else None, "ranger": legged, "line_directions": 24, "reader": reader}
    return Cast(find_league(league), agents, parts=parts, why_no_notes="nothing was noted", **{**given, **changes})


def note_of(cast: Cast, robots: Sequence[Mapping[str, Any]]) -> np.ndarray:
    """Return the note (R, C) int16 of all robots, each as numbers by column or group; what is not given is 0.

    "tracks": rows of TRACK; "memory": a number for each of MEMORY; a group: rows of its parts. Robots think.
    """
    assert cast.reader is not None
    reader, rows = cast.reader, []
    for said in robots:
        table = {"sees": SEES["thinks"], **said}
        tracks = [*said.get("tracks", ()), *[(0, 0, 0)] * reader.slots][: reader.slots]
        assert all(len(track) == len(TRACK) for track in tracks)
        parts = [group_columns(group, said.get(group[0], ())) for group in reader.groups]
        memory = said.get("memory", SILENT)[: len(reader.fields[0])]
        numbers = [0 if name == "players" else table.get(name, 0) for name in TABLE]  # "players" is a group here
        row = [*numbers, *np.ravel(tracks), *np.concatenate([*parts, memory])]
        rows.append(np.rint(row).astype(np.int16))
    return np.stack(rows)


def group_columns(group: Group, rows: Sequence[Sequence[int]]) -> np.ndarray:
    """Return the columns of a group, 0 where rows are missing."""
    found = np.zeros((group[1], len(group[2])), int)
    if len(rows):
        found[: len(rows)] = rows
    assert found.size == count_columns([group])
    return found.ravel()


__all__ = ["GOES", "LEGGED_LEAGUE", "MIDDLE", "MUTE", "PULLS", "cast_for", "note_of"]
