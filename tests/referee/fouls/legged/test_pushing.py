"""Pushing: more than 3 s of walking into an opponent."""

import numpy as np
import pytest

from soccer_env.referee.fouls.legged.contact import note_push
from soccer_env.types import Foul
from tests.scenes.fouls import BODY, FOOT_IN, KEEPER, NOSES, asks, court, face, fouls, rows
from tests.scenes.staging import place, put, stand

RULE = "pushing=True"


def pushed_steps(match, actions, seconds):
    """Return in how many steps robot 1 pushed before it was whistled, or in all."""
    count = 0
    for _ in range(round(seconds * match.league.control_rate)):
        match.step(actions)
        count += int(match.robot_events["pushes"][0, 1])
        if match.robot_events["foul"][0, 1]:
            break
    return count


def test_three_seconds_are_legal_and_one_step_more_is_not():
    match = court(RULE)
    face(match, 1, 4, 0.3)
    match.rebuild()
    assert pushed_steps(match, asks(match, r1=1.0), 8.0) == 3 * 16 + 1
    assert match.robot_events["foul"][0, 1] == Foul.PUSHING and match.events["foul"][0] == Foul.PUSHING
    assert match.events["foul_team"][0] == 0 and match.robots["active"][0, 1] == 0
    assert match.robots["penalty"][0, 1] == 30.0 and match.robots["active"][0, 4] == 1


def test_with_the_switch_off_nobody_is_whistled():
    match = court("pushing=False")
    face(match, 1, 4, 0.3)
    match.rebuild()
    assert fouls(match, asks(match, r1=1.0), 8.0) == []


def test_of_two_that_charge_into_each_other_both_are_removed_at_once():
    match = court(RULE)
    face(match, 1, 4, 0.3)
    match.rebuild()
    found = fouls(match, asks(match, r1=1.0, r4=1.0), 6.0)
    assert rows(found) == [1, 4] and found[0][0] == found[1][0]


def test_who_stands_is_never_guilty_and_who_turns_or_walks_away_pushes_nobody():
    match = court(RULE)
    face(match, 1, 4, 0.3)
    match.rebuild()
    assert fouls(match, stand(match), 6.0) == []
    actions = stand(match)
    actions[:, 1, 2] = 1.0
    assert fouls(match, actions, 6.0) == [] and fouls(match, asks(match, r1=-1.0), 2.0) == []


@pytest.mark.parametrize(("heading", "forward", "left", "pushes"), [
    (0.0, 0.26, 0.0, 1), (0.0, 0.24, 0.0, 0), (0.0, -1.0, 0.0, 0), (0.0, 0.0, 1.0, 0), (0.5 * np.pi, 0.0, -0.26, 1),
    (0.5 * np.pi, 0.0, 0.26, 0), (np.pi, -0.26, 0.0, 1), (0.25 * np.pi, 0.3, 0.0, 0),
])  # fmt: skip
def test_a_walk_leads_into_another_from_a_quarter_of_the_top_speed_on(heading, forward, left, pushes):
    match = court(RULE)
    put(match, 4, 0.3 + NOSES, 0.4)
    top = match.league.drive.forward
    put(match, 1, 0.3, 0.4, heading, forward * top, left * top)
    note_push(match.matches[0], match.robots[0], match.robot_events[0], 1, 4, match.batch.constants[0])
    assert match.robot_events["pushes"][0].tolist() == [0, pushes, 0, 0, 0, 0]
    assert match.robot_events["pushed"][0].tolist() == [0, 0, 0, 0, pushes, 0]


def test_mates_may_push_each_other():
    match = court(RULE)
    face(match, 1, 2, 0.3)
    match.rebuild()
    assert fouls(match, asks(match, r1=1.0), 6.0) == []


@pytest.mark.parametrize(("away", "guilty"), [(0.45, []), (0.60, [1])])
def test_the_robot_nearest_to_the_ball_may_push_within_50_cm(away, guilty):
    match = court(RULE)
    face(match, 1, 4, 0.3)
    place(match, ball=(0.3, 0.4 - away))
    assert rows(fouls(match, asks(match, r1=1.0), 5.0)) == guilty


def test_the_second_nearest_of_a_team_may_not_while_the_nearest_of_the_other_may():
    match = court(RULE)
    face(match, 1, 4, 0.3)
    place(match, ball=(0.3, 0.1), robots={2: (0.3, -0.1)})
    assert rows(fouls(match, asks(match, r1=1.0, r4=1.0), 6.0)) == [1]


@pytest.mark.parametrize(("inside", "guilty"), [(0.01, []), (-0.001, [0])])
def test_a_goalkeeper_with_two_feet_in_its_own_area_may_push(inside, guilty):
    match = court(RULE)
    x = -FOOT_IN - BODY.hind_x - inside  # it faces the pitch, and walks on in the step
    face(match, KEEPER, 4, x, 0.0)
    match.robots["pushing"][0, KEEPER] = 2.99
    match.robots["walk"]["forward"][0, KEEPER] = match.robots["target"]["forward"][0, KEEPER] = 0.12
    match.rebuild()
    assert rows(fouls(match, asks(match, r0=1.0), 1.0 / 16.0)) == guilty


def test_short_pushes_count_as_one_unless_it_lets_go_for_as_long():
    match = court(RULE)
    face(match, 1, 4, 0.3)
    match.rebuild()
    match.robots["pushing"][0, 1] = 2.0
    assert pushed_steps(match, asks(match, r1=1.0), 8.0) == 16 + 1 + 10  # while it got going the clock ran back
    match = court(RULE)
    match.robots["pushing"][0, 1] = 2.0
    place(match, robots={1: (-1.0, 0.4)})
    fouls(match, stand(match), 1.5)
    assert match.robots["pushing"][0, 1] == 0.5


@pytest.mark.parametrize("turned", [False, True])
def test_both_teams_and_both_directions_are_alike(turned):
    match = court(RULE)
    if turned:
        match.matches["home_direction"] = -1.0
        put(match, 4, -0.3, -0.4, np.pi)
        put(match, 1, -0.3 - NOSES, -0.4, 0.0)
    else:
        face(match, 4, 1, 0.3)
    place(match, ball=(0.0, 0.9 if turned else -0.9))
    found = fouls(match, asks(match, r4=1.0), 8.0)
    assert rows(found) == [4]
