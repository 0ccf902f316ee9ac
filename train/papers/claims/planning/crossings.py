"""Ways past moving obstacles: the crossing of the paper's figure, random crossings, slow traffic.  [H. 2006, 3]

The planner's constants were tuned on both canonical scenes: the floor under repulsion, the search's two rules and the
cap on evaluations stem from this. Random scenes were not used.
"""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from soccer_env.baselines.weigel_2001.planner import Travel
from soccer_env.train.papers.claim import NO_MATCH, Arrows, Batch, Claim, Curve, Figure
from soccer_env.train.papers.claims.planning.runs import (
    CANONICAL,
    CROSSERS,
    CROSSING,
    PLANNERS,
    SLOW,
    SPEED,
    WAY,
    Draw,
    scenes_of,
    side_changes,
    slow_traffic,
    travel,
    travel_results,
)
from soccer_env.train.papers.values import mean, quantile
from soccer_env.train.papers.verdicts import Samples, exact, measured, reported

SCENES = 100  # of a batch
CYCLES = (1, 30, 60)  # of the paper's snapshots
NEAR = 0.25  # [m] between surfaces: nearly a collision
CLEAR = 0.3  # [m] between surfaces: none
LOOKED_AT = (
    "Constants of the planner and both scenes were looked at together while it was built; random crossings were not."
)
ASSUMED = ("forces, grid and search of the planner, which the paper does not give: baselines/weigel_2001/planner",)
SCENE_TEXT = (
    f"{SCENES} points a batch that plan anew every 20 ms and drive {WAY:g} m at {SPEED:g} m/s, each past one obstacle "
    f"at {CROSSERS[0]:g} to {CROSSERS[1]:g} m/s that comes to the straight way when the point would, to 0.3 s"
)


def travel_with_both_planners(batch: Batch, draw: Draw) -> dict[str, list[Travel]]:
    """Return the travels of both planners through the scenes of a batch."""
    scenes = scenes_of(batch, draw, SCENES)
    return {name: [travel(scene, **changes) for scene in scenes] for name, changes in PLANNERS.items()}


def compare_planners(batch: Batch, draw: Draw) -> Samples:
    """Return the results of `travel_results` for the travels of both planners through equal scenes."""
    samples: Samples = {}
    for name, travels in travel_with_both_planners(batch, draw).items():
        samples |= travel_results(travels, name)
    return samples


def canonical_crossings(batch: Batch) -> Samples:
    """Return results of both planners in the two canonical crossings, one unit each, equal in every batch."""
    return travel_results_with_sides({name: [travel(scene, **changes) for scene in CANONICAL.values()]
                               for name, changes in PLANNERS.items()})  # fmt: skip


def travel_results_with_sides(travels_of: dict[str, list[Travel]]) -> Samples:
    """Return, for each planner, `travel_results`, how often paths changed sides of an obstacle, and their distance [m]
    from the first plan.
    """
    samples: Samples = {}
    for name, travels in travels_of.items():
        samples |= travel_results(travels, name)
        samples[f"{name} sides"] = np.array([side_changes(one) for one in travels], float)
        samples[f"{name} strays"] = np.array([distance_from_first_plan(one) for one in travels])
    return samples


def random_crossings(batch: Batch) -> Samples:
    """Return the results of both planners in drawn crossings, and in the fixed ones, which every unit repeats."""
    fixed = canonical_crossings(batch)
    kept = {f"{scene} {name}": np.full(SCENES, values[i]) for name, values in fixed.items()
            for i, scene in enumerate(CANONICAL)}  # fmt: skip
    return travel_results_with_sides(travel_with_both_planners(batch, CROSSING)) | kept


def compare_stricter_threshold(batch: Batch) -> Samples:
    """Return the results of `random_crossings`, and of the new planner with a threshold of T five times as strict."""
    scenes = scenes_of(batch, CROSSING, SCENES)
    exact_ones = [travel(scene, threshold=0.02, most_iterations=16) for scene in scenes]
    return random_crossings(batch) | travel_results(exact_ones, "exact")


def distance_from_first_plan(one: Travel) -> float:
    """Return the greatest distance [m] of the travelled path from the path of the first plan."""
    planned, path = one.planned(0), one.path
    gaps = np.hypot(*(path[:, None] - planned[None]).transpose(2, 0, 1))
    return float(gaps.min(axis=1).max())


