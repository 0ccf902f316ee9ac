"""The ball that a middle-size robot tracks: its velocity, kicks, false balls, own motion, delay, the light barrier."""

from math import inf

import numpy as np
import pytest

from soccer_env.belief.omni.ball import BALL_MEMORY
from soccer_env.belief_types import BALL_BELIEF
from tests.belief.omni.staged_omni import begin, in_frame, off, run, state, thinking
from tests.scenes.staging import asking, put, put_ball, stand

BOTH = pytest.mark.parametrize("name", ["kalman", "least-squares"])


@BOTH
def test_mh06_a_ball_that_rolls_by_is_tracked_with_its_velocity(name: str) -> None:
    """MH06: (x, y, vx, vy); the last reading alone knows no velocity."""
    match = thinking(40, memory={"filter": name})
    put_ball(match, 2.0, -2.0, -0.5, 3.0)
    begin(match)
    run(match, 0.5)
    place, velocity = off(match)
    assert np.median(place) < 0.03 and np.median(velocity) < 0.45
    ball = match.beliefs["ball"][:, 0]
    assert (ball["confidence"] == 100.0).all() and ball["age"] == pytest.approx(0.02)
    x, y, vx, vy = state(ball).T
    assert ball["radial"] == pytest.approx((x * vx + y * vy) / np.hypot(x, y))
    assert ball["angular"] == pytest.approx((x * vy - y * vx) / (x * x + y * y))


def test_mh06_without_a_filter_there_is_the_last_reading_and_no_velocity() -> None:
    """MH06: switched off."""
    match = thinking(20, memory={"filter": "none"})
    put_ball(match, 2.0, -2.0, -0.5, 3.0)
    begin(match)
    run(match, 0.5)
    ball = match.beliefs["ball"][:, 0]
    assert not ball["vx"].any() and not ball["vy"].any()
    assert ball["x"] == pytest.approx(ball["distance"] * np.cos(ball["bearing"]), abs=1e-6)
    assert np.median(off(match)[1]) > 2.5


@BOTH
def test_mh06_tracking_steadies_the_place_of_a_ball_at_rest(name: str) -> None:
    """MH06: the filtered place is better than the raw one."""
    match = thinking(30, memory={"filter": name})
    put_ball(match, 5.0, 1.0)
    begin(match)
    raw, filtered, speeds = [], [], []
    for step in range(150):
        match.step(stand(match))
        if step > 50:
            ball = match.beliefs["ball"][:, 0]
            x, y = ball["distance"] * np.cos(ball["bearing"]), ball["distance"] * np.sin(ball["bearing"])
            raw.append(np.hypot(x - 5.0, y - 1.0))
            filtered.append(off(match)[0])
            speeds.append(np.hypot(ball["vx"], ball["vy"]))
    assert np.mean(filtered) < 0.75 * np.mean(raw)
    assert np.mean(speeds) < 0.6


@BOTH
def test_mh06_after_a_kick_the_velocity_is_soon_right_again(name: str) -> None:
    """MH06: within a fifth of a second, by the filter itself or because the track starts anew."""
    match = thinking(30, memory={"filter": name})
    put_ball(match, 3.0, -1.0)
    begin(match)
    run(match, 0.4)
    put_ball(match, 3.0, -1.0, -3.0, 7.0)
    match.rebuild()
    run(match, 0.2)
    assert np.median(off(match)[1]) < 1.2
    assert np.median(off(match)[0]) < 0.15


@BOTH
def test_mh06_a_ball_that_is_somewhere_else_is_believed_there_after_some_readings(name: str) -> None:
    """MH06: `surprise_count` readings in a row, not one, and not only when the old track has faded."""
    match = thinking(30, memory={"filter": name})
    put_ball(match, 3.0, -1.0)
    begin(match)
    run(match, 0.4)
    put_ball(match, 2.0, 1.5)
    match.rebuild()
    match.step(stand(match))
    assert np.median(off(match)[0]) > 2.0  # the picture is late, and one reading is not enough
    run(match, 0.2)
    assert np.median(off(match)[0]) < 0.1


