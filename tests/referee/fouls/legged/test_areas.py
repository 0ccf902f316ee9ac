"""Illegal defender and attacker, robots that leave the field through a goal, and local and global game stuck."""

from math import pi

import pytest

from soccer_env.types import Foul, Phase
from tests.scenes.fouls import BODY, FOOT_IN, KEEPER, NOSES, POCKET, asks, court, fouls, rows
from tests.scenes.staging import LEGGED, place, put, put_ball, stage, stand

AREAS = "illegal_defender=True"
LINE = -FOOT_IN  # [m] of home's penalty area, and of its own goal beyond
HIND = -BODY.hind_x  # [m] of the hind feet behind a robot's middle
STEP = 1.0 / 16.0


def standing_at(x, y=0.0, heading=0.0, rules=AREAS, r=1):
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
    found = fouls(standing_at(x, y, heading), stand(court(AREAS)), 3.0)
    assert found == ([(1.0 + STEP, 1, Foul.ILLEGAL_DEFENDER)] if guilty else [])


def test_a_second_is_legal_short_visits_add_up_and_where_there_is_no_goalkeeper_nothing_is_called():
    match = standing_at(-1.2)
    assert fouls(match, stand(match), 1.0) == []
    place(match, robots={1: (0.0, 0.0)})
    fouls(match, stand(match), 0.5)
    assert match.robots["trespass"][0, 1] == 0.5
    match = standing_at(-1.2)
    assert match.robots["active"][0, 0] == 0 and rows(fouls(match, stand(match), 2.0)) == [1]
    alone = stage(LEGGED, rules=f"simple:{AREAS},dropped_ball=False", robots={0: (-1.2, 0.0)})
    alone.robots["trespass"] = 0.0  # as in a court
    off = standing_at(-1.2, rules="illegal_defender=False")
    assert fouls(alone, stand(alone), 3.0) == fouls(off, stand(off), 3.0) == []


@pytest.mark.parametrize(("r", "x", "direction", "guilty"), [
    (0, -1.2, 1.0, []), (1, 1.2, 1.0, []), (4, 1.2, 1.0, [4]), (4, -1.2, 1.0, []), (5, 1.2, 1.0, [5]),
    (1, 1.2, -1.0, [1]),
])  # fmt: skip
def test_goalkeepers_and_attackers_may_be_there_and_both_teams_and_halves_are_alike(r, x, direction, guilty):
    match = standing_at(x, r=r)
    match.matches["home_direction"] = direction
    assert rows(fouls(match, stand(match), 2.0)) == guilty


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


def until_restart(match, seconds, actions=None):
    """Play on until a restart; return at which second and what it is, or None."""
    for step in range(round(seconds / STEP)):
        match.step(stand(match) if actions is None else actions)
        if match.events["restart"][0]:
            return (step + 1) * STEP, Phase(match.events["restart"][0]), int(match.events["restart_team"][0])
    return None


@pytest.mark.parametrize(("x", "team", "direction", "idle"), [
    (-0.9, 0, 1.0, 0.0), (0.9, 1, 1.0, 29.0), (-0.9, 1, -1.0, 29.0), (0.9, 0, -1.0, 29.0),
])  # fmt: skip
def test_a_ball_that_nobody_touches_for_30_s_gives_a_kick_off_to_those_in_whose_half_it_lies(x, team, direction, idle):
    match = court("global_stuck=True")
    match.matches["home_direction"], match.matches["idle_clock"] = direction, idle
    place(match, ball=(x, 0.3))
    assert until_restart(match, 31.0 - idle) == (30.0 - idle + STEP, Phase.KICK_OFF, team)
    assert match.events["stuck"][0] == 1 and match.balls["x"][0] == 0.0


def test_a_touch_begins_the_30_s_anew_dropped_balls_do_not_and_the_switch_off_ends_them():
    match = court("global_stuck=True")
    place(match, ball=(-0.9, 0.3), robots={1: (-0.9 - POCKET, 0.3)})
    assert until_restart(match, 33.0) is None
    match = court("global_stuck=False")
    place(match, ball=(-0.9, 0.3))
    assert until_restart(match, 33.0) is None
    match = court("global_stuck=True")
    match.batch.constants["rules_dropped_ball"] = 1
    place(match, ball=(-0.9, 0.3))
    assert until_restart(match, 16.0) == until_restart(match, 16.0) == (15.0, Phase.DROP_BALL, -1)
    assert until_restart(match, 1.0) == (STEP, Phase.KICK_OFF, 0), "a dropped ball is in play at once"


