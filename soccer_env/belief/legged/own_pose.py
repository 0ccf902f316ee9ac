"""The own pose of a legged robot: its particles go by landmarks and goals.  MH08

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

import numpy as np

from soccer_env.belief.legged.landmarks import LANDMARK_VIEW, draw_from_landmark, look_at_landmarks, weigh_by_landmarks
from soccer_env.belief.own_pose import conclude, go_on_blind, motion_since, particles_are_due
from soccer_env.compiled import compiled, records


@compiled
def believe_pose_legged(percept, own, crowded, memory, particles, noise, k, s, w):
    """Bring the own pose of a legged robot up to the percept; its particles go by landmarks and goals.  MH08"""
    if not particles_are_due(percept.body, own, crowded, memory, particles, noise, k, s, w):
        return
    view = records(1, LANDMARK_VIEW)[0]
    seen = look_at_landmarks(percept, view, k, s, w)
    hand = np.float64(percept.body.handedness)
    if seen == 0:
        go_on_blind(own, memory, particles, noise, hand, k, w)
        return
    motion = motion_since(memory, k, w)
    weigh_by_landmarks(particles, view, motion, noise, hand, k, w)
    if conclude(own, memory, particles, seen, noise, w):
        for i in range(particles.shape[0]):
            if particles[i].weight == 0.0:
                draw_from_landmark(particles[i], view, noise, hand, k, w)
