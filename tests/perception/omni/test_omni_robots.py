"""The mirror camera tells robots by their markers and goals by the own side, and sees what stands behind what."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.percept_types import OTHERS
from tests.perception.omni.staged_omni import SURE, apart, look, watching
from tests.scenes.staging import MIDDLE, put

LEAGUE = find_league(MIDDLE)


# Players


def test_players_are_told_apart_by_their_markers_and_listed_nearest_first() -> None:
    match = watching(200, 2, 3, sensors=SURE)
    for r, (x, y) in {1: (2.0, 1.0), 2: (-1.0, 0.5), 3: (0.5, -3.0), 4: (-4.0, -1.0)}.items():
        put(match, r, x, y)
    for turned, heading in ((1.0, 0.0), (-1.0, 2.0)):
        match.matches["home_direction"] = turned  # the jersey is the same in both halves
        put(match, 0, 0.0, 0.0, heading)
        players = look(match)["players"]
        assert players["seen"].sum(axis=1).tolist() == [4] * 200 and players.shape[1] == OTHERS
        assert (np.diff(players["distance"][:, :4], axis=1) >= 0.0).all()
        assert players["teammate"][:, :4].tolist() == [[0, 1, 0, 0]] * 200
        expected = [np.arctan2(0.5, -1.0), np.arctan2(1.0, 2.0), np.arctan2(-3.0, 0.5), np.arctan2(-1.0, -4.0)]
        assert abs(apart(players["bearing"][:, :4], np.array(expected) - heading)).max() < 0.03


def test_a_robot_behind_a_robot_is_not_seen() -> None:
    match = watching(50, 2, 1, sensors=SURE)
    put(match, 1, 2.0, 0.0)
    put(match, 2, 4.0, 0.0)
    players = look(match)["players"]
    assert players["seen"].sum(axis=1).max() == 1 and (players["teammate"][:, 0] == 1).all()
    put(match, 2, 4.0, 1.0)
    assert look(match)["players"]["seen"].sum() == 100


def test_robots_that_are_off_neither_see_nor_are_seen() -> None:
    match = watching(20, 1, 1, sensors={**SURE, "false_balls": 1.0})
    assert look(match)["players"]["seen"].sum() == 0
    match.robots["active"][:, 0] = 0
    percepts = look(match)
    assert percepts["ball"]["seen"].sum() == percepts["own_goal"]["seen"].sum() == 0 and not percepts["lines"].any()


# Goals


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_goals_are_named_from_the_own_side(direction: float) -> None:
    match = watching(100, sensors=SURE)
    match.matches["home_direction"] = direction
    put(match, 0, 1.0, 2.0, 0.5)
    percepts = look(match)
    for name, end in (("own_goal", -6.0 * direction), ("opponent_goal", 6.0 * direction)):
        goal = percepts[name]
        assert (goal["seen"] == 1).all()
        assert goal["distance"].mean() == pytest.approx(np.hypot(end - 1.0, -2.0), rel=0.01)
        posts = [np.arctan2(y - 2.0, end - 1.0) - 0.5 for y in (-1.0, 1.0)]
        middle = posts[0] + 0.5 * apart(posts[1], posts[0])  # of what is seen
        assert abs(apart(goal["bearing"], middle)).max() < 0.02


def test_a_goal_is_seen_over_robots_unless_they_are_near() -> None:
    match = watching(200, 1, 1, sensors=SURE)
    goal = look(match)["opponent_goal"]
    assert goal["seen"].all() and abs(goal["bearing"].mean()) < 0.002
    put(match, 1, 3.0, 0.0)
    goal = look(match)["opponent_goal"]
    assert goal["seen"].all()
    put(match, 1, 0.5, 0.0)  # heads of 0.8 m at 0.5 m: the view from 0.75 m passes over a goal of 1 m at 6 m
    assert not look(match)["opponent_goal"]["seen"].any()
    put(match, 1, 0.8, 0.15)  # its left is hidden: the middle of the rest lies to the right
    goal = look(match)["opponent_goal"]
    assert (goal["bearing"][goal["seen"] == 1] < -0.03).all() and goal["seen"].any()
