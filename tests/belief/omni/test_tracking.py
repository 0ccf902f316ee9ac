"""The filters of the tracking: the textbook's Kalman filter, a line fitted to readings, one thing followed by them."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env.belief.omni import players, tracking
from soccer_env.belief.omni.kalman import COVARIANCE, fit_gains, predict_covariance, start_covariance, update_covariance
from soccer_env.belief.omni.tracking import DELAYS, FILTER, MOTION, correct_track, predict, reading_sd, start
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.optics.mirror_camera import ground_distance, image_radius, mirror_parameters
from soccer_env.records.beliefs import TRACK
from soccer_env.records.percepts import SIGHTING
from tests.scenes.staging import MIDDLE

LEAGUE = find_league(MIDDLE)
S, K = LEAGUE.sensors.record(), constants_of(LEAGUE)
DT = 0.02  # [s]

THING = np.dtype([("x", "f8"), ("y", "f8"), ("vx", "f8"), ("vy", "f8")])


@compiled
def covariance_after(P, steps, dt, agility, jitter, age, R, gains):
    """Run a covariance through frames with a reading each; fill the gains (steps, 2)."""
    start_covariance(P[0], R, 3.0)
    for step in range(steps):
        predict_covariance(P[0], dt, agility, jitter)
        gains[step, 0], gains[step, 1] = update_covariance(P[0], age, R)


@compiled
def follow(readings, motions, thing, filter, late, agility, slowing, constants, sensors, settings, found):
    """Track one thing by readings (T, 2) [m] of an age `late` [s]; NaN is none. Fill found (T, 4) with its state."""
    k, s, w = constants[0], sensors[0], settings[0]
    elapsed = 0.0
    for step in range(readings.shape[0]):
        elapsed += k.dt
        x, y = readings[step, 0], readings[step, 1]
        if filter[0].readings > 0:
            predict(thing[0], filter[0], motions[0], agility, slowing, k, s)
        if x == x:
            if filter[0].readings == 0:
                start(thing[0], filter[0], x, y, 4.0, s)
            else:
                correct_track(thing[0], filter[0], x, y, late, elapsed, s, w)
            elapsed = 0.0
        found[step] = thing[0].x, thing[0].y, thing[0].vx, thing[0].vy


@compiled
def move_reading(sighting, motions, frame, frames):
    return tracking.place_of_sighting(sighting[0], motions, frame, frames)


@compiled
def deviation(distance, sensors):
    return reading_sd(distance, sensors[0])


def track(readings: np.ndarray, late: float = 0.0, slowing: float = 0.0, **memory: Any) -> np.ndarray:
    """Return the states (T, 4) of a thing that readings (T, 2) show to a robot that stands."""
    found = np.zeros((len(readings), 4))
    settings = LEAGUE.memory.changed(memory).record()
    scratch = np.zeros(1, MOTION), np.zeros(1, THING), np.zeros(1, FILTER)
    follow(readings, *scratch, late, 4.0, slowing, K, S, settings, found)
    return found


def rolling(steps: int, start: tuple[float, float], velocity: tuple[float, float]) -> np.ndarray:
    """Return the places (T, 2) of a thing that moves evenly."""
    return np.array(start) + DT * np.arange(steps)[:, None] * np.array(velocity)


def noisy(places: np.ndarray, seed: int = 0) -> np.ndarray:
    """Return readings (T, 2) with the errors of the mirror camera."""
    rng, found = np.random.default_rng(seed), np.zeros_like(places)
    for i, (x, y) in enumerate(places):
        distance = np.hypot(x, y)
        along, across = deviation(distance, S)
        line = np.array([x, y]) / distance
        found[i] = places[i] + along * rng.normal() * line + across * rng.normal() * np.array([-line[1], line[0]])
    return found


@pytest.mark.parametrize("distance", [0.5, 2.0, 8.0])
def test_mh02_readings_are_trusted_as_the_mirrors_curve_allows(distance: float) -> None:
    """MH02: half a pixel of a whole one and the blob's own noise, through the slope of the curve."""
    along, across = deviation(distance, S)
    mirror = mirror_parameters(S.view(np.recarray)[0])
    pixels = np.sqrt(LEAGUE.sensors.pixel_noise**2 + 1.0 / 12.0)
    nearer, farther = (ground_distance(mirror, image_radius(mirror, distance) + step) for step in (-0.01, 0.01))
    assert along == pytest.approx(pixels * (farther - nearer) / 0.02, rel=1e-3)
    assert across == pytest.approx(pixels * distance / image_radius(mirror, distance), rel=1e-6)