def worst_canonical_value(samples: Samples, name: str, take: Any = max) -> float:
    """Return the greatest (or, with `take` min, the least) value of a quantity over both canonical scenes."""
    return float(take(samples[f"{scene} {name}"][0] for scene in CANONICAL))


def near_collision_share(samples: Samples) -> float:
    """Return the share [%] of random crossings in which the old planner nearly collides and then drives away."""
    return 100.0 * mean((samples["old gap"] < NEAR) & (samples["old away"] > 10))


def excess_percent(samples: Samples, name: str) -> float:
    """Return the excess [%] of the old planner's mean of a quantity over the new planner's mean."""
    return 100.0 * (mean(samples[f"old {name}"]) / mean(samples[f"new {name}"]) - 1.0)


def mean_difference(samples: Samples, name: str) -> float:
    """Return the old planner's mean of a quantity minus the new planner's mean."""
    return mean(samples[f"old {name}"] - samples[f"new {name}"])


def snapshots(samples: Samples) -> Sequence[Figure]:
    """Plot the paper's figure: planned and travelled paths of both planners after 1, 30 and 60 cycles, scene a."""
    figures = []
    for name, text in {"old": "Conventional planner", "new": "Time-variant planner"}.items():
        one = travel(CANONICAL["a"], **PLANNERS[name])
        figures += [snapshot(one, cycle, f"{text}, t = {cycle}") for cycle in CYCLES]
    return tuple(figures)


def snapshot(one: Travel, cycle: int, title: str) -> Figure:
    """Return a picture of the planned path, the travelled path and the obstacle at the start of a cycle.  MH18"""
    cycle = min(cycle, len(one.stations) - 2)
    planned, travelled = one.planned(cycle), one.path[: cycle + 1]
    angle = np.linspace(0.0, 2.0 * np.pi, 25)
    (x, y), crosser = one.others(cycle)[0], one.obstacles[0]
    outline = x + crosser["radius"] * np.cos(angle), y + crosser["radius"] * np.sin(angle)
    paths: dict[str, Any] = {"planned": planned.T, "travelled": travelled.T, "obstacle": outline}
    curves = tuple(Curve(name, list(map(float, at)), list(map(float, on))) for name, (at, on) in paths.items())
    course = Arrows([float(x)], [float(y)], [float(crosser["vx"])], [float(crosser["vy"])])
    return Figure(title, "x [m]", "y [m]", curves, arrows=course)


def gap_figure(samples: Samples) -> Sequence[Figure]:
    """Plot the cumulative distributions of the smallest gap and of the time, for both planners."""
    shares = np.linspace(1.0, 99.0, 50)
    names = {"old": "conventional planner", "new": "time-variant planner"}

    def curves(key: str) -> tuple[Curve, ...]:
        return tuple(
            Curve(text, list(np.percentile(samples[f"{name} {key}"], shares)), list(shares))
            for name, text in names.items()
        )

    y_label, half, words = "travels below [%]", (50.0,), "half of them"
    return (
        Figure("Smallest gap in random crossings", "gap [m]", y_label, curves("gap"), rules=half, rule=words),
        Figure("Time of random crossings", "time [s]", y_label, curves("time"), rules=half, rule=words),
    )


H07 = Claim(
    id="H07",
    section="3",
    statement="Planned anew constantly, the conventional planner's paths are efficient and smooth for slow obstacles.",
    method=f"{SCENES} points a batch drive {WAY:g} m past four obstacles at up to {SLOW:g} m/s that leave the target "
    "free, by either planner.",
    criteria=(
        measured("the conventional planner's way is longer by", excess_percent, "length", unit="%", at_most=5.0),
        measured("collisions of the conventional planner", lambda s: float(s["old hit"].sum()), at_most=0.0),
        reported("it takes longer by", excess_percent, "time", unit="%"),
        reported("turns by more", excess_percent, "turn", unit="%"),
        reported("collisions of the time-variant one", lambda s: float(s["new hit"].sum())),
        reported("conventional: way over the straight line", lambda s: mean(s["old length"]) / WAY),
    ),
    rules=NO_MATCH,
    measure=partial(compare_planners, draw=slow_traffic),
    seconds=2.0,
    batches=6,
    ingredients=ASSUMED,
)

