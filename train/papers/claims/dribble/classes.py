"""Dribbling past a mover among standing players, by class of situation.  [Sacks 2001, 4.2, 4.3.4]"""

from math import pi
from typing import Any

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.scenes import Scene
from soccer_env.scenes.drills_legged import legged_drill, put_at_distance, send_mover, start_dribble
from soccer_env.scenes.scene import SceneRandom
from soccer_env.train.papers.claim import Batch, Claim
from soccer_env.train.papers.claims.dribble.past import BODIES, MATCHES, MOVING, RULES, Plan, outcome_share, play_all
from soccer_env.train.papers.dribble_runs import PAPER
from soccer_env.train.papers.verdicts import Samples, measured, reported


def place_still_behind(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place a mover as in dribble-past-mover-far, and a still player on the path beyond the mover's crossing."""
    robot, (still, mover), way = start_dribble(league, ball, robots, draw, 2)
    put_at_distance(league, robot, still, draw.between(0.95, 1.1), way + draw.between(-0.1, 0.1), draw.between(-pi, pi))
    aside = draw.side() * draw.between(0.35, 0.7)
    send_mover(league, robot, mover, draw, way, (1.1, 1.5), aside, (0.3, 0.6))


STILL_BEHIND = legged_drill("still-behind-mover", "a mover, and a still player behind where it crosses",
    place_still_behind,
                     "home gets past", "still", "walker@0.5")  # fmt: skip
CLASSES: tuple[tuple[str, tuple[str | Scene, ...]], ...] = (
    ("one still", ("dribble-past-one",)),
    ("one mover", MOVING),
    ("mover, a still player behind", (STILL_BEHIND,)),
    ("mover and still, opposite sides", ("mover-and-still",)),
)
AS_WELL = 10.0  # [pp] more touches that are "about as well", assumed
OPPOSITE = len(CLASSES) - 1


def dribble_past_classes(batch: Batch) -> Samples:
    """Dribble in all classes; return means over each class's drills (M, classes), named as in `play_drill`."""
    plan: Plan = [(scene, {}, PAPER) for _, scenes in CLASSES for scene in scenes]
    runs = play_all(batch, plan, MATCHES)
    ends = np.cumsum([0] + [len(scenes) for _, scenes in CLASSES])
    return {
        name: np.stack([values[:, a:b].mean(axis=1) for a, b in zip(ends, ends[1:], strict=False)], axis=1)
        for name, values in runs.items()
    }


def still_player_advantage(samples: Samples) -> float:
    """Return the clean share [%] with one still player minus the best clean share of the other classes."""
    return outcome_share(samples, "clean", 0) - max(outcome_share(samples, "clean", i) for i in range(1, len(CLASSES)))


def opposite_sides_disadvantage(samples: Samples) -> float:
    """Return the smallest clean share [%] of the other classes minus the share with players on opposite sides."""
    others = min(outcome_share(samples, "clean", i) for i in range(OPPOSITE))
    return others - outcome_share(samples, "clean", OPPOSITE)


S64 = Claim(
    id="S64", section="4.3.4",
    statement="A mover and stationary players are mostly avoided well, but not one on each side.",
    method=f"{MATCHES} runs a batch in each drill of four classes: {', '.join(name for name, _ in CLASSES)}; movers at "
    f"6 cm/s. {RULES}",
    criteria=(
        measured("clean past one still player, less the best other class", still_player_advantage, unit="%", above=0.0),
        measured("the least other class less mover and still on opposite sides", opposite_sides_disadvantage, unit="%",
                 above=0.0),
        *(reported(f"clean, {name}", outcome_share, "clean", i, unit="%") for i, (name, _) in enumerate(CLASSES)),
        *(reported(f"past without a contact that stopped it or turned somebody, {name}", outcome_share, "free", i,
                   unit="%") for i, (name, _) in enumerate(CLASSES)),
        *(reported(f"past, touched or not, {name}", outcome_share, "past", i, unit="%")
          for i, (name, _) in enumerate(CLASSES)),
    ),
    measure=dribble_past_classes, batches=6, seconds=8.0,
    ingredients=("the walker goes straight on and never gives way", "the drills' places, STILL_BEHIND here"),
    note=BODIES,
)  # fmt: skip

S43 = Claim(
    id="S43", section="4.2",
    statement="The potential field handles moving obstacles about as well as stationary ones.",
    method="The runs of S64: share that touch somebody, one mover at 6 cm/s against one who stands. \"About as well\" "
    f"is read as {AS_WELL:g} points more at most. {RULES}",
    criteria=(
        measured("touched, one mover less one who stands",
                 lambda s: outcome_share(s, "touched", 1) - outcome_share(s, "touched", 0), unit="pp", at_most=AS_WELL),
        *(reported(f"touched, {text}", outcome_share, "touched", i, unit="%")
          for i, text in ((0, "one still player"), (1, "one mover"))),
    ),
    measure=dribble_past_classes, batches=6, seconds=8.0,
    ingredients=("the walker goes straight on and never gives way",),
    note="The field has positions alone, no velocities.",
)  # fmt: skip
