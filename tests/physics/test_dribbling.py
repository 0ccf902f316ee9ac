"""The ball on the carpet, how far it rolls and slides; and the pocket, in which a ball pushed straight ahead stays."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.physics.engine.space import build_space
from tests.scenes.leagues import LEAGUES, LEGGED, MIDDLE, each_league, endless, league_without_calls, steady
from tests.scenes.staging import (
    distance,
    outline,
    place,
    play,
    put,
    put_ball,
    record_each_step,
    robot_actions,
    speed,
    stage,
    stand,
)


def pushed(league, matches, v, seconds, forward):
    """Return matches in which a robot has pushed its ball ahead, and the greatest distance that it lost it by."""
    match = stage(league, matches, seed=4)
    place(match, ball=(-1.2 + league.body.front + league.ball.radius + 0.003, 0.0), robots={0: (-1.2, 0.0, 0.0)})
    kept = np.ones(matches, bool)
    for step in range(round(seconds * league.control_rate)):
        match.step(robot_actions(match, forward=forward(step * league.dt) * v / league.drive.forward))
        if step > 2 * league.delay_steps:
            kept &= match.robots["has_ball"][:, 0] == 1
    return match, kept


@pytest.mark.parametrize(("name", "v", "seconds", "start"), [(LEGGED, 0.07, 17.0, 0.0), (MIDDLE, 1.0, 3.0, 1.0)])
def test_a_robot_that_starts_gently_keeps_the_ball_over_a_metre(name, v, seconds, start):
    match, kept = pushed(find_league(name), 60, v, seconds, lambda t: min(t / start, 1.0) if start else 1.0)
    assert (match.robots["x"][:, 0] > -0.2).all() and kept.all()
    assert name == MIDDLE or (abs(match.balls["y"]) < 0.02).all()


def test_a_robot_that_brakes_hard_or_turns_on_the_spot_loses_its_ball():
    match, _ = pushed(steady(MIDDLE), 1, 1.5, 2.5, lambda t: min(t / 1.0, 1.0) if t < 1.5 else 0.0)
    gap = match.balls["x"][0] - match.robots["x"][0, 0] - match.league.body.front - match.league.ball.radius
    assert match.robots["has_ball"][0, 0] == 0 and gap > 0.3
    match = stage(steady(MIDDLE), ball=(-1.0 + 0.18 + 0.11 + 0.003, 0.0), robots={0: (-1.0, 0.0, 0.0)})
    play(match, actions=robot_actions(match, turn=1.0), steps=100)
    assert match.robots["has_ball"][0, 0] == 0


def kept_for(commands, seconds=4.0):
    """Return for how long [s] guides keep the ball (N,), each robot at 1 m/s ahead and then told its command (N, 3)."""
    league = endless(steady(MIDDLE))
    match = stage(league, len(commands))
    place(match, ball=(league.body.front + league.ball.radius + 0.001, 0.0), robots={0: (0.0, 0.0, 0.0)})
    warm = league.control_rate  # steps of a gentle start
    last = np.zeros(len(commands))
    for step in range(warm + round(seconds * league.control_rate)):
        ahead = np.array([min(step / warm, 1.0) / league.drive.forward, 0.0, 0.0])
        forward, left, turn = np.broadcast_to(ahead if step < warm else commands, (len(commands), 3)).T
        match.step(robot_actions(match, forward=forward, left=left, turn=turn))
        last[match.robots["has_ball"][:, 0] == 1] = (step - warm + 1) * league.dt
    return last


def test_a_guide_keeps_the_ball_straight_ahead_loses_it_the_sooner_the_faster_it_turns_and_never_pulls_it():
    drive = find_league(MIDDLE).drive
    rates = np.array([0.0, 0.2, 0.5, 1.0, 2.0, 3.0])  # [rad/s]
    ahead = np.full(len(rates), 1.0 / drive.forward)
    times = kept_for(np.stack([ahead, 0.0 * rates, rates / drive.turn], axis=1))
    assert times[0] == 4.0
    assert (np.diff(times) <= 0.0).all()
    assert times[1] > 2.0 and (times[2:] < 0.8).all()
    standing, back, aside = [0.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]
    assert (kept_for(np.array([standing, back, aside]), 1.5) < 0.5).all()


@each_league
def test_a_ball_off_the_middle_is_steered_into_the_pocket_and_overlaps_nothing_there(name):
    league = steady(name)
    aside = np.linspace(-0.6, 0.6, 21) * (league.body.tip_y - league.body.tip_radius)
    match = stage(league, 21)
    put(match, 0, -1.2, 0.0, 0.0)
    place(match, ball=(-1.2 + league.body.tip_x + league.ball.radius + league.body.tip_radius + 0.05, aside))
    share = 0.5 if name == LEGGED else 0.2
    play(match, 0.5 / (share * league.drive.forward), robot_actions(match, forward=share))
    assert (match.robots["has_ball"][:, 0] == 1).mean() > 0.9
    league = find_league(name)
    match = stage(league, robots={0: (0.0, 0.0, 0.7)})
    reach = league.body.front + league.ball.radius
    place(match, ball=(reach * np.cos(0.7), reach * np.sin(0.7)))
    match.step(robot_actions(match))
    assert match.robots["has_ball"][0, 0] == 1
    space = build_space(league, match.balls[0], match.robots[0])
    ball = next(iter(space.bodies))
    depths = []
    space.step(1e-9)
    ball.each_arbiter(lambda arbiter: depths.extend(-p.distance for p in arbiter.contact_point_set.points))
    assert max(depths, default=0.0) < 1e-6
    assert match.balls[["vx", "vy"]].tolist() == [(0.0, 0.0)]


def test_at_most_a_third_of_the_ball_lies_within_the_convex_hull_of_a_middle_size_robot():
    """The rule of the league; wherever the ball can lie against the front, and however it leans on the guide."""
    league = find_league(MIDDLE)
    points, r = outline(league), league.ball.radius
    front_of_hull = league.body.tip_x + league.body.tip_radius  # between the tips the hull is a straight edge
    assert (points[:, 0] <= front_of_hull + 1e-12).all()
    deepest = 0.0
    for aside in np.linspace(-0.1, 0.1, 201):
        near = points[abs(points[:, 1] - aside) < r]
        rest = (near[:, 0] + np.sqrt(r**2 - (near[:, 1] - aside) ** 2)).max()  # x of its centre when it touches
        deepest = max(deepest, front_of_hull - (rest - r))
    assert deepest <= 2.0 * r / 3.0 and deepest == pytest.approx(0.055, abs=0.002)
    assert league.body.front == pytest.approx(league.body.disc_x + league.body.disc_radius)


@pytest.mark.parametrize("name", LEAGUES)
def test_the_numbers_of_a_body_agree_with_its_outline(name):
    league = find_league(name)
    points = outline(league)
    assert np.hypot(*points.T).max() == pytest.approx(league.body.reach, abs=0.001)
    straight = points[abs(points[:, 1]) < 0.03]
    assert straight[:, 0].max() == pytest.approx(league.body.front, abs=1e-9)
    assert 2.0 * (league.body.tip_y - league.body.tip_radius) == pytest.approx(2.0 * league.ball.radius, rel=0.11)


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
def test_a_rolling_ball_loses_speed_at_a_constant_rate_never_slides_again_and_stays_where_it_comes_to_rest(name):
    match = stage(endless(name), ball=(0.0, 0.0, 2.0, 0.0))
    speeds = record_each_step(match, lambda: match.balls["vx"][0], steps=20)
    expected = 2.0 - match.league.ball.rolling * match.league.dt * np.arange(1, 21)
    np.testing.assert_allclose(speeds, expected, rtol=1e-12)
    match = stage(endless(name), ball=(0.0, 0.0, 1.0, -0.7))
    while speed(match.balls).any():
        match.step(stand(match))
        assert match.balls["vx"] == match.balls["roll_x"] and match.balls["vy"] == match.balls["roll_y"]
    match = stage(league_without_calls(name), 3, ball=([0.0, 0.3, -0.7], [0.1, 0.0, 0.4]))
    before = match.balls.copy()
    play(match, steps=200)
    np.testing.assert_array_equal(match.balls, before)


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
def test_backspin_slows_a_ball_and_can_bring_it_back_and_nothing_moves_faster_than_the_balls_top_speed(name):
    match = stage(endless(name), ball=(0.0, 0.0, 0.3, 0.0))
    match.balls["roll_x"] = -1.0
    match.rebuild()
    furthest = 0.0
    while speed(match.balls).any():
        match.step(stand(match))
        furthest = max(furthest, match.balls["x"][0])
    assert furthest > 0.0 and match.balls["x"][0] < furthest
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
    spins = record_each_step(match, lambda: match.balls["spin"][0], 2.0)
    times = match.league.dt * np.arange(1, len(spins) + 1)
    np.testing.assert_allclose(spins, np.maximum(3.0 - match.league.ball.pivot * times, 0.0), atol=1e-9)
    assert (match.balls["vx"][0], match.balls["vy"][0]) == (0.0, 0.0)
