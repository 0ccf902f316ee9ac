"""Dribbling past players who stand or walk, by class, and how often to decide.  [Sacks 2001, 4.2, 4.3.2, 4.3.4]

A player's distance counts from the camera to its surface, as the sensors gave it (MS42).
"""

from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.scenes import Scene
from soccer_env.scenes.drills_legged import legged_drill, put_at_distance, send_mover, start_dribble
from soccer_env.scenes.scene import SceneRandom
from soccer_env.train.papers.claim import Batch, claim
from soccer_env.train.papers.claims.field.points import player_near_path, run_robots, starts
from soccer_env.train.papers.dribble_runs import LONGEST, PAPER, play_drill
from soccer_env.train.papers.plots import columns, part, plot, plot_curves
from soccer_env.train.papers.verdicts import Samples, measured, reported

Plan = Sequence[tuple[str | Scene, dict[str, Any], float]]  # scene, settings of the team, speed of movers [m/s]

MATCHES, FEWER = 24, 12  # of each scene in a batch; fewer in a batch of many scenes
STILL = ("dribble-past-one", "dribble-past-two", "dribble-past-three")
MOVING = ("dribble-past-mover-near", "dribble-past-mover-far", "dribble-past-mover-head-on")
SPEEDS = (0.03, 0.06, 0.09, 0.12)  # [m/s] of a mover: up to a robot's top speed
SLOW = 0.06  # [m/s] up to which a mover decides
RULES = (
    "The scene is that of the drill, but the robot dribbles from the start, does not shoot, and a touch ends nothing; "
    f"{LONGEST:g} s at most. Clean: past everybody with the ball without a touch of any robot. Distances of players "
    "count from camera to surface."
)
BODIES = "The field takes robots for points (MS44); bodies count as touching when outlines meet, legs and paws too. "


def play_all(batch: Batch, plan: Plan, matches: int) -> Samples:
    """Play each scene of a plan with its team settings and mover speed; return `play_drill` arrays (M, len(plan))."""
    runs = [play_drill(batch, scene, settings, matches, speed) for scene, settings, speed in plan]
    return {name: np.stack([one[name] for one in runs], axis=1) for name in runs[0]}


# Standing players


def dribble_past_still(batch: Batch) -> Samples:
    """Dribble past one, two, three standing players; past one also with ideal senses, and from afar."""
    samples = play_all(batch, [(scene, {}, PAPER) for scene in STILL], MATCHES)
    samples["clean ideal"] = play_drill(batch, STILL[0], {}, MATCHES, senses="ideal")["clean"]
    rng = batch.rng()
    start, crowd = starts(rng, MATCHES), player_near_path(rng, 0.0, 0.25, MATCHES)
    return samples | {"clean afar": run_robots(batch, start, crowd).is_clean}


S62 = claim(
    "S62", "4.3.4", "A dribbling robot consistently avoids stationary players.",
    f"{MATCHES} runs a batch past one, two and three players who stand on the way to the goal. {RULES}",
    measured("clean, over one to three players", "clean", unit="%", at_least=95.0),
    reported("one, ideal senses: clean", "clean ideal", unit="%"),
    reported("one who stands 90 to 150 cm off at the start: clean", "clean afar", unit="%"),
    measure=dribble_past_still,
    figures=plot("Dribbling past players who stand", "players", "runs [%]", (1, 2, 3),
                 {"past, without a touch": columns("clean"), "past, no touch that stops or turns": columns("free"),
                  "past": columns("past")}, rules=(95.0,)),
    least=3, batches=8, seconds=8.0,
    ingredients=("the drills' places", "bodies with paws, not points", "the head that glances up"),
    note=BODIES + "The drills begin about 60 cm from the first player, middle to middle: 35 cm from camera to surface, "
    "where he pushes half as much again as the goal pulls before he has been seen. With ideal senses, or begun farther "
    "off, nearly all runs past one player are clean; else the robot turns off at once by 45 degrees, and the ball "
    "slips.",
)  # fmt: skip

# A moving player

RUNS = [(scene, speed) for scene in MOVING for speed in SPEEDS]

S63 = claim(
    "S63", "4.3.4", "One moving player is avoided well too, near or far at the start, even head-on.",
    f"{FEWER} runs a batch in each of {', '.join(MOVING)}, the mover at 3, 6, 9 and 12 cm/s. Up to 6 cm/s "
    f"decides; the paper gives no speed, and a dribbler makes 7. {RULES}",
    measured("clean, at 3 and 6 cm/s", "clean", [i for i, (_, speed) in enumerate(RUNS) if speed <= SLOW],
             unit="%", at_least=80.0),
    measure=lambda batch: play_all(batch, [(scene, {}, speed) for scene, speed in RUNS], FEWER),
    figures=plot("Dribbling past one mover", "its speed [cm/s]", "clean runs [%]", [100 * speed for speed in SPEEDS],
                 {scene.removeprefix("dribble-past-"): columns(part("clean", ..., slice(i, i + len(SPEEDS))))
                  for i, scene in zip(range(0, len(RUNS), len(SPEEDS)), MOVING, strict=True)}, rules=(80.0,)),
    batches=8, seconds=6.0,
    ingredients=("the walker goes straight on and never gives way", "bodies with paws, not points"),
    note=BODIES + "A dribbler at 7 cm/s cannot get a body's width aside of one that comes as fast; that the paper's "
    "movers were slower, or stopped, is a guess.",
)  # fmt: skip

# How often to decide

REPLANS = (0.125, 0.25, 0.5, 1.0, 2.0)  # [s] between two decisions; the paper's is 0.5
SCENES = ("dribble-past-two", "dribble-past-mover-far")
FINE = np.geomspace(REPLANS[0], REPLANS[-1], 33)  # [s] of the figure
DEGREE = 2  # of the curve in the logarithm of the time: a rise, a fall and a bend