def test_mh06_the_filter_is_the_textbooks_kalman_filter() -> None:
    """MH06: P = F P F' + Q; K = P H' / (H P H' + R); P = (I - K H) P, here with a reading of some age."""
    for age in (0.0, 0.02, 0.06):
        P, gains = np.zeros(1, COVARIANCE), np.zeros((30, 2))
        covariance_after(P, 30, DT, 4.0, 0.005**2, age, 0.01, gains)
        full, expected = np.diag([0.01, 9.0]), []
        F, H = np.array([[1.0, DT], [0.0, 1.0]]), np.array([1.0, -age])
        G = np.array([0.5 * DT * DT, DT])
        for _ in range(30):
            full = F @ full @ F.T + 16.0 * np.outer(G, G) + np.diag([0.005**2, 0.0])
            gain = full @ H / (H @ full @ H + 0.01)
            full = full - np.outer(gain, H @ full)
            expected.append(gain)
        assert gains == pytest.approx(np.array(expected), rel=2e-3)
        entries = [P[name][0] for name in ("xx", "xv", "vv")]
        assert entries == pytest.approx([full[0, 0], full[0, 1], full[1, 1]], rel=1e-3)


def test_mh06_the_line_fit_is_that_of_least_squares() -> None:
    """MH06: until there are `window` readings the state is what a line through all of them says."""
    readings = noisy(rolling(8, (2.0, 1.0), (0.7, -0.4)))
    found = track(readings, filter="least-squares", window=8.0)
    for n in range(2, 9):
        for axis in range(2):
            slope, now = np.polyfit(DT * np.arange(1 - n, 1), readings[:n, axis], 1)
            assert found[n - 1, [axis, 2 + axis]] == pytest.approx([now, slope], abs=1e-6)
    assert fit_gains(50, 8.0, DT, 0.0) == fit_gains(8, 8.0, DT, 0.0)


@pytest.mark.parametrize("name", ["kalman", "least-squares"])
def test_mh06_filters_smooth_places_find_velocities_and_know_how_old_a_reading_is(name: str) -> None:
    places = rolling(400, (5.0, -3.0), (-0.8, 0.9))
    readings = noisy(places)
    found, raw = track(readings, filter=name), track(readings, filter="none")
    error, raw_error = (np.hypot(*(one[50:, :2] - places[50:]).T).mean() for one in (found, raw))
    assert error < 0.75 * raw_error
    speeds = found[50:, 2:] - np.array([-0.8, 0.9])
    assert abs(speeds.mean(axis=0)).max() < 0.1 and speeds.std(axis=0).max() < 0.6
    assert not raw[:, 2:].any() and np.array_equal(raw[:, :2], readings)
    places = rolling(200, (6.0, -3.0), (-2.0, 2.0))
    late = np.vstack([places[:3], places[:-3]])  # three frames old
    aware, unaware = (np.hypot(*(track(late, late=age, filter=name)[-1, :2] - places[-1])) for age in (0.06, 0.0))
    assert aware < 1e-3 and unaware == pytest.approx(0.06 * np.hypot(2.0, 2.0), rel=0.05)


