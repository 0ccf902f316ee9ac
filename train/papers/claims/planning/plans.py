"""The cost, time T and passes of a plan; its methods: local gradients, search, backward planning.  [H. 2006, 2, 3]"""

from functools import partial
from time import process_time
from typing import Any

import numpy as np

from soccer_env.baselines.weigel_2001.planner import Plan, PlannerSettings
from soccer_env.baselines.weigel_2001.planner.planner import obstacle_records
from soccer_env.baselines.weigel_2001.planner.planning import plan_way
from soccer_env.baselines.weigel_2001.planner.records import PLAN, SCRATCH
from soccer_env.compiled import compiled
from soccer_env.train.papers.claim import NO_MATCH, PLAYED, Ablation, Batch, claim
from soccer_env.train.papers.claims.planning import runs
from soccer_env.train.papers.claims.planning.crossings import ASSUMED, LOOKED_AT
from soccer_env.train.papers.claims.planning.runs import CANONICAL, CROSSING, PLANNED, PLANNERS, SCENES, WAY
from soccer_env.train.papers.staging import MIDDLE, make_matches
from soccer_env.train.papers.values import mean, median, quantile
from soccer_env.train.papers.verdicts import Samples, counted, exact, measured, reported

CYCLE = 0.02  # [s] Heinemann 2006, 2  MH03
SLOWER = 20.0  # [1] a Pentium-M of 2 GHz beside the processor that measures, assumed
LOOPS, TRIES = 20, 5  # plans in a loop, and loops of which the fastest counts: H15
WARM, STEPS = 50, 1000  # cycles before those measured, and measured: H02
HEADING = 0.5  # [m] of path that define its first heading
SETTINGS = PlannerSettings()
CELLS = (2 * SETTINGS.half_u + 1) * (2 * SETTINGS.half_v + 1)  # of the whole grid


def evaluations(batch: Batch) -> Samples:
    """Return how often each plan (M,) of both planners evaluates the potential."""
    return {name: np.array([one.evaluations for one in runs.plans_of(batch, **changes)], float)
            for name, changes in PLANNERS.items()}  # fmt: skip


H04 = claim(
    "H04", "3", "Evaluating the potential at adjacent cells alone spares the whole field.",
    f"{PLANNED}; evaluations of the potential in a whole plan, all its passes and searches together, over the "
    f"{CELLS} cells of the field.",
    measured("conventional planner: evaluations a plan", lambda s: 100 * mean(s["old"]) / CELLS, unit="%", at_most=5.0),
    measured("time-variant planner: evaluations a plan", lambda s: 100 * mean(s["new"]) / CELLS, unit="%", at_most=5.0),
    rules=NO_MATCH, measure=evaluations, batches=4, seconds=0.6,
    ingredients=ASSUMED,
    note=LOOKED_AT,
)  # fmt: skip


def compare_local_search(batch: Batch) -> Samples:
    """Return which plans (M,) past rows and cups join robot and target, with the local search and without it."""
    both = {
        "on": runs.plans_of(batch, runs.robot_row_or_cup),
        "off": runs.plans_of(batch, runs.robot_row_or_cup, search=False),
    }
    samples = {name: np.array([one.arrived for one in plans], float) for name, plans in both.items()}
    touches = np.array([one.clearance() < -0.02 for one in both["on"]], float)
    return samples | {"all": np.ones(SCENES), "clean": samples["on"] * (1.0 - touches)}


H05 = claim(
    "H05", "3", "A local grid search, when the path enters a cell twice, overcomes local minima.",
    f"{SCENES} scenes a batch: rows of two or three robots that touch square to the way, cups of nine about the "
    "target; which plans join robot and target, with the search and without it.",
    counted("plans that arrive with the search", "on", "all", at_least=99.0),
    counted("plans that arrive without it", "off", "all", at_most=50.0),
    measured("arrive with it and touch nobody", "clean", unit="%", at_least=95.0),
    rules=NO_MATCH, measure=compare_local_search, batches=4, seconds=1.0,
    ingredients=ASSUMED,
    note=LOOKED_AT,
)  # fmt: skip


