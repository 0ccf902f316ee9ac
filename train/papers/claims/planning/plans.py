"""The cost of a plan, and its methods: local gradients, search, backward planning.  [H. 2006, 2, 3]"""

from functools import partial
from time import perf_counter

import numpy as np

from soccer_env.baselines.weigel_2001.planner import Plan, Planner, PlannerSettings
from soccer_env.train.bench.plans import PlanLoad
from soccer_env.train.papers.claim import NO_MATCH, Ablation, Batch, Claim
from soccer_env.train.papers.claims.planning.crossings import ASSUMED, LOOKED_AT
from soccer_env.train.papers.claims.planning.runs import (
    CROSSING,
    PLANNED,
    PLANNERS,
    SCENES,
    WAY,
    Scene,
    plan,
    plans_of,
    robot_row_or_cup,
    scenes_of,
    still_obstacle,
)
from soccer_env.train.papers.values import mean, median, quantile
from soccer_env.train.papers.verdicts import Samples, counted, exact, measured, reported

CYCLE = 0.02  # [s] Heinemann 2006, 2  MH03
HEADING = 0.5  # [m] of path that define its first heading
SETTINGS = PlannerSettings()
CELLS = (2 * SETTINGS.half_u + 1) * (2 * SETTINGS.half_v + 1)  # of the whole grid


def evaluations(batch: Batch) -> Samples:
    """Return how often each plan (M,) of both planners evaluates the potential."""
    return {name: np.array([one.evaluations for one in plans_of(batch, **changes)], float)
            for name, changes in PLANNERS.items()}  # fmt: skip


def evaluations_per_cell(samples: Samples, name: str) -> float:
    """Return the mean number of evaluations of a plan, divided by the number of cells of the whole field [%]."""
    return 100.0 * mean(samples[name]) / CELLS


H04 = Claim(
    id="H04",
    section="3",
    statement="Evaluating the potential at adjacent cells alone spares the whole field.",
    method=f"{PLANNED}; evaluations of the potential in a whole plan, all its passes and searches together, over the "
    f"{CELLS} cells of the field.",
    criteria=(
        measured("conventional planner: evaluations a plan", evaluations_per_cell, "old", unit="%", at_most=5.0),
        measured("time-variant planner: evaluations a plan", evaluations_per_cell, "new", unit="%", at_most=5.0),
        reported("of the time-variant one, 99 % below", lambda s: 100 * quantile(s["new"], 0.99) / CELLS, unit="%"),
    ),
    rules=NO_MATCH,
    measure=evaluations,
    seconds=0.6,
    batches=4,
    ingredients=ASSUMED,
    note=LOOKED_AT,
)


def compare_local_search(batch: Batch) -> Samples:
    """Return which plans (M,) past rows and cups join robot and target, with the local search and without it."""
    both = {"on": plans_of(batch, robot_row_or_cup), "off": plans_of(batch, robot_row_or_cup, search=False)}
    samples = {name: np.array([one.arrived for one in plans], float) for name, plans in both.items()}
    touches = np.array([one.clearance() < -0.02 for one in both["on"]], float)
    return samples | {"all": np.ones(SCENES), "clean": samples["on"] * (1.0 - touches)}


H05 = Claim(
    id="H05",
    section="3",
    statement="A local grid search, when the path enters a cell twice, overcomes local minima.",
    method=f"{SCENES} scenes a batch: rows of two or three robots that touch square to the way, cups of nine about the "
    "target; which plans join robot and target, with the search and without it.",
    criteria=(
        counted("plans that arrive with the search", "on", "all", at_least=99.0),
        counted("plans that arrive without it", "off", "all", at_most=50.0),
        measured("arrive with it and touch nobody", "clean", unit="%", at_least=95.0),
    ),
    rules=NO_MATCH,
    measure=compare_local_search,
    seconds=1.0,
    batches=4,
    ingredients=ASSUMED,
    note=LOOKED_AT,
)


def first_heading(one: Plan, scene: Scene) -> float:
    """Return the angle [degrees] between the first half metre of a path and the straight line to the target."""
    path = one.path
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    x, y = (np.interp(HEADING, along, path[:, i]) - path[0, i] for i in (0, 1))
    to_x, to_y = scene.target[0] - scene.robot[0], scene.target[1] - scene.robot[1]
    return float(np.degrees(abs(np.arctan2(to_x * y - to_y * x, to_x * x + to_y * y))))


def sharpest_turn(one: Plan) -> float:
    """Return the greatest change of heading [degrees] of a path within half a metre."""
    path = one.path
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    at = np.arange(0.0, along[-1], 0.1)
    x, y = (np.interp(at, along, path[:, i]) for i in (0, 1))
    heading = np.unwrap(np.arctan2(np.diff(y), np.diff(x)))
    return float(np.degrees(np.abs(heading[5:] - heading[:-5]).max()))


