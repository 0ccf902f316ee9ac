"""A jersey of stickers, seen from all sides and from afar; all its blobs, or the largest one.  [Sacks 2001, 4.1.2]

Sizes of stickers are guesses, so each claim here is judged over jerseys of 0.7 to 1.3 times their size; the worst
jersey counts.
"""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import Ablation, Batch, claim
from soccer_env.train.papers.claims.players import watching
from soccer_env.train.papers.plots import Drawing, columns, part, plot, plot_bins, plots
from soccer_env.train.papers.staging import OPEN_FLOOR, begin_scene, put, record, still_actions
from soccer_env.train.papers.values import mean, median, ratio, rms, row_means, subtract_row_mean
from soccer_env.train.papers.verdicts import Samples, measured

JERSEYS = (0.7, 1.0, 1.3)  # [1] scale of all stickers
RUNS = 32  # of each jersey
SETTLE = 1.0  # [s] for the head to find the player
ROUND = 8.5  # [s] of a full turn at full speed
NEAR, FAR = 0.5, 1.0  # [m]
SECTORS = 12  # of 30 degrees, the first one head-on
FRONT, SIDES = (0,), (3, 9)  # sectors head-on and from the sides
ALL, ASIDE = tuple(range(SECTORS)), tuple(range(1, SECTORS))  # all of them, and all but head-on
# [m] of the flank's stickers, for a jersey of equal stickers, side by side on chest and rump
FLANK = {"width": 0.06, "height": 0.06, "apart": 0.062}
ALIKE: dict[str, Any] = {f"sticker_{place}_{name}": size for place in ("chest", "rump") for name, size in FLANK.items()}
SIZES = {
    "width": "width of the largest blob",
    "height": "height of the largest blob",
    "all width": "width of all blobs",
    "all height": "height of all blobs",
}
TABLES = {"front table": "table made head-on", "side table": "table made from the side"}
QUANTITIES = (*SIZES, *TABLES)


def box_sizes(match: Match) -> Samples:
    """Return width and height (M,) [px] of the opponents' largest blob, and of the box round all opponents' blobs."""
    blobs = match.percepts["opponents"][:, 0]
    there = blobs["area"] > 0
    width = np.where(there, blobs["left"].astype(float) - blobs["right"], 0.0)
    height = np.where(there, blobs["high"].astype(float) - blobs["low"], 0.0)
    largest, rows = (width + height).argmax(axis=1), np.arange(len(blobs))
    left, high = (np.where(there, blobs[end].astype(float), -1e9).max(axis=1) for end in ("left", "high"))
    right, low = (np.where(there, blobs[end].astype(float), 1e9).min(axis=1) for end in ("right", "low"))
    sizes = {"width": width[rows, largest], "height": height[rows, largest], "all width": left - right,
             "all height": high - low}  # fmt: skip
    return {name: np.where(there.any(axis=1), values, np.nan) for name, values in sizes.items()}


def turn_player_once(batch: Batch, jersey: float, view: str, **sensors: Any) -> Samples:
    """Return sizes [px] and relative range errors of a turning player, means (RUNS, SECTORS) over angles of view."""
    rng, settings = batch.rng(), {"jersey": jersey, **sensors}
    place = rng.uniform(NEAR, FAR, RUNS), rng.uniform(-0.4, 0.4, RUNS), rng.uniform(-np.pi, np.pi, RUNS)
    memory = {"player_infrared": False, "player_view": view}
    match = watching.stage_player(batch, RUNS, *place, league=OPEN_FLOOR, sensors=settings, memory=memory)
    actions = still_actions(match)

    def read() -> Samples:
        actions[:, 1, 2] = 1.0
        sector = np.round(watching.view_of(match, 1) / (2.0 * np.pi) * SECTORS).astype(int) % SECTORS
        error = watching.nearest_seen(match)[0] / watching.distance_to_robot(match) - 1.0
        return {"sector": sector, **box_sizes(match), f"{view} table": error}

    rows = record(match, watching.stare(match, actions, SETTLE, ROUND), read)
    sector = rows.pop("sector")
    return {name: mean_by_sector(sector, values) for name, values in rows.items()}


