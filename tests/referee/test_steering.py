"""Driving to places at a restart: round the held ball, which lies where it was put and gives way to nobody."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.compiled import compiled
from soccer_env.physics.contacts import paws_gap
from soccer_env.referee.steering import CLEAR, SLACK, avoid_ring, move_off_ball, path_round_ring
from soccer_env.types import Phase
from tests.scenes.leagues import LEGGED, MIDDLE, each_league
from tests.scenes.staging import distance, place, put, put_ball, scatter, set_phase, speed, stage, stand, steps_in

DIFFERENTIAL = "middle-size-2006-differential"
DEEPEST = 0.001  # [m] of a robot that was set back, in the held ball
PRESSED = {LEGGED: 0.006, MIDDLE: 0.010, DIFFERENTIAL: 0.010}  # [m] of one that is pressed into it, in 99 % of steps


@compiled
def measure_gaps(matches, balls, robots, constants, gaps):
    for m in range(len(balls)):
        for r in range(robots.shape[1]):
            gaps[m, r] = paws_gap(robots[m, r], constants[0], balls[m].x, balls[m].y, matches[m].handedness)


@compiled
def keep_all(balls, robots, constants, moved):
    for m in range(len(balls)):
        moved[m] = move_off_ball(robots[m, 0], constants[0], balls[m], 1.0)


def gaps_of(match: Match) -> np.ndarray:
    """Return how far all robots are from the ball (M, R) [m], below 0 in it."""
    gaps = np.zeros(match.robots.shape)
    measure_gaps(match.matches, match.balls, match.robots, match.settings.constants(), gaps)
    return gaps


@pytest.mark.parametrize("handedness", [1.0, -1.0])
def test_a_way_that_keeps_off_the_ball_is_straight_and_through_its_middle_on_the_side_of_the_handedness(handedness):
    for x, y, to_x, to_y in ((-2.0, 0.6, 2.0, 0.6), (1.0, 0.0, 3.0, 0.1), (-3.0, 0.0, -1.0, 0.0)):
        assert path_round_ring(x, y, to_x, to_y, 0.5, handedness) == pytest.approx((to_x - x, to_y - y))
    ahead, left = path_round_ring(-2.0, 0.0, 2.0, 0.0, 0.5, handedness)
    assert left == pytest.approx(-handedness * 4.0 * 0.25) and ahead > 0.0


@pytest.mark.parametrize("y", [0.3, 0.1, -0.1, -0.3])
def test_a_way_through_the_ball_goes_along_the_tangent_of_its_ring_on_the_side_on_which_it_passes(y):
    ring, x = 0.5, -2.0
    ahead, left = path_round_ring(x, y, 2.0, y, ring, 1.0)
    size = np.hypot(ahead, left)
    across = (x * left - y * ahead) / size
    assert across == pytest.approx(-np.sign(y) * ring), "the tangent passes the middle at the ring's radius"
    assert size == pytest.approx(4.0) and ahead > 0.0


@each_league
def test_a_robot_within_the_ring_backs_out_and_one_outside_brakes_in_time(name):
    match = stage(name)
    k, ring, top = match.settings.constants()[0], 0.4, match.league.drive.forward

    def held(x):
        return held_off(k, x, 0.0, 1.0, 0.3, ring)

    assert held(-0.3)[0] * top == pytest.approx(-0.1 / 0.25), "as far as it stands within, in a quarter of a second"
    assert held(-0.4)[0] == pytest.approx(0.0)
    room = 1e-3
    assert (held(-ring - room)[0] * top) ** 2 <= 2.0 * 0.7 * match.league.drive.acceleration * room
    far = held(-20.0)
    assert far[0] / far[1] == pytest.approx(1.0 / 0.3), "far away it may go where it wants"
    assert all(held(x)[1] == far[1] for x in (-0.3, -0.4, -1.0)), "along the ring as well"


@compiled
def held_off(k, x, y, to_x, to_y, ring):
    return avoid_ring(k, x, y, to_x, to_y, ring)


@pytest.mark.parametrize("name", [LEGGED, MIDDLE, DIFFERENTIAL])
def test_a_robot_where_the_ball_is_laid_down_is_set_back_till_it_touches_it_and_stopped(name):
    """From all sides, turned any way: the ball stays where it lies, the robot keeps its speed along the ball."""
    matches = 500
    match, rng = stage(name, matches), np.random.default_rng(1)
    reach = match.league.body.reach + match.league.ball.radius
    angle, away = rng.uniform(-np.pi, np.pi, matches), rng.uniform(0.0, 1.05, matches) * reach
    put(match, 0, away * np.cos(angle), away * np.sin(angle), rng.uniform(-np.pi, np.pi, matches))
    put_ball(match, 0.0, 0.0)
    match.robots["vx"][:, 0], match.robots["vy"][:, 0] = rng.uniform(-1.0, 1.0, (2, matches))
    before, gap, moved = match.robots[:, 0].copy(), gaps_of(match)[:, 0], np.zeros(matches)
    keep_all(match.balls, match.robots, match.settings.constants(), moved)
    robot, after = match.robots[:, 0], gaps_of(match)[:, 0]
    inside = moved > 0.0
    assert 0.5 < inside.mean() < 0.97
    assert gap[inside].max() < -SLACK and gap[~inside].min() > -DEEPEST
    assert after.min() > -DEEPEST and after[inside].max() < 1e-9
    assert robot[~inside].tobytes() == before[~inside].tobytes(), "who does not stand in it is left alone"
    out_x, out_y = np.cos(angle), np.sin(angle)
    closing = -(robot["vx"] * out_x + robot["vy"] * out_y)
    assert closing[inside].max() < 1e-12
    along = [state["vy"] * out_x - state["vx"] * out_y for state in (robot, before)]
    np.testing.assert_allclose(*along, atol=1e-12)
    assert not speed(match.balls).any() and not match.balls["x"].any()


@each_league
def test_a_robot_on_whose_place_the_ball_is_put_is_set_back_at_once_and_told(name):
    robots = {0: (0.05, 0.02), 1: (1.0, 0.6), 2: (1.2, -0.6), 3: (-1.0, 0.7)}
    match = stage(name, 4, home=2, away=2, placement="drive", robots=robots)
    place(match, ball=(match.league.pitch.length / 2 + match.league.ball.radius + 0.01, 0.0))
    match.step(stand(match))
    assert (match.matches["placing"] == 1).all() and (match.events["restart"] == Phase.KICK_OFF).all()
    assert gaps_of(match).min() > -DEEPEST and match.robots["placed"].tolist() == [[1, 0, 0, 0]] * 4


@pytest.mark.parametrize("name", [LEGGED, MIDDLE, DIFFERENTIAL])
def test_a_robot_whose_place_lies_beyond_the_ball_goes_round_it(name):
    """It starts on the far side, a little to one side or right behind the ball, turned any way."""
    match = stage(name, 40, home=1, away=1, placement="drive")
    league = match.league
    put(match, 0, 0.25 * league.pitch.length, np.linspace(-0.2, 0.2, 40), np.linspace(-3.0, 3.0, 40))
    put(match, 1, 0.4 * league.pitch.length, 0.4 * league.pitch.width)
    put_ball(match, -league.pitch.length / 2 - league.ball.radius - 0.01, 0.0)  # away scores, home kicks off
    match.rebuild()
    match.step(stand(match))
    nearest, last = np.full(40, np.inf), match.robots[:, 0].copy()
    placing = match.matches["placing"] == 1
    assert placing.all()
    for _ in range(steps_in(match, 9.9)):
        nearest[placing] = np.minimum(nearest, gaps_of(match)[:, 0])[placing]
        last[placing] = match.robots[placing, 0]
        match.step(stand(match))
        placing &= match.matches["placing"] == 1
    assert nearest.min() > 0.0, "nobody pushes it, and it touches nothing"
    if name != LEGGED:  # legs take longer than the referee waits
        assert not placing.any()
        assert (distance(last, 0.0, 0.0) < league.body.reach + league.ball.radius + CLEAR + 0.15).all()


@pytest.mark.parametrize(("name", "size"), [(LEGGED, 3), (MIDDLE, 5), (DIFFERENTIAL, 3)])
def test_while_placing_nobody_drives_through_the_ball(name, size):
    match = Match(name, home=size, away=size, matches=24, seed=6, placement="drive")
    set_phase(match, Phase.PLAY)
    scatter(match, np.random.default_rng(6), 0.5)
    place(match, ball=(match.league.pitch.length / 2 + 0.2, 0.0))
    match.step(stand(match))
    placing, depths, moved = match.matches["placing"] == 1, [], 0.0
    assert placing.all()
    while placing.any():
        depths.extend(-gaps_of(match)[placing].min(axis=1))
        before = match.robots[["x", "y"]].copy()
        match.step(stand(match))
        placing &= match.matches["placing"] == 1
        assert not match.balls["x"][placing].any() and not match.balls["y"][placing].any()
        moved = max(moved, distance(match.robots, before["x"], before["y"])[placing].max(initial=0.0))
    assert np.quantile(depths, 0.99) < PRESSED[name] and max(depths) < 2.0 * PRESSED[name]
    assert moved > 0.5 * match.league.drive.forward * match.league.dt