def first_heading(one: Plan, scene: runs.Scene) -> float:
    """Return the angle [degrees] between the first half metre of a path and the straight line to the target."""
    path = one.path
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    x, y = (np.interp(HEADING, along, path[:, i]) - path[0, i] for i in (0, 1))
    to_x, to_y = scene.target[0] - scene.robot[0], scene.target[1] - scene.robot[1]
    return float(np.degrees(abs(np.arctan2(to_x * y - to_y * x, to_x * x + to_y * y))))


def compare_directions(batch: Batch) -> Samples:
    """Return first heading [degrees] and length [m] (M,) of backward and forward plans in equal scenes."""
    scenes, samples = runs.scenes_of(batch, runs.still_obstacle, SCENES), {}
    for name, backward in (("back", True), ("fore", False)):
        plans = [runs.plan(scene, time_variant=False, backward=backward) for scene in scenes]
        samples[f"{name} heading"] = np.array([first_heading(*pair) for pair in zip(plans, scenes, strict=True)])
        samples[f"{name} length"] = np.array([one.length for one in plans])
    return samples


H06 = claim(
    "H06", "3", "Backward planning leads around an obstacle at once, instead of heading into it first.",
    f"{SCENES} ways a batch of {WAY:g} m with one obstacle that stands on them, planned in both directions; "
    f"first heading over {HEADING:g} m, and length.",
    measured("the first heading is farther off straight by", lambda s: mean(s["back heading"] - s["fore heading"]),
             unit="deg", above=2.0),
    measured("the way is longer by", lambda s: 100 * mean(s["back length"] - s["fore length"]) / WAY, unit="%",
             at_most=1.0),
    rules=NO_MATCH, measure=compare_directions, batches=4, seconds=0.8,
    ingredients=ASSUMED,
)  # fmt: skip


@compiled
def repeat_plan(times, ends, obstacles, settings, scratch, plans):
    """Compute the plan between the ends x, y, x, y (4,) [m] `times` times, in a loop without Python."""
    for _ in range(times):
        plan_way(ends[0], ends[1], ends[2], ends[3], 1, obstacles, settings[0], scratch[0], plans[0])


def measure_planning_times(batch: Batch) -> Samples:
    """Return the computing time [us] of each scene's plan (M,) by both planners' kernels, and the passes of the new."""
    samples: Samples = {}
    scenes = [(np.array([*one.robot, *one.target]), obstacle_records(np.array(one.obstacles)))
              for one in runs.scenes_of(batch, CROSSING, SCENES)]  # fmt: skip
    for name, changes in PLANNERS.items():
        parts = PlannerSettings(**changes).record(), np.zeros(1, SCRATCH), np.zeros(1, PLAN)
        repeat_plan(1, *scenes[0], *parts)  # compiles it
        rows = [(time_plan(*scene, *parts), int(parts[2]["iterations"][0])) for scene in scenes]
        samples[name], samples[f"{name} passes"] = np.array(rows, float).T
    return samples


def time_plan(*scene: np.ndarray) -> float:
    """Return the processor time [us] of one plan, the least of TRIES means over LOOPS plans."""
    spent = []
    for _ in range(TRIES):
        begun = process_time()
        repeat_plan(LOOPS, *scene)
        spent.append(process_time() - begun)
    return 1e6 * min(spent) / LOOPS


