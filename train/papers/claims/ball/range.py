"""The range of the ball: by size, by infrared, the worth of a pixel, the finer camera.  [Sacks 2001, 3.1.1, 5]"""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.perception.legged.calibration import calibrate
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import NO_MATCH, Ablation, Batch, claim
from soccer_env.train.papers.claims.players.watching import stage_watchers
from soccer_env.train.papers.plots import plot_bins, plot_curves, plots
from soccer_env.train.papers.staging import LEGGED, OPEN_FLOOR
from soccer_env.train.papers.true_sight import look_first, range_from_camera, stare_for
from soccer_env.train.papers.values import bin_masks, median, middles_of, quantile, ratio, rms, subtract_row_mean
from soccer_env.train.papers.verdicts import Samples, exact, measured, reported

# The ball system that Sacks found: the larger dimension by table, no ranger, no rules, no filter, bearing-only memory.
OLD = {
    "infrared_override": False, "horizon": False, "double_area": False, "odometry": "rotation", "averaged": 1,
}  # fmt: skip
MATCHES = 128
SETTLE = 0.75  # [s] during which the head is turned to the ball; then it tracks by itself
SECONDS = 1.0  # [s] that are measured
FRESH = 1e-6  # [s] greatest age of a ball seen in this frame
CAMERA_AHEAD = 0.15  # [m] of the body's centre, roughly: used only to place balls
# Claims about sensors count ranges along the ground from the camera, like the tables of sizes.
NEAR, FAR = 0.05, 0.60  # [m] from a ball before the paws to the range that the criterion names
LEAST_RANGE, MOST_RANGE = 0.15, 0.90  # [m] S06
WIDTH = 0.05  # [m] of its bins
EDGES = np.arange(LEAST_RANGE, MOST_RANGE + 1e-9, WIDTH)
MIDDLES = np.array(middles_of(EDGES))
KINDS = ("size", "infrared")  # of estimates of the range
CROSSING = (0.35, 0.45)  # [m] "about 40 cm"
BEYOND = (0.45, 0.80)  # [m] where the ranger must be the worse one
STEPS = ((0.05, 0.52, 0.64), (0.10, 0.74, 0.90))  # [m] worth of a pixel, and the ranges where it is expected: S15
RANGE_LABEL = "range along the ground from the camera [cm]"
SMALLEST, LARGEST = 3, 60  # [px] sizes of the ball in S15


def watch_ball(batch: Batch, place: np.ndarray, seconds: float = SECONDS, **settings: Any) -> Samples:
    """Let standing robots look at a ball; return true distances and errors (M, T), NaN in frames without the ball.

    place: approximate ball distances from the camera (M,) [m]; poses and bearings are random, nothing else is orange.
    "range": from the camera; "distance" (from the body's centre) and "bearing": errors.
    """
    rng, count = batch.rng(), len(place)
    pose = rng.uniform(-0.5, 0.5, count), rng.uniform(-0.2, 0.2, count), rng.uniform(-np.pi, np.pi, count)
    bearing = rng.uniform(-0.7, 0.7, count)
    match = staging.stage_ball(batch, *pose, CAMERA_AHEAD + place, bearing, league=OPEN_FLOOR, **settings)
    look_first(match, SETTLE)

    def read() -> Samples:
        (true, bearing), ball = staging.distance_to_ball(match), match.beliefs["ball"][:, 0]
        errors = {"distance": ball["distance"] - true, "bearing": staging.wrap_angle(ball["bearing"] - bearing)}
        seen = {name: np.where(ball["age"] < FRESH, error, np.nan) for name, error in errors.items()}
        return {"range": range_from_camera(match), **seen}

    return staging.record(match, staging.play(match, seconds), read)


def error_quartiles(samples: Samples) -> Sequence[Sequence[float]]:
    """Return bins of the distance [cm], and the median and quartiles [cm] of the range error in them."""
    edges = np.linspace(NEAR, FAR, 9)
    error = np.abs(samples["distance"])
    errors = [error[there] for there in bin_masks(samples["range"][:, 0], edges)]
    return middles_of(edges, 100), *([100 * quantile(e, share) for e in errors] for share in (0.5, 0.25, 0.75))


