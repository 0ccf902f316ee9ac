"""What a robot feels of itself: its steps (not the ground that it covers), balance, kicker; a pose from outside."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.omni_sensors import OmniSensors
from soccer_env.perception.body import POSE_ERROR, sense_body, sense_light_barrier
from soccer_env.records.percepts import BODY_PERCEPT, NO_POSE, POSE_SENSED, POSE_TOLD
from soccer_env.types import MATCH, ROBOT, ROBOT_EVENTS
from tests.scenes.leagues import LEGGED, MIDDLE, each_league, steady
from tests.scenes.staging import WALK, place, play, put, record_each_step, robot_actions, stage, stand

EXACT = {"odometry_noise": 0.0}


def feeling(league: Any, matches: int = 1, home: int = 1, away: int = 1, **settings: Any) -> Match:
    """Return matches whose robots feel themselves, robot 0 in the middle and the ball far away."""
    match = stage(league, matches, home, away, observe="percepts", **settings)
    put(match, 0, 0.0, 0.0)
    place(match, ball=(-0.4 * match.league.pitch.length, -0.4 * match.league.pitch.width))
    return match


def body(match: Match) -> np.ndarray:
    """Return what robot 0 of each match feels."""
    return match.percepts["body"][:, 0]


def travelled(match: Match, actions: np.ndarray, steps: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the displacement ahead [m] by odometry and in truth, robot 0 of each match, after some steps."""
    start = match.robots["x"][:, 0].copy()
    felt = record_each_step(match, lambda: body(match)["forward"], 0.0, actions, steps).sum(axis=0)
    return felt, match.robots["x"][:, 0] - start


@each_league
def test_on_firm_ground_the_odometry_is_the_path_and_a_turning_walk_adds_up_to_the_pose(name: str) -> None:
    match = feeling(steady(name), sensors=EXACT)
    felt, true = travelled(match, robot_actions(match, forward=1.0), 40)
    assert true[0] > 0.1 and felt == pytest.approx(true, rel=1e-5)
    match = feeling(steady(name), sensors=EXACT)
    x, y, heading = 0.0, 0.0, 0.0
    for _ in range(48):
        match.step(robot_actions(match, forward=0.2, left=-0.2, turn=0.1))
        one = body(match)[0]
        x += np.cos(heading) * one["forward"] - np.sin(heading) * one["left"]
        y += np.sin(heading) * one["forward"] + np.cos(heading) * one["left"]
        heading += one["turn"]
    robot = match.robots[0, 0]
    assert (x, y) == pytest.approx((robot["x"], robot["y"]), abs=2e-4)  # wheels slide a little as they start
    assert np.cos(heading - robot["heading"]) == pytest.approx(1.0, abs=1e-10)


def test_slip_is_not_felt() -> None:
    match = feeling(LEGGED, 40, sensors=EXACT)
    felt, true = travelled(match, robot_actions(match, forward=1.0), 64)
    assert np.ptp(felt) < 1e-6 and true.std() > 0.01 * true.mean()


@each_league
def test_a_stuck_robot_feels_that_it_walks(name: str) -> None:
    match = feeling(steady(name), sensors=EXACT)
    edge = match.league.pitch.length / 2 + match.league.pitch.band_end
    put(match, 0, edge - match.league.body.reach, 0.4 * match.league.pitch.width)  # its nose at the boards
    match.rebuild()
    felt, true = travelled(match, robot_actions(match, forward=1.0), 4 * match.league.control_rate)
    assert felt > 0.8 * 3.0 * match.league.drive.forward
    assert abs(true) < 0.2 * felt


@each_league
def test_odometry_errs_in_proportion_to_the_step(name: str) -> None:
    match = feeling(steady(name), 40, sensors={"odometry_noise": 0.05})
    found, actions = [], robot_actions(match, forward=0.6, left=0.3, turn=0.5)
    for _ in range(30):
        match.step(actions)  # until everybody walks
    for _ in range(30):
        match.step(actions)
        walk = match.robots["walk"][:, 0]
        found.append([body(match)[part] / (walk[part] * match.league.dt) for part in WALK])
    felt = np.array(found)
    assert felt.mean(axis=(0, 2)) == pytest.approx(1.0, abs=0.01)
    assert felt.std(axis=(0, 2)) == pytest.approx(0.05, rel=0.1)


@each_league
def test_a_standing_robot_feels_no_step_and_one_that_is_out_knows_it(name: str) -> None:
    match, other = feeling(name, 50), feeling(name, home=2)
    for _ in range(10):
        match.step(stand(match))
        assert not any(body(match)[part].any() for part in WALK)
    other.step(stand(other))
    assert other.percepts["body"]["active"][0].tolist() == [1, 0, 0]
    assert (other.percepts["body"]["frame"] == other.matches["step"][0]).all()


def test_ms06_a_robot_feels_whether_it_lies_on_its_side() -> None:
    match = feeling(LEGGED)
    match.step(stand(match))
    assert (body(match)["upright"], body(match)["kicked"]) == (1, 0)
    match.robots["fallen"][:, 0] = 1.0
    match.step(stand(match))
    assert body(match)["upright"] == 0
    play(match, steps=16)
    assert body(match)["upright"] == 1


def test_a_kick_is_felt_in_the_frame_in_which_it_hits() -> None:
    match = feeling(MIDDLE, home=2)
    place(match, ball=(0.18 + 0.11, 0.0), robots={1: (0.0, 0.0), 0: (-3.0, 1.0)})
    match.step(stand(match))
    match.step(robot_actions(match, 1, kick=1.0))
    assert match.percepts["body"]["kicked"][0].tolist() == [0, 1, 0]
    match.step(stand(match))
    assert match.percepts["body"]["kicked"][0].tolist() == [0, 0, 0]


