"""A player's range from all its blobs or the largest one, while its head stickers come and go.  [Sacks 2001, 4.1.2]

Sizes of stickers are guesses, so the claim is judged over jerseys of 0.7 to 1.3 times their size.
"""

from functools import partial

import numpy as np

from soccer_env.train.papers.claim import Batch, claim
from soccer_env.train.papers.claims.players import watching
from soccer_env.train.papers.claims.players.jersey import JERSEYS
from soccer_env.train.papers.plots import plot_bins, plots
from soccer_env.train.papers.staging import begin_scene, put, record, still_actions
from soccer_env.train.papers.values import bin_masks, mean, median, ratio, rms, subtract_row_mean
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
    match = watching.stage_watchers(batch, RUNS, sensors={"jersey": jersey, **sensors}, memory=memory)
    put(match, 0, EYE_X, rng.uniform(-0.3, 0.3, RUNS), 0.0)
    distance, bearing = rng.uniform(NEAR, FAR, RUNS), rng.uniform(-0.2, 0.2, RUNS)
    watching.put_facing(match, 1, distance, bearing, rng.uniform(-np.pi, np.pi, RUNS))
    begin_scene(match)

    def read() -> Samples:
        heights, true = watching.blob_heights(match), watching.distance_to_robot(match)
        head, trunk = (np.any(seen, axis=1) for seen in (heights > HEAD_HEIGHT, heights <= HEAD_HEIGHT))  # NaN: False
        return {"range": watching.nearest_seen(match)[0] / true, "head": head, "trunk": trunk, "distance": true}

    found = record(match, watching.stare(match, still_actions(match), SETTLE, SECONDS), read)
    return found | {"distance": found["distance"][:, -1]}


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
    return np.array([median(without[:, j]) / max(median(complete[:, j]), 1e-9) for j in range(len(JERSEYS))])


def worst_sticker_ratio(samples: Samples, blobs: str) -> float:
    """Return the ratio of `sticker_range_ratios` that is farthest from the paper's factor of two."""
    ratios = sticker_range_ratios(samples, blobs)
    return float(ratios[np.argmax(np.abs(np.log(ratios / 2.0)))]) if np.isfinite(ratios).all() else np.nan


def share_without_head_sticker(samples: Samples, j: int, i: int) -> float:
    """Return the share of frames [%] without a head sticker, for jersey `j` in the distance bin `i`."""
    return 100 * (1.0 - mean(samples["head"][bin_masks(samples["distance"], BINS)[i], j]))


def scatter(ranges: np.ndarray) -> float:
    """Return the rms deviation [%] of believed relative ranges (RUNS, jerseys, T) from their mean in each run."""
    return 100 * rms(subtract_row_mean(ranges.reshape(-1, ranges.shape[-1])))


S39 = claim(
    "S39", "4.1.2", "Where head stickers vanish the height of all blobs halves; the largest blob is steadier.",
    f"{RUNS} robots a batch and jersey (stickers of {', '.join(f'{j:g}' for j in JERSEYS)} times their size) "
    f"stare at a player {100 * NEAR:.0f} to {100 * FAR:.0f} cm away, seen from any side; share of frames without a "
    "head sticker; scatter of the believed over the true range in each run; that ratio in frames with a trunk alone "
    "over frames with trunk and head (for these 30 % of the stickers are missed, so that there are enough).",
    measured("combined: range without the head over that with it", worst_sticker_ratio, "combined", at_least=1.5,
             at_most=2.5),
    measured("largest blob: the same, in the worst jersey",
             lambda samples: float(sticker_range_ratios(samples, "largest").max()), at_most=1.2),
    measured("scatter of the largest blob's range over that of the combined",
             ratio, "largest", "combined", scatter, below=1.0),
    *(reported(f"frames without a head sticker at the far end, 2.3 to 2.6 m, stickers {jersey:g} times as large",
               share_without_head_sticker, j, len(BINS) - 2, unit="%") for j, jersey in enumerate(JERSEYS)),
    reported("scatter, largest blob", lambda s: scatter(s["largest"]), unit="%"),
    reported("scatter, combined", lambda s: scatter(s["combined"]), unit="%"),
    measure=compare_blobs,
    figures=plots(plot_bins("Scatter of a player's range", "distance [cm]", "deviation [%]",
                            {"largest blob": "largest", "all blobs": "combined"}, "distance", BINS, scatter, 1.0),
                  plot_bins("Frames without a head sticker", "distance [cm]", "share of frames [%]",
                            {f"stickers {jersey:g} times as large": partial(lambda s, j: s["head"][:, j], j=j)
                             for j, jersey in enumerate(JERSEYS)}, "distance", BINS, lambda head: 1.0 - mean(head))),
    seconds=2.0,
    ingredients=("sensors.sticker_*, all assumed", "sensors.sticker_miss", "sensors.least_area, two pixels"),
    note="A head's sticker fills two pixels, the least that the vision delivers, 2.4 m from the camera if it is seen "
    "straight on, nearer by if not; the field is 3 m long.",
)  # fmt: skip
