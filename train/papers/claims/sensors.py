"""Error against range for every sensor and estimate of both leagues: a study beside the claims."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.evaluate.report import plain_number, table
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import Batch, Curve, Figure, claim
from soccer_env.train.papers.staging import LEGGED, MIDDLE
from soccer_env.train.papers.true_sight import look_first
from soccer_env.train.papers.values import bin_masks, mean, middles_of, rms
from soccer_env.train.papers.verdicts import Samples

MATCHES = 256
SETTLE, SECONDS = 1.5, 1.0  # [s]
DIGITS = 2  # significant digits of the tables
PLAIN = {"patches": 0.0, "red_as_orange": 0.0}
EDGES = {  # [m] of the bins of the distance
    LEGGED: (0.2, 0.4, 0.6, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5),
    MIDDLE: (0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0),
}
BACK = {LEGGED: -1.25, MIDDLE: -5.5}  # [m] x of the robot that looks, facing the other goal
ASIDE = 0.15  # [rad] bearings to either side
LEVEL = -0.15  # [rad] tilt of a head that looks for players
SCALES = {"cm": 100.0, "deg": 180.0 / np.pi, "cm/s": 100.0, "%": 100.0}  # from SI to the unit
ESTIMATES = {  # sensed or estimated quantities whose errors are plotted, and their units
    "ball, range": "cm",
    "ball, filtered range": "cm",
    "ball, range by infrared": "cm",
    "ball, bearing": "deg",
    "ball, velocity along": "cm/s",
    "player, range": "cm",
    "player, bearing": "deg",
    "ball, seen": "%",
    "player, seen": "%",
}


def look_at_things(batch: Batch) -> Samples:
    """Return errors (M, T) of every estimate, and true distances (M,), of still balls and players at all ranges."""
    samples: Samples = {}
    for league in EDGES:
        place = batch.rng(1).uniform(EDGES[league][0], EDGES[league][-1], MATCHES)
        bearing = batch.rng(2).uniform(-ASIDE, ASIDE, MATCHES)
        samples[f"{league} place"] = place
        ball = watch_ball(batch, league, place, bearing)
        if league == LEGGED:
            by_ranger = watch_ball(batch, league, place, bearing, memory={"ball_range": "infrared"})
            ball["ball, range by infrared"] = by_ranger["ball, range"]
        seen = ball | watch_player(batch, league, place, bearing)
        samples |= {f"{league} {name}": values for name, values in seen.items()}
    return samples


def set_up(batch: Batch, league: str, **settings: Any) -> Match:
    """Set up matches in which a robot stands in front of its own goal and looks across the field."""
    if league == LEGGED:
        settings["sensors"] = PLAIN  # a false ball has no true range
    match = staging.stage(batch, league, matches=MATCHES, actions="full", **settings)
    staging.put(match, 0, BACK[league], batch.rng(3).uniform(-0.1, 0.1, MATCHES), 0.0)
    return match


def watch_ball(batch: Batch, league: str, place: np.ndarray, bearing: np.ndarray, **settings: Any) -> Samples:
    """Return the errors of robots' beliefs about a still ball, NaN in frames that do not show it."""
    match = set_up(batch, league, **settings)
    staging.put_ball(match, *staging.point_ahead(match, 0, place, bearing))
    staging.begin_scene(match)
    true, off = staging.distance_to_point(match, 0, match.balls["x"], match.balls["y"])
    if match.league.head.pan_limit > 0.0:
        look_first(match, SETTLE)  # so that no search is needed

    def read() -> Samples:
        ball = match.beliefs["ball"][:, 0]
        errors = {
            "ball, range": ball["distance"] - true,
            "ball, filtered range": ball["filtered_distance"] - true,
            "ball, bearing": staging.wrap_angle(ball["bearing"] - off),
            "ball, velocity along": ball["radial"],
        }
        return where_seen(errors, ball["age"] < newest_picture_age(match), "ball, seen")

    return staging.record(match, staging.watch(match, SECONDS, settle=SETTLE), read)


