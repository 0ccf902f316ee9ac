"""Groups of columns beside those that every note has: what the camera delivered, and where the robot plans to go.

A group is [name, how many, names of the parts of each]. Pixels are as `percept_types` has them; angles in 0.01 rad and
lengths in cm, but those of lines, in dm. Parts of things that are not there are all 0.
"""

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.match.squads import Squad
from soccer_env.teams import Explanation, Mind, explanation_of

BOX = ["left", "right", "high", "low"]
POLAR = ["bearing", "distance"]
LEGGED: list[list[Any]] = [  # percepts of a camera on a head; those of several blobs are the largest
    ["head", 1, ["pan", "tilt"]],
    *([name, 1, BOX] for name in ("ball", "own_goal", "opponent_goal")),
    *([name, count, BOX] for name, count in (("teammates", 2), ("opponents", 3), ("landmarks", 6))),
]
MOST_PLAYERS = 9  # that an omnidirectional camera sees, nearest first
OMNI: list[list[Any]] = [  # the distance of an opponent is below 0
    *([name, 1, POLAR] for name in ("ball", "own_goal", "opponent_goal")),
    ["players", MOST_PLAYERS, POLAR],
    ["lines", 32, ["distance"]],
]
OBSTACLE: list[list[Any]] = [["obstacle", 1, POLAR]]  # that the ranger meets
PLAN: list[list[Any]] = [["plan", 10, ["x", "y"]]]  # points of the planned path in the field frame, the last is its end
ALL = LEGGED + OMNI + OBSTACLE + PLAN
KNOWN = {name: [parts for other, _, parts in ALL if other == name] for name, _, _ in ALL}  # parts of each
MOST_GROUPS, MOST_COLUMNS = 32, 512
CENTI = 100.0  # [1] steps in a metre or radian
LINE_STEPS = 10.0  # [1/m]

Group = list[Any]


def groups_of(match: Match) -> list[Group]:
    """Return what is noted of each robot of a match."""
    found: list[Group] = []
    if match.batch.senses is not None:
        names = match.batch.senses.percepts.dtype.names or ()
        found += LEGGED + OBSTACLE if "infrared" in names else OMNI
    return found + (PLAN if any(planner_of(squad) for squad in match.squads) else [])


def checked_groups(groups: Any) -> list[Group]:
    """Return groups that were read from a file; ValueError for anything else."""
    found: list[Group] = [[str(name), int(count), [str(part) for part in parts]] for name, count, parts in groups]
    wrong = any(count < 0 or parts not in KNOWN.get(name, [parts]) for name, count, parts in found)
    if wrong or len(found) > MOST_GROUPS or width_of(found) > MOST_COLUMNS:
        raise ValueError("the groups of its thoughts are damaged")
    return found


def width_of(groups: list[Group]) -> int:
    """Return how many columns they have."""
    return sum(count * len(parts) for _, count, parts in groups)


def group_columns(match: Match, groups: list[Group]) -> np.ndarray:
    """Return the columns (R, C) of all robots of the first match, not yet whole numbers."""
    rows = len(match.agents)
    known: dict[str, np.ndarray] = {}
    if not groups:
        return np.zeros((rows, 0))
    if match.batch.senses is not None:
        percepts = match.batch.senses.percepts[0]
        legged = "infrared" in (percepts.dtype.names or ())
        known = of_head_camera(percepts) if legged else of_mirror_camera(percepts)
        obstacle = match.beliefs[0]["obstacle"]
        known["obstacle"] = np.stack([CENTI * obstacle["bearing"], CENTI * obstacle["distance"]], axis=-1)[:, None]
    if any(name == "plan" for name, _, _ in groups):
        known["plan"] = plans(match)
    parts = [known[name][:, :count].reshape(rows, -1) for name, count, _ in groups]
    return np.concatenate(parts, axis=1)


def of_head_camera(percepts: np.ndarray) -> dict[str, np.ndarray]:
    """Return head and blobs of percepts (R,), each (R, n, parts)."""
    found = {"head": np.stack([CENTI * percepts["pan"], CENTI * percepts["tilt"]], axis=-1)[:, None]}
    for name, _, _ in LEGGED[1:]:
        blobs = percepts[name]
        there = (blobs["area"] > 0)[..., None]
        found[name] = np.where(there, np.stack([blobs[part] for part in BOX], axis=-1), 0)
    return found


def of_mirror_camera(percepts: np.ndarray) -> dict[str, np.ndarray]:
    """Return sightings and lines of percepts (R,), each (R, n, parts)."""
    found = {}
    for name, count, _ in OMNI[:-1]:
        things = percepts[name].reshape(len(percepts), -1)[:, :count]
        side = np.where(things["teammate"] == 1, 1.0, -1.0) if name == "players" else 1.0
        polar = np.stack([CENTI * things["bearing"], CENTI * side * things["distance"]], axis=-1)
        found[name] = np.where((things["seen"] > 0)[..., None], polar, 0.0)
    return found | {"lines": LINE_STEPS * percepts["lines"][..., None]}


def planner_of(squad: Squad) -> Explanation | None:
    """Return what the team of a squad explains, if it plans ways; lineups change teams, and explain nothing."""
    explanation = None if squad.lineup is not None else explanation_of(squad.team)
    return explanation if explanation is not None and explanation.plan is not None else None


def mind_of(match: Match, squad: Squad, place: int) -> Mind:
    """Return copies of what a player of the first match decides from; `place` is its place in the squad."""
    r = int(squad.players[place])
    return Mind(
        match.beliefs[:1, r].copy(),
        match.tracks[:1, r].copy(),
        squad.memory[:1, place].copy(),
        match.robots["noise"][:1, r].copy(),
        match.batch.constants,
        squad.team.settings,  # type: ignore[attr-defined]  # teams that explain themselves are compiled
    )


def plans(match: Match) -> np.ndarray:
    """Return the planned ways (R, points, 2) in cm of the field frame, 0 where there is none."""
    found = np.zeros((len(match.agents), PLAN[0][1], 2))
    home_ahead = float(match.matches["home_direction"][0])
    for squad in match.squads:
        explanation = planner_of(squad)
        if explanation is None or explanation.plan is None:
            continue
        for place, r in enumerate(squad.players.tolist()):
            if match.robots["active"][0, r]:
                way = explanation.plan(mind_of(match, squad, place))
                sign = home_ahead if match.robots["team"][0, r] == 0 else -home_ahead
                found[r] = CENTI * sign * spaced(way, PLAN[0][1])
    return found


def spaced(way: np.ndarray, count: int) -> np.ndarray:
    """Return so many points (count, 2) evenly along a way (N, 2); all 0 for a way of fewer than two."""
    if len(way) < 2:
        return np.zeros((count, 2))
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(way, axis=0).T))])
    wanted = np.linspace(0.0, along[-1], count)
    return np.column_stack([np.interp(wanted, along, way[:, axis]) for axis in (0, 1)])
