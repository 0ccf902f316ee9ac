"""A player's range from all its blobs or the largest one, while its head stickers come and go.  [Sacks 2001, 4.1.2]

Sizes of stickers are guesses, so the claim is judged over jerseys of 0.7 to 1.3 times their size.
"""

from collections.abc import Sequence

import numpy as np

from soccer_env.train.papers.claim import Batch, Claim, Curve, Figure
from soccer_env.train.papers.claims.players.jersey import JERSEYS
from soccer_env.train.papers.claims.players.seen import blob_heights, nearest_seen, put_facing, stage_watchers, stare
from soccer_env.train.papers.staging import begin_scene, put, stacked, still_actions
from soccer_env.train.papers.values import bin_masks, mean, median, middles_of, rms, subtract_row_mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

RUNS = 48  # of each jersey
SETTLE, SECONDS = 1.0, 2.0  # [s]
NEAR, FAR = 0.5, 2.6  # [m] as far as the field allows
EYE_X = -1.3  # [m] of the robot that looks, at one end of the field
HEAD_HEIGHT = 0.185  # [m] between the middles of the stickers of trunk and head
MANY = {"sticker_miss": 0.3}  # a share of missed stickers that yields enough frames of a trunk without a head
BLOBS = ("largest", "combined")
BINS = (0.5, 0.8, 1.1, 1.4, 1.7, 2.0, 2.3, 2.6)  # [m]


def watch_players(batch: Batch, jersey: float, blobs: str, **sensors: float) -> dict[str, np.ndarray]:
    """Return believed over true range, and whether a sticker of the head and of the trunk is seen (RUNS, T).

    "distance" (RUNS,) [m] is the true distance.
    """
    rng = batch.rng()
    memory = {"player_blob": blobs, "player_infrared": False}
    match = stage_watchers(batch, RUNS, sensors={"jersey": jersey, **sensors}, memory=memory)
    put(match, 0, EYE_X, rng.uniform(-0.3, 0.3, RUNS), 0.0)
    distance, bearing = rng.uniform(NEAR, FAR, RUNS), rng.uniform(-0.2, 0.2, RUNS)
    put_facing(match, 1, distance, bearing, rng.uniform(-np.pi, np.pi, RUNS))
    begin_scene(match)
    rows: dict[str, list[np.ndarray]] = {"range": [], "head": [], "trunk": []}
    for true in stare(match, still_actions(match), SETTLE, SECONDS):
        heights = blob_heights(match)
        rows["range"].append(nearest_seen(match)[0] / true)
        rows["head"].append(np.any(heights > HEAD_HEIGHT, axis=1))  # NaN compares as False
        rows["trunk"].append(np.any(heights <= HEAD_HEIGHT, axis=1))
    return stacked(match, rows) | {"distance": true}


def compare_blobs(batch: Batch) -> Samples:
    """Return relative ranges (RUNS, jerseys, T) by both methods, in all frames and with and without a head sticker."""
    samples: Samples = {}
    for blobs in BLOBS:
        runs = [watch_players(batch, jersey, blobs) for jersey in JERSEYS]
        samples[blobs] = np.stack([one["range"] for one in runs], axis=1)
        many = [watch_players(batch, jersey, blobs, **MANY) for jersey in JERSEYS]
        for name, head in (("with", True), ("without", False)):
            chosen = [np.where(one["trunk"] & (one["head"] == head), one["range"], np.nan) for one in many]
            samples[f"{blobs} {name} head"] = np.stack(chosen, axis=1)
    return samples | {"head": np.stack([one["head"] for one in runs], axis=1), "distance": runs[0]["distance"]}


def sticker_range_ratios(samples: Samples, blobs: str) -> np.ndarray:
    """Return the median range without a head sticker over the median range with one, for each jersey (jerseys,)."""
    without, complete = (samples[f"{blobs} {name} head"] for name in ("without", "with"))
    ratios = [median(without[:, j]) / max(median(complete[:, j]), 1e-9) for j in range(len(JERSEYS))]
    return np.array(ratios)