@compiled
def break_barriers(robots, bodies, sensors):  # type: ignore[no-untyped-def]
    for i in range(robots.shape[0]):
        sense_light_barrier(robots[i], bodies[i], sensors[0])


@pytest.mark.parametrize("has_ball", [0, 1])
def test_the_light_barrier_errs_in_its_share_of_the_frames(has_ball: int) -> None:
    robots, bodies = np.zeros(20_000, ROBOT), np.zeros(20_000, BODY_PERCEPT)
    robots["has_ball"], robots["noise"] = has_ball, np.arange(20_000)[:, None] * 7919 + 1
    break_barriers(robots, bodies, OmniSensors(barrier_miss=0.01).record())
    assert (bodies["held"] != has_ball).mean() == pytest.approx(0.01, abs=0.003)
    break_barriers(robots, bodies, OmniSensors(barrier_miss=0.0).record())
    assert (bodies["held"] == has_ball).all()


SHARP = {"pose_noise": 0.0, "pose_turn_noise": 0.0, "place_noise": 0.0, "place_turn_noise": 0.0}


def posed(league: str, matches: int = 1, heading: float = 2.0, **settings: Any) -> Match:
    """Return matches in which robot 0, of home, and 1, of away, stand in the same way seen from their own goals."""
    robots = {0: (0.4, 0.3, heading), 1: (-0.4, -0.3, heading - np.pi)}
    return stage(league, matches, ball=(-1.0, 0.7), robots=robots, **{"observe": "percepts", **settings})


@each_league
def test_without_noise_both_teams_are_given_the_truth_from_their_own_goal(name: str) -> None:
    match = posed(name, sensors=SHARP)
    match.step(stand(match))
    for body in match.percepts["body"][0]:
        assert body["pose"] == POSE_SENSED
        assert (body["x"], body["y"], body["heading"]) == pytest.approx((0.4, 0.3, 2.0), abs=1e-6)


@compiled
def feel(matches, robots, events, bodies, pose_errors, constants, sensors):  # type: ignore[no-untyped-def]
    for i in range(robots.shape[0]):
        sense_body(matches[0], robots[i], events[0], bodies[i], pose_errors[i], constants[0], sensors[0], 1)


def errors_of_many(league: str, frames: int, **sensors: float) -> np.ndarray:
    """Return the errors (frames, N, 3) [m, m, rad] of the poses given to many robots that stand at the centre spot."""
    found = find_league(league)
    robots, bodies, matches = np.zeros(4000, ROBOT), np.zeros(4000, BODY_PERCEPT), np.zeros(1, MATCH)
    robots["noise"] = np.random.default_rng(2).integers(0, 1 << 63, robots["noise"].shape, np.uint64)
    matches["handedness"] = matches["home_direction"] = 1.0
    record, constants = found.sensors.changed(sensors).record(), constants_of(found)
    errors, states = [], np.zeros(4000, POSE_ERROR)
    for _ in range(frames):
        feel(matches, robots, np.zeros(1, ROBOT_EVENTS), bodies, states, constants, record)
        errors.append(np.stack([bodies["x"], bodies["y"], bodies["heading"]], axis=-1))
    return np.array(errors)


@each_league
def test_errors_are_as_large_as_the_settings_say_and_last_for_their_correlation_time(name: str) -> None:
    found = errors_of_many(name, 3, pose_noise=0.1, pose_turn_noise=0.2)
    assert found.mean(axis=1) == pytest.approx(np.zeros((3, 3)), abs=0.015)
    assert found.std(axis=1) == pytest.approx(np.full((3, 3), [0.1, 0.1, 0.2]), rel=0.05)
    frames = round(0.5 * find_league(name).control_rate) + 1
    found = errors_of_many(name, frames, pose_time=0.5)
    for part in range(3):
        assert np.corrcoef(found[0, :, part], found[-1, :, part])[0, 1] == pytest.approx(np.exp(-1.0), abs=0.05)


def test_no_correlation_time_makes_fresh_errors_in_every_frame() -> None:
    first, later = errors_of_many(LEGGED, 2, pose_time=0.0)
    assert abs(np.corrcoef(first[:, 0], later[:, 0])[0, 1]) < 0.05


@each_league
def test_a_robot_that_is_carried_is_told_where(name: str) -> None:
    match = Match(name, home=2, away=2, matches=150, seed=3, observe="percepts", pose="particles")
    body = match.percepts["body"]
    assert (body["pose"] == POSE_TOLD).all()
    noise = match.league.sensors.place_noise
    assert (body["x"][:, :2] - match.robots["x"][:, :2]).std() == pytest.approx(noise, rel=0.15)
    assert (body["x"][:, 2:] + match.robots["x"][:, 2:]).std() == pytest.approx(noise, rel=0.15)
    turn = body["heading"][:, :2] - match.robots["heading"][:, :2]
    assert turn.std() == pytest.approx(match.league.sensors.place_turn_noise, rel=0.15)
    match.step(np.zeros((150, 4, 4)))
    assert (match.percepts["body"]["pose"] == NO_POSE).all()
    assert not any(match.percepts["body"][part].any() for part in ("x", "y", "heading"))


def test_the_ends_of_the_field_change_places_at_half_time() -> None:
    match = posed(LEGGED, sensors=SHARP)
    match.matches["home_direction"] = -1.0
    match.step(stand(match))
    body = match.percepts["body"][0, 0]
    assert (body["x"], body["y"], body["heading"]) == pytest.approx((-0.4, -0.3, 2.0 - np.pi), abs=1e-6)
