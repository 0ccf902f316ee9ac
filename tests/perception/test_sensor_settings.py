"""Settings of sensors that cannot be are refused, with a word on what is allowed."""

import numpy as np
import pytest
from soccer_env import Match
from soccer_env.leagues.legged_sensors import LeggedSensors

@pytest.mark.parametrize(("changes", "complaint"), [
    ({"ball_miss": 1.5}, "LeggedSensors.ball_miss must be 0 to 1, got 1.5"),
    ({"player_miss": 2.0}, "player_miss must be 0 to 1"), ({"landmark_miss": 1.01}, "landmark_miss must be 0 to 1"),
    ({"red_as_orange": 3.0}, "red_as_orange must be 0 to 1"), ({"audio_loss": 1.2}, "audio_loss must be 0 to 1"),
    ({"view_width": 0.0}, "view_width must be 0.0174533 to 3.12414, got 0.0"),
    ({"view_height": 3.15}, "view_height must be 0.0174533 to 3.12414"),
    ({"infrared_near": 0.95}, "infrared_near must be at most infrared_far 0.9, got 0.95"),
    ({"patch_low": 1.2}, "patch_low must be at most patch_high 1.0"),
    ({"landmark_low": 0.5}, "landmark_low must be at most landmark_high 0.4"),
    ({"trunk_low": 0.2}, "trunk_low must be at most trunk_height 0.18"),
    ({"patches": 3.0}, "patches must be an even whole number"), ({"patches": 1000.0}, "patches must be 0 to 64"),
    ({"scale_error": 0.9}, "scale_error must be 0 to 0.5"), ({"head_size": 0.0}, "head_size must be 0.001 to 1000000"),
    ({"dither": -1.0}, "dither must be 0 to 1000000"),
    ({"resolution": "640x480"}, "resolution must be one of 44x36, 88x72, 176x144"),
])  # fmt: skip
def test_impossible_sensors_are_refused(changes: dict[str, object], complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint.replace(".", r"\.")):
        LeggedSensors(**changes)
    with pytest.raises(ValueError, match=complaint.replace(".", r"\.")):
        Match("legged-2001", sensors=changes)


@pytest.mark.parametrize("changes", [
    {"ball_miss": 1.0}, {"patch_low": 0.5, "patch_high": 0.5}, {"jersey": 0.0}, {"patches": 0.0}, {"view_width": 2.0},
])  # fmt: skip
def test_unusual_sensors_are_allowed(changes: dict[str, float]) -> None:
    match = Match("legged-2001", matches=1, seed=1, observe="belief", sensors=changes)
    for _ in range(3):
        match.step(np.zeros((1, 6, 4)))
    assert np.isfinite(match.observations).all()
    assert set(changes) <= {row[0] for row in LeggedSensors(**changes).rows()}