def worst_sticker_ratio(samples: Samples, blobs: str) -> float:
    """Return the ratio of `sticker_range_ratios` that is farthest from the paper's factor of two."""
    ratios = sticker_range_ratios(samples, blobs)
    return float(ratios[np.argmax(np.abs(np.log(ratios / 2.0)))]) if np.isfinite(ratios).all() else np.nan


def share_without_head_sticker(samples: Samples, j: int, i: int) -> float:
    """Return the share of frames [%] without a head sticker, for jersey `j` in the distance bin `i`."""
    return 100 * (1.0 - mean(samples["head"][bin_masks(samples["distance"], BINS)[i], j]))


def scatter(samples: Samples, blobs: str) -> float:
    """Return the rms deviation [%] of the believed relative range from its mean in each run."""
    return 100 * rms(subtract_row_mean(samples[blobs].reshape(-1, samples[blobs].shape[-1])))


def blob_figures(samples: Samples) -> Sequence[Figure]:
    """Plot the scatter of the range by both methods, and the share of frames without a head sticker, over distance."""
    middles, inside = middles_of(BINS, 100), bin_masks(samples["distance"], BINS)
    steady = [
        Curve(label, middles, [scatter({blobs: samples[blobs][i]}, blobs) if i.any() else np.nan for i in inside])
        for blobs, label in zip(BLOBS, ("largest blob", "all blobs"), strict=True)
    ]
    heads = [
        Curve(
            f"stickers {jersey:g} times as large",
            middles,
            [share_without_head_sticker(samples, j, i) for i in range(len(middles))],
        )
        for j, jersey in enumerate(JERSEYS)
    ]
    return (
        Figure("Scatter of a player's range", "distance [cm]", "deviation [%]", tuple(steady)),
        Figure("Frames without a head sticker", "distance [cm]", "share of frames [%]", tuple(heads)),
    )  # fmt: skip


S39 = Claim(
    id="S39", section="4.1.2",
    statement="Where head stickers vanish the height of all blobs halves; the largest blob is steadier.",
    method=f"{RUNS} robots a batch and jersey (stickers of {', '.join(f'{j:g}' for j in JERSEYS)} times their size) "
    f"stare at a player {100 * NEAR:.0f} to {100 * FAR:.0f} cm away, seen from any side; share of frames without a "
    "head sticker; scatter of the believed over the true range in each run; that ratio in frames with a trunk alone "
    "over frames with trunk and head (for these 30 % of the stickers are missed, so that there are enough).",
    criteria=(
        measured("combined: range without the head over that with it", worst_sticker_ratio, "combined", at_least=1.5,
                 at_most=2.5),
        measured("largest blob: the same, in the worst jersey",
                 lambda samples: float(sticker_range_ratios(samples, "largest").max()), at_most=1.2),
        measured("scatter of the largest blob's range over that of the combined",
                 lambda samples: scatter(samples, "largest") / max(scatter(samples, "combined"), 1e-9), below=1.0),
        *(reported(f"frames without a head sticker at the far end, 2.3 to 2.6 m, stickers {jersey:g} times as large",
                   share_without_head_sticker, j, len(BINS) - 2, unit="%") for j, jersey in enumerate(JERSEYS)),
        reported("scatter, largest blob", scatter, "largest", unit="%"),
        reported("scatter, combined", scatter, "combined", unit="%"),
    ),
    measure=compare_blobs, figures=blob_figures, seconds=2.0,
    ingredients=("sensors.sticker_*, all assumed", "sensors.sticker_miss", "sensors.least_area, two pixels"),
    note="A head's sticker fills two pixels, the least that the vision delivers, 2.4 m from the camera if it is seen "
    "straight on, nearer by if not; the field is 3 m long.",
)  # fmt: skip
