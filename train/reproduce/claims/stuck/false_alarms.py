"""When a robot believes that it is stuck and is not.  [Sacks 2001, 3.3]"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import BACK
from soccer_env.match import Match
from soccer_env.staging import memory_of
from soccer_env.train.reproduce.claim import SACKS, Batch, Claim, Curve, Figure
from soccer_env.train.reproduce.claims.stuck.detection import NEAR, latencies
from soccer_env.train.reproduce.claims.stuck.runs import recovers, seekers
from soccer_env.train.reproduce.staging import ahead_of, ball_from, begin, kick_off, play, put, put_ball
from soccer_env.train.reproduce.values import least_rise, mean
from soccer_env.train.reproduce.verdicts import Samples, counted, measured, reported

COUNTS = (3, 6, 9, 12, 15)  # thresholds, S25
SHORT = 0.25  # [1] share of a full step near the ball, beside the assumed one
ROLLS = (0.1, 0.5)  # [m/s] of a ball that rolls
TRIES, TIME = 48, 20.0  # approaches of each kind a batch, [s] of each at most
MATCHES, PLAY_TIME = 16, 60.0  # of 3 v 3, [s]
CAUSES = ("receding", "turning", "near", "other")
BEFORE = 3.0  # [s] before an alarm that tell its cause
FREE = 0.5  # [1] of that time in contact with somebody, below which nobody stopped the robot
AWAY = 0.01  # [m/s] of the ball
ASIDE = 0.3  # [rad] off its bearing
SLOWLY = 0.2  # [rad/s] of the turn


def approach(batch: Batch, rolls: bool, **settings: Any) -> np.ndarray:
    """Let robots that nothing stops go to a ball anywhere round them; return who (M,) gave a false alarm.

    An alarm is a recovery that begins before the robot has the ball.
    """
    rng = batch.rng(1)
    match = seekers(batch, TRIES, **settings)
    put(match, 0, 0.0, 0.0, rng.uniform(-np.pi, np.pi, TRIES))
    angle, speed = rng.uniform(-np.pi, np.pi, TRIES), rng.uniform(*ROLLS, TRIES) * float(rolls)
    place = ahead_of(match, 0, rng.uniform(0.4, 0.9, TRIES), rng.uniform(-np.pi, np.pi, TRIES))
    put_ball(match, *place, speed * np.cos(angle), speed * np.sin(angle))
    begin(match, placed=True)
    alarms, over = np.zeros(TRIES), np.zeros(TRIES, bool)
    for _ in play(match, TIME):
        alarms[recovers(match) & ~over] = 1.0
        over |= recovers(match) | (match.robots["has_ball"][:, 0] == 1)
        if over.all():
            break
    match.close()
    return alarms


def one_and_two(batch: Batch) -> Samples:
    """Return false alarms with one counter and with two, in approaches to a still ball (M,)."""
    found = {}
    for n in (1, 2):
        found[f"counters {n}"] = approach(batch, rolls=False, two_counters=n == 2)
        found[f"short {n}"] = approach(batch, rolls=False, two_counters=n == 2, near_step=SHORT)
    return {**found, "approaches": np.ones(TRIES)}


def fewer(samples: Samples, name: str) -> float:
    """Return how many times fewer alarms there are with two counters; half an alarm stands for none; NaN: no alarm."""
    one, two = samples[f"{name} 1"].sum(), samples[f"{name} 2"].sum()
    return float(one / max(two, 0.5)) if one + two > 0.0 else float("nan")


S23 = Claim(
    id="S23",
    paper=SACKS,
    section="3.3",
    statement="With one counter robots would often think they were stuck when they were about to reach the ball; the "
    "second counter, of time within 35 cm, remedies this.",
    method=f"{TRIES} approaches a batch to a still ball 40 to 90 cm away in any direction, nothing in the way, with "
    "one counter and with two: a recovery that begins is a false alarm.",
    criteria=(
        counted("one counter: approaches with a false alarm (often)", "counters 1", "approaches", at_least=5.0),
        measured("alarms with one counter over those with two", lambda s: fewer(s, "counters"), at_least=5.0),
        reported("two counters: alarms in 100 approaches", lambda s: 100 * mean(s["counters 2"])),
        reported("steps cut to a quarter, one counter: alarms in 100 approaches", lambda s: 100 * mean(s["short 1"])),
        reported("steps cut to a quarter, two counters: alarms in 100 approaches", lambda s: 100 * mean(s["short 2"])),
        reported("steps cut to a quarter: alarms with one counter over those with two", lambda s: fewer(s, "short")),
    ),
    measure=one_and_two,
    ingredients=("near_step 0.9 and near_time 8 s: assumed",),
    note="The paper does not say how short its steps became. With near_step 0.9 the ball's velocity does not drop to "
    "near zero on the last 20 cm, and one counter gives next to no alarms; with steps cut to a quarter it does.",
    seconds=2.0,
    batches=16,
)


def signs_of(match: Match, r: int) -> np.ndarray:
    """Return the ball's own speed away from robot r [m/s], |bearing| [rad], |turn| [rad/s], distance [m]: (4, M)."""
    distance, bearing = ball_from(match, r)
    angle = match.robots["heading"][:, r] + bearing
    away = match.balls["vx"] * np.cos(angle) + match.balls["vy"] * np.sin(angle)
    return np.stack([away, np.abs(bearing), np.abs(match.robots["omega"][:, r]), distance])


