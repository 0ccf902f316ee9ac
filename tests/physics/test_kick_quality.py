"""How kicks differ: speed, direction and misses by how the ball lies, recoil, and a ball that another robot touches."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.physics.kicker import advance_kicker, kick_misalignment
from soccer_env.random_numbers import GOLDEN
from soccer_env.types import RobotStream
from tests.scenes.staging import (
    LEGGED,
    MIDDLE,
    each_league,
    place,
    put,
    put_ball,
    robot_actions,
    speed,
    stage,
    stand,
)

KICKS = 1000
FEW = 40  # kicks, of which a fact holds for each
EDGE = 0.999  # of the kicker's reach or half width: a ball at the very edge cannot be kicked


@cache
def staged(league, matches):
    """Return matches, which take seconds to make, and their arrays as they began."""
    match = stage(league, matches, seed=5)
    return match, [(array, array.copy()) for array in (match.matches, match.balls, match.robots, match.robot_events)]


def ready(league, ahead=0.0, aside=0.0, matches=KICKS) -> Match:
    """Return matches in which robot 0 is about to finish a kick of full strength, in a direction of its own.

    The ball lies at shares of the kicker's reach and half width. The next call stages the same matches anew.
    """
    match, begun = staged(league, matches)
    for array, start in begun:
        array[:] = start
    found, heading = match.league, np.linspace(-3.0, 3.0, matches)
    cosine, sine = np.cos(heading), np.sin(heading)
    gap = found.body.front + found.ball.radius + ahead * found.kicker.reach
    left = aside * found.kicker.half_width
    put(match, 0, 0.1, -0.2, heading)
    put_ball(match, 0.1 + gap * cosine - left * sine, -0.2 + gap * sine + left * cosine)
    match.robots["kick_clock"][:, 0], match.robots["kick_strength"][:, 0] = 1e-6, 1.0
    match.rebuild()
    return match


@compiled
def finish_all(matches, balls, robots, robot_events, constants):
    for m in range(len(matches)):
        advance_kicker(robots[m], 0, robot_events[m, 0], constants[0], balls[m], matches[m].handedness)


def finish(match: Match) -> np.ndarray:
    """Finish the kick of robot 0 in all matches, before any contact is solved; return which balls got it (M,)."""
    match.robot_events["kick"] = 0
    finish_all(match.matches, match.balls, match.robots, match.robot_events, match.settings.constants())
    return match.robot_events["kick"][:, 0] == 1


def strays(match: Match, kicked: np.ndarray) -> np.ndarray:
    """Return how far the kicked balls leave beside the heading [rad]."""
    direction = np.arctan2(match.balls["vy"], match.balls["vx"])[kicked]
    return np.angle(np.exp(1j * (direction - match.robots["heading"][kicked, 0])))


@each_league
def test_ball_and_robot_keep_their_momentum_in_a_kick_and_a_missed_one_gives_nothing_and_recharges(name):
    match = ready(name, matches=FEW)
    body, ball = match.league.body, match.league.ball
    assert finish(match).all()
    for axis in ("vx", "vy"):
        gained = ball.mass * match.balls[axis] + body.mass * match.robots[axis][:, 0]
        np.testing.assert_allclose(gained, 0.0, atol=1e-14 * body.mass)
    recoil = speed(match.robots)[:, 0].mean()
    assert recoil == pytest.approx({LEGGED: 0.05 * 1.5 / 1.45, MIDDLE: 0.43 * 10.0 / 30.0}[name], rel=0.1)
    league = find_league(name)
    match = stage(replace(league, kicker=replace(league.kicker, miss=1.0)), 50)
    body, ball, kicker = league.body, league.ball, league.kicker
    place(match, ball=(body.front + ball.radius + EDGE * kicker.reach, 0.0), robots={0: (0.0, 0.0)})
    match.step(stand(match))
    kicked, recharging = np.zeros(50, bool), np.zeros(50, bool)
    for _ in range(11):
        match.step(robot_actions(match, kick=1.0))
        kicked |= match.robot_events["kick"][:, 0] == 1
        recharging |= match.robots["kick_clock"][:, 0] < 0.0
    assert recharging.all() and kicked.mean() < 0.05
    assert not speed(match.balls)[~kicked].any() and not speed(match.robots)[~kicked].any()


@pytest.mark.parametrize(("name", "share"), [(LEGGED, 0.15), (MIDDLE, 0.05)])
def test_the_speed_of_kicks_varies_by_the_leagues_share(name, share):
    match = ready(name)
    assert finish(match).all()
    pace = speed(match.balls) / match.league.kicker.fastest
    assert pace.mean() == pytest.approx(1.0, abs=4.0 * share / np.sqrt(KICKS))
    assert pace.std() == pytest.approx(share, rel=4.0 / np.sqrt(2.0 * KICKS))


def test_no_kick_draws_the_ball_back_however_much_kicks_vary():
    league = find_league(LEGGED)
    match = ready(replace(league, kicker=replace(league.kicker, spread=0.0, speed_spread=1.0)))
    finish(match)
    moves = speed(match.balls) > 0.0
    below = 0.1587  # of the draws of a normal distribution lie a deviation below the mean
    assert (~moves).mean() == pytest.approx(below, abs=4.0 * np.sqrt(below * (1.0 - below) / KICKS))
    assert abs(strays(match, moves)).max() < 1e-6


@pytest.mark.parametrize(
    ("ahead", "aside"), [(0.0, 0.0), (0.5, 0.0), (0.0, -0.5), (EDGE, 0.3), (0.2, EDGE), (EDGE, -EDGE)]
)
@pytest.mark.parametrize(("name", "miss"), [(LEGGED, 0.5), (MIDDLE, 0.2)])
def test_misses_grow_with_the_square_of_how_badly_the_ball_lies(name, miss, ahead, aside):
    match = ready(name, ahead, aside)
    expected = miss * max(ahead, abs(aside)) ** 2
    missed = (~finish(match)).mean()
    assert missed == (speed(match.balls) == 0.0).mean()
    assert missed == pytest.approx(expected, abs=4.0 * np.sqrt(expected * (1.0 - expected) / KICKS))


@pytest.mark.parametrize(("ahead", "aside", "wider"), [(0.5, 0.0, 1.5), (0.0, -0.25, 1.25), (0.0, EDGE, 1.0 + EDGE)])
@each_league
def test_a_kick_strays_up_to_twice_as_far_from_the_edge_of_the_kicker(name, ahead, aside, wider):
    """By the same draws; how far kicks from its middle stray is a number of the league, see test_kicker.py."""
    middle = ready(name, matches=FEW)
    off = strays(middle, finish(middle))
    worse = ready(name, ahead, aside, matches=FEW)
    hits = finish(worse)
    assert hits.sum() > FEW / 4
    np.testing.assert_allclose(strays(worse, hits), wider * off[hits], atol=1e-9)


@compiled
def badness_of(robot, k, x, y):
    return kick_misalignment(robot, k, x, y)


@each_league
def test_a_ball_lies_best_in_the_middle_of_the_front_and_worst_at_every_edge(name):
    match = stage(name, robots={0: (0.0, 0.0)})
    k, robot = match.settings.constants()[0], match.robots[0, 0]
    front, reach, half = k["body_front"] + k["ball_radius"], k["kicker_reach"], k["kicker_half_width"]
    for x, y, expected in (
        (0.0, 0.0, 0.0), (-0.1 * reach, 0.0, 0.0), (0.25 * reach, 0.0, 0.25), (reach, 0.0, 1.0),
        (0.0, 0.5 * half, 0.5), (0.0, -0.5 * half, 0.5), (0.9 * reach, half, 1.0), (reach, -0.1 * half, 1.0),
    ):  # fmt: skip
        assert badness_of(robot, k, front + x, y) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("ahead", [0.0, EDGE, 3.0])
def test_every_kick_draws_three_numbers_whether_it_hits_misses_or_meets_air(ahead):
    match = ready(LEGGED, ahead, matches=50)
    before = match.robots["noise"][:, 0, RobotStream.KICK].copy()
    finish(match)
    drawn = match.robots["noise"][:, 0, RobotStream.KICK] - before
    assert (drawn == np.uint64((3 * int(GOLDEN)) % 2**64)).all()


@pytest.mark.parametrize(("gap", "share"), [(0.002, 1.0), (0.006, 0.0)])
@pytest.mark.parametrize(("name", "miss"), [(LEGGED, 0.5), (MIDDLE, 0.2)])
def test_a_ball_that_another_robot_touches_lies_as_badly_as_it_can(name, miss, gap, share):
    match = ready(name)
    heading, apart = match.robots["heading"][:, 0], 2.0 * (match.league.body.front + match.league.ball.radius) + gap
    place(match, robots={1: (0.1 + apart * np.cos(heading), -0.2 + apart * np.sin(heading), heading + np.pi)})
    missed = (~finish(match)).mean()
    assert missed == pytest.approx(share * miss, abs=4.0 * np.sqrt(share * miss * (1.0 - miss) / KICKS))
