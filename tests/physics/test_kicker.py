"""Kicks: who can, when, how hard, and in which direction the ball leaves."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.scenes.leagues import LEGGED, MIDDLE, each_league, steady
from tests.scenes.staging import at_the_ball, place, play, put, put_ball, robot_actions, speed, stage, steps_in


def kicks(match: Match, actions: np.ndarray, most: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the control step of each match's first kick (-1 none), the ball's speed and its direction then."""
    at, v, direction = np.full(match.count, -1), np.zeros(match.count), np.zeros(match.count)
    for step in range(1, most + 1):
        match.step(actions)
        kicked = (match.robot_events["kick"].max(axis=1) == 1) & (at < 0)
        at[kicked], v[kicked] = step, speed(match.balls)[kicked]
        direction[kicked] = np.arctan2(match.balls["vy"], match.balls["vx"])[kicked]
    return at, v, direction


def carpet(match: Match) -> float:
    """Return what the carpet takes of a kicked ball's speed in its first control step [m/s]."""
    return match.league.ball.sliding * match.league.dt


@pytest.mark.parametrize(("strength", "expected"), [(0.3, 0.8), (0.5, 1.0), (0.65, 1.15), (1.0, 1.5)])
def test_a_legged_kick_sends_the_ball_off_at_0_8_to_1_5_m_per_s(strength, expected):
    match = at_the_ball(steady(LEGGED))
    _, v, _ = kicks(match, robot_actions(match, kick=strength), 16)
    assert v[0] == pytest.approx(expected - carpet(match), abs=1e-6)


@pytest.mark.parametrize(("name", "strength"), [
    (LEGGED, 0.05), (LEGGED, 0.2), (LEGGED, 0.29), (LEGGED, 0.0), (LEGGED, -1.0), (MIDDLE, 0.0), (MIDDLE, -1.0),
])  # fmt: skip
def test_no_strength_or_less_is_no_kick_and_a_legged_robot_ignores_strengths_below_0_3(name, strength):
    match = at_the_ball(name)
    at, _, _ = kicks(match, robot_actions(match, kick=strength), 40)
    assert at[0] == -1 and not speed(match.balls).any()


@pytest.mark.parametrize("strength", [0.02, 0.1, 0.5, 0.9, 1.0])
def test_a_middle_size_kick_is_proportional_to_its_strength_up_to_10_m_per_s(strength):
    match = at_the_ball(steady(MIDDLE))
    at, v, _ = kicks(match, robot_actions(match, kick=strength), 1)
    assert at[0] == 1 and v[0] == pytest.approx(10.0 * strength - carpet(match), abs=1e-6)


def test_a_legged_kick_takes_0_6_s_in_which_the_robot_comes_to_a_stand_and_stays():
    match = at_the_ball(steady(LEGGED))
    put(match, 0, match.robots["x"][:, 0], 0.1, 0.0)
    actions = robot_actions(match, forward=1.0, kick=1.0)
    speeds, clock, at = [], [], match.robots["x"][0, 0]
    for _ in range(12):
        match.step(actions)
        speeds.append(speed(match.robots)[0, 0])
        clock.append(match.robots["kick_clock"][0, 0])
        if match.robot_events["kick"][0, 0]:
            break
    assert len(speeds) - 1 == np.ceil(0.6 * 16)  # the first step only begins it
    assert max(speeds[:-1]) == 0.0
    assert abs(match.robots["x"][0, 0] - at) < 1e-3 and speeds[-1] < 1e-9, "its paws bear the recoil"
    assert clock[0] == pytest.approx(0.6) and clock[-1] == -0.5


def test_a_walking_robot_brakes_as_soon_as_it_winds_up_and_a_ball_that_rolls_away_meanwhile_is_missed():
    match = at_the_ball(steady(LEGGED))
    put(match, 0, match.robots["x"][:, 0], 0.1, 0.0, forward=0.07)
    place(match, ball=(match.balls["x"], 0.1, 0.07, 0.0))
    actions, speeds = robot_actions(match, forward=0.07 / 0.12, kick=1.0), []
    while not match.robot_events["kick"][0, 0]:
        match.step(actions)
        speeds.append(speed(match.robots)[0, 0])
    assert (np.diff(speeds[:-1]) <= 1e-9).all()
    assert speeds[6] == 0.0, "0.07 m/s at 0.24 m/s2 takes 0.3 s"
    match = at_the_ball(LEGGED)
    actions = robot_actions(match, kick=1.0)
    match.step(actions)
    match.balls["x"] += 0.2
    match.rebuild()
    at, _, _ = kicks(match, actions, 12)
    assert at[0] == -1 and not speed(match.balls).any()
    assert match.robots["kick_clock"][0, 0] < 0.0, "it has kicked the air"


