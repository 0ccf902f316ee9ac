"""The pocket: how much of the ball it holds, and that a ball pushed straight ahead stays in it."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.physics.engine.space import build_space
from tests.scenes.leagues import LEAGUES, LEGGED, MIDDLE, each_league, endless, steady
from tests.scenes.staging import asking, outline, place, play, put, stage


def pushed(league, matches, v, seconds, forward):
    """Return matches in which a robot has pushed its ball ahead, and the greatest distance that it lost it by."""
    match = stage(league, matches, seed=4)
    place(match, ball=(-1.2 + league.body.front + league.ball.radius + 0.003, 0.0), robots={0: (-1.2, 0.0, 0.0)})
    kept = np.ones(matches, bool)
    for step in range(round(seconds * league.control_rate)):
        match.step(asking(match, forward=forward(step * league.dt) * v / league.drive.forward))
        if step > 2 * league.delay_steps:
            kept &= match.robots["has_ball"][:, 0] == 1
    return match, kept


def test_a_legged_robot_at_7_cm_per_s_keeps_the_ball_over_a_metre():
    match, kept = pushed(find_league(LEGGED), 60, 0.07, 17.0, lambda t: 1.0)
    assert (match.robots["x"][:, 0] > -0.2).all()
    assert kept.all()
    assert (abs(match.balls["y"]) < 0.02).all()


def test_a_middle_size_robot_at_1_m_per_s_keeps_the_ball_over_a_metre_if_it_starts_gently():
    match, kept = pushed(find_league(MIDDLE), 60, 1.0, 3.0, lambda t: min(t / 1.0, 1.0))
    assert (match.robots["x"][:, 0] > -0.2).all()
    assert kept.all()


def test_a_robot_that_brakes_hard_loses_its_ball():
    match, _ = pushed(steady(MIDDLE), 1, 1.5, 2.5, lambda t: min(t / 1.0, 1.0) if t < 1.5 else 0.0)
    assert match.robots["has_ball"][0, 0] == 0
    gap = match.balls["x"][0] - match.robots["x"][0, 0] - match.league.body.front - match.league.ball.radius
    assert gap > 0.3


def test_a_robot_that_turns_on_the_spot_loses_its_ball():
    match = stage(steady(MIDDLE), ball=(-1.0 + 0.18 + 0.11 + 0.003, 0.0), robots={0: (-1.0, 0.0, 0.0)})
    play(match, actions=asking(match, turn=1.0), steps=100)
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
        match.step(asking(match, forward=forward, left=left, turn=turn))
        last[match.robots["has_ball"][:, 0] == 1] = (step - warm + 1) * league.dt
    return last


def test_a_guide_keeps_the_ball_by_geometry_and_friction_straight_ahead_and_loses_it_the_sooner_the_faster_it_turns():
    drive = find_league(MIDDLE).drive
    rates = np.array([0.0, 0.2, 0.5, 1.0, 2.0, 3.0])  # [rad/s]
    ahead = np.full(len(rates), 1.0 / drive.forward)
    times = kept_for(np.stack([ahead, 0.0 * rates, rates / drive.turn], axis=1))
    assert times[0] == 4.0
    assert (np.diff(times) <= 0.0).all()
    assert times[1] > 2.0 and (times[2:] < 0.8).all()


def test_a_guide_does_not_pull_the_ball_along_when_it_brakes_goes_back_or_aside():
    standing, back, aside = [0.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]
    assert (kept_for(np.array([standing, back, aside]), 1.5) < 0.5).all()


@each_league
def test_a_ball_a_little_off_the_middle_is_steered_into_the_pocket_by_its_tips(name):
    league = steady(name)
    aside = np.linspace(-0.6, 0.6, 21) * (league.body.tip_y - league.body.tip_radius)
    match = stage(league, 21)
    put(match, 0, -1.2, 0.0, 0.0)
    place(match, ball=(-1.2 + league.body.tip_x + league.ball.radius + league.body.tip_radius + 0.05, aside))
    share = 0.5 if name == LEGGED else 0.2
    for _ in range(round(0.5 / (share * league.drive.forward) * league.control_rate)):
        match.step(asking(match, forward=share))
    assert (match.robots["has_ball"][:, 0] == 1).mean() > 0.9


@each_league
def test_a_ball_against_the_front_lies_in_the_pocket_and_overlaps_nothing(name):
    league = find_league(name)
    match = stage(league, robots={0: (0.0, 0.0, 0.7)})
    reach = league.body.front + league.ball.radius
    place(match, ball=(reach * np.cos(0.7), reach * np.sin(0.7)))
    match.step(asking(match))
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
