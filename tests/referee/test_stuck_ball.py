"""Lack of progress: only a ball that stays is stuck; it is dropped, and the robots are pulled apart."""

import numpy as np
import pytest

from soccer_env.types import NO_TEAM, Phase
from tests.scenes.leagues import LEGGED, each_league
from tests.scenes.staging import place, play, set_phase, stage, stand, steps_in


@each_league
def test_a_ball_that_stays_or_trembles_is_stuck_after_the_leagues_time_and_robots_far_off_stay(name):
    match = stage(name, ball=(0.4, 0.3))
    steps = 0
    while not match.events["stuck"][0]:
        match.step(stand(match))
        steps += 1
        assert steps < 2000
    assert steps == steps_in(match, match.league.rules.stuck_time)
    assert match.events["restart"][0] == Phase.DROP_BALL and match.events["restart_team"][0] == NO_TEAM
    match = stage(name, ball=(0.0, 0.0))
    rules, called = match.league.rules, 0
    for step in range(steps_in(match, rules.stuck_time) + 2):
        match.balls["x"] = 0.4 * rules.stuck_radius * np.sin(step)
        match.rebuild()
        match.step(stand(match))
        called += match.events["stuck"][0]
    assert called == 1
    match = stage(name, ball=(1.2, 0.9), robots={0: (-1.0, -0.6, 0.4)})
    match.matches["still_clock"] = match.league.rules.stuck_time
    match.step(stand(match))
    assert match.events["stuck"][0] == 1
    assert match.robots[["x", "y", "heading"]][0, 0].tolist() == (-1.0, -0.6, 0.4)


@pytest.mark.parametrize(("x", "y"), [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.6, -0.8)])
@pytest.mark.parametrize(("share", "stuck"), [(0.99, 1), (1.01, 0)])
@each_league
def test_within_the_radius_it_has_stayed_and_beyond_it_it_begins_anew(name, x, y, share, stuck):
    match = stage(name, ball=(0.4, 0.3))
    far = share * match.league.rules.stuck_radius
    match.matches["still_x"], match.matches["still_y"] = 0.4 + far * x, 0.3 + far * y
    match.matches["still_clock"] = match.league.rules.stuck_time - match.league.dt
    match.rebuild()
    match.step(stand(match))
    assert match.events["stuck"][0] == stuck and match.matches["still_clock"][0] == 0.0


@pytest.mark.parametrize("pace", [1.05, 3.0])
@each_league
def test_a_moving_ball_is_never_stuck_however_slowly_it_moves_on(name, pace):
    """A trap: lack of progress called while the ball moves; it may also be carried round in a circle."""
    match = stage(name, 2, rules="simple")
    rules, dt = match.league.rules, match.league.dt
    slowest = rules.stuck_radius / rules.stuck_time  # [m/s]
    radius = 1.2 * rules.stuck_radius
    for step in range(int(2.5 * rules.stuck_time / dt)):
        way = pace * slowest * step * dt
        match.balls["x"] = [-0.6 + way, radius * np.cos(way / radius)]
        match.balls["y"] = [0.2, radius * np.sin(way / radius)]
        match.rebuild()
        match.step(stand(match))
        assert not match.events["stuck"].any()


@each_league
def test_a_restart_that_nobody_takes_is_no_stuck_ball(name):
    match = stage(name)
    set_phase(match, Phase.KICK_OFF)
    for _ in range(steps_in(match, match.league.rules.restart_time) + 2):
        match.step(stand(match))
        assert not match.events["stuck"].any()
    assert match.matches["phase"][0] == Phase.PLAY and match.matches["still_clock"][0] < 1.0


def test_anybody_may_play_a_dropped_ball_at_once():
    match = stage(LEGGED)
    set_phase(match, Phase.DROP_BALL)
    match.matches["restart_x"], match.matches["restart_y"] = 0.0, 0.0
    place(match, ball=(0.0, 0.0, 0.5, 0.0))
    play(match, steps=4)
    assert match.matches["phase"][0] == Phase.PLAY
