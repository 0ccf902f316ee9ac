"""Pushing: more than 3 s of walking into an opponent, or 1 s into a goalkeeper in its own area."""

from math import cos, pi, sin

import numpy as np
import pytest

from soccer_env.referee.fouls.legged import contact
from soccer_env.referee.fouls.legged.contact import note_push, note_pushes_through_ball
from soccer_env.referee.fouls.legged.keeper_pushing import joins_pushing_mate
from soccer_env.types import Foul
from tests.scenes.fouls import BODY, FOOT_IN, KEEPER, NOSES, OTHER_KEEPER, POCKET, asks, court, face, fouls, rows
from tests.scenes.staging import place, put, put_ball, robot_actions, stand

PUSHING = "pushing=True"


def pushed_steps(match, actions, seconds):
    """Return in how many steps robot 1 pushed before it was whistled, or in all."""
    count = 0
    for _ in range(round(seconds * match.league.control_rate)):
        match.step(actions)
        count += int(match.robot_events["pushes"][0, 1])
        if match.robot_events["foul"][0, 1]:
            break
    return count


def before(r=1, other=4, rules=PUSHING, **scene):
    """Return a match in which a robot stands right before the paws of another."""
    match = court(rules)
    face(match, r, other, 0.3)
    place(match, **scene)
    return match


def test_three_seconds_are_legal_one_step_more_is_not_nor_a_charge_and_who_stands_or_pushes_a_mate_is_not_guilty():
    match = before()
    assert pushed_steps(match, asks(match, r1=1.0), 8.0) == 3 * 16 + 1
    assert match.robot_events["foul"][0, 1] == Foul.PUSHING and match.events["foul"][0] == Foul.PUSHING
    assert match.events["foul_team"][0] == 0 and match.robots["active"][0, 1] == 0
    assert match.robots["penalty"][0, 1] == 30.0 and match.robots["active"][0, 4] == 1
    match = before()
    found = fouls(match, asks(match, r1=1.0, r4=1.0), 6.0)
    assert rows(found) == [1, 4] and found[0][0] == found[1][0]
    match, mates, off = before(), before(other=2), before(rules="pushing=False")
    assert fouls(match, stand(match), 6.0) == fouls(match, robot_actions(match, 1, turn=1.0), 6.0) == []
    assert fouls(match, asks(match, r1=-1.0), 2.0) == []
    assert fouls(mates, asks(mates, r1=1.0), 6.0) == fouls(off, asks(off, r1=1.0), 8.0) == []


@pytest.mark.parametrize(("heading", "forward", "left", "pushes"), [
    (0.0, 0.26, 0.0, 1), (0.0, 0.24, 0.0, 0), (0.0, -1.0, 0.0, 0), (0.0, 0.0, 1.0, 0), (0.5 * np.pi, 0.0, -0.26, 1),
    (0.5 * np.pi, 0.0, 0.26, 0), (np.pi, -0.26, 0.0, 1), (0.25 * np.pi, 0.3, 0.0, 0),
])  # fmt: skip
def test_a_walk_leads_into_another_from_a_quarter_of_the_top_speed_on(heading, forward, left, pushes):
    match = court(PUSHING)
    put(match, 4, 0.3 + NOSES, 0.4)
    top = match.league.drive.forward
    put(match, 1, 0.3, 0.4, heading, forward * top, left * top)
    note_push(match.matches[0], match.balls[0], match.robots[0], match.robot_events[0], 1, 4, match.batch.constants[0])
    assert match.robot_events["pushes"][0].tolist() == [0, pushes, 0, 0, 0, 0]
    assert match.robot_events["pushed"][0].tolist() == [0, 0, 0, 0, pushes, 0]


@pytest.mark.parametrize(("away", "guilty"), [(0.45, []), (0.60, [1])])
def test_the_robot_nearest_to_the_ball_may_push_within_50_cm(away, guilty):
    match = before(ball=(0.3, 0.4 - away))
    assert rows(fouls(match, asks(match, r1=1.0), 5.0)) == guilty


def test_the_second_nearest_of_a_team_may_not_while_the_nearest_of_the_other_may():
    match = before(ball=(0.3, 0.1), robots={2: (0.3, -0.1)})
    assert rows(fouls(match, asks(match, r1=1.0, r4=1.0), 6.0)) == [1]


@pytest.mark.parametrize(("inside", "guilty"), [(0.01, []), (-0.001, [0])])
def test_a_goalkeeper_with_two_feet_in_its_own_area_may_push(inside, guilty):
    match = court(PUSHING)
    x = -FOOT_IN - BODY.hind_x - inside  # it faces the pitch, and walks on in the step
    face(match, KEEPER, 4, x, 0.0)
    match.robots["pushing"][0, KEEPER] = 2.99
    match.robots["walk"]["forward"][0, KEEPER] = match.robots["target"]["forward"][0, KEEPER] = 0.12
    match.rebuild()
    assert rows(fouls(match, asks(match, r0=1.0), 1.0 / 16.0)) == guilty


