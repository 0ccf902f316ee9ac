"""Local minima and remaining indecision, in the point simulator and in the full one.  [Sacks 2001, 4.3.3, 5]"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import Batch, Claim, Curve, Figure
from soccer_env.train.papers.claims.field.paths import GAP, HARD_GAPS, gap_with_third_player, side_change_share
from soccer_env.train.papers.claims.field.point_world import players
from soccer_env.train.papers.claims.field.points import NOISE, SCENES, START, draw_field, gap_ahead, run_points, starts
from soccer_env.train.papers.claims.field.robots import ROBOTS, SECONDS, pad_with_nan, run_robots
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

NO_LIMIT: dict[str, Any] = {"clamp": False, "body_clamp": False}
STRAIGHT = 0.01  # [m] greatest distance from the way of a player "right ahead"
SOMETIMES = 10.0  # [%] least share of runs for "sometimes", assumed
LEFT = 5.0  # [%] least share of runs for "indecision remains", assumed
BACK = 0.07  # [m] of retreat from the goal: two steps, more than a body's sway
DECISIONS: dict[str, dict[str, Any]] = {"all rules": {}, "decisive": {"decisive": True}}
LIMITS: dict[str, dict[str, Any]] = {"off": NO_LIMIT, "on": {}}


def player_right_ahead(rng: np.random.Generator) -> np.ndarray:
    """Return one standing player (M, 1) between the dribbler's start, on the middle line, and the goal."""
    place = np.stack([rng.uniform(-0.3, 0.3, SCENES), rng.uniform(-STRAIGHT, STRAIGHT, SCENES)], axis=-1)
    return players(place[:, None])


def compare_angle_limits(batch: Batch) -> Samples:
    """Return stalls and retreats (M,) of points and of robots, in head-on and gap scenes, with the limits off and on.

    NaN in scenes that the full simulator did not play: it plays fewer.
    """
    rng, samples = batch.rng(), {}
    start = np.column_stack([np.full(SCENES, START), np.zeros(SCENES)])
    scenes = {"head-on": player_right_ahead(rng), "gap": gap_ahead(rng, *GAP, askew=0.0)}
    for scene, crowd in scenes.items():
        for limit, play in LIMITS.items():
            runs = run_points(batch.rng(1), start, crowd, **play)
            name = f"{scene}, limit {limit}"
            samples[f"points {name}: stalls"] = (~runs.arrived).astype(float)
            samples[f"points {name}: retreats"] = (runs.retreats > 0).astype(float)
            robots = run_robots(batch, start[:ROBOTS], crowd[:ROBOTS], **play)
            samples[f"robots {name}: stalls"] = pad_with_nan(~robots.arrived)
            samples[f"robots {name}: retreats"] = pad_with_nan(robots.retreat > BACK)
    return samples


def has_trouble(samples: Samples, who: str, scene: str, limit: str) -> np.ndarray:
    """Return for each run (M,) 1 if it stalls or retreats, 0 if not, and NaN if it is not played."""
    stalls, retreats = (samples[f"{who} {scene}, limit {limit}: {kind}"] for kind in ("stalls", "retreats"))
    return np.maximum(stalls, retreats)


def trouble_share(samples: Samples, who: str, limit: str, scenes: Sequence[str] = ("head-on", "gap")) -> float:
    """Return the share of runs [%] that stall or retreat."""
    return 100 * mean([has_trouble(samples, who, scene, limit) for scene in scenes])


def minimum_figures(samples: Samples) -> Sequence[Figure]:
    """Plot the paths of a dribbler with a player right ahead, with and without the limit of 70 degrees on its turn."""
    crowd, start = players([[0.0, 0.0]]), np.array([[START, 0.0]])
    paths = {
        name: run_points(np.random.default_rng(0), start, crowd, **play).path[:, 0]
        for name, play in (("no limit", NO_LIMIT), ("70 degrees", {}))
    }
    return (draw_field("A player right between dribbler and goal", crowd, paths),)


