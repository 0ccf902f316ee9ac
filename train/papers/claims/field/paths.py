"""Paths through the potential field: steadiness, retreat, indecision.  [Sacks 2001, 4.3.1, 4.3.3]"""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import NO_MATCH, Ablation, Batch, Figure, claim
from soccer_env.train.papers.claims.field import points
from soccer_env.train.papers.claims.field.point_world import players
from soccer_env.train.papers.claims.field.points import BLOBS, NO_CUT_OFF, NOISE, ROBOTS, SCENES
from soccer_env.train.papers.plots import plot_shares
from soccer_env.train.papers.values import mean, reduction
from soccer_env.train.papers.verdicts import Samples, measured, reported

NOISY = {"range_noise": NOISE, "false_blobs": BLOBS}
JITTERS = {"noise and blobs": NOISY, "noise": {"range_noise": NOISE}, "blobs": {"false_blobs": BLOBS}}
CUT_OFFS: dict[str, dict[str, Any]] = {"with": {}, "without": NO_CUT_OFF, "unmatched": {"cut_off": False}}
GAP = (0.45, 0.55)  # [m] about 500 mm
HARD_GAPS = (0.35, 0.70)  # [m] of a harder set
BOUNCES = 2  # changes of side of a run that bounces "back and forth between moving left and right"


def compare_cut_off(batch: Batch) -> Samples:
    """Return the rms change of direction [degrees] (M,) between steps, with the forces' cut-off and without it.

    "unmatched": without the cut-off and with an unchanged k2, so that all forces are stronger as well.
    """
    rng, samples = batch.rng(), {}
    start = points.starts(rng, SCENES, 0.3)
    x = rng.uniform(-0.4, 1.2, (SCENES, 3))
    y = rng.uniform(0.3, 0.9, (SCENES, 3)) * rng.choice([-1.0, 1.0], (SCENES, 3))
    crowd = players(np.stack([x, y], axis=-1))
    for seen, world in JITTERS.items():
        for name, play in CUT_OFFS.items():
            runs = points.run_points(batch.rng(1), start, crowd, world, **play)
            samples[f"{seen} {name}"] = np.degrees(np.sqrt(np.nanmean(runs.turns**2, axis=0)))
    return samples


S45 = claim(
    "S45", "4.3.1", "A greatest distance keeps false blobs and distant players from disturbing the path.",
    f"{SCENES} points a batch among three players that stand 30 to 90 cm beside the way, ranges with an error "
    f"of {100 * NOISE:.0f} %, a false blob in {100 * BLOBS:.0f} % of the decisions; rms change of direction from step "
    "to step with the cut-off at 1 m and without, k2 then such that a force is 1 at the same distance as with it.",
    measured("jitter is less by (means)", reduction, "noise and blobs with", "noise and blobs without", unit="%",
             above=0.0),
    reported("less by, noise alone", reduction, "noise with", "noise without", unit="%"),
    reported("less by, false blobs alone", reduction, "blobs with", "blobs without", unit="%"),
    reported("less by, against the same k2 without the cut-off", reduction, "noise and blobs with",
             "noise and blobs unmatched", unit="%"),
    rules=NO_MATCH, measure=compare_cut_off, batches=8, seconds=0.8,
    ingredients=("how often blobs are false, and where they seem to be: 0.5 to 2.5 m",),
)  # fmt: skip


def steps_away(batch: Batch, **play: Any) -> Samples:
    """Count each run's steps and its steps away from the goal, and tell which runs arrive (M,)."""
    rng = batch.rng()
    place = np.stack([rng.uniform(-0.7, 1.0, (SCENES, 3)), rng.uniform(-0.5, 0.5, (SCENES, 3))], axis=-1)
    place[np.arange(SCENES)[:, None] % 3 < np.arange(3)] = 0.0, 50.0  # far off the field: one to three players remain
    start = points.starts(rng, SCENES, 0.5)
    runs = points.run_points(batch.rng(1), start, players(place), {"range_noise": NOISE}, **play)
    return {"steps": runs.steps, "away": runs.retreats, "arrived": runs.arrived.astype(float)}


S55 = claim(
    "S55", "4.3.3", "Within 70 degrees of the goal's direction the robot never goes away from it.",
    f"{SCENES} points a batch past one to three standing players anywhere on their way, ranges with an error of "
    f"{100 * NOISE:.0f} %; steps after which the goal is farther away.",
    measured("steps away from the goal", lambda s: float(s["away"].sum()), at_most=0.0),
    rules=NO_MATCH, measure=steps_away, batches=8, seconds=0.3,
    without=Ablation("the limit of 70 degrees: a step at a smaller angle shortens the way",
                     partial(steps_away, clamp=False)),
    note="Geometry, as long as the robot goes where it wants to: 3.5 cm at 70 degrees bring the goal 1.2 cm nearer.",
)  # fmt: skip


def compare_gaps(batch: Batch) -> Samples:
    """Count changes of side (M,) before a gap of about 50 cm, by the limit alone and with the rule that keeps sides."""
    rng, samples = batch.rng(), {}
    start = points.starts(rng)
    crowd = points.gap_ahead(rng, *GAP, askew=0.0)
    askew = points.gap_ahead(rng, *GAP)
    hard_start, hard_crowd = points.starts(rng, SCENES, 0.2), gap_with_third_player(rng)
    for name, keep in (("limit", False), ("rule", True)):
        for seen, world in (("", {}), (" noisy", {"range_noise": NOISE})):
            runs = points.run_points(batch.rng(1), start, crowd, world, keep_side=keep)
            samples[name + seen] = runs.flips.astype(float)
            runs = points.run_points(batch.rng(1), start, askew, world, keep_side=keep)
            samples[f"{name}{seen} askew"] = runs.flips.astype(float)
        runs = points.run_points(batch.rng(1), hard_start, hard_crowd, {"range_noise": NOISE}, keep_side=keep)
        samples[f"{name} hard"] = runs.flips.astype(float)
    return samples