@pytest.mark.parametrize(("name", "degrees"), [(LEGGED, 10.0), (MIDDLE, 2.0)])
def test_kicks_stray_from_the_heading_with_the_leagues_deviation(name, degrees):
    matches = 300
    match = at_the_ball(name, matches, seed=11)
    heading = np.linspace(-3.0, 3.0, matches)
    reach = match.league.body.front + match.league.ball.radius
    place(match, ball=(-0.5 + reach * np.cos(heading), reach * np.sin(heading)), robots={0: (-0.5, 0.0, heading)})
    at, _, direction = kicks(match, robot_actions(match, kick=1.0), 12)
    off = (direction - match.robots["heading"][:, 0] + np.pi) % (2.0 * np.pi) - np.pi
    assert (at > 0).all()
    assert off.mean() == pytest.approx(0.0, abs=np.radians(4.0 * degrees / np.sqrt(matches)))
    assert off.std() == pytest.approx(np.radians(degrees), rel=4.0 / np.sqrt(2.0 * matches))
    assert (abs(off) > np.radians(2.0 * degrees)).mean() == pytest.approx(0.0455, abs=0.04), "a normal deviation"


@each_league
def test_a_kicked_ball_flies_clear_of_the_robot_that_kicked_it(name):
    match = at_the_ball(name, 200, seed=2)
    kicks(match, robot_actions(match, kick=1.0), 11)
    direction = np.arctan2(match.balls["vy"], match.balls["vx"])
    play(match, 0.2)
    later = np.arctan2(match.balls["vy"], match.balls["vx"])
    straight = abs(direction) < np.radians(20.0)
    assert straight.mean() > 0.9
    np.testing.assert_allclose(later[straight], direction[straight], atol=1e-6)


@pytest.mark.parametrize(("name", "ahead", "aside"), [
    (LEGGED, 0.04, 0.0), (LEGGED, 0.031, 0.0), (LEGGED, 0.05, 0.046), (MIDDLE, 0.05, 0.0), (MIDDLE, 0.02, 0.09),
])  # fmt: skip
def test_a_ball_outside_the_pocket_cannot_be_kicked(name, ahead, aside):
    match = at_the_ball(name, ahead=ahead, aside=aside)
    assert match.robots["has_ball"][0, 0] == 0
    at, _, _ = kicks(match, robot_actions(match, kick=1.0), 20)
    assert at[0] == -1 and not speed(match.balls).any()


@each_league
def test_a_robot_without_the_ball_does_not_begin_to_kick_and_no_kick_gives_more_than_the_top_speed(name):
    match = at_the_ball(name, ahead=0.5)
    for _ in range(20):
        match.step(robot_actions(match, kick=1.0))
        assert match.robots["kick_clock"][0, 0] == 0.0
    league = find_league(name)
    strong = replace(league, kicker=replace(league.kicker, fastest=3.0 * league.ball.top_speed))
    match = at_the_ball(strong)
    _, v, _ = kicks(match, robot_actions(match, kick=1.0), 16)
    assert 0.5 * league.ball.top_speed < v[0] <= league.ball.top_speed


@pytest.mark.parametrize(("name", "pause"), [(LEGGED, 0.5), (MIDDLE, 1.0)])
def test_after_a_kick_the_kicker_recharges(name, pause):
    match = at_the_ball(steady(name))
    x, times = match.balls["x"].copy(), []
    for step in range(steps_in(match, 4.0)):
        match.step(robot_actions(match, kick=1.0))
        if match.robot_events["kick"][0, 0]:
            times.append(step)
        put_ball(match, x, 0.1)  # somebody puts the ball back
        match.robots["has_ball"][:, 0] = 1
        match.rebuild()
    wind_up = np.ceil(match.league.kicker.wind_up * match.league.control_rate)
    gap = np.diff(times) / match.league.control_rate
    assert len(gap) >= 2
    np.testing.assert_allclose(gap, pause + wind_up * match.league.dt, atol=1.01 * match.league.dt)