def compare_decision_times(batch: Batch) -> Samples:
    """Dribble past two still players, and past a mover from afar; return means of both by decision time (M, times)."""
    plan: Plan = [(scene, {"replan": time}, PAPER) for scene in SCENES for time in REPLANS]
    runs, count = play_all(batch, plan, FEWER), len(REPLANS)
    return {name: 0.5 * (values[:, :count] + values[:, count:]) for name, values in runs.items()}


def fitted_clean_share(samples: Samples, *times: float) -> float:
    """Return the mean clean share [%] at the given decision intervals, on the curve fitted over all intervals."""
    curve = np.polyfit(np.log2(REPLANS), 100.0 * samples["clean"].mean(axis=0), DEGREE)
    return float(np.polyval(curve, np.log2(times)).mean())


S52 = claim(
    "S52", "4.3.2", "Half a second between recalculations suits steps that take half a second.",
    f"{FEWER} runs a batch past two still players and past a mover, with decisions every "
    f"{', '.join(f'{time:g}' for time in REPLANS)} s; a curve of degree {DEGREE} in the logarithm of the time is "
    f"fitted to the clean share. {RULES}",
    measured("curve at 0.125 and 0.25 s less at 0.5 s: no gain of 5 points",
             lambda s: fitted_clean_share(s, 0.125, 0.25) - fitted_clean_share(s, 0.5), unit="%", at_most=5.0),
    measured("curve at 0.5 s less at 1 s", lambda s: fitted_clean_share(s, 0.5) - fitted_clean_share(s, 1.0),
             unit="%", above=0.0),
    measure=compare_decision_times, batches=7, seconds=8.0,
    figures=plot_curves("Dribbling by the time between decisions", "time [s]", "runs [%]",
                        {"without a touch": lambda s: (REPLANS, columns("clean")(s)),
                         "past": lambda s: (REPLANS, columns("past")(s)),
                         "without a touch, curve": lambda s: (FINE, [fitted_clean_share(s, time) for time in FINE])}),
    ingredients=("gait steps of half a second: a decision takes effect when one begins",),
    note="A decision takes effect when the next gait step begins: deciding more often brings a fresher picture. A "
    "second is only two steps, 7 cm.",
)  # fmt: skip

# A mover among standing players, by class of situation


def place_still_behind(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place a mover as in dribble-past-mover-far, and a still player on the path beyond the mover's crossing."""
    robot, (still, mover), way = start_dribble(league, ball, robots, draw, 2)
    put_at_distance(league, robot, still, draw.between(0.95, 1.1), way + draw.between(-0.1, 0.1), draw.between(-pi, pi))
    aside = draw.side() * draw.between(0.35, 0.7)
    send_mover(league, robot, mover, draw, way, (1.1, 1.5), aside, (0.3, 0.6))


STILL_BEHIND = legged_drill(
    "still-behind-mover", "a mover, and a still player behind where it crosses", place_still_behind, "home gets past",
    "still", "walker@0.5",
)  # fmt: skip
CLASSES: tuple[tuple[str, tuple[str | Scene, ...]], ...] = (
    ("one still", ("dribble-past-one",)),
    ("one mover", MOVING),
    ("mover, a still player behind", (STILL_BEHIND,)),
    ("mover and still, opposite sides", ("mover-and-still",)),
)
BEHIND = 2  # of CLASSES: the mover with a stationary player, not one on each side
AS_WELL = 10.0  # [pp] more touches that are "about as well", assumed
clean, touched = columns("clean"), columns("touched")  # shares [%] of the runs of each class


def dribble_past_classes(batch: Batch) -> Samples:
    """Dribble in all classes; return means over each class's drills (M, classes), named as in `play_drill`."""
    plan: Plan = [(scene, {}, PAPER) for _, scenes in CLASSES for scene in scenes]
    runs = play_all(batch, plan, MATCHES)
    ends = np.cumsum([0] + [len(scenes) for _, scenes in CLASSES])
    return {
        name: np.stack([values[:, a:b].mean(axis=1) for a, b in zip(ends, ends[1:], strict=False)], axis=1)
        for name, values in runs.items()
    }


S64 = claim(
    "S64", "4.3.4", "A mover and stationary players are mostly avoided well, but not one on each side.",
    f"{MATCHES} runs a batch in each drill of four classes: {', '.join(name for name, _ in CLASSES)}; movers at "
    f"6 cm/s. The paper: \"it performs well much of the time\", but less so with one on each side. {RULES}",
    measured("clean, a mover and a still player behind", "clean", BEHIND, unit="%", above=50.0),
    measured("the least other class less mover and still on opposite sides",
             lambda s: min(clean(s)[:-1]) - clean(s)[-1], unit="%", above=0.0),
    measure=dribble_past_classes, batches=6, seconds=8.0,
    ingredients=("the walker goes straight on and never gives way", "the drills' places, STILL_BEHIND here"),
    note=BODIES,
)  # fmt: skip

S43 = claim(
    "S43", "4.2", "The potential field handles moving obstacles about as well as stationary ones.",
    "The runs of S64: share that touch somebody, one mover at 6 cm/s against one who stands. \"About as well\" "
    f"is read as {AS_WELL:g} points more at most. {RULES}",
    measured("touched, one mover less one who stands", lambda s: touched(s)[1] - touched(s)[0], unit="pp",
             at_most=AS_WELL),
    measure=dribble_past_classes, batches=6, seconds=8.0,
    ingredients=("the walker goes straight on and never gives way",),
    note="The field has positions alone, no velocities.",
)  # fmt: skip
