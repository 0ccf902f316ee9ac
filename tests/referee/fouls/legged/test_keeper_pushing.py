"""Goalkeeper pushing: more than 1 s of walking into a goalkeeper in its own area."""

from math import cos, pi, sin

import pytest

from soccer_env.referee.fouls.legged.contact import KEEPER, PLAYER, note_push, note_pushes_through_ball
from soccer_env.referee.fouls.legged.keeper_pushing import joins
from soccer_env.types import Foul
from tests.scenes.fouls import BODY, FOOT_IN, NOSES, OTHER_KEEPER, POCKET, asks, court, fouls, rows
from tests.scenes.staging import place, put, put_ball

RULE = "keeper_pushing=True"
STEP = 1.0 / 16.0
NEAR = 0.93  # [m] of an attacker whose paws touch a goalkeeper in its area


def charge(rules=RULE, x=NEAR):
    """Return a match in which robot 1 stands right before the away team's goalkeeper."""
    match = court(rules)
    place(match, robots={1: (x, 0.0, 0.0), OTHER_KEEPER: (x + NOSES, 0.0, pi)})
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
    place(match, ball=(1.1, 0.3))
    assert pushed_steps(match, asks(match, r1=1.0)) == 16 + 1
    assert match.robot_events["foul"][0, 1] == Foul.KEEPER_PUSHING and match.robots["penalty"][0, 1] == 30.0
    assert match.matches["whistled"][0] == 0


def test_from_the_whistle_on_goals_do_not_count_for_the_full_time_though_there_was_one_before():
    match = charge()
    match.robots["keeper_pushing"][0, 1] = 0.9
    match.matches["whistled_clock"] = 2.5
    assert pushed_steps(match, asks(match, r1=1.0)) is not None
    assert match.matches["whistled"][0] == 0 and match.matches["whistled_clock"][0] == 0.0


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
    place(match, robots={2: (NEAR + NOSES, 0.24, -0.5 * pi)})
    match.robots["keeper_pushing"][0, 1] = 0.3
    actions = asks(match, r1=1.0, r2=1.0)
    found = fouls(match, actions, 4.0)
    assert sorted(rows(found)) == [1, 2]
    pushed = {row: second for second, row, _ in found}
    assert pushed[2] < pushed[1] or pushed[2] - pushed[1] > 1.0  # joined, or came when the first was gone


@pytest.mark.parametrize(("longer", "team", "joined"), [(0.0, 0, 0), (STEP, 0, 1), (-STEP, 0, 0), (STEP, 1, 0)])
def test_who_comes_after_a_mate_joins_it_and_of_two_that_come_at_once_neither_does(longer, team, joined):
    match = charge()
    match.robot_events["pushes"][0, 1:3] = KEEPER
    match.robots["keeper_pushing"][0, 1:3] = 0.3 + longer, 0.3
    match.robots["team"][0, 1] = team
    assert joins(match.robots[0], match.robot_events[0], 2, match.batch.constants[0]) == joined


def test_a_goalkeeper_is_pushed_through_the_ball_too():
    match = court(RULE)
    place(match, ball=(NEAR + POCKET, 0.0), robots={1: (NEAR, 0.0, 0.0), OTHER_KEEPER: (NEAR + 2.0 * POCKET, 0.0, pi)})
    actions = asks(match, r1=1.0)
    found = fouls(match, actions, 2.0)
    assert rows(found) == [1] and found[0][2] == Foul.KEEPER_PUSHING
    assert match.robot_events["collision"].sum() == 0


@pytest.mark.parametrize(("ball", "pushes"), [(NEAR + POCKET, KEEPER), (NEAR - POCKET, 0)])
def test_only_a_ball_between_the_two_hands_a_push_on(ball, pushes):
    match = charge()
    match.robots["walk"]["forward"][0, 1] = 0.12
    put_ball(match, ball, 0.0)
    match.robot_events["pushes"], match.robot_events["touch"][0, [1, OTHER_KEEPER]] = 0, 1
    records = match.matches[0], match.balls[0], match.robots[0], match.robot_events[0]
    note_pushes_through_ball(*records, OTHER_KEEPER, match.batch.constants[0])
    assert match.robot_events["pushes"][0].tolist() == [0, pushes, 0, 0, 0, 0]


@pytest.mark.parametrize(("keeper", "inside", "pushes"), [
    (OTHER_KEEPER, 0.003, KEEPER), (OTHER_KEEPER, -0.003, PLAYER), (4, 0.3, PLAYER),
])  # fmt: skip
def test_one_foot_of_a_goalkeeper_counts_and_no_field_player_is_one(keeper, inside, pushes):
    heading = 1.25 * pi  # one of its hind feet is over the line first
    match = court(RULE)
    x = FOOT_IN + (BODY.hind_x - BODY.hind_y) * 0.5**0.5 + inside
    put(match, keeper, x, 0.0, heading)
    put(match, 1, x + NOSES * cos(heading), NOSES * sin(heading), heading - pi)
    match.robots["walk"]["forward"][0, 1] = 0.12
    note_push(match.matches[0], match.robots[0], match.robot_events[0], 1, keeper, match.batch.constants[0])
    assert match.robot_events["pushes"][0, 1] == pushes and match.robot_events["pushed"][0, keeper] == 1


def test_a_mate_of_the_goalkeeper_may_push_it_and_so_may_an_opponent_out_of_its_area():
    match = charge()
    match.robots["team"][0, 1] = 1
    assert fouls(match, asks(match, r1=1.0), 2.5) == []
    match = charge(x=0.0)
    assert fouls(match, asks(match, r1=1.0), 2.5) == []
