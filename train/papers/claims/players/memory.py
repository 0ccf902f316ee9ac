"""The memory of other players: one opponent that fills it, a ghost, a missed player.  [Sacks 2001, 4.1.1]

The rates of missed stickers and missed players are guesses, so S35 is judged over both; the worst case counts. The
errors of S34 are the paper's own: for one frame every blob counts as a player (ghosts), or all blobs of a colour count
as one player (the farther one is missed). The comparison has the same frames without an error.
"""

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.match.staging import memory_settings_of
from soccer_env.train.papers.claim import Batch, claim
from soccer_env.train.papers.claims.players import watching
from soccer_env.train.papers.claims.players.grouping import TILT, ghosts_and_misses, put_two_in_view, seen_and_believed
from soccer_env.train.papers.plots import Drawing, columns, part, plot
from soccer_env.train.papers.staging import OPEN_FLOOR, begin_scene, play, still_actions
from soccer_env.train.papers.true_sight import turn_head
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

MATCHES = 64
SECONDS = 30.0  # [s] in which a single opponent is in view
LOOK = 1.0  # [s] at each of the two others before
NEAR, FAR = 0.5, 1.5  # [m] of the opponents
AHEAD = 0.25  # [rad] greatest bearing of the one in view
ASIDE, TURNED = (1.1, 1.4), 1.25  # [rad] bearings of the others, out of view of a head that looks ahead; pan at them
POWERS = {  # of distance and angle in the likelihood
    "U/d": (1.0, 0.0),
    "U/d^3": (3.0, 0.0),
    "U/(d a)": (1.0, 1.0),
    "U/(d^3 a)": (3.0, 1.0),
}
ONE_PLAYER = 1e6  # grouping factor by which all blobs of a colour are one player
EVERY, POINTS = 8, 60  # frames between two points of the figure, and their number
FIRST, FINAL = "U/d", "U/(d^3 a)"  # the first and the final likelihood of the paper
MISSES: dict[str, dict[str, float]] = {  # things that frames miss
    "nothing": {"sticker_miss": 0.0, "player_miss": 0.0},
    "5 % of the stickers": {"sticker_miss": 0.05, "player_miss": 0.0},
    "5 % of the players": {"sticker_miss": 0.0, "player_miss": 0.05},
}


def stare_at_one(batch: Batch, sensors: dict[str, float], **memory: Any) -> np.ndarray:
    """Let robot 0 look at three opponents in turn, then for SECONDS at one alone; return slots filled since (M, T)."""
    rng = batch.rng()
    match = watching.stage_watchers(batch, MATCHES, away=3, league=OPEN_FLOOR, sensors=sensors, memory=memory)
    for r, low, high in ((1, -AHEAD, AHEAD), (2, *ASIDE), (3, -ASIDE[1], -ASIDE[0])):
        distance, bearing = rng.uniform(NEAR, FAR, MATCHES), rng.uniform(low, high, MATCHES)
        watching.put_facing(match, r, distance, bearing, rng.uniform(-np.pi, np.pi, MATCHES))
    begin_scene(match)
    actions = still_actions(match)
    for pan in (TURNED, -TURNED, 0.0):
        turn_head(match, actions, 0, pan, TILT)
        for _ in play(match, LOOK, actions):
            pass
    filled: list[np.ndarray] = []
    for step in play(match, SECONDS, actions):
        slots = watching.slots_of(match)
        since = (step + 0.5) * match.league.dt
        filled.append(((slots["present"] == 1) & (slots["age"] < since)).sum(axis=1))
    match.close()
    return np.stack(filled, axis=1)


def compare_likelihoods(batch: Batch) -> Samples:
    """Return the share of time (M,) in which one opponent holds two slots or more, for each likelihood in POWERS.

    All blobs in view count as one player, so only the matching can fill a second slot. "all ...": three slots or more.
    """
    samples: Samples = {}
    for name, (distance, angle) in POWERS.items():
        filled = stare_at_one(batch, {}, distance_power=distance, angle_power=angle, grouping=ONE_PLAYER)
        samples[name] = (filled >= 2).mean(axis=1)
        samples[f"all {name}"] = (filled >= 3).mean(axis=1)
        samples[f"course {name}"] = filled[:, ::EVERY] >= 2
    return samples


