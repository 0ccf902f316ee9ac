"""Ball holding: a trapped ball, for more than 3 s, by a goalkeeper in its own area 5 s."""

from math import cos, pi, sin

import pytest

from soccer_env.referee.fouls.legged.holding import is_covered
from soccer_env.types import Foul
from tests.scenes.fouls import BODY, KEEPER, POCKET, asks, court, fouls, rows
from tests.scenes.staging import place, put, put_ball, stand

RULE = "holding=True"
DT = 1.0 / 16.0


def hold(match, r, actions, seconds):
    """Play on with the ball kept between the forepaws of a robot; return at which second it was whistled, or None."""
    for step in range(round(seconds / DT)):
        robot = match.robots[0, r]
        put_ball(
            match,
            robot["x"] + POCKET * cos(robot["heading"]),
            robot["y"] + POCKET * sin(robot["heading"]),
            robot["vx"],
            robot["vy"],
        )
        match.robots["has_ball"][0, r] = 1
        match.rebuild()
        match.step(actions)
        if match.robot_events["foul"][0, r]:
            return (step + 1) * DT
    return None


def at_work(match, r, **asked):
    """Put robot r on the pitch, already walking or turning as it is asked to; return the actions."""
    league, robot = match.league.drive, match.robots[0, r]
    actions = stand(match)
    for index, name in enumerate(("forward", "left", "turn")):
        share = asked.get(name, 0.0)
        actions[0, r, index] = share
        top = {"forward": league.forward if share > 0.0 else league.backward, "left": league.sideways}
        for record in (robot["walk"], robot["target"]):
            record[name] = share * top.get(name, league.turn)
        robot["delayed"][name] = share * top.get(name, league.turn)
    return actions


@pytest.mark.parametrize("asked", [{"turn": 0.5}, {"turn": -0.5}, {"left": 0.6}, {"forward": -0.6}])
def test_a_ball_that_goes_along_though_the_robot_does_not_walk_ahead_is_held_for_three_seconds(asked):
    match = court(RULE)
    put(match, 1, 0.3, 0.0)
    assert hold(match, 1, at_work(match, 1, **asked), 4.0) == pytest.approx(3.0 + DT, abs=DT)
    assert match.robots["active"][0, 1] == 0 and match.robots["penalty"][0, 1] == 30.0
    assert match.events["foul"][0] == Foul.HOLDING and match.matches["whistled"][0] == 0
    assert abs(match.balls["x"][0]) < 1.0  # the ball lies where it was held


@pytest.mark.parametrize(("r", "x", "limit"), [(1, 0.3, 3.0), (KEEPER, -1.2, 5.0), (4, -1.2, 3.0)])
def test_the_full_time_is_legal_and_one_step_more_is_not(r, x, limit):
    match = court(RULE)
    put(match, r, x, 0.0)
    match.robots["holding"][0, r] = limit - DT
    actions = at_work(match, r, turn=0.5)
    assert hold(match, r, actions, DT) is None and match.robots["holding"][0, r] == limit
    assert hold(match, r, actions, DT) == DT


@pytest.mark.parametrize("asked", [{"forward": 1.0}, {"forward": 0.5, "turn": 0.5}, {"forward": 0.3}, {}])
def test_a_ball_that_is_walked_ahead_with_or_stood_before_is_never_held(asked):
    match = court(RULE)
    put(match, 1, -0.9, 0.0)
    assert hold(match, 1, at_work(match, 1, **asked), 8.0) is None and match.robots["holding"][0, 1] == 0.0


def test_who_stands_with_it_neither_holds_on_nor_lets_go_and_who_walks_ahead_lets_go():
    match = court(RULE)
    put(match, 1, -0.5, 0.0)
    match.robots["holding"][0, 1] = 2.0
    hold(match, 1, at_work(match, 1), 1.0)
    assert match.robots["holding"][0, 1] == 2.0
    hold(match, 1, at_work(match, 1, forward=1.0), 1.0)
    assert match.robots["holding"][0, 1] == 1.0


def test_with_the_switch_off_nobody_is_whistled():
    match = court("holding=False")
    put(match, 1, 0.3, 0.0)
    assert hold(match, 1, at_work(match, 1, turn=0.5), 5.0) is None


