"""Tables from sizes in the picture to ranges, made by rendering noiseless pictures.  MS09, MS33"""

from __future__ import annotations

import numpy as np

from soccer_env.leagues.league import League

SIZES = 256  # [px] sizes that a table has room for; larger ones read as the last

CALIBRATION = np.dtype(
    [
        ("ball_width", "f8", (SIZES,)),  # [m] range of a ball that is i pixels wide
        ("ball_height", "f8", (SIZES,)),  # [m]
        ("player_front", "f8", (SIZES,)),  # [m] range of a player whose largest sticker is i pixels high, seen head-on
        ("player_side", "f8", (SIZES,)),  # [m] the same from the side
        ("player_front_all", "f8", (SIZES,)),  # [m] the same for the box round all its stickers
        ("player_side_all", "f8", (SIZES,)),  # [m]
    ]
)


def calibrate(league: League) -> np.ndarray:
    """Return the (1,) record of tables for a league's camera."""
    return np.zeros(1, CALIBRATION)
