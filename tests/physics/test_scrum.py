"""Crowds: six robots push one ball, and teams of every size do anything at all."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.types import MAX_TEAM, Phase
from tests.scenes.leagues import LEAGUES, LEGGED, MIDDLE, each_league, patient
from tests.scenes.staging import deepest_overlaps, scatter, set_phase, speed, stand, steps_in


def chase(match: Match) -> np.ndarray:
    """Return actions with which every robot runs at the ball."""
    robots, ball = match.robots, match.balls
    bearing = np.arctan2(ball["y"][:, None] - robots["y"], ball["x"][:, None] - robots["x"]) - robots["heading"]
    bearing = (bearing + np.pi) % (2.0 * np.pi) - np.pi
    actions = stand(match)
    actions[..., 0], actions[..., 2] = np.cos(bearing), np.clip(2.0 * bearing, -1.0, 1.0)
    return actions


def is_finite(records: np.ndarray) -> bool:
    return all(np.isfinite(records[name]).all() for name in records.dtype.names if records[name].dtype.kind == "f")


@each_league
def test_six_robots_that_push_a_ball_for_a_minute_never_push_it_out_or_into_each_other(name):
    """A ball squeezed between robots of thirty times its mass still goes into them, up to its radius as measured.

    More substeps and iterations halve that; the bound here is what keeps it from coming out on the other side.
    """
    match = Match(patient(name), home=3, away=3, matches=4, seed=2)
    set_phase(match, Phase.PLAY)
    scatter(match, np.random.default_rng(2), 0.9)
    match.rebuild()
    ball, pitch, body = match.league.ball, match.league.pitch, match.league.body
    worst: dict[str, float] = {}
    touches = 0
    for step in range(steps_in(match, 60.0)):
        match.step(chase(match))
        touches += match.robot_events["touch"].sum()
        assert is_finite(match.balls) and is_finite(match.robots)
        assert speed(match.balls).max() <= ball.top_speed + 1e-9
        inside = (abs(match.balls["x"]) < pitch.length / 2 + pitch.goal_depth) & (
            abs(match.balls["y"]) < pitch.width / 2 + pitch.band_side
        )
        assert inside.all()
        if step % steps_in(match, 1.0) == 0:
            found = deepest_overlaps(match)
            worst = {pair: max(depth, worst.get(pair, 0.0)) for pair, depth in found.items()}
    assert touches > 500
    assert max(worst["ball robot"], worst["ball wall"]) < 1.25 * ball.radius
    assert worst["robot robot"] < 0.25 * body.reach and worst["robot wall"] < 0.1 * body.reach


@each_league
def test_robots_that_run_at_full_speed_into_the_boards_stay_inside_them(name):
    match = Match(patient(name), home=3, away=3, matches=20, seed=3)
    rng = np.random.default_rng(3)
    scatter(match, rng)
    match.rebuild()
    pitch = match.league.pitch
    for _ in range(steps_in(match, 20.0 if name == LEGGED else 5.0)):
        actions = stand(match)
        actions[..., 0] = 1.0
        match.step(actions)
        goal = abs(match.robots["y"]) < pitch.goal_width / 2
        edge = pitch.length / 2 + np.where(goal, max(pitch.goal_depth, pitch.band_end), pitch.band_end)
        assert (abs(match.robots["x"]) < edge).all()
        assert (abs(match.robots["y"]) < pitch.width / 2 + pitch.band_side).all()
    assert deepest_overlaps(match)["robot wall"] < 0.1 * match.league.body.reach


@pytest.mark.parametrize("name", LEAGUES)
@pytest.mark.parametrize("home", range(1, MAX_TEAM + 1))
def test_teams_of_every_size_play_500_random_steps_in_one_piece(name, home):
    away = MAX_TEAM + 1 - home if home % 2 else home
    match = Match(name, home=home, away=away, matches=2, seed=home, senses="ideal", rules="simple")
    rng = np.random.default_rng(home)
    pitch, reach = match.league.pitch, match.league.body.reach
    for step in range(500):
        if step % 10 == 0:
            actions = rng.uniform(-1.0, 1.0, (2, home + away, 4))
        match.step(actions)
    for records in (match.matches, match.balls, match.robots, match.beliefs["ball"]):
        assert is_finite(records[[name for name in records.dtype.names if name != "half_length"]])
    assert np.isfinite(match.observations).all() and np.isfinite(match.rewards).all()
    assert (abs(match.robots["x"]) < pitch.length / 2 + max(pitch.band_end, pitch.goal_depth)).all()
    assert (abs(match.robots["y"]) < pitch.width / 2 + pitch.band_side).all()
    found = deepest_overlaps(match)
    assert found["robot robot"] < 0.25 * reach and found["robot wall"] < 0.1 * reach
    assert found["ball robot"] < 1.25 * match.league.ball.radius


@pytest.mark.parametrize("name", LEAGUES)
def test_padding_touches_nobody_and_nobody_touches_it(name):
    match = Match(name, home=1, away=2, max_players=5, matches=4, seed=1)
    rng = np.random.default_rng(1)
    absent = match.robots["active"][0] == 0
    assert absent.sum() == 7
    parked = match.robots[:, absent].copy()
    for _ in range(300):
        match.step(rng.uniform(-1.0, 1.0, (4, 10, 4)))
        for event in match.robot_events.dtype.names:
            assert not match.robot_events[event][:, absent].any()
    for axis in ("x", "y", "heading", "vx", "vy", "omega"):
        np.testing.assert_array_equal(match.robots[axis][:, absent], parked[axis])
    away_from_field = np.hypot(parked["x"], parked["y"])
    assert (away_from_field > 4.0 * match.league.pitch.length).all() or name == MIDDLE
    assert (away_from_field > 40.0).all()