def compare_misses(batch: Batch) -> Samples:
    """Return the share of time (M,) in which one opponent holds two slots or more, in each case of MISSES."""
    samples: Samples = {}
    for name in (FIRST, FINAL):
        (distance, angle), courses = POWERS[name], []
        for missed, sensors in MISSES.items():
            filled = stare_at_one(batch, sensors, distance_power=distance, angle_power=angle, grouping=ONE_PLAYER)
            samples[f"{name}, {missed}"] = (filled >= 2).mean(axis=1)
            samples[f"all {name}, {missed}"] = (filled >= 3).any(axis=1).astype(float)
            courses.append(filled[:, ::EVERY] >= 2)
        samples[f"course {name}"] = np.stack(courses, axis=1)
    return samples


def by_case(samples: Samples, name: str) -> list[float]:
    """Return the mean [%] of the samples of a name, such as "U/d" (time with two slots), in each case of MISSES."""
    return [100 * mean(samples[f"{name}, {missed}"]) for missed in MISSES]


def plot_slots(*names: str) -> Drawing:
    """Return a drawing of the share of runs in which one opponent holds two slots against the time, by likelihood."""
    lines = {name: columns(f"course {name}") for name in names}
    title = "One opponent in view: runs in which it holds two slots"
    return plot(title, "time [s]", "runs [%]", [i * SECONDS / POINTS for i in range(POINTS)], lines)


HOW = (
    f"{MATCHES} robots a batch have looked at three standing opponents {100 * NEAR:.0f} to {100 * FAR:.0f} cm away and "
    f"then look at one of them alone for {SECONDS:g} s, all its blobs taken for one player; share of the time in which "
    "it has filled two slots or more, same seeds for each likelihood"
)

S35 = claim(
    "S35", "4.1.1", "Uncertainty U/d lets one opponent fill all three slots; U/(d^3 angle) usually does not.",
    f"{HOW}: U/d first, U/(d^3 angle) at last; if frames miss nothing, 5 % of the stickers, or 5 % of the "
    "players; the worst of them counts. The paper: U/d \"frequently caused a single foe to fill up all three foe "
    "slots\"; the other \"usually prevents one player from occupying multiple slots\".",
    measured("U/d: runs in which it comes to fill all three slots", lambda s: min(by_case(s, f"all {FIRST}")),
             unit="%", at_least=50.0),
    measured("U/(d^3 angle): time with one slot alone", lambda s: 100 - max(by_case(s, FINAL)), unit="%", above=50.0),
    measure=compare_misses, figures=plot_slots(FIRST, FINAL), batches=10, seconds=6.0,
    ingredients=("memory.uncertainty_growth, assumed", "memory.ghost_time, assumed", "sensors.dither"),
    note="Where a frame misses all of the trunk's stickers, the one of the head is the largest blob that is left, the "
    "player seems half as far again, and may go into another slot.",
)  # fmt: skip


S36 = claim(
    "S36", "4.1.1", "It is not clear that the factor of the angle helps.",
    f"{HOW}: with the angle and without.",
    reported("U/(d^3 angle)", "U/(d^3 a)", unit="%"),
    reported("U/d^3", "U/d^3", unit="%"),
    reported("U/(d angle)", "U/(d a)", unit="%"),
    reported("U/d", "U/d", unit="%"),
    measure=compare_likelihoods, figures=plot_slots(*POWERS), batches=4, seconds=5.0,
    ingredients=("memory.uncertainty_growth, assumed", "memory.ghost_time, assumed", "sensors.dither"),
)  # fmt: skip

# A ghost and a missed player

WATCHERS = 256
LOOK_ASIDE = 1.0  # [s] at the third opponent
LOOK_AHEAD = 1.0  # [s] at the first two
AFTER = 5.0  # [s] after the error
THIRD_NEAR, THIRD_FAR = 0.5, 1.0  # [m] of the third opponent
KNOWN = 1.0  # [m] beyond which a slot stands for nobody: obstacles exert no force from there, 4.3.2
FOES = [1, 2, 3]
RATE, POINT_EVERY = 16, 4  # [Hz] of control steps, and of them between two points of the figure
EVENTS: dict[str, float | None] = {"none": None, "ghost": 0.0, "miss": 1e6}  # grouping factor for one frame


