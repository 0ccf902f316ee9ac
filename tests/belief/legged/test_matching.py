"""Which player in memory is the one that is seen: likelihood = uncertainty / distance^3 / angle."""

from math import atan2, hypot, inf, pi
from typing import Any

import numpy as np
import pytest

from soccer_env.belief.legged import matching
from soccer_env.belief.legged.matching import inverse_power, match_likelihood, track_uncertainty
from soccer_env.belief.legged.players import age_tracks, remember_player
from soccer_env.compiled import compiled
from soccer_env.leagues.constants import constants_of
from soccer_env.records.beliefs import TRACK
from tests.belief.legged.staged_players import LEAGUE

LINEAR = {"distance_power": 1.0, "angle_power": 0.0}  # what was tried first
CUBIC = {"distance_power": 3.0, "angle_power": 0.0}


def settings(**changes: Any) -> np.void:
    return LEAGUE.memory.changed(changes).record()[0]


def memory(*players: tuple[float, float, float] | None) -> np.ndarray:
    """Return slots with players at x, y [m], robot frame, unseen for an age [s]; None: an empty slot."""
    tracks = np.zeros(len(players), TRACK)
    for track, player in zip(tracks, players, strict=True):
        if player is not None:
            x, y, track["age"] = player
            track["present"], track["x"], track["y"] = 1, x, y
            track["distance"], track["bearing"] = hypot(x, y), atan2(y, x)
    return tracks


def slot_for(tracks: np.ndarray, x: float, y: float, **changes: Any) -> int:
    """Return the slot that a player seen at x, y [m] replaces."""
    return int(matching.likeliest_slot(tracks, 0, len(tracks), x, y, settings(**changes)))


@pytest.mark.parametrize("power", [0.0, 1.0, 2.0, 2.5, 3.0])
def test_powers_may_be_whole_or_not_and_never_overflow(power: float) -> None:
    for value in (1e-3, 0.07, 1.0, 3.6):
        assert inverse_power(value, power) == pytest.approx(value**-power, rel=1e-13)
    for value, huge in ((1e-3, 1e3), (1e-3, 1e300), (4.0, 1e300)):
        assert 0.0 <= inverse_power(value, huge) < inf
    assert slot_for(memory((1, 0, 1), (2, 0, 1), None), 1.0, 0.0, distance_power=1e6, angle_power=1e6) == 0


def test_ms32_uncertainty_grows_from_a_half_to_a_hundred() -> None:
    """MS32: with the time that a player has not been seen for; of two equally near the longer unseen is replaced."""
    ages = [track_uncertainty(memory((1.0, 0.0, age))[0], settings()) for age in (0.0, 3.0, 15.0, 29.85, 60.0, 1e9)]
    assert ages == pytest.approx([0.5, 10.5, 50.5, 100.0, 100.0, 100.0])
    assert track_uncertainty(memory(None)[0], settings()) == 100.0
    assert track_uncertainty(memory((1.0, 0.0, 3.0))[0], settings(uncertainty_growth=0.0)) == 0.5
    assert slot_for(memory((1.0, 0.3, 5.0), (1.0, -0.3, 1.0)), 1.0, 0.0) == 0
    later = memory((1.0, 0.3, 1.0), (1.0, -0.3, 5.0))
    assert (slot_for(later, 1.0, 0.0), slot_for(later, 1.0, 0.0, uncertainty_growth=0.0)) == (1, 0)


def test_ms30_likelihood_is_uncertainty_by_distance_cubed_by_angle() -> None:
    angle = pi / 6
    x, y = 1.2 * np.cos(angle), 1.2 * np.sin(angle)
    distance = hypot(x - 0.7, y)
    found = match_likelihood(memory((0.7, 0.0, 3.0))[0], x, y, angle, settings())
    assert found == pytest.approx(10.5 / distance**3 / angle, rel=1e-12)
    tracks = memory((0.8, 0.0, 1.0), (1.5, 0.5, 1.0), (1.0, -0.8, 1.0))  # all seen equally long ago
    assert [slot_for(tracks, *place) for place in ((0.9, 0.05), (1.3, 0.5), (1.0, -0.6))] == [0, 1, 2]


