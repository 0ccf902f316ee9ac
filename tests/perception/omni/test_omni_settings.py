"""Settings of the middle-size robots' sensors that cannot be are refused, with a word on what is allowed."""

from typing import Any

import pytest

from soccer_env.leagues import find_league
from tests.scenes.staging import MIDDLE

LEAGUE = find_league(MIDDLE)


@pytest.mark.parametrize(("change", "message"), [
    ({"lines": 33}, "lines must be 1 to 32, got 33"), ({"lines": 0}, "lines must be 1 to 32, got 0"),
    ({"image": 8}, "image must be 16 to 4096, got 8"), ({"camera_delay": 4}, "camera_delay must be 0 to 3, got 4"),
    ({"ball_miss": 1.5}, "ball_miss must be 0 to 1, got 1.5"),
    ({"radio_loss": 1.1}, "radio_loss must be 0 to 1, got 1.1"),
    ({"mirror_eccentricity": 0.9}, "mirror_eccentricity must be 1 to 1000, got 0.9"),
    ({"mirror_edge": 0.0}, "mirror_edge must be 0.001 to 1000, got 0"),
    ({"detection_width": 0.0}, "detection_width must be 0.001 to 1000000, got 0"),
    ({"light_period": 0.0}, "light_period must be 0.001 to 1000000, got 0"),
    ({"hidden_radius": 10.0}, "hidden_radius must be less than mirror_edge 10.0, got 10.0"),
])  # fmt: skip
def test_sensors_that_cannot_be_are_refused(change: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        LEAGUE.sensors.changed(change)
