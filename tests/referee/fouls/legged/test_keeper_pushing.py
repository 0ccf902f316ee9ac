"""Goalkeeper pushing: more than 1 s of walking into a goalkeeper in its own area."""

from math import pi

import pytest

from soccer_env.types import Foul
from tests.scenes.fouls import BODY, FOOT_IN, NOSES, OTHER_KEEPER, POCKET, asks, court, fouls, rows
from tests.scenes.staging import put, put_ball, stand

RULE = "keeper_pushing=True"
NEAR = 0.93  # [m] of an attacker whose paws touch a goalkeeper in its area


def charge(rules=RULE, x=NEAR):
    """Return a match in which robot 1 stands right before the away team's goalkeeper."""
    match = court(rules)
    put(match, 1, x, 0.0, 0.0)
    put(match, OTHER_KEEPER, x + NOSES, 0.0, pi)
    match.rebuild()
    return match


def pushed_steps(match, actions):
    """Return in how many steps robot 1 pushed the goalkeeper before it was whistled."""
    count = 0
    for _ in range(80):
        match.step(actions)
        count += int(match.robot_events["pushes"][0, 1] == 2)
        if match.robot_events["foul"][0, 1]:
            return count
    return None


def test_one_second_is_legal_and_one_step_more_is_not_even_for_the_robot_nearest_to_the_ball():
    match = charge()
    put_ball(match, 1.1, 0.3)
    match.rebuild()
    assert pushed_steps(match, asks(match, r1=1.0)) == 16 + 1
    assert match.robot_events["foul"][0, 1] == Foul.KEEPER_PUSHING and match.robots["penalty"][0, 1] == 30.0
    assert match.matches["whistled"][0] == 0


def test_with_the_switch_off_nobody_is_whistled():
    match = charge("pushing=True")
    assert fouls(match, asks(match, r1=1.0), 2.5) == []


@pytest.mark.parametrize(("inside", "guilty"), [(0.002, [1]), (-0.02, [])])
def test_a_foot_of_the_goalkeeper_on_its_line_is_enough(inside, guilty):
    match = charge(x=FOOT_IN + BODY.hind_x + inside - NOSES)  # it faces the pitch: its hind feet are in
    match.robots["keeper_pushing"][0, 1] = 0.9
    assert rows(fouls(match, asks(match, r1=0.5), 2.5)) == guilty


def test_a_standing_attacker_is_never_guilty_whoever_walks_into_it():
    match = charge()
    assert fouls(match, asks(match, r3=1.0), 4.0) == []


def test_a_second_attacker_that_joins_is_removed_immediately_and_the_first_after_its_second():
    match = charge()
    put(match, 2, NEAR + NOSES, 0.24, -0.5 * pi)
    match.rebuild()
    match.robots["keeper_pushing"][0, 1] = 0.3
    actions = asks(match, r1=1.0, r2=1.0)
    found = fouls(match, actions, 4.0)
    assert sorted(rows(found)) == [1, 2]
    pushed = {row: second for second, row, _ in found}
    assert pushed[2] < pushed[1] or pushed[2] - pushed[1] > 1.0  # joined, or came when the first was gone


def test_of_two_that_come_at_once_neither_joins():
    match = charge()
    put(match, 2, NEAR, 0.0)
    match.robot_events["pushes"][0, 1:3] = 2
    assert fouls(match, stand(match), 0.5) == []


def test_a_goalkeeper_is_pushed_through_the_ball_too():
    match = court(RULE)
    put(match, 1, NEAR, 0.0, 0.0)
    put_ball(match, NEAR + POCKET, 0.0)
    put(match, OTHER_KEEPER, NEAR + 2.0 * POCKET, 0.0, pi)
    match.rebuild()
    actions = asks(match, r1=1.0)
    found = fouls(match, actions, 2.0)
    assert rows(found) == [1] and found[0][2] == Foul.KEEPER_PUSHING
    assert match.robot_events["collision"].sum() == 0


def test_a_mate_of_the_goalkeeper_may_push_it_and_so_may_an_opponent_out_of_its_area():
    match = charge()
    match.robots["team"][0, 1] = 1
    assert fouls(match, asks(match, r1=1.0), 2.5) == []
    match = charge(x=0.0)
    assert fouls(match, asks(match, r1=1.0), 2.5) == []
