"""The goalkeeper's place, and its ways to the ball: geometry of its kernels.  [Heinemann et al. 2006, 4]

`k`: the league's constants, `play`: the team's settings; here arrays of one record.
"""

from functools import partial

import numpy as np

from soccer_env.baselines.heinemann_2006.goalkeeper import interception, passive_place
from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings, settings_records
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills.sight import SIGHT
from soccer_env.train.papers.claim import NO_MATCH, Ablation, Batch, claim
from soccer_env.train.papers.staging import MIDDLE
from soccer_env.train.papers.values import mean, median
from soccer_env.train.papers.verdicts import Samples, measured

SCENES = 300  # of a batch
BALLS, ANGLES = (2.0, 6.0), (0.0, 1.0)  # [m], [rad] of a still ball from the middle of the goal
OFF = (0.1, 0.2, 0.3, 0.4, 0.5)  # [m] along the half circle off the line d
LEAGUE = find_league(MIDDLE)
CONSTANTS = constants_of(LEAGUE)
OMNI = 1  # row of a team's settings


@compiled
def fill_passive_places(balls, places, k, play):
    """Fill `places` (n, 2) with the passive keeper's places for the balls (n, 2)."""
    for i in range(len(balls)):
        places[i, 0], places[i, 1] = passive_place(balls[i, 0], balls[i, 1], k[0], play[0])


@compiled
def fill_active_destinations(sights, places, k, play):
    """Fill `places` (n, 2) with the active keeper's destinations for the sights (n,)."""
    for i in range(len(sights)):
        places[i, 0], places[i, 1] = interception(sights[i], k[0], play[0])


def open_angle(balls: np.ndarray, keepers: np.ndarray) -> np.ndarray:
    """Return the angle [degrees] between the posts that keepers at (n, 2) leave open to balls at (n, 2)."""
    pitch, radius = LEAGUE.pitch, LEAGUE.ball.radius
    goal, half = -pitch.length / 2, pitch.goal_width / 2 - radius
    away = goal - balls[:, 0]
    low, high = (np.arctan2(side * half - balls[:, 1], -away) for side in (-1.0, 1.0))
    dx, dy = balls[:, 0] - keepers[:, 0], keepers[:, 1] - balls[:, 1]
    middle = np.arctan2(dy, dx)
    wide = np.arcsin(np.clip((LEAGUE.body.disc_radius + radius) / np.hypot(dx, dy), -1.0, 1.0))
    shadow = np.clip(np.minimum(high, middle + wide) - np.maximum(low, middle - wide), 0.0, None)
    return np.asarray(np.degrees(high - low - shadow))


def compare_open_angles(batch: Batch) -> Samples:
    """Return the open angle (M,) [degrees] with keepers on the line d, and moved off it along their half circle."""
    rng, goal = batch.rng(), -LEAGUE.pitch.length / 2
    away, angle = rng.uniform(*BALLS, SCENES), rng.choice([-1.0, 1.0], SCENES) * rng.uniform(*ANGLES, SCENES)
    balls, places = np.stack([goal + away * np.cos(angle), away * np.sin(angle)], axis=-1), np.zeros((SCENES, 2))
    settings = HeinemannSettings()
    fill_passive_places(balls, places, CONSTANTS, settings_records(settings)[OMNI : OMNI + 1])
    samples = {"on": open_angle(balls, places)}
    for off in OFF:
        for side in (-1.0, 1.0):
            turn = angle + side * off / settings.keeper_radius
            beside = np.stack([goal + settings.keeper_radius * np.cos(turn), settings.keeper_radius * np.sin(turn)], -1)
            samples[f"off {side * off:g}"] = open_angle(balls, beside)
    return samples


def open_angle_gains(samples: Samples) -> np.ndarray:
    """Return the smallest open angle with the keeper off the line minus the open angle on the line (M,) [degrees]."""
    off = np.stack([values for name, values in samples.items() if name != "on"])
    return np.asarray(off.min(axis=0) - samples["on"])


H17 = claim(
    "H17", "4", "On the line d through the ball and the goal's middle a goalkeeper minimises the open angles.",
    f"{SCENES} still balls a batch, {BALLS[0]:g} to {BALLS[1]:g} m from the goal and up to {ANGLES[1]:g} rad "
    "off its middle: the angle beside the passive keeper, and beside one 10 to 50 cm off along its half circle.",
    measured("balls to which d is best, to 0.1 degrees", lambda s: 100 * mean(open_angle_gains(s) > -0.1), unit="%",
             at_least=95.0),
    measured("it is better than 50 cm off by (mean)",
             lambda s: mean(np.minimum(s["off 0.5"], s["off -0.5"]) - s["on"]), unit="deg", above=1.0),
    rules=NO_MATCH, measure=compare_open_angles, batches=4, seconds=0.2,
    ingredients=("the keeper as a disc of its body's radius",),
)  # fmt: skip


def interception_distances(batch: Batch, along_line: bool = False) -> Samples:
    """Return the active keeper's distances (M,) [m] to its interception point, and to the ball's crossing of its line.

    `along_line`: it moves along its line to where the ball will cross it, not perpendicular into the trajectory.
    """
    rng, goal = batch.rng(), -LEAGUE.pitch.length / 2
    settings = HeinemannSettings(keeper_waits=False)
    away, angle = rng.uniform(3.0, 5.0, SCENES), rng.choice([-1.0, 1.0], SCENES) * rng.uniform(0.3, 0.8, SCENES)
    sights, places = np.zeros(SCENES, SIGHT), np.zeros((SCENES, 2))
    sights["ball_x"], sights["ball_y"] = goal + away * np.cos(angle), away * np.sin(angle)
    aim, speed = rng.uniform(-0.9, 0.9, SCENES), rng.uniform(2.4, 6.0, SCENES)
    way = np.arctan2(aim - sights["ball_y"], goal - sights["ball_x"])
    sights["ball_vx"], sights["ball_vy"] = speed * np.cos(way), speed * np.sin(way)
    record = settings_records(settings)[OMNI : OMNI + 1]
    fill_passive_places(np.stack([sights["ball_x"], sights["ball_y"]], -1), places, CONSTANTS, record)
    sights["x"], sights["y"] = places.T
    fill_active_destinations(sights, places, CONSTANTS, record)
    line = goal + settings.keeper_out
    cross = sights["ball_y"] + (line - sights["ball_x"]) * np.tan(way)
    if along_line:
        places[:, 0], places[:, 1] = line, cross
    return {
        "perpendicular": np.hypot(places[:, 0] - sights["x"], places[:, 1] - sights["y"]),
        "crossing": np.hypot(line - sights["x"], cross - sights["y"]),
    }


H21 = claim(
    "H21", "4", "Moving perpendicular into the predicted trajectory is a very short way.",
    f"{SCENES} shots a batch from 3 to 5 m at passive keepers: way to the foot of the perpendicular, and to "
    "where the trajectory crosses the keeper's line.",
    measured("one way over the other (median)", lambda s: median(s["perpendicular"] / s["crossing"]), at_most=0.7),
    measured("shots to which the perpendicular is the shorter",
             lambda s: 100 * mean(s["perpendicular"] <= s["crossing"] + 1e-9), unit="%", at_least=99.0),
    rules=NO_MATCH, measure=interception_distances, batches=4, seconds=0.2,
    without=Ablation("the perpendicular: here the keeper moves along its line to where the ball will cross it",
                     partial(interception_distances, along_line=True)),
    note="That the perpendicular is the shortest way to a line is geometry.",
)  # fmt: skip
