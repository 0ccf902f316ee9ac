"""The declaration of the legged robot, which plays the legged league."""

import numpy as np

from soccer_env.belief.legged.believe import LEGGED_MEMORY, believe_slice
from soccer_env.belief.legged.talk import SOUND_MESSAGE
from soccer_env.belief.particles import PARTICLE
from soccer_env.leagues.robot_kind import CENTI, POLAR, Group, NotedPercepts, PerceptSummary, RobotKind
from soccer_env.observations.legged import entries, observe_slice
from soccer_env.perception.legged.calibration import calibrate
from soccer_env.perception.legged.sense import LEGGED_SENSOR_STATE, sense_slice
from soccer_env.records.percepts import LEGGED_PERCEPT

BOX = ["left", "right", "high", "low"]  # [px] as `records/percepts.py` has them
GROUPS: tuple[Group, ...] = (  # percepts of a camera on a head; those of several blobs are the largest
    ["head", 1, ["pan", "tilt"]],
    *([name, 1, BOX] for name in ("ball", "own_goal", "opponent_goal")),
    *([name, count, BOX] for name, count in (("teammates", 2), ("opponents", 3), ("landmarks", 6))),
    ["obstacle", 1, POLAR],  # that the ranger meets
)


def percept_columns(percepts: np.ndarray, beliefs: np.ndarray) -> dict[str, np.ndarray]:
    """Return the percept columns that a replay stores for robots (R,): head, blobs and obstacle, each (R, n, parts)."""
    obstacle = beliefs["obstacle"]
    arrays = {"head": np.stack([CENTI * percepts["pan"], CENTI * percepts["tilt"]], axis=-1)[:, None]}
    arrays["obstacle"] = np.stack([CENTI * obstacle["bearing"], CENTI * obstacle["distance"]], axis=-1)[:, None]
    for name, _, _ in GROUPS[1:-1]:
        blobs = percepts[name]
        visible = (blobs["area"] > 0)[..., None]
        arrays[name] = np.where(visible, np.stack([blobs[part] for part in BOX], axis=-1), 0)
    return arrays


def summarise_percepts(percepts: np.ndarray) -> PerceptSummary:
    """Return a `PerceptSummary` of percepts (R,): ball, goals, numbers of players and landmarks, infrared range."""
    ball, own_goal, opponent_goal = (percepts[name]["area"][:, 0] > 0 for name in ("ball", "own_goal", "opponent_goal"))
    mates, opponents, marks = ((percepts[n]["area"] > 0).sum(axis=1) for n in ("teammates", "opponents", "landmarks"))
    return PerceptSummary(ball, own_goal, opponent_goal, mates + opponents, marks, percepts["infrared"])


LEGGED = RobotKind(
    percept=LEGGED_PERCEPT,
    sensor_state=LEGGED_SENSOR_STATE,
    memory=LEGGED_MEMORY,
    message=SOUND_MESSAGE,
    particle=PARTICLE,
    sense=sense_slice,
    believe=believe_slice,
    entries=entries,
    observe=observe_slice,
    tables=calibrate,
    noted=NotedPercepts(GROUPS, percept_columns, summarise_percepts),
)
