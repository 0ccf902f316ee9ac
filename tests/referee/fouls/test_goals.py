"""Goals that do not count: of an attack that was whistled, by a push or a hold, straight from the kick-off."""

import numpy as np
import pytest

from soccer_env.types import Phase
from tests.scenes.fouls import POCKET, court, fouls
from tests.scenes.staging import place, put, put_ball, stand

RULES = "keeper_pushing=True,holding=True,kick_off_shot=True"
STEP = 1.0 / 16.0


def rolling_in(rules=RULES, side=1.0, y=0.1):
    """Return a match in which the ball rolls over the goal line in a step or two; robot 1 stands aside."""
    match = court(rules)
    place(match, ball=(side * (1.5 + 0.03), y, side * 0.3), robots={1: (0.5, 0.5)})
    return match


def after_goal(match):
    """Play on until the ball is in; return score and whether the goal was annulled."""
    for _ in range(8):
        match.step(stand(match))
        if match.events["restart"][0]:
            return match.matches["score"][0].tolist(), int(match.events["annulled"][0])
    raise AssertionError("no goal")


def test_an_honest_goal_counts():
    assert after_goal(rolling_in()) == ([1, 0], 0)


@pytest.mark.parametrize(("pushed", "score"), [(0.5, [1, 0]), (0.5 + STEP, [0, 0])])  # a step before the goal
def test_a_goal_while_the_scorers_push_the_goalkeeper_does_not_count_after_half_a_second(pushed, score):
    match = rolling_in()
    match.robots["keeper_pushing"][0, 1] = pushed
    assert after_goal(match)[0] == score
    match = rolling_in("keeper_pushing=False")
    match.robots["keeper_pushing"][0, 1] = pushed
    assert after_goal(match) == ([1, 0], 0)


def test_a_push_by_those_who_concede_does_not_matter():
    match = rolling_in(side=-1.0)
    match.robots["keeper_pushing"][0, 1] = 0.9
    assert after_goal(match) == ([0, 1], 0)


@pytest.mark.parametrize(("ago", "annulled"), [(3.0 - 2 * STEP, 1), (3.0 - STEP, 0)])  # a step before the goal
def test_a_whistled_attack_cannot_score_for_three_seconds(ago, annulled):
    match = rolling_in()
    match.matches["whistled"], match.matches["whistled_clock"] = 0, ago
    assert after_goal(match)[1] == annulled
    match = rolling_in(side=-1.0)
    match.matches["whistled"], match.matches["whistled_clock"] = 0, ago
    assert after_goal(match)[1] == 0  # the others may score


@pytest.mark.parametrize(("y", "dropped"), [(0.1, 0.5), (-0.1, -0.5)])
def test_the_ball_of_an_annulled_goal_is_dropped_on_the_halfway_line_on_its_side(y, dropped):
    match = rolling_in(y=y)
    match.matches["whistled"] = 0
    assert after_goal(match) == ([0, 0], 1)
    assert match.matches["phase"][0] == Phase.DROP_BALL and match.matches["restart_team"][0] == -1
    assert (match.balls["x"][0], match.balls["y"][0]) == (0.0, dropped)


def test_nobody_scores_while_holding_the_ball():
    match = court(RULES)
    put(match, 1, 1.5 + 0.03 - POCKET, 0.0, 0.0, forward=0.12)
    put_ball(match, 1.5 + 0.03, 0.0, 0.12)
    match.robots["holding"][0, 1] = 1.0
    match.robots["has_ball"][0, 1] = 1
    match.rebuild()
    actions = stand(match)
    actions[:, 1, 0] = 1.0
    for _ in range(5):
        match.step(actions)
        if match.events["restart"][0]:
            break
    assert match.events["annulled"][0] == 1


def test_who_held_the_ball_and_has_let_go_annuls_no_goal():
    match = rolling_in()
    match.robots["holding"][0, 1] = 1.0
    assert after_goal(match) == ([1, 0], 0)


def test_a_kick_off_shot_gives_the_defenders_a_kick_off():
    match = rolling_in()
    match.matches["kick_off_shot"] = 0
    assert after_goal(match) == ([0, 0], 1)
    assert match.matches["phase"][0] == Phase.KICK_OFF and match.matches["restart_team"][0] == 1
    match = rolling_in(side=-1.0)
    match.matches["kick_off_shot"] = 0
    assert after_goal(match) == ([0, 1], 0)
    match = rolling_in("kick_off_shot=False")
    match.matches["kick_off_shot"] = 0
    assert after_goal(match) == ([1, 0], 0)


@pytest.mark.parametrize(("beyond", "owner"), [(0.01, -1), (-0.01, 0)])
@pytest.mark.parametrize("way", [0.0, 0.5 * np.pi])
def test_the_kicking_team_has_to_touch_the_ball_when_all_of_it_has_left_the_circle(way, beyond, owner):
    match = court("kick_off_shot=True")
    match.matches["kick_off_shot"] = 0
    away = match.league.pitch.circle + match.league.ball.radius + beyond
    x, y = np.cos(way), np.sin(way)
    place(match, ball=(away * x, away * y), robots={4: ((away + POCKET) * x, (away + POCKET) * y, way + np.pi)})
    match.step(stand(match))
    assert match.robot_events["touch"][0, 4] == 1 and match.matches["kick_off_shot"][0] == 0  # an opponent: no matter
    place(match, robots={1: ((away - POCKET) * x, (away - POCKET) * y, way)})
    match.step(stand(match))
    assert match.robot_events["touch"][0, 1] == 1 and match.matches["kick_off_shot"][0] == owner


def test_each_kick_off_begins_anew_and_a_scene_in_play_has_none():
    match = court("kick_off_shot=True")
    match.matches["phase"], match.matches["restart_team"] = Phase.KICK_OFF, 1
    match.step(stand(match))
    assert match.matches["kick_off_shot"][0] == 1
    match = court("kick_off_shot=True")
    assert fouls(match, stand(match), 0.2) == [] and match.matches["kick_off_shot"][0] == -1
