"""How a player of sacks-2001 notices that it is stuck, by readings in which the ball comes no nearer, and gets free."""

from math import atan2, cos, pi, sin
from statistics import NormalDist

import numpy as np
import pytest

from soccer_env import make_team
from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, DRIBBLE, ROTATE, SHOOT, SIDESTEP, SUPPORT
from soccer_env.baselines.sacks_2001.recovery import surplus_on_left
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.records.beliefs import TRACK
from tests.scenes.sacks_mind import LEAGUE, RATE, Mind

COUNT = SacksSettings().stuck_count
HAS_BALL = (DRIBBLE, SHOOT)  # what is done with a ball that is not gone for
READING = 1.0 / 3.0  # [s] between two readings
FAR = 0.6  # [m] from the ball, and not near it
CAMERA = LEAGUE.head.camera_ahead  # [m] from which a ball is near or not
NOISE = 0.21  # [1/(m s)] sd of the filtered radial velocity over distance squared, at 88x72, simulated


@pytest.mark.parametrize("radial", [0.0, 0.1, -0.02])
def test_ms19_a_ball_that_does_not_come_nearer_is_counted_until_the_robot_is_stuck(radial: float) -> None:
    mind = Mind()
    mind.see_ball(FAR, radial=radial)
    mind.think(COUNT * READING - 0.2)
    assert mind.memory["stuck"] == COUNT - 1 and mind.memory["behaviour"] == APPROACH
    assert mind.does(0.4) == BACK


def test_ms19_a_ball_that_clearly_comes_nearer_is_taken_off_and_the_count_is_never_below_zero() -> None:
    mind = Mind()
    mind.see_ball(FAR)
    mind.think(5 * READING + 0.1)
    assert mind.memory["stuck"] == 5
    mind.see_ball(FAR, radial=-0.12)
    mind.think(3 * READING)
    assert mind.memory["stuck"] == 2
    mind.think(9 * READING)
    assert mind.memory["stuck"] == 0
    mind.see_ball(FAR)
    mind.think(2 * READING)
    assert mind.memory["stuck"] == 2


def test_ms19_between_the_bands_the_count_rests() -> None:
    mind = Mind()
    mind.see_ball(FAR)
    mind.think(3 * READING + 0.1)
    mind.see_ball(FAR, radial=-0.04)
    mind.think(9 * READING)
    assert mind.memory["stuck"] == 3


def test_ms19_a_ball_that_reappears_counts_only_from_its_second_reading_on() -> None:
    """Its first reading is only stored, with a velocity of 0 that says nothing."""
    for unseen, counted in ((1.0, 1), (1.6, 0)):
        mind = Mind()
        mind.see_ball(FAR)
        mind.belief["ball"]["age"] = unseen
        mind.think(3 * READING)
        mind.see_ball(FAR)
        mind.memory["reading"] = 0.0
        mind.think(READING + 0.03)
        assert mind.memory["stuck"] == counted
        mind.think(2 * READING)
        assert mind.memory["stuck"] == counted + 2


@pytest.mark.parametrize("distance", [0.6, 1.8, 2.5])
def test_ms19_however_wrong_velocities_are_the_count_falls_for_who_walks_and_rises_for_who_stands(distance) -> None:
    errors = [NOISE * distance**2 * NormalDist().inv_cdf((i + 0.5) / 400) for i in range(400)]
    for speed, falls in ((LEAGUE.drive.forward, True), (0.0, False)):
        mind = Mind(stuck_count=10_000)
        mind.stand_at(-1.4, 0.0)
        mind.memory["stuck"] = begun = 1000
        for error in errors:
            mind.see_ball(distance, radial=error - speed)
            mind.memory["reading"] = READING
            mind.think()
        assert (mind.memory["stuck"] < begun) == falls


def test_ms20_near_the_ball_both_counters_must_agree() -> None:
    one, two = Mind(two_counters=False), Mind()
    for mind in (one, two):
        mind.see_ball(0.3)
        mind.think(COUNT * READING + 0.2)
    assert one.memory["behaviour"] == BACK and two.memory["behaviour"] == APPROACH
    assert two.does(SacksSettings().near_time - COUNT * READING - 0.3) == APPROACH
    assert two.does(0.3) == BACK


