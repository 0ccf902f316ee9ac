"""Energy: without commands nothing ever speeds up; a blow adds none and keeps momentum, whatever meets whatever."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues.league import League
from soccer_env.physics.engine.space import robot_moment
from soccer_env.types import Phase
from tests.scenes.leagues import LEGGED, boarded, each_league, endless, icy, steady
from tests.scenes.looking import energy
from tests.scenes.staging import (
    freeze,
    place,
    play,
    put,
    put_ball,
    robot_actions,
    scatter,
    set_phase,
    stage,
    stand,
    steps_in,
)

SOLVER = 1e-9  # [J] of rounding in a step


def let_loose(name: str, matches: int, seed: int) -> Match:
    """Return matches in which ball and six robots move at random between boards, and nobody commands them."""
    match = Match(boarded(name), home=3, away=3, matches=matches, seed=seed)
    set_phase(match, Phase.PLAY)
    rng = np.random.default_rng(seed)
    scatter(match, rng, 0.7)
    drive, top = match.league.drive, match.league.ball.top_speed
    angle, v = rng.uniform(-np.pi, np.pi, matches), rng.uniform(0.3, 1.0, matches) * top
    put_ball(match, match.balls["x"], match.balls["y"], v * np.cos(angle), v * np.sin(angle))
    angle, v = (rng.uniform(low, high, match.robots.shape) for low, high in ((-np.pi, np.pi), (0.0, drive.forward)))
    match.robots["vx"], match.robots["vy"] = v * np.cos(angle), v * np.sin(angle)
    match.robots["omega"] = rng.uniform(-drive.turn, drive.turn, match.robots.shape)
    match.rebuild()
    return match


@each_league
def test_without_commands_the_kinetic_energy_of_a_match_never_grows(name):
    match = let_loose(name, 100, seed=3)
    before, began = energy(match), energy(match)
    playing = np.ones(match.count, bool)
    growth = np.zeros(match.count)
    for _ in range(steps_in(match, 4.0)):
        match.step(stand(match))
        playing &= match.events["restart"] == 0  # a goal lays the ball down
        now = energy(match)
        growth[playing] = np.maximum(growth, now - before)[playing]
        before = now
    assert growth.max() < SOLVER
    assert (before[playing] < 0.6 * began[playing]).all(), "and most of it is spent"


MATCHES = 200


def throng(league: League, seed: int, x: float = 0.0, y: float = 0.0) -> Match:
    """Return matches in which a ball and three robots rush at each other on ice, round a place [m]."""
    match = freeze(stage(league, MATCHES, home=2, away=1))
    rng, body, top = np.random.default_rng(seed), match.league.body, match.league.drive.forward
    corners = np.array([(i, j) for i in (-1.1, 1.1) for j in (-1.1, 1.1)])
    corners = corners[rng.permuted(np.tile(np.arange(4), (MATCHES, 1)), axis=1)]
    for r in range(3):
        corner = corners[:, r] * body.reach + (x, y)
        put(match, r, *corner.T, rng.uniform(-np.pi, np.pi, MATCHES))
        drift = 0.5 * (rng.uniform(-top, top, (MATCHES, 2)) - 0.9 * top * corners[:, r])
        match.robots["vx"][:, r], match.robots["vy"][:, r] = drift.T
    match.robots["omega"] = rng.uniform(-1.0, 1.0, (MATCHES, 3)) * match.league.drive.turn
    v, angle = match.league.ball.top_speed * rng.uniform(0.0, 0.4, MATCHES), rng.uniform(-np.pi, np.pi, MATCHES)
    corner = corners[:, 3] * body.reach + (x, y)
    place(match, ball=(*corner.T, v * np.cos(angle), v * np.sin(angle)))
    return match


def momentum(match: Match) -> np.ndarray:
    """Return the momentum (M, 2) of ball and robots [N s]."""
    ball, body = match.league.ball, match.league.body
    sums = [ball.mass * match.balls[v] + body.mass * match.robots[v].sum(axis=1) for v in ("vx", "vy")]
    return np.stack(sums, axis=-1)


def growth_in(match: Match, seconds: float) -> np.ndarray:
    """Return by how much of its first energy a match has grown at most in a step (M,)."""
    before = began = energy(match)
    growth, blows = np.zeros(MATCHES), 0
    for _ in range(steps_in(match, seconds)):
        match.step(stand(match))
        now = energy(match)
        growth = np.maximum(growth, (now - before) / began)
        blows += (now < 0.99 * before).sum()
        before = now
    assert blows > MATCHES / 2, "many blows are looked at"
    return growth


def adds_next_to_nothing(growth: np.ndarray) -> bool:
    """Tell whether matches gain no energy but for a jam in a hundred, which the rounds of impulses leave unsolved.

    There a ball, a part in 70 of a robot's mass, is pressed by three bodies; it gains some parts in a thousand.
    """
    return bool((growth > 1e-9).mean() <= 0.01 and growth.max() < 5e-3)


@each_league
@pytest.mark.parametrize("seed", [2, 5])
def test_blows_in_a_throng_on_ice_add_no_energy(name, seed):
    assert adds_next_to_nothing(growth_in(throng(icy(endless(name)), seed=seed), 3.0))


@each_league
def test_blows_of_robots_and_boards_on_ice_add_no_energy_and_those_in_a_throng_keep_momentum(name):
    league = icy(boarded(name))
    match = throng(league, seed=1, y=0.5 * league.pitch.width - 2.5 * league.body.reach)
    place(match, ball=(0.4 * league.pitch.length, -0.4 * league.pitch.width))
    assert adds_next_to_nothing(growth_in(match, 2.0))
    match = throng(icy(endless(name)), seed=1)
    kept, moved = momentum(match), match.robots["vx"].copy()
    for _ in range(steps_in(match, 3.0)):
        match.step(stand(match))
        assert abs(momentum(match) - kept).max() < 3e-10 * match.league.body.mass
    assert (abs(match.robots["vx"] - moved) > 1e-3).mean() > 0.5


def swinging(mass: float, gap: float, side: float) -> Match:
    """Return a match in which a robot on ice walks at full speed, a slick ball at rest a gap [m] before a forepaw.

    The left forepaw (side 1) begins to swing ahead, the right one (-1) to stand.
    """
    league = icy(steady(endless(LEGGED)))
    slick = replace(league.materials, ball_robot=replace(league.materials.ball_robot, friction=0.0))
    match = stage(replace(league, body=replace(league.body, mass=mass), materials=slick))
    drive, body = match.league.drive, match.league.body
    put(match, 0, 0.0, 0.0, forward=drive.forward)
    match.robots["gait_phase"] = 0
    half = 0.25 * drive.gait_steps * match.league.dt * drive.forward  # [m] of a stroke
    ahead = body.tip_x - side * half + body.tip_radius + match.league.ball.radius
    place(match, ball=(ahead + gap, side * body.tip_y))
    return freeze(match)


@pytest.mark.parametrize("mass", [1e6, 1.45, 0.2])
def test_ms51_a_paw_that_swings_hits_the_ball_at_twice_the_speed_of_the_walk(mass):
    """Off the centre's line, a robot of mass M resists with 1 / (1 / M + y^2 / I)."""
    match = swinging(mass, gap=0.004, side=1.0)
    league, u = match.league, 2.0 * match.league.drive.forward
    body, ball = league.body, league.ball
    both = 1.0 / ball.mass + 1.0 / body.mass + body.tip_y**2 / robot_moment(league)  # [1/kg]
    match.step(robot_actions(match, forward=1.0))
    expected = (1.0 + league.materials.ball_robot.elasticity) * u / both / ball.mass
    assert match.balls["vx"][0] == pytest.approx(expected, rel=1e-6)
    assert match.balls["vy"][0] == pytest.approx(0.0, abs=1e-6)


def test_ms51_a_paw_that_stands_on_the_ground_leaves_the_ball_alone():
    match = swinging(1e6, gap=0.001, side=-1.0)
    play(match, actions=robot_actions(match, forward=1.0), steps=match.league.drive.gait_steps // 2)
    assert abs(match.balls["vx"][0]) < 1e-9
    play(match, actions=robot_actions(match, forward=1.0), steps=match.league.drive.gait_steps // 2)
    assert match.balls["vx"][0] > match.league.drive.forward, "then it swings"
