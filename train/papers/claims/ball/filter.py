"""How steady the believed ball is: averaging four estimates, and bearing against range.  [Sacks 2001, 3.1.1, fn 4]"""

from dataclasses import replace

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.train.papers.claim import Ablation, Batch, claim
from soccer_env.train.papers.claims.ball.range import CAMERA_AHEAD, RANGE_LABEL
from soccer_env.train.papers.plots import plot_bins
from soccer_env.train.papers.staging import LEGGED, distance_to_ball, play, put_ball, stage_ball, wrap_angle
from soccer_env.train.papers.true_sight import look_first
from soccer_env.train.papers.values import bin_masks, ratio, rms, subtract_row_mean
from soccer_env.train.papers.verdicts import Samples, exact, measured
from soccer_env.types import RobotStream

MATCHES = 128
CAMERA = int(RobotStream.CAMERA)
SLOW = 8  # frames: half a second
LARGE = 0.11  # [m] radius of the middle-size league's ball
SETTLE = 1.0  # [s]
SECONDS = 2.0  # [s] measured
NEAR, FAR = 0.20, 1.50  # [m] of the balls, along the ground from the camera
STEADY = {"dither": 0.0, "scale_error": 0.0, "ball_miss": 0.0, "patches": 0.0}  # a camera without noise
JUMP = 0.30  # [m] step of a ball, to measure when the filter has forgotten the old place
BINS = (0.60, 0.75, 0.90, 1.05, 1.20, 1.50)  # [m] edges for bearing against range, from where the criterion begins


def look_at_still_balls(batch: Batch, hold: int = 1, radius: float | None = None) -> Samples:
    """Return deviations (M, T) [m] of a still ball's estimates from each robot's mean, and the ball's range (M,) [m].

    hold: number of consecutive frames with equal camera noise; radius: ball radius [m], None for the league's radius.
    """
    rng, league = batch.rng(), find_league(LEGGED)
    if radius is not None:
        league = replace(league, ball=replace(league.ball, radius=radius))
    pose = rng.uniform(-0.3, 0.3, MATCHES), rng.uniform(-0.2, 0.2, MATCHES), rng.choice([0.0, np.pi], MATCHES)
    place, aside = rng.uniform(NEAR, FAR, MATCHES), rng.uniform(-0.4, 0.4, MATCHES)
    match = stage_ball(batch, *pose, CAMERA_AHEAD + place, aside, league=league)
    true, bearing = distance_to_ball(match)
    look_first(match, SETTLE)
    frames = []
    draws = match.robots["noise"][:, 0, CAMERA]
    before = draws.copy()
    for step in play(match, SECONDS):
        if (step + 1) % hold:
            draws[:] = before  # the next frame repeats the noise of this one
        before = draws.copy()
        ball = match.beliefs["ball"][:, 0]
        seen = ball["age"] < 0.5 * match.league.dt
        aside = true * wrap_angle(ball["bearing"] - bearing)
        frames.append([np.where(seen, x, np.nan) for x in (ball["distance"], ball["filtered_distance"], aside)])
    match.close()
    raw, filtered, aside = (subtract_row_mean(np.stack(values, axis=1)) for values in zip(*frames, strict=True))
    span = np.full(MATCHES, averaging_time(batch))
    return {"range": place, "raw": raw, "filtered": filtered, "aside": aside, "span": span}


def averaging_time(batch: Batch) -> float:
    """Return the filter's averaging time [s]: from a jump of the ball until the estimate is within 10 % of the jump."""
    match = stage_ball(batch, 0.0, 0.0, 0.0, np.array([0.5]), 0.0, sensors=STEADY)
    look_first(match, SETTLE)
    put_ball(match, 0.5 + JUMP, 0.0)
    match.rebuild()
    places = [float(match.beliefs["ball"]["filtered_distance"][0, 0]) for _ in play(match, SETTLE)]
    match.close()
    still = [abs(place - places[-1]) < 0.1 * JUMP for place in places]
    return (still.index(True) + 1) * match.league.dt if True in still else float("nan")


def radial_over_tangential(samples: Samples) -> float:
    """Return the rms deviation along the line of sight divided by that across it, the least of the bins of BINS."""
    inside = bin_masks(samples["range"], BINS)
    ratios = [rms(samples["raw"][here]) / max(rms(samples["aside"][here]), 1e-12) for here in inside]
    return float(np.min(ratios))


filter_figure = plot_bins(
    "Scatter of a still ball's estimate", RANGE_LABEL, "deviation [cm]",
    {"raw": "raw", "mean of four": "filtered", "across the line of sight": "aside"}, "range",
    np.linspace(NEAR, FAR, 9), rms,
)  # fmt: skip
HOW = (
    f"{MATCHES} standing robots a batch look at still balls {100 * NEAR:.0f} to {100 * FAR:.0f} cm from the "
    f"camera for {SECONDS:g} s; scatter of each robot's estimates about its own mean."
)

S16 = claim(
    "S16", "3.1.1", "The average of four estimates, over about 1/4 s, steadies the ball's position.",
    f"{HOW} The span is the time in which a ball that is moved at once has left the average.",
    measured("deviation of the filtered range over the raw one's", ratio, "filtered", "raw", rms, at_least=0.45,
             at_most=0.6),
    exact("span of the average", "span", unit="s", at_least=0.2, at_most=0.3),
    measure=look_at_still_balls, figures=filter_figure, batches=32, seconds=0.5,
    without=Ablation(f"flicker that is drawn anew in each frame: here every {SLOW} frames, a gait step of half a "
                     "second", lambda batch: look_at_still_balls(batch, hold=SLOW)),
    ingredients=("memory.averaged = 4", "16 frames a second", "sensors.dither, drawn anew in each frame"),
)  # fmt: skip

S17 = claim(
    "S17", "footnote 4", "Angles to the ball are more stable over time than distances.",
    f"{HOW} Raw estimates, along the line of sight and across it, in bins of "
    f"{', '.join(f'{100 * edge:.0f}' for edge in BINS)} cm; the bin where they differ least counts.",
    measured("deviation of the range over that across, from 60 cm on", radial_over_tangential, at_least=3.0),
    measure=look_at_still_balls, figures=filter_figure, batches=32, seconds=0.5,
    without=Ablation("a ball of 84 mm: distance over diameter is the ratio that a pinhole gives; here one of 220 mm",
                     lambda batch: look_at_still_balls(batch, radius=LARGE)),
    ingredients=("sensors.dither, the same for a blob's size and its place", "88x72 pixels over 57.6 degrees"),
)  # fmt: skip
