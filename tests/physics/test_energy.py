"""Energy: without commands nothing ever speeds up, whatever meets whatever."""

import numpy as np

from soccer_env import Match
from soccer_env.types import Phase
from tests.scenes.leagues import boarded, each_league
from tests.scenes.staging import energy, place, play, put_ball, scatter, set_phase, speed, stage, stand, steps_in

SOLVER = 1e-9  # [J] of rounding in a step


def let_loose(name: str, matches: int, seed: int) -> Match:
    """Return matches in which ball and six robots move at random between boards, and nobody commands them."""
    match = Match(boarded(name), home=3, away=3, matches=matches, seed=seed)
    set_phase(match, Phase.PLAY)
    rng = np.random.default_rng(seed)
    scatter(match, rng, 0.7)
    drive, top = match.league.drive, match.league.ball.top_speed
    angle, v = rng.uniform(-np.pi, np.pi, matches), rng.uniform(0.3, 1.0, matches) * top
    put_ball(match, match.balls["x"], match.balls["y"], v * np.cos(angle), v * np.sin(angle))
    angle, v = (rng.uniform(low, high, match.robots.shape) for low, high in ((-np.pi, np.pi), (0.0, drive.forward)))
    match.robots["vx"], match.robots["vy"] = v * np.cos(angle), v * np.sin(angle)
    match.robots["omega"] = rng.uniform(-drive.turn, drive.turn, match.robots.shape)
    match.rebuild()
    return match


@each_league
def test_without_commands_the_kinetic_energy_of_a_match_never_grows(name):
    match = let_loose(name, 100, seed=3)
    before, began = energy(match), energy(match)
    playing = np.ones(match.count, bool)
    growth = np.zeros(match.count)
    for _ in range(steps_in(match, 4.0)):
        match.step(stand(match))
        playing &= match.events["restart"] == 0  # a goal lays the ball down
        now = energy(match)
        growth[playing] = np.maximum(growth, now - before)[playing]
        before = now
    assert growth.max() < SOLVER
    assert (before[playing] < 0.6 * began[playing]).all(), "and most of it is spent"


@each_league
def test_a_ball_that_has_come_back_from_a_board_gets_no_faster(name):
    rng = np.random.default_rng(0)
    match = stage(boarded(name), 250)
    ball, pitch = match.league.ball, match.league.pitch
    edge = pitch.width / 2 - ball.radius
    place(match, ball=(0.3, edge - rng.uniform(0.2, 0.5, 250), 0.0, rng.uniform(0.3, 1.0, 250) * ball.top_speed))
    came, fastest = np.zeros((2, 250))
    for _ in range(40):
        last = match.balls["vy"].copy()
        match.step(stand(match))
        came = np.where(came == 0.0, np.where(match.balls["vy"] < 0.0, last, 0.0), came)
        fastest = np.maximum(fastest, -match.balls["vy"])
    assert (came > 0.0).mean() > 0.8
    assert (fastest[came > 0.0] < came[came > 0.0] * match.league.materials.ball_board.elasticity).all()


@each_league
def test_matches_left_alone_come_to_rest(name):
    match = let_loose(name, 20, seed=4)
    play(match, 40.0)
    assert not speed(match.balls).any()
    assert speed(match.robots).max() < 1e-6 and abs(match.robots["omega"]).max() < 1e-5
