"""How steadily a robot sees the ball: averaging, bearing against range, the head, jumps.  [Sacks 2001, 3.1.1, fn 4]"""

from dataclasses import replace
from functools import partial

import numpy as np

from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import PLAYED, Ablation, Batch, claim, compare
from soccer_env.train.papers.claims.ball.range import CAMERA_AHEAD, RANGE_LABEL
from soccer_env.train.papers.plots import plot_bins
from soccer_env.train.papers.staging import OPEN_FLOOR
from soccer_env.train.papers.true_sight import ball_angle, ball_in_sight, follow_ball, look_first
from soccer_env.train.papers.values import bin_masks, ratio, rms, subtract_row_mean
from soccer_env.train.papers.verdicts import Samples, counted, exact, measured, reported
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
    rng, league = batch.rng(), OPEN_FLOOR
    if radius is not None:
        league = replace(league, ball=replace(league.ball, radius=radius))
    pose = rng.uniform(-0.3, 0.3, MATCHES), rng.uniform(-0.2, 0.2, MATCHES), rng.choice([0.0, np.pi], MATCHES)
    place, aside = rng.uniform(NEAR, FAR, MATCHES), rng.uniform(-0.4, 0.4, MATCHES)
    match = staging.stage_ball(batch, *pose, CAMERA_AHEAD + place, aside, league=league)
    true, bearing = staging.distance_to_ball(match)
    look_first(match, SETTLE)
    frames = []
    draws = match.robots["noise"][:, 0, CAMERA]
    before = draws.copy()
    for step in staging.play(match, SECONDS):
        if (step + 1) % hold:
            draws[:] = before  # the next frame repeats the noise of this one
        before = draws.copy()
        ball = match.beliefs["ball"][:, 0]
        seen = ball["age"] < 0.5 * match.league.dt
        aside = true * staging.wrap_angle(ball["bearing"] - bearing)
        frames.append([np.where(seen, x, np.nan) for x in (ball["distance"], ball["filtered_distance"], aside)])
    match.close()
    raw, filtered, aside = (subtract_row_mean(np.stack(values, axis=1)) for values in zip(*frames, strict=True))
    span = np.full(MATCHES, averaging_time(batch))
    return {"range": place, "raw": raw, "filtered": filtered, "aside": aside, "span": span}


def averaging_time(batch: Batch) -> float:
    """Return the filter's averaging time [s]: from a jump of the ball until the estimate is within 10 % of the jump."""
    match = staging.stage_ball(batch, 0.0, 0.0, 0.0, np.array([0.5]), 0.0, sensors=STEADY)
    look_first(match, SETTLE)
    staging.put_ball(match, 0.5 + JUMP, 0.0)
    match.rebuild()
    places = [float(match.beliefs["ball"]["filtered_distance"][0, 0]) for _ in staging.play(match, SETTLE)]
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

# In play

GAMES, PLAYED_SECONDS = 32, 20.0  # [s] of 3 v 3: S10
SETTLED = 3.0  # [s] after the kick-off, until heads have found the ball
WATCHED, TIME = 48, 20.0  # matches with one robot that watches, [s]: S11
KEPT = 0.5  # [m] from the ball, S11
FARTHER = 0.5  # [m] in a frame, S11
RIGHT = 0.25  # [1] of the true distance within which a sighting is right
RULE_SETS = {"none": (False, False), "both": (True, True), "horizon": (True, False), "area": (False, True)}
MOVED = 0.2  # [m] a ball that moves farther in a frame was moved by the referee


def count_centred_frames(batch: Batch) -> Samples:
    """Count robots' frames (M,) of 3 v 3 play with the ball in sight, and those with the camera's axis on the ball."""
    match = staging.kick_off(batch, matches=GAMES, team="sacks-2001")
    on_ball, seen = np.zeros((2, GAMES))
    for _ in staging.watch(match, PLAYED_SECONDS, settle=SETTLED):
        for r in range(match.robots.shape[1]):
            fresh = match.beliefs["ball"][:, r]["age"] < 0.5 * match.league.dt
            tracking = fresh & (match.robots["active"][:, r] == 1)
            distance, angle = ball_in_sight(match, r)
            seen += tracking
            on_ball += tracking & (angle <= ball_angle(match, distance))
    match.close()
    return {"on ball": on_ball, "seen": seen}


