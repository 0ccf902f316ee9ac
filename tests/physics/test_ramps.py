"""Ramps before the boards: a ball climbs them, comes back with half of its speed, and never rests on them."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.scenes.staging import (
    LEGGED,
    energy,
    league_without_calls,
    place,
    play,
    put_ball,
    robot_actions,
    speed,
    stage,
    stand,
)

FOOT = 0.1 + 0.042 * np.tan(np.pi / 8)  # [m] from a board to the centre of a ball that touches floor and ramp
DRIVES = 9.81 * 0.5 / (5 / 3)  # [m/s2] in plan, of a hollow ball that rolls down 45 degrees


def smooth_carpet():
    """Return the legged league with a carpet that does not slow a rolling ball."""
    league = league_without_calls(LEGGED)
    return replace(league, ball=replace(league.ball, rolling=0.0))


def rolled(league, ball, seconds: float) -> tuple[Match, np.ndarray]:
    """Return a match after a ball has rolled, and its places (steps, 2) [m]."""
    match, places = stage(league, ball=ball), []
    for _ in range(round(seconds / league.dt)):
        match.step(stand(match))
        places.append((float(match.balls["x"][0]), float(match.balls["y"][0])))
    return match, np.array(places)


@pytest.mark.parametrize("way", [(0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0)])
@pytest.mark.parametrize("speed", [0.05, 0.1, 0.2, 0.4, 0.8, 1.2])
def test_a_ball_climbs_as_its_energy_allows_and_comes_back_with_half_of_its_speed(way, speed):
    """Less the part of a substep in which it begins to roll back, 1/64 s at most."""
    league = smooth_carpet()
    edge = np.array([1.5, 1.0]) - FOOT
    start = np.abs(way) * (edge - 0.05 * speed) * np.sign(way) + (np.abs(way) == 0.0) * [0.3, 0.6]
    match, places = rolled(league, (*start, *(speed * np.array(way))), 1.4)
    past = (places @ np.array(way)).max() - edge @ np.abs(way)
    top = (0.5 * speed) ** 2 / (2.0 * DRIVES)
    assert 0.5 * top < past < 1.001 * top  # seen between two control steps
    back = np.array([match.balls["vx"][0], match.balls["vy"][0]]) @ np.array(way)
    assert -0.5 * speed * 1.001 < back < min(-0.5 * speed + 0.5 * DRIVES / 64.0, -0.4 * speed)
    rolls = match.balls["roll_x"][0], match.balls["roll_y"][0]
    assert rolls == pytest.approx((match.balls["vx"][0], match.balls["vy"][0]), abs=1e-12)


def test_a_ball_put_on_a_ramp_rolls_off_it_and_one_at_its_foot_and_in_the_mouth_of_a_goal_lies():
    match = stage(league_without_calls(LEGGED), 4)
    put_ball(match, np.array([0.3, 0.3, 1.45, 1.45]), np.array([0.95, 1.0 - FOOT - 1e-6, 0.5, 0.0]))
    match.rebuild()
    play(match, 2.0, stand(match))
    assert match.balls["y"][0] < 1.0 - FOOT and match.balls["x"][2] < 1.5 - FOOT
    assert (match.balls["x"][[1, 3]], match.balls["y"][[1, 3]]) == (
        pytest.approx([0.3, 1.45]), pytest.approx([1.0 - FOOT - 1e-6, 0.0]),
    )  # fmt: skip


def test_a_ball_that_the_referee_holds_stays_on_a_ramp_and_a_corner_drives_it_out_both_ways():
    match = stage(league_without_calls(LEGGED), 2, ball=(1.4, 0.9))
    match.matches["placing"][0] = 1
    match.matches["restart_x"][0], match.matches["restart_y"][0] = 1.4, 0.9
    match.step(stand(match))
    assert (match.balls["x"][0], match.balls["y"][0]) == pytest.approx((1.4, 0.9), abs=1e-6)
    assert match.balls["vx"][1] < 0.0 and match.balls["vy"][1] < 0.0


@pytest.mark.parametrize("end", [1.0, -1.0])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_ball_in_the_mouth_of_a_goal_does_not_roll_onto_the_end_of_a_ramp(end, side):
    match = stage(league_without_calls(LEGGED), ball=(end * 1.43, side * 0.2, 0.0, side * 0.8))
    play(match, 1.0, stand(match))
    assert (match.balls["x"][0], match.balls["y"][0]) == pytest.approx((end * 1.43, side * 0.3), abs=2e-6)
    assert match.balls["vy"][0] == match.balls["roll_y"][0] == 0.0


def test_a_ramp_gives_no_ball_energy_and_none_stays_on_it_or_leaves_the_pitch():
    """What a ball has on the floor never grows, whatever ramps and boards it has met meanwhile."""
    match = stage(league_without_calls(LEGGED), 400, seed=3)
    rng = np.random.default_rng(8)
    x, y = rng.uniform(-1.38, 1.38, 400), rng.choice([-1.0, 1.0], 400) * rng.uniform(0.5, 0.88, 400)
    v, angle = 10.0 ** rng.uniform(-1.3, 0.28, 400), rng.uniform(-np.pi, np.pi, 400)
    put_ball(match, x, y, v * np.cos(angle), v * np.sin(angle))
    match.rebuild()
    most, climbed, came_back = energy(match), np.zeros(400, bool), 0
    for _ in range(160):
        match.step(stand(match))
        x, y = np.abs(match.balls["x"]), np.abs(match.balls["y"])
        on_ramp = (y > 1.0 - FOOT) | ((x > 1.5 - FOOT) & (y > 0.3))
        climbed |= on_ramp
        now = energy(match)
        assert (now < most + 1e-12)[~on_ramp].all()
        came_back += int((climbed & ~on_ramp & (speed(match.balls) > 0.01)).sum())
        most = np.where(on_ramp, most, now)
        in_mouth = y < 0.3
        assert ((x < 1.5 - 0.03) | in_mouth).all() and (y < 1.0 - 0.03).all()  # 12 mm in a substep
    assert not on_ramp.any() and climbed.sum() > 100 and came_back > 1000


def test_a_fast_ball_meets_the_board_above_the_ramp_and_one_at_0_7_m_per_s_comes_to_rest_within_20_cm_of_the_foot():
    tops = [
        rolled(league_without_calls(LEGGED), (0.3, y, 0.0, 1.9), 0.5)[1][:, 1].max() for y in np.linspace(0.7, 0.8, 8)
    ]
    assert 0.945 < max(tops) < 1.0 - 0.03
    match, _ = rolled(league_without_calls(LEGGED), (0.3, 1.0 - FOOT - 0.005, 0.0, 0.7), 4.0)
    off = 1.0 - FOOT - match.balls["y"][0]
    assert match.balls["vy"][0] == 0.0 and 0.12 < off < 0.35**2 / (2.0 * 0.3)  # carpet: 0.3 m/s2


def test_a_robot_pushes_a_ball_up_a_ramp_only_as_far_as_its_paws_go_and_holds_it_there():
    match = stage(league_without_calls(LEGGED), 3, ball=([0.3, 0.3, -0.4], [0.7, 0.8, 0.84]))
    body, radius = match.league.body, match.league.ball.radius
    place(match, robots={0: (match.balls["x"], match.balls["y"] - body.front - radius - 0.001, np.pi / 2)})
    play(match, 5.0, robot_actions(match, forward=1.0))
    paws = match.robots["y"][:, 0] + body.tip_x + body.tip_radius
    assert paws == pytest.approx(np.full(3, 1.0 - match.league.pitch.board_foot), abs=0.003)
    off = match.balls["y"] - match.robots["y"][:, 0] - body.front - radius
    assert (abs(off) < 0.003).all() and (match.balls["y"] > 1.0 - FOOT).all()
    play(match, 2.0, robot_actions(match, forward=-1.0))
    assert (match.balls["y"] < 1.0 - FOOT).all(), "it rolls off when it is let go"


def test_a_ramp_is_at_least_as_wide_as_what_keeps_paws_off():
    with pytest.raises(ValueError, match="board_foot must be at most ramp"):
        league = find_league(LEGGED)
        replace(league, pitch=replace(league.pitch, ramp=0.05))