def test_ms20_the_second_counter_is_time_within_35_cm_of_the_camera_and_time_beyond_is_taken_off() -> None:
    mind = Mind(stuck_count=1000)
    mind.see_ball(CAMERA + 0.34)
    mind.think(3.0)
    assert mind.memory["near"] == pytest.approx(3.0)
    mind.see_ball(CAMERA + 0.36)
    mind.think()
    assert mind.memory["near"] == pytest.approx(3.0 - 1.0 / RATE)
    mind.think(4.0)
    assert mind.memory["near"] == 0.0
    mind.see_ball(CAMERA + 0.34, bearing=0.5)  # aside it is farther from the camera than ahead
    mind.think()
    assert mind.memory["near"] == 0.0


def test_ms20_one_reading_beyond_35_cm_neither_ends_the_time_nor_makes_a_robot_think_itself_stuck() -> None:
    mind = Mind()
    mind.see_ball(CAMERA + 0.3)
    mind.think(5.0)
    mind.belief["ball"]["distance"] = CAMERA + 0.4  # one estimate; the mean of the last four is still near
    mind.think()
    assert mind.memory["near"] == pytest.approx(5.0 + 1.0 / RATE) and mind.memory["behaviour"] == APPROACH


def test_ms21_within_35_cm_steps_shrink_with_the_distance_until_the_ball_hardly_comes_nearer() -> None:
    speeds = []
    for gap in (0.36, 0.349, 0.175, 0.05, 0.01):
        mind = Mind()
        mind.see_ball(CAMERA + gap)
        speeds.append(mind.think()[0, 0])
    share = np.array(speeds) / speeds[0]
    least = SacksSettings().near_step
    np.testing.assert_allclose(share, [1.0, 0.349 / 0.35, 0.5, least, least], rtol=1e-6)
    assert speeds[-1] * LEAGUE.drive.forward <= SacksSettings().near_zero + 1e-9


def test_ms21_who_has_just_had_the_ball_walks_on_at_full_pace() -> None:
    mind = Mind()
    mind.see_ball(CAMERA + 0.01)
    mind.memory["begun"], mind.memory["had_ball"] = 1, 0.1
    mind.belief["obstacle"]["distance"] = 0.2  # an opponent before it: the ball is contested
    assert mind.think()[0, 0] == pytest.approx(1.0)


def test_ms22_only_who_tries_to_get_to_the_ball_counts() -> None:
    supporter, dribbler, attacker = Mind(), Mind(shoots=False), Mind()
    supporter.belief["heard"]["distance"], supporter.belief["heard"]["age"] = 0.2, 0.1
    dribbler.see_ball(0.147, held=1)
    for mind in (supporter, attacker):
        mind.see_ball(FAR)
    for mind in (supporter, dribbler, attacker):
        mind.think(2.0)
    assert supporter.memory["behaviour"] == SUPPORT and dribbler.memory["behaviour"] in HAS_BALL
    assert supporter.memory["stuck"] == dribbler.memory["stuck"] == 0 < attacker.memory["stuck"]


def test_ms22_who_went_on_to_something_else_begins_to_count_anew() -> None:
    for other in ("possession", "support"):
        mind = Mind(stuck_count=1000)
        mind.see_ball(FAR)
        mind.think(2.0)
        assert mind.memory["stuck"] > 0
        if other == "possession":
            mind.see_ball(0.147, held=1)
        else:
            mind.belief["heard"]["distance"], mind.belief["heard"]["age"] = 0.2, 0.1
        mind.think(2.0)
        assert mind.memory["stuck"] == 0 and mind.memory["behaviour"] in (*HAS_BALL, SUPPORT)


STEP = LEAGUE.drive.gait_steps * LEAGUE.dt  # [s]
GOAL = LEAGUE.pitch.length / 2
BEFORE_STUCK = 9 / 3.0 + 0.05  # [s]


def stuck(bearing: float = 0.0, distance: float = 0.5, **settings: float) -> Mind:
    """Return a player that has just begun to recover."""
    mind = Mind(**settings)
    mind.see_ball(distance, bearing)
    for _ in range(100):
        mind.think()
        if mind.memory["behaviour"] == BACK:
            return mind
    raise AssertionError("it never noticed")


