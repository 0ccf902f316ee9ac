"""Changing light, and the colour table that must follow it.  [Heinemann et al. 2006, 1]  MH07

Brightness is given as the difference from the light for which the fixed table was made. Light between the table's and
the field's makes pixels drop out of their colour class: blobs are missed, and those that are found have lost their
rim. Both laws are assumed.

`s`: settings of the sensors.
"""

from __future__ import annotations

from math import exp, log, pi, sin

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.leagues.omni_sensors import COLOUR_TABLES
from soccer_env.random_numbers import GOLDEN, TO_UNIT, mix, normal
from soccer_env.types import RobotStream

LIGHT = int(RobotStream.LIGHT)
ADAPTIVE = COLOUR_TABLES["adaptive"]
LIGHT_NOISE = 0.01  # [1] sd of the brightness that the camera measures, assumed
DARKEST = 40.0  # [1] exponent beyond which nothing is recognised at all


@compiled
def brightness(match, s):
    """Return the light of a match now [1]: a slow sine whose phase follows from the seed.  MH07"""
    if s.light_drift <= 0.0:
        return 0.0
    bits = mix(np.uint64(match.seed) + GOLDEN * np.uint64(match.episode + 1))
    start = np.float64(bits >> np.uint64(11)) * TO_UNIT
    return s.light_drift * sin(2.0 * pi * (match.clock / s.light_period + start))


@compiled
def measure_light(light, s, noise):
    """Return the brightness of the picture [1]; constant light is known exactly."""
    return light + LIGHT_NOISE * normal(noise, LIGHT) if s.light_drift > 0.0 else light


@compiled
def adapt_table(table, measured, s, dt, first):
    """Return the light that the colour table is made for after a frame [1].  MH07

    The adaptive table follows the light with a time constant and has done so before the first frame; the fixed one
    stays as it was made.
    """
    if s.colour_table != ADAPTIVE:
        return 0.0
    if first:
        return measured
    return table + (measured - table) * clip(dt / max(s.table_time, dt), 0.0, 1.0)


@compiled
def recognised(light, table, s):
    """Return the share of pixels that keep their colour class [1]: one half at a difference of `table_width`.  MH07"""
    difference = (light - table) / s.table_width
    return exp(-min(log(2.0) * difference * difference, DARKEST))
