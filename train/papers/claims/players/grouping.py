"""Grouping blobs into players: missed players, ghosts, and which player is missed.  [Sacks 2001, 4.1.1]

Sizes of stickers are guesses, so the grouping factor is judged over jerseys of 0.7 to 1.3 times their size; the worst
jersey counts.
"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import Ablation, Batch, claim
from soccer_env.train.papers.claims.players import watching
from soccer_env.train.papers.claims.players.jersey import JERSEYS
from soccer_env.train.papers.plots import each, plot, plots
from soccer_env.train.papers.staging import OPEN_FLOOR, begin_scene, still_actions, watch, wrap_angle
from soccer_env.train.papers.true_sight import turn_head
from soccer_env.train.papers.values import percent
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

MATCHES = 64  # of each jersey and factor
PAIRS = 384  # of opponents, S72
SETTLE, SECONDS = 0.5, 0.5  # [s]
FACTORS = (1.0, 2.0, 3.0, 4.0, 6.0)
CHOSEN = 3.0  # Sacks 2001, 4.1.1
NEAR, FAR = 0.45, 2.0  # [m] of the players in view
WIDE = 0.35  # [rad] of their bearings: within the camera's view, less half a robot
APART = 0.30  # [m] between bodies' middles
TILT = -0.10  # [rad] of the head that looks over the field
FOES = [1, 2]  # rows of the two opponents in view
UNLIKE = 1.2  # [1] ratio of distances beyond which one player is clearly farther, S72
ASIDE, RANGE = 0.10, 0.15  # [m], [1] by which the place of a slot errs, S72
DRAWS = 50  # of places, until two do not touch
FEW = 5.0  # [%] of the slots filled that may be ghosts


def put_two_in_view(match: Match, rng: np.random.Generator, alike: bool = False) -> None:
    """Place two opponents at random in view of robot 0, who looks ahead, with random headings; `alike`: equally far."""
    shape, rows = (DRAWS, match.count, 2), np.arange(match.count)
    distance, bearing = rng.uniform(NEAR, FAR, shape), rng.uniform(-WIDE, WIDE, shape)
    if alike:
        distance[..., 1] = distance[..., 0]
    x, y = distance * np.cos(bearing), distance * np.sin(bearing)
    first = (np.hypot(x[..., 0] - x[..., 1], y[..., 0] - y[..., 1]) > APART).argmax(axis=0)
    for i, r in enumerate(FOES):
        view = rng.uniform(-np.pi, np.pi, match.count)
        watching.put_facing(match, r, distance[first, rows, i], bearing[first, rows, i], view)


def seen_and_believed(match: Match) -> tuple[np.ndarray, np.ndarray]:
    """Return whether each opponent in view shows a blob (M, 2), and how many slots it has filled in this frame (M, 2).

    A blob or slot belongs to the opponent that is nearest to it sideways.
    """
    mine, slots = watching.blob_owners(match, FOES), watching.slots_of(match)
    away, true = watching.distances_from_camera(match, FOES)
    aside = np.abs(wrap_angle(watching.slot_bearings(match, slots)[:, :, None] - true[:, None, :])) * away[:, None, :]
    nearest = np.where(watching.is_fresh(match, slots), aside.argmin(axis=2), -1)
    visible = np.stack([(mine == i).any(axis=1) for i in range(len(FOES))], axis=1)
    return visible, np.stack([(nearest == i).sum(axis=1) for i in range(len(FOES))], axis=1)


def ghosts_and_misses(visible: np.ndarray, filled: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the number of surplus slots (M,), and the number of players that show a blob but have no slot (M,)."""
    return np.maximum(filled - visible, 0).sum(axis=1), (visible & (filled == 0)).sum(axis=1)


def count_errors(batch: Batch, factor: float, jersey: float) -> dict[str, np.ndarray]:
    """Count ghosts, missed players, filled slots and visible players over all frames (M,), with a grouping factor."""
    settings: dict[str, Any] = {"memory": {"grouping": factor}, "sensors": {"jersey": jersey}}
    match = watching.stage_watchers(batch, MATCHES, away=2, league=OPEN_FLOOR, **settings)
    put_two_in_view(match, batch.rng())
    begin_scene(match)
    actions = still_actions(match)
    turn_head(match, actions, 0, 0.0, TILT)
    total = np.zeros((4, MATCHES))
    for _ in watch(match, SECONDS, actions, SETTLE):
        visible, filled = seen_and_believed(match)
        total += np.stack([*ghosts_and_misses(visible, filled), filled.sum(axis=1), visible.sum(axis=1)])
    match.close()
    return dict(zip(("ghosts", "missed", "filled", "visible"), total, strict=True))


def try_factors(batch: Batch) -> Samples:
    """Return the counts of `count_errors` (M, jerseys) for every grouping factor."""
    samples: Samples = {}
    for factor in FACTORS:
        counts = [count_errors(batch, factor, jersey) for jersey in JERSEYS]
        samples |= {f"{name} {factor:g}": np.stack([one[name] for one in counts], axis=1) for name in counts[0]}
    return samples


def error_share(samples: Samples, name: str, factor: float, of: str = "visible") -> np.ndarray:
    """Return the share [%] of ghosts or missed players among visible players, or filled slots, by jersey (jerseys,)."""
    total = samples[f"{of} {factor:g}"].sum(axis=0)
    return np.asarray(100 * samples[f"{name} {factor:g}"].sum(axis=0) / np.maximum(total, 1.0))


def total_error_share(samples: Samples, factor: float) -> np.ndarray:
    """Return the sum of ghosts and missed players [%] of visible players, for each jersey (jerseys,)."""
    return np.asarray(error_share(samples, "ghosts", factor) + error_share(samples, "missed", factor))


