"""Changing light, and the vision's colour table that must adapt to it.  [Heinemann et al. 2006, 1]  MH07

Brightness is given as the difference from the light for which the fixed table was made. A difference between the light
of the table and of the field makes pixels drop out of their colour class: blobs are missed, and the others lose their
rim. Both laws are assumed.

The adaptive table is trained online, as by ACT, automatic colour training [Heinemann, Sehnke, Zell 2006]: a robot that
knows its own pose knows which colour class each pixel of field, lines and goals must show, whatever its colour; colours
within the class's spread enter the table, and old ones fade out of it.

    own pose told or sensed, or enough white lines in the picture to know it by     else: nothing is learned
    colours within CLASS_SPREAD of the table                                         else: taken for something else
    the table moves to the picture's colours with `table_time`

So the table follows slow changes of light, loses a sudden one, and learns nothing where it recognises nothing. Unlike
the method, whose numbers are not published, it learns one light for all colours, and its three numbers are assumed.

`s`: settings of the sensors.
"""

from math import exp, log, pi, sin, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.leagues.omni_sensors import COLOUR_TABLES
from soccer_env.random_numbers import GOLDEN, TO_UNIT, draw_normal, mix_bits
from soccer_env.types import RobotStream

LIGHT = int(RobotStream.LIGHT)
ADAPTIVE = COLOUR_TABLES["adaptive"]
LIGHT_NOISE = 0.01  # [1] sd of the brightness that the camera measures, assumed
CLASS_SPREAD = 2.0 / sqrt(2.0 * log(2.0))  # [1] table widths: two standard deviations of a colour class, assumed
LEAST_LINES = 3  # directions with a line in a picture that gives the own pose, assumed
DARKEST = 40.0  # [1] exponent beyond which nothing is recognised at all


@compiled
def brightness(match, s):
    """Return the present brightness of the light in a match [1]: a slow sine with a phase drawn from the seed.  MH07"""
    if s.light_drift <= 0.0:
        return 0.0
    bits = mix_bits(np.uint64(match.seed) + GOLDEN * np.uint64(match.episode + 1))
    start = np.float64(bits >> np.uint64(11)) * TO_UNIT
    return s.light_drift * sin(2.0 * pi * (match.clock / s.light_period + start))


@compiled
def measure_light(light, s, noise):
    """Return the measured brightness of the picture [1], with noise unless the light is constant."""
    return light + LIGHT_NOISE * draw_normal(noise, LIGHT) if s.light_drift > 0.0 else light


@compiled
def begin_colour_table(table, measured, s, told):
    """Return the brightness [1] to which the colour table is adapted before a picture.  MH07

    A robot that has just been told its pose (`told`) needs no table: its first picture trains one. The fixed table
    stays as it was made.
    """
    if s.colour_table != ADAPTIVE:
        return 0.0
    return measured if told else table


@compiled
def train_colour_table(table, measured, s, dt, placed):
    """Return the brightness [1] to which the colour table is adapted after a picture; `placed`: pose known.  MH07"""
    off = measured - table
    if s.colour_table != ADAPTIVE or not placed or abs(off) > CLASS_SPREAD * s.table_width:
        return table
    return table + off * clip(dt / max(s.table_time, dt), 0.0, 1.0)


@compiled
def recognised_share(light, table, s):
    """Return the share of pixels still in their colour class [1]: one half at a difference of `table_width`.  MH07"""
    difference = (light - table) / s.table_width
    return exp(-min(log(2.0) * difference * difference, DARKEST))
