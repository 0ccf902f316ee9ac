"""A ball between the faces of two legged robots: a kick may lift it out aside."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.scenes.leagues import LEGGED, MIDDLE, endless, league_without_calls
from tests.scenes.looking import deepest_overlaps, overlaps
from tests.scenes.staging import at_the_ball, put, put_ball, robot_actions, stage, steps_in

VICE = 0.003  # [m] between the ball and the fronts of the two robots that hold it


def vice(league, matches, x=0.0, y=0.0, heading=0.0, **settings) -> Match:
    """Return matches in which two robots face each other, the ball between them."""
    match = stage(league, matches, **settings)
    body, ball = match.league.body, match.league.ball
    apart = max(body.front + ball.radius + VICE, body.tip_x + body.tip_radius + 0.001)
    for r, way in ((0, -1.0), (1, 1.0)):
        turn = heading + (np.pi if way > 0.0 else 0.0)
        put(match, r, x + way * apart * np.cos(heading), y + way * apart * np.sin(heading), turn)
    put_ball(match, x, y)
    match.robots["has_ball"] = 1
    match.rebuild()
    return match


def squirts(match: Match) -> np.ndarray:
    """Let robot 0 kick once; return to which side of it the ball was lifted out (M,), 0: it was not."""
    side = np.zeros(match.count, int)
    for _ in range(14):
        match.step(robot_actions(match, kick=1.0))
        side += match.robot_events["squirt"][:, 0]
    return side


@pytest.mark.slow
def test_a_kick_in_a_vice_lifts_the_ball_out_aside_as_often_as_the_league_says_on_each_side_alike():
    matches = 2000
    match = vice(endless(LEGGED), matches, seed=5)
    kicker, side = match.league.kicker, squirts(match)
    for found, expected in ((abs(side), (1.0 - kicker.miss) * kicker.squirt), (side > 0, 0.125), (side < 0, 0.125)):
        spread = np.sqrt(expected * (1.0 - expected) / matches)
        assert found.mean() == pytest.approx(expected, abs=4.0 * spread)
    out = side != 0
    assert (np.sign(match.balls["y"]) == side)[out].all() and (abs(match.balls["y"])[out] > kicker.squirt_way).all()
    assert (abs(match.balls["y"])[~out] < 0.5 * kicker.squirt_way).all(), "the others stay in the vice"


def test_a_ball_that_is_lifted_out_rolls_on_aside_at_the_speed_of_the_weakest_kick():
    match = vice(endless(LEGGED), 200, heading=0.7, seed=6)
    seen = 0
    for _ in range(14):
        match.step(robot_actions(match, kick=1.0))
        for m in np.flatnonzero(match.robot_events["squirt"][:, 0]):
            ball, side = match.balls[m], match.robot_events["squirt"][m, 0]
            heading = match.robots["heading"][m, 0]
            off = (-np.sin(heading), np.cos(heading)) @ np.array(
                [ball["x"] - match.robots["x"][m, 0], ball["y"] - match.robots["y"][m, 0]]
            )
            way = np.array([-np.sin(heading), np.cos(heading)]) * side
            assert off == pytest.approx(side * match.league.kicker.squirt_way)
            assert (ball["vx"], ball["vy"]) == pytest.approx(tuple(match.league.kicker.slowest * way))
            assert (ball["roll_x"], ball["roll_y"]) == (ball["vx"], ball["vy"])
            seen += 1
    assert seen > 20


def test_only_a_pinched_ball_is_lifted_out_and_no_league_on_wheels_lifts_any():
    match = at_the_ball(LEGGED, 300, seed=2)
    assert not squirts(match).any()
    assert not squirts(vice(MIDDLE, 100, seed=2)).any() and find_league(MIDDLE).kicker.squirt == 0.0
    league = endless(LEGGED)
    without = replace(league, kicker=replace(league.kicker, squirt=0.0))
    assert not squirts(vice(without, 300, seed=5)).any()


def test_two_that_kick_at_a_ball_between_them_get_it_out_within_some_kicks():
    match = vice(endless(LEGGED), 200, seed=7)
    free = np.zeros(200, bool)
    for _ in range(steps_in(match, 12.0)):  # ten kicks of each
        match.step(robot_actions(match, r=[0, 1], kick=1.0))
        free |= abs(match.balls["y"]) > 0.12
    assert free.mean() > 0.97


@pytest.mark.slow
@pytest.mark.parametrize("heading", [0.0, 0.5 * np.pi, -0.25 * np.pi])
def test_a_ball_is_never_lifted_into_a_robot_or_beyond_a_board_but_to_the_other_side_or_not_at_all(heading):
    """A third robot stands beside the vice, and a board runs along it; then the vice stands in a corner."""
    for x, y in ((0.0, -0.68), (1.15, -0.68)):
        match = stage(league_without_calls(LEGGED), 200, home=2, away=2, seed=3)
        pinched = vice(league_without_calls(LEGGED), 1, x, y, heading)
        for r, other in ((0, 0), (2, 1)):
            robot = pinched.robots[0, other]
            put(match, r, robot["x"], robot["y"], robot["heading"])
        put(match, 1, x - 0.12, y + 0.23 if heading == 0.0 else y + 0.42, 0.3)
        put_ball(match, x, y)
        match.robots["has_ball"][:, [0, 2]] = 1
        match.rebuild()
        pitch, radius = match.league.pitch, match.league.ball.radius
        lifted, began = 0, deepest_overlaps(match)["ball robot"]
        for _ in range(40):
            match.step(robot_actions(match, r=[0, 2], kick=1.0))
            out = match.robot_events["squirt"].any(axis=1)
            moved = out & (np.hypot(match.balls["x"] - x, match.balls["y"] - y) > 0.1)
            lifted += int(moved.sum())
            assert (abs(match.balls["x"]) <= pitch.length / 2 - radius + 0.012).all()
            assert (abs(match.balls["y"]) <= pitch.width / 2 - radius + 0.012).all()
            for m in np.flatnonzero(moved):
                gaps = overlaps(match.league, match.balls[m], match.robots[m], float(match.matches["handedness"][m]))
                assert gaps["ball robot"] == 0.0
        assert began == 0.0 and lifted > 10
