"""The ground under robots holds while they push each other: with all paws or wheels who stands, with less who walks."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues.league import League
from tests.scenes.leagues import LEGGED, MIDDLE, endless, steady
from tests.scenes.outlines import robot_gaps
from tests.scenes.staging import asking, place, play, put, speed, stage, stand, steps_in

DIFFERENTIAL = "middle-size-2006-differential"
ROBOTS = (LEGGED, MIDDLE, DIFFERENTIAL)
GAP = 5e-4  # [m] between two that are about to push each other
SIDES = np.radians([0.0, 45.0, 90.0, 135.0, 180.0, -90.0])  # heading of one that is pushed along x
WAYS = {"ahead": (1.0, 0.0), "back": (-1.0, 0.0), "left": (0.0, 1.0), "right": (0.0, -1.0)}


def face_to_face(league: League, headings: np.ndarray, aside: np.ndarray, gap: float = GAP) -> Match:
    """Return matches in which robot 0 heads along x and another one stands in its way, a gap [m] before it."""
    match = stage(league, len(headings), ball=(50.0, 50.0), robots={0: (0.0, 0.0)})
    near, far = np.zeros(len(headings)), np.full(len(headings), 1.0)
    for _ in range(40):
        middle = 0.5 * (near + far)
        put(match, 1, middle, aside, headings)
        found = robot_gaps(league, match.robots)[:, 0]
        near, far = np.where(found < GAP, middle, near), np.where(found < GAP, far, middle)
    place(match, robots={1: (far + gap - GAP, aside, headings)})
    return match


def all_ways() -> tuple[np.ndarray, np.ndarray]:
    """Return headings [rad] and offsets [m] of those who are pushed: from all sides, but face to face not aside.

    There the guides of wheeled robots slide off each other, and the next that meets is a blow after a run-up.
    """
    grid = np.meshgrid(SIDES, [0.0, 0.03, -0.03])
    headings, aside = grid[0].ravel(), grid[1].ravel()
    kept = (headings < 3.0) | (aside == 0.0)
    return headings[kept], aside[kept]


def push(match: Match, actions: np.ndarray, seconds: float) -> np.ndarray:
    """Play for a time [s]; return where both robots have been (steps, M, 2, 2) [m]."""
    places = []
    for _ in range(steps_in(match, seconds)):
        match.step(actions)
        places.append(np.stack([match.robots["x"], match.robots["y"]], axis=-1))
    return np.array(places)


@pytest.mark.parametrize("name", ROBOTS)
def test_a_walker_moves_one_of_its_own_weight_that_stands_by_less_than_a_centimetre_in_5_s(name):
    match = face_to_face(steady(endless(name)), *all_ways())
    began = np.stack([match.robots["x"], match.robots["y"]], axis=-1)[:, 1]
    places = push(match, asking(match, forward=1.0), 5.0)[:, :, 1]
    assert np.hypot(*np.moveaxis(places - began, -1, 0)).max() < 0.01


def test_not_even_with_a_run_up_of_15_cm():
    match = face_to_face(steady(endless(LEGGED)), *all_ways(), gap=0.15)
    began = np.stack([match.robots["x"], match.robots["y"]], axis=-1)[:, 1]
    places = push(match, asking(match, forward=1.0), 7.0)
    assert (places[:, :, 0, 0].max(axis=0) > 0.1).all(), "they get there"
    assert np.hypot(*np.moveaxis(places[:, :, 1] - began, -1, 0)).max() < 0.01


@pytest.mark.parametrize("name", ROBOTS)
def test_two_that_push_head_on_creep_at_less_than_1_cm_per_s_after_the_first_second(name):
    aside = np.array([0.0, 0.03, -0.03])
    match = face_to_face(steady(endless(name)), np.full(3, np.pi), aside)
    actions = asking(match, r=[0, 1], forward=1.0)
    began = push(match, actions, 1.0)[-1]
    ended = push(match, actions, 4.0)[-1]
    assert np.hypot(*np.moveaxis(ended - began, -1, 0)).max() / 4.0 < 0.01


def knocked(match: Match, way: str, v: float) -> None:
    """Give robot 0 a velocity [m/s] besides what it has, in a direction of its own frame."""
    ahead, left = WAYS[way]
    match.robots["vx"][:, 0] += v * ahead
    match.robots["vy"][:, 0] += v * left
    match.rebuild()


def alone(name: str) -> Match:
    """Return a match in which robot 0 has come to rest and heads along x."""
    match = stage(steady(endless(name)), ball=(50.0, 50.0), robots={0: (0.0, 0.0)})
    match.step(stand(match))
    return match


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", ROBOTS)
def test_who_stands_and_is_pushed_slides_with_all_its_traction(name, way):
    match = alone(name)
    drive, dt = match.league.drive, match.league.dt
    v = 4.5 * drive.traction * dt
    knocked(match, way, v)
    for step in range(1, 7):
        match.step(stand(match))
        left = max(v - step * drive.traction * dt, 0.0)
        assert speed(match.robots)[0, 0] == pytest.approx(left, abs=1e-9)


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", ROBOTS)
def test_who_walks_and_is_pushed_goes_back_to_its_walk_with_the_thrust_of_its_drive(name, way):
    """The wheels of a differential base do not roll sideways: to either side they hold as if it stood."""
    match = alone(name)
    drive, dt = match.league.drive, match.league.dt
    actions = asking(match, forward=0.5)
    play(match, 1.5, actions)
    walk = match.robots["vx"][0, 0]
    assert walk == pytest.approx(0.5 * drive.forward)
    sideways = name == DIFFERENTIAL and way in ("left", "right")
    most = drive.traction if sideways else drive.thrust
    v = 4.5 * most * dt
    knocked(match, way, v)
    for step in range(1, 7):
        match.step(actions)
        over = np.hypot(match.robots["vx"][0, 0] - walk, match.robots["vy"][0, 0])
        assert over == pytest.approx(max(v - step * most * dt, 0.0), abs=1e-9)


@pytest.mark.parametrize("name", ROBOTS)
def test_who_is_turned_resists_with_turn_traction_if_it_stands_and_with_turn_thrust_if_it_walks(name):
    for walks in (False, True):
        match = alone(name)
        drive, dt = match.league.drive, match.league.dt
        actions = asking(match, forward=0.3 if walks else 0.0)
        play(match, 1.5, actions)
        most = drive.turn_thrust if walks else drive.turn_traction
        omega = 3.5 * most * dt
        match.robots["omega"][:, 0] = -omega
        match.rebuild()
        for step in range(1, 6):
            match.step(actions)
            left = max(omega - step * most * dt, 0.0)
            assert match.robots["omega"][0, 0] == pytest.approx(-left, abs=1e-9)


@pytest.mark.parametrize("name", ROBOTS)
def test_who_has_not_come_to_rest_yet_brakes_with_its_thrust(name):
    match = alone(name)
    match.robots["stands"] = 0
    drive, dt = match.league.drive, match.league.dt
    knocked(match, "ahead", 4.5 * drive.thrust * dt)
    for step in range(1, 5):
        match.step(stand(match))
        assert speed(match.robots)[0, 0] == pytest.approx((4.5 - step) * drive.thrust * dt)
        assert match.robots["stands"][0, 0] == 0
    match.step(stand(match))
    assert speed(match.robots)[0, 0] == 0.0 and match.robots["stands"][0, 0] == 1
