"""How a stuck robot gets free: steps back, then aside or round, then to the ball again.  [Sacks 2001, 3.4]"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import PLAYED_AND_STAGED, Ablation, Batch, claim
from soccer_env.train.papers.claims.stuck.branches import FUTURE, count_hits, follow_moments
from soccer_env.train.papers.claims.stuck.sampled import MATCHES, SECONDS
from soccer_env.train.papers.plots import columns, plot, plot_shares
from soccer_env.train.papers.values import mean, percent
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

BACK_STEPS = (2, 5, 10, 15)  # S26
BACK_PACE = 0.10 / 0.12  # [1] of the top speeds back and ahead: S26
AGAIN = 5.0  # [s] "immediately", assumed: S26
CLEAR = 10.0  # [s] after a recovery without being held again that count as clear, assumed: S27
FREE = 10.0  # [s] for a robot to get free: S29
FEW = 3  # tries: S29
QUICK: dict[str, Any] = {"stuck_count": 5, "near_time": 1.0}  # readings, [s]: with these most notice soon: S29
SCENE = (
    f"Robots that others hold on their way to the ball (contact, a quarter of the way that their legs walk for 1.5 s) "
    f"in 3 v 3 play, {MATCHES} matches a batch of {SECONDS:g} s; from there on they recover at once, as if they had "
    "noticed, "
)
HELD = "who holds it goes on playing: sacks-2001 without recovery"


def measure_held_again(batch: Batch, way_back: bool = False) -> Samples:
    """Tell which robots are held again within AGAIN after a recovery, by number of steps back (M, moments, numbers).

    `way_back`: subtract the time to walk these steps forward again.
    """
    columns = []
    for steps in BACK_STEPS:
        fate = follow_moments(batch, begun=True, back_steps=steps)
        after = fate["again"] - fate["over"] - (0.5 * steps * BACK_PACE if way_back else 0.0)
        columns.append(np.where(np.isfinite(fate["over"]), (after <= AGAIN).astype(float), np.nan))
    return {"again": np.stack(columns, axis=-1)}


held_again = columns("again")  # [%] for each number of steps back


def ten_steps_ratio(samples: Samples) -> float:
    """Return the share held again after 10 steps back over the mean share after 2 and 5; NaN: no robot is held."""
    two, five, ten, _ = held_again(samples)
    return ten / (0.5 * (two + five)) if two + five > 0.0 else float("nan")


S26 = claim(
    "S26", "3.4", "Ten steps back exceed the need, but prevent getting stuck again at once.",
    SCENE + f"with {', '.join(map(str, BACK_STEPS))} steps back: who is held again within {AGAIN:g} s after the "
    "recovery.",
    measured("held again after 10 steps over the mean of 2 and 5", ten_steps_ratio, at_most=0.5),
    rules=PLAYED_AND_STAGED, measure=measure_held_again,
    figures=plot("Held again after a recovery", "steps back", "robots [%]", BACK_STEPS,
                 {"held again within 5 s": held_again}),
    least=4, batches=24, seconds=4.0,
    without=Ablation("the way back counted in the five seconds, as here it is not",
                     partial(measure_held_again, way_back=True)),
    ingredients=(HELD, "side_steps 5: assumed"),
)  # fmt: skip


def compare_sides(batch: Batch) -> Samples:
    """Return the misalignment of robot and ball [deg] (M, moments of a recovery) and the number of clear paths (M,),
    for the side that the player chose and, in keys that end in " either", for a random side.
    """
    samples: Samples = {}
    for word, drawn in (("", False), (" either", True)):
        fate = follow_moments(batch, begun=True, random_sides=drawn)
        there = np.isfinite(fate["aside"])
        aside, clear = count_hits(
            {**fate, "stepped": there.astype(float)},
            lambda f: ~(f["again"] - f["over"] <= CLEAR) & np.isfinite(f["over"]), stepped=1.0,
        )  # fmt: skip
        samples |= {f"aside{word}": aside, f"clear{word}": clear}
        samples |= {f"{time}{word}": np.where(there, fate[time], np.nan) for time in ("before", "after")}
        samples[f"at ball{word}"] = np.where(there & (fate["got"] >= fate["over"]), fate["at ball"], np.nan)
    return samples


def misalignment_change(samples: Samples, until: str = "at ball") -> float:
    """Return the mean change [deg] of the misalignment from before a recovery until the ball, or until "after" it."""
    return mean(samples[until] - samples["before"])


S27 = claim(
    "S27", "3.4", "The sidestep does not always clear the obstacle, but positions the robot to shoot.",
    SCENE + f"those that step aside: who is not held again within {CLEAR:g} s after the recovery has cleared "
    "the way. Angle between the ways from robot to ball and from ball to goal, before and when the robot has the ball; "
    "beside it a side drawn at random, and the angle right after the recovery.",
    counted("cleared the obstacle", "clear", "aside", at_least=50.0, at_most=95.0),
    measured("change of the misalignment until the robot has the ball", misalignment_change, unit="deg", below=0.0),
    measured("misalignment when it has the ball, less that with a random side",
             lambda s: mean(s["at ball"] - s["at ball either"]), unit="deg", below=0.0),
    reported("cleared with a random side", percent, "clear either", "aside either", unit="%"),
    reported("change of the misalignment by the recovery alone", partial(misalignment_change, until="after"),
             unit="deg"),
    reported("misalignment right after it, less that with a random side",
             lambda s: mean(s["after"]) - mean(s["after either"]), unit="deg"),
    rules=PLAYED_AND_STAGED, measure=compare_sides, least=4, batches=12, seconds=3.0,
    ingredients=(HELD, "side_steps 5: assumed"),
    note="The paper speaks of the moment at which the robot reaches the ball. Right after the recovery a robot is "
    "placed worse than before: while it retreats the others take the ball elsewhere.",
)  # fmt: skip


def compare_recoveries(batch: Batch) -> Samples:
    """Return fates of held robots (M, moments) that recover at once, when they notice, not at all, or by QUICK."""
    samples: Samples = {}
    variants = {"begun": follow_moments(batch, begun=True), "on": follow_moments(batch, recovery=True),
                "off": follow_moments(batch, recovery=False), "quick": follow_moments(batch, **QUICK)}  # fmt: skip
    for word, fate in variants.items():
        there = np.isfinite(fate["near"])
        for name in ("freed", "got"):
            samples[f"{name} {word}"] = np.where(there, np.nan_to_num(fate[name], nan=np.inf), np.nan)
        samples[f"goals {word}"], samples[f"tries {word}"] = fate["goals"], fate["tries"]
    few_tries = count_hits(variants["begun"], lambda f: np.isfinite(f["freed"]) & (f["tries"] <= FEW))
    samples["one"], samples["few"] = few_tries
    return samples


def share_within(samples: Samples, name: str, seconds: float) -> float:
    """Return the share [%] of robots that are free, or have the ball, within `seconds`."""
    times = samples[name]
    return 100.0 * mean(np.where(np.isnan(times), np.nan, times <= seconds))


def recovery_gain(samples: Samples, name: str = "freed", word: str = "begun") -> float:
    """Return the share of robots free, or with the ball, with a recovery minus the share without a recovery [pp]."""
    seconds = FREE if name == "freed" else FUTURE
    return share_within(samples, f"{name} {word}", seconds) - share_within(samples, f"{name} off", seconds)


def repeated_recovery_share(samples: Samples) -> float:
    """Return the share [%] of robots that begin more than one recovery before they have the ball."""
    tries = samples["tries begun"]
    return 100.0 * mean(np.where(np.isnan(tries), np.nan, tries > 1.0))


S29 = claim(
    "S29", "3.4", "The recovery seems relatively effective, though it sometimes takes a few tries.",
    SCENE + "or push on: free is who walks as asked for 1 s, not recovering and in contact with nobody, or has "
    f"the ball alone. Beside it the same when they notice by themselves, and the ball got within {FUTURE:g} s.",
    counted("free after at most three tries", "few", "one", at_least=90.0),
    measured("cases that take more than one try, until it has the ball", repeated_recovery_share, unit="%",
             at_least=5.0),
    measured("free within 10 s: recovering less pushing on", recovery_gain, unit="pp", above=0.0),
    reported("noticing after 5 readings and 1 s near the ball: free within 10 s, less pushing on",
             partial(recovery_gain, word="quick"), unit="pp"),
    reported("the same: ball got, less pushing on", recovery_gain, "got", "quick", unit="pp"),
    rules=PLAYED_AND_STAGED, measure=compare_recoveries, condition="where the recovery is begun for the robot",
    figures=plot_shares("Robots held in play: free by when", "time [s]", "robots [%]", np.linspace(0.0, FUTURE, 49),
                        {"recover at once": "freed begun", "recover when they notice": "freed on",
                         "push on": "freed off"}),
    least=4, batches=24, seconds=3.0,
    ingredients=(HELD, "side_steps 5: assumed"),
    note="A robot that backs off comes free more often than one that pushes on, but gets the ball no more often: "
    "others are there first while it is away. When it has to notice by itself nothing is gained in 10 s, for a sixth "
    "only notices within 5 s; with thresholds of 5 readings and 1 s it comes free more often too.",
)  # fmt: skip
