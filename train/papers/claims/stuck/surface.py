"""S22 and S23 over the two constants of the stuck counters that the paper does not tell.  [Sacks 2001, 3.3]

Each sentence is judged at the setting that suits it best. That setting is chosen on one half of the runs and judged on
the other, and the other way round: no run is judged at a setting that it helped to choose.
"""

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.train.evaluate.report import table
from soccer_env.train.papers.claim import PLAYED_AND_STAGED, STAGED, Batch, claim, shared
from soccer_env.train.papers.claims.stuck.branches import count_hits, follow_moments
from soccer_env.train.papers.claims.stuck.detection import FARTHEST, NEAREST, TRIES, WALK, approach, latencies
from soccer_env.train.papers.plots import plot, plots
from soccer_env.train.papers.values import percent
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

COUNTS = (4, 5, 7, 9)  # [readings] thresholds of the first counter
TIMES = (4.0, 5.0, 6.0, 8.0)  # [s] of the second counter
TEAM = COUNTS.index(SacksSettings().stuck_count), TIMES.index(SacksSettings().near_time)  # the team's own setting
MIDDLE = 0.6  # [m] greatest distance of a ball that is near, assumed
FEW, LATE = 5.0, 8.0  # [s] "a few seconds", for near balls and for all, assumed
PLAY_TIMES = {"5 s": FEW, "20 s": 20.0}  # [s] in which robots held in play may notice
# Bounds [%] by sentence: "almost always", "infrequently"; "often", and five times fewer
NOTICED, NOTICED_LATE, FALSE, OFTEN, FEWER = 95.0, 90.0, 5.0, 5.0, 5.0
COUNTED = ("near", "near soon", "all", "all late", "one", "two", "approaches")
SETTINGS_TEXT = (
    f"Thresholds of {', '.join(map(str, COUNTS))} readings and {', '.join(f'{t:g}' for t in TIMES)} s near the ball, "
    f"for the paper tells neither. {TRIES} robots a batch and setting walk to a still ball for {WALK:g} s and are then "
    f"held, the ball {100 * NEAREST:.0f} to {100 * FARTHEST:.0f} cm from the camera; as many approach a still ball 40 "
    "to 90 cm away in any direction, nothing in the way: a recovery is a false alarm. Judged at the setting that suits "
    "the sentence best, chosen on the other half of the runs"
)


@shared("stuck settings", rules=STAGED)
def measure_settings(batch: Batch) -> Samples:
    """Return counts (M, thresholds, times) of held robots that notice in time, and of false alarms with two counters.

    "one": false alarms with one counter, for which the time near the ball does not count; "half" (M,): 0 or 1.
    """
    shape = (TRIES, len(COUNTS), len(TIMES))
    found = {name: np.zeros(shape) for name in COUNTED}
    found["approaches"] += 1.0
    for i, count in enumerate(COUNTS):
        found["one"][:, i] = approach(batch, rolls=False, stuck_count=count, two_counters=False)[:, None]
        for j, time in enumerate(TIMES):
            found["two"][:, i, j] = approach(batch, rolls=False, stuck_count=count, near_time=time)
            distance, after = (one[:TRIES] for one in latencies(batch, stuck_count=count, near_time=time))
            held = ~np.isnan(after) & (distance >= NEAREST) & (distance < FARTHEST)
            found["all"][:, i, j], found["all late"][:, i, j] = held, held & (after <= LATE)
            near = held & (distance < MIDDLE)
            found["near"][:, i, j], found["near soon"][:, i, j] = near, near & (after <= FEW)
    return found | {"half": np.arange(TRIES) % 2}


def shares(samples: Samples, hits: str, trials: str, rows: np.ndarray | slice = slice(None)) -> np.ndarray:
    """Return the share [%] of hits among trials at each setting (thresholds, times)."""
    return np.asarray(100.0 * samples[hits][rows].sum(axis=0) / np.maximum(samples[trials][rows].sum(axis=0), 1.0))


def fit_of_s22(samples: Samples, rows: np.ndarray | slice = slice(None)) -> np.ndarray:
    """Return the least of all shares over their bounds at each setting, 1 or more where S22's sentence holds."""
    quiet = (100.0 - shares(samples, "two", "approaches", rows)) / (100.0 - FALSE)
    soon, late = (shares(samples, *names, rows) for names in (("near soon", "near"), ("all late", "all")))
    fit: np.ndarray = np.minimum(quiet, np.minimum(soon / NOTICED, late / NOTICED_LATE))
    return fit


def fit_of_s23(samples: Samples, rows: np.ndarray | slice = slice(None)) -> np.ndarray:
    """Return the lesser of the alarms with one counter and of the ratio, over their bounds, at each setting."""
    one, two = (samples[name][rows].sum(axis=0) for name in ("one", "two"))
    ratio = one / np.maximum(two, 0.5)
    fit: np.ndarray = np.minimum(shares(samples, "one", "approaches", rows) / OFTEN, ratio / FEWER)
    return fit


FITS = {"S22": fit_of_s22, "S23": fit_of_s23}