def test_a_ball_that_an_opponent_touches_is_not_trapped():
    match = court(RULE)
    put(match, 1, 0.0, 0.0)
    actions = at_work(match, 1, forward=-0.3)
    put(match, 4, 2.0 * POCKET - 0.002, 0.0, pi)
    match.robots["holding"][0, 1] = 2.9
    assert hold(match, 1, actions, DT) is None and match.robots["holding"][0, 1] == 2.9 - DT


@pytest.mark.parametrize(("x", "seconds"), [(-1.2, 5.0), (0.0, 3.0)])
def test_the_goalkeeper_has_five_seconds_in_its_area_and_comes_back_at_once(x, seconds):
    match = court(RULE)
    put(match, KEEPER, x, 0.0)
    assert hold(match, KEEPER, at_work(match, KEEPER, turn=0.5), 6.0) == pytest.approx(seconds + DT, abs=DT)
    keeper = match.robots[0, KEEPER]
    assert keeper["active"] == 1 and keeper["penalty"] == 0.0 and keeper["x"] == 0.0
    assert match.robot_events["returned"][0, KEEPER] == 1


@pytest.mark.parametrize("heading", [0.25 * pi, -0.25 * pi])
def test_a_ball_that_a_robot_covers_in_a_corner_is_trapped_though_it_walks_ahead(heading):
    match = court(RULE)
    side = 1.0 if heading > 0.0 else -1.0
    x, y = 1.5 - 0.043, side * (1.0 - 0.043)
    place(match, ball=(x, y), robots={1: (x - POCKET * cos(heading), y - POCKET * sin(heading), heading)})
    found = fouls(match, asks(match, r1=0.6), 4.0)
    assert rows(found) == [1] and found[0][2] == Foul.HOLDING and 3.0 < found[0][0] < 3.8


def test_a_ball_pressed_straight_against_a_board_is_trapped_and_one_pushed_along_it_is_free():
    match = court(RULE)
    place(match, ball=(0.3, 1.0 - 0.043), robots={1: (0.3, 1.0 - 0.043 - POCKET, 0.5 * pi)})
    assert rows(fouls(match, asks(match, r1=0.6), 4.0)) == [1]
    match = court(RULE)
    place(match, ball=(-1.0 + POCKET, 1.0 - 0.045), robots={1: (-1.0, 1.0 - 0.11, 0.0)})
    assert fouls(match, asks(match, r1=0.7), 8.0) == []


@pytest.mark.parametrize(("away", "covered"), [(0.0, True), (0.5, True), (2.0, False)])
def test_a_robot_that_has_backed_off_by_the_breadth_of_a_paw_covers_nothing(away, covered):
    """`away`: in radii of a paw."""
    match = court(RULE)
    y = 1.0 - match.league.ball.radius
    put(match, 1, 0.3, y - POCKET - away * BODY.tip_radius, 0.5 * pi)
    put_ball(match, 0.3, y)
    assert is_covered(match.robots[0, 1], match.balls[0], match.batch.constants[0]) == covered


def test_what_it_goes_without_the_ball_is_not_carried():
    match = court("carrying=True,carrying_distance=0.3")
    put(match, 1, 0.3, 0.2)
    match.robots["carry_x"][0, 1] = match.robots["carry_y"][0, 1] = -0.4
    match.rebuild()
    assert fouls(match, stand(match), DT) == []
    assert match.robots["carry_x"][0, 1] == pytest.approx(0.3) and match.robots["carry_y"][0, 1] == pytest.approx(0.2)


def test_carrying_is_a_rule_of_its_own():
    match = court("carrying=True,carrying_distance=0.3")
    put(match, 1, -0.9, 0.0)
    match.robots["carry_x"][0, 1] = -0.9
    second = hold(match, 1, at_work(match, 1, forward=1.0), 6.0)
    assert second is not None and 0.3 < match.league.drive.forward * second * 1.1 < 0.42
    match = court(RULE)
    put(match, 1, -0.9, 0.0)
    assert hold(match, 1, at_work(match, 1, forward=1.0), 6.0) is None