S05 = claim(
    "S05", "3.1.1", "The old system, range by size and angle by head and image, works fairly well.",
    f"{MATCHES} standing robots a batch track an unobstructed ball {100 * NEAR:.0f} to {100 * FAR:.0f} cm from "
    "the camera, along the ground, for 1 s; raw estimate against truth, frames that show it.",
    measured("median range error over the distance",
             lambda samples: 100 * median(np.abs(samples["distance"]) / samples["range"]), unit="%", at_most=10.0),
    measured("median bearing error", lambda s: np.degrees(median(np.abs(s["bearing"]))), unit="deg", at_most=2.0),
    measure=lambda batch: watch_ball(batch, batch.rng(1).uniform(NEAR, FAR, MATCHES), memory=OLD),
    figures=plot_curves("Range error of the ball, unobstructed", RANGE_LABEL, "error [cm]",
                        {"median and quartiles": error_quartiles}),
    seconds=0.7,
    ingredients=("sensors.dither", "sensors.scale_error", "the tables of perception/legged/calibration.py"),
)  # fmt: skip


def compare_size_and_infrared(batch: Batch, **sensors: float) -> Samples:
    """Estimate ranges of equal balls by size and by infrared alone; return true ranges and both errors (M, T) [m]."""
    place = batch.rng(1).uniform(LEAST_RANGE - 0.05, MOST_RANGE + 0.05, 2 * MATCHES)
    rule = OLD | {"under_head": False}
    seen = {kind: watch_ball(batch, place, 0.5, memory=rule | {"ball_range": kind}, sensors=sensors) for kind in KINDS}
    return {kind: one["distance"] for kind, one in seen.items()} | {"range": seen["infrared"]["range"]}


def error_ratios(samples: Samples) -> np.ndarray:
    """Return the rms error of ranges by infrared over that by size, in each bin of EDGES."""
    inside = bin_masks(samples["range"], EDGES)
    by_size, by_infrared = (np.array([rms(samples[kind][there]) for there in inside]) for kind in KINDS)
    return np.asarray(by_infrared / by_size)


def crossing_range(samples: Samples) -> float:
    """Return the smallest range [cm] beyond which, up to 60 cm, infrared errs more than size; interpolated in bins."""
    ratio = np.log(error_ratios(samples))
    better = np.flatnonzero((ratio <= 0.0) & (MIDDLES < FAR))
    if len(better) == 0:
        return 100 * LEAST_RANGE
    last = int(better[-1])
    share = np.clip(ratio[last] / min(ratio[last] - ratio[last + 1], -1e-9), 0.0, 1.0)
    return float(100 * (MIDDLES[last] + share * WIDTH))


def table_steps(resolution: str) -> Samples:
    """Return the middle ("range") and size ("step") [m] of the calibration table's steps from one pixel to the next."""
    league = find_league(LEGGED)
    sensors = replace(league.sensors, resolution=resolution)
    table = calibrate(replace(league, sensors=sensors))["ball_width"][0, SMALLEST : LARGEST + 1]
    return {"range": 0.5 * (table[1:] + table[:-1])[None], "step": (table[:-1] - table[1:])[None]}


def range_at_step(samples: Samples, step: float) -> float:
    """Return the range [cm] at which one pixel of the ball's width is worth `step` [m] of range."""
    order = np.argsort(samples["step"][0], kind="stable")
    return float(100 * np.interp(step, samples["step"][0][order], samples["range"][0][order]))


S06 = claim(
    "S06", "3.1.1", "Beyond about 40 cm infrared tells the ball's range less accurately than its size.",
    f"{2 * MATCHES} standing robots a batch track an unobstructed ball; range by size or by the ranger (by size "
    "in frames without a valid reading on the ball), all frames that show the ball, bins of 5 cm.",
    measured("range from which infrared is the worse one", crossing_range, unit="cm", at_least=100 * CROSSING[0],
             at_most=100 * CROSSING[1]),
    measured("rms error of infrared over that of size, least in 45 to 80 cm",
             lambda s: float(np.min(error_ratios(s)[(BEYOND[0] < MIDDLES) & (BEYOND[1] > MIDDLES)])), above=1.0),
    measure=compare_size_and_infrared,
    figures=plot_bins("Range error of the ball", RANGE_LABEL, "rms error [cm]", {f"by {kind}": kind for kind in KINDS},
                      "range", EDGES, rms),
    batches=32, seconds=2.5,
    without=Ablation("sensors.infrared_growth = 0: a ranger as good far away as near",
                     lambda b: compare_size_and_infrared(b, infrared_growth=0.0)),
    ingredients=("sensors.infrared_growth and infrared_power, chosen so that the laws cross at 40 cm",
                 "sensors.dither"),
)  # fmt: skip