def test_short_pushes_count_as_one_unless_it_lets_go_for_as_long():
    match, gone = before(), court(PUSHING)
    match.robots["pushing"][0, 1] = gone.robots["pushing"][0, 1] = 2.0
    assert pushed_steps(match, asks(match, r1=1.0), 8.0) == 16 + 1 + 10  # while it got going the clock ran back
    place(gone, robots={1: (-1.0, 0.4)})
    fouls(gone, stand(gone), 1.5)
    assert gone.robots["pushing"][0, 1] == 0.5


@pytest.mark.parametrize("turned", [False, True])
def test_both_teams_and_both_directions_are_alike(turned):
    match = court(PUSHING)
    if turned:
        match.matches["home_direction"] = -1.0
        put(match, 4, -0.3, -0.4, np.pi)
        put(match, 1, -0.3 - NOSES, -0.4, 0.0)
    else:
        face(match, 4, 1, 0.3)
    place(match, ball=(0.0, 0.9 if turned else -0.9))
    found = fouls(match, asks(match, r4=1.0), 8.0)
    assert rows(found) == [4]


KEEPER_PUSHING = "keeper_pushing=True"
STEP = 1.0 / 16.0
NEAR = 0.93  # [m] of an attacker whose paws touch a goalkeeper in its area


def charge(rules=KEEPER_PUSHING, x=NEAR):
    """Return a match in which robot 1 stands right before the away team's goalkeeper."""
    match = court(rules)
    place(match, robots={1: (x, 0.0, 0.0), OTHER_KEEPER: (x + NOSES, 0.0, pi)})
    return match


def keeper_pushed_steps(match, actions):
    """Return in how many steps robot 1 pushed the goalkeeper before it was whistled."""
    count = 0
    for _ in range(80):
        match.step(actions)
        count += int(match.robot_events["pushes"][0, 1] == 2)
        if match.robot_events["foul"][0, 1]:
            return count
    return None


def test_one_second_at_a_goalkeeper_in_its_area_is_legal_and_one_step_more_is_not_even_for_the_robot_at_the_ball():
    match = charge()
    place(match, ball=(1.1, 0.3))
    assert keeper_pushed_steps(match, asks(match, r1=1.0)) == 16 + 1
    assert match.robot_events["foul"][0, 1] == Foul.KEEPER_PUSHING and match.robots["penalty"][0, 1] == 30.0
    assert match.matches["whistled"][0] == 0
    match, mates, outside, off = charge(), charge(), charge(x=0.0), charge("pushing=True")
    assert fouls(match, asks(match, r3=1.0), 4.0) == [], "whoever walks into it"
    mates.robots["team"][0, 1] = 1
    for one in (mates, outside, off):
        assert fouls(one, asks(one, r1=1.0), 2.5) == []


def test_from_the_whistle_on_goals_do_not_count_for_the_full_time_though_there_was_one_before():
    match = charge()
    match.robots["keeper_pushing"][0, 1] = 0.9
    match.matches["whistled_clock"] = 2.5
    assert keeper_pushed_steps(match, asks(match, r1=1.0)) is not None
    assert match.matches["whistled"][0] == 0 and match.matches["whistled_clock"][0] == 0.0


@pytest.mark.parametrize(("inside", "guilty"), [(0.002, [1]), (-0.02, [])])
def test_a_foot_of_the_goalkeeper_on_its_line_is_enough(inside, guilty):
    match = charge(x=FOOT_IN + BODY.hind_x + inside - NOSES)  # it faces the pitch: its hind feet are in
    place(match, ball=(1.2, 0.4))
    match.robots["keeper_pushing"][0, 1] = 0.9
    assert rows(fouls(match, asks(match, r1=0.5), 2.5)) == guilty


def test_a_second_attacker_that_joins_is_removed_at_once_and_a_goalkeeper_is_pushed_through_the_ball_too():
    match = charge()
    place(match, robots={2: (NEAR + NOSES, 0.24, -0.5 * pi)})
    match.robots["keeper_pushing"][0, 1] = 0.3
    actions = asks(match, r1=1.0, r2=1.0)
    found = fouls(match, actions, 4.0)
    assert sorted(rows(found)) == [1, 2]
    pushed = {row: second for second, row, _ in found}
    assert pushed[2] < pushed[1] or pushed[2] - pushed[1] > 1.0  # joined, or came when the first was gone
    match = court(KEEPER_PUSHING)
    place(match, ball=(NEAR + POCKET, 0.0), robots={1: (NEAR, 0.0, 0.0), OTHER_KEEPER: (NEAR + 2.0 * POCKET, 0.0, pi)})
    actions = asks(match, r1=1.0)
    found = fouls(match, actions, 2.0)
    assert rows(found) == [1] and found[0][2] == Foul.KEEPER_PUSHING
    assert match.robot_events["collision"].sum() == 0