def test_single_false_balls_are_ignored() -> None:
    match = thinking(60, sensors={"false_balls": 0.05})
    put_ball(match, 4.0, 0.0)
    begin(match)
    run(match, 0.4)
    raw_off, believed_off = [], []
    for _ in range(100):
        match.step(stand(match))
        ball = match.beliefs["ball"][:, 0]
        raw_off.append(abs(ball["distance"] * np.exp(1j * ball["bearing"]) - 4.0) > 1.0)
        believed_off.append(off(match)[0] > 0.5)
    assert np.mean(raw_off) > 0.02
    assert np.mean(believed_off) < 0.1 * np.mean(raw_off)


def test_with_a_surprise_count_of_one_every_false_ball_is_believed() -> None:
    match = thinking(60, sensors={"false_balls": 0.05}, memory={"surprise_count": 1})
    put_ball(match, 4.0, 0.0)
    begin(match)
    wrong = []
    for _ in range(100):
        match.step(stand(match))
        wrong.append(off(match)[0] > 0.5)
    assert np.mean(wrong) > 0.02


@BOTH
def test_a_ball_at_rest_stays_at_rest_for_a_robot_that_drives_and_turns(name: str) -> None:
    """The velocity is over the ground, in the axes of the robot, whatever the robot does."""
    match = thinking(20, memory={"filter": name})
    put(match, 0, -3.0, -2.0, 0.3)
    put_ball(match, 0.0, 1.5)
    begin(match)
    speeds, places = [], []
    for step in range(75):
        match.step(asking(match, 0, 0.6, 0.5, 0.15))  # beyond 4 m/s2 the wheels would slip
        if step > 30:
            speeds.append(off(match)[1])
            places.append(off(match)[0])
    assert np.median(speeds) < 0.5 and np.median(places) < 0.04
    ball, own = match.beliefs["ball"][:, 0], match.beliefs["own"][:, 0]
    vx, vy = ball["vx"] - own["forward"], ball["vy"] - own["left"]
    square = ball["x"] ** 2 + ball["y"] ** 2
    assert ball["angular"] == pytest.approx((ball["x"] * vy - ball["y"] * vx) / square - own["turn"])


def test_a_ball_that_is_not_seen_is_carried_by_the_odometry_and_fades() -> None:
    match = thinking(10)
    put_ball(match, 1.5, 0.5)
    begin(match)
    run(match, 1.0)
    before = match.beliefs["ball"]["confidence"][:, 0].copy()
    match.batch.senses.sensors["ball_miss"] = 1.0
    run(match, 1.0, asking(match, 0, 0.0, 0.0, 0.5))
    ball = match.beliefs["ball"][:, 0]
    assert np.median(off(match)[0]) < 0.25
    assert before.tolist() == [100.0] * 10
    assert ball["confidence"] == pytest.approx(75.0, abs=0.6)
    assert ball["age"] == pytest.approx(1.02, abs=0.021)
    true = in_frame(match, 0, match.balls)
    bearing = np.arctan2(true[:, 1], true[:, 0])
    assert abs(np.angle(np.exp(1j * (ball["bearing"] - bearing)))).max() < 0.1


@pytest.mark.parametrize("compensated", [True, False])
def test_delay_is_made_good_by_comparing_with_the_state_at_the_exposure(compensated: bool) -> None:
    """Three frames late, a robot that turns at 3 rad/s sees everything 10 degrees off, a ball at 3 m/s 18 cm."""
    match = thinking(20, sensors={"camera_delay": 3}, memory={"delay_compensation": compensated})
    put_ball(match, 2.5, -2.0, 0.0, 3.0)
    begin(match)
    run(match, 0.6, asking(match, 0, turn=0.5))
    place = off(match)[0]
    assert np.median(place) < 0.06 if compensated else np.median(place) > 0.2
    assert match.beliefs["ball"]["age"][:, 0] == pytest.approx(0.06)


