"""The memory of an unseen ball, and the robot's own motion.  [Sacks 2001, 3.1.1, fn 2]"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import Ablation, Batch, claim, compare
from soccer_env.train.papers.plots import plot
from soccer_env.train.papers.true_sight import blind_cameras, look_first, stare_at_ball
from soccer_env.train.papers.values import bin_masks, least_rise, median, middles_of, ratio
from soccer_env.train.papers.verdicts import Samples, measured, reported

MATCHES = 96
SEEN = 1.0  # [s] for which the ball is seen first
WAY = 1.0  # [m] walked without sight of it, S12
SPEED = 0.12  # [m/s] at full command
TURN = 0.8  # [rad/s] at full command
VARIANTS = ("full", "rotation", "none")
TIMES = (1.0, 2.0, 3.0)  # [s] without sight, S13
FASTEST = 0.8  # [m/s] of the ball, S13
BINS = (0.0, 0.05, 0.15, 0.30, 0.50, 1.00)  # [m] edges of the ball's own way, S13
POCKET = 0.147  # [m] a ball at the chest: body.front and its radius
DRIBBLE, PUSHED = 0.07, 5.0  # [m/s] 3.5 cm per half-second step, [s]: S14


def ball_errors(match: Match) -> Samples:
    """Return the errors of the believed ball (M,): of its place and range [m], and of its bearing [degrees]."""
    (true, bearing), ball = staging.distance_to_ball(match), match.beliefs["ball"][:, 0]
    x = ball["distance"] * np.cos(ball["bearing"]) - true * np.cos(bearing)
    y = ball["distance"] * np.sin(ball["bearing"]) - true * np.sin(bearing)
    off = np.degrees(np.abs(staging.wrap_angle(ball["bearing"] - bearing)))
    return {"place": np.hypot(x, y), "range": np.abs(ball["distance"] - true), "bearing": off}


def look_at_ball(batch: Batch, **memory: Any) -> Match:
    """Set up matches whose robots have watched a still ball beside their path for SEEN [s]."""
    rng = batch.rng()
    pose = rng.uniform(-0.9, -0.6, MATCHES), rng.uniform(-0.1, 0.1, MATCHES), rng.uniform(-0.2, 0.2, MATCHES)
    side, distance = rng.choice([-1.0, 1.0], MATCHES), rng.uniform(0.5, 0.9, MATCHES)
    bearing = side * rng.uniform(0.6, 1.2, MATCHES)
    match = staging.stage_ball(batch, *pose, distance, bearing, league=staging.OPEN_FLOOR, memory=memory)
    look_first(match, SEEN)
    return match


def walk_blind(batch: Batch, odometry: str) -> Iterator[Match]:
    """Walk 1 m blind, on an arc of up to 90 degrees away from the ball; yield the matches after every step."""
    match = look_at_ball(batch, odometry=odometry)
    blind_cameras(match)
    seconds, actions = WAY / SPEED, staging.still_actions(match)
    away = -np.sign(staging.distance_to_ball(match)[1])
    actions[:, 0, 0] = 1.0
    actions[:, 0, 2] = away * batch.rng(1).uniform(0.0, 0.5 * np.pi, MATCHES) / seconds / TURN
    yield from (match for _ in staging.play(match, seconds, actions))
    match.close()


def roll_balls(batch: Batch, seen: bool) -> Samples:
    """Let balls roll while the robot walks; return how far each ball rolled and the error of its belief (M, T) [m]."""
    rng = batch.rng(1)
    match = look_at_ball(batch)
    if not seen:
        blind_cameras(match)
    speed, course = rng.uniform(0.0, FASTEST, MATCHES), rng.uniform(-np.pi, np.pi, MATCHES)
    speed[: MATCHES // 6] = 0.0
    x, y = match.balls["x"].copy(), match.balls["y"].copy()
    staging.put_ball(match, x, y, speed * np.cos(course), speed * np.sin(course))
    actions = staging.still_actions(match)
    actions[:, 0, 0] = 1.0
    ways, errors = [], []
    for before, time in zip((0.0, *TIMES), TIMES, strict=False):
        for _ in staging.play(match, time - before, actions):
            if seen:
                stare_at_ball(match, actions)
        ways.append(np.hypot(match.balls["x"] - x, match.balls["y"] - y))
        errors.append(ball_errors(match)["place"])
    match.close()
    return {"way": np.stack(ways, axis=1), "error": np.stack(errors, axis=1)}


def error_by_roll_distance(samples: Samples) -> list[float]:
    """Return the median error [cm] of the believed ball in each bin of the distance that the ball rolled."""
    return [100 * median(samples["error"][there]) for there in bin_masks(samples["way"], BINS)]


def dribble_unseen_ball(batch: Batch, update: bool, turn: float) -> np.ndarray:
    """Dribble an unseen ball with turn action `turn` in [-1, 1]; return the error of its remembered place (M,) [m]."""
    rng = batch.rng()
    pose = rng.uniform(-0.9, -0.7, MATCHES), rng.uniform(-0.3, 0.3, MATCHES), rng.uniform(-0.3, 0.3, MATCHES)
    match = staging.stage_ball(batch, *pose, np.full(MATCHES, POCKET), 0.0, memory={"odometry_while_dribbling": update})
    look_first(match, SEEN)
    blind_cameras(match)
    actions = staging.still_actions(match)
    actions[:, 0, 0], actions[:, 0, 2] = DRIBBLE / SPEED, turn
    for _ in staging.play(match, PUSHED, actions):
        pass
    match.close()
    return ball_errors(match)["place"]


def compare_dribbling(batch: Batch, turn: float = 0.0) -> Samples:
    """Return the errors of `dribble_unseen_ball` without and with an update of the ball memory by odometry."""
    return {"off": dribble_unseen_ball(batch, False, turn), "on": dribble_unseen_ball(batch, True, turn)}


S12 = claim(
    "S12", "3.1.1", "Full odometry, not rotation alone, keeps the remembered ball accurate while the robot moves.",
    f"{MATCHES} robots a batch see a still ball 50 to 90 cm away for {SEEN:g} s, then see it no more and walk "
    f"{WAY:g} m on an arc of 0 to 90 degrees; error of the believed place at the end, same seeds for each memory.",
    measured("full update: median error of the place", "place full", of=median, unit="cm", at_most=15.0),
    measured("full update: median error of the bearing", "bearing full", of=median, unit="deg", at_most=10.0),
    measured("rotation only: error over that of the full update", ratio, "place rotation", "place full", median,
             at_least=3.0),
    reported("no update: median error of the place", "place none", of=median, unit="cm"),

    measure=lambda batch: compare(dict(zip(VARIANTS, VARIANTS, strict=True)),
                                  lambda memory: ball_errors([*walk_blind(batch, memory)][-1])),
    seconds=1.5,
    ingredients=("sensors.odometry_noise", "drive.slip", "memory.odometry"),
)  # fmt: skip

S13 = claim(
    "S13", "3.1.1", "The remembered ball stays accurate only if the ball itself does not move.",
    f"As S12, but the unseen ball rolls off at 0 to {FASTEST:g} m/s in any direction; error after "
    f"{', '.join(f'{time:g}' for time in TIMES)} s against the way that the ball has made.",
    measured("least rise of the median error with the ball's way",
             lambda samples: least_rise(error_by_roll_distance(samples)), unit="cm", above=0.0),
    measure=lambda batch: roll_balls(batch, seen=False),
    figures=plot("Memory of a ball that moved unseen", "way of the ball [cm]", "error of the place [cm]",
                 middles_of(BINS, 100), {"median": error_by_roll_distance}),
    batches=64, seconds=0.5,
    without=Ablation("a memory that leaves an unseen ball where it was: here it stays in sight",
                     lambda batch: roll_balls(batch, seen=True)),
    ingredients=("memory.odometry = full",),
)  # fmt: skip

S14 = claim(
    "S14", "footnote 2", "The ball's relative position need not be updated while the robot dribbles it.",
    f"{MATCHES} robots a batch push a ball that they no longer see for {PUSHED:g} s at {100 * DRIBBLE:.0f} "
    "cm/s; error of the believed place at the end with the update and without, same seeds, lost balls included.",
    measured("median error without the update over that with it", ratio, "off", "on", median, at_most=0.5),
    measure=compare_dribbling, seconds=0.8,
    without=Ablation(f"a ball that stays between the paws: here they turn at {TURN:g} rad/s, and most balls are lost",
                     lambda batch: compare_dribbling(batch, turn=1.0)),
    ingredients=("memory.dribbling_distance", "contact of ball and paws"),
)  # fmt: skip
