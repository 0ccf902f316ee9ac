"""Dribbling past players who stand and players who walk.  [Sacks 2001, 4.3.4, 4.2, 4.3.2]"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from math import pi
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.leagues.league import League
from soccer_env.match_settings import Senses
from soccer_env.scenes import Scene
from soccer_env.scenes.drills_legged import drill, put_at, send_mover, start_dribble
from soccer_env.scenes.scene import Draw
from soccer_env.train.reproduce.claim import SACKS, Batch, Claim, Curve, Figure
from soccer_env.train.reproduce.drill_runs import LONGEST, PAPER, play_drill
from soccer_env.train.reproduce.verdicts import Samples, measured, reported

Plan = Sequence[tuple[str | Scene, dict[str, Any], float]]  # scene, settings of the team, speed of movers [m/s]

MATCHES, FEWER = 48, 20  # of each scene in a batch; where a batch has many scenes
STILL = ("dribble-past-one", "dribble-past-two", "dribble-past-three")
MOVING = ("dribble-past-mover-near", "dribble-past-mover-far", "dribble-past-mover-head-on")
SPEEDS = (0.03, 0.06, 0.09, 0.12)  # [m/s] of a mover: up to a robot's top speed
REPLANS = (0.125, 0.25, 0.5, 1.0, 2.0)  # [s] between two decisions; the paper's is 0.5
RULES = (
    "The scene is that of the drill, but the robot dribbles from the start, does not shoot, and a touch ends nothing; "
    f"{LONGEST:g} s at most. Clean: past everybody with the ball without a touch of any robot."
)
BODIES = (
    "The field takes robots for points (MS44) and bends the way off them as far as their forces say; "
    "bodies here are 27 cm long with paws 14 cm ahead of their middle, and count as touching when outlines meet. "
)


def clean(samples: Samples, name: str = "clean", columns: Any = slice(None)) -> float:
    """Return a share [%] over runs and some columns."""
    return 100.0 * float(samples[name][:, columns].mean())


def play_all(batch: Batch, plan: Plan, matches: int) -> Samples:
    """Play scenes, each with settings of the team and a mover's speed; arrays (M, len(plan)) of `play_drill`."""
    found = [play_drill(batch, scene, settings, matches, speed) for scene, settings, speed in plan]
    return {name: np.stack([one[name] for one in found], axis=1) for name in found[0]}


# Players who stand


def pass_still(batch: Batch) -> Samples:
    """Dribble past one, two and three players who stand; one also with ideal senses, with twice k2, with both."""
    found = play_all(batch, [(scene, {}, PAPER) for scene in STILL], MATCHES)
    strong = {"player_gain": 2.0 * SacksSettings().player_gain}
    variants: tuple[tuple[str, dict[str, Any], Senses], ...] = (
        ("ideal", {}, "ideal"),
        ("strong", strong, "sensors"),
        ("both", strong, "ideal"),
    )
    for name, settings, senses in variants:
        one = play_drill(batch, STILL[0], settings, MATCHES, senses=senses)
        found |= {f"{key} {name}": values for key, values in one.items()}
    return found


def still_figure(samples: Samples) -> Sequence[Figure]:
    """Draw what became of the runs by the number of players."""
    names = {"clean": "past, without a touch", "past": "past"}
    curves = tuple(Curve(text, (1, 2, 3), [clean(samples, name, i) for i in range(3)]) for name, text in names.items())
    return (Figure("Dribbling past players who stand", "players", "runs [%]", curves, rules=(95.0,)),)


S62 = Claim(
    id="S62",
    paper=SACKS,
    section="4.3.4",
    statement="A dribbling robot consistently avoids stationary players.",
    method=f"{MATCHES} runs a batch past one, two and three players who stand on the way to the goal. {RULES}",
    criteria=(
        measured("clean, over one to three players", clean, unit="%", at_least=95.0),
        *(reported(f"clean, {i + 1}", partial(clean, name="clean", columns=i), unit="%") for i in range(3)),
        reported("past with the ball, touched or not", lambda s: clean(s, "past"), unit="%"),
        reported("ball lost", lambda s: clean(s, "lost"), unit="%"),
        reported("one: median distance between middles of bodies at the nearest",
                 lambda s: 100.0 * float(np.median(s["nearest"][:, 0])), unit="cm"),
        reported("one, ideal senses: clean", lambda s: 100.0 * float(s["clean ideal"].mean()), unit="%"),
        reported("one, twice k2: clean", lambda s: 100.0 * float(s["clean strong"].mean()), unit="%"),
        reported("one, twice k2, ideal senses: clean", lambda s: 100.0 * float(s["clean both"].mean()), unit="%"),
    ),
    measure=pass_still,
    figures=still_figure,
    ingredients=("the drills' places", "bodies with paws, not points"),
    note=BODIES + "It gets past nearly always, and brushes somebody in more than half of the runs: with k2 = 800 its "
    "middle comes as near as 26 cm to a player's, bodies and paws need up to 29. Seeing better and twice the force "
    "each mend a part, together all.",
    seconds=5.5,
    batches=12,
)  # fmt: skip

