"""How a robot notices that it is stuck: the ball does not come nearer.  [Sacks 2001, 3, 3.3]"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import PLAYED, Batch, Curve, Figure, claim
from soccer_env.train.papers.claims.stuck.runs import immobilise_robots, is_recovering, set_up_walk
from soccer_env.train.papers.claims.stuck.sampled import BASE, MATCHES, SECONDS, MotionWindow, distance_from_camera
from soccer_env.train.papers.staging import distance_to_ball, kick_off, play
from soccer_env.train.papers.values import known, median, middles_of
from soccer_env.train.papers.verdicts import Samples, measured, reported

HELD = 64  # robots a batch that are held
WALK = 1.5  # [s] of free walk before
WAIT = 12.0  # [s] for a held robot to notice
NEAREST = 0.2  # [m] of the ball, assumed, like the farthest
NEAR = 0.35  # [m] 3.3
FARTHEST = 0.8  # [m]
WINDOW = 2.5  # [s] over which the velocity is averaged, assumed


def latencies(batch: Batch, **settings: Any) -> tuple[np.ndarray, np.ndarray]:
    """Hold robots on their path to a still ball; return the ball's distance [m] and the time to notice [s], (M,).

    The distance is from the camera. inf: not within WAIT; NaN: noticed before the hold.
    """
    match = set_up_walk(batch, HELD, NEAREST + 0.1, FARTHEST + 0.1, **settings)
    for _ in play(match, WALK):
        pass
    immobilise_robots(match)
    distance = distance_from_camera(match, *distance_to_ball(match))
    after, began = np.full(HELD, np.inf), is_recovering(match)
    for step in play(match, WAIT):
        after[is_recovering(match) & np.isinf(after)] = (step + 1) * match.league.dt
    match.close()
    after[began] = np.nan
    return distance, after


def velocity_windows(batch: Batch) -> Samples:
    """Return mean radial velocities [m/s] of free robots and of held robots in time windows of play (M, K).

    Windows do not overlap; NaN: no further window in the match.
    """
    match = kick_off(batch, matches=MATCHES, team=BASE)
    watch = MotionWindow(match, WINDOW)
    radial: list[np.ndarray] = []
    found: dict[str, list[np.ndarray]] = {"free": [], "stuck": []}
    for _ in play(match, SECONDS):
        watch.look()
        radial.append(match.beliefs["ball"]["radial"].copy())
        if len(radial) < watch.size:
            continue
        x, y = match.balls["x"][:, None] - match.robots["x"], match.balls["y"][:, None] - match.robots["y"]
        near = distance_from_camera(match, np.hypot(x, y), np.arctan2(y, x) - match.robots["heading"]) <= FARTHEST
        free = (watch.mean(4) == 1.0) & (watch.mean(3) == 0.0)
        for name, there in (("free", free & near), ("stuck", watch.held() & near)):
            found[name].append(np.where(there, np.mean(radial, axis=0), np.nan))
        radial.clear()
    match.close()
    return {name: np.concatenate(values, axis=1) for name, values in found.items()}


def roc_area(samples: Samples) -> float:
    """Return the area under the ROC curve: the probability that a stuck robot reads more than a free robot."""
    free, stuck = known(samples["free"]), known(samples["stuck"])
    if len(stuck) == 0:
        return float("nan")
    ranks = np.argsort(np.argsort(np.concatenate([free, stuck]))) + 1
    count = len(stuck)
    return float((ranks[len(free) :].sum() - count * (count + 1) / 2) / (count * len(free)))


def velocity_figure(samples: Samples) -> Sequence[Figure]:
    """Plot the distributions of the mean radial velocity of free robots and of held robots."""
    edges = np.linspace(-0.2, 0.1, 25)
    curves = []
    for name, title in (("free", "walks freely"), ("stuck", "held")):
        counts, _ = np.histogram(known(samples[name]), edges)
        curves.append(Curve(title, middles_of(edges, 100), (100.0 * counts / max(len(samples[name]), 1)).tolist()))
    return (Figure(f"Radial velocity over {WINDOW:g} s", "mean radial velocity [cm/s]", "robots [%]", tuple(curves)),)


S04 = claim(
    "S04", "3", "A robot that makes for the ball but comes no nearer is probably stuck.",
    f"{MATCHES} matches a batch of 3 v 3, {SECONDS:g} s each, in which nobody recovers; windows of {WINDOW:g} s "
    f"of robots that go for a ball nearer than {100 * FARTHEST:.0f} cm: mean of the filtered radial velocity of those "
    "that others hold (contact, a quarter of the way that their legs walk or less) and of those that touch nobody.",
    measured("area under the ROC curve of the mean velocity", roc_area, at_least=0.9),
    reported("median of free robots", "free", of=median, unit="cm/s"),
    reported("median of held robots", "stuck", of=median, unit="cm/s"),
    rules=PLAYED, measure=velocity_windows, figures=velocity_figure, least=4, batches=12, seconds=2.0,
    ingredients=("sensors.dither", "memory.filter_length"),
)  # fmt: skip