def cause_of(signs: np.ndarray) -> int:
    """Return the index of an alarm's cause, from the mean signs (4,) before it."""
    away, bearing, turn, distance = signs
    tests = (away > AWAY, bearing > ASIDE or turn > SLOWLY, distance < NEAR, True)
    return tests.index(True)


def alarms_in_play(batch: Batch) -> tuple[np.ndarray, np.ndarray]:
    """Return false alarms of 3 v 3 by cause (M, causes), and all recoveries (M,)."""
    match = kick_off(batch, matches=MATCHES, team="sacks-2001")
    count, rows = match.robots.shape[1], round(BEFORE * match.league.control_rate)
    found, recoveries = np.zeros((MATCHES, len(CAUSES))), np.zeros(MATCHES)
    signs: list[np.ndarray] = []
    contact: list[np.ndarray] = []
    before = np.zeros((MATCHES, count), bool)
    for _ in play(match, PLAY_TIME):
        signs = [*signs[1 - rows :], np.stack([signs_of(match, r) for r in range(count)], axis=-1)]
        contact = [*contact[1 - rows :], match.robot_events["collision"] == 1]
        behaviour = np.stack([memory_of(match, r)["behaviour"] for r in range(count)], axis=1)
        begins, before = (behaviour == BACK) & ~before, behaviour == BACK
        recoveries += begins.sum(axis=1)
        for m, r in np.argwhere(begins & (np.mean(contact, axis=0) < FREE)):
            found[m, cause_of(np.mean([sign[:, m, r] for sign in signs], axis=0))] += 1.0
    match.close()
    return found, recoveries


def causes(batch: Batch) -> Samples:
    """Return false alarms of play by cause (M, causes), recoveries (M,), and alarms in approaches by group (M,)."""
    found, recoveries = alarms_in_play(batch)
    alarms = approach(batch, rolls=False).reshape(MATCHES, -1)
    samples = {"causes": found, "recoveries": recoveries, "false": alarms.sum(axis=1)}
    samples |= {"usual": found[:, :2].sum(axis=1), "alarms": found.sum(axis=1)}
    return {**samples, "approaches": np.full(MATCHES, float(alarms.shape[1]))}


def by_cause(samples: Samples) -> np.ndarray:
    """Return the shares [%] of the causes in all false alarms of play."""
    total = samples["causes"].sum()
    found: np.ndarray = 100.0 * samples["causes"].sum(axis=0) / total if total else np.full(len(CAUSES), np.nan)
    return found


def share_of(samples: Samples, cause: int) -> float:
    """Return the share [%] of one cause."""
    return float(by_cause(samples)[cause])


