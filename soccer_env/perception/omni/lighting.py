"""Changing light, and the colour table that must follow it.  [Heinemann et al. 2006, 1]  MH07

Brightness is given as the difference from the light for which the fixed table was made. Light between the table's and
the field's makes pixels drop out of their colour class: blobs are missed, and those that are found have lost their
rim. Both laws are assumed.

The adaptive table is trained online, as by ACT, automatic colour training [Heinemann, Sehnke, Zell 2006]: who knows
its own pose knows which colour class each pixel of field, lines and goals must show, whatever its colour; what lies
within the class's spread goes into the table, and what was there before fades out of it.

    own pose told or sensed, or enough white lines in the picture to know it by     else: nothing is learned
    colours within CLASS_SPREAD of the table                                         else: taken for something else
    the table moves to the picture's colours with `table_time`

So it follows light that changes, is left behind by light that jumps, and learns nothing where it recognises nothing.
Unlike the method, of which we know no numbers, it learns one light for all colours, and its three numbers are assumed.

`s`: settings of the sensors.
"""

from math import exp, log, pi, sin, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.leagues.omni_sensors import COLOUR_TABLES
from soccer_env.random_numbers import GOLDEN, TO_UNIT, mix, normal
from soccer_env.types import RobotStream

LIGHT = int(RobotStream.LIGHT)
ADAPTIVE = COLOUR_TABLES["adaptive"]
LIGHT_NOISE = 0.01  # [1] sd of the brightness that the camera measures, assumed
CLASS_SPREAD = 2.0 / sqrt(2.0 * log(2.0))  # [1] table widths: two standard deviations of a colour class, assumed
LEAST_LINES = 3  # directions that show a line in a picture from which the own pose can be known, assumed
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
def begin_table(table, measured, s, told):
    """Return the light that the colour table is made for before a picture [1].  MH07

    Who has just been told its pose needs no table to begin with: it trains one by the first picture. The fixed table
    stays as it was made.
    """
    if s.colour_table != ADAPTIVE:
        return 0.0
    return measured if told else table


@compiled
def train_table(table, measured, s, dt, placed):
    """Return the light that the colour table is made for after a picture [1]; `placed`: the pose is known.  MH07"""
    off = measured - table
    if s.colour_table != ADAPTIVE or not placed or abs(off) > CLASS_SPREAD * s.table_width:
        return table
    return table + off * clip(dt / max(s.table_time, dt), 0.0, 1.0)


@compiled
def recognised(light, table, s):
    """Return the share of pixels that keep their colour class [1]: one half at a difference of `table_width`.  MH07"""
    difference = (light - table) / s.table_width
    return exp(-min(log(2.0) * difference * difference, DARKEST))