@pytest.mark.parametrize(("name", "has_kicker"), [(LEGGED, True), (MIDDLE, False)])
def test_a_legged_goalkeeper_kicks_and_the_middle_size_goalkeeper_has_no_kicker(name, has_kicker):
    match = at_the_ball(steady(name), home=2)
    assert match.robots["keeper"][0, 0] == 1 and match.robots["has_ball"][0, 0] == 1
    assert (kicks(match, robot_actions(match, kick=1.0), 60)[0][0] > 0) == has_kicker


def test_a_dribbled_ball_leaves_with_the_robots_speed_on_top():
    match = stage(steady(MIDDLE), ball=(-3.0 + 0.18 + 0.11 + 0.005, 0.0, 1.5, 0.0), robots={0: (-3.0, 0.0, 0.0, 1.5)})
    match.robots["has_ball"][:, 0] = 1
    match.rebuild()
    at, v, _ = kicks(match, robot_actions(match, forward=1.5 / 2.6, kick=0.4), 1)
    assert at[0] == 1 and v[0] == pytest.approx(5.5 - carpet(match), abs=0.01)


@each_league
def test_two_robots_that_kick_against_each_other_at_once_are_equals(name):
    """A trap: whoever came last in the list used to win every such duel."""
    match = stage(steady(name))
    body, ball = match.league.body, match.league.ball
    apart = max(body.front + ball.radius + 0.012, body.tip_x + body.tip_radius + 0.003)
    put(match, 0, -apart, 0.0, 0.0)
    put(match, 1, apart, 0.0, np.pi)
    put_ball(match, 0.0, 0.0)
    match.robots["has_ball"] = 1
    match.rebuild()
    kicked = False
    for _ in range(20):
        match.step(robot_actions(match, r=slice(None), kick=1.0))
        kicked |= bool(match.robot_events["kick"].all())
        assert abs(match.balls["x"][0]) < 1e-9 and speed(match.balls)[0] < 1e-9
    assert kicked


ASIDE = np.radians(50.0)


def full_actions(match: Match, head: float, pan: float) -> np.ndarray:
    """Return actions (M, R, 7) in which robot 0 kicks and turns its head by a share of its range."""
    actions = np.zeros((*match.robots.shape, 7))
    actions[:, 0, 3:6] = 1.0, head, pan
    return actions


def kick_with_head(name: str, pan: float, head: float, matches: int = 1) -> tuple[Match, np.ndarray, np.ndarray]:
    """Return matches in which a robot has kicked with its head turned by `pan` [rad], the step and direction."""
    match = at_the_ball(steady(name), matches, actions="full")
    at, _, direction = kicks(match, full_actions(match, head, pan / max(match.league.head.pan_limit, 1.0)), 20)
    return match, at, direction


@pytest.mark.parametrize(("degrees", "turned"), [
    (26.0, 1.0), (60.0, 1.0), (89.0, 1.0), (-26.0, -1.0), (-60.0, -1.0), (24.0, 0.0), (0.0, 0.0), (-24.0, 0.0),
])  # fmt: skip
def test_a_legged_robot_that_turns_its_head_by_25_degrees_or_more_kicks_50_degrees_to_that_side(degrees, turned):
    match, at, direction = kick_with_head(LEGGED, np.radians(degrees), 0.5)
    assert direction[0] == pytest.approx(turned * ASIDE, abs=1e-6)
    assert match.robots["kick_side"][0, 0] == turned
    assert speed(match.balls)[0] > 0.5
    assert at[0] == 1 + np.ceil((0.8 if turned else 0.6) * 16), "with one foreleg it takes longer"


@pytest.mark.parametrize(("name", "head"), [(LEGGED, -0.01), (LEGGED, -1.0), (MIDDLE, 1.0)])
def test_a_head_that_looks_for_itself_aims_no_kick_and_one_on_wheels_kicks_ahead_only(name, head):
    match, at, direction = kick_with_head(name, 1.0, head)
    assert at[0] > 0 and direction[0] == pytest.approx(0.0, abs=1e-6)
    assert match.robots["kick_side"][0, 0] == 0.0


def test_the_head_aims_as_the_wind_up_begins():
    match = at_the_ball(steady(LEGGED), actions="full")
    match.step(full_actions(match, 1.0, 1.0))
    at, _, direction = kicks(match, full_actions(match, 1.0, -1.0), 14)
    assert at[0] == 13 and direction[0] == pytest.approx(ASIDE, abs=1e-6)
