"""A ball that rolls into something: friction takes roll and sliding speed, in closed form over speed and angle.

Seen along the normal n into what it meets and the tangent t to its left, with P the impulse along n:

    level slip u, upright slip w = roll . n        Coulomb's friction mu P in the direction of (u, w)
    level impulse     Q = min(mu P |u| / hypot(u, w), what stops the slip: |u| m shell / (1 + shell))
    upright impulse   J = sqrt((mu P)^2 - Q^2), which takes J / (shell m) of the roll along n, all of it at most
"""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from tests.scenes.leagues import MIDDLE, boarded, each_league, icy
from tests.scenes.staging import energy, freeze, put_ball, stage, stand

RATE = 1000  # [1/s] control steps, so short that a step holds one blow
SUBSTEPS = 2
DEEP = 1e-6  # [m] overlap in the substep of the blow: where it happens is then known
ANGLES = np.radians([-75.0, -60.0, -40.0, -20.0, -5.0, 0.0, 10.0, 30.0, 50.0, 75.0])
SPEEDS = np.array([0.05, 0.2, 0.6, 1.0])  # [1] of the ball's top speed
ROLLS = np.array([1.0, 0.0, -0.5, 2.0])  # [1] of the speed: rolling, sliding, backspin, topspin


def quick(league: str | League, mass: float = 1e6) -> League:
    """Return the league on a carpet without friction, with robots of a mass [kg] and short control steps."""
    found = fine(icy(league))
    substeps = replace(found.substeps, least=SUBSTEPS, close=SUBSTEPS, most=SUBSTEPS, travel=1.0)
    return replace(found, substeps=substeps, body=replace(found.body, mass=mass))


def fine(league: League) -> League:
    """Return the league in short control steps; so many that no delay would fit."""
    return replace(league, control_rate=RATE, drive=replace(league.drive, delay=0.0))


def targets(league: League) -> dict[str, tuple[tuple[float, float], tuple[float, float]]]:
    """Return points [m] of a robot at the origin that heads along x, and the normals into it there."""
    body = league.body
    rear = body.disc_x - body.disc_back
    return {
        "front": ((body.front, 0.0), (-1.0, 0.0)),
        "left side": ((0.5 * (body.disc_x + rear), body.disc_radius), (0.0, -1.0)),
        "right side": ((0.5 * (body.disc_x + rear), -body.disc_radius), (0.0, 1.0)),
        "back": ((rear - body.disc_radius, 0.0), (1.0, 0.0)),
        "left post": ((body.tip_x + body.tip_radius, body.tip_y), (-1.0, 0.0)),
        "right post": ((body.tip_x, -body.tip_y - body.tip_radius), (0.0, 1.0)),
    }


def shoot(match: Match, point, normal, speeds, angles, rolls) -> None:
    """Shoot the balls at a point [m] at angles [rad] off the normal; they get there in the first substep."""
    nx, ny = normal
    along, across = speeds * np.cos(angles), speeds * np.sin(angles)
    vx, vy = along * nx - across * ny, along * ny + across * nx
    radius, dt = match.league.ball.radius, match.league.dt / SUBSTEPS
    x, y = point[0] - (radius - DEEP) * nx - vx * dt, point[1] - (radius - DEEP) * ny - vy * dt
    put_ball(match, x, y, vx, vy)
    match.balls["roll_x"], match.balls["roll_y"] = rolls * vx, rolls * vy
    match.rebuild()