S24 = Claim(
    id="S24",
    paper=SACKS,
    section="3.3",
    statement="Robots sometimes believe they are stuck when they are not, usually when the ball is moving away or when "
    "they are turning slowly toward the ball; this happens infrequently.",
    method=f"{MATCHES} matches a batch of 3 v 3, {PLAY_TIME:g} s each: recoveries of robots that touched nobody for "
    f"most of the {BEFORE:g} s before are false alarms; their cause by that time: the ball moved away, else the "
    "robot turned or had the ball aside, else the ball was nearer than 35 cm, else none of these. Ordinary approaches: "
    f"{TRIES} a batch to a still ball 40 to 90 cm away in any direction, nothing in the way.",
    criteria=(
        counted("ordinary approaches with a false alarm", "false", "approaches", at_most=5.0),
        counted(
            "false alarms in play while the ball recedes or the robot turns (usually)", "usual", "alarms", at_least=50.0
        ),
        measured(
            "share of the false alarms in play: the lesser of the two causes less the greater of the others",
            lambda s: float(by_cause(s)[:2].min() - by_cause(s)[2:].max()),
            unit="%",
            above=0.0,
        ),
        *(
            reported(f"false alarms in play: {name}", partial(share_of, cause=i), unit="%")
            for i, name in enumerate(CAUSES)
        ),
        reported("recoveries in play, a minute and match", lambda s: mean(s["recoveries"]) * 60.0 / PLAY_TIME),
        reported("false alarms in play, in all", lambda s: float(s["alarms"].sum())),
        reported(
            "recoveries that are false alarms",
            lambda s: 100.0 * s["causes"].sum() / max(s["recoveries"].sum(), 1.0),
            unit="%",
        ),
    ),
    measure=causes,
    ingredients=("stuck_count, near_zero, clearly, near_time: assumed",),
    note="In play false alarms are not rare: counters go on while the ball flickers or is hidden for a moment, and "
    "about a quarter of the recoveries come to robots that touched nobody.",
    seconds=4.5,
    batches=16,
    least=12,
)


def sweep(batch: Batch) -> Samples:
    """Return latencies of held robots [s] and false alarms of free ones at each threshold (M, thresholds)."""
    delay, false = [], []
    for count in COUNTS:
        distance, after = latencies(batch, stuck_count=count)
        far = (distance >= NEAR) & np.isfinite(after)
        delay.append(np.where(far, after, np.nan)[:TRIES])
        false.append(0.5 * sum(approach(batch, rolls, stuck_count=count) for rolls in (False, True)))
    return {"delay": np.stack(delay, axis=1), "false": np.stack(false, axis=1)}


def delays(samples: Samples) -> list[float]:
    """Return the mean latency [s] at each threshold."""
    return [mean(samples["delay"][:, i]) for i in range(len(COUNTS))]


def falses(samples: Samples) -> list[float]:
    """Return the false alarms in 100 approaches at each threshold."""
    return [100.0 * mean(samples["false"][:, i]) for i in range(len(COUNTS))]


def sweep_figure(samples: Samples) -> Sequence[Figure]:
    """Draw both against the threshold."""
    delay = Curve("held robots", COUNTS, delays(samples))
    false = Curve("free robots", COUNTS, falses(samples))
    return (
        Figure("Delay by threshold", "threshold [readings]", "mean time until noticed [s]", (delay,)),
        Figure("False alarms by threshold", "threshold [readings]", "false alarms in 100 approaches", (false,)),
    )


S25 = Claim(
    id="S25",
    paper=SACKS,
    section="3.3",
    statement="Raising the thresholds would prevent false alarms, but mean longer delays until a collision is known.",
    method=f"Thresholds of {', '.join(map(str, COUNTS))} readings: held robots as in S22, {TRIES} a batch, the ball at "
    f"35 to 80 cm, and {2 * TRIES} approaches to a ball 40 to 90 cm away in any direction, half of them to one that "
    f"rolls at {100 * ROLLS[0]:.0f} to {100 * ROLLS[1]:.0f} cm/s; each recovery there is a false alarm.",
    criteria=(
        measured(
            "least rise of the delay from threshold to threshold",
            lambda s: least_rise(delays(s)),
            unit="s",
            above=0.0,
        ),
        measured(
            "least fall of the false alarms in 100 approaches",
            lambda s: least_rise([-v for v in falses(s)]),
            at_least=0.0,
        ),
        measured(
            "false alarms in 100 approaches: least threshold less greatest",
            lambda s: falses(s)[0] - falses(s)[-1],
            above=0.0,
        ),
        reported("least threshold: delay", lambda s: delays(s)[0], unit="s"),
        reported("greatest threshold: delay", lambda s: delays(s)[-1], unit="s"),
    ),
    measure=sweep,
    figures=sweep_figure,
    ingredients=("the second counter stays at 8 s",),
    seconds=8.0,
    batches=6,
)

CLAIMS = (S23, S24, S25)
