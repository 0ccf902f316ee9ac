"""Local minima, remaining indecision, and a stronger preference for the present side.  [Sacks 2001, 4.3.3, 5]"""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import NO_MATCH, Batch, claim
from soccer_env.train.papers.claims.field import points
from soccer_env.train.papers.claims.field.paths import GAP, HARD_GAPS, gap_with_third_player, side_change_share
from soccer_env.train.papers.claims.field.point_world import players
from soccer_env.train.papers.claims.field.points import NOISE, ROBOT_SECONDS, ROBOTS, SCENES, SPEEDS, START
from soccer_env.train.papers.plots import each, plot, plot_shares, plots
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

NO_LIMIT: dict[str, Any] = {"clamp": False, "body_clamp": False}
STRAIGHT = 0.01  # [m] greatest distance from the way of a player "right ahead"
SOMETIMES = 10.0  # [%] least share of runs for "sometimes", assumed
LEFT = 5.0  # [%] least share of runs for "indecision remains", assumed
BACK = 0.07  # [m] of retreat from the goal: two steps, more than a body's sway
DECISIONS: dict[str, dict[str, Any]] = {"all rules": {}, "decisive": {"decisive": True}}
LIMITS: dict[str, dict[str, Any]] = {"off": NO_LIMIT, "on": {}}


def compare_angle_limits(batch: Batch) -> Samples:
    """Return stalls and retreats (M,) of points and of robots, in head-on and gap scenes, with the limits off and on.

    NaN in scenes that the full simulator did not play: it plays fewer.
    """
    rng, samples = batch.rng(), {}
    start = np.column_stack([np.full(SCENES, START), np.zeros(SCENES)])
    place = np.stack([rng.uniform(-0.3, 0.3, SCENES), rng.uniform(-STRAIGHT, STRAIGHT, SCENES)], axis=-1)
    scenes = {"head-on": players(place[:, None]), "gap": points.gap_ahead(rng, *GAP, askew=0.0)}
    for scene, crowd in scenes.items():
        for limit, play in LIMITS.items():
            runs = points.run_points(batch.rng(1), start, crowd, **play)
            name = f"{scene}, limit {limit}"
            samples[f"points {name}: stalls"] = (~runs.arrived).astype(float)
            samples[f"points {name}: retreats"] = (runs.retreats > 0).astype(float)
            robots = points.run_robots(batch, start, crowd, **play)
            samples[f"robots {name}: stalls"] = points.pad_with_nan(~robots.arrived)
            samples[f"robots {name}: retreats"] = points.pad_with_nan(robots.retreat > BACK)
    return samples


def has_trouble(samples: Samples, who: str, scene: str, limit: str) -> np.ndarray:
    """Return for each run (M,) 1 if it stalls or retreats, 0 if not, and NaN if it is not played."""
    stalls, retreats = (samples[f"{who} {scene}, limit {limit}: {kind}"] for kind in ("stalls", "retreats"))
    return np.maximum(stalls, retreats)


def trouble_share(samples: Samples, who: str, limit: str, scenes: Sequence[str] = ("head-on", "gap")) -> float:
    """Return the share of runs [%] that stall or retreat."""
    return 100 * mean([has_trouble(samples, who, scene, limit) for scene in scenes])


S54 = claim(
    "S54", "4.3.3", "An obstacle right between robot and goal sometimes pushes it back: a local minimum.",
    f"{SCENES} points and {ROBOTS} robots a batch before a player within {100 * STRAIGHT:.0f} cm of their way, "
    f"and as many before a square gap of {100 * GAP[0]:.0f} to {100 * GAP[1]:.0f} cm, without the limits of 70 and 45 "
    "degrees and with them. A run retreats if a step of a point leads away from the goal, or if a robot is "
    f"{100 * BACK:.0f} cm farther from it than it was; it stalls if it does not come past within 70 s (points) or "
    f"{ROBOT_SECONDS:.0f} s (robots).",
    measured("points without limits that stall or retreat", trouble_share, "points", "off", unit="%", above=SOMETIMES),
    measured("robots that do so: without limits less with them",
             lambda s: trouble_share(s, "robots", "off") - trouble_share(s, "robots", "on"), unit="pp",
             above=SOMETIMES),
    reported("points with the limits", trouble_share, "points", "on", unit="%"),
    measure=compare_angle_limits,
    figures=lambda samples: [points.draw_field("A player right between dribbler and goal", [[0.0, 0.0]],
                                  {"no limit": NO_LIMIT, "70 degrees": {}})],
    batches=6, seconds=9.0,
    note="Robots that lose the ball, or touch a player, stall or go back as well: that is what they do with the "
    "limits.",
)  # fmt: skip