def remember_three(batch: Batch, event: str) -> dict[str, np.ndarray]:
    """Return the memory's error (M, T) [m] since an event: mean distance of three opponents from their memory slots.

    "ghosts" and "missed" (M,): their numbers in the frame of the event.
    """
    rng = batch.rng()
    match = watching.stage_watchers(batch, WATCHERS, away=3, league=OPEN_FLOOR)
    put_two_in_view(match, rng)
    side = rng.choice([-1.0, 1.0], WATCHERS)
    distance, bearing = rng.uniform(THIRD_NEAR, THIRD_FAR, WATCHERS), side * rng.uniform(*ASIDE, WATCHERS)
    watching.put_facing(match, 3, distance, bearing, rng.uniform(-3.0, 3.0, WATCHERS))
    begin_scene(match)
    actions = still_actions(match)
    for pan, seconds in ((side * TURNED, LOOK_ASIDE), (0.0, LOOK_AHEAD)):
        turn_head(match, actions, 0, pan, TILT)
        for _ in play(match, seconds, actions):
            pass
    chosen, factor = float(memory_settings_of(match)["grouping"][0]), EVENTS[event]
    memory_settings_of(match)["grouping"] = chosen if factor is None else factor
    match.step(actions)
    memory_settings_of(match)["grouping"] = chosen
    ghosts, missed = ghosts_and_misses(*seen_and_believed(match))
    errors = [memory_error(match)]
    for _ in play(match, AFTER, actions):
        errors.append(memory_error(match))
    match.close()
    return {"error": np.stack(errors, axis=1), "ghosts": ghosts.astype(float), "missed": missed.astype(float)}


def memory_error(match: Match) -> np.ndarray:
    """Return the mean distance (M,) [m] of the opponents from the slots matched to them, KNOWN if none is matched."""
    gaps = watching.matched_distances(watching.gaps_to(match, watching.slots_of(match), FOES), KNOWN)
    return np.asarray(np.minimum(gaps, KNOWN).mean(axis=1))


def compare_errors(batch: Batch) -> Samples:
    """Return the error that each ghost and each miss adds, as mean over AFTER (M,) and in each frame (M, T) [m].

    Matches count if the event made a ghost or a miss, and the frame without the event has neither.
    """
    runs = {event: remember_three(batch, event) for event in EVENTS}
    quiet = (runs["none"]["ghosts"] == 0) & (runs["none"]["missed"] == 0)
    samples: Samples = {"plain": runs["none"]["error"].mean(axis=1)}
    for event, name in (("ghost", "ghosts"), ("miss", "missed")):
        number = runs[event][name]
        counts = quiet & (number > 0) & (runs[event]["ghosts"] * runs[event]["missed"] == 0)
        added = (runs[event]["error"] - runs["none"]["error"]) / np.maximum(number, 1.0)[:, None]
        samples[f"course {event}"] = np.where(counts[:, None], added, np.nan)
        samples[event] = np.where(counts, added.mean(axis=1), np.nan)
    return samples


S34 = claim(
    "S34", "4.1.1", "A ghost, which may displace a real player, is worse than a miss.",
    f"{WATCHERS} robots a batch have looked at three standing opponents, two of which are in view; for one frame "
    "every blob counts as a player (ghosts), or all blobs as one (a miss); mean distance of the opponents from the "
    f"slots that stand for them (at most {100 * KNOWN:.0f} cm), less that without the event, over the {AFTER:g} s "
    "after it, for each ghost and for each miss.",
    measured("added error for a ghost less that for a miss",
             lambda samples: 100 * (mean(samples["ghost"]) - mean(samples["miss"])), unit="cm", above=0.0),
    reported("error without either", "plain", unit="cm"),
    measure=compare_errors,
    figures=plot("What one frame's error does to the memory", "time since [s]", "added error [cm]",
                 np.linspace(0.0, AFTER, round(AFTER * RATE) + 1)[::POINT_EVERY],
                 {f"a {event}": columns(part(f"course {event}", ..., slice(None, None, POINT_EVERY)))
                  for event in ("ghost", "miss")}),
    seconds=5.0,
    ingredients=("three slots for three opponents", "memory.distance_power, angle_power"),
)  # fmt: skip