def scrum(rules="local_stuck=True", x=-0.5, r=1):
    """Return a match in which robot r and, a little farther away, robot 4 stand at the ball."""
    match = court(rules)
    place(match, ball=(x, 0.3), robots={r: (x - POCKET, 0.3), 4: (x + POCKET + 0.001, 0.3, pi)})
    return match


def test_after_30_s_at_one_place_the_nearest_robot_goes_to_the_halfway_line_unless_nobody_touches_the_ball():
    match = scrum()
    assert fouls(match, stand(match), 29.9) == []
    found = fouls(match, stand(match), 0.2)  # the first step finds where play is
    assert found == [(3 * STEP, 1, Foul.GAME_STUCK)]
    assert match.robots["x"][0, 1] == 0.0 and match.robots["active"][0, 1] == 1
    assert abs(match.balls["x"][0] + 0.5) < 0.01 and match.matches["phase"][0] == Phase.PLAY
    assert rows(fouls(match, stand(match), 31.0)) == [4]
    match = court("local_stuck=True")
    place(match, ball=(-0.5, 0.3), robots={1: (-0.9, 0.3)})
    assert fouls(match, stand(match), 60.0) == []
    place(match, robots={1: (-0.5 - POCKET, 0.3)})
    assert fouls(match, stand(match), 29.9) == []
    assert rows(fouls(match, stand(match), 0.3)) == [1]


def late(match, x=0.0, y=0.0, clock=30.0 - STEP):
    """Let play have been so far [m] from the ball, for so many seconds."""
    match.matches["local_x"], match.matches["local_y"] = match.balls["x"] + x, match.balls["y"] + y
    match.matches["local_clock"] = clock
    return match


@pytest.mark.parametrize(("x", "y"), [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.6, -0.8)])
@pytest.mark.parametrize(("far", "guilty"), [(0.49, [1]), (0.51, [])])
def test_play_that_moves_on_by_half_a_metre_is_not_stuck(x, y, far, guilty):
    match = late(scrum(), far * x, far * y)
    assert rows(fouls(match, stand(match), STEP)) == guilty
    assert match.matches["local_clock"][0] == 0.0 and match.matches["local_x"][0] == pytest.approx(-0.5, abs=0.01)


@pytest.mark.parametrize(("rules", "clock", "guilty"), [
    ("local_stuck=True", 30.0 - 2 * STEP, []), ("local_stuck=True", 30.0 - STEP, [1]), ("local_stuck=False", 60.0, []),
])  # fmt: skip
def test_30_s_at_one_place_are_enough_and_less_is_not_nor_anything_with_the_switch_off(rules, clock, guilty):
    match = late(scrum(rules), clock=clock)
    assert rows(fouls(match, stand(match), STEP)) == guilty


@pytest.mark.parametrize(("farther", "nearest"), [(0.0, 1), (0.05, 4)])
def test_the_robot_nearest_to_the_ball_is_carried(farther, nearest):
    match = scrum()
    place(match, robots={1: (-0.5 - POCKET - farther, 0.3), 4: (-0.5 + POCKET + 0.01, 0.3, pi)})
    assert rows(fouls(late(match), stand(match), STEP)) == [nearest]


@pytest.mark.parametrize(("idle", "clock"), [(4.0, 20.0 + STEP), (6.0, 20.0), (14.0, 20.0), (16.0, 0.0)])
def test_seconds_in_which_nobody_is_at_the_ball_do_not_count_and_many_of_them_begin_anew(idle, clock):
    match = court("local_stuck=True")
    put_ball(match, -0.5, 0.3)
    put(match, 1, -0.9, 0.3)
    match.matches["idle_clock"] = idle
    match.rebuild()
    late(match, clock=20.0).step(stand(match))
    assert match.matches["local_clock"][0] == clock


def test_a_goalkeeper_in_the_other_half_is_carried_and_the_ball_of_one_in_its_own_is_taken_to_the_centre_spot():
    match = late(scrum(x=0.6, r=KEEPER))
    assert rows(fouls(match, stand(match), STEP)) == [KEEPER] and match.robots["x"][0, KEEPER] == 0.0
    match = late(scrum(x=-1.2, r=KEEPER))
    assert until_restart(match, 31.0)[1:] == (Phase.DROP_BALL, -1)
    assert (match.balls["x"][0], match.balls["y"][0]) == (0.0, 0.0) and match.robots["active"][0, KEEPER] == 1
    assert match.robots["x"][0, KEEPER] < -1.0