def count_side_changes(batch: Batch) -> Samples:
    """Count changes of side (M,) of points and robots in the harder scenes, under each set of rules in DECISIONS."""
    rng, samples = batch.rng(), {}
    start, crowd = points.starts(rng, SCENES, 0.2), gap_with_third_player(rng)
    for name, play in DECISIONS.items():
        runs = points.run_points(batch.rng(1), start, crowd, {"range_noise": NOISE}, **play)
        samples[f"points {name}"] = runs.flips.astype(float)
        robots = points.run_robots(batch, start, crowd, **play)
        samples[f"robots {name}"] = points.pad_with_nan(robots.flips)
        samples[f"clean {name}"] = points.pad_with_nan(robots.is_clean)
    ideal = points.run_robots(batch, start, crowd, senses="ideal")
    return samples | {"robots that see all": points.pad_with_nan(ideal.flips)}


S68 = claim(
    "S68", "5", "The problem of local minima is not solved: the robots' indecision remains.",
    f"{SCENES} points (range error {100 * NOISE:.0f} %) and {ROBOTS} robots with their sensors a batch before a "
    f"gap of {100 * HARD_GAPS[0]:.0f} to {100 * HARD_GAPS[1]:.0f} cm with a third player near it, all of the paper's "
    "rules on; changes between more than 20 degrees left of the goal and as much right of it.",
    measured("points: runs with a change of side", side_change_share, "points all rules", unit="%", above=LEFT),
    measured("robots: runs with a change of side", side_change_share, "robots all rules", unit="%", above=LEFT),
    measure=count_side_changes,
    figures=plot_shares("Indecision in the harder set", "changes of side", "runs with as many or more [%]", range(13),
                        {f"{who} {name}": f"{who} {name}" for who in ("points", "robots") for name in DECISIONS},
                        np.greater_equal),
    batches=6, seconds=7.0,
    note="Most changes of robots come from what they see: with ideal senses there are few. Decisive points "
    "(sacks-2001-future), who leave a side only when the other has clearly become better, hardly ever change sides; "
    "decisive robots do as often as the others.",
)  # fmt: skip

# A stronger preference for the present side, with moving players

PATIENCE = (0, 1, 2, 4, 8)  # decisions for which a change of side has to last
ANGLES = (135.0, 90.0, 45.0, 0.0)  # [degrees] beyond which the side is kept
MOVERS = {"comes": "one comes", "both": "one comes, one stands on the other side"}  # the classes in the paper


def collide_with_movers(batch: Batch) -> Samples:
    """Return whether points collide (M,) in each class of scenes with a mover, for each patience and angle."""
    rng, samples = batch.rng(), {}
    start = points.starts(rng)
    for scene, crowd in (("comes", points.approaching_player(rng)), ("both", points.players_on_both_sides(rng))):
        for name, values in (("patience", PATIENCE), ("keep_side_angle", ANGLES)):
            for value in values:
                play = {name: np.radians(value) if name == "keep_side_angle" else value}
                runs = points.run_points(batch.rng(1), start, crowd, {"body": True, "range_noise": NOISE}, **play)
                samples[f"{scene} {name} {value:g}"] = points.collided(runs).astype(float)
    return samples


def collision_share(samples: Samples, name: str, value: float, scenes: Iterable[str] = MOVERS) -> float:
    """Return the share of runs with a collision [%] at a value of the setting `name`, over classes of scenes."""
    return 100 * mean([samples[f"{scene} {name} {value:g}"] for scene in scenes])


S58 = claim(
    "S58", "4.3.3", "Keeping the direction more often made the reaction to moving obstacles too slow.",
    f"{SCENES} points a batch and class of scenes, facing the goal, meet a player at {100 * SPEEDS[0]:.0f} to "
    f"{100 * SPEEDS[1]:.0f} cm/s: one that comes straight for them, or one that comes from one side while another "
    f"stands on the other (the classes of 4.3.4). Ranges have an error of {100 * NOISE:.0f} %. A change of side has to "
    f"last for {', '.join(map(str, PATIENCE))} decisions before it is made; beside it the side is kept beyond smaller "
    "angles than 135 degrees.",
    measured(f"collisions at {PATIENCE[-1]} decisions less those at 0",
             lambda s: collision_share(s, "patience", PATIENCE[-1]) - collision_share(s, "patience", PATIENCE[0]),
             unit="pp", above=0.0),
    rules=NO_MATCH, measure=collide_with_movers,
    figures=plots(*(plot("Collisions with movers", label, "runs with a collision [%]", values,
                         {title: each(values, lambda s, name, key, value: collision_share(s, name, value, (key,)), name,
                                      key) for key, title in MOVERS.items()})
                    for name, values, label in (("patience", PATIENCE,
                                                 "decisions for which a change of side has to last"),
                                                ("keep_side_angle", ANGLES,
                                                 "angle beyond which the side is kept [degrees]")))),
    batches=16, seconds=1.5,
    note="Keeping the side beyond smaller angles than 135 degrees changes next to nothing: who is pushed more than 70 "
    "degrees off the goal is nearly always pushed back by more than 135.",
)  # fmt: skip
