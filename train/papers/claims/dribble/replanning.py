"""How often a dribbler has to decide.  [Sacks 2001, 4.3.2]"""

from collections.abc import Sequence

import numpy as np

from soccer_env.train.papers.claim import STAGED, Batch, Claim, Curve, Figure
from soccer_env.train.papers.claims.dribble.past import FEWER, RULES, Plan, outcome_share, play_two_distances
from soccer_env.train.papers.drill_runs import PAPER
from soccer_env.train.papers.verdicts import Samples, measured, reported

REPLANS = (0.125, 0.25, 0.5, 1.0, 2.0)  # [s] between two decisions; the paper's is 0.5
SCENES = ("dribble-past-two", "dribble-past-mover-far")
DEGREE = 2  # of the curve in the logarithm of the time: a rise, a fall and a bend


def compare_decision_times(batch: Batch) -> Samples:
    """Dribble past two still players, and past a mover from afar; return means of both by decision time (M, times)."""
    plan: Plan = [(scene, {"replan": time}, PAPER) for scene in SCENES for time in REPLANS]
    runs, count = play_two_distances(batch, plan, FEWER), len(REPLANS)
    return {name: 0.5 * (values[:, :count] + values[:, count:]) for name, values in runs.items()}


def fitted_clean_share(samples: Samples, *times: float, name: str = "clean") -> float:
    """Return the mean clean share [%] at the given decision intervals, on the curve fitted over all intervals."""
    curve = np.polyfit(np.log2(REPLANS), 100.0 * samples[name].mean(axis=0), DEGREE)
    return float(np.polyval(curve, np.log2(times)).mean())


def fast_decisions_gain(samples: Samples, name: str = "clean") -> float:
    """Return the fitted share [%] at decision intervals of 1/8 and 1/4 s (mean) minus the fitted share at 1/2 s."""
    return fitted_clean_share(samples, 0.125, 0.25, name=name) - fitted_clean_share(samples, 0.5, name=name)


def half_second_gain(samples: Samples, name: str = "clean") -> float:
    """Return the fitted share [%] at a decision interval of 1/2 s minus the fitted share at 1 s."""
    return fitted_clean_share(samples, 0.5, name=name) - fitted_clean_share(samples, 1.0, name=name)


def replan_figure(samples: Samples) -> Sequence[Figure]:
    """Plot the shares of runs by outcome against the time between decisions, and the fitted curve."""
    curves = [
        Curve(text, REPLANS, list(100.0 * samples[name].mean(axis=0)))
        for name, text in (("clean", "without a touch"), ("past", "past"), ("middle clean", "from the middle"))
    ]
    times = np.geomspace(REPLANS[0], REPLANS[-1], 33)
    curves.append(Curve("without a touch, curve", list(times), [fitted_clean_share(samples, time) for time in times]))
    return (Figure("Dribbling by the time between decisions", "time [s]", "runs [%]", tuple(curves)),)


S52 = Claim(
    id="S52",
    section="4.3.2",
    statement="Half a second between recalculations suits steps that take half a second.",
    method=f"{FEWER} runs a batch past two still players and past a mover, with decisions every "
    f"{', '.join(f'{time:g}' for time in REPLANS)} s; a curve of degree {DEGREE} in the logarithm of the time is "
    f"fitted to the clean share. {RULES}",
    criteria=(
        measured("curve at 0.125 and 0.25 s less at 0.5 s: no gain of 5 points", fast_decisions_gain, unit="%",
                 at_most=5.0),
        measured("curve at 0.5 s less at 1 s", half_second_gain, unit="%", above=0.0),
        *(reported(f"clean at {time:g} s", outcome_share, "clean", REPLANS.index(time), unit="%")
          for time in REPLANS),
        reported("from the middle: curve at 0.125 and 0.25 s less at 0.5 s", fast_decisions_gain, "middle clean",
                 unit="%"),
        reported("from the middle: curve at 0.5 s less at 1 s", half_second_gain, "middle clean", unit="%"),
    ),
    rules=STAGED,
    measure=compare_decision_times,
    figures=replan_figure,
    ingredients=("gait steps of half a second: a decision takes effect when one begins",),
    note="A decision takes effect when the next gait step begins: deciding more often brings a fresher picture. "
    "A second is only two steps, 7 cm.",
    seconds=8.0,
    batches=7,
)  # fmt: skip
