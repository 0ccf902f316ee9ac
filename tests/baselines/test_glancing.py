"""A chaser that is unsure where it is looks up from the ball, and back before it has lost it."""

import numpy as np
import pytest

from soccer_env.baselines.chaser import MEMORY, NUMBERS, team
from soccer_env.baselines.glancing import KEEPER_ROOM, ROOM, look_up
from soccer_env.belief_types import BELIEF
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.optics.head_camera import share_of_tilt
from soccer_env.types import COMMAND
from tests.scenes.staging import LEGGED, MIDDLE

UNSURE, QUITE_LOST = NUMBERS["unsure"][0], NUMBERS["lost"][0]


def tilts(confidence: float, distance: float, keeper: int = 0, age: float = 0.0, bearing: float = 0.2) -> np.ndarray:
    """Return the head, pan and tilt commands (steps, 3) of 3.5 s with a ball seen so."""
    k = constants_of(find_league(LEGGED))[0]
    belief, memory, command = (np.zeros(1, dtype) for dtype in (BELIEF, MEMORY, COMMAND))
    belief["situation"]["active"], belief["situation"]["keeper"] = 1, keeper
    belief["own"]["confidence"] = confidence
    belief["ball"]["distance"], belief["ball"]["bearing"], belief["ball"]["age"] = distance, bearing, age
    told = []
    for _ in range(int(3.5 / k["dt"])):
        command["head"] = -1.0
        look_up(belief[0], command[0], memory[0], k, team().settings[int(k["drive_kind"])])
        told.append((command["head"][0], command["pan"][0], command["tilt"][0]))
    return np.array(told)


def test_who_is_unsure_looks_up_for_a_moment_and_then_at_the_ball_again() -> None:
    up = np.flatnonzero(tilts(UNSURE - 1.0, ROOM + 0.05)[:, 0] > 0.0)
    dt = constants_of(find_league(LEGGED))[0]["dt"]
    looks = np.split(up, np.flatnonzero(np.diff(up) > 1) + 1)
    assert len(looks) == 2
    assert {len(look) for look in looks} == {int(np.ceil(NUMBERS["glance_time"][0] / dt))}
    assert (looks[1][0] - looks[0][-1]) * dt == pytest.approx(NUMBERS["glance_rest"][0], abs=2.0 * dt)


@pytest.mark.parametrize("seen", [
    {"confidence": UNSURE + 1.0, "distance": ROOM + 0.05}, {"confidence": QUITE_LOST + 1.0, "distance": ROOM - 0.01},
    {"confidence": 0.0, "distance": ROOM + 0.05, "age": 0.5},
    {"confidence": QUITE_LOST + 1.0, "distance": ROOM + 0.1, "keeper": 1},
])  # fmt: skip
def test_the_eyes_stay_on_the_ball(seen: dict) -> None:
    assert (tilts(**seen)[:, 0] < 0.0).all()


def test_who_is_quite_lost_looks_up_with_the_ball_at_its_feet() -> None:
    assert (tilts(QUITE_LOST - 1.0, ROOM - 0.01)[:, 0] > 0.0).any()


def test_a_ball_farther_away_is_kept_in_the_picture_below_its_middle() -> None:
    k = constants_of(find_league(LEGGED))[0]
    told = tilts(100.0, KEEPER_ROOM)
    below = np.arctan2(k["head_camera_height"] - k["ball_radius"], KEEPER_ROOM - k["head_camera_ahead"])
    assert (told[:, 0] > 0.0).all() and told[0, 1] * k["head_pan_limit"] == pytest.approx(0.2)
    middle = share_of_tilt(NUMBERS["raised"][0] - below, k["head_tilt_low"], k["head_tilt_high"])
    assert told[0, 2] == pytest.approx(middle)
    assert NUMBERS["raised"][0] < 0.5 * find_league(LEGGED).sensors.view_height


def test_a_sweep_is_mirrored_by_the_side_of_the_ball() -> None:
    one, other = (tilts(0.0, ROOM + 0.05, bearing=side * 0.2) for side in (1.0, -1.0))
    assert (one[:, 1] == -other[:, 1]).all() and (one[:, 2] == other[:, 2]).all()
    assert np.ptp(one[:, 1]) > 0.5


def test_a_camera_that_sees_all_round_is_left_alone() -> None:
    k = constants_of(find_league(MIDDLE))[0]
    belief, memory, command = (np.zeros(1, dtype) for dtype in (BELIEF, MEMORY, COMMAND))
    belief["situation"]["active"], belief["ball"]["distance"] = 1, 1.0
    command["head"] = -1.0
    look_up(belief[0], command[0], memory[0], k, team().settings[int(k["drive_kind"])])
    assert command["head"][0] == -1.0 and memory["glance"][0] == 0.0