# One who moves


def pass_mover(batch: Batch) -> Samples:
    """Dribble past one mover: columns by drill, then by speed."""
    return play_all(batch, [(scene, {}, speed) for scene in MOVING for speed in SPEEDS], FEWER)


def of_drill(index: int) -> slice:
    """Return the columns of one drill of MOVING."""
    return slice(index * len(SPEEDS), (index + 1) * len(SPEEDS))


def of_speeds(most: float) -> list[int]:
    """Return the columns of speeds up to `most` [m/s]."""
    return [i for i in range(len(MOVING) * len(SPEEDS)) if SPEEDS[i % len(SPEEDS)] <= most]


def mover_figure(samples: Samples) -> Sequence[Figure]:
    """Draw the clean runs against the mover's speed, one curve for each drill."""
    centimetres = [100 * speed for speed in SPEEDS]
    curves = tuple(
        Curve(scene.removeprefix("dribble-past-"), centimetres, list(100.0 * samples["clean"][:, of_drill(i)].mean(0)))
        for i, scene in enumerate(MOVING)
    )
    return (Figure("Dribbling past one mover", "its speed [cm/s]", "clean runs [%]", curves, rules=(80.0,)),)


S63 = Claim(
    id="S63",
    paper=SACKS,
    section="4.3.4",
    statement="With one moving player it does well too, near or far at the start, even if that one comes straight on.",
    method=f"{FEWER} runs a batch in each of {', '.join(MOVING)}, the mover at 3, 6, 9 and 12 cm/s. {RULES}",
    criteria=(
        measured("clean, over all drills and speeds", clean, unit="%", at_least=80.0),
        reported("clean, at 3 and 6 cm/s", lambda s: clean(s, "clean", of_speeds(0.06)), unit="%"),
        reported("clean, near at the start", lambda s: clean(s, "clean", of_drill(0)), unit="%"),
        reported("clean, far at the start", lambda s: clean(s, "clean", of_drill(1)), unit="%"),
        reported("clean, head-on", lambda s: clean(s, "clean", of_drill(2)), unit="%"),
        reported("past with the ball, touched or not", lambda s: clean(s, "past"), unit="%"),
    ),
    measure=pass_mover,
    figures=mover_figure,
    ingredients=("the walker goes straight on and never gives way", "bodies with paws, not points"),
    note=BODIES + "A dribbler at 7 cm/s cannot get a body's width aside of one that comes as fast; the paper's movers "
    "may have been slower, or stopped.",
    seconds=6.0,
    batches=12,
)  # fmt: skip

# One who moves among those who stand


def place_still_behind(league: League, ball: Any, robots: Any, draw: Draw) -> None:
    """Put a mover as in dribble-past-mover-far, and a still player on the way behind where it crosses."""
    robot, (still, mover), way = start_dribble(league, ball, robots, draw, 2)
    put_at(league, robot, still, draw.between(0.95, 1.1), way + draw.between(-0.1, 0.1), draw.between(-pi, pi))
    aside = draw.side() * draw.between(0.35, 0.7)
    send_mover(league, robot, mover, draw, way, (1.1, 1.5), aside, (0.3, 0.6))


STILL_BEHIND = drill("still-behind-mover", "a mover, and a still player behind where it crosses", place_still_behind,
                     "home gets past", "still", "walker@0.5")  # fmt: skip
CLASSES: tuple[tuple[str, tuple[str | Scene, ...]], ...] = (
    ("one still", ("dribble-past-one",)),
    ("one mover", MOVING),
    ("mover, a still player behind", (STILL_BEHIND,)),
    ("mover and still, opposite sides", ("mover-and-still",)),
)
OPPOSITE = len(CLASSES) - 1


def pass_classes(batch: Batch) -> Samples:
    """Dribble in all classes; arrays (M, classes): a class of several drills is their mean."""
    plan: Plan = [(scene, {}, PAPER) for _, scenes in CLASSES for scene in scenes]
    found = play_all(batch, plan, MATCHES)
    ends = np.cumsum([0] + [len(scenes) for _, scenes in CLASSES])
    return {
        name: np.stack([values[:, a:b].mean(axis=1) for a, b in zip(ends, ends[1:], strict=False)], axis=1)
        for name, values in found.items()
    }


def best_less_next(samples: Samples) -> float:
    """Return the clean share [%] with one still player less the best of the other classes."""
    return clean(samples, "clean", 0) - max(clean(samples, "clean", i) for i in range(1, len(CLASSES)))


