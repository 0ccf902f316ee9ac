"""Settings of sensors that cannot be are refused, with a word on what is allowed."""

import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.scenes.staging import LEGGED, MIDDLE


@pytest.mark.parametrize(("league", "changes", "complaint"), [
    (LEGGED, {"ball_miss": 1.5}, "LeggedSensors.ball_miss must be 0 to 1, got 1.5"),
    (LEGGED, {"view_width": 0.0}, "view_width must be 0.0174533 to 3.12414, got 0.0"),
    (LEGGED, {"infrared_near": 0.95}, "infrared_near must be at most infrared_far 0.9, got 0.95"),
    (LEGGED, {"patch_low": 1.2}, "patch_low must be at most patch_high 1.0"),
    (LEGGED, {"patches": 3.0}, "patches must be an even whole number"),
    (LEGGED, {"patches": 1000.0}, "patches must be 0 to 64"),
    (LEGGED, {"scale_error": 0.9}, "scale_error must be 0 to 0.5"),
    (LEGGED, {"head_size": 0.0}, "head_size must be 0.001 to 1000000"),
    (LEGGED, {"dither": -1.0}, "dither must be 0 to 1000000"),
    (LEGGED, {"resolution": "640x480"}, "resolution must be one of 44x36, 88x72, 176x144"),
    (MIDDLE, {"lines": 33}, "lines must be 1 to 32, got 33"), (MIDDLE, {"lines": 0}, "lines must be 1 to 32, got 0"),
    (MIDDLE, {"image": 8}, "image must be 16 to 4096, got 8"),
    (MIDDLE, {"camera_delay": 4}, "camera_delay must be 0 to 3, got 4"),
    (MIDDLE, {"mirror_eccentricity": 0.9}, "mirror_eccentricity must be 1 to 1000, got 0.9"),
    (MIDDLE, {"mirror_edge": 0.0}, "mirror_edge must be 0.001 to 1000, got 0"),
    (MIDDLE, {"hidden_radius": 10.0}, "hidden_radius must be less than mirror_edge 10.0, got 10.0"),
])  # fmt: skip
def test_impossible_sensors_are_refused(league: str, changes: dict[str, object], complaint: str) -> None:
    for make in (find_league(league).sensors.changed, lambda changes: Match(league, sensors=changes)):
        with pytest.raises(ValueError, match=complaint.replace(".", r"\.")):
            make(changes)
