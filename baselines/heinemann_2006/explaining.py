"""Explanations of heinemann-2006 and weigel-2001 for viewers: a player's role, its plan, its potential field.

`k`: the league's constants; `play`: the team's settings.
"""

import numpy as np

from soccer_env.baselines.heinemann_2006.driving import fill_planner_settings, note_crowd
from soccer_env.baselines.heinemann_2006.memory import ROLES, SCRATCH
from soccer_env.baselines.heinemann_2006.team import act
from soccer_env.baselines.weigel_2001.planner.potential import gradient
from soccer_env.compiled import compiled
from soccer_env.skills.sight import fill_sight
from soccer_env.teams import DecisionInputs, Explanation
from soccer_env.types import COMMAND


def plan(mind: DecisionInputs) -> np.ndarray:
    """Return the path that the player would now drive, from a new decision on a copy of its memory."""
    scratch, memory = np.zeros(1, SCRATCH), mind.memory.copy()
    memory["skill"]["wait"] = 0.0
    decide_again(mind.beliefs, mind.tracks, memory, mind.noise.copy(), mind.constants, settings_of(mind), scratch)
    made = scratch["plan"][0, 0]
    path = made["path"][: made["count"]]
    return np.column_stack([path["x"], path["y"]])


def forces(mind: DecisionInputs, target: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return minus the gradient of the potential at each point, given the present positions of the other robots."""
    scratch, slopes = np.zeros(1, SCRATCH), np.zeros((len(points), 2))
    scratch["place"][0, 0] = tuple(target)
    compute_descent(mind.beliefs, mind.tracks, mind.constants, settings_of(mind), scratch, points, slopes)
    return slopes


def settings_of(mind: DecisionInputs) -> np.ndarray:
    """Return the player's settings for the kind of base in its league, shape (1,)."""
    kind = int(mind.constants["drive_kind"][0])
    return mind.settings[kind : kind + 1]


@compiled
def decide_again(beliefs, tracks, memory, noise, constants, settings, scratch):
    """Make the team's decision again, in a scratch record that the caller reads afterwards."""
    command = np.zeros(1, COMMAND)
    act(beliefs[0], tracks[0], memory[0], noise[0], command[0], constants[0], settings[0], scratch[0])


@compiled
def compute_descent(beliefs, tracks, constants, settings, scratch, points, slopes):
    """Compute minus the gradient of the potential at each point.  MH10"""
    k, play, work = constants[0], settings[0], scratch[0]
    work.sight.pace = 1.0
    fill_sight(work.sight, beliefs[0], tracks[0], k)
    note_crowd(work, k, play, False)
    fill_planner_settings(work, k, play)
    ways = work.ways[0]
    for i in range(len(points)):
        u, v = points[i, 0] / ways.cell, points[i, 1] / ways.cell
        x, y = gradient(u, v, 0.0, work.place[0], work.crowd[: work.count], ways)
        slopes[i, 0], slopes[i, 1] = -x, -y


SHOWN: dict[str, tuple[str, ...]] = {"role": ROLES}
NUMBERS = ("rank", "stuck", "tries", "left", "wriggle", "back_off", "detour")
EXPLANATION = Explanation(SHOWN | dict.fromkeys(NUMBERS, ()), plan, forces, needs_target=True)
