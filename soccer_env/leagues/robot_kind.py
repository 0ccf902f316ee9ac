"""RobotKind: the records and kernels that go with a kind of sensors, found by the name of the kind.

    league.sensors.KIND  ->  KINDS, a place as "MODULE:NAME"  ->  the RobotKind that is declared there

The places are strings, resolved at first use, since their modules import this file. A user's own kind is one more
entry: `KINDS["beacon"] = "my_robots:BEACON"`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from soccer_env.guards.names import unknown

KINDS = {"legged": "soccer_env.robot_kinds.legged:LEGGED", "omni": "soccer_env.robot_kinds.omni:OMNI"}

CENTI = 100.0  # [1/m, 1/rad] steps of a noted number
LINE_STEPS = 10.0  # [1/m] steps of a noted distance of a line
POLAR = ["bearing", "distance"]  # parts of a thing drawn as a ray; the distance is above 0 for a team-mate, else below
Group = list[Any]  # [name, number of things, names of the parts of each thing]


class PerceptSummary(NamedTuple):
    """The objects that the robots see in their percepts (R,), and the ranger's reading."""

    ball: np.ndarray  # (R,) bool
    own_goal: np.ndarray  # (R,) bool
    opponent_goal: np.ndarray  # (R,) bool
    players: np.ndarray  # (R,) number of other players
    marks: np.ndarray  # (R,) number of landmarks or lines
    range: np.ndarray  # (R,) [m] reading of a ranger, 0: none


@dataclass(frozen=True)
class NotedPercepts:
    """The percepts of a robot kind that replays store and renderings show.

    Groups named `ball`, `own_goal`, `opponent_goal` and `players` have their own colours; all others are white. Groups
    with the parts POLAR are drawn as rays; `render/overlays/sight.py` draws groups of blobs and lines.
    """

    groups: tuple[Group, ...]
    columns: Callable[[np.ndarray, np.ndarray], dict[str, np.ndarray]]  # of percepts (R,), beliefs (R,): (R, n, parts)
    seen: Callable[[np.ndarray], PerceptSummary]  # of percepts (R,)


@dataclass(frozen=True)
class RobotKind:
    """The records and kernels of a kind of robot: sensors, memory, and observations of its percepts.

    Records made by `ranges.record` are checked when a save is loaded; plain dtypes are not.
    """

    percept: np.dtype  # readings of the sensors, with a BODY_PERCEPT "body"
    sensor_state: np.dtype  # hidden state of the sensors, with a POSE_ERROR "pose_error"
    memory: np.dtype  # memory of a robot beside its belief
    message: np.dtype  # message to team-mates
    particle: np.dtype  # a hypothesis of the own pose
    sense: Callable[..., None]  # made by perception.sensing.sense_kernel
    believe: Callable[..., None]  # made by belief.believing.believe_kernel
    entries: Callable[[Any], list[Any]]  # of observe="percepts" in a league
    observe: Callable[..., None]  # the kernel that writes those entries
    tables: Callable[[Any], np.ndarray]  # (1,) record of tables calibrated before a match in a league
    noted: NotedPercepts | None = None  # None: a replay keeps the robot's beliefs, but no percepts
    late: Callable[[Any], int] = lambda sensors: 0  # frames of camera delay, from the settings of the sensors


def check_kind(sensors: Any) -> str:
    """Return the name of the robot kind that `sensors` belong to; ValueError for an unknown kind lists the kinds."""
    name = getattr(sensors, "KIND", sensors)
    if not isinstance(name, str) or name not in KINDS:
        raise ValueError(unknown("kind of sensors", name, KINDS))
    return name


def kind_of(sensors: Any) -> RobotKind:
    """Return the robot kind of a league's sensors; ValueError for an unknown kind."""
    module, _, name = KINDS[check_kind(sensors)].partition(":")
    kind: RobotKind = getattr(import_module(module), name)
    return kind
