"""The gain of the camera's finer layer: steadier ranges and velocities.  [Sacks 2001, 5]"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.train.papers.claim import Ablation, Batch, claim
from soccer_env.train.papers.claims.players.watching import stage_watchers
from soccer_env.train.papers.plots import plot_bins, plots
from soccer_env.train.papers.staging import LEGGED, begin_scene, distance_to_ball, point_ahead, put_ball, record
from soccer_env.train.papers.true_sight import stare_for
from soccer_env.train.papers.values import ratio, rms, subtract_row_mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

MATCHES = 64
SETTLE, SECONDS = 2.0, 3.0  # [s]
NEAR, FAR = 0.45, 1.50  # [m] of the ball; nearer, the ranger and the angle under the head take over
LAYERS = ("88x72", "176x144")


def watch_still_balls(batch: Batch, layer: str, override: bool = False, **sensors: Any) -> dict[str, np.ndarray]:
    """Return deviations (M, T) of "range" [m] from each run's mean, radial "velocity" [m/s], and "true" range (M,) [m].

    Ranges are by size alone unless `override` lets the ranger correct them.
    """
    rng = batch.rng()
    settings = {"resolution": layer, "patches": 0.0, **sensors}
    match = stage_watchers(batch, MATCHES, sensors=settings, memory={"infrared_override": override})
    put_ball(match, *point_ahead(match, 0, rng.uniform(NEAR, FAR, MATCHES), rng.uniform(-0.4, 0.4, MATCHES)))
    begin_scene(match)
    true, _ = distance_to_ball(match)

    def read() -> Samples:
        ball = match.beliefs["ball"][:, 0]
        seen = ball["age"] < 0.5 * match.league.dt
        return {name: np.where(seen, ball[name], np.nan) for name in ("distance", "radial")}

    found = record(match, stare_for(match, SETTLE, SECONDS), read)
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
    f"{MATCHES} robots a batch stare at a still ball {100 * NEAR:.0f} to {100 * FAR:.0f} cm away for "
    f"{SECONDS:g} s with each layer of the camera; deviation of the latest range from each run's mean, and of the "
    "radial velocity from zero, frames that show the ball, same seeds; ranges by size, the ranger's rule off, because "
    "no camera mends what the ranger does. About half: 0.4 to 0.6.",
    measured("deviation of the range at 176x144 over that at 88x72", ratio, "range 176x144", "range 88x72", rms,
             at_least=0.4, at_most=0.6),
    measured("deviation of the velocity, the same", ratio, "velocity 176x144", "velocity 88x72", rms, at_least=0.4,
             at_most=0.6),
    reported("range, ranger included", ratio, "range 176x144 rules", "range 88x72 rules", rms),
    reported("velocity, ranger included", ratio, "velocity 176x144 rules", "velocity 88x72 rules", rms),
    reported("range at 88x72", "range 88x72", of=rms, unit="cm"),
    reported("range at 176x144", "range 176x144", of=rms, unit="cm"),
    reported("velocity at 88x72", "velocity 88x72", of=rms, unit="cm/s"),
    reported("velocity at 176x144", "velocity 176x144", of=rms, unit="cm/s"),
    measure=compare_layers,
    figures=plots(*(plot_bins(f"Scatter of a still ball's {name}", "distance [cm]", f"deviation [{unit}]",
                              {layer: f"{name} {layer}" for layer in LAYERS}, "true", np.linspace(NEAR, FAR, 8), rms)
                    for name, unit in (("range", "cm"), ("velocity", "cm/s")))),
    batches=32, seconds=1.5,
    without=Ablation("sensors.dither, the same number of pixels in both layers; here the same angle",
                     partial(compare_layers, dither=2.0 * find_league(LEGGED).sensors.dither)),
    ingredients=("sensors.dither", "pixels of half the size"),
    note="With the ranger's rule on (a reading below 2/3 of the range by size wins) balls beyond about 0.9 m scatter "
    "as much with either layer: readings of the ranger are so noisy there that many a one is short by a third.",
)  # fmt: skip