def test_a_ball_never_seen_is_nowhere_and_endlessly_old() -> None:
    match = thinking(sensors={"ball_miss": 1.0})
    begin(match)
    run(match, 0.3, asking(match, 0, 0.5, 0.0, 0.5))
    ball = match.beliefs["ball"][0, 0]
    assert ball["confidence"] == 0.0 and ball["age"] == inf
    assert all(np.isfinite(ball[name]) for name in BALL_BELIEF.names if name != "age")
    assert ball["distance"] == ball["x"] == ball["y"] == ball["vx"] == 0.0


def test_a_ball_lost_for_long_has_no_velocity_and_needs_two_readings() -> None:
    match = thinking()
    put_ball(match, 1.0, 0.0, 2.0, 0.0)
    begin(match)
    run(match, 0.3)
    sensors = match.batch.senses.sensors
    sensors["ball_miss"] = 1.0
    run(match, 4.1)
    ball = match.beliefs["ball"][0, 0]
    assert ball["confidence"] == 0.0 and ball["vx"] == ball["vy"] == 0.0 and 4.0 < ball["age"] < 4.3
    sensors["ball_miss"] = 0.0
    run(match, 0.04)
    assert match.beliefs["ball"]["confidence"][0, 0] == 0.0  # the picture is a frame late: one reading
    run(match, 0.02)
    assert match.beliefs["ball"]["confidence"][0, 0] == 100.0


def test_a_robot_that_is_put_somewhere_and_told_forgets_the_ball() -> None:
    match = thinking(1, 1, 1)
    put(match, 1, 3.0, 1.0)
    begin(match)
    run(match, 0.5)
    assert match.tracks["present"][0, 0].sum() == 1
    match.batch.senses.sensors["ball_miss"] = match.batch.senses.sensors["player_miss"] = 1.0
    run(match, 0.1)
    match.robots["placed"][0, 0] = 1
    match.batch.senses.step(0, 1)
    assert match.beliefs["ball"]["confidence"][0, 0] == 0.0 and match.beliefs["ball"]["age"][0, 0] == inf
    assert match.tracks["present"][0, 0].sum() == 0


def test_the_light_barrier_tells_of_the_ball_that_the_body_hides() -> None:
    match = thinking()
    front = match.league.body.front + match.league.ball.radius
    put_ball(match, front + 0.001, 0.0)
    begin(match)
    run(match, 0.2)
    ball = match.beliefs["ball"][0, 0]
    assert match.percepts["ball"]["seen"][0, 0] == 0
    assert ball["held"] == 1 and ball["confidence"] == 100.0 and ball["age"] == 0.0
    assert (ball["x"], ball["y"]) == pytest.approx((front, 0.0), abs=0.01)
    run(match, 1.0, asking(match, 0, 0.3, 0.0, 0.0))
    ball = match.beliefs["ball"][0, 0]
    assert match.robots["vx"][0, 0] > 0.5 and ball["held"] == 1
    assert ball["vx"] == pytest.approx(match.robots["vx"][0, 0], abs=0.15)  # it goes with the robot
    assert ball["radial"] == pytest.approx(0.0, abs=0.15)


def test_a_light_barrier_that_errs_moves_no_ball() -> None:
    match = thinking(20, sensors={"barrier_miss": 0.02})
    put_ball(match, 4.0, 0.0)
    begin(match)
    for _ in range(100):
        match.step(stand(match))
        assert off(match)[0].max() < 0.5
    match = thinking(20, sensors={"barrier_miss": 0.02, "ball_miss": 1.0})
    begin(match)
    trusted = []
    for _ in range(100):
        match.step(stand(match))
        trusted.append(match.beliefs["ball"]["confidence"][:, 0] > 0.0)
    assert np.mean(trusted) < 0.1


def test_ones_own_kick_is_believed_at_once() -> None:
    match = thinking(10)
    put_ball(match, match.league.body.front + match.league.ball.radius + 0.001, 0.0)
    begin(match)
    run(match, 0.2)
    run(match, 0.02, asking(match, 0, kick=0.5))
    run(match, 0.2)
    assert np.median(off(match)[1]) < 0.8


def test_the_memory_of_a_ball_is_small() -> None:
    assert BALL_MEMORY.itemsize <= 128
