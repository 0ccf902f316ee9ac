"""Boards, posts and nets: what bounces, how much, and that nothing passes through."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.physics.engine.space import build_space
from soccer_env.types import HOME, NO_TEAM
from tests.scenes.leagues import LEGGED, MIDDLE, boarded, each_league, icy, league_without_calls
from tests.scenes.staging import (
    outline,
    place,
    play,
    put,
    put_ball,
    record_each_step,
    robot_actions,
    speed,
    stage,
    stand,
)

HUNDREDS = 300


def bounces(match, towards, steps):
    """Step until each ball moves against `towards` (an axis "x" or "y"); return its speeds before, after and along."""
    before, after, along = np.full((3, match.count), np.nan)
    other = "vx" if towards == "y" else "vy"
    for _ in range(steps):
        last = match.balls[f"v{towards}"].copy()
        match.step(stand(match))
        now = match.balls[f"v{towards}"]
        turned = np.isnan(after) & (last > 0.0) & (now <= 0.0)
        before[turned], after[turned], along[turned] = last[turned], -now[turned], match.balls[other][turned]
    assert not np.isnan(after).any(), "a ball never came back"
    return before, after, along


@each_league
def test_a_ball_comes_back_from_a_board_with_the_elasticity_of_the_two_and_a_glancing_one_loses_to_friction(name):
    league = icy(boarded(name))
    rng = np.random.default_rng(1)
    v = rng.uniform(0.2, 1.0, 100) * league.ball.top_speed
    match = stage(league, 100)
    away = league.ball.radius + rng.uniform(0.1, 0.4, 100)
    put_ball(match, 0.3, league.pitch.width / 2 - away, 0.0, v, rolls=False)
    match.rebuild()
    before, after, _ = bounces(match, "y", 60)
    np.testing.assert_allclose(before, v, rtol=1e-6, err_msg="what it never meets takes nothing")
    np.testing.assert_allclose(after, before * league.materials.ball_board.elasticity, rtol=1e-6)
    league = icy(boarded(name))
    angle = np.linspace(0.2, 1.4, 50)
    v = 0.6 * league.ball.top_speed
    match = stage(league, 50)
    edge = league.pitch.width / 2 - league.ball.radius
    put_ball(match, -0.5, edge - 0.1, v * np.cos(angle), v * np.sin(angle), rolls=False)
    match.rebuild()
    before, after, along = bounces(match, "y", 30)
    assert (along <= v * np.cos(angle) + 1e-9).all()
    most = league.materials.ball_board.friction * (before + after)
    assert (along >= v * np.cos(angle) - most - 1e-9).all()


@each_league
def test_a_ball_comes_back_from_a_robot_with_the_elasticity_of_the_two(name):
    league = icy(name)
    rng = np.random.default_rng(2)
    v = rng.uniform(0.2, 1.0, 100) * league.ball.top_speed
    match = stage(league, 100)
    back = -outline(league)[:, 0].min()
    put(match, 0, 0.5, 0.0, 0.0)  # seen from behind
    put_ball(match, 0.5 - back - league.ball.radius - rng.uniform(0.05, 0.4, 100), 0.0, v, 0.0, rolls=False)
    match.rebuild()
    before, after, _ = bounces(match, "x", 60)
    both = league.materials.ball_robot.elasticity
    pushed = (league.ball.mass / (league.ball.mass + league.body.mass)) * (1.0 + both) * before
    assert (after <= both * before + 1e-3).all(), "at most that of a robot that the ground holds"
    assert (after >= both * before - pushed - 1e-3).all(), "at least that of one that slides freely"


def test_a_ball_on_the_post_stays_out_and_one_off_the_inside_of_the_post_goes_in():
    league = league_without_calls(MIDDLE)
    pitch, offsets = league.pitch, np.linspace(-0.06, 0.12, 60)  # [m] from the middle of the post, towards the corner
    match = stage(league, 120)
    y = np.concatenate([s * (pitch.goal_width / 2 + pitch.post_radius + offsets) for s in (1, -1)])
    place(match, ball=(pitch.length / 2 - 1.0, y, 9.0, 0.0))
    out = np.zeros(120, bool)
    for _ in range(30):
        match.step(stand(match))
        out |= match.events["out"] == 1
        assert (match.events["goal"] == NO_TEAM).all()
    head_on = np.tile(abs(offsets) < 0.05, 2)
    assert not out[head_on].any(), "it came back into the field"
    assert (match.balls["vx"][head_on] < 0.0).all()
    league = league_without_calls(MIDDLE)
    y = league.pitch.goal_width / 2 + league.pitch.post_radius - 0.14  # [m] the post turns it inwards
    match = stage(league, 2, ball=(league.pitch.length / 2 - 1.0, [y, -y], 9.0, 0.0))
    assert (record_each_step(match, lambda: match.events["goal"], steps=60) == HOME).sum() == 2


@each_league
def test_the_net_catches_the_ball(name):
    league = find_league(name)
    match = stage(league, 20)
    speeds = np.linspace(0.3, 1.0, 20) * league.ball.top_speed
    put_ball(match, league.pitch.length / 2 + 0.6 * league.ball.radius, 0.0, speeds, 0.0)
    before = match.balls.copy()
    for m in range(20):
        assert caught(league, before[m], match.robots[m]) <= 0.051 * speeds[m]


def caught(league, ball, robots):
    """Return the speed of a ball after the net, which it cannot pass, on no carpet."""
    space = build_space(league, ball, robots)
    body = next(iter(space.bodies))
    while body.velocity.x > 0.06 * ball["vx"]:
        space.step(0.1 * league.ball.radius / league.ball.top_speed)
        assert body.position.x < league.pitch.length / 2 + league.pitch.goal_depth
    return body.velocity.length


def crossings(league, old, new):
    """Tell for each ball whether its way in a step crossed a board, a post or a net (as centre lines)."""
    pitch = league.pitch
    line, depth, half = pitch.length / 2, pitch.goal_depth, pitch.goal_width / 2 + pitch.post_radius
    lines = []
    for end in (1, -1):
        back = end * (line + depth)
        lines += [((end * (line + pitch.post_radius), s * half), (back, s * half)) for s in (1, -1)]
        lines += [((back, -half), (back, half))]
        if pitch.walled:
            lines += [((end * line, s * (half + 0.01)), (end * line, s * pitch.width / 2)) for s in (1, -1)]
    if pitch.walled:
        lines += [((-line, s * pitch.width / 2), (line, s * pitch.width / 2)) for s in (1, -1)]
    crossed = np.zeros(len(old), bool)
    for start, stop in lines:
        crossed |= crosses(np.array(start), np.array(stop), old, new)
    return crossed


def crosses(start, stop, old, new):
    """Tell for each way old -> new (N, 2) whether it crosses the line from start to stop."""

    def side(a, b, p):
        return (b[..., 0] - a[..., 0]) * (p[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (p[..., 0] - a[..., 0])

    over = side(start, stop, old) * side(start, stop, new) < 0.0
    return over & (side(old, new, start) * side(old, new, stop) < 0.0)


def places(match):
    return np.stack([match.balls["x"], match.balls["y"]], axis=-1)


@pytest.mark.parametrize(("name", "make"), [(LEGGED, find_league), (MIDDLE, find_league), (MIDDLE, boarded)])
def test_no_ball_passes_through_a_board_a_post_or_a_net_at_top_speed(name, make):
    league = icy(make(name))
    pitch = league.pitch
    rng = np.random.default_rng(3)
    match = stage(league, HUNDREDS)
    x = rng.uniform(-1.0, 1.0, HUNDREDS) * (pitch.length / 2 - league.ball.radius - 0.01)
    y = rng.uniform(-1.0, 1.0, HUNDREDS) * (pitch.width / 2 - league.ball.radius - 0.01)
    aim = rng.uniform(-1.3, 1.3, HUNDREDS) * pitch.goal_width / 2  # half of them at a goal, its posts and side nets
    direction = np.arctan2(aim - y, rng.choice([-1, 1], HUNDREDS) * (pitch.length / 2 + pitch.goal_depth / 2) - x)
    direction[::2] = rng.uniform(-np.pi, np.pi, HUNDREDS // 2)
    place(match, ball=(x, y, league.ball.top_speed * np.cos(direction), league.ball.top_speed * np.sin(direction)))
    bounced = np.zeros(HUNDREDS, bool)
    for _ in range(60):
        old, speeds = places(match), speed(match.balls)
        match.step(stand(match))
        free = match.events["restart"] == 0
        assert not crossings(league, old[free], places(match)[free]).any()
        bounced |= free & (speed(match.balls) < 0.99 * speeds)
        if pitch.walled:
            in_goal = abs(match.balls["x"]) > pitch.length / 2
            assert (abs(match.balls["y"]) < np.where(in_goal, pitch.goal_width, pitch.width) / 2).all()
    assert bounced.mean() > 0.1


@pytest.mark.parametrize("depth", [0.0, 0.02])
@each_league
def test_no_ball_passes_through_a_robot_at_top_speed(name, depth):
    league = icy(boarded(name))
    rng = np.random.default_rng(4)
    body, ball = league.body, league.ball
    match = stage(league, HUNDREDS)
    heading, angle = rng.uniform(-np.pi, np.pi, (2, HUNDREDS))
    put(match, 0, 0.0, 0.0, heading)
    away = body.reach + ball.radius + rng.uniform(0.0, 0.3, HUNDREDS) + depth
    aside = rng.uniform(-1.0, 1.0, HUNDREDS) * 0.5 * min(body.disc_radius or 0.0775, 0.2)
    x, y = away * np.cos(angle) - aside * np.sin(angle), away * np.sin(angle) + aside * np.cos(angle)
    place(match, ball=(x, y, -ball.top_speed * np.cos(angle), -ball.top_speed * np.sin(angle)))
    knocked = np.zeros(HUNDREDS, bool)
    for _ in range(12):
        old = places(match)
        match.step(stand(match))
        robot, heading = match.robots[:, 0], match.robots["heading"][:, 0]
        middle = np.stack([robot["x"] + body.disc_x * np.cos(heading), robot["y"] + body.disc_x * np.sin(heading)], -1)
        inner = body.disc_radius or 0.0775  # [m] radius of a disc inside the body
        nearest = nearest_on_way(old - middle, places(match) - middle)
        assert (nearest > inner + ball.radius - 1.2 * league.substeps.travel).all()
        knocked |= match.robot_events["touch"][:, 0] == 1
    assert knocked.mean() > 0.95


def nearest_on_way(old, new):
    """Return how near each straight way old -> new (N, 2) comes to the origin."""
    way = new - old
    along = np.clip(-(old * way).sum(-1) / np.maximum((way * way).sum(-1), 1e-12), 0.0, 1.0)
    return np.hypot(*(old + along[:, None] * way).T)


def test_a_legged_robot_fits_into_the_goal_and_not_through_the_board_beside_it():
    league = league_without_calls(LEGGED)
    match = stage(league, 2, ball=(-1.0, 0.0), robots={0: (1.3, [0.0, 0.55], 0.0)})
    play(match, actions=robot_actions(match, forward=1.0), steps=160)
    inside, beside = match.robots["x"][:, 0] + league.body.tip_x + league.body.tip_radius
    pressed = 0.012  # [m] it goes into what it pushes against with its full force
    assert inside == pytest.approx(1.5 + league.pitch.goal_depth, abs=pressed)
    assert beside == pytest.approx(1.5 - league.pitch.board_foot, abs=pressed)