def compare_gaps_with_robots(batch: Batch) -> Samples:
    """Return samples of `compare_gaps`, and robots' changes of side in the first scenes, with the rule and without."""
    rng = batch.rng()
    start, crowd = points.starts(rng), points.gap_ahead(rng, *GAP, askew=0.0)
    samples = compare_gaps(batch)
    for name, keep in (("limit", False), ("rule", True)):
        robots = points.run_robots(batch, start, crowd, keep_side=keep)
        samples[f"robots {name}"] = points.pad_with_nan(robots.flips)
        samples[f"clean {name}"] = points.pad_with_nan(robots.is_clean)
    return samples


def side_change_ratio(samples: Samples, seen: str) -> float:
    """Return how many times more often paths change sides of a player without the rule to keep a side than with it."""
    return mean(samples[f"limit {seen}"]) / max(mean(samples[f"rule {seen}"]), 1e-3)


def side_change_share(samples: Samples, name: str, least: int = 1) -> float:
    """Return the share of runs [%] with at least `least` changes of side."""
    flips = samples[name]
    return 100.0 * mean(np.where(np.isfinite(flips), flips >= least, np.nan))


def cured_share(samples: Samples, without: str, with_rule: str) -> float:
    """Return the share [%] of the runs that bounce back and forth that the rule takes away."""
    left, all_ = (side_change_share(samples, name, BOUNCES) for name in (with_rule, without))
    return 100.0 - 100.0 * left / max(all_, 1e-3)


def gap_with_third_player(rng: np.random.Generator) -> np.ndarray:
    """Return three standing players (M, 3): two with a gap of 35 to 70 cm, and a third before or behind the gap."""
    gap = points.gap_ahead(rng, *HARD_GAPS)
    third = np.stack([gap["x"].mean(axis=1) + rng.uniform(-0.4, 0.4, SCENES), rng.uniform(-0.4, 0.4, SCENES)], axis=-1)
    return players(np.concatenate([np.stack([gap["x"], gap["y"]], axis=-1), third[:, None]], axis=1))


def gap_figures(samples: Samples) -> Sequence[Figure]:
    """Plot paths before a gap, and the distribution of the number of changes of side."""
    plays: dict[str, dict[str, Any]] = {
        "no limit": {"clamp": False}, "70 degrees": {"keep_side": False}, "and the side kept": {},
    }  # fmt: skip
    changes = plot_shares(
        "Indecision before a gap of about 50 cm", "changes of side", "runs with as many or more [%]", range(41),
        {"limit alone": "limit", "limit, noise": "limit noisy", "side kept": "rule", "side kept, noise": "rule noisy"},
        np.greater_equal,
    )  # fmt: skip
    return (points.draw_field("Before a gap of 50 cm", [[0.0, 0.25], [0.0, -0.25]], plays, 0.01), *changes(samples))


S56 = claim(
    "S56", "4.3.3", "With the limit of 70 degrees alone the robot sometimes bounces left and right.",
    f"{SCENES} points a batch before two players with a gap of {100 * GAP[0]:.0f} to {100 * GAP[1]:.0f} cm "
    "between their middles, square to their way and within 5 cm of it, nothing but the 70 degrees limit; changes "
    "between more than 20 degrees left of the goal and as much right of it.",
    measured("changes of side in a run (mean)", "limit", at_least=10.0),
    reported("gap up to 20 degrees askew: in a run (mean)", "limit askew"),
    rules=NO_MATCH, measure=compare_gaps, figures=gap_figures, batches=8, seconds=0.8,
    note="About half of these runs bounce, and then 20 to 30 times; a robot that comes more to one side of the gap's "
    "middle passes both players there. In a gap that is askew it hardly ever bounces.",
)  # fmt: skip

S57 = claim(
    "S57", "4.3.3", "Keeping one's side when pushed back beyond 135 degrees mostly cures the indecision.",
    f"The runs of S56 with ranges that have an error of {100 * NOISE:.0f} %, with the rule and without; and a "
    f"harder set: gaps of {100 * HARD_GAPS[0]:.0f} to {100 * HARD_GAPS[1]:.0f} cm with a third player near them. "
    f"{ROBOTS} robots a batch do the same in the full simulator: the paper speaks of both. A case is a run that "
    f"changes sides {BOUNCES} times or more. The paper: \"this solved the problem of indecision in most cases, but not "
    "all the time\".",
    measured("points: cases of indecision that the rule cures", cured_share, "limit noisy", "rule noisy", unit="%",
             above=50.0),
    measured("robots: cases of indecision that the rule cures", cured_share, "robots limit", "robots rule",
             unit="%", above=50.0),
    measured("points that bounce with the rule", side_change_share, "rule noisy", BOUNCES, unit="%", above=5.0),
    reported("gap up to 20 degrees askew: without the rule over with it",
             side_change_ratio, "noisy askew"),
    reported("harder set: without the rule over with it", side_change_ratio, "hard"),
    measure=compare_gaps_with_robots, figures=gap_figures, batches=6, seconds=6.0,
)  # fmt: skip
