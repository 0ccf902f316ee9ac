"""The scales of observations and states in numbers of a league: `own_x` is 1 at 1.8 m.

Entries have scales in words that hold in every league. Here a league's numbers and units replace the words.
"""

import re
from math import hypot, pi
from typing import Any

from soccer_env.leagues.league import League
from soccer_env.observations.entry import Entry
from soccer_env.observations.truth import NEAR, SLOW
from soccer_env.types import Phase


def scale_in_numbers(entry: Entry, league: League) -> str:
    """Return in numbers and units the quantity at which an entry is 1, or the formula of its soft scale."""
    known = scale_phrases(league)
    pattern = "|".join(re.escape(text) for text in sorted(known, key=len, reverse=True))
    return re.sub(pattern, lambda found: known[found[0]], entry.scale).removeprefix("soft: ")


def scale_phrases(league: League) -> dict[str, str]:
    """Return the phrases used for scales, such as "top turn rate", each with its number and unit in a league."""
    pitch, drive, fastest = league.pitch, league.drive, league.ball.top_speed
    diagonal = hypot(pitch.length, pitch.width)
    return {
        "half length plus goal depth": f"{pitch.length / 2 + pitch.goal_depth:.4g} m",
        "half width plus band": f"{pitch.width / 2 + pitch.band_side:.4g} m",
        "diagonal of the pitch": f"{diagonal:.4g} m",
        "a tenth of the diagonal": f"{NEAR * diagonal:.4g} m",
        "a tenth of its top speed": f"{SLOW * fastest:.4g} m/s",
        "its top speed": f"{fastest:.4g} m/s",
        "a control step at top speed": f"{drive.forward * league.dt:.4g} m",
        "a control step at the top turn rate": f"{drive.turn * league.dt:.4g} rad",
        "top speed ahead": f"{drive.forward:.4g} m/s",
        "top turn rate": f"{drive.turn:.4g} rad/s",
        "pi / 2": f"{pi / 2:.4g} rad",
        "pi": f"{pi:.4g} rad",
        "those of a gait step": f"{drive.gait_steps} control steps",
        "the last phase": f"{max(Phase):d}",
        "the match": f"{120.0 * league.rules.half_minutes:g} s, or the match that `minutes` asks for",
        "the half": f"{60.0 * league.rules.half_minutes:g} s, or half of `minutes`",
        **sensor_phrases(league.sensors),
    }


def sensor_phrases(sensors: Any) -> dict[str, str]:
    """Return the phrases used for sensors' scales, such as "greatest range", each with its number and unit."""
    numbers = {}
    if hasattr(sensors, "infrared_far"):
        numbers["its greatest valid range"] = f"{sensors.infrared_far:.4g} m"
    if hasattr(sensors, "line_range"):
        numbers["greatest range"] = f"{sensors.line_range:.4g} m"
    if hasattr(sensors, "resolution"):
        width, height = map(int, sensors.resolution.split("x"))  # [px]
        numbers |= {"the picture's width": f"{width} px", "the picture's height": f"{height} px"}
        numbers |= {"half the picture's width": f"{width // 2} px", "half the picture's height": f"{height // 2} px"}
    return numbers
