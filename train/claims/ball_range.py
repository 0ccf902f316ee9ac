"""How far away a legged robot takes the ball to be, from size and head angles alone.  [Sacks 2001, 3.1.1]"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from soccer_env.train.claims.claim import SACKS, Batch, Claim, Curve, Figure
from soccer_env.train.claims.staging import ahead_of, ball_from, begin, put, put_ball, stage, watch, wrapped
from soccer_env.train.claims.values import median, quantile
from soccer_env.train.verdicts import Samples, measured

# The ball system that Sacks found: the larger dimension by table, no ranger, no rules, no filter, bearing-only memory.
OLD = {
    "infrared_override": False, "horizon": False, "double_area": False, "odometry": "rotation", "averaged": 1,
}  # fmt: skip
MATCHES = 128
SETTLE = 1.0  # [s] in which the head finds the ball
SECONDS = 1.0  # [s] that are measured
FRESH = 1e-6  # [s] age of a ball that is seen in this frame
NEAR, FAR = 0.20, 0.60  # [m] from a ball before the paws to the range that the criterion names


def watch_ball(batch: Batch, distance: np.ndarray, seconds: float = SECONDS, **settings: object) -> Samples:
    """Return what robots that stand and look at a ball believe: arrays (M, T), NaN in frames that do not show it.

    distance (M,) [m] from the body's centre; pose, heading and bearing are random.
    """
    rng, count = batch.rng(), len(distance)
    match = stage(batch, matches=count, **settings)
    put(match, 0, rng.uniform(-0.5, 0.5, count), rng.uniform(-0.2, 0.2, count), rng.uniform(-np.pi, np.pi, count))
    put_ball(match, *ahead_of(match, 0, distance, rng.uniform(-0.7, 0.7, count)))
    begin(match)
    rows: dict[str, list[np.ndarray]] = {"true": [], "distance": [], "bearing": []}
    for _ in watch(match, seconds, settle=SETTLE):
        true, bearing = ball_from(match)
        ball = match.beliefs["ball"][:, 0]
        seen = ball["age"] < FRESH
        rows["true"].append(true)
        rows["distance"].append(np.where(seen, ball["distance"] - true, np.nan))
        rows["bearing"].append(np.where(seen, wrapped(ball["bearing"] - bearing), np.nan))
    match.close()
    return {name: np.stack(values, axis=1) for name, values in rows.items()}


def old_system(batch: Batch) -> Samples:
    """Watch balls at all distances to 60 cm with the system that Sacks found."""
    return watch_ball(batch, batch.rng(1).uniform(NEAR, FAR, MATCHES), memory=OLD)


def range_figure(samples: Samples) -> Sequence[Figure]:
    """Draw the median error against the distance."""
    edges = np.linspace(NEAR, FAR, 9)
    middles = 0.5 * (edges[1:] + edges[:-1])
    place, error = samples["true"][:, 0], np.abs(samples["distance"])
    errors = [error[(place >= a) & (place < b)] for a, b in zip(edges, edges[1:], strict=False)]
    low, middle, high = ([100 * quantile(e, q) for e in errors] for q in (0.25, 0.5, 0.75))
    curve = Curve("median and quartiles", list(100 * middles), middle, low, high)
    return (Figure("Range error of the ball, unobstructed", "distance [cm]", "error [cm]", (curve,)),)


S05 = Claim(
    id="S05",
    paper=SACKS,
    section="3.1.1",
    statement="The old system, range by a table of sizes and angle by head and image position, works fairly well.",
    method=f"{MATCHES} standing robots a batch look at an unobstructed ball {100 * NEAR:.0f} to {100 * FAR:.0f} cm "
    "from the body's centre, for 1 s after the head has found it; raw estimate against truth, frames that show it.",
    criteria=(
        measured(
            "median range error <= 10 % of the distance",
            lambda samples: 100 * median(np.abs(samples["distance"]) / samples["true"]),
            unit="%",
            at_most=10.0,
        ),
        measured(
            "median bearing error <= 2 deg",
            lambda samples: np.degrees(median(np.abs(samples["bearing"]))),
            unit="deg",
            at_most=2.0,
        ),
    ),
    measure=old_system,
    figures=range_figure,
    ingredients=("sensors.dither", "sensors.scale_error", "the tables of perception/calibration.py"),
)

CLAIMS = (S05,)