H08 = Claim(
    id="H08",
    section="3, figure 1",
    statement="Before a crossing obstacle the conventional planner nearly collides, then drives away from the target.",
    method=f"Two canonical crossings, a and b, and beside them {SCENE_TEXT}.",
    criteria=(
        exact("canonical: greater of both smallest gaps", worst_canonical_value, "old gap", unit="m", below=NEAR),
        exact("canonical: fewer cycles away", worst_canonical_value, "old away", min, above=10.0),
        reported(f"random crossings with a gap below {100 * NEAR:.0f} cm and 10 cycles away", near_collision_share,
                 unit="%"),
        reported("random crossings with 10 cycles away", lambda s: 100 * mean(s["old away"] > 10), unit="%"),
        reported(f"random crossings with a gap below {100 * NEAR:.0f} cm", lambda s: 100 * mean(s["old gap"] < NEAR),
                 unit="%"),
    ),
    rules=NO_MATCH,
    measure=random_crossings,
    seconds=3.0,
    batches=4,
    figures=snapshots,
    ingredients=ASSUMED,
    note=f"{LOOKED_AT} The canonical scenes were chosen because a sketch showed the paper's picture there.",
)  # fmt: skip

H09 = Claim(
    id="H09",
    section="3",
    statement="Time-variant planning avoids the obstacles' predicted trajectories.",
    method=f"Both canonical crossings, and {SCENE_TEXT}; smallest gap between surfaces.",
    criteria=(
        exact("canonical: smaller of both gaps", worst_canonical_value, "new gap", min, unit="m", at_least=CLEAR),
        measured(f"random crossings with a gap of {100 * CLEAR:.0f} cm or more",
                 lambda s: 100 * mean(s["new gap"] >= CLEAR), unit="%", at_least=95.0),
        reported("the same of the conventional planner", lambda s: 100 * mean(s["old gap"] >= CLEAR), unit="%"),
        reported("gap that 5 % stay below", lambda s: quantile(s["new gap"], 0.05), unit="m"),
    ),
    rules=NO_MATCH,
    measure=random_crossings,
    seconds=3.0,
    batches=6,
    figures=gap_figure,
    ingredients=ASSUMED,
    note=LOOKED_AT,
)  # fmt: skip

H10 = Claim(
    id="H10",
    section="3",
    statement="Taking the obstacles' movement into account gives smoother paths and fewer collisions.",
    method=f"{SCENE_TEXT}; both planners in the same scenes.",
    criteria=(
        measured("fewer collisions in 100 crossings", lambda s: 100 * mean_difference(s, "hit"), at_least=0.0),
        measured(f"fewer gaps below {100 * NEAR:.0f} cm in 100 crossings",
                 lambda s: 100 * mean((s["old gap"] < NEAR).astype(float) - (s["new gap"] < NEAR)), above=0.0),
        measured("less turn", mean_difference, "turn", unit="deg", above=0.0),
        measured("less time", mean_difference, "time", unit="s", above=0.0),
        reported("collisions of the conventional planner", "old hit", unit="%"),
        reported("collisions of the time-variant one", "new hit", unit="%"),
        reported("the same, T to 0.02 s instead of 0.1 s", "exact hit", unit="%"),
        reported("turn of the conventional planner", "old turn", unit="deg"),
        reported("turn of the time-variant one", "new turn", unit="deg"),
    ),
    rules=NO_MATCH,
    measure=compare_stricter_threshold,
    seconds=3.0,
    batches=12,
    figures=gap_figure,
    ingredients=ASSUMED,
)  # fmt: skip

H11 = Claim(
    id="H11",
    section="3, figure 2",
    statement="The time-variant planner plans a very efficient path right from the beginning.",
    method=f"Both canonical crossings, and {SCENE_TEXT}; how often plans change the side on which they pass the "
    "obstacle, and how far the travelled way strays from that planned at first.",
    criteria=(
        exact("canonical: changes of side", worst_canonical_value, "new sides", at_most=0.0),
        measured("random crossings without one", lambda s: 100 * mean(s["new sides"] == 0), unit="%", at_least=90.0),
        reported("the same of the conventional planner", lambda s: 100 * mean(s["old sides"] == 0), unit="%"),
        reported("canonical: strays by at most", worst_canonical_value, "new strays", unit="m"),
        reported("canonical, conventional: strays by", worst_canonical_value, "old strays", min, unit="m"),
        reported("random crossings: strays by (mean)", "new strays", unit="m"),
        reported("canonical: way over the straight line", lambda s: worst_canonical_value(s, "new length") / 6.0),
    ),
    rules=NO_MATCH,
    measure=random_crossings,
    seconds=3.0,
    batches=6,
    ingredients=ASSUMED,
    note=LOOKED_AT,
)  # fmt: skip
