"""The relative velocity of the ball: how often to read it, and the accuracy of a reading.  [Sacks 2001, 3.2, 3.3]"""

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import Ablation, Batch, claim
from soccer_env.train.papers.claims.ball.range import CAMERA_AHEAD
from soccer_env.train.papers.plots import plot
from soccer_env.train.papers.staging import LEGGED
from soccer_env.train.papers.true_sight import range_from_camera, stare_at_ball, stare_for
from soccer_env.train.papers.values import least_fall, rms
from soccer_env.train.papers.verdicts import Samples, counted, exact, measured, reported

MATCHES = 96
TOP_SPEED = 0.12  # [m/s] "our robots' fastest speed", Sacks 2001, 3.3
READING = 1.0 / 3.0  # [s] between two readings, Sacks 2001, 3.2
HALF_WAY = -0.5 * TOP_SPEED  # [m/s] a radial velocity below this counts as an approach
SETTLE = 1.5  # [s] until filter and velocity have forgotten the beginning
LOOK = 0.5  # [s] during which the head is turned to the ball; then it tracks by itself
INTERVALS = (0.08, 0.17, 0.33, 0.67)  # [s] of the claim
PIXEL_JUMP = 0.05  # [m] "even a difference of 5 cm between successive readings", Sacks 2001, 3.3
PLACE, AROUND = 0.60, 0.05  # [m] from the camera, where single readings are judged
READINGS = 9
ACROSS, PASSES = (0.2, 0.5), 2.0  # [m/s] of a ball that rolls past, [s] watched: S73
NEAREST = 0.15  # [m] from the camera, nearest ball of a stuck robot: nearer ones lie between the paws
LONG, SHORT = 1.10, 0.70  # [m] from the camera, starts of walks: S18
WALK = 0.25  # [m] half of a walk with its start: standing robots are at the mean distance of walking ones


def true_radial(match: Match, r: int = 0) -> np.ndarray:
    """Return the true rate of change of the distance between robot r and the ball (M,) [m/s]."""
    robot, ball = match.robots[:, r], match.balls
    x, y = ball["x"] - robot["x"], ball["y"] - robot["y"]
    away = np.maximum(np.hypot(x, y), 1e-9)
    return np.asarray((x * (ball["vx"] - robot["vx"]) + y * (ball["vy"] - robot["vy"])) / away)


def walk_to_ball(
    batch: Batch, start: np.ndarray, seconds: float, stuck: bool, pace: float = 1.0, **settings: Any
) -> Samples:
    """Let robots walk to a still ball `start` (M,) [m] from the camera; return radial velocities and ranges (M, T).

    "radial": believed, "rate": true [m/s]. Stuck robots step and count odometry, but stay: no traction. Pace 0: stand.
    """
    rng, count, league = batch.rng(), len(start), find_league(LEGGED)
    if stuck:
        league = replace(league, drive=replace(league.drive, traction=1e-9, thrust=1e-9))
    pose = rng.uniform(-0.9, -0.7, count), rng.uniform(-0.5, 0.5, count), 0.0
    forward = 0.0 if stuck else pace * TOP_SPEED
    match = staging.stage_ball(batch, *pose, CAMERA_AHEAD + start, 0.0, forward=forward, league=league, **settings)
    actions = staging.still_actions(match)
    actions[:, 0, 0] = pace

    def steer(step: int) -> None:
        actions[:, 0, 4] = -1.0
        if (step + 1) * match.league.dt <= LOOK:
            stare_at_ball(match, actions)

    return staging.record(match, staging.watch(match, seconds, actions, SETTLE, steer),
                  lambda: {"radial": match.beliefs["ball"]["radial"][:, 0].copy(), "rate": true_radial(match),
                           "range": range_from_camera(match)})  # fmt: skip


def sweep_intervals(batch: Batch) -> Samples:
    """Return errors (M, T) [m/s] of the radial velocity for each reading interval, of walking and standing robots."""
    rng = batch.rng(1)
    walking, standing = (rng.uniform(SHORT - less, LONG - less, MATCHES) for less in (0.0, WALK))
    samples = {}
    for name, start, pace in (("walking", walking, 1.0), ("standing", standing, 0.0)):
        for interval in INTERVALS:
            memory = {"velocity_interval": interval}
            seen = walk_to_ball(batch, start, 1.5, stuck=False, pace=pace, memory=memory)
            samples[f"{name} {interval}"] = seen["radial"] - seen["rate"]
    return samples