def test_ms30_no_slot_is_taken_twice_in_one_view() -> None:
    tracks = memory((1.0, 0.0, 0.0), (-1.0, 0.0, 0.1))
    assert slot_for(tracks, 1.0, 0.01) == 1
    tracks["age"] = 0.0
    assert slot_for(tracks, 1.0, 0.01) == -1 and slot_for(tracks[:0], 1.0, 0.0) == -1


def test_ms31_with_the_first_power_an_uncertain_player_far_away_is_replaced() -> None:
    """MS31: 1/d lets uncertainty outweigh the distance; 1/d^3 does not."""
    tracks = memory((1.0, 0.0, 0.0625), (1.6, 0.6, 6.0))
    assert slot_for(tracks, 1.1, 0.0, **LINEAR) == 1 and slot_for(tracks, 1.1, 0.0, **CUBIC) == 0


def test_ms31_the_angle_counts_more_than_the_range() -> None:
    tracks = memory((1.0, 0.0, 1.0), (1.3, 0.25, 1.0))
    assert slot_for(tracks, 1.3, 0.01) == 0 and slot_for(tracks, 1.3, 0.01, angle_power=0.0) == 1


def test_an_empty_slot_is_used_unless_a_player_in_memory_is_near() -> None:
    assert slot_for(memory(None, None), 1.0, 0.0) == 0
    for age, stays, goes in ((0.0625, 0.2, 0.4), (5.0, 0.5, 0.8), (15.0, 0.7, 1.0)):  # [s], [m] aside
        tracks = memory(None, (1.0, 0.0, age))
        assert slot_for(tracks, 1.0, stays) == 1 and slot_for(tracks, 1.0, goes) == 0
    just_seen = memory(None, (1.0, 0.0, 0.0625))
    assert slot_for(just_seen, 1.5, 0.01) == 1  # a range error
    assert slot_for(just_seen, 1.5, 0.01, empty_distance=0.3, empty_angle=0.1) == 0


@compiled
def watch_one(tracks, views, duplicated, k, w):
    """Let robots n see one player at views[n, frame] and no other, after a first sight of all; note in which frames
    another player's slot holds something within 0.45 m of where it is."""
    for n in range(tracks.shape[0]):
        for frame in range(views.shape[1]):
            age_tracks(tracks[n], tracks.shape[1], k[0], w[0])
            x, y = views[n, frame, 0], views[n, frame, 1]
            remember_player(tracks[n], matching.likeliest_slot(tracks[n], 0, tracks.shape[1], x, y, w[0]), x, y, 0)
            near = 0
            for slot in range(tracks.shape[1]):
                aside, away = tracks[n, slot].y, tracks[n, slot].x - 1.0
                if tracks[n, slot].present == 1 and away * away + aside * aside < 0.45 * 0.45:
                    near += 1
            duplicated[n, frame] = near > 1


def duplicate_share(noise: float, **changes: float) -> float:
    """Return the share of 200 robots whose memory holds a player twice within 30 s in which they see it alone.

    It stands 1 m ahead; two others were seen once, 1 m and 1.2 m away, 45 degrees to the sides. `noise` is the
    deviation of the range, 1 the range itself; that of the bearing is half a pixel of the 88x72 camera, 0.36 degrees.
    """
    rng, robots, frames = np.random.default_rng(7), 200, 30 * 16
    distance = 1.0 + noise * rng.standard_normal((robots, frames))
    bearing = np.radians(0.36) * rng.standard_normal((robots, frames))
    views = np.stack([distance * np.cos(bearing), distance * np.sin(bearing)], axis=-1)
    tracks = np.repeat(memory((1.0, 0.0, 0.0), (0.707, 0.707, 0.0), (0.85, -0.85, 0.0))[None], robots, axis=0)
    duplicated = np.zeros((robots, frames), bool)
    watch_one(tracks, views, duplicated, constants_of(LEAGUE), LEAGUE.memory.changed(changes).record())
    return float(duplicated.any(axis=1).mean())


@pytest.mark.parametrize("noise", [0.05, 0.08])
def test_ms31_one_player_fills_the_slots_under_the_first_power_and_not_under_the_final_rule(noise: float) -> None:
    """MS31: S35, "frequently caused a single foe to fill up all three foe slots"; the angle is what prevents it."""
    assert duplicate_share(noise, **LINEAR) > 0.95 and duplicate_share(noise) < 0.02
    assert duplicate_share(noise, **CUBIC) > 0.5
