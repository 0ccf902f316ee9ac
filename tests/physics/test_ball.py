"""The ball on the carpet: how far it rolls, how it slides after a kick, and how fast it can be."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.scenes.leagues import LEGGED, MIDDLE, each_league, endless, patient
from tests.scenes.staging import distance, play, put_ball, speed, stage, stand, steps_in

DIRECTIONS = 32


def roll_out(match: Match, most: int) -> int:
    """Let the ball roll until it stops everywhere; return the control steps that it took."""
    for step in range(1, most + 1):
        match.step(stand(match))
        if not speed(match.balls).any():
            return step
    raise AssertionError(f"a ball rolls for more than {most} steps")


@pytest.mark.parametrize("rate", [16, 50])
@pytest.mark.parametrize(("name", "speeds"), [(LEGGED, (0.05, 0.3, 1.0, 2.0)), (MIDDLE, (0.05, 0.3, 3.0, 10.0))])
def test_a_rolling_ball_stops_after_v_squared_over_2a_in_every_direction(name, speeds, rate):
    league = replace(endless(name), control_rate=rate)
    a = league.ball.rolling
    v = np.repeat(speeds, DIRECTIONS) * np.tile(np.linspace(0.9, 1.0, DIRECTIONS), len(speeds))
    angle = np.tile(np.linspace(-np.pi, np.pi, DIRECTIONS), len(speeds))
    match = stage(league, len(v), ball=(0.0, 0.0, v * np.cos(angle), v * np.sin(angle)))
    steps = roll_out(match, 2000)
    way = v**2 / (2.0 * a)
    last_step = a * league.dt**2 / 8.0  # [m] by which the step in which it stops may fall short
    assert (abs(distance(match.balls, 0.0, 0.0) - way) <= 1e-9 + last_step).all()
    fast = v >= 0.3
    np.testing.assert_allclose(distance(match.balls, 0.0, 0.0)[fast], way[fast], rtol=1e-3)
    np.testing.assert_allclose(np.arctan2(match.balls["y"], match.balls["x"])[v > 0.1], angle[v > 0.1], atol=1e-9)
    assert steps == pytest.approx(max(v) / a * rate, abs=1.0)


@each_league
def test_a_rolling_ball_loses_speed_at_a_constant_rate(name):
    match = stage(endless(name), ball=(0.0, 0.0, 2.0, 0.0))
    speeds = []
    for _ in range(20):
        match.step(stand(match))
        speeds.append(match.balls["vx"][0])
    expected = 2.0 - match.league.ball.rolling * match.league.dt * np.arange(1, 21)
    np.testing.assert_allclose(speeds, expected, rtol=1e-12)


@each_league
def test_a_kicked_ball_slides_until_it_rolls_at_three_fifths_of_its_speed(name):
    league = endless(name)
    model = league.ball
    assert model.shell == pytest.approx(2 / 3)
    v = np.linspace(0.5, model.top_speed, 40)
    match = stage(league, len(v))
    put_ball(match, 0.0, 0.0, 0.0, v, rolls=False)
    match.rebuild()
    rolls_at = np.full(len(v), np.nan)
    for _ in range(2000):
        match.step(stand(match))
        just_now = np.isnan(rolls_at) & (match.balls["vy"] == match.balls["roll_y"])
        rolls_at[just_now] = match.balls["vy"][just_now]
        if not speed(match.balls).any():
            break
    once = model.rolling * league.dt  # [m/s] of rolling in the step in which it begins to
    assert ((rolls_at <= 0.6 * v + 1e-12) & (rolls_at >= 0.6 * v - once)).all()
    slides, rolls = (v**2 - (0.6 * v) ** 2) / (2.0 * model.sliding), (0.6 * v) ** 2 / (2.0 * model.rolling)
    lost = model.sliding * league.dt**2 / 4.0  # [m] at most, where sliding ends within a step
    np.testing.assert_allclose(match.balls["y"], slides + rolls, rtol=1e-3, atol=lost)


@each_league
def test_a_ball_that_rolls_never_slides_again_by_itself(name):
    match = stage(endless(name), ball=(0.0, 0.0, 1.0, -0.7))
    while speed(match.balls).any():
        match.step(stand(match))
        assert match.balls["vx"] == match.balls["roll_x"] and match.balls["vy"] == match.balls["roll_y"]


@each_league
def test_a_ball_at_rest_stays_exactly_where_it_is(name):
    match = stage(patient(name), 3, ball=([0.0, 0.3, -0.7], [0.1, 0.0, 0.4]))
    before = match.balls.copy()
    play(match, steps=200)
    np.testing.assert_array_equal(match.balls, before)


@each_league
def test_backspin_slows_a_ball_and_can_bring_it_back(name):
    match = stage(endless(name), ball=(0.0, 0.0, 0.3, 0.0))
    match.balls["roll_x"] = -1.0
    match.rebuild()
    furthest = 0.0
    while speed(match.balls).any():
        match.step(stand(match))
        furthest = max(furthest, match.balls["x"][0])
    assert furthest > 0.0 and match.balls["x"][0] < furthest


@each_league
def test_nothing_moves_faster_than_the_balls_top_speed(name):
    top = find_league(name).ball.top_speed
    times = np.array([1.05, 1.5, 5.0, 50.0])
    match = stage(endless(name), 4, ball=(0.0, 0.0, 0.6 * times * top, -0.8 * times * top))
    match.step(stand(match))
    assert (speed(match.balls) <= top * (1.0 + 1e-12)).all() and speed(match.balls) == pytest.approx(top)
    np.testing.assert_allclose(np.arctan2(match.balls["vy"], match.balls["vx"]), np.arctan2(-4.0, 3.0))


@each_league
def test_a_ball_that_spins_on_the_spot_slows_down_at_a_constant_rate_and_stops(name):
    match = stage(name)
    match.balls["spin"] = 3.0
    match.rebuild()
    pivot, spins = match.league.ball.pivot, []
    for _ in range(steps_in(match, 2.0)):
        match.step(stand(match))
        spins.append(match.balls["spin"][0])
    times = match.league.dt * np.arange(1, len(spins) + 1)
    np.testing.assert_allclose(spins, np.maximum(3.0 - pivot * times, 0.0), atol=1e-9)
    assert (match.balls["vx"][0], match.balls["vy"][0]) == (0.0, 0.0)
