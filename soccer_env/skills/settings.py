"""The numbers that skills read, one record for each kind of base: `skill_settings`, for a compiled team of any league.

    CompiledTeam("runner", RUNNER, NO_MEMORY, skill_settings(strength=1.0), fit=fitted)

The kernel made by `per_player(act, SIGHT)` then has a record for `look`, and settings for the skills:

    scratch.pace, scratch.elapsed = settings.strength, k.dt  # share of its top speed, and time until it decides again
    look(scratch, belief, tracks, k)
    go(command, scratch, k, settings, x, y, facing, 0.0)
"""

import numpy as np

from soccer_env.guards.checking import check_finite_number
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.leagues.robot import DRIVE_KINDS

NUMBERS = {  # all assumed; for a gait, an omnidirectional and a differential base
    "settle": (0.7, 0.25, 0.3),  # [s] in which a turn or a step is to be done
    "arrived": (0.03, 0.05, 0.08),  # [m] near enough
    "walk_ahead": (0.25, 0.0, 0.0),  # [m] a walk this long is done facing ahead
    "walks_turned": (0.3, 0.0, 0.0),  # [m] a longer walk goes on sideways and backwards during a turn; 0: none does
    "turn_share": (1.0, 0.0, 0.5),  # [1] of the top turn rate with the ball, where it is not gone round
    "carry_share": (1.0, 0.15, 0.2),  # [1] of the top speed while turning with the ball
    "circle_share": (0.0, 0.3, 0.0),  # [1] of the acceleration that turning about the ball takes; 0: about itself
    "push_share": (1.0, 0.6, 0.9),  # [1] of the top speed while pushing it straight
    "aligned": (0.15, 0.3, 0.2),  # [rad] off the aim within which the ball counts as straight ahead
    "way_on": (0.7, 2.5, 2.5),  # [m] that a way for the ball is looked at
    "wing_cost": (0.2, 0.0, 0.0),  # [rad] room that a way may lose for ending in the middle, not at a touchline
    "sweeps": (1.2, 0.0, 0.0),  # [s] of one sweep of a searching head; 0: the head searches by itself
    "keeper_line": (1.35, 1.2, 1.2),  # [body reaches] from the goal line
}
CHOSEN_IN = (  # where these numbers were chosen, by kind of base: length of the pitch [m], reach [m], top speed [m/s]
    (3.0, 0.1535, 0.12),  # legged-2001
    (12.0, 0.287, 2.6),  # middle-size-2006
    (12.0, 0.287, 2.6),  # middle-size-2006-differential
)
FAMILIES = ("legged", "middle-size")  # of the leagues in which they were chosen, whose variants keep them as they are
FOLLOWS = {"arrived": 1, "walk_ahead": 1}  # which of the three a number grows with; `way_on` would miss open goals


def skill_settings(**own: float) -> np.ndarray:
    """Return the settings (3,) of the skills, one record for each of `DRIVE_KINDS`; a team's own fields come first."""
    given = {name: 3 * (check_finite_number(name, value),) for name, value in own.items()}
    return settings_rows({**given, **NUMBERS})


def settings_rows(numbers: dict[str, tuple[float, float, float]]) -> np.ndarray:
    """Convert numbers by name, each for the three kinds of base, to records (3,), one for each kind."""
    dtype = np.dtype([(name, "f8") for name in numbers])
    return np.array([tuple(values[kind] for values in numbers.values()) for kind in range(len(DRIVE_KINDS))], dtype)


def fitted(settings: np.ndarray, league: League, follows: dict[str, int] = FOLLOWS) -> np.ndarray:
    """Return a team's settings (3,) for a league; outside FAMILIES they scale with the league's pitch and robot."""
    if league.family in FAMILIES:
        return settings
    k, scaled = constants_of(league)[0], settings.copy()
    here = (k["pitch_length"], k["body_reach"], k["drive_forward"])
    for kind, chosen in enumerate(CHOSEN_IN):
        for name, size in follows.items():
            scaled[name][kind] *= here[size] / chosen[size]
    return scaled