def every(league: League) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return all speeds [m/s], angles [rad] and rolls [1], each with each."""
    found = np.meshgrid(SPEEDS * league.ball.top_speed / 2.0, ANGLES, ROLLS)
    return found[0].ravel(), found[1].ravel(), found[2].ravel()


def check_blow(match: Match, point, normal, pair, speeds, angles, rolls, share=1.0) -> None:
    """Assert that the balls leave as the closed form says; `share`: the mass that a blow feels over the ball's."""
    ball, (nx, ny) = match.league.ball, normal
    shoot(match, point, normal, speeds, angles, rolls)
    before = energy(match)
    match.step(stand(match))
    assert (energy(match) <= before * (1.0 + 1e-9)).all()
    along, u, w = speeds * np.cos(angles), speeds * np.sin(angles), rolls * speeds * np.cos(angles)
    push = (1.0 + pair.elasticity) * share * along  # [m/s] the impulse over the ball's mass
    slip = np.hypot(u, w)
    level = pair.friction * push * np.divide(abs(u), slip, out=np.ones_like(slip), where=slip > 0.0)
    level = np.minimum(level, abs(u) * ball.shell / (1.0 + ball.shell))
    most = np.sqrt(np.maximum((pair.friction * push) ** 2 - level**2, 0.0)) / ball.shell
    expected = {
        "along": along - push,
        "across": u - np.sign(u) * level,
        "roll along": w - np.clip(w, -most, most),
        "roll across": rolls * u,
        "spin": -np.sign(u) * level / (ball.shell * ball.radius),
    }
    balls = match.balls
    found = {
        "along": balls["vx"] * nx + balls["vy"] * ny,
        "across": balls["vy"] * nx - balls["vx"] * ny,
        "roll along": balls["roll_x"] * nx + balls["roll_y"] * ny,
        "roll across": balls["roll_y"] * nx - balls["roll_x"] * ny,
        "spin": balls["spin"],
    }
    for name, numbers in expected.items():
        np.testing.assert_allclose(found[name], numbers, rtol=1e-5, atol=1e-5 * speeds.max(), err_msg=name)


@each_league
def test_a_board_takes_roll_and_speed_as_friction_and_elasticity_say_and_a_robot_on_ice_by_the_reduced_mass(name):
    """Into the middle of its back, so that it does not turn."""
    league = quick(boarded(name))
    speeds, angles, rolls = every(league)
    match = stage(league, len(speeds))
    side = (0.2 * league.pitch.length, 0.5 * league.pitch.width)
    check_blow(match, side, (0.0, 1.0), league.materials.ball_board, speeds, angles, rolls)
    end = (-0.5 * league.pitch.length, 0.4 * league.pitch.width)
    check_blow(match, end, (-1.0, 0.0), league.materials.ball_board, speeds, angles, rolls)
    league = quick(name, mass=8.0 * find_league(name).ball.mass)
    match = freeze(stage(league, len(ROLLS), robots={0: (0.0, 0.0)}))
    point, normal = targets(league)["back"]
    speeds, angles = np.full((2, len(ROLLS)), ((0.4 * league.ball.top_speed,), (0.0,)))
    check_blow(match, point, normal, league.materials.ball_robot, speeds, angles, ROLLS, share=8.0 / 9.0)


def test_a_goal_post_takes_roll_and_speed_of_a_ball_as_friction_and_elasticity_say():
    league = quick(MIDDLE)
    pitch = league.pitch
    speeds, angles, rolls = every(league)
    match = stage(league, len(speeds))
    end = (0.5 * pitch.length, 0.5 * pitch.goal_width + pitch.post_radius)
    check_blow(match, end, (1.0, 0.0), league.materials.ball_post, speeds, angles, rolls)


@pytest.mark.parametrize("part", ["front", "left side", "right side", "back", "left post", "right post"])
@each_league
def test_a_heavy_robot_takes_roll_and_speed_of_a_ball_as_friction_and_elasticity_say(name, part):
    league = quick(name)
    speeds, angles, rolls = every(league)
    match = stage(league, len(speeds), robots={0: (0.0, 0.0)})
    point, normal = targets(league)[part]
    check_blow(match, point, normal, league.materials.ball_robot, speeds, angles, rolls)


@each_league
def test_a_wall_takes_the_roll_of_a_ball_that_its_own_roll_drives_into_it(name):
    """The carpet presses it against the board with m times `sliding`, whose friction is mu of that.

    It brakes the roll itself, too: both together take (1 + mu) sliding t / shell, and nothing turns the roll round.
    """
    league = fine(boarded(name))
    ball, mu = league.ball, league.materials.ball_board.friction
    match = stage(league, ball=(0.0, 0.5 * league.pitch.width - ball.radius))
    match.balls["roll_y"] = began = 1.0
    match.rebuild()
    rate = (1.0 + mu) * ball.sliding / ball.shell  # [m/s2]
    for step in range(1, int(1.2 * began / rate * RATE)):
        match.step(stand(match))
        left = max(began - rate * step / RATE, 0.0)
        assert match.balls["roll_y"][0] == pytest.approx(left, abs=0.03) and match.balls["roll_y"][0] > -0.03
    assert abs(match.balls["vy"][0]) < 0.01
