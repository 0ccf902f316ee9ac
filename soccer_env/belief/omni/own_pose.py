"""The own pose of a middle-size robot: its particles go by white lines and goals.  MH08

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

import numpy as np

from soccer_env.belief.omni.field_lines import LINE_VIEW, draw_from_goal, look_at_lines, weigh_by_lines
from soccer_env.belief.own_pose import conclude, field_of, go_on_blind, motion_since, particles_are_due
from soccer_env.compiled import compiled, records


@compiled
def believe_pose_omni(percept, own, crowded, memory, particles, noise, k, s, w, table):
    """Bring the own pose of a middle-size robot up to the percept; its particles go by white lines and goals.  MH08

    `table` is the record of `perception.omni.sense.line_tables`.
    """
    if not particles_are_due(percept.body, own, crowded, memory, particles, noise, k, s, w):
        return
    view = records(1, LINE_VIEW)[0]
    seen = look_at_lines(percept, own, view, k, s, w)
    hand = np.float64(percept.body.handedness)
    if seen == 0:
        go_on_blind(own, memory, particles, noise, hand, k, w)
        return
    motion = motion_since(memory, k, w)
    half_length, half_width = field_of(k)
    weigh_by_lines(particles, view, motion, half_length, half_width, noise, hand, k, w, table)
    if conclude(own, memory, particles, seen, noise, w):
        for i in range(particles.shape[0]):
            if particles[i].weight == 0.0:
                draw_from_goal(particles[i], view, half_length, half_width, noise, hand, w)