def mean_by_sector(sector: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the means (M, SECTORS) of values (M, T) by their sector (M, T); NaN for an empty sector."""
    return np.stack([row_means(np.where(sector == i, values, np.nan)) for i in range(SECTORS)], axis=1)


def measure_all_sides(batch: Batch, **sensors: Any) -> Samples:
    """Measure how players with jerseys of all sizes are seen; return an array (RUNS, jerseys, SECTORS) for each of
    QUANTITIES.
    """
    runs = []
    for jersey in JERSEYS:
        front, side = (turn_player_once(batch, jersey, view, **sensors) for view in ("front", "side"))
        runs.append(front | {"side table": side["side table"]})
    return {name: np.stack([one[name] for one in runs], axis=1) for name in QUANTITIES}


def variation(sizes: np.ndarray) -> np.ndarray:
    """Return the coefficient of variation [1] over views, mean over runs (jerseys,); sizes (runs, jerseys, views)."""
    middle = np.nan_to_num(row_means(sizes))
    square = np.nan_to_num(row_means((sizes - middle[..., None]) ** 2))
    return np.asarray((np.sqrt(square) / np.maximum(middle, 1e-9)).mean(axis=0))


def front_over_side(samples: Samples) -> np.ndarray:
    """Return the height seen head-on divided by the height seen from the side, for each jersey (jerseys,)."""
    height = samples["height"]
    front, side = height[:, :, FRONT].mean(axis=2), height[:, :, SIDES].mean(axis=2)
    return np.array([mean(front[:, j] / side[:, j]) for j in range(len(JERSEYS))])


def bias(samples: Samples, table: str, sectors: Sequence[int]) -> np.ndarray:
    """Return the mean relative range error [%] for each jersey (jerseys,), over the given sectors of view."""
    errors = samples[f"{table} table"][:, :, list(sectors)]
    return np.array([100 * mean(errors[:, j]) for j in range(len(JERSEYS))])


def plot_over_views(labels: dict[str, str], title: str, unit: str, scale: float) -> Drawing:
    """Return a drawing of quantities (`labels` by name) against the view, for stickers of their own size."""
    own = slice(None), JERSEYS.index(1.0)
    lines = {label: columns(part(name, *own), scale=scale) for name, label in labels.items()}
    return plot(title, "view [degrees from head-on]", unit, [360.0 / SECTORS * i for i in range(SECTORS)], lines)


EQUAL_STICKERS = Ablation(
    "smaller stickers on chest and rump than on the flanks; here all are alike", partial(measure_all_sides, **ALIKE)
)
HOW = (
    f"{RUNS} players a batch and jersey (stickers of {', '.join(f'{j:g}' for j in JERSEYS)} times their size) turn "
    f"once round, {100 * NEAR:.0f} to {100 * FAR:.0f} cm before a robot that stares at them; means in 30-degree sectors"
)

S37 = claim(
    "S37", "4.1.2", "A player's width varies with the view, its height hardly: slightly smaller head-on.",
    f"{HOW}; coefficient of variation of width and height of the box round all stickers over the sectors, and "
    "heights of the largest sticker; the worst jersey counts.",
    measured("player: variation of the width over the height's",
             lambda s: float((variation(s["all width"]) / variation(s["all height"])).min()), at_least=3.0),
    measured("largest sticker: height head-on over that from the side",
             lambda samples: float(front_over_side(samples).max()), below=1.0),
    measure=measure_all_sides,
    figures=plot_over_views(SIZES, "Size of a player by the angle of view", "size [px]", 1.0), seconds=1.5,
    without=EQUAL_STICKERS,
    ingredients=("sensors.sticker_*, all assumed", "the four largest blobs of a colour alone are delivered (MS04)"),
    note="The smallest jersey decides: seen askew from behind its stickers are six blobs, of which four are delivered, "
    "so that the head is missing and the player is a fifth lower. With one sticker on each side of the trunk it varies "
    "5.3 times as much in width.",
)  # fmt: skip

S38 = claim(
    "S38", "4.1.2", "A table made head-on errs towards taking players to be closer than they are.",
    f"{HOW}; relative error of the range by a table made head-on, and by one made from the side, without the "
    "ranger; all sectors but the head-on one; the worst jersey counts.",
    measured("head-on table: mean error in the other views",
             lambda samples: float(bias(samples, "front", ASIDE).max()), unit="%", at_most=0.0),
    measured("head-on table less side table, mean error in all views",
             lambda samples: float((bias(samples, "front", ALL) - bias(samples, "side", ALL)).max()), unit="%",
             below=0.0),
    measure=measure_all_sides,
    figures=plot_over_views(TABLES, "Range error of a player by the angle of view", "mean error [%]", 100.0),
    seconds=1.5,
    without=EQUAL_STICKERS,
    ingredients=("sensors.sticker_*, all assumed", "the tables of perception/legged/calibration.py"),
)  # fmt: skip

# All blobs of a player, or the largest one, while its head stickers come and go

BLOB_RUNS = 48  # of each jersey
SECONDS = 2.0  # [s]
FARTHEST = 2.6  # [m] as far as the field allows
EYE_X = -1.3  # [m] of the robot that looks, at one end of the field
HEAD_HEIGHT = 0.185  # [m] between the middles of the stickers of trunk and head
MANY = {"sticker_miss": 0.3}  # a share of missed stickers that yields enough frames of a trunk without a head
BLOBS = ("largest", "combined")
BINS = (0.5, 0.8, 1.1, 1.4, 1.7, 2.0, 2.3, 2.6)  # [m]


def watch_players(batch: Batch, jersey: float, blobs: str, **sensors: float) -> dict[str, np.ndarray]:
    """Return believed over true range, and whether a sticker of the head and of the trunk is seen (BLOB_RUNS, T).

    "distance" (BLOB_RUNS,) [m] is the true distance.
    """
    rng = batch.rng()
    memory = {"player_blob": blobs, "player_infrared": False}
    match = watching.stage_watchers(batch, BLOB_RUNS, sensors={"jersey": jersey, **sensors}, memory=memory)
    put(match, 0, EYE_X, rng.uniform(-0.3, 0.3, BLOB_RUNS), 0.0)
    distance, bearing = rng.uniform(NEAR, FARTHEST, BLOB_RUNS), rng.uniform(-0.2, 0.2, BLOB_RUNS)
    watching.put_facing(match, 1, distance, bearing, rng.uniform(-np.pi, np.pi, BLOB_RUNS))
    begin_scene(match)

    def read() -> Samples:
        heights, true = watching.blob_heights(match), watching.distance_to_robot(match)
        head, trunk = (np.any(seen, axis=1) for seen in (heights > HEAD_HEIGHT, heights <= HEAD_HEIGHT))  # NaN: False
        return {"range": watching.nearest_seen(match)[0] / true, "head": head, "trunk": trunk, "distance": true}

    found = record(match, watching.stare(match, still_actions(match), SETTLE, SECONDS), read)
    return found | {"distance": found["distance"][:, -1]}


def compare_blobs(batch: Batch) -> Samples:
    """Return relative ranges (BLOB_RUNS, jerseys, T) by both methods: all frames, with and without a head sticker."""
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


def scatter(ranges: np.ndarray) -> float:
    """Return the rms deviation [%] of believed relative ranges (BLOB_RUNS, jerseys, T) from their mean in each run."""
    return 100 * rms(subtract_row_mean(ranges.reshape(-1, ranges.shape[-1])))


S39 = claim(
    "S39", "4.1.2", "Where head stickers vanish the height of all blobs halves; the largest blob is steadier.",
    f"{BLOB_RUNS} robots a batch and jersey (stickers of {', '.join(f'{j:g}' for j in JERSEYS)} times their size) "
    f"stare at a player {100 * NEAR:.0f} to {100 * FARTHEST:.0f} cm away, seen from any side; share of frames without "
    "a head sticker; scatter of the believed over the true range in each run; that ratio in frames with a trunk alone "
    "over frames with trunk and head (for these 30 % of the stickers are missed, so that there are enough).",
    measured("combined: range without the head over that with it", worst_sticker_ratio, "combined", at_least=1.5,
             at_most=2.5),
    measured("largest blob: the same, in the worst jersey",
             lambda samples: float(sticker_range_ratios(samples, "largest").max()), at_most=1.2),
    measured("scatter of the largest blob's range over that of the combined",
             ratio, "largest", "combined", scatter, below=1.0),
    measure=compare_blobs,
    figures=plots(plot_bins("Scatter of a player's range", "distance [cm]", "deviation [%]",
                            {"largest blob": "largest", "all blobs": "combined"}, "distance", BINS, scatter, 1.0),
                  plot_bins("Frames without a head sticker", "distance [cm]", "share of frames [%]",
                            {f"stickers {jersey:g} times as large": part("head", slice(None), j)
                             for j, jersey in enumerate(JERSEYS)}, "distance", BINS, lambda head: 1.0 - mean(head))),
    seconds=2.0,
    ingredients=("sensors.sticker_*, all assumed", "sensors.sticker_miss", "sensors.least_area, two pixels"),
    note="A head's sticker fills two pixels, the least that the vision delivers, 2.4 m from the camera if it is seen "
    "straight on, nearer by if not; the field is 3 m long.",
)  # fmt: skip