def watch_player(batch: Batch, league: str, place: np.ndarray, bearing: np.ndarray) -> Samples:
    """Return errors of robots' beliefs about a standing opponent with a random heading, NaN in frames without it."""
    match = set_up(batch, league)
    staging.put_ball(match, -BACK[league], 0.45 * match.league.pitch.width)  # far off, out of the way
    staging.put(match, 1, *staging.point_ahead(match, 0, place, bearing), batch.rng(4).uniform(-np.pi, np.pi, MATCHES))
    staging.begin_scene(match)
    true, off = staging.distance_to_point(match, 0, match.robots["x"][:, 1], match.robots["y"][:, 1])
    actions, head = staging.still_actions(match), match.league.head
    if head.pan_limit > 0.0:
        actions[..., 4], actions[..., 5] = 1.0, 0.0  # both: a lowered head would hide the other's jersey
        actions[..., 6] = (2.0 * LEVEL - head.tilt_high - head.tilt_low) / (head.tilt_high - head.tilt_low)

    def read() -> Samples:
        tracks = match.tracks[:, 0]
        usable = (tracks["present"] == 1) & (tracks["teammate"] == 0)
        slot = np.where(usable, tracks["age"], np.inf).argmin(axis=1)
        track = tracks[np.arange(MATCHES), slot]
        seen = usable[np.arange(MATCHES), slot] & (track["age"] < newest_picture_age(match))
        errors = {
            "player, range": track["distance"] - true,
            "player, bearing": staging.wrap_angle(track["bearing"] - off),
        }
        return where_seen(errors, seen, "player, seen")

    return staging.record(match, staging.watch(match, SECONDS, actions, SETTLE), read)


def newest_picture_age(match: Match) -> float:
    """Return the greatest age [s] of an object seen in the newest picture, which may be delivered late."""
    late = getattr(match.league.sensors, "camera_delay", 0)
    return (late + 0.5) * match.league.dt


def where_seen(errors: Samples, seen: np.ndarray, name: str) -> Samples:
    """Return the errors, NaN where the object is not seen, and, as `name`, whether it is seen."""
    return {key: np.where(seen, error, np.nan) for key, error in errors.items()} | {name: seen.astype(float)}


def error_by_distance(samples: Samples, league: str, name: str) -> list[float]:
    """Return the rms error of an estimate in each bin of the distance, or for "... seen" the share of frames."""
    errors, value = samples[f"{league} {name}"], mean if name.endswith("seen") else rms
    inside = bin_masks(samples[f"{league} place"], EDGES[league])
    return [SCALES[ESTIMATES[name]] * value(errors[there]) for there in inside]


def sensor_figures(samples: Samples) -> Sequence[Figure]:
    """Plot the errors of all estimates against the distance, one figure for each league and unit."""
    figures = []
    for league in EDGES:
        for unit in SCALES:
            curves = tuple(
                Curve(name, middles_of(EDGES[league], 100), error_by_distance(samples, league, name))
                for name in ESTIMATES if f"{league} {name}" in samples and ESTIMATES[name] == unit
            )  # fmt: skip
            label = "share of frames [%]" if unit == "%" else f"rms error [{unit}]"
            figures.append(Figure(f"Sensors of {league}", "distance [cm]", label, curves))
    return figures


def sensor_tables(samples: Samples) -> str:
    """Return the table of each league: a row for each estimate, a column for each bin of the distance."""
    parts = ["Rms errors in frames that show the thing, and the share of frames that do:"]
    for league, edges in EDGES.items():
        head = (league, *(f"{low:g} to {high:g} m" for low, high in zip(edges, edges[1:], strict=False)))
        rows = []
        for name in (name for name in ESTIMATES if f"{league} {name}" in samples):
            cells = [plain_number(x, DIGITS).replace("nan", "-") for x in error_by_distance(samples, league, name)]
            rows.append((f"{name} [{ESTIMATES[name]}]", *cells))
        parts.append(table(head, rows))
    return "\n\n".join(parts)


SENSORS = claim(
    "sensors", "", "Error against range for every sensor and estimate.",
    f"{MATCHES} robots a batch stand and look at a still ball, or at an opponent who stands any way round.",
    measure=look_at_things, figures=sensor_figures, study=True, batches=4, seconds=4.0,
    ingredients=("all settings of leagues/legged_sensors.py and leagues/omni_sensors.py",),
    note=sensor_tables,
)  # fmt: skip
