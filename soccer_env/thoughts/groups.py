"""Optional groups of columns in a note: percepts of the camera, and the planned path.

A group is [name, number of items, names of the columns of an item]; the robot kind declares the groups of its sensors
(`leagues/robot_kind.py`). Angles are in 0.01 rad and lengths in cm. The columns of a missing item are all 0.
"""

import functools
from typing import Any

import numpy as np

from soccer_env.leagues.robot_kind import CENTI, Group, NotedPercepts, kind_of
from soccer_env.match import Match
from soccer_env.match.squads import Squad
from soccer_env.teams import DecisionInputs, Explanation, explanation_of

PLAN: list[list[Any]] = [["plan", 10, ["x", "y"]]]  # points of the planned path in the field frame, the last is its end
MOST_GROUPS, MOST_COLUMNS = 32, 512


def noted_percepts(match: Match) -> NotedPercepts | None:
    """Return the percepts that the robot kind records in notes; None if no robot senses or none are declared."""
    return None if match.batch.senses is None else kind_of(match.league.sensors).noted


def note_groups(match: Match) -> list[Group]:
    """Return the optional groups of columns in the notes of a match: percepts, and plans if a team plans paths."""
    noted = noted_percepts(match)
    groups = [] if noted is None else [*noted.groups]
    return groups + (PLAN if any(planner_of(squad) for squad in match.squads) else [])


@functools.cache
def allowed_columns() -> dict[str, list[list[str]]]:
    """Return the allowed lists of columns of each group, by the group's name, for all robot kinds and plans."""
    kinds = (kind_of(name).noted for name in ("legged", "omni"))
    known: dict[str, list[list[str]]] = {}
    for name, _, parts in (*PLAN, *(group for noted in kinds if noted for group in noted.groups)):
        known.setdefault(name, []).append(parts)
    return known


def checked_groups(groups: Any) -> list[Group]:
    """Return the groups read from a file, checked; ValueError for anything that is not a list of groups."""
    checked: list[Group] = [[str(name), int(count), [str(part) for part in parts]] for name, count, parts in groups]
    known = allowed_columns() if checked else {}
    wrong = any(count < 0 or parts not in known.get(name, [parts]) for name, count, parts in checked)
    if wrong or len(checked) > MOST_GROUPS or count_columns(checked) > MOST_COLUMNS:
        raise ValueError("the groups of its thoughts are damaged")
    return checked


def count_columns(groups: list[Group]) -> int:
    """Return the number of columns of some groups."""
    return sum(count * len(parts) for _, count, parts in groups)


def group_columns(match: Match, groups: list[Group]) -> np.ndarray:
    """Return the columns (R, C) of the groups for all robots of the first match, before rounding."""
    rows = len(match.agents)
    noted, known = noted_percepts(match), {}
    if not groups:
        return np.zeros((rows, 0))
    if noted is not None and match.batch.senses is not None:
        known = noted.columns(match.batch.senses.percepts[0], match.beliefs[0])
    if any(name == "plan" for name, _, _ in groups):
        known["plan"] = planned_paths(match)
    parts = [known[name][:, :count].reshape(rows, -1) for name, count, _ in groups]
    return np.concatenate(parts, axis=1)


def planner_of(squad: Squad) -> Explanation | None:
    """Return the explanation of a squad's team if it plans paths; None for lineups, whose teams change."""
    explanation = None if squad.lineup is not None else explanation_of(squad.team)
    return explanation if explanation is not None and explanation.plan is not None else None


def copy_decision_inputs(match: Match, squad: Squad, place: int) -> DecisionInputs:
    """Return copies of the records from which a player of the first match decides; `place`: its index in the squad."""
    r, settings = int(squad.players[place]), squad.settings
    beliefs, tracks = match.beliefs[:1, r].copy(), match.tracks[:1, r].copy()
    memory, noise = squad.memory[:1, place].copy(), match.robots["noise"][:1, r].copy()
    return DecisionInputs(beliefs, tracks, memory, noise, match.batch.constants, settings)


def planned_paths(match: Match) -> np.ndarray:
    """Return the planned paths (R, points, 2) [cm, field frame] of all robots, 0 without a plan."""
    paths = np.zeros((len(match.agents), PLAN[0][1], 2))
    home_ahead = float(match.matches["home_direction"][0])
    for squad in match.squads:
        explanation = planner_of(squad)
        if explanation is None or explanation.plan is None:
            continue
        for place, r in enumerate(squad.players.tolist()):
            if match.robots["active"][0, r]:
                path = explanation.plan(copy_decision_inputs(match, squad, place))
                sign = home_ahead if match.robots["team"][0, r] == 0 else -home_ahead
                paths[r] = CENTI * sign * space_evenly(path, PLAN[0][1])
    return paths


def space_evenly(path: np.ndarray, count: int) -> np.ndarray:
    """Return points (count, 2) at equal distances along a path (N, 2); all 0 for a path of fewer than two points."""
    if len(path) < 2:
        return np.zeros((count, 2))
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    wanted = np.linspace(0.0, along[-1], count)
    return np.column_stack([np.interp(wanted, along, path[:, axis]) for axis in (0, 1)])