def others_less_opposite(samples: Samples) -> float:
    """Return the least clean share [%] of the other classes less that of mover and still on opposite sides."""
    return min(clean(samples, "clean", i) for i in range(OPPOSITE)) - clean(samples, "clean", OPPOSITE)


S64 = Claim(
    id="S64",
    paper=SACKS,
    section="4.3.4",
    statement="With stationary players besides a mover it does well much of the time, but not with one on each side.",
    method=f"{MATCHES} runs a batch in each drill of four classes: {', '.join(name for name, _ in CLASSES)}; movers at "
    f"6 cm/s. {RULES}",
    criteria=(
        measured("clean past one still player, less the best other class", best_less_next, unit="%", above=0.0),
        measured("the least other class less mover and still on opposite sides", others_less_opposite, unit="%",
                 above=0.0),
        *(reported(f"clean, {name}", partial(clean, name="clean", columns=i), unit="%")
          for i, (name, _) in enumerate(CLASSES)),
        *(reported(f"past, touched or not, {name}", partial(clean, name="past", columns=i), unit="%")
          for i, (name, _) in enumerate(CLASSES)),
    ),
    measure=pass_classes,
    ingredients=("the walker goes straight on and never gives way", "the drills' places, STILL_BEHIND here"),
    note=BODIES,
    seconds=6.0,
    batches=16,
)  # fmt: skip

S43 = Claim(
    id="S43",
    paper=SACKS,
    section="4.2",
    statement="The potential field handles moving obstacles about as well as stationary ones.",
    method=f"The runs of S64: share that touch somebody, one mover at 6 cm/s against one who stands. {RULES}",
    criteria=(
        reported("touched, one still player", lambda s: clean(s, "touched", 0), unit="%"),
        reported("touched, one mover", lambda s: clean(s, "touched", 1), unit="%"),
        reported("touched, mover less still", lambda s: clean(s, "touched", 1) - clean(s, "touched", 0), unit="%"),
    ),
    measure=pass_classes,
    ingredients=("the walker goes straight on and never gives way",),
    note="A report, for the paper gives no measure; S61 to S64 judge. The field has positions alone, no velocities.",
    seconds=6.0,
    batches=4,
)

# How often it decides


def pass_by_replan(batch: Batch) -> Samples:
    """Dribble past two still players and past a mover that starts afar: arrays (M, times), the mean of both."""
    scenes = ("dribble-past-two", "dribble-past-mover-far")
    plan: Plan = [(scene, {"replan": time}, PAPER) for scene in scenes for time in REPLANS]
    found, count = play_all(batch, plan, FEWER), len(REPLANS)
    return {name: 0.5 * (values[:, :count] + values[:, count:]) for name, values in found.items()}


def at_time(samples: Samples, *times: float) -> float:
    """Return the clean share [%] at some times between decisions."""
    return clean(samples, "clean", [REPLANS.index(time) for time in times])


def replan_figure(samples: Samples) -> Sequence[Figure]:
    """Draw the clean runs against the time between decisions."""
    curves = tuple(Curve(text, REPLANS, list(100.0 * samples[name].mean(axis=0)))
                   for name, text in (("clean", "without a touch"), ("past", "past")))  # fmt: skip
    return (Figure("Dribbling by the time between decisions", "time [s]", "runs [%]", curves),)


S52 = Claim(
    id="S52",
    paper=SACKS,
    section="4.3.2",
    statement="Half a second between recalculations suits steps that take half a second.",
    method=f"{FEWER} runs a batch past two still players and past a mover, with decisions every "
    f"{', '.join(f'{time:g}' for time in REPLANS)} s. {RULES}",
    criteria=(
        measured("clean at 0.125 and 0.25 s less clean at 0.5 s: no gain of 5 points",
                 lambda s: at_time(s, 0.125, 0.25) - at_time(s, 0.5), unit="%", at_most=5.0),
        measured("clean at 0.5 s less clean at 1 s", lambda s: at_time(s, 0.5) - at_time(s, 1.0), unit="%", above=0.0),
        reported("clean at 0.5 s", lambda s: at_time(s, 0.5), unit="%"),
        reported("clean at 0.5 s less clean at 2 s", lambda s: at_time(s, 0.5) - at_time(s, 2.0), unit="%"),
    ),
    measure=pass_by_replan,
    figures=replan_figure,
    ingredients=("gait steps of half a second: a decision takes effect when one begins",),
    note="A decision takes effect when the next gait step begins: deciding more often brings a fresher picture. "
    "A second is only two steps, 7 cm.",
    seconds=6.0,
    batches=24,
)  # fmt: skip

CLAIMS = (S43, S52, S62, S63, S64)
