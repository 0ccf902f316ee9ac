"""What comes back from boards and robots: a rolling ball, and blows of legs with the elasticity and friction stated."""

from math import pi

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues.league import League
from tests.scenes.leagues import LEGGED, boarded, each_league, endless, icy, steady
from tests.scenes.staging import freeze, place, put, put_ball, record_each_step, stage, stand

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
    return (match.balls["x"] - x) * dx + (match.balls["y"] - y) * dy


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
    farthest = record_each_step(match, lambda: ahead(match, side), 5.0)
    back = (ahead(match, side) + league.ball.radius)[speeds > 0.2 * top]
    assert farthest.max() + league.ball.radius < 0.02, "no ball gets into the side"
    assert back.max() < -0.005, "and all but slow ones come back"


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
    assert (-match.balls["vy"] <= back + 1e-9).all()


GAP = 0.004  # [m] between two that are about to meet, less than one travels in a control step


def on_ice(robots: int) -> Match:
    """Return a match in which neither the ground nor a drive acts on robots, so that blows alone change speeds."""
    match = stage(icy(LEGGED), home=1, away=1)
    freeze(match)
    for r in range(robots):
        match.robots["active"][:, r] = 1
    put_ball(match, -1.2, -0.8)
    return match


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
    match.robots["vx"][:, 0], match.robots["vy"][:, 0] = slide, speed
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
    match.robots["vx"][:, 0], match.robots["vy"][:, 0] = speed, slide
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