def at_best_setting(samples: Samples, claim: str, names: Sequence[str] = COUNTED) -> Samples:
    """Return each run's counts (M,) `names` at the setting that suits a claim best in the other half of the runs."""
    chosen = {name: np.zeros(len(samples["half"])) for name in names}
    for half in (0, 1):
        mine, others = samples["half"] == half, samples["half"] != half
        i, j = np.unravel_index(int(FITS[claim](samples, others).argmax()), (len(COUNTS), len(TIMES)))
        for name in names:
            chosen[name][mine] = samples[name][mine, i, j]
    return chosen


def alarm_ratio(samples: Samples) -> float:
    """Return the number of alarms with one counter over that with two (at least half an alarm) at the best setting."""
    chosen = at_best_setting(samples, "S23", ("one", "two"))
    one, two = chosen["one"].sum(), chosen["two"].sum()
    return float(one / max(two, 0.5)) if one + two > 0.0 else float("nan")


def settings_that_hold(samples: Samples, *claims: str) -> float:
    """Return at how many settings the sentences of all these claims hold, by their point estimates."""
    return float(np.logical_and.reduce([FITS[claim](samples) >= 1.0 for claim in claims]).sum())


def surface_table(samples: Samples) -> str:
    """Return the surface as a table: a row for each setting."""
    columns = {
        "noticed within 5 s": ("near soon", "near"), "within 8 s": ("all late", "all"),
        "false alarms, one counter": ("one", "approaches"), "two": ("two", "approaches"),
    }  # fmt: skip
    found = [shares(samples, *names) for names in columns.values()]
    holds = {claim: fit(samples) >= 1.0 for claim, fit in FITS.items()}
    rows = [
        (f"{count} readings, {time:g} s", *(f"{one[i, j]:.1f} %" for one in found),
         ", ".join(claim for claim in FITS if holds[claim][i, j]) or "none")
        for i, count in enumerate(COUNTS) for j, time in enumerate(TIMES)
    ]  # fmt: skip
    return table(("setting", *columns, "sentences that hold"), rows)


def by_time(hits: str, trials: str, i: int) -> Callable[[Samples], Sequence[float]]:
    """Return a function of samples that gives a share [%] at each time near the ball, with the threshold COUNTS[i]."""
    return lambda samples: list(shares(samples, hits, trials)[i])


surface_figures = plots(
    plot("Held robots that notice within 5 s", "time near the ball [s]", "robots [%]", TIMES,
         {f"{count} readings": by_time("near soon", "near", i) for i, count in enumerate(COUNTS)}, rules=(NOTICED,)),
    plot("False alarms", "time near the ball [s]", "approaches [%]", TIMES,
         {f"{count} readings, {word}": by_time(name, "approaches", i) for i, count in enumerate(COUNTS)
          for name, word in (("one", "one counter"), ("two", "two"))}, rules=(FALSE,)),
)  # fmt: skip


def measure_with_play(batch: Batch) -> Samples:
    """Return `measure_settings`, and counts (M,) of robots held in play that notice by the team's own setting."""
    fate = follow_moments(batch, recovery=True)
    counts: Samples = {}
    for name, seconds in PLAY_TIMES.items():
        pair = count_hits(fate, lambda f, limit=seconds: f["began"] <= limit)  # type: ignore[misc]
        counts |= {f"{word} {name}": np.concatenate([one, np.zeros(TRIES - len(one))])
                   for word, one in zip(("robots", "known"), pair, strict=True)}  # fmt: skip
    return measure_settings(batch) | counts


SAME = reported("settings of 16 at which both S22 and S23 hold", settings_that_hold, "S22", "S23")

S22 = claim(
    "S22", "3.3", "Robots almost always notice within a few seconds that they are stuck.",
    f"{SETTINGS_TEXT}. Beside it robots that others hold in 3 v 3 play (contact, a quarter of the way that "
    "their legs walk for 1.5 s).",
    counted("ball at 20 to 60 cm: noticed within 5 s", "near soon", "near", partial(at_best_setting, claim="S22"),
            at_least=NOTICED),
    counted("ball at 20 to 80 cm: noticed within 8 s", "all late", "all", partial(at_best_setting, claim="S22"),
            at_least=NOTICED_LATE),
    counted("approaches that nothing stops: false alarms", "two", "approaches",
            partial(at_best_setting, claim="S22"), at_most=FALSE),
    SAME,
    *(reported(f"held in play, 9 readings and 8 s: noticed within {name}", percent, f"known {name}",
               f"robots {name}", unit="%") for name in PLAY_TIMES),
    rules=PLAYED_AND_STAGED, measure=measure_with_play, condition="at a setting that the paper does not tell",
    figures=surface_figures, batches=12, seconds=12.0,
    ingredients=("near_zero and clearly: assumed", "a held robot sees the ball throughout"),
    note=surface_table,
)  # fmt: skip

S23 = claim(
    "S23", "3.3", "One counter often raises false alarms near the ball; the second remedies this.",
    f"{SETTINGS_TEXT}; with one counter and with two.",
    counted("one counter: approaches with a false alarm", "one", "approaches",
            partial(at_best_setting, claim="S23"), at_least=OFTEN),
    measured("alarms with one counter over those with two", alarm_ratio, at_least=FEWER),
    SAME,
    measure=measure_settings, condition="at a setting that the paper does not tell", figures=surface_figures,
    batches=12, seconds=12.0,
    ingredients=("near_step 0.25, near_zero and clearly: assumed",),
    note=surface_table,
)  # fmt: skip