def excess_over_best_factor(samples: Samples) -> np.ndarray:
    """Return the errors [%] at the paper's factor minus the fewest errors at another factor, by jersey (jerseys,)."""
    others = np.stack([total_error_share(samples, factor) for factor in FACTORS if factor != CHOSEN])
    return np.asarray(total_error_share(samples, CHOSEN) - others.min(axis=0))


S33 = claim(
    "S33", "4.1.1", "Merging blobs within three sizes works best, and errs towards counting two players as one.",
    f"{MATCHES} robots a batch and jersey (stickers of {', '.join(f'{j:g}' for j in JERSEYS)} times their size) "
    f"look at two standing opponents {100 * NEAR:.0f} to {100 * FAR:.0f} cm away in their view, from any side; a ghost "
    "is a slot filled in a frame beyond one for each opponent that shows a blob, a missed one shows a blob and fills "
    "no slot; same seeds for each factor; the worst jersey counts.",
    measured("ghosts at a factor of 3, in the worst jersey",
             lambda s: float(error_share(s, "ghosts", CHOSEN, "filled").max()), unit="%", at_most=FEW),
    measured("missed less ghosts at a factor of 3, in the worst jersey",
             lambda s: float((error_share(s, "missed", CHOSEN) - error_share(s, "ghosts", CHOSEN)).min()), unit="%",
             above=0.0),
    measured("ghosts and misses at a factor of 3 less the fewest at another factor < 0, of the players visible, in "
             "each jersey", lambda samples: float(excess_over_best_factor(samples).max()), unit="%", below=0.0),
    measure=try_factors, condition="in the worst of three sizes of assumed stickers",
    figures=plots(*(plot(f"Two players in view, stickers {jersey:g} times as large",
                         "grouping factor [sizes of the larger blob]", "per visible player [%]", FACTORS,
                         {name: each(FACTORS, lambda s, name, j, factor: float(error_share(s, name, factor)[j]), name,
                                     j) for name in ("ghosts", "missed")}) for j, jersey in enumerate(JERSEYS))),
    seconds=5.0,
    ingredients=("sensors.sticker_*, all assumed", "the gap of two blobs, taken between their middles"),
    note="Which factor is best follows from the jersey: stickers of shoulder and hip are 12 cm apart, 2.8 sizes of the "
    "smallest ones, 2 of those of their own size, 1.5 of the largest.",
)  # fmt: skip


def count_kept_opponents(batch: Batch, alike: bool = False) -> Samples:
    """Count frames (M,) with two opponents visible and one slot filled, and frames that keep the nearer opponent."""
    match = watching.stage_watchers(batch, PAIRS, away=2, league=OPEN_FLOOR)
    put_two_in_view(match, batch.rng(), alike)
    begin_scene(match)
    actions = still_actions(match)
    turn_head(match, actions, 0, 0.0, TILT)
    kept, merged = np.zeros((2, match.count))
    true = np.stack([watching.distance_to_robot(match, r) for r in FOES], axis=1)
    for _ in watch(match, SECONDS, actions, SETTLE):
        visible, filled = seen_and_believed(match)
        one = visible.all(axis=1) & (filled.sum(axis=1) == 1)
        merged += one
        kept += one & (kept_opponent(match) == true.argmin(axis=1))
    match.close()
    unlike = true.max(axis=1) > UNLIKE * true.min(axis=1)
    return {"nearer": kept, "merged": merged, "nearer unlike": kept * unlike, "merged unlike": merged * unlike}


def kept_opponent(match: Match) -> np.ndarray:
    """Return the index of the opponent (M,) that the slot filled in this frame stands for.

    This is the opponent nearest to the slot's place, in units of the errors: ASIDE, and RANGE of the distance.
    """
    slots, rows = watching.slots_of(match), np.arange(match.count)
    row = watching.is_fresh(match, slots).argmax(axis=1)
    away, true = watching.distances_from_camera(match, FOES)
    x, y = slots["x"][rows, row], slots["y"][rows, row]
    places = [watching.distance_to_robot(match, r) for r in FOES]
    beside = np.abs(wrap_angle(watching.slot_bearings(match, slots)[rows, row][:, None] - true)) * away / ASIDE
    beyond = np.log(np.maximum(np.hypot(x, y), 0.01)[:, None] / np.stack(places, axis=1)) / RANGE
    return np.asarray((beside * beside + beyond * beyond).argmin(axis=1))


S72 = claim(
    "S72", "4.1.1", "A player that is ignored is a farther one, because blobs are considered by size.",
    f"{PAIRS} robots a batch look at two standing opponents {100 * NEAR:.0f} to {100 * FAR:.0f} cm away in "
    "their view, from any side; frames in which both show a blob and one slot is filled, with the opponent whose place "
    f"is nearest to it ({100 * ASIDE:.0f} cm aside count like {100 * RANGE:.0f} % of the distance). The paper: "
    "\"ignoring only those farther away\", which decides where one is farther.",
    counted(f"distances differ by {100 * (UNLIKE - 1):.0f} % or more: the nearer is kept", "nearer unlike",
            "merged unlike", at_least=95.0),
    reported("the nearer is kept, all pairs", percent, "nearer", "merged", unit="%"),
    measure=count_kept_opponents, batches=24, seconds=2.0,
    without=Ablation("a nearer player's blobs are larger, and blobs are sorted by size; here both are as far",
                     partial(count_kept_opponents, alike=True)),
    ingredients=("sensors.sticker_*: a flank's sticker is larger than a nearer chest's", "memory.grouping = 3"),
)  # fmt: skip