def count_jumps(batch: Batch, rules: tuple[bool, bool]) -> Samples:
    """Let a robot, with the rules horizon and double_area on or off, follow the ball of three who play identically.

    Return counts (M,): "jumps" of the believed ball to a wrong distance, and frames with a "right" sighting.
    """
    senses, memory = {"home": "sensors", "away": "ideal"}, dict(zip(("horizon", "double_area"), rules, strict=True))
    match = staging.stage(batch, matches=WATCHED, home=1, away=3, opponents="chaser", senses=senses, memory=memory)
    match.reset(seeds=batch.seeds(WATCHED))
    (jumps, right), actions = np.zeros((2, WATCHED)), staging.still_actions(match)

    def look() -> tuple[np.ndarray, np.ndarray]:
        return match.beliefs["ball"]["distance"][:, 0].copy(), np.stack([match.balls["x"], match.balls["y"]])

    before, place_before = look()
    for step in staging.play(match, SETTLED + TIME, actions):
        actions[:, 0, :3] = follow_ball(match, KEPT)
        if (step + 1) * match.league.dt <= SETTLED:
            continue
        (now, place), age = look(), match.beliefs["ball"]["age"][:, 0]
        true, put_elsewhere = staging.distance_to_ball(match)[0], np.hypot(*(place - place_before)) > MOVED
        jumps += np.isfinite(age) & ~put_elsewhere & (now - before > FARTHER) & (np.abs(now - true) > FARTHER)
        right += (age < 0.5 * match.league.dt) & (np.abs(now - true) < RIGHT * true)
        before, place_before = now, place
    match.close()
    return {"jumps": jumps, "right": right}


def fewer_jumps(samples: Samples, name: str) -> float:
    """Return the reduction [%] of jumps by the rules `name`, relative to no rules."""
    without = samples["jumps none"].sum()
    return float(100 * (1.0 - samples[f"jumps {name}"].sum() / without)) if without else float("nan")


S10 = claim(
    "S10", "3.1.1", "While robots track the ball it is often at the image's centre.",
    f"{GAMES} matches a batch of 3 v 3, sacks-2001 on its sensors, {PLAYED_SECONDS:g} s each: frames in which a "
    "robot sees the ball and the camera's axis meets it.",
    counted("frames with the axis on the ball", "on ball", "seen", at_least=60.0),
    rules=PLAYED, measure=count_centred_frames, batches=32, seconds=2.5,
    ingredients=("speeds of neck joints", "belief/legged/head.py"),
)  # fmt: skip

S11 = claim(
    "S11", "3.1.1", "Range jumps come from orange patches seen when the ball is lost; two rules fix them.",
    f"{WATCHED} matches a batch of {TIME:g} s in which a robot follows at 50 cm a ball that three opponents "
    "have, with orange patches round the field and on red stickers; jumps: over 50 cm farther in a frame, to a place "
    "more than 50 cm wrong; the same play with the two rules and without.",
    measured("fewer jumps with both rules", fewer_jumps, "both", unit="%", at_least=80.0),
    measured("frames with a right sighting lost by the rules",
             lambda s: float(100 * (1.0 - s["right both"].sum() / max(s["right none"].sum(), 1.0))), unit="%",
             at_most=5.0),
    reported("fewer jumps by the height test alone", fewer_jumps, "horizon", unit="%"),
    reported("fewer jumps by the area thresholds alone", fewer_jumps, "area", unit="%"),
    measure=lambda batch: compare(RULE_SETS, partial(count_jumps, batch)), batches=24, seconds=4.0,
    ingredients=("sensors.patches, patch_low, red_as_orange", "memory.horizon_angle, area_small, area_large"),
)  # fmt: skip