@pytest.mark.parametrize(("longer", "team", "joined"), [(0.0, 0, 0), (STEP, 0, 1), (-STEP, 0, 0), (STEP, 1, 0)])
def test_who_comes_after_a_mate_joins_it_and_of_two_that_come_at_once_neither_does(longer, team, joined):
    match = charge()
    match.robot_events["pushes"][0, 1:3] = contact.KEEPER
    match.robots["keeper_pushing"][0, 1:3] = 0.3 + longer, 0.3
    match.robots["team"][0, 1] = team
    assert joins_pushing_mate(match.robots[0], match.robot_events[0], 2, match.batch.constants[0]) == joined


@pytest.mark.parametrize(("ball", "pushes"), [(NEAR + POCKET, contact.KEEPER), (NEAR - POCKET, 0)])
def test_only_a_ball_between_the_two_hands_a_push_on(ball, pushes):
    match = charge()
    match.robots["walk"]["forward"][0, 1] = 0.12
    put_ball(match, ball, 0.0)
    match.robot_events["pushes"], match.robot_events["touch"][0, [1, OTHER_KEEPER]] = 0, 1
    records = match.matches[0], match.balls[0], match.robots[0], match.robot_events[0]
    note_pushes_through_ball(*records, OTHER_KEEPER, match.batch.constants[0])
    assert match.robot_events["pushes"][0].tolist() == [0, pushes, 0, 0, 0, 0]


@pytest.mark.parametrize(("keeper", "inside", "pushes"), [
    (OTHER_KEEPER, 0.003, contact.KEEPER), (OTHER_KEEPER, -0.003, contact.PLAYER), (4, 0.3, contact.PLAYER),
])  # fmt: skip
def test_one_foot_of_a_goalkeeper_counts_and_no_field_player_is_one(keeper, inside, pushes):
    heading = 1.25 * pi  # one of its hind feet is over the line first
    match = court(KEEPER_PUSHING)
    x = FOOT_IN + (BODY.hind_x - BODY.hind_y) * 0.5**0.5 + inside
    put(match, keeper, x, 0.0, heading)
    put(match, 1, x + NOSES * cos(heading), NOSES * sin(heading), heading - pi)
    put_ball(match, 1.2, 0.4)
    match.robots["walk"]["forward"][0, 1] = 0.12
    note_push(
        match.matches[0], match.balls[0], match.robots[0], match.robot_events[0], 1, keeper, match.batch.constants[0]
    )
    assert match.robot_events["pushes"][0, 1] == pushes and match.robot_events["pushed"][0, keeper] == 1


@pytest.mark.parametrize(("inside", "ball", "pushes"), [
    (-0.003, (0.7, 0.4), contact.PLAYER), (0.003, (0.7, 0.4), contact.KEEPER), (-0.003, (1.003, 0.4), contact.KEEPER),
    (-0.003, (0.997, 0.4), contact.PLAYER), (-0.003, (1.2, 0.503), contact.PLAYER),
])  # fmt: skip
def test_a_goalkeeper_in_its_area_is_pushed_like_any_player_while_ball_and_attacker_are_outside_it(
    inside, ball, pushes
):
    match = court(KEEPER_PUSHING)
    x = FOOT_IN - BODY.tip_x + inside  # the attacker's forefeet are the nearest to the area
    put(match, 1, x, 0.0, 0.0, forward=0.12)
    put(match, OTHER_KEEPER, x + NOSES, 0.0, pi)
    put_ball(match, *ball)
    note_push(
        match.matches[0], match.balls[0], match.robots[0], match.robot_events[0], 1, OTHER_KEEPER,
        match.batch.constants[0],
    )  # fmt: skip
    assert match.robot_events["pushes"][0, 1] == pushes and match.robot_events["pushed"][0, OTHER_KEEPER] == 1


def test_a_duel_for_a_ball_outside_the_area_is_no_foul_at_a_goalkeeper_with_one_foot_in():
    match = charge(x=FOOT_IN + BODY.hind_x + 0.002 - NOSES)
    match.robots["keeper_pushing"][0, 1] = 0.9
    place(match, ball=(0.8, 0.4))
    assert fouls(match, asks(match, r1=0.5), 2.5) == [] and match.robots["keeper_pushing"][0, 1] == 0.0
