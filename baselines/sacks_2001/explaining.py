"""Explanations of sacks-2001 for viewers: a player's behaviour, its path, and the forces on it.

`k`: the league's constants; `play`: the team's settings.
"""

from math import atan2, cos, sin

import numpy as np

from soccer_env.baselines.sacks_2001.forces import goal_force, wall_force
from soccer_env.baselines.sacks_2001.memory import APPROACH, BEHAVIOURS, DRIBBLE
from soccer_env.baselines.sacks_2001.steering import direction_to_goal, force_of_players
from soccer_env.compiled import compiled
from soccer_env.geometry import into_frame, length, out_of_frame
from soccer_env.teams import DecisionInputs, Explanation

WAY_SHOWN = 0.5  # [m] of the way of a dribble, which has a direction and no end


def plan(mind: DecisionInputs) -> np.ndarray:
    """Return the path of the player's approach to the ball or of its dribble; other paths are not planned."""
    own, ball, memory = mind.beliefs["own"][0], mind.beliefs["ball"][0], mind.memory[0]
    place = np.array([own["x"], own["y"]])
    if memory["behaviour"] == APPROACH:
        return np.array([place, place + out_of_frame(ball["x"], ball["y"], cos(own["heading"]), sin(own["heading"]))])
    if memory["behaviour"] == DRIBBLE:
        return np.array([place, place + WAY_SHOWN * np.array([cos(memory["way"]), sin(memory["way"])])])
    return np.zeros((0, 2))


def forces(mind: DecisionInputs, target: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return the total force at each point on the robot, if it stood there; the goal is used in place of `target`."""
    total = np.zeros((len(points), 2))
    beliefs, tracks = mind.beliefs.copy(), mind.tracks.copy()
    force_field(mind.beliefs, mind.tracks, beliefs, tracks, mind.constants, mind.settings, points, total)
    return total


@compiled
def force_field(beliefs, tracks, moved_beliefs, moved_tracks, constants, settings, points, total):
    """Compute the force at each point, by the code that steers the team's dribbling."""
    k, play, own, moved = constants[0], settings[0], beliefs[0].own, moved_beliefs[0]
    for i in range(len(points)):
        copy_with_own_position(beliefs[0], tracks[0], moved, moved_tracks[0], points[i, 0], points[i, 1])
        goal_x, goal_y = direction_to_goal(moved.own, k)
        pull_x, pull_y = goal_force(goal_x, goal_y, play)
        push_x, push_y = force_of_players(moved, moved_tracks[0], goal_x, goal_y, k, play)
        total[i, 0] = pull_x + push_x
        total[i, 1] = pull_y + push_y + wall_force(points[i, 1], 0.5 * k.pitch_width, play)
    moved.own.x, moved.own.y = own.x, own.y


@compiled
def copy_with_own_position(belief, tracks, moved, moved_tracks, x, y):
    """Copy a belief with the own position moved to (x, y), while other robots stay in place on the field."""
    cosine, sine = cos(belief.own.heading), sin(belief.own.heading)
    ahead, left = into_frame(x - belief.own.x, y - belief.own.y, cosine, sine)
    moved.own.x, moved.own.y = x, y
    for slot in range(len(tracks)):
        moved_tracks[slot].x = tracks[slot].x - ahead
        moved_tracks[slot].y = tracks[slot].y - left
    if belief.obstacle.distance > 0.0:
        there_x = belief.obstacle.distance * cos(belief.obstacle.bearing) - ahead
        there_y = belief.obstacle.distance * sin(belief.obstacle.bearing) - left
        moved.obstacle.distance, moved.obstacle.bearing = length(there_x, there_y), atan2(there_y, there_x)


SHOWN: dict[str, tuple[str, ...]] = {"behaviour": BEHAVIOURS, "attacks": ("supporter", "attacker")}
EXPLANATION = Explanation(SHOWN | dict.fromkeys(("stuck", "tries", "left"), ()), plan, forces)
