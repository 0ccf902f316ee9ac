"""What a kind of robot is: all that goes with its sensors, declared in one place and found by what the sensors say.

    league.sensors.KIND  ->  KINDS, a place as "MODULE:NAME"  ->  the RobotKind that is declared there

The places are strings, resolved at first use: what they name stands above this file. A kind of one's own is one more
entry: `KINDS["beacon"] = "my_robots:BEACON"`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from soccer_env.guards.names import unknown

KINDS = {
    "legged": "soccer_env.robot_kinds.legged:LEGGED",
    "omni": "soccer_env.robot_kinds.omni:OMNI",
}

CENTI = 100.0  # [1] steps of a note in a metre or radian
LINE_STEPS = 10.0  # [1/m] of the distance of a line
POLAR = [
    "bearing",
    "distance",
]  # parts of a thing that is drawn as a ray; a team-mate's distance is above 0, others' below
Group = list[Any]  # [name, how many, names of the parts of each]


class Seen(NamedTuple):
    """What percepts (R,) show."""

    ball: np.ndarray  # (R,) bool
    own_goal: np.ndarray  # (R,) bool
    opponent_goal: np.ndarray  # (R,) bool
    players: np.ndarray  # (R,) how many others
    marks: np.ndarray  # (R,) how many landmarks or lines
    range: np.ndarray  # (R,) [m] that a ranger reads, 0: none


@dataclass(frozen=True)
class Noted:
    """What a replay keeps of a robot's sensors, and so what pictures show of them.

    A group named `ball`, `own_goal`, `opponent_goal` or `players` has its colour, each other one is white. Groups with
    the parts POLAR are drawn as rays. How groups of blobs and lines look: `render/overlays/sight.py`.
    """

    groups: tuple[Group, ...]
    columns: Callable[[np.ndarray, np.ndarray], dict[str, np.ndarray]]  # of percepts (R,), beliefs (R,): (R, n, parts)
    seen: Callable[[np.ndarray], Seen]  # of percepts (R,)


@dataclass(frozen=True)
class RobotKind:
    """The sensors and the memory of a kind of robot: its records, its kernels, and how learners see its percepts.

    Records that `ranges.record` makes are checked when a save brings them in; those of `np.dtype` are left alone.
    """

    percept: np.dtype  # what the sensors deliver, with a BODY_PERCEPT "body"
    sensor_state: np.dtype  # what they remember and do not deliver, with a POSE_ERROR "pose_error"
    memory: np.dtype  # what a robot remembers beside its belief
    message: np.dtype  # what it says to team-mates
    particle: np.dtype  # one of those by which it finds itself
    sense: Callable[..., None]  # made by perception.sensing.sense_kernel
    believe: Callable[..., None]  # made by belief.believing.believe_kernel
    entries: Callable[[Any], list[Any]]  # of observe="percepts" in a league
    observe: Callable[..., None]  # the kernel that writes them
    tables: Callable[[Any], np.ndarray]  # (1,) record of what is calibrated before a match in a league
    noted: Noted | None = None  # None: a replay keeps nothing of the sensors, only what the robot believes
    late: Callable[[Any], int] = lambda sensors: 0  # frames by which its camera delivers late, of its sensors' settings


def check_kind(sensors: Any) -> str:
    """Return the kind of robot that goes with sensors; ValueError for an unknown one says which are known."""
    name = getattr(sensors, "KIND", sensors)
    if not isinstance(name, str) or name not in KINDS:
        raise ValueError(unknown("kind of sensors", name, KINDS))
    return name


def kind_of(sensors: Any) -> RobotKind:
    """Return the kind of robot that goes with the sensors of a league; ValueError for an unknown one."""
    module, _, name = KINDS[check_kind(sensors)].partition(":")
    kind: RobotKind = getattr(import_module(module), name)
    return kind
