"""Restarts: who stands where, when play goes on, and that every placement is legal for teams of every size."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.match.staging import constants_of
from soccer_env.physics.contacts import robots_touch
from soccer_env.referee.restarts import STEP_ASIDE, make_room
from soccer_env.types import AWAY, HOME, MAX_TEAM, NO_TEAM, Phase
from tests.scenes.leagues import LEAGUES, LEGGED, MIDDLE, each_league
from tests.scenes.looking import deepest_overlaps, distance, speed
from tests.scenes.staging import place, play, robot_actions, scatter, set_phase, stand, steps_in

KINDS = {
    LEGGED: (Phase.KICK_OFF,),
    MIDDLE: (Phase.KICK_OFF, Phase.THROW_IN, Phase.GOAL_KICK, Phase.CORNER_KICK),
}
KIND_CASES = [(name, phase) for name in LEAGUES for phase in KINDS[name]]
SIZES = (1, 3, 5, MAX_TEAM)
TAKERS = np.repeat([HOME, AWAY], 4)  # of the eight matches of a case
DIRECTIONS = np.tile([1.0, 1.0, -1.0, -1.0], 2)
SIDES = np.tile([1.0, -1.0], 4)


def called(name, phase, home, away, placement="instant", seed=0) -> Match:
    """Return 8 matches in which the referee has just called a restart: both teams, both halves, both sides.

    Everybody stood somewhere at random before.
    """
    match = Match(name, home=home, away=away, matches=8, seed=seed, placement=placement)
    set_phase(match, Phase.PLAY)
    match.matches["home_direction"], match.matches["half"] = DIRECTIONS, DIRECTIONS < 0.0
    scatter(match, np.random.default_rng(seed), 0.95)
    pitch, r = match.league.pitch, match.league.ball.radius + 0.01
    attack = DIRECTIONS * np.where(TAKERS == HOME, 1.0, -1.0)  # the end that the takers attack
    beyond, aside = pitch.length / 2 + r, SIDES * 0.35 * pitch.width
    x, y, last = {
        Phase.KICK_OFF: (-attack * beyond, 0.0, TAKERS),
        Phase.THROW_IN: (np.linspace(-0.5, 0.5, 8) * pitch.length, SIDES * (pitch.width / 2 + r), 1 - TAKERS),
        Phase.GOAL_KICK: (-attack * beyond, aside, 1 - TAKERS),
        Phase.CORNER_KICK: (attack * beyond, aside, 1 - TAKERS),
    }[phase]
    match.matches["last_touch_team"] = last
    place(match, ball=(x, y))
    match.step(stand(match))
    assert (match.events["restart"] == phase).all() and (match.events["restart_team"] == TAKERS).all()
    return match


def drive_to_places(match, rng=None):
    """Step until the placing is over everywhere; return its control steps, and the matches at the moment of its end."""
    steps = np.zeros(match.count, int)
    balls, robots = match.balls.copy(), match.robots.copy()
    where = match.balls[["x", "y"]].copy()
    placing = match.matches["placing"] == 1
    assert placing.all()
    while placing.any():
        clock = match.matches["clock"].copy()
        actions = stand(match) if rng is None else rng.uniform(-1.0, 1.0, stand(match).shape)
        match.step(np.where(placing[:, None, None], actions, 0.0))
        assert (match.balls[["x", "y"]][placing] == where[placing]).all(), "the ball moved"
        assert not speed(match.balls)[placing].any()
        np.testing.assert_allclose(match.matches["clock"] - clock, match.league.dt)
        ended = placing & (match.matches["placing"] == 0)
        balls[ended], robots[ended] = match.balls[ended], match.robots[ended]
        steps[placing] += 1
        placing &= match.matches["placing"] == 1
    match.balls[:], match.robots[:] = balls, robots
    return steps


def assert_legal(match, phase):
    """Check the places of all robots against the rules of a restart."""
    league, robots = match.league, match.robots
    rules, reach = league.rules, league.body.reach
    far = distance(robots, match.balls["x"][:, None], match.balls["y"][:, None])
    opponents = (robots["team"] != TAKERS[:, None]) & (robots["keeper"] == 0)
    required = rules.kick_off_distance if phase == Phase.KICK_OFF else rules.restart_distance
    assert (far[opponents] >= required).all()
    if phase == Phase.KICK_OFF:
        attack = DIRECTIONS[:, None] * np.where(robots["team"] == HOME, 1.0, -1.0)
        assert (attack * robots["x"] < 0.0).all(), "a robot is not in its own half"
    found = deepest_overlaps(match)
    assert max(found["robot robot"], found["robot wall"], found["ball robot"]) < 0.001
    assert not speed(robots).any() and not robots["omega"].any() and not robots["walk"]["forward"].any()
    beside = max(league.pitch.band_side, 0.0)
    assert (abs(robots["x"]) <= league.pitch.length / 2 + max(league.pitch.band_end, 0.0)).all()
    assert (abs(robots["y"]) <= league.pitch.width / 2 + beside).all()
    takers = (robots["team"] == TAKERS[:, None]) & (far < reach + league.ball.radius + 0.15)
    fielders = ((robots["team"] == TAKERS[:, None]) & (robots["keeper"] == 0)).any(axis=1)
    assert (takers.sum(axis=1) >= fielders).all(), "nobody stands ready to take it"


@pytest.mark.slow
@pytest.mark.parametrize(("home", "away"), [*((size, size) for size in SIZES), (MAX_TEAM, 2), (4, 9)])
@pytest.mark.parametrize(("name", "phase"), KIND_CASES)
def test_instant_placement_is_legal_for_teams_of_every_size_and_unequal_ones(name, phase, home, away):
    match = called(name, phase, home, away, seed=home)
    assert (match.matches["placing"] == 0).all()
    assert_legal(match, phase)


@pytest.mark.slow
@pytest.mark.parametrize("size", [1, 5, MAX_TEAM])
@pytest.mark.parametrize(("name", "phase"), KIND_CASES)
def test_robots_drive_to_their_places_for_10_s_at_most_and_then_stand_legally(name, phase, size):
    match = called(name, phase, size, size, "drive", seed=size)
    steps = drive_to_places(match, np.random.default_rng(size))
    assert (steps * match.league.dt <= match.league.rules.placing_time + 1e-9).all()
    assert_legal(match, phase)


def test_at_a_middle_size_kick_off_opponents_keep_2_m_and_stay_in_their_half():
    match = Match(MIDDLE, home=5, away=5, matches=20, seed=5)
    far, takers = distance(match.robots, 0.0, 0.0), match.matches["kick_off_team"] == AWAY
    far[takers] = np.roll(far[takers], 5, axis=1)
    assert 0 < takers.sum() < 20
    assert (far[:, 5:] >= 2.0).all() and (match.robots["x"][:, 5:] > 0.0).all()
    assert (match.robots["x"][:, :5] < 0.0).all() and (far[:, :5].min(axis=1) < 0.5).all()


@each_league
def test_the_taker_faces_the_ball_with_the_opponents_goal_ahead_and_goalkeepers_stand_in_front_of_their_goals(name):
    match = Match(name, home=3, away=3, matches=20, seed=6)
    taker = match.robots[np.arange(20), distance(match.robots, 0.0, 0.0).argmin(axis=1)]
    assert (taker["team"] == match.matches["kick_off_team"]).all() and (taker["keeper"] == 0).all()
    ahead = np.where(taker["team"] == HOME, 1.0, -1.0)
    assert (ahead * np.cos(taker["heading"]) > 0.995).all()
    assert (ahead * taker["x"] < 0.0).all() and (abs(taker["y"]) < 0.03).all()
    keepers, pitch = match.robots[:, [0, 3]], match.league.pitch
    assert (keepers["keeper"] == 1).all() and (abs(keepers["y"]) < pitch.goal_width / 2).all()
    assert (abs(keepers["x"] - [-pitch.length / 2, pitch.length / 2]) < 0.1 * pitch.length).all()


@each_league
def test_play_goes_on_once_the_ball_has_moved_by_a_kick_off_or_after_ten_seconds(name):
    match = Match(name, home=1, away=1, matches=2, seed=1)
    far, first = match.league.rules.in_play_distance, match.matches["kick_off_team"][0]
    match.balls["x"] = [far - 0.001, far + 0.001]
    match.robots["x"] += np.array([-0.3, 0.3])
    match.rebuild()
    match.step(stand(match))
    assert match.matches["phase"].tolist() == [Phase.KICK_OFF, Phase.PLAY]
    assert match.events["in_play"].tolist() == [0, 1] and match.matches["restart_team"].tolist() == [first, NO_TEAM]
    match = Match(name, home=2, away=2, seed=1)
    play(match, steps=steps_in(match, 10.0) - 1)
    assert match.matches["phase"][0] == Phase.KICK_OFF and find_league(name).rules.restart_time == 10.0
    match.step(stand(match))
    assert match.matches["phase"][0] == Phase.PLAY
    match = Match(name, home=1, away=1, seed=1)
    taker = match.matches["kick_off_team"][0]
    for _ in range(steps_in(match, 9.0)):
        match.step(robot_actions(match, taker, forward=0.5))
        if match.matches["phase"][0] == Phase.PLAY:
            break
    assert match.matches["phase"][0] == Phase.PLAY and match.matches["last_touch_team"][0] == taker


@each_league
def test_sent_off_robots_are_not_placed_and_a_restart_forgets_who_touched_the_ball(name):
    match = Match(name, home=2, away=2, max_players=4, matches=3, seed=2)
    absent = match.robots["active"][0] == 0
    before = match.robots[:, absent].copy()
    set_phase(match, Phase.PLAY)
    match.matches["last_touch_team"], match.matches["last_touch_robot"] = HOME, 0
    place(match, ball=(match.league.pitch.length / 2 + match.league.ball.radius + 0.01, 0.0))
    match.step(stand(match))
    assert (match.events["restart"] == Phase.KICK_OFF).all()
    for axis in ("x", "y", "heading"):
        np.testing.assert_array_equal(match.robots[axis][:, absent], before[axis])
    assert (match.matches["last_touch_team"] == NO_TEAM).all() and (match.matches["last_touch_robot"] == -1).all()


@each_league
def test_who_makes_room_for_a_carried_robot_goes_straight_away_from_the_ball_and_no_farther_than_it_must(name):
    match = Match(name, home=1, away=1, seed=1)
    robots, k, reach = match.robots[0], constants_of(match)[0], match.league.body.reach
    robots["x"], robots["y"], robots["heading"] = [0.5, 0.5 + 0.3 * reach], [0.4, 0.4 + 0.2 * reach], 0.3
    old = np.array([robots["x"][1], robots["y"][1]])
    robots["placed"] = 0
    make_room(robots.view(np.recarray), 0, match.balls[0], k)
    new = np.array([robots["x"][1], robots["y"][1]])
    assert robots["placed"].tolist() == [0, 1]
    assert new / np.hypot(*new) == pytest.approx(old / np.hypot(*old), abs=1e-9)
    assert not robots_touch(robots[0], robots[1], k)
    robots["x"][1], robots["y"][1] = new - 1.01 * STEP_ASIDE * new / np.hypot(*new)
    assert robots_touch(robots[0], robots[1], k)