@pytest.mark.parametrize("steps", [10, 3])
def test_ms23_a_stuck_robot_takes_ten_steps_back_then_one_aside_then_goes_to_the_ball(steps: int) -> None:
    mind = stuck() if steps == 10 else stuck(back_steps=steps)
    commands = mind.think(steps * STEP - 2.5 * LEAGUE.dt)
    assert (commands[:, 0] == -1.0).all() and (commands[:, 1:4] == 0.0).all()
    assert mind.memory["behaviour"] == BACK
    assert mind.does(4 * LEAGUE.dt) == SIDESTEP
    aside = mind.think(SacksSettings().side_steps * STEP - 4 * LEAGUE.dt)
    assert (abs(aside[:, 1]) == 1.0).all() and (aside[:, 0] == 0.0).all()
    assert mind.does(5 * LEAGUE.dt) == APPROACH and mind.memory["stuck"] == 0


def test_ms23_it_does_so_again_if_it_is_stuck_again_and_counts_the_tries() -> None:
    mind = stuck()
    assert mind.does(10 * STEP + SacksSettings().side_steps * STEP + 0.1) == APPROACH
    assert mind.does(BEFORE_STUCK + 0.2) == BACK and mind.memory["tries"] == 2


def test_ms23_without_recovery_it_pushes_on_for_ever() -> None:
    mind = Mind(recovery=False)
    mind.see_ball(0.5)
    commands = mind.think(20.0)
    assert mind.memory["behaviour"] == APPROACH and (commands[:, 0] > 0.9).all()


def test_ms24_the_step_aside_brings_the_ball_between_the_robot_and_the_goal() -> None:
    rng = np.random.default_rng(24)
    for _ in range(40):
        x, y, heading = rng.uniform(-1.0, 0.5), rng.uniform(-0.6, 0.6), rng.uniform(-2.0, 2.0)
        mind = stuck()
        mind.stand_at(x, y, heading)
        assert mind.does(10 * STEP) == SIDESTEP
        side = float(mind.memory["side"])
        ball_x, ball_y = x + 0.5 * cos(heading), y + 0.5 * sin(heading)
        to_goal = atan2(-ball_y, GOAL - ball_x)
        off = {
            s: misalignment(x - 0.05 * s * sin(heading), y + 0.05 * s * cos(heading), ball_x, ball_y, to_goal)
            for s in (1.0, -1.0)
        }
        assert off[side] < off[-side] and abs(side) == 1.0


def misalignment(x: float, y: float, ball_x: float, ball_y: float, to_goal: float) -> float:
    """Return the angle [rad] between the way from a place to the ball and that from the ball to the goal."""
    angle = atan2(ball_y - y, ball_x - x) - to_goal
    return abs((angle + pi) % (2.0 * pi) - pi)


@pytest.mark.parametrize("side", [1, -1])
def test_ms25_a_ball_more_than_30_degrees_aside_is_turned_to_instead(side: int) -> None:
    for degrees, behaviour in ((29.0, SIDESTEP), (31.0, ROTATE)):
        mind = stuck(side * degrees * pi / 180.0)
        commands = mind.think(10 * STEP + 0.2)
        assert mind.memory["behaviour"] == behaviour
    assert (np.sign(commands[-2:, 2]) == side).all() and (commands[-2:, :2] == 0.0).all()


def test_ms25_one_that_faces_the_ball_goes_to_it() -> None:
    mind = stuck(2.0)
    assert mind.does(10 * STEP + 0.5) == ROTATE
    mind.see_ball(0.5, 0.1)
    assert mind.does(2 * LEAGUE.dt) == APPROACH


@pytest.mark.parametrize(("players", "surplus"), [
    ([], 0), ([(0.2, 0.1)], 1), ([(0.2, -0.1)], -1), ([(0.2, 0.1), (0.1, -0.2)], 0), ([(0.2, -0.1), (0.1, -0.2)], -2),
])  # fmt: skip
def test_the_players_beside_a_stuck_robot_are_counted_to_the_left_and_off_to_the_right(players, surplus):
    tracks = np.zeros(5, TRACK)
    for track, (x, y) in zip(tracks, players, strict=False):
        track["present"], track["x"], track["y"], track["distance"] = 1, x, y, np.hypot(x, y)
    assert surplus_on_left(tracks, make_team("sacks-2001").settings[0]) == surplus
