"""The numbers that skills read, one record for each kind of base, and what a player of these skills remembers.

    CompiledTeam("runner", RUNNER, NO_MEMORY, skill_settings(strength=1.0), fit=fitted)

The kernel made by `per_player(act, SIGHT)` then has a record for `look`, and settings for the skills:

    scratch.pace, scratch.elapsed = settings.strength, k.dt  # share of its top speed, and time until it decides again
    look(scratch, belief, tracks, k)
    go(command, scratch, k, settings, x, y, facing, 0.0)
"""

import numpy as np

from soccer_env.guards.checking import check_finite_number
from soccer_env.guards.ranges import NUMBER, UNIT, ranged_record
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.leagues.robot import DRIVE_KINDS
from soccer_env.types import PLAYERS

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
    "run_in_cosine": (0.3, 0.94, 0.9),  # cosine of the angle off the line behind the ball for a run straight in
    "square_up": (0.0, 0.1, 0.0),  # [m] into the ball that a base which steps aside aims; 0: it faces the ball instead
    "near": (1.6, 1.8, 1.3),  # [touch distances] within which `near_cosine` counts instead
    "near_cosine": (-0.5, 0.85, 0.3),  # the same cosine near the ball
    "clearance": (0.05, 0.15, 0.25),  # [m] between front and ball on the way round
    "orbit_step": (0.6, 0.7, 0.6),  # [rad] of the way round that is looked ahead
    "orbit_speed": (0.12, 1.0, 0.6),  # [m/s] least on the way round
    "bump": (0.12, 0.5, 0.5),  # [m/s] at which the ball is met
    "delay": (0.1, 0.12, 0.12),  # [s] least time by which the ball is led
    "lead": (3.0, 1.5, 2.0),  # [s] greatest time by which the ball is led
    "kick_gap": (0.025, 0.04, 0.04),  # [m] the ball is at most this far from the front
    "kick_aside": (0.035, 0.08, 0.08),  # [m] and this far aside
    "room": (0.03, 0.03, 0.03),  # [rad] beside a shot
    "shot_range": (1.3, 7.0, 7.0),  # [m] of a shot at the goal
    "arrival": (0.0, 5.0, 5.0),  # [m/s] of a shot at the goal; 0: with all strength
    "plays_aside": (1.0, 0.0, 0.0),  # 1: kicks past what stands ahead, with one foreleg; 0: never
    "clears": (0.0, 1.0, 1.0),  # 1: kicks the ball away when it is pressed in its own half; 0: never
    "fetches": (1.0, 0.0, 0.0),  # 1: a goalkeeper goes for a ball in its third, off the corners; 0: near its goal
    "faces_ball": (1.2, 0.0, 0.0),  # [m] to a ball that a goalkeeper on legs faces even while it walks
    "beyond": (0.3, 0.0, 0.0),  # [m] off the pitch from which a ball is taken for something else; 0: never
    "wriggle_ahead": (-0.3, 0.3, 0.3),  # [1] speed ahead while working a ball out
    "wriggle_time": (3.0, 0.6, 0.8),  # [s]
    "patience": (3.0, 1.2, 1.5),  # [s]
    "still": (0.02, 0.15, 0.15),  # [m/s] a ball slower than this does not move
    "rank_time": (1.0, 0.3, 0.4),  # [s] before a player changes its rank
    "foresight": (1.0, 0.5, 0.6),  # [s] by which a player's own motion shortens its way to the ball
    "wrong_side": (0.3, 0.8, 1.0),  # [m] that a way from ahead of the ball is longer
    "cover": (0.8, 2.5, 2.5),  # [m] of the first supporter behind the ball, on its way to the own goal
    "back": (0.6, 2.0, 2.0),  # [m] between the next pairs of supporters
    "aside": (0.5, 1.5, 1.5),  # [m] of a pair beside the ball
    "change_side": (0.2, 0.6, 0.6),  # [m] from the middle before a supporter changes sides
    "keeper_out": (1.8, 1.8, 2.0),  # [body reaches] from the middle of the goal
    "keeper_zone": (0.4, 2.0, 2.0),  # [m] round the middle of the goal from which balls are cleared
    "shot_speed": (0.15, 0.5, 0.5),  # [m/s] a ball this fast towards the goal is a shot
    "dive": (0.0, 0.0, 0.0),  # [m/s] at which a shot is met
    "clear_cosine": (0.77, 0.77, 0.77),  # cosine of the angle to the way clear of the goal for a kick, 40 degrees
    "retreat": (0.75, 0.75, 0.75),  # [s] before a push is for too long it steps back: delay, gait step, legs' ramp
    "unsure": (45.0, 0.0, 0.0),  # [1] confidence in the own pose below which a player looks up for landmarks
    "lost": (15.0, 0.0, 0.0),  # [1] the same with the ball so near that it loses it
    "glance_time": (0.9, 0.9, 0.9),  # [s] of such a look
    "glance_rest": (1.0, 1.0, 1.0),  # [s] until the next
    "raised": (0.25, 0.0, 0.0),  # [rad] that the camera is raised above a ball farther away
}
CHOSEN_IN = (  # where these numbers were chosen, by kind of base: length of the pitch [m], reach [m], top speed [m/s]
    (3.0, 0.1535, 0.12),  # legged-2001
    (12.0, 0.287, 2.6),  # middle-size-2006
    (12.0, 0.287, 2.6),  # middle-size-2006-differential
)
FAMILIES = ("legged", "middle-size")  # of the leagues in which they were chosen, whose variants keep them as they are
FOLLOWS = {  # which of the three a number grows with; `way_on` would miss open goals
    **dict.fromkeys(("shot_range", "cover", "back", "aside", "change_side", "keeper_zone"), 0),
    **dict.fromkeys(("arrived", "walk_ahead", "clearance", "wrong_side", "kick_gap", "kick_aside", "square_up"), 1),
    **dict.fromkeys(("orbit_speed", "bump", "shot_speed", "arrival", "still"), 2),
}
MEMORY = ranged_record(
    [  # between two decisions
        ("wait", "f8", NUMBER),  # [s] until the next decision
        ("rank", "i8", PLAYERS),  # field team-mates nearer to the ball: 0 the attacker
        ("rank_age", "f8", NUMBER),  # [s] for which another rank has been right
        ("side", "f8", UNIT),  # +1 supports on the left of the ball, -1 on its right, 0 undecided
        ("way", "f8", UNIT),  # +1 goes round the ball counter-clockwise, -1 clockwise
        ("aim_error", "f8", NUMBER),  # [rad]
        ("stuck", "f8", NUMBER),  # [s] that the ball at my feet has not moved
        ("patience", "f8", NUMBER),  # [s] of being stuck until it is worked out
        ("wriggle", "f8", NUMBER),  # [s] left of working it out
        ("wriggle_side", "f8", UNIT),  # +1 turning left, -1 right
        ("set_piece", "f8", NUMBER),  # [s] left of remembering our restart: above 0 as its taker, below 0 its mate
        ("sweep", "f8", NUMBER),  # [s] left of sweeping it out of a corner
        ("sweep_way", "f8", NUMBER),  # [rad] in which it is swept, team frame
        ("sweep_side", "f8", UNIT),  # +1 turning left, -1 right
        ("pressed", "f8", NUMBER),  # [s] for which the robot has walked into an opponent
        ("back_off", "f8", NUMBER),  # [s] left of stepping back from it
        ("off_x", "f8", NUMBER),  # unit vector away from it, team frame
        ("off_y", "f8", NUMBER),
        ("search_side", "f8", UNIT),  # +1 searches turning left, -1 right, 0 knows the ball
        ("turned", "f8", NUMBER),  # [rad] since it began to turn on the spot
        ("search_clock", "f8", NUMBER),  # [s] on the way to a lookout
        ("lookout", "f8", NUMBER),  # [m] x of it, team frame
        ("look_side", "f8", UNIT),  # +1 the head began to search on the left, -1 right, 0 knows the ball
        ("look_clock", "f8", NUMBER),  # [s] in the head's two sweeps
        ("phantom", "f8", NUMBER),  # [s] for which the ball was seen only where it cannot be
        ("glance", "f8", NUMBER),  # [s] left of looking up from the ball; below 0 until the next look
        ("glance_side", "f8", UNIT),  # +1 the next look begins on the right, -1 on the left, 0 none yet
        ("forward", "f8", NUMBER),  # the command that is repeated until the next decision
        ("aside", "f8", NUMBER),
        ("turn", "f8", NUMBER),
        ("kick", "f8", NUMBER),
        ("kicking", "f8", NUMBER),  # [s] for which a kick has been commanded with the ball at the feet
        ("kick_side", "f8", UNIT),  # of that kick: +1 to the left, -1 right, 0 ahead
    ]
)


def skill_settings(**own: float) -> np.ndarray:
    """Return the settings (3,) of the skills, one record for each of `DRIVE_KINDS`.

    A team's own fields come first; one that has the name of a skill's number replaces that number.
    """
    given = {name: 3 * (check_finite_number(name, value),) for name, value in own.items()}
    return settings_rows({**given, **NUMBERS, **given})


def settings_rows(numbers: dict[str, tuple[float, float, float]]) -> np.ndarray:
    """Convert numbers by name, each for the three kinds of base, to records (3,), one for each kind."""
    dtype = np.dtype([(name, "f8") for name in numbers])
    return np.array([tuple(values[kind] for values in numbers.values()) for kind in range(len(DRIVE_KINDS))], dtype)


def fitted(settings: np.ndarray, league: League) -> np.ndarray:
    """Return a team's settings (3,) for a league; outside FAMILIES they scale with the league's pitch and robot."""
    if league.family in FAMILIES:
        return settings
    k, scaled = constants_of(league)[0], settings.copy()
    here = (k["pitch_length"], k["body_reach"], k["drive_forward"])
    for kind, chosen in enumerate(CHOSEN_IN):
        for name, size in FOLLOWS.items():
            scaled[name][kind] *= here[size] / chosen[size]
    return scaled
