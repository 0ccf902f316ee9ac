"""The forces of the potential field: exponents, the goal's pull, the cosine, walls.  [Sacks 2001, 4.2, 4.3.1, 4.3.2]"""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.train.papers.claim import NO_MATCH, Ablation, Batch, Curve, Figure, claim
from soccer_env.train.papers.claims.field import points
from soccer_env.train.papers.claims.field.point_world import players
from soccer_env.train.papers.claims.field.points import FIELD, GOAL_X, ROBOTS, SCENES, TOUCH, UNIT
from soccer_env.train.papers.plots import columns
from soccer_env.train.papers.values import least_fall, least_rise, mean, median, reduction
from soccer_env.train.papers.verdicts import Samples, measured, reported

EXPONENTS = (1, 2, 3)
FEW_MORE = 2.0  # [pp] more collisions with the factor that still count as no extra collisions
REACTS = np.radians(5.0)  # [rad] off the goal's direction at which a robot has begun to go round a player, assumed
DEGREES = 180.0 / np.pi
NEAR_GOAL, FAR_GOAL = 0.8, 2.5  # [m]


def compare_exponents(batch: Batch) -> Samples:
    """Return distance at first reaction [m], peak turn [rad], clearance [m] (M, exponents); forces equal at 444 mm."""
    rng = batch.rng()
    start, crowd = points.starts(rng), points.player_near_path(rng, 0.0, 0.25)
    columns: dict[str, list[np.ndarray]] = {"onset": [], "peak": [], "clearance": []}
    for exponent in EXPONENTS:
        runs = points.run_points(rng, start, crowd, exponent=exponent, player_gain=matched_gain(exponent))
        away = np.linalg.norm(runs.others[:-1, :, 0] - runs.path[:-1], axis=-1)
        reacts = np.abs(runs.off) > REACTS
        first = reacts.argmax(axis=0)
        columns["onset"].append(np.where(reacts.any(axis=0), away[first, np.arange(SCENES)], np.nan))
        columns["peak"].append(np.nanmax(np.abs(runs.turns), axis=0))
        columns["clearance"].append(runs.clearance)
    return {name: np.stack(values, axis=1) for name, values in columns.items()}


def matched_gain(exponent: int) -> float:
    """Return the gain [m^n] for which a player's force is 1 at 444 mm."""
    return 0.8 * UNIT ** (exponent - 1)


onsets, peaks = columns("onset", median, 100.0), columns("peak", median, DEGREES)  # [cm], [deg]: for each exponent


def exponent_figures(samples: Samples) -> Sequence[Figure]:
    """Plot each exponent's force against the distance, and its path past a player over the default field."""
    distances = np.linspace(0.25, 1.1, 35)
    curves, plays = [], {}
    for exponent in EXPONENTS:
        settings: dict[str, Any] = {"exponent": exponent, "player_gain": matched_gain(exponent)}
        play = SacksSettings(**settings).record()[0]
        forces = [FIELD.repulsion(x, play["player_gain"], play["player_range"], play) for x in distances]
        curves.append(Curve(f"exponent {exponent}", list(100 * distances), forces))
        plays[f"exponent {exponent}"] = settings
    return (
        Figure("Force of a player, 1 at 444 mm", "distance [cm]", "force [goal's pull]", tuple(curves), rules=(1.0,)),
        points.draw_field("Paths past a player, and the forces with exponent 1", [[0.0, 0.12]], plays),
    )


S44 = claim(
    "S44", "4.3.1", "With forces by 1/d instead of 1/d^3 the robot reacts earlier and goes more smoothly.",
    f"{SCENES} points a batch pass a player that stands up to 25 cm beside their way, exponents 1, 2 and 3 with "
    "the gain for which the force is 1 at 444 mm, all else as in the team; distance from which the way is 5 degrees "
    "off the goal, and greatest turn from one step to the next.",
    measured("least fall of the first reaction's distance with the exponent", lambda s: least_fall(onsets(s)),
             unit="cm", above=0.0),
    measured("greatest turn rises with the exponent (least rise of the median)", lambda s: least_rise(peaks(s)),
             unit="deg", above=0.0),
    rules=NO_MATCH, measure=compare_exponents, figures=exponent_figures, batches=8, seconds=0.5,
    ingredients=("the distance at which the exponents are matched: where the paper's force is 1",),
)  # fmt: skip


