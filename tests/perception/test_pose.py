"""The pose from outside: right on average, wrong by what the settings say, and wrong for a while the same way."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.perception.body import POSE_ERROR, sense_body
from soccer_env.records.percepts import BODY_PERCEPT, NO_POSE, POSE_SENSED, POSE_TOLD
from soccer_env.types import MATCH, ROBOT, ROBOT_EVENTS
from tests.scenes.staging import LEGGED, each_league, put, put_ball, stage, stand

SHARP = {"pose_noise": 0.0, "pose_turn_noise": 0.0, "place_noise": 0.0, "place_turn_noise": 0.0}


def posed(
    league: str, matches: int = 1, x: float = 0.4, y: float = 0.3, heading: float = 2.0, **settings: Any
) -> Match:
    """Return matches in which robot 0, of home, and 1, of away, stand in the same way seen from their own goals."""
    match = stage(league, matches, 1, 1, **{"observe": "percepts", **settings})
    put(match, 0, 0.4, 0.3, heading)
    put(match, 1, -0.4, -0.3, heading - np.pi)
    put_ball(match, -1.0, 0.7)
    match.rebuild()
    return match


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
def test_errors_are_as_large_as_the_settings_say_from_the_first_frame_on(name: str) -> None:
    found = errors_of_many(name, 3, pose_noise=0.1, pose_turn_noise=0.2)
    assert found.mean(axis=1) == pytest.approx(np.zeros((3, 3)), abs=0.015)
    assert found.std(axis=1) == pytest.approx(np.full((3, 3), [0.1, 0.1, 0.2]), rel=0.05)


@each_league
def test_errors_last_for_their_correlation_time(name: str) -> None:
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


@each_league
def test_headings_stay_within_a_turn(name: str) -> None:
    for heading in (np.pi, -np.pi + 1e-9, 3.0):
        match = posed(name, 50, heading=heading, sensors={"pose_turn_noise": 1.0})
        match.step(stand(match))
        found = match.percepts["body"]["heading"]
        assert (np.abs(found) <= np.float32(np.pi)).all()


def test_the_ends_of_the_field_change_places_at_half_time() -> None:
    match = posed(LEGGED, sensors=SHARP)
    match.matches["home_direction"] = -1.0
    match.step(stand(match))
    body = match.percepts["body"][0, 0]
    assert (body["x"], body["y"], body["heading"]) == pytest.approx((-0.4, -0.3, 2.0 - np.pi), abs=1e-6)
