"""The declaration of the omnidirectional robot, which plays the middle-size league."""

import numpy as np

from soccer_env.belief.omni.believe import OMNI_MEMORY, believe_slice
from soccer_env.belief.omni.lines import line_tables
from soccer_env.belief.omni.radio import RADIO_MESSAGE
from soccer_env.belief.particles import PARTICLE
from soccer_env.leagues.robot_kind import CENTI, LINE_STEPS, POLAR, Group, NotedPercepts, PerceptSummary, RobotKind
from soccer_env.observations.omni import entries, observe_slice
from soccer_env.perception.omni.sense import OMNI_SENSOR_STATE, sense_slice
from soccer_env.records.percepts import OMNI_PERCEPT

MOST_PLAYERS = 9  # that a note keeps, nearest first
GROUPS: tuple[Group, ...] = (
    *([name, 1, POLAR] for name in ("ball", "own_goal", "opponent_goal")),
    ["players", MOST_PLAYERS, POLAR],
    ["lines", 32, ["distance"]],
)


def percept_columns(percepts: np.ndarray, beliefs: np.ndarray) -> dict[str, np.ndarray]:
    """Return the percept columns that a replay stores for robots (R,): sightings and lines, each (R, n, parts)."""
    arrays = {}
    for name, count, _ in GROUPS[:-1]:
        things = percepts[name].reshape(len(percepts), -1)[:, :count]
        side = np.where(things["teammate"] == 1, 1.0, -1.0) if name == "players" else 1.0
        polar = np.stack([CENTI * things["bearing"], CENTI * side * things["distance"]], axis=-1)
        arrays[name] = np.where((things["seen"] > 0)[..., None], polar, 0.0)
    return arrays | {"lines": LINE_STEPS * percepts["lines"][..., None]}


def summarise_percepts(percepts: np.ndarray) -> PerceptSummary:
    """Return a `PerceptSummary` of percepts (R,): ball, goals, players and lines, without an infrared range."""
    ball, own_goal, opponent_goal = (percepts[name]["seen"] > 0 for name in ("ball", "own_goal", "opponent_goal"))
    players, lines = percepts["players"]["seen"].sum(axis=1), (percepts["lines"] > 0.0).sum(axis=1)
    return PerceptSummary(ball, own_goal, opponent_goal, players, lines, np.zeros(len(percepts)))


OMNI = RobotKind(
    percept=OMNI_PERCEPT,
    sensor_state=OMNI_SENSOR_STATE,
    memory=OMNI_MEMORY,
    message=RADIO_MESSAGE,
    particle=PARTICLE,
    sense=sense_slice,
    believe=believe_slice,
    entries=entries,
    observe=observe_slice,
    tables=line_tables,
    noted=NotedPercepts(GROUPS, percept_columns, summarise_percepts),
    late=lambda sensors: sensors.camera_delay,
)
