"""Illegal defender, illegal attacker, and robots that leave the field through a goal."""

from math import pi

import pytest

from soccer_env.types import Foul
from tests.scenes.fouls import BODY, FOOT_IN, NOSES, asks, court, fouls, rows
from tests.scenes.staging import LEGGED, place, put_ball, stage, stand

RULE = "illegal_defender=True"
LINE = -FOOT_IN  # [m] of home's penalty area, and of its own goal beyond
HIND = -BODY.hind_x  # [m] of the hind feet behind a robot's middle
STEP = 1.0 / 16.0


def standing_at(x, y=0.0, heading=0.0, rules=RULE, r=1):
    """Return a match in which robot r alone stands somewhere."""
    match = court(rules)
    place(match, robots={r: (x, y, heading)})
    return match


@pytest.mark.parametrize(("x", "y", "heading", "guilty"), [
    (LINE + HIND - 0.002, 0.0, 0.0, True),  # both hind feet just in
    (LINE + HIND + 0.002, 0.0, 0.0, False),
    (LINE + HIND * 0.707 + BODY.hind_y * 0.707 - 0.003, 0.0, 0.25 * pi, False),  # one hind foot
    (-1.2, 0.5 + BODY.tip_y - 0.002, 0.0, True),  # the two right feet, over the side of the area
    (-1.2, 0.5 + BODY.tip_y + 0.002, 0.0, False),
    (-1.55, 0.0, 0.0, True),  # in its own goal
])  # fmt: skip
def test_a_field_player_with_two_feet_in_its_own_area_is_illegal(x, y, heading, guilty):
    found = fouls(standing_at(x, y, heading), stand(court(RULE)), 3.0)
    assert found == ([(1.0 + STEP, 1, Foul.ILLEGAL_DEFENDER)] if guilty else [])


def test_a_second_is_legal_and_short_visits_add_up():
    match = standing_at(-1.2)
    assert fouls(match, stand(match), 1.0) == []
    place(match, robots={1: (0.0, 0.0)})
    fouls(match, stand(match), 0.5)
    assert match.robots["trespass"][0, 1] == 0.5


@pytest.mark.parametrize(
    ("r", "x", "guilty"), [(0, -1.2, []), (1, 1.2, []), (4, 1.2, [4]), (4, -1.2, []), (5, 1.2, [5])]
)
def test_goalkeepers_and_attackers_may_be_there_and_both_teams_are_alike(r, x, guilty):
    match = standing_at(x, r=r)
    assert rows(fouls(match, stand(match), 2.0)) == guilty


def test_ends_change_at_half_time():
    match = standing_at(1.2)
    match.matches["home_direction"] = -1.0
    assert rows(fouls(match, stand(match), 2.0)) == [1]


def test_it_is_called_though_the_goalkeeper_is_out_but_not_where_there_is_none():
    match = standing_at(-1.2)
    assert match.robots["active"][0, 0] == 0 and rows(fouls(match, stand(match), 2.0)) == [1]
    alone = stage(LEGGED, 1, 1, 1, rules=f"simple:{RULE},dropped_ball=False", robots={0: (-1.2, 0.0)})
    alone.robots["trespass"] = 0.0  # as in a court
    alone.rebuild()
    assert fouls(alone, stand(alone), 3.0) == []


def test_with_the_switch_off_nobody_is_whistled():
    match = standing_at(-1.2, rules="illegal_defender=False")
    assert fouls(match, stand(match), 3.0) == []


def test_whom_an_opponent_or_the_referee_put_there_has_time_to_walk_out():
    match = standing_at(-1.2)
    place(match, robots={4: (-1.2 + NOSES, 0.0, pi)})
    assert fouls(match, asks(match, r4=0.6), 5.0) == []
    place(match, robots={4: (0.5, 0.0, pi)})
    assert 3.5 < fouls(match, stand(match), 6.0)[0][0] <= 4.0 + 2 * STEP
    match = standing_at(-0.7, -0.3)  # the ball falls where it stands, and it is carried away from there
    match.batch.constants["rules_dropped_ball"] = 1
    put_ball(match, -0.45, -0.3)
    match.matches["still_clock"] = match.league.rules.stuck_time
    match.rebuild()
    match.step(stand(match))
    assert match.events["restart"][0] == 5 and match.robots["placed"][0, 1] == 1
    assert match.robots["trespass"][0, 1] == -3.0


@pytest.mark.parametrize(("ball", "guilty"), [(0.0, [1]), (1.3, [])])
def test_an_attacker_may_not_camp_in_the_opponents_area_while_the_ball_is_elsewhere(ball, guilty):
    match = standing_at(1.25, rules="illegal_attacker=True")
    place(match, ball=(ball, 0.4))
    found = fouls(match, stand(match), 11.0)
    assert rows(found) == guilty and all(abs(second - 10.0 - STEP) < 1e-9 for second, _, _ in found)
    match = standing_at(1.25, rules="illegal_defender=True")
    assert fouls(match, stand(match), 11.0) == []


@pytest.mark.parametrize(
    ("r", "x", "guilty"), [(1, 1.505, [1]), (1, 1.495, []), (1, -1.6, [1]), (0, -1.6, []), (0, 1.6, [0])]
)
def test_who_stands_in_a_goal_for_five_seconds_leaves_the_field_but_for_a_goalkeeper_in_its_own(r, x, guilty):
    match = standing_at(x, r=r, rules="leaving_field=True")
    found = fouls(match, stand(match), 6.0)
    assert rows(found) == guilty and all(item == (5.0 + STEP, r, Foul.LEFT_FIELD) for item in found)
    assert fouls(standing_at(x, r=r, rules="leaving_field=False"), stand(match), 6.0) == []


def test_who_comes_back_onto_the_field_in_time_has_not_left_it():
    match = standing_at(1.6, rules="leaving_field=True")
    assert fouls(match, stand(match), 4.9) == []
    place(match, robots={1: (1.3, 0.0)})
    fouls(match, stand(match), 0.1)
    place(match, robots={1: (1.6, 0.0)})
    assert fouls(match, stand(match), 4.9) == []
