"""Robots that walk about know where they are: told once, or after they have been carried away without being told.

Sacks 2001 says nothing of self-localisation; Heinemann et al. 2006, 1, call theirs "efficient and reliable".
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env.belief.own_pose import POSE_MEMORY, add_motion, is_crowded, take_summed_motion
from soccer_env.compiled import compiled
from soccer_env.records.beliefs import OWN_POSE, TRACK
from soccer_env.records.percepts import POSE_SENSED
from tests.scenes.pose_worlds import World
from tests.scenes.staging import LEGGED, MIDDLE, each_league

CLOSE = {LEGGED: 0.10, MIDDLE: 0.15}  # [m] median error of a robot that knows where it is
NEAR = {LEGGED: 0.3, MIDDLE: 0.6}  # [m] error within which a robot has found itself again
RECOVERY = 10.0  # [s] in which it does
POSE = ("x", "y", "heading")


def informed(name: str, seconds: float = 0.0, **settings: Any) -> World:
    """Return robots that were told where they are, and then walked about for a time [s]."""
    world = World(name, **settings)
    world.tell()
    world.walk(seconds)
    return world


def assert_finite(world: World) -> None:
    for field in OWN_POSE.names:
        assert np.isfinite(world.own[field]).all()
    for field in world.particles.dtype.names:
        assert np.isfinite(world.particles[field]).all()


@each_league
def test_mh08_a_robot_that_was_told_its_pose_keeps_it_while_it_walks_about_and_slips(name: str) -> None:
    world = informed(name, robots=40)
    errors = world.walk(60.0)
    assert np.median(errors) < CLOSE[name] and np.median(errors[-100:]) < CLOSE[name]
    assert np.quantile(errors, 0.99) < 3.0 * CLOSE[name] and np.median(world.heading_errors()) < 0.05
    assert world.own["confidence"].mean() > 70.0


@pytest.mark.slow
@each_league
def test_mh08_without_particles_the_same_robot_drifts_and_its_confidence_falls_to_nothing(name: str) -> None:
    world = informed(name, robots=40, particles=0)
    errors = world.walk(240.0)
    assert np.median(errors[-100:]) > 2.0 * CLOSE[name] and (world.own["confidence"] == 0.0).all()


@each_league
def test_without_slip_dead_reckoning_is_exact_and_speeds_are_those_that_legs_or_wheels_feel(name: str) -> None:
    exact = dict.fromkeys(("odometry_noise", "place_noise", "place_turn_noise"), 0.0)
    world = World(name, robots=5, particles=0, sensors=exact)
    world.league = replace(world.league, drive=replace(world.league.drive, slip=0.0))
    world.tell()
    assert world.walk(20.0).max() < 1e-3
    slips = informed(name, 1.0, robots=5, sensors={"odometry_noise": 0.0})
    for speed in ("forward", "left", "turn"):
        assert slips.own[speed] == pytest.approx(slips.truth["walk"][speed], abs=1e-6)


@each_league
def test_mh08_a_robot_that_is_carried_away_finds_itself_again(name: str) -> None:
    world = informed(name, 5.0, robots=100)
    world.kidnap()
    assert np.median(world.errors()) > NEAR[name]
    errors = world.walk(RECOVERY)
    assert (errors[-world.league.control_rate // 2 :] < NEAR[name]).all(axis=0).mean() >= 0.95
    assert (World(name, robots=40).walk(RECOVERY)[-1] < NEAR[name]).mean() >= 0.95
    lost = informed(name, 5.0, robots=40, pose_fresh=0.0, pose_fast=0.0, pose_fit=0.0)
    lost.kidnap()
    assert (lost.walk(RECOVERY)[-1] < NEAR[name]).mean() < 0.6


@each_league
def test_confidence_falls_when_what_is_seen_disagrees_and_comes_back(name: str) -> None:
    world = informed(name, 5.0, robots=40)
    sure = world.own["confidence"].mean()
    world.kidnap()
    lost = []
    for _ in range(20):
        world.walk(0.1)
        lost.append(world.own["confidence"].mean())
    world.walk(RECOVERY)
    assert min(lost) < 0.7 * sure < world.own["confidence"].mean()


@each_league
def test_odometry_is_trusted_less_the_farther_the_way_and_while_others_are_near(name: str) -> None:
    world, memory = World(name), np.zeros(1, POSE_MEMORY)
    spreads = []
    for forward, crowded in ((0.0, 0.0), (0.2, 0.0), (0.0, 0.2)):
        add_motion(memory[0], forward, 0.0, 0.0, crowded)
        spreads.append(take_summed_motion(memory[0], world.k[0], world.w[0])[3:])
    (still, still_turn, few), (walking, _, _), (among, among_turn, many) = spreads
    assert still < walking and still < among and still_turn < among_turn
    assert few == world.league.memory.pose_stuck < many


@compiled
def crowds(tracks, constants, found):  # type: ignore[no-untyped-def]
    found[0] = is_crowded(tracks, constants[0])


@each_league
def test_ms06_that_somebody_may_push_is_seen_and_not_felt(name: str) -> None:
    """MS06: a collision presses no sensor; a player who is believed near enough to touch may push."""
    world, found = World(name), np.zeros(1, np.int64)
    tracks = np.zeros(3, TRACK)
    reach = 2.0 * world.league.body.reach
    for present, distance, age, crowded in ((1, 0.99, 0.5, 1), (1, 1.01, 0.5, 0), (1, 0.99, 1.5, 0), (0, 0.0, 0.0, 0)):
        tracks[1]["present"], tracks[1]["distance"], tracks[1]["age"] = present, distance * reach, age
        crowds(tracks, world.k, found)
        assert found[0] == crowded


def test_steps_add_up_as_a_rigid_body_moves() -> None:
    """A quarter circle of radius 1 in 90 steps ends 1 m ahead and 1 m to the left of where it began."""
    world, memory = World(LEGGED), np.zeros(1, POSE_MEMORY)
    angle = 0.5 * np.pi / 90
    for _ in range(90):
        add_motion(memory[0], np.sin(angle), 1.0 - np.cos(angle), angle, 0.0)
    assert (memory["ahead"][0], memory["left"][0]) == pytest.approx((1.0, 1.0))
    ahead, left, turn = take_summed_motion(memory[0], world.k[0], world.w[0])[:3]
    assert (ahead, left, turn) == pytest.approx((1.0, -1.0, 0.5 * np.pi))  # in the axes at its end
    assert memory["path"][0] == memory["turn"][0] == 0.0


@each_league
@pytest.mark.parametrize("particles", [1, 2, 7])
def test_any_number_of_particles_runs(name: str, particles: int) -> None:
    assert_finite(informed(name, 10.0, robots=5, particles=particles))


@each_league
def test_a_told_pose_is_taken_and_all_particles_go_there_and_a_noisy_one_that_is_given_as_it_is(name: str) -> None:
    world = informed(name, 3.0, robots=10)
    world.kidnap()
    world.tell()
    told = world.percepts["body"][:, 0]
    for field in POSE:
        assert (world.own[field] == told[field]).all()
    assert (world.own["confidence"] == 100.0).all()
    away = np.hypot(world.particles["x"] - told["x"][:, None], world.particles["y"] - told["y"][:, None])
    assert away.max() < 4.0 * world.league.sensors.place_noise
    assert (world.walk(3.0) < 3.0 * CLOSE[name]).all()
    world = World(name, robots=3, particles=0)
    world.sense()
    body = world.percepts["body"][:, 0]
    body["pose"], body["x"], body["y"], body["heading"] = POSE_SENSED, 0.5, -0.25, 3.0
    world.believe()
    for field in POSE:
        assert (world.own[field] == body[field]).all()
    assert (world.own["confidence"] == 100.0).all()
