"""Blows of legs show the elasticity and friction that the league states: on the ball, other robots and boards."""

from math import pi

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.match.staging import constants_of
from tests.scenes.staging import LEGGED, icy, put, put_ball, stage, stand

GAP = 0.004  # [m] between two that are about to meet, less than one travels in a control step


def on_ice(robots: int) -> Match:
    """Return a match in which neither the ground nor a drive acts on robots, so that blows alone change speeds."""
    match = stage(icy(LEGGED), home=1, away=1)
    for name in ("traction", "thrust", "turn_traction", "turn_thrust"):
        constants_of(match)[f"drive_{name}"] = 1e-9
    for r in range(robots):
        match.robots["active"][:, r] = 1
    put_ball(match, -1.2, -0.8)
    return match


def moving(match: Match, r: int, vx: float, vy: float) -> None:
    """Give a robot a velocity [m/s]."""
    match.robots["vx"][:, r], match.robots["vy"][:, r] = vx, vy


def blow(match: Match, mover: np.void) -> tuple[np.ndarray, np.ndarray]:
    """Step once; return the change of velocity (2,) [m/s] of what moves (a view), and where it was then (2,) [m].

    Nothing but the blow changes its velocity in this step, which tells when in the step it came.
    """
    match.rebuild()
    before = mover.copy()
    match.step(stand(match))
    change = np.array([mover[axis] - before[axis] for axis in ("vx", "vy")])
    place, speed = (("x", "vx"), ("y", "vy"))[int(abs(change).argmax())]
    late = (mover[place] - before[place] - before[speed] * match.league.dt) / (mover[speed] - before[speed])
    gone = match.league.dt - late  # [s] from the beginning of the step
    return change, np.array([before["x"] + gone * before["vx"], before["y"] + gone * before["vy"]])


def surface_speed(robot: np.void, ahead: float, left: float) -> np.ndarray:
    """Return the velocity [m/s] of a robot that heads along x, at a place of its frame [m]."""
    return np.array([robot["vx"] - robot["omega"] * left, robot["vy"] + robot["omega"] * ahead])


def friction_of(change: np.ndarray, normal: np.ndarray) -> float:
    """Return the impulse along a surface over that along its normal."""
    return float(abs((normal[0] * change[1] - normal[1] * change[0]) / (normal @ change)))


@pytest.mark.parametrize("slide", [0.0, 0.4])
def test_paws_come_back_from_a_board_as_robot_and_board_are_stated_to(slide):
    """Both forepaws meet it at once: the rounds of the solver leave a part in a hundred of such a blow."""
    match = on_ice(1)
    league, speed = match.league, 0.2
    reach = league.body.tip_x + league.body.tip_radius + league.pitch.board_foot
    put(match, 0, 0.0, league.pitch.width / 2 - reach - GAP, pi / 2)
    moving(match, 0, slide, speed)
    change, _ = blow(match, match.robots[0, 0])
    stated = league.materials.robot_board
    if slide == 0.0:
        assert change[1] == pytest.approx(-speed * (1.0 + stated.elasticity), rel=0.01)
    else:
        assert friction_of(change, np.array([0.0, 1.0])) == pytest.approx(stated.friction, rel=0.01)


@pytest.mark.parametrize("slide", [0.0, 0.6])
def test_a_forepaw_parts_from_a_hind_leg_as_two_robots_are_stated_to(slide):
    match = on_ice(2)
    league, speed = match.league, 0.3
    body, materials = league.body, league.materials
    aside = body.tip_y + body.hind_y  # the left forepaw behind the right hind leg
    put(match, 0, 0.0, 0.0, 0.0)
    put(match, 1, body.tip_x - body.hind_x + 2.0 * body.tip_radius + GAP, aside + slide / speed * GAP, 0.0)
    moving(match, 0, speed, slide)
    before = match.robots[0, 1].copy()
    change, place = blow(match, match.robots[0, 0])
    one, other = match.robots[0]
    if slide == 0.0:
        parting = surface_speed(other, body.hind_x, -body.hind_y) - surface_speed(one, body.tip_x, body.tip_y)
        assert parting[0] == pytest.approx(materials.robot_robot.elasticity * speed, abs=2e-3)
    else:
        leg = np.array([before["x"] + body.hind_x, before["y"] - body.hind_y])
        normal = leg - place - (body.tip_x, body.tip_y)
        assert friction_of(change, normal) == pytest.approx(materials.robot_robot.friction, rel=0.01)


@pytest.mark.parametrize("slide", [0.0, 1.4])
def test_the_ball_comes_back_from_a_hind_leg_as_ball_and_robot_are_stated_to(slide):
    match = on_ice(1)
    league, speed = match.league, 0.6  # [m/s] so slow that it slides all through the blow
    body, both = league.body, league.body.tip_radius + league.ball.radius
    put(match, 0, 0.0, 0.0, 0.0)
    put_ball(match, body.hind_x - both - GAP, body.hind_y - slide / speed * GAP, speed, slide, rolls=False)
    change, place = blow(match, match.balls[0])
    stated, robot = league.materials.ball_robot, match.robots[0, 0]
    if slide == 0.0:
        parting = surface_speed(robot, body.hind_x, body.hind_y)[0] - match.balls["vx"][0]
        assert parting == pytest.approx(stated.elasticity * speed, rel=1e-3)
    else:
        normal = np.array([body.hind_x, body.hind_y]) - place
        assert friction_of(change, normal) == pytest.approx(stated.friction, rel=0.01)