S54 = Claim(
    id="S54", section="4.3.3",
    statement="An obstacle right between robot and goal sometimes pushes it back: a local minimum.",
    method=f"{SCENES} points and {ROBOTS} robots a batch before a player within {100 * STRAIGHT:.0f} cm of their way, "
    f"and as many before a square gap of {100 * GAP[0]:.0f} to {100 * GAP[1]:.0f} cm, without the limits of 70 and 45 "
    "degrees and with them. A run retreats if a step of a point leads away from the goal, or if a robot is "
    f"{100 * BACK:.0f} cm farther from it than it was; it stalls if it does not come past within 70 s (points) or "
    f"{SECONDS:.0f} s (robots).",
    criteria=(
        measured("points without limits that stall or retreat", trouble_share, "points", "off", unit="%",
                 above=SOMETIMES),
        measured("robots that do so: without limits less with them",
                 lambda s: trouble_share(s, "robots", "off") - trouble_share(s, "robots", "on"), unit="pp",
                 above=SOMETIMES),
        reported("points with the limits", trouble_share, "points", "on", unit="%"),
        *(reported(f"{who} without limits, {scene}", trouble_share, who, "off", (scene,), unit="%")
          for who in ("points", "robots") for scene in ("head-on", "gap")),
        *(reported(f"robots with the limits, {scene}", trouble_share, "robots", "on", (scene,), unit="%")
          for scene in ("head-on", "gap")),
    ),
    measure=compare_angle_limits, figures=minimum_figures, batches=6, seconds=9.0,
    note="Robots that lose the ball, or touch a player, stall or go back as well: that is what they do with the "
    "limits.",
)  # fmt: skip


def count_side_changes(batch: Batch) -> Samples:
    """Count changes of side (M,) of points and robots in the harder scenes, under each set of rules in DECISIONS."""
    rng, samples = batch.rng(), {}
    start, crowd = starts(rng, SCENES, 0.2), gap_with_third_player(rng)
    for name, play in DECISIONS.items():
        runs = run_points(batch.rng(1), start, crowd, {"range_noise": NOISE}, **play)
        samples[f"points {name}"] = runs.flips.astype(float)
        robots = run_robots(batch, start[:ROBOTS], crowd[:ROBOTS], **play)
        samples[f"robots {name}"] = pad_with_nan(robots.flips)
        samples[f"clean {name}"] = pad_with_nan(robots.is_clean)
    ideal = run_robots(batch, start[:ROBOTS], crowd[:ROBOTS], senses="ideal")
    return samples | {"robots that see all": pad_with_nan(ideal.flips)}


def side_changes_figure(samples: Samples) -> Sequence[Figure]:
    """Plot the distribution of the number of changes of side."""
    count = np.arange(13)
    curves = []
    for name in ("points all rules", "points decisive", "robots all rules", "robots decisive"):
        flips = samples[name][np.isfinite(samples[name])]
        curves.append(Curve(name, list(count), [100 * mean(flips >= n) for n in count]))
    return (Figure("Indecision in the harder set", "changes of side", "runs with as many or more [%]", tuple(curves)),)


S68 = Claim(
    id="S68", section="5",
    statement="The problem of local minima is not solved: the robots' indecision remains.",
    method=f"{SCENES} points (range error {100 * NOISE:.0f} %) and {ROBOTS} robots with their sensors a batch before a "
    f"gap of {100 * HARD_GAPS[0]:.0f} to {100 * HARD_GAPS[1]:.0f} cm with a third player near it, all of the paper's "
    "rules on; changes between more than 20 degrees left of the goal and as much right of it.",
    criteria=(
        measured("points: runs with a change of side", side_change_share, "points all rules", unit="%", above=LEFT),
        measured("robots: runs with a change of side", side_change_share, "robots all rules", unit="%", above=LEFT),
        reported("points: changes of side in a run (mean)", "points all rules"),
        reported("robots: changes of side in a run (mean)", "robots all rules"),
        reported("points that are decisive (mean)", "points decisive"),
        reported("robots that are decisive (mean)", "robots decisive"),
        reported("robots that see all (ideal senses) (mean)", "robots that see all"),
        reported("robots that pass and touch nobody", "clean all rules", unit="%"),
        reported("the same of decisive ones", "clean decisive", unit="%"),
    ),
    measure=count_side_changes, figures=side_changes_figure, batches=6, seconds=7.0,
    note="Most changes of robots come from what they see: with ideal senses there are few. Decisive points "
    "(sacks-2001-future), who leave a side only when the other has clearly become better, hardly ever change sides; "
    "decisive robots do as often as the others.",
)  # fmt: skip