def test_a_thing_that_is_not_seen_rolls_on_and_slows_down_and_nothing_fails_at_distance_0_or_after_hours() -> None:
    readings = np.full((200, 2), np.nan)
    readings[:50] = rolling(50, (1.0, 0.5), (1.0, 0.0))
    found = track(readings, slowing=0.4)
    speed = np.hypot(*found[49, 2:])
    assert np.hypot(*found[99, 2:]) == pytest.approx(speed - 0.4, abs=1e-6)
    assert found[-1, 2:] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert found[-1, 0] - found[49, 0] == pytest.approx(speed**2 / (2.0 * 0.4), rel=0.02)
    readings = np.full((2000, 2), np.nan)
    readings[0] = readings[1] = readings[-1] = 0.0
    for name in ("kalman", "least-squares", "none"):
        assert np.isfinite(track(readings, filter=name, late=0.06)).all()
    P, gains = np.zeros(1, COVARIANCE), np.zeros((1, 2))
    covariance_after(P, 1, 3600.0, 4.0, 0.0, 0.0, 1e-4, gains)
    assert np.isfinite(gains).all()


def test_a_picture_is_moved_by_the_odometry_since_its_exposure() -> None:
    motions, sighting = np.zeros(DELAYS, MOTION), np.zeros(1, SIGHTING)
    sighting["distance"], sighting["bearing"] = 2.0, 0.5
    point = np.array([2.0 * np.cos(0.5), 2.0 * np.sin(0.5)])
    assert move_reading(sighting, motions, 7, 0) == pytest.approx(tuple(point))
    for frame, (forward, left, turn) in ((6, (0.05, 0.01, 0.1)), (7, (0.02, -0.03, -0.2))):
        motions[frame % DELAYS] = forward, left, turn
        x, y = point[0] - forward, point[1] - left
        point = np.array([np.cos(turn) * x + np.sin(turn) * y, np.cos(turn) * y - np.sin(turn) * x])
    assert move_reading(sighting, motions, 7, 2) == pytest.approx(tuple(point), abs=1e-6)


def test_a_filter_is_as_sure_as_it_is_right() -> None:
    """The squared errors of places, over the variance that the filter states, are about 1 on average."""
    ratios = []
    for seed in range(40):
        places = rolling(60, (4.0, 1.0), (0.5, 0.5))
        readings, found = noisy(places, seed), np.zeros((60, 4))
        scratch = np.zeros(1, MOTION), np.zeros(1, THING), np.zeros(1, FILTER)
        follow(readings, *scratch, 0.0, 0.3, 0.0, K, S, LEAGUE.memory.record(), found)
        error = found[-1, :2] - places[-1]
        line = places[-1] / np.hypot(*places[-1])
        ratios.append((error @ line) ** 2 / scratch[2]["along"]["xx"][0])
        ratios.append((error @ [-line[1], line[0]]) ** 2 / scratch[2]["across"]["xx"][0])
    assert 0.5 < np.mean(ratios) < 1.5


def test_memories_that_cannot_be_are_refused() -> None:
    for message, change in (
        ("particles must be 1 to 65536, got 0", {"particles": 0}),
        ("surprise_count must be 1 to 100, got 0", {"surprise_count": 0}),
        ("window must be 2 to 100, got 1", {"window": 1.0}),
        ("filter must be one of kalman, least-squares, none", {"filter": "median"}),
    ):
        with pytest.raises(ValueError, match=message):
            LEAGUE.memory.changed(change)


@pytest.mark.parametrize(("since", "late"), [(0.5, 0.1), (0.06, 0.02), (0.02, 0.02)])
def test_a_fitted_line_takes_the_time_from_one_picture_of_a_player_to_the_next(since: float, late: float) -> None:
    """The track was seen `since` [s] ago, the new picture is `late` [s] old; at least a frame lies between."""
    settings = replace(LEAGUE.memory, filter="least-squares").record()[0]
    track, filter = np.zeros(1, TRACK)[0], np.zeros(1, FILTER)[0]
    track["x"], track["vx"], track["age"], filter["readings"] = 2.0, 0.5, since, 5
    thing, other = np.zeros(1, THING)[0], filter.copy()
    thing["x"], thing["vx"] = 2.0, 0.5
    players.correct_player(track, filter, 2.2, 0.1, 0.0, late, late, K[0], S[0], settings)
    correct_track(thing, other, 2.2, 0.1, late, max(since - late, DT), S[0], settings)
    assert [track[name] for name in THING.names or ()] == pytest.approx([thing[name] for name in THING.names or ()])
    assert track["age"] == late and thing["vx"] != 0.5