def compare_reactions(batch: Batch, **play: Any) -> Samples:
    """Return turns off the goal's direction [degrees] for a player at equal relative places, near the goal and far."""
    rng, samples = batch.rng(), {}
    distance, bearing = rng.uniform(0.25, 0.7, SCENES), rng.uniform(-1.0, 1.0, SCENES)
    for name, away in (("near", NEAR_GOAL), ("far", FAR_GOAL)):
        start = np.column_stack([np.full(SCENES, GOAL_X - away), np.zeros(SCENES)])
        place = start + np.column_stack([distance * np.cos(bearing), distance * np.sin(bearing)])
        for kind in ("unit", "proportional"):
            runs = points.run_points(rng, start, players(place[:, None]), **{"goal_force": kind, **play})
            samples[f"{kind} {name}"] = np.degrees(runs.off[0])
    return samples


def reaction_difference(samples: Samples, kind: str) -> np.ndarray:
    """Return the absolute difference (M,) [degrees] between reactions near the goal and far from the goal."""
    return np.asarray(np.abs(samples[f"{kind} near"] - samples[f"{kind} far"]))


S46 = claim(
    "S46", "4.3.1", "With a constant goal force reactions do not depend on the goal's distance.",
    f"{SCENES} points a batch, {NEAR_GOAL:g} m and {FAR_GOAL:g} m from the goal, have a player at the same "
    "place relative to themselves, 25 to 70 cm away; difference of the directions off the goal that they take.",
    measured("unit force: greatest difference", lambda s: float(reaction_difference(s, "unit").max()), unit="deg",
             at_most=1e-6),
    reported("proportional force: mean difference", lambda s: mean(reaction_difference(s, "proportional")), unit="deg"),
    rules=NO_MATCH, measure=compare_reactions, batches=4, seconds=0.5,
    without=Ablation("a goal force of size 1 everywhere; here it is k1 times the distance, k1 = 1/m assumed",
                     partial(compare_reactions, goal_force="proportional")),
)  # fmt: skip


def compare_cosine_factor(batch: Batch) -> Samples:
    """Return deviations and lengths [m] of paths and collisions (M,), with the cosine factor and without it."""
    rng, samples = batch.rng(), {}
    start, crowd = points.starts(rng), points.player_near_path(rng, 0.0, 0.4)
    for name, cosine in (("with", True), ("without", False)):
        runs = points.run_points(rng, start, crowd, cosine_factor=cosine)
        samples[f"deviation {name}"], samples[f"length {name}"] = runs.deviation, runs.length
        samples[f"hit {name}"] = points.collided(runs).astype(float)
        robots = points.run_robots(batch, start, crowd, cosine_factor=cosine)
        samples[f"robots deviation {name}"] = points.pad_with_nan(robots.deviation)
        samples[f"robots clean {name}"] = points.pad_with_nan(robots.is_clean)
    return samples | {"aside": np.abs(crowd["y"][:, 0])}


S47 = claim(
    "S47", "4.3.1", "Without the cosine factor players beside and behind push robots farther aside than necessary.",
    f"{SCENES} points a batch pass a player that stands up to 40 cm beside their way, with the factor and "
    f"without; greatest deviation from the straight way; a collision is a distance below {100 * TOUCH:.0f} cm. "
    f"{ROBOTS} robots a batch do the same in the full simulator: the paper speaks of robots.",
    measured("deviation is less by (medians)", reduction, "deviation with", "deviation without", median, unit="%",
             above=0.0),
    measured("collisions with the factor less those without",
             lambda s: 100 * (mean(s["hit with"]) - mean(s["hit without"])), unit="pp", at_most=FEW_MORE),
    measured("robots: deviation is less by (medians)", reduction, "robots deviation with",
             "robots deviation without", median, unit="%", above=0.0),
    measure=compare_cosine_factor, batches=6, seconds=4.0,
    figures=lambda samples: [points.draw_field(f"Forces {word} the cosine factor", [[0.0, 0.15]],
                                               {"with the cosine": {}, "without": {"cosine_factor": False}}, **play)
                             for word, play in (("with", {}), ("without", {"cosine_factor": False}))],
)  # fmt: skip