def compare_directions(batch: Batch) -> Samples:
    """Return first heading, length and sharpest turn (M,) of backward and forward plans in equal scenes."""
    scenes, samples = scenes_of(batch, still_obstacle, SCENES), {}
    for name, backward in (("back", True), ("fore", False)):
        plans = [plan(scene, time_variant=False, backward=backward) for scene in scenes]
        samples[f"{name} heading"] = np.array([first_heading(*pair) for pair in zip(plans, scenes, strict=True)])
        samples[f"{name} length"] = np.array([one.length for one in plans])
        samples[f"{name} turn"] = np.array([sharpest_turn(one) for one in plans])
    return samples


def backward_excess(samples: Samples, name: str) -> float:
    """Return the mean of a quantity of the backward plans minus its mean of the forward plans."""
    return mean(samples[f"back {name}"] - samples[f"fore {name}"])


H06 = Claim(
    id="H06",
    section="3",
    statement="Backward planning leads around an obstacle at once, instead of heading into it first.",
    method=f"{SCENES} ways a batch of {WAY:g} m with one obstacle that stands on them, planned in both directions; "
    f"first heading over {HEADING:g} m, length, sharpest turn within {HEADING:g} m.",
    criteria=(
        measured("the first heading is farther off straight by", backward_excess, "heading", unit="deg", above=2.0),
        measured("the way is longer by", lambda s: 100 * backward_excess(s, "length") / WAY, unit="%", at_most=1.0),
        measured("the sharpest turn is less by", lambda s: -backward_excess(s, "turn"), unit="deg", above=0.0),
        reported("first heading, backwards", "back heading", unit="deg"),
        reported("first heading, forwards", "fore heading", unit="deg"),
    ),
    rules=NO_MATCH,
    measure=compare_directions,
    seconds=0.8,
    batches=4,
    ingredients=ASSUMED,
)


def measure_planning_times(batch: Batch) -> Samples:
    """Return the computing time [us] of each scene's plan (M,) by both planners, the least of five tries."""
    scenes, samples = scenes_of(batch, CROSSING, SCENES), {}
    for name, changes in PLANNERS.items():
        planner = Planner(**changes)
        samples[name] = np.array([min(time_plan(planner, scene) for _ in range(5)) for scene in scenes])
    return samples


def time_plan(planner: Planner, scene: Scene) -> float:
    """Plan a scene once and return the computing time [us], Python's overhead included."""
    begun = perf_counter()
    planner.plan(*scene)
    return 1e6 * (perf_counter() - begun)


def compare_planning_times(batch: Batch) -> Samples:
    """Return the computing times [us] of plans by both planners, and of plans past nine obstacles."""
    _, plans = PlanLoad(int(batch.sequence().generate_state(1)[0])).sample(SCENES)
    return measure_planning_times(batch) | {"nine": 1e6 * np.array(plans)}


H02 = Claim(
    id="H02",
    section="2, 3",
    statement="The planner runs 50 times a second: the software fits a cycle of 20 ms.",
    method=f"Time of {SCENES} plans a batch over 5 m past nine moving obstacles, on one core; a tenth of the cycle, "
    "as a machine 20 years younger than the paper's can hardly miss the whole.",
    criteria=(
        measured("time that 1 % of the plans exceed", lambda s: 1e-4 * quantile(s["nine"], 0.99) / CYCLE,
                 unit="% of 20 ms", at_most=10.0),
        reported("plan (median)", "nine", of=median, unit="us"),
    ),
    rules=NO_MATCH,
    measure=compare_planning_times,
    seconds=2.0,
    batches=2,
    ingredients=("the machine, and compiled code: numbers differ from run to run",),
)  # fmt: skip

H15 = Claim(
    id="H15",
    section="3",
    statement="The planner is very fast, comparable to standard potential field planners.",
    method=f"{PLANNED}, by both planners; the least of five times each, on one core, with what Python adds to both.",
    criteria=(
        measured("time over the conventional planner's (median)", lambda s: median(s["new"] / s["old"]), at_most=3.0),
        reported("that 1 % exceed", lambda s: quantile(s["new"] / s["old"], 0.99)),
    ),
    rules=NO_MATCH,
    measure=measure_planning_times,
    seconds=1.5,
    batches=2,
    ingredients=("the machine, and compiled code: numbers differ from run to run",),
)


def plans_equal_paths(batch: Batch, still: bool = True) -> Samples:
    """Tell in which scenes (M,) both planners plan equal paths, bit for bit; `still`: with obstacles at rest."""
    scenes, same = scenes_of(batch, CROSSING, SCENES), []
    for scene in scenes:
        rows = [(x, y, 0.0, 0.0) if still else (x, y, vx, vy) for x, y, vx, vy in scene.obstacles]
        first, second = (plan(scene._replace(obstacles=rows), **changes).path for changes in PLANNERS.values())
        same.append(np.array_equal(first, second))
    return {"same": np.array(same, float)}


H16 = Claim(
    id="H16",
    section="3",
    statement="Conventional planners are unaware of the other robots' speed.",
    method=f"{PLANNED} by both planners, all velocities taken away: which paths are the same to the last bit.",
    criteria=(exact("paths that are the same", "same", unit="%", at_least=100.0),),
    rules=NO_MATCH,
    measure=plans_equal_paths,
    without=Ablation("velocities of 0: here the obstacles move", partial(plans_equal_paths, still=False)),
    seconds=0.8,
    batches=2,
)
