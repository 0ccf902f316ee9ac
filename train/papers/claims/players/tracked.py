"""The number and accuracy of tracked players: the old system and the new one.  [Sacks 2001, 4.1]"""

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import Batch, claim, compare
from soccer_env.train.papers.claims.players import watching
from soccer_env.train.papers.plots import each, plot
from soccer_env.train.papers.staging import begin_scene, distance_to_point, play, put, still_actions, wrap_angle
from soccer_env.train.papers.true_sight import turn_head
from soccer_env.train.papers.values import mean, rms
from soccer_env.train.papers.verdicts import Samples, measured

MATCHES = 48
SETTLE, SECONDS = 6.0, 14.0  # [s]
EVERY = 8  # control steps between two looks: half a second
# The system before Sacks knew one player of each team. Its table is not published ("no careful calibration had been
# done"): the table of the first calibration, from the side and by the box round all blobs, replaces it.
NEAREST = {"slots": "nearest"}
OLD = NEAREST | {"player_view": "side", "player_blob": "combined", "player_infrared": False, "player_odometry": False}
VARIANTS: dict[str, dict[str, Any]] = {"new": {}, "old": OLD, "new, nearest alone": NEAREST}
NEAR = 0.5  # [m] greatest distance of a slot from its player
TEAMS = ((True, [1, 2]), (False, [3, 4, 5]))  # team-mates and opponents, by rows
PLACES = ((-0.2, 0.0), (-0.9, 0.5), (-0.7, -0.6), (0.5, 0.5), (0.6, -0.5), (1.1, 0.1))  # [m]
SWEEP = 3.0  # [s] of a sweep of the head from side to side and back
WIDTH = 1.3  # [rad] greatest pan of the sweep
TILT = -0.10  # [rad]
KEPT = 2.0  # [s] between two random walks


def walk_about(match: Match, actions: np.ndarray, step: int, rng: np.random.Generator) -> None:
    """Fill in actions (M, R, 7) by which all robots walk about at random and robot 0 sweeps its head."""
    if step % round(KEPT * match.league.control_rate) == 0:
        shape = match.robots.shape
        actions[..., 0] = rng.uniform(0.0, 1.0, shape)
        actions[..., 2] = rng.uniform(-1.0, 1.0, shape)
    phase = step / match.league.control_rate / SWEEP
    turn_head(match, actions, 0, WIDTH * (4.0 * abs(phase % 1.0 - 0.5) - 1.0), TILT)


def track_all(batch: Batch, **memory: Any) -> dict[str, np.ndarray]:
    """Return how many of five players are tracked (M, T), and the range errors (M, T, 2) [m].

    The errors are of the nearest team-mate and the nearest opponent in the frame, NaN without one.
    """
    rng = batch.rng()
    match = watching.stage_watchers(batch, MATCHES, home=3, away=3, memory=memory)
    for r, (x, y) in enumerate(PLACES):
        aside = rng.uniform(-0.2, 0.2, (2, MATCHES))
        put(match, r, x + aside[0], y + aside[1], rng.uniform(-np.pi, np.pi, MATCHES))
    begin_scene(match)
    actions = still_actions(match)
    walks = batch.rng(1)
    tracked, errors = [], []
    for step in play(match, SETTLE + SECONDS, actions):
        if step % EVERY == 0 and step >= SETTLE * match.league.control_rate:
            gaps = [watching.gaps_to(match, watching.slots_of(match, mates), rows) for mates, rows in TEAMS]
            tracked.append(sum(np.isfinite(watching.matched_distances(gap, NEAR)).sum(axis=1) for gap in gaps))
        if step >= SETTLE * match.league.control_rate:
            errors.append(np.stack([nearest_error(match, mates, rows) for mates, rows in TEAMS], axis=1))
        walk_about(match, actions, step + 1, walks)
    match.close()
    return {"tracked": np.stack(tracked, axis=1), "error": np.stack(errors, axis=1)}


def nearest_error(match: Match, mates: bool, rows: list[int]) -> np.ndarray:
    """Return the range error (M,) [m] of a team's nearest player that this frame shows, NaN without a player.

    The slot is compared with the player that is nearest to it sideways.
    """
    slots, order = watching.slots_of(match, mates), np.arange(match.count)
    distance = np.where(watching.is_fresh(match, slots), slots["distance"], np.inf)
    slot = distance.argmin(axis=1)
    away, true = watching.distances_from_camera(match, rows)
    aside = np.abs(wrap_angle(watching.slot_bearings(match, slots)[order, slot][:, None] - true)) * away
    x, y = match.robots["x"][:, rows], match.robots["y"][:, rows]
    meant = aside.argmin(axis=1)
    range_, _ = distance_to_point(match, 0, x[order, meant], y[order, meant])
    return np.where(np.isfinite(distance[order, slot]), distance[order, slot] - range_, np.nan)


def compare_systems(batch: Batch) -> Samples:
    """Return the tracked players and range errors of each system in VARIANTS, in equal scenes."""
    samples = compare(VARIANTS, lambda memory: track_all(batch, **memory))
    both = np.isfinite(samples["error new"]) & np.isfinite(samples["error old"])
    for name in ("new", "old"):  # the frames that both see
        samples[f"error {name}"] = np.where(both, samples[f"error {name}"], np.nan)
    return samples


def recall(samples: Samples, name: str) -> float:
    """Return the share of the five other players that the system `name` tracks [%]."""
    return 20 * mean(samples[f"tracked {name}"])


def error(samples: Samples, name: str) -> float:
    """Return the rms range error [cm] of the system `name`."""
    return 100 * rms(samples[f"error {name}"])


S32 = claim(
    "S32", "4.1", "Three opponents and two team-mates are stored, more accurately than the nearest ones before.",
    f"{MATCHES} robots a batch walk about among two team-mates and three opponents who do as well, their heads "
    f"sweeping, for {SECONDS:g} s; a player is tracked if a slot of its team lies within {100 * NEAR:.0f} cm; range "
    "error of the nearest player of each team in frames that both systems see, same seeds.",
    measured("players tracked, new over old",
             lambda samples: recall(samples, "new") / max(recall(samples, "old"), 1e-9), at_least=1.8),
    measured("range error, new over old", lambda s: error(s, "new") / max(error(s, "old"), 1e-9), below=1.0),
    measure=compare_systems,
    figures=plot("Players tracked, of five", "players tracked", "share of the time [%]", range(6),
                 {name: each(range(6), lambda s, name, n: 100 * float(np.mean(s[f"tracked {name}"] == n)), name)
                  for name in VARIANTS}),
    seconds=5.0,
    ingredients=("memory.slots", "the way the head sweeps"),
    note="The table of the old system is not told; the first one of the paper's own calibrations, from the side by all "
    "blobs, stands for it, so that the second criterion compares the new system with its own first version.",
)  # fmt: skip
