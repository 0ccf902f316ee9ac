"""The time T of a plan, and the passes until it agrees with the time of the path.  [H. 2006, 3]"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import NO_MATCH, Ablation, Batch, claim
from soccer_env.train.papers.claims.planning.crossings import ASSUMED, LOOKED_AT
from soccer_env.train.papers.claims.planning.runs import CANONICAL, PLANNED, plan, plans_of
from soccer_env.train.papers.values import mean, median
from soccer_env.train.papers.verdicts import Samples, exact, measured, reported

KINDS: dict[str, dict[str, Any]] = {"smooth": {}, "literal": {"literal": True}}


def measure_plan_times(batch: Batch, slower: float = 1.0) -> Samples:
    """Return T over T_min (M,), passes, convergence and collisions of plans; `slower` multiplies T_min."""
    samples: Samples = {}
    for name, changes in KINDS.items():
        plans = plans_of(batch, **changes)
        samples[f"{name} ratio"] = np.array([one.time / (slower * one.least_time) for one in plans])
        samples[f"{name} passes"] = np.array([one.iterations for one in plans], float)
        samples[f"{name} open"] = np.array([not one.converged for one in plans], float)
        samples[f"{name} into"] = np.array([one.clearance() < 0.0 for one in plans], float)
    return samples


H12 = claim(
    "H12", "3", "The straight line's time at full speed always underestimates the path's time.",
    f"{PLANNED}; time of the path over the time of the straight line.",
    exact("smallest ratio", lambda s: float(s["smooth ratio"].min()), at_least=1.0 - 1e-9),
    reported("mean ratio", "smooth ratio"),
    rules=NO_MATCH, measure=measure_plan_times, batches=2, seconds=0.8,
    without=Ablation("one speed for both: here the straight line is timed at 0.9 of it",
                     partial(measure_plan_times, slower=1 / 0.9)),
    note="No path is shorter than the straight line, and both are timed at the same speed.",
)  # fmt: skip

H13 = claim(
    "H13", "3", "The iterative planning needs very few iterations to converge to a reasonable path.",
    f"{PLANNED}; passes over the grid until the times agree to 0.1 s, at most eight.",
    measured("passes (median)", "smooth passes", of=median, at_most=2.0),
    measured("plans that do not converge", "smooth open", unit="%", at_most=10.0),
    reported("plans that run into the obstacle", "smooth into", unit="%"),
    reported("they alone: plans that do so", "literal into", unit="%"),
    reported("plans of one pass", lambda s: 100 * mean(s["smooth passes"] == 1), unit="%"),
    reported("the paper's words alone: passes (median)", "literal passes", of=median),
    reported("they alone: plans that do not converge", "literal open", unit="%"),
    rules=NO_MATCH, measure=measure_plan_times, condition="with damping and smoothing, not as written", batches=4,
    seconds=0.8,
    ingredients=("T of the smoothed path, damped by half: the paper speaks of neither",),
    note=f"{LOOKED_AT} Taken at its word, T is that of the way of cells, which is longer than the path that is driven, "
    "and swings where an obstacle is met head on.",
)  # fmt: skip


def first_plans(batch: Batch, chosen: bool = True) -> Samples:
    """Return passes and error of T [s] of first plans: of both canonical crossings (2,), or of random ones (M,)."""
    plans = [plan(scene) for scene in CANONICAL.values()] if chosen else plans_of(batch)
    return {
        "passes": np.array([one.iterations for one in plans], float),
        "error": np.array([abs(one.times[0] - one.guesses[0]) for one in plans]),
    }


H14 = claim(
    "H14", "3, figure 2", "For the figure's path one iteration estimated the time to less than 100 ms.",
    f"The first plans of both canonical crossings, equal for every seed. Without their choice: {PLANNED}.",
    exact("most passes", "passes", of=np.max, at_most=1.0),
    exact("greatest error of T after the first", "error", of=np.max, unit="s", below=0.1),
    reported("planned in one pass", lambda s: 100 * mean(s["passes"] == 1), unit="%"),
    rules=NO_MATCH, measure=first_plans, batches=1, seconds=0.1,
    without=Ablation("the choice of both scenes, by a sketch of the planner: here random ones",
                     partial(first_plans, chosen=False)),
    ingredients=ASSUMED,
    note=LOOKED_AT,
)  # fmt: skip