def interval_errors(samples: Samples, how: str) -> list[float]:
    """Return the rms error [cm/s] of the radial velocity for each interval; `how`: "walking" or "standing"."""
    return [100 * rms(samples[f"{how} {interval}"]) for interval in INTERVALS]


def count_misjudged_readings(batch: Batch, **settings: Any) -> Samples:
    """Count velocity readings of stuck and walking robots about 60 cm from the ball, and readings that misjudge."""
    shifts = batch.rng(1).uniform(-AROUND, AROUND, MATCHES)
    free = walk_to_ball(batch, PLACE + TOP_SPEED * (SETTLE + 0.5) + shifts, 1.0, stuck=False, **settings)
    stuck = walk_to_ball(batch, PLACE + shifts, 1.0, stuck=True, **settings)
    near = np.abs(free["range"] - PLACE) <= AROUND
    wrong = (near & (free["radial"] >= HALF_WAY)).sum(axis=1) + (stuck["radial"] < HALF_WAY).sum(axis=1)
    return {"wrong": wrong, "judged": near.sum(axis=1) + stuck["radial"].shape[1]}


def mean_readings(batch: Batch) -> Samples:
    """Return means of the first 1 to 9 readings (M, 9) [m/s], of robots walking in from 60 cm and of stuck robots."""
    dt, seconds = find_league(LEGGED).dt, READINGS * READING
    times = SETTLE + dt * np.arange(1, round(seconds / dt) + 1)
    period = np.floor(times / READING + 1e-6)
    last = np.flatnonzero(np.diff(period, append=period[-1] + 1))[:READINGS]  # the last frame of each reading
    start = np.full(MATCHES, PLACE + TOP_SPEED * (SETTLE - 0.5 * READING))  # about 60 cm at the first reading
    free = walk_to_ball(batch, start, seconds, stuck=False)["radial"]
    stuck = walk_to_ball(batch, batch.rng(1).uniform(NEAREST, PLACE, MATCHES), seconds, stuck=True)["radial"]
    counts = np.arange(1, len(last) + 1)
    means = {name: np.cumsum(x[:, last], axis=1) / counts for name, x in (("free", free), ("stuck", stuck))}
    wrong = (means["free"] >= HALF_WAY).astype(float) + (means["stuck"] < HALF_WAY)
    return {**means, "wrong": wrong, "wrong at last": wrong[:, -1], "judged": np.full(MATCHES, 2.0)}


S18 = claim(
    "S18", "3.2", "Velocities read more often than every 1/3 s show sensor errors more than movement.",
    f"{MATCHES} robots a batch walk at {100 * TOP_SPEED:.0f} cm/s to a still ball 90 to 40 cm from the camera, "
    "and as many stand so far from one; error of the believed radial velocity (filtered positions) for four intervals "
    f"between readings ({', '.join(f'{interval:g}' for interval in INTERVALS)} s), same seeds.",
    measured("walking: least fall of the rms error from interval to interval",
             lambda s: least_fall(interval_errors(s, "walking")), unit="cm/s", above=0.0),
    measured("standing: the same", lambda s: least_fall(interval_errors(s, "standing")), unit="cm/s", above=0.0),
    measure=sweep_intervals,
    figures=plot("Error of the radial velocity", "interval between readings [s]", "rms error [cm/s]", INTERVALS,
                 {how: partial(interval_errors, how=how) for how in ("walking", "standing")}, rules=(100 * TOP_SPEED,)),
    seconds=3.0,
    ingredients=("sensors.dither", "memory.averaged = 4", "16 frames a second"),
    note="Positions are means of four frames: those of readings less than 1/4 s apart share frames, and with them a "
    "part of their error.",
)  # fmt: skip

