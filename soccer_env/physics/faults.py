"""Robots that fail: for a while (a dropout) or for the rest of the episode (a breakdown); see `leagues.robot.Faults`.

Whether a robot fails follows from the match's seed, the episode, the robot's number and the time alone: nothing is
stored, and the noise of working robots is not shifted.

`k`: the league's constants, under variation those of the match.
"""

from math import log

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.random_numbers import GOLDEN, MIX_1, bits_to_unit_interval, mix_bits

FAULT_KEY = np.uint64(0xA24BAED4963EE407)  # keeps faults independent of the noise streams of a seed
MINUTE = 60.0  # [s]


@compiled
def stop_if_failed(match, robot, k):
    """Return whether the robot fails now, and clear its command of drive and kick if so."""
    if (k.faults_dropouts <= 0.0 and k.faults_breakdowns <= 0.0) or not has_failed(match, robot, k):
        return False
    command = robot.command
    command.forward = command.left = command.turn = command.kick = 0.0
    return True


@compiled
def has_failed(match, robot, k):
    """Tell whether the robot has broken down, or drops out now.

    The time to a breakdown is exponential. Time falls into spans of `dropout_time`, from a moment of its own for each
    robot; it drops out for a whole span, with the probability that gives `dropouts` a minute.
    """
    key = mix_bits(np.uint64(match.seed) + GOLDEN * np.uint64(match.episode + 1)) ^ FAULT_KEY
    key = mix_bits(key + GOLDEN * np.uint64(2 * robot.number + robot.team + 1))
    time = match.step * k.dt
    if k.faults_breakdowns > 0.0 and time * k.faults_breakdowns >= -MINUTE * log(1.0 - bits_to_unit_interval(key)):
        return True
    if k.faults_dropouts <= 0.0:
        return False
    span = int(time / k.faults_dropout_time + bits_to_unit_interval(mix_bits(key + MIX_1)))
    drawn = bits_to_unit_interval(mix_bits(key + MIX_1 * np.uint64(span + 2)))
    return drawn * MINUTE < k.faults_dropouts * k.faults_dropout_time
