"""A dropped ball falls near where it stuck, and moves nobody farther than it must: property tests with crowds."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.types import MAX_TEAM, Phase
from tests.scenes.leagues import LEGGED, MIDDLE, each_league
from tests.scenes.staging import deepest_overlaps, distance, scatter, set_phase, stage, stand


def dropped(match):
    """Let the ball be stuck in all matches; return where the robots stood before."""
    set_phase(match, Phase.PLAY)
    match.matches["still_x"], match.matches["still_y"] = match.balls["x"], match.balls["y"]
    match.matches["still_clock"] = match.league.rules.stuck_time
    match.rebuild()
    before = match.robots.copy()
    match.step(stand(match))
    assert (match.events["restart"] == Phase.DROP_BALL).all()
    return before


def carried(match, before):
    """Return how far (M, R) the robots were moved [m]; of 1 cm the physics of the step is guilty."""
    return distance(match.robots, before["x"], before["y"])


def dropped_at(name, x, y):
    """Return where balls that stuck at x, y are dropped, nobody near."""
    match = stage(name, len(x), ball=(x, y))
    dropped(match)
    return match.balls["x"], match.balls["y"]


@each_league
def test_in_the_open_the_ball_is_dropped_where_it_stuck(name):
    half = find_league(name).pitch.length / 2
    x, y = np.array([0.0, 0.2, -0.5]) * half, np.array([0.0, -0.1, 0.3])
    for found, asked in zip(dropped_at(name, x, y), (x, y), strict=True):
        np.testing.assert_allclose(found, asked, atol=1e-9)


def test_from_a_board_it_is_taken_straight_to_050_m_off_it_and_from_a_corner_off_both():
    x, y = np.array([0.4, 0.4, 0.4, 1.36, -1.36]), np.array([0.86, -0.60, 0.49, 0.86, -0.86])
    found_x, found_y = dropped_at(LEGGED, x, y)
    np.testing.assert_allclose(found_x, [0.4, 0.4, 0.4, 1.0, -1.0], atol=1e-9)
    np.testing.assert_allclose(found_y, [0.5, -0.5, 0.49, 0.5, -0.5], atol=1e-9)


@each_league
def test_a_dropped_ball_is_in_play_at_once_and_the_robots_know_it(name):
    match = stage(name, ball=(0.3, 0.2), robots={0: (-0.8, 0.0)})
    dropped(match)
    assert match.matches["phase"][0] == Phase.DROP_BALL
    match.step(stand(match))
    assert match.matches["phase"][0] == Phase.PLAY and match.events["in_play"][0] == 1


@pytest.mark.parametrize(
    ("name", "depth", "half_width"), [(LEGGED, 0.5, 0.5), (MIDDLE, 0.5, 1.5)], ids=["legged", "middle size"]
)
def test_before_a_goal_it_is_dropped_on_the_line_of_the_area_where_it_was(name, depth, half_width):
    """The penalty area of the legged league, which has no other; the goal area of the middle size."""
    half = find_league(name).pitch.length / 2
    x = np.array([1.0, 1.0, -1.0, 1.0]) * (half - np.array([0.06, depth - 0.01, 0.2, depth + 0.01]))
    y = np.array([half_width - 0.01, -0.1, 0.2, 0.1])
    found_x, found_y = dropped_at(name, x, y)
    line = half - depth
    np.testing.assert_allclose(found_x, [line, line, -line, half - depth - 0.01], atol=1e-9)
    np.testing.assert_allclose(found_y, y, atol=1e-9)
    assert (abs(found_x) <= abs(x) + 1e-9).all()


def test_beside_the_area_it_stays_beside_it_and_without_the_rule_no_ball_is_dropped():
    x, y = dropped_at(LEGGED, np.array([0.99, -0.95]), np.array([0.51, 0.86]))
    assert (x, y) == (pytest.approx([0.99, -0.95], abs=1e-9), pytest.approx([0.5, 0.5], abs=1e-9))
    match = stage(find_league(LEGGED), rules="league:dropped_ball=False", ball=(0.4, 0.3))
    match.matches["still_clock"] = match.league.rules.stuck_time
    match.step(stand(match))
    assert match.events["restart"][0] == 0


@pytest.mark.parametrize("handedness", [1.0, -1.0])
def test_a_goalkeeper_stays_in_its_area_and_a_robot_just_within_the_ring_is_moved_out_by_a_hair(handedness):
    """A trap: robots were moved round the ring one way only, a keeper from its goal to midfield."""
    match = stage(LEGGED, 1, home=2, away=2, ball=(0.95, 0.1), robots={2: (1.30, 0.20, np.pi), 3: (0.5, -0.30, np.pi)})
    match.matches["handedness"] = handedness
    ring = match.league.rules.separation + match.league.body.reach
    assert match.robots["keeper"][0, 2] == 1
    assert all(0.3 < distance(match.robots, 0.95, 0.1)[0, r] < ring for r in (2, 3))
    way = carried(match, dropped(match))
    assert way[0, 2] == 0.0 and 0.0 < way[0, 3] < 0.1


def test_a_goalkeeper_out_of_its_area_keeps_the_ring_and_a_robot_outside_it_is_not_moved_however_near_others_stand():
    match = stage(LEGGED, 1, home=2, away=2, ball=(0.5, 0.2), robots={2: (0.7, 0.2, np.pi)})
    dropped(match)
    assert distance(match.robots, 0.5, 0.2)[0, 2] >= match.league.rules.separation + match.league.body.reach - 1e-6
    match = stage(LEGGED, 1, home=2, away=2, ball=(0.5, 0.0), robots={0: (-0.5, 0.0), 3: (-0.5, 0.17, np.pi)})
    assert not carried(match, dropped(match)).any()


@pytest.mark.slow
@pytest.mark.parametrize("place", ["anywhere", "board", "corner", "goal"])
@each_league
def test_nobody_is_carried_farther_than_the_ring_and_030_m_but_one_in_a_hundred_that_a_corner_holds(name, place):
    """Between a ball 0.5 m off the boards of the legged league and their ramps there is no place outside the ring."""
    match = stage(name, 100, home=5, away=5)
    crowd(match, place, np.random.default_rng(5), spread=2.5)
    before = dropped(match)
    way, rules = carried(match, before), match.league.rules
    far = way > rules.separation + 0.3
    assert far.sum() <= (0.01 * (way > 0.05).sum() if match.league.pitch.walled else 0)
    assert way.max() <= rules.separation + 0.5
    assert_apart(match)


@pytest.mark.slow
@pytest.mark.parametrize("size", [3, MAX_TEAM])
@pytest.mark.parametrize("place", ["anywhere", "board", "corner", "goal"])
@each_league
def test_after_a_drop_nobody_stands_in_anybody_nor_in_the_ring(name, place, size):
    match = stage(name, 12, home=size, away=size)
    crowd(match, place, np.random.default_rng(10 + size), spread=1.0)
    dropped(match)
    assert_apart(match)
    robots, rules, pitch = match.robots, match.league.rules, match.league.pitch
    far = distance(robots, match.balls["x"][:, None], match.balls["y"][:, None])
    attack = np.where(robots["team"] == 0, 1.0, -1.0)
    deep = attack * robots["x"] < -pitch.length / 2 + pitch.penalty_depth
    at_home = deep & (abs(robots["y"]) < pitch.penalty_width / 2) & (robots["keeper"] == 1)
    assert (far >= rules.separation)[~at_home].all()


def crowd(match, place, rng, spread, pairs=False):
    """Put the ball somewhere and all robots about it at random, as densely as `spread` says (1: no denser), apart.

    With `pairs` every robot of away stands at one of home, if there is room.
    """
    if place == "anywhere":
        scatter(match, rng, 0.95)
        match.robots["active"] = 1
        return
    league = match.league
    spot = np.array({"board": [0.5, 0.96], "corner": [0.96, 0.96], "goal": [0.85, 0.0]}[place])
    half = np.array([league.pitch.length, league.pitch.width]) / 2
    inward = league.pitch.ramp + league.ball.radius if place != "goal" else 0.0  # no ball lies on a ramp
    for m in range(match.count):
        where = np.minimum(spot * half, half - inward) * rng.choice([-1.0, 1.0], 2)
        match.balls["x"][m], match.balls["y"][m] = where
        gather(match, m, where, rng, spread * league.body.reach * np.sqrt(6.0 * match.robots.shape[1]), pairs)


def gather(match, m, spot, rng, radius, pairs):
    """Put the robots of match m about a spot, one after the other where nobody stands."""
    league = match.league
    half, apart = match.robots.shape[1] // 2, 2.0 * league.body.reach
    edge = np.array([league.pitch.length, league.pitch.width]) / 2 - league.body.reach - league.foot
    places: list[np.ndarray] = []
    for r in range(match.robots.shape[1]):
        for tries in range(20_000):
            away = rng.uniform(-1.0, 1.0, 2) * radius * (1.0 + tries / 1000.0)
            place = np.clip(spot + away, -edge, edge)
            if pairs and r >= half and tries < 200:
                place = np.clip(places[r - half] + 1.01 * apart * away / np.hypot(*away), -edge, edge)
            if all(np.hypot(*(place - other)) > apart for other in places):
                break
        places.append(place)
        robot = match.robots[m, r : r + 1]
        robot["x"], robot["y"] = place
        robot["heading"], robot["active"] = rng.uniform(-np.pi, np.pi), 1


def assert_apart(match):
    """Check that nobody stands in anybody, in a board or off the pitch."""
    found = deepest_overlaps(match)
    assert max(found["robot robot"], found["robot wall"], found["ball robot"]) < 0.001
    pitch = match.league.pitch
    assert (abs(match.robots["x"]) < pitch.length / 2).all() and (abs(match.robots["y"]) < pitch.width / 2).all()