S20 = claim(
    "S20", "3.3", "Readings 1/3 s apart that differ by 5 cm exceed the top speed of 12 cm/s.",
    f"Arithmetic; and {MATCHES} robots a batch that walk to the ball, as many that are stuck, both with the "
    f"ball {100 * (PLACE - AROUND):.0f} to {100 * (PLACE + AROUND):.0f} cm from the camera: a single reading is wrong "
    "if it lies on the wrong side of half the top speed.",
    exact("5 cm in 1/3 s over the top speed", lambda samples: PIXEL_JUMP / READING / TOP_SPEED, above=1.0),
    counted("single readings at 60 cm that misjudge", "wrong", "judged", at_least=10.0),
    measure=count_misjudged_readings, batches=32, seconds=0.8,
    without=Ablation("sensors.dither = 0: blobs without flicker",
                     lambda b: count_misjudged_readings(b, sensors={"dither": 0.0})),
    ingredients=("the identity 5 cm / (1/3 s) = 15 cm/s", "sensors.dither"),
)  # fmt: skip

S21 = claim(
    "S21", "3.3", "Averaged over several readings the velocity tells accurately enough whether a robot is stuck.",
    f"{MATCHES} robots a batch walk in from {100 * PLACE:.0f} cm, as many are stuck {100 * NEAREST:.0f} to "
    f"{100 * PLACE:.0f} cm from the ball, counted from the camera; the mean of the first 1 to {READINGS} readings "
    "against half the top speed.",
    counted(f"wrong after {READINGS} readings", "wrong at last", "judged", at_most=5.0),
    measure=mean_readings,
    figures=plot("Judging whether a robot is stuck", "readings averaged", "judged wrongly [%]", range(1, READINGS + 1),
                 {"stuck or walking, from 60 cm on": lambda s: list(50.0 * s["wrong"].mean(axis=0))}, rules=(5.0,)),
    batches=32, seconds=0.7,
    ingredients=("sensors.dither", "memory.velocity_interval = 1/3 s"),
)  # fmt: skip


def compare_bearings(batch: Batch) -> Samples:
    """Return errors (M, T) [degrees/s] of angular velocities from raw and from filtered bearings of a ball that passes.

    Both are differences over READING; the truth is the rate at the later of the two bearings.
    """
    rng = batch.rng()
    match = staging.stage(batch, matches=MATCHES, actions="full", sensors={"patches": 0.0})
    side = rng.choice([-1.0, 1.0], MATCHES)
    staging.put(match, 0, -0.8, 0.0)
    staging.put_ball(match, rng.uniform(-0.2, 0.2, MATCHES), -0.5 * side, 0.0, side * rng.uniform(*ACROSS, MATCHES))
    staging.begin_scene(match, placed=True)

    def read() -> Samples:
        ball = match.beliefs["ball"][:, 0]
        true, raw, filtered = staging.distance_to_ball(match)[1], ball["bearing"], ball["filtered_bearing"]
        return {"true": np.degrees(true), "raw": np.degrees(raw), "filtered": np.degrees(filtered)}

    bearings, rate = staging.record(match, stare_for(match, LOOK, PASSES), read), match.league.control_rate
    back = round(READING * rate)
    now = np.diff(bearings["true"], axis=1)[:, back - 1 :] * rate
    return {name: (one[:, back:] - one[:, :-back]) * rate / back - now for name, one in bearings.items()}


S73 = claim(
    "S73", "3.2, footnote 4", "Unfiltered data gives a more current angular velocity than filtered data.",
    f"{MATCHES} robots a batch stare at a ball that rolls past at {100 * ACROSS[0]:.0f} to "
    f"{100 * ACROSS[1]:.0f} cm/s, about 80 cm away: difference of bearings over 1/3 s against the present rate. The "
    "filter's delay follows from its length, so nothing is judged.",
    reported("error, raw bearings", "raw", of=rms, unit="deg/s"),
    reported("error, filtered bearings", "filtered", of=rms, unit="deg/s"),
    reported("error of true bearings: the delay of 1/3 s alone", "true", of=rms, unit="deg/s"),
    measure=compare_bearings, batches=2, seconds=1.0,
    ingredients=("memory.filter_length",),
)  # fmt: skip
