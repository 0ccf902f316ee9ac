"""A rolling ball comes back from what it meets: off boards, and off every side of a robot that stands."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues.league import League
from tests.scenes.leagues import LEGGED, MIDDLE, boarded, each_league, endless, steady
from tests.scenes.staging import place, play, put, speed, stage, stand, steps_in

SIDES = ("front", "left", "right", "back")
DIRECTIONS = {"front": (-1.0, 0.0), "left": (0.0, -1.0), "right": (0.0, 1.0), "back": (1.0, 0.0)}  # of the ball
SQUARELY = np.radians(10.0)  # off the normal at most; farther off it meets a leg or the guide as well
RUN_UP = 0.01  # [m] from the surfaces of the two


def hull(league: League, side: str) -> tuple[float, float]:
    """Return the middle of a side of a robot's trunk [m], robot frame."""
    body = league.body
    rear = body.disc_x - body.disc_back
    x = {"front": body.front, "back": rear - body.disc_radius}.get(side, 0.5 * (body.disc_x + rear))
    return x, {"left": body.disc_radius, "right": -body.disc_radius}.get(side, 0.0)


def roll_at(match: Match, side: str, speeds: np.ndarray, aside: np.ndarray) -> None:
    """Let balls roll straight at a side of robot 0, `aside` [m] of its middle."""
    (x, y), (dx, dy), radius = hull(match.league, side), DIRECTIONS[side], match.league.ball.radius + RUN_UP
    put(match, 0, 0.0, 0.0)
    place(match, ball=(x - radius * dx - aside * dy, y - radius * dy + aside * dx, speeds * dx, speeds * dy))


def ahead(match: Match, side: str) -> np.ndarray:
    """Return how far beyond the middle of a side the balls' centres are, as they came [m]."""
    (x, y), (dx, dy) = hull(match.league, side), DIRECTIONS[side]
    found: np.ndarray = (match.balls["x"] - x) * dx + (match.balls["y"] - y) * dy
    return found


@pytest.mark.parametrize("way", [(0.0, 1.0), (1.0, 0.0)])
def test_a_ball_that_rolls_at_0_7_m_per_s_comes_back_5_to_20_cm_from_a_legged_board(way):
    match = stage(steady(LEGGED), 5)
    pitch, radius = match.league.pitch, match.league.ball.radius
    gap = np.linspace(0.005, 0.03, 5)  # [m] from the board, so that it hits it anywhere in a control step
    edge = 0.5 * (way[0] * pitch.length + way[1] * pitch.width) - radius
    start = edge - gap
    aside = 0.6 * way[0]
    place(match, ball=(way[0] * start, way[1] * start + aside, 0.7 * way[0], 0.7 * way[1]))
    play(match, 4.0)
    assert not speed(match.balls).any()
    away = edge - (match.balls["x"] if way[0] else match.balls["y"])
    assert (away > 0.05).all() and (away < 0.20).all(), away


@pytest.mark.parametrize("side", SIDES)
def test_a_ball_that_rolls_at_10_m_per_s_comes_back_a_metre_from_a_middle_size_robot_that_stands(side):
    match = stage(steady(endless(MIDDLE)), 5)
    roll_at(match, side, np.full(5, 10.0), np.linspace(-0.02, 0.02, 5))
    play(match, 3.0)
    assert (-ahead(match, side) - match.league.ball.radius > 1.0).all(), ahead(match, side)


@pytest.mark.parametrize("side", SIDES)
@each_league
def test_no_ball_that_hits_a_side_squarely_rolls_on_beyond_it(name, side):
    league = steady(endless(name))
    top = min(league.ball.top_speed, 10.0)
    width = (league.body.disc_radius + league.ball.radius) * np.sin(SQUARELY)
    grid = np.meshgrid(np.linspace(0.1, 1.0, 10) * top, np.linspace(-width, width, 7))
    speeds, aside = grid[0].ravel(), grid[1].ravel()
    match = stage(league, len(speeds))
    roll_at(match, side, speeds, aside)
    farthest = np.full(len(speeds), -np.inf)
    for _ in range(steps_in(match, 5.0)):
        match.step(stand(match))
        farthest = np.maximum(farthest, ahead(match, side))
    overlap = farthest + league.ball.radius
    assert overlap.max() < 0.02, "no ball gets into the side"
    assert (ahead(match, side) + league.ball.radius)[speeds > 0.2 * top].max() < -0.005, (
        "and all but slow ones come back"
    )


@each_league
def test_a_ball_that_rolls_comes_back_from_a_board_as_far_as_friction_and_elasticity_leave_it(name):
    """Head-on it leaves with -e v and rolls with (1 - mu (1 + e) / shell) v; sliding then makes one speed of both.

    (e - shell (1 - mu (1 + e) / shell)) v / (1 + shell)
    """
    match = stage(steady(boarded(name)), 6)
    league, pair = match.league, match.league.materials.ball_board
    model, gap = league.ball, 1e-3
    v = np.linspace(0.3, 0.8, 6) * model.top_speed
    edge = 0.5 * league.pitch.width - model.radius
    place(match, ball=(0.3, edge - gap, 0.0, v))
    roll = np.maximum(1.0 - pair.friction * (1.0 + pair.elasticity) / model.shell, 0.0)
    back = (pair.elasticity - model.shell * roll) / (1.0 + model.shell) * v
    time = np.abs(pair.elasticity + roll) * v / (model.sliding * (1.0 + 1.0 / model.shell))  # [s] of sliding
    for _ in range(int(np.ceil(time.max() / league.dt)) + 1):
        match.step(stand(match))
        rolls = match.balls["vy"] == match.balls["roll_y"]
    assert rolls.all() and (back > 0.0).all()
    lost = model.rolling * (time.max() + 2.0 * league.dt)
    assert (abs(-match.balls["vy"] - back) < lost).all()
    slower = -match.balls["vy"] <= back + 1e-9
    assert slower.all()