S15 = claim(
    "S15", "3.1.1", "A single pixel can change the ball's distance by 5 or 10 cm.",
    "The calibration table for the ball's width: range at which neighbouring sizes are 5 and 10 cm apart.",
    *(exact(f"range at which a pixel is worth {100 * step:.0f} cm", range_at_step, step, unit="cm",
            at_least=100 * low, at_most=100 * high) for step, low, high in STEPS),
    rules=NO_MATCH, measure=lambda batch: table_steps("88x72"), batches=1, seconds=0.5,
    figures=plot_curves("One pixel of the ball's width", "range [cm]", "worth in range [cm]",
                        {"88x72": lambda s: (100 * s["range"][0], 100 * s["step"][0])}, rules=(5.0, 10.0)),
    without=Ablation("88x72 pixels: with 176x144 instead", lambda batch: table_steps("176x144")),
    ingredients=("88 pixels over 57.6 degrees", "a ball 84 mm across"),
)  # fmt: skip

# The finer layer of the camera

STARERS = 64
STARE_SETTLE, STARE_SECONDS = 2.0, 3.0  # [s]
STILL_NEAR, STILL_FAR = 0.45, 1.50  # [m] of the ball; nearer, the ranger and the angle under the head take over
LAYERS = ("88x72", "176x144")


def watch_still_balls(batch: Batch, layer: str, override: bool = False, **sensors: Any) -> dict[str, np.ndarray]:
    """Return deviations (M, T) of "range" [m] from each run's mean, radial "velocity" [m/s], and "true" range (M,) [m].

    Ranges are by size alone unless `override` lets the ranger correct them.
    """
    rng = batch.rng()
    settings = {"resolution": layer, "patches": 0.0, **sensors}
    memory = {"infrared_override": override}
    match = stage_watchers(batch, STARERS, league=OPEN_FLOOR, sensors=settings, memory=memory)
    distance, bearing = rng.uniform(STILL_NEAR, STILL_FAR, STARERS), rng.uniform(-0.4, 0.4, STARERS)
    staging.put_ball(match, *staging.point_ahead(match, 0, distance, bearing))
    staging.begin_scene(match)
    true, _ = staging.distance_to_ball(match)

    def read() -> Samples:
        ball = match.beliefs["ball"][:, 0]
        seen = ball["age"] < 0.5 * match.league.dt
        return {name: np.where(seen, ball[name], np.nan) for name in ("distance", "radial")}

    found = staging.record(match, stare_for(match, STARE_SETTLE, STARE_SECONDS), read)
    return {"true": true, "range": subtract_row_mean(found["distance"]), "velocity": found["radial"]}


def compare_layers(batch: Batch, **fine: Any) -> Samples:
    """Return `watch_still_balls` of both layers; `fine`: sensor settings of the finer layer; "... rules": ranger on."""
    samples: Samples = {}
    for layer, sensors in zip(LAYERS, ({}, fine), strict=True):
        for name, override in (("", False), (" rules", True)):
            runs = watch_still_balls(batch, layer, override, **sensors)
            samples |= {f"{part} {layer}{name}": runs[part] for part in ("range", "velocity")}
    return samples | {"true": runs["true"]}


S66 = claim(
    "S66", "5", "The high resolution camera would steady the ball's distance, and so its velocity.",
    f"{STARERS} robots a batch stare at a still ball {100 * STILL_NEAR:.0f} to {100 * STILL_FAR:.0f} cm away for "
    f"{STARE_SECONDS:g} s with each layer of the camera; deviation of the latest range from each run's mean, and of "
    "the radial velocity from zero, frames that show the ball, same seeds; ranges by size, the ranger's rule off, "
    "because no camera mends what the ranger does. About half: 0.4 to 0.6.",
    measured("deviation of the range at 176x144 over that at 88x72", ratio, "range 176x144", "range 88x72", rms,
             at_least=0.4, at_most=0.6),
    measured("deviation of the velocity, the same", ratio, "velocity 176x144", "velocity 88x72", rms, at_least=0.4,
             at_most=0.6),
    reported("range, ranger included", ratio, "range 176x144 rules", "range 88x72 rules", rms),
    reported("velocity, ranger included", ratio, "velocity 176x144 rules", "velocity 88x72 rules", rms),
    measure=compare_layers,
    figures=plots(*(plot_bins(f"Scatter of a still ball's {name}", "distance [cm]", f"deviation [{unit}]",
                              {layer: f"{name} {layer}" for layer in LAYERS}, "true",
                              np.linspace(STILL_NEAR, STILL_FAR, 8), rms)
                    for name, unit in (("range", "cm"), ("velocity", "cm/s")))),
    batches=32, seconds=1.5,
    without=Ablation("sensors.dither, the same number of pixels in both layers; here the same angle",
                     partial(compare_layers, dither=2.0 * find_league(LEGGED).sensors.dither)),
    ingredients=("sensors.dither", "pixels of half the size"),
    note="With the ranger's rule on (a reading below 2/3 of the range by size wins) the finer layer gains less, least "
    "at about a metre: readings of the ranger are so noisy there that many a one is short by a third.",
)  # fmt: skip
