"""Goals that do not count; matches under all rules of the legged league play alike mirrored and on both backends."""

import numpy as np
import pytest

from soccer_env.types import Phase
from tests.scenes.fouls import POCKET, court, fouls
from tests.scenes.staging import place, put, put_ball, stand
from tests.scenes.symmetry import HALF_TURN, Records, assert_same_records, mirrored, turned

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


def test_an_honest_goal_counts_whoever_has_pushed_among_those_who_concede_or_has_held_the_ball_and_let_go():
    assert after_goal(rolling_in()) == ([1, 0], 0)
    for field, side, score in (("keeper_pushing", -1.0, [0, 1]), ("holding", 1.0, [1, 0])):
        match = rolling_in(side=side)
        match.robots[field][0, 1] = 0.9
        assert after_goal(match) == (score, 0)


@pytest.mark.parametrize(("pushed", "score"), [(0.5, [1, 0]), (0.5 + STEP, [0, 0])])  # a step before the goal
def test_a_goal_while_the_scorers_push_the_goalkeeper_does_not_count_after_half_a_second(pushed, score):
    match = rolling_in()
    match.robots["keeper_pushing"][0, 1] = pushed
    assert after_goal(match)[0] == score
    match = rolling_in("keeper_pushing=False")
    match.robots["keeper_pushing"][0, 1] = pushed
    assert after_goal(match) == ([1, 0], 0)


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


def test_a_kick_off_shot_gives_the_defenders_a_kick_off_and_each_kick_off_begins_anew():
    def shot(*where, **settings):
        match = rolling_in(*where, **settings)
        match.matches["kick_off_shot"] = 0
        return match

    match = shot()
    assert after_goal(match) == ([0, 0], 1)
    assert match.matches["phase"][0] == Phase.KICK_OFF and match.matches["restart_team"][0] == 1
    assert after_goal(shot(side=-1.0)) == ([0, 1], 0) and after_goal(shot("kick_off_shot=False")) == ([1, 0], 0)
    match = court("kick_off_shot=True")
    match.matches["phase"], match.matches["restart_team"] = Phase.KICK_OFF, 1
    match.step(stand(match))
    assert match.matches["kick_off_shot"][0] == 1
    match = court("kick_off_shot=True")
    assert fouls(match, stand(match), 0.2) == [] and match.matches["kick_off_shot"][0] == -1


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


def whistled():
    """Return a match with a robot that is about to be whistled, one that comes back and a goal that does not count."""
    match = court("illegal_defender=True,keeper_pushing=True,kick_off_shot=True,local_stuck=True")
    put(match, 1, -1.2, 0.3, 0.2)
    put(match, 4, 0.4, -0.6, 2.0)
    put_ball(match, 1.48, 0.2, 0.5)
    match.robots["penalty"][0, 5] = 0.5
    match.matches["whistled"] = 0
    match.rebuild()
    return match


def on_pitch(records):
    """Return records without the poses of those who are out: the bench is in no frame."""
    for name in ("x", "y", "heading", "pan", "tilt", "place_x", "place_y", "place_heading"):
        records.robots[name][records.robots["active"] == 0] = 0.0
    return records


@pytest.mark.parametrize("change", [mirrored, turned])
def test_mirrored_and_turned_matches_are_judged_alike(change):
    match, other = whistled(), whistled()
    change(Records.of(match)).put_into(other)
    fouls = 0
    for _ in range(24):
        match.step(stand(match))
        other.step(stand(other))
        fouls += int((match.robot_events["foul"] > 0).sum())
        assert_same_records(on_pitch(change(Records.of(match))), on_pitch(Records.of(other)), HALF_TURN)
    assert fouls == 1 and match.matches["score"].sum() == 0 and match.robots["active"][0].tolist() == [0, 0, 0, 0, 1, 1]