def measure_whole_cycle(batch: Batch) -> Samples:
    """Return the processor time [ms] of one robot's whole cycle (M,): picture, own pose, tracks, plan, command.

    A tenth of the time of a match of ten robots, physics and referee included, which no robot computes.
    """
    sides = dict.fromkeys(("home", "away"), "heinemann-2006")
    match = make_matches(
        batch, MIDDLE, batch.play_rules, matches=1, home=5, away=5, senses="sensors", controllers=sides
    )
    spent = []
    for step in range(WARM + STEPS):
        begun = process_time()
        match.step()
        if step >= WARM:
            spent.append(process_time() - begun)
    robots = match.robots.shape[1]
    match.close()
    return {"cycle": 1e3 * np.array(spent).reshape(-1, STEPS // 20) / robots}


H02 = claim(
    "H02", "2, 3", "The planner runs 50 times a second: the software fits a cycle of 20 ms.",
    f"Processor time of the whole software of one robot in {STEPS} cycles a batch of 5 v 5 play: a tenth of the "
    f"match's, with physics and referee, times {SLOWER:g} for a Pentium-M of 2 GHz beside today's processors "
    "(assumed).",
    measured("time that 1 % of the cycles exceed", lambda s: SLOWER * quantile(s["cycle"], 0.99), unit="ms",
             at_most=1000.0 * CYCLE),
    rules=PLAYED, measure=measure_whole_cycle, timed=True, batches=2, seconds=2.0,
    ingredients=("the machine, and compiled code: numbers differ from run to run",),
)  # fmt: skip

H15 = claim(
    "H15", "3", "The planner is very fast, comparable to standard potential field planners.",
    f"{PLANNED}, by both planners' kernels in a loop without Python; means over {LOOPS} plans, the least of "
    f"{TRIES}. Beside it the share of the cycle that a plan takes on a processor {SLOWER:g} times as slow (assumed), "
    "which is another meaning of \"comparable\".",
    measured("plans of one pass, of which the sentence speaks: time over the conventional planner's (means)",
             lambda s: mean(s["new"][s["new passes"] == 1]) / mean(s["old"][s["new passes"] == 1]), at_most=3.0),
    rules=NO_MATCH, measure=measure_planning_times, condition="in plans of one pass", timed=True, batches=2,
    seconds=1.0,
    ingredients=("the machine, and compiled code: numbers differ from run to run",),
)  # fmt: skip


def plans_equal_paths(batch: Batch, still: bool = True) -> Samples:
    """Tell in which scenes (M,) both planners plan equal paths, bit for bit; `still`: with obstacles at rest."""
    scenes, same = runs.scenes_of(batch, CROSSING, SCENES), []
    for scene in scenes:
        rows = [(x, y, 0.0, 0.0) if still else (x, y, vx, vy) for x, y, vx, vy in scene.obstacles]
        first, second = (runs.plan(scene._replace(obstacles=rows), **changes).path for changes in PLANNERS.values())
        same.append(np.array_equal(first, second))
    return {"same": np.array(same, float)}


H16 = claim(
    "H16", "3", "Conventional planners are unaware of the other robots' speed.",
    f"{PLANNED} by both planners, all velocities taken away: which paths are the same to the last bit.",
    exact("paths that are the same", "same", unit="%", at_least=100.0),
    rules=NO_MATCH, measure=plans_equal_paths, batches=2, seconds=0.8,
    without=Ablation("velocities of 0: here the obstacles move", partial(plans_equal_paths, still=False)),
)  # fmt: skip

# A

KINDS: dict[str, dict[str, Any]] = {"smooth": {}, "literal": {"literal": True}}


def measure_plan_times(batch: Batch, slower: float = 1.0) -> Samples:
    """Return T over T_min (M,), passes, convergence and collisions of plans; `slower` multiplies T_min."""
    samples: Samples = {}
    for name, changes in KINDS.items():
        plans = runs.plans_of(batch, **changes)
        samples[f"{name} ratio"] = np.array([one.time / (slower * one.least_time) for one in plans])
        samples[f"{name} passes"] = np.array([one.iterations for one in plans], float)
        samples[f"{name} open"] = np.array([not one.converged for one in plans], float)
        samples[f"{name} into"] = np.array([one.clearance() < 0.0 for one in plans], float)
    return samples


H12 = claim(
    "H12", "3", "The straight line's time at full speed always underestimates the path's time.",
    f"{PLANNED}; time of the path over the time of the straight line.",
    exact("smallest ratio", lambda s: float(s["smooth ratio"].min()), at_least=1.0 - 1e-9),
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
    plans = [runs.plan(scene) for scene in CANONICAL.values()] if chosen else runs.plans_of(batch)
    return {
        "passes": np.array([one.iterations for one in plans], float),
        "error": np.array([abs(one.times[0] - one.guesses[0]) for one in plans]),
    }


H14 = claim(
    "H14", "3, figure 2", "For the figure's path one iteration estimated the time to less than 100 ms.",
    f"The first plans of both canonical crossings, equal for every seed. Without their choice: {PLANNED}.",
    exact("most passes", "passes", of=np.max, at_most=1.0),
    exact("greatest error of T after the first", "error", of=np.max, unit="s", below=0.1),
    rules=NO_MATCH, measure=first_plans, batches=1, seconds=0.1,
    without=Ablation("the choice of both scenes, by a sketch of the planner: here random ones",
                     partial(first_plans, chosen=False)),
    ingredients=ASSUMED,
    note=LOOKED_AT,
)  # fmt: skip
