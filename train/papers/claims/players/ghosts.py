"""The damage of a ghost and of a missed player to the memory of other players.  [Sacks 2001, 4.1.1]

Both errors are the paper's own: for one frame every blob counts as a player (ghosts), or all blobs of a colour count as
one player (the farther one is missed). The comparison has the same frames without an error.
"""

from functools import partial

import numpy as np

from soccer_env.match import Match
from soccer_env.match.staging import memory_settings_of
from soccer_env.train.papers.claim import Batch, claim
from soccer_env.train.papers.claims.players.grouping import TILT, ghosts_and_misses, put_two_in_view, seen_and_believed
from soccer_env.train.papers.claims.players.watching import (
    gaps_to,
    matched_distances,
    put_facing,
    slots_of,
    stage_watchers,
)
from soccer_env.train.papers.plots import columns, plot
from soccer_env.train.papers.staging import begin_scene, play, still_actions
from soccer_env.train.papers.true_sight import turn_head
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

MATCHES = 256
LOOK_ASIDE = 1.0  # [s] at the third opponent
LOOK_AHEAD = 1.0  # [s] at the first two
AFTER = 5.0  # [s] after the error
ASIDE, TURNED = (1.1, 1.4), 1.25  # [rad] bearing of the third opponent, out of view of a head that looks ahead; pan
NEAR, FAR = 0.5, 1.0  # [m] of the third opponent
KNOWN = 1.0  # [m] beyond which a slot stands for nobody: obstacles exert no force from there, 4.3.2
FOES = [1, 2, 3]
RATE, EVERY = 16, 4  # [Hz] of control steps, and of them between two points of the figure
EVENTS: dict[str, float | None] = {"none": None, "ghost": 0.0, "miss": 1e6}  # grouping factor for one frame


def remember_three(batch: Batch, event: str) -> dict[str, np.ndarray]:
    """Return the memory's error (M, T) [m] since an event: mean distance of three opponents from their memory slots.

    "ghosts" and "missed" (M,): their numbers in the frame of the event.
    """
    rng = batch.rng()
    match = stage_watchers(batch, MATCHES, away=3)
    put_two_in_view(match, rng)
    side = rng.choice([-1.0, 1.0], MATCHES)
    put_facing(
        match, 3, rng.uniform(NEAR, FAR, MATCHES), side * rng.uniform(*ASIDE, MATCHES), rng.uniform(-3.0, 3.0, MATCHES)
    )
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
    gaps = matched_distances(gaps_to(match, slots_of(match), FOES), KNOWN)
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


def course_of(samples: Samples, event: str) -> np.ndarray:
    """Return the error that an event adds (M, T) [m], every few frames."""
    return samples[f"course {event}"][:, ::EVERY]


S34 = claim(
    "S34", "4.1.1", "A ghost, which may displace a real player, is worse than a miss.",
    f"{MATCHES} robots a batch have looked at three standing opponents, two of which are in view; for one frame "
    "every blob counts as a player (ghosts), or all blobs as one (a miss); mean distance of the opponents from the "
    f"slots that stand for them (at most {100 * KNOWN:.0f} cm), less that without the event, over the {AFTER:g} s "
    "after it, for each ghost and for each miss.",
    measured("added error for a ghost less that for a miss",
             lambda samples: 100 * (mean(samples["ghost"]) - mean(samples["miss"])), unit="cm", above=0.0),
    reported("added error for a ghost", "ghost", unit="cm"),
    reported("added error for a miss", "miss", unit="cm"),
    reported("error without either", "plain", unit="cm"),
    reported("share of events that make a ghost", lambda s: 100 * float(np.isfinite(s["ghost"]).mean()), unit="%"),
    reported("share of events that make a miss", lambda s: 100 * float(np.isfinite(s["miss"]).mean()), unit="%"),
    measure=compare_errors,
    figures=plot("What one frame's error does to the memory", "time since [s]", "added error [cm]",
                 np.linspace(0.0, AFTER, round(AFTER * RATE) + 1)[::EVERY],
                 {f"a {event}": columns(partial(course_of, event=event)) for event in ("ghost", "miss")}),
    seconds=5.0,
    ingredients=("three slots for three opponents", "memory.distance_power, angle_power"),
)  # fmt: skip
