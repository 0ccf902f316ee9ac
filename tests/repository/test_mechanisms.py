"""Mechanisms of the papers that live in leagues and drive; each test fails when the mechanism is switched off."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.scenes.staging import place, steady


def run(match: Match, command: tuple[float, ...], steps: int) -> None:
    """Let robot 0 of the first match do one thing, the others stand."""
    actions = np.zeros((match.count, len(match.agents), len(command)))
    actions[:, 0] = command
    for _ in range(steps):
        match.step(actions)


def test_ms56_the_legged_preset_is_what_the_paper_says() -> None:
    league = find_league("legged-2001")
    assert (league.pitch.length, league.pitch.width, league.team_size) == (3.0, 2.0, 3)
    assert league.drive.forward == 0.12 and league.drive.gait_steps / league.control_rate == 0.5
    assert Match("legged-2001", seed=0).robots["keeper"].tolist() == [[1, 0, 0, 1, 0, 0]]


def test_mh23_the_middle_size_preset_has_room_for_six_robots() -> None:
    match = Match("middle-size-2006", home=6, away=6, seed=0)
    assert (match.league.pitch.length, match.league.pitch.width) == (12.0, 8.0)
    assert match.robots["keeper"].sum() == 2 and len(match.agents) == 12


def test_mh01_the_omnidirectional_base_reaches_its_top_speed_in_every_direction() -> None:
    """MH01: 2.6 m/s in any direction; the old base 1.6 m/s and never sideways."""
    for angle in (0.0, 1.0, np.pi / 2, 2.5):
        match = Match(steady("middle-size-2006"), home=1, away=1, seed=0)
        place(match, (-5.5, -3.5), {0: (-1.0, -0.5), 1: (5.0, 3.0)})
        run(match, (np.cos(angle), np.sin(angle), 0.0, 0.0), 45)
        assert np.hypot(match.robots["vx"], match.robots["vy"])[0, 0] == pytest.approx(2.6, rel=1e-6)
    match = Match(steady("middle-size-2006-differential"), home=1, away=1, seed=0)
    place(match, (-5.5, -3.5), {0: (-1.0, -0.5), 1: (5.0, 3.0)})
    run(match, (0.0, 1.0, 0.0, 0.0), 45)
    assert np.hypot(match.robots["vx"], match.robots["vy"])[0, 0] == 0.0
    run(match, (1.0, 0.0, 0.0, 0.0), 60)
    assert np.hypot(match.robots["vx"], match.robots["vy"])[0, 0] == pytest.approx(1.6, rel=1e-6)


def test_mh03_the_control_cycle_takes_20_ms() -> None:
    match = Match("middle-size-2006", seed=0)
    run(match, (0.0,) * 4, 50)
    assert match.matches["clock"][0] == pytest.approx(1.0)


@pytest.mark.parametrize("strength", [0.1, 0.4, 1.0])
def test_mh04_the_kicker_shoots_as_hard_as_it_is_told(strength: float) -> None:
    """MH04: 0 to 10 m/s in proportion to the strength; the goalkeeper has none."""
    match = Match(steady("middle-size-2006"), home=2, away=1, matches=2, seed=0, rules="simple")
    for row in (0, 1):
        match.robots["x"][row], match.robots["y"][row] = [-3.0, -3.0, 4.0], [2.0, -2.0, 3.0]
        match.robots["heading"][row] = 0.0
    match.balls["x"] = -3.0 + 0.18 + 0.11
    match.balls["y"] = [2.0, -2.0]
    match.rebuild()
    actions = np.zeros((2, 3, 4))
    match.step(actions)
    actions[:, :2, 3] = strength
    match.step(actions)
    keeper, field_player = np.hypot(match.balls["vx"], match.balls["vy"])
    assert keeper == 0.0
    assert field_player == pytest.approx(10.0 * strength, abs=0.07)  # 3 m/s2 of sliding in a step of 20 ms


def test_ms07_the_head_keeps_the_ball_ahead_of_the_camera() -> None:
    """MS07: the head follows the ball by itself, within its limits and speeds, unless it is commanded."""
    match = Match("legged-2001", home=1, away=1, actions="full", seed=0)
    match.robots["x"][:, 0], match.robots["y"][:, 0], match.robots["heading"][:, 0] = -1.0, -0.5, 0.0
    match.balls["x"], match.balls["y"] = -0.8, -0.1
    match.rebuild()
    run(match, (0, 0, 0, 0, -1, 0, 0), 1)
    assert match.robots["pan"][0, 0] == pytest.approx(match.league.head.pan_speed / 16)
    run(match, (0, 0, 0, 0, -1, 0, 0), 16)
    assert match.robots["pan"][0, 0] == pytest.approx(np.arctan2(0.4, 0.2), abs=0.02)
    assert match.robots["tilt"][0, 0] < -0.3
    run(match, (0, 0, 0, 0, 1, -1, 1), 40)
    assert match.robots["pan"][0, 0] == pytest.approx(-match.league.head.pan_limit)
    assert match.robots["tilt"][0, 0] == pytest.approx(match.league.head.tilt_high)
