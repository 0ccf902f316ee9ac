"""Ball holding, for more than 3 s, a goalkeeper in its own area 5 s; and falling over, from the impulse of a push."""

from dataclasses import replace
from math import cos, inf, pi, sin

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.referee.fouls.legged.falling import impulse_on
from soccer_env.referee.fouls.legged.holding import is_covered
from soccer_env.types import Foul
from tests.scenes.fouls import BODY, KEEPER, NOSES, POCKET, asks, court, face, fouls, rows
from tests.scenes.staging import LEGGED, place, play, put, put_ball, robot_actions, stage, stand

HOLDING, CARRYING = "holding=True", "carrying=True,carrying_distance=0.3"
DT = 1.0 / 16.0
OPPONENT = 5  # row of the one whom robots of home keep off the ball
UPRIGHT = "legged-2001-upright"


def hold(match, r, actions, seconds, near=0.35):
    """Play on with the ball kept between the forepaws of a robot; return at which second it was whistled, or None.

    An opponent waits `near` [m] ahead of the ball; inf: there is none.
    """
    for step in range(round(seconds / DT)):
        robot, heading = match.robots[0, r], match.robots["heading"][0, r]
        x, y = robot["x"] + POCKET * cos(heading), robot["y"] + POCKET * sin(heading)
        match.robots["has_ball"][0, r] = 1
        place(match, ball=(x, y, robot["vx"], robot["vy"]))
        if near < inf:
            other = OPPONENT if r < 3 else 2
            place(match, robots={other: (x + near * cos(heading), y + near * sin(heading))})
        match.step(actions)
        if match.robot_events["foul"][0, r]:
            return (step + 1) * DT
    return None


def at_work(match, r, x, y=0.0, **asked):
    """Put robot r on the pitch, already walking or turning as it is asked to; return the actions."""
    put(match, r, x, y)
    drive, robot = match.league.drive, match.robots[0, r]
    tops = {"forward": drive.forward, "left": drive.sideways, "turn": drive.turn}
    for name, share in asked.items():
        robot["walk"][name] = robot["target"][name] = robot["delayed"][name] = share * (
            drive.backward if name == "forward" and share < 0.0 else tops[name]
        )
    return robot_actions(match, r, **asked)


@pytest.mark.parametrize("asked", [{"turn": 0.5}, {"turn": -0.5}, {"left": 0.6}, {"forward": -0.6}])
def test_a_ball_that_goes_along_though_the_robot_does_not_walk_ahead_is_held_for_three_seconds(asked):
    match = court(HOLDING)
    assert hold(match, 1, at_work(match, 1, 0.3, **asked), 4.0) == pytest.approx(3.0 + DT, abs=DT)
    assert match.robots["active"][0, 1] == 0 and match.robots["penalty"][0, 1] == 30.0
    assert match.events["foul"][0] == Foul.HOLDING and match.matches["whistled"][0] == 0
    assert abs(match.balls["x"][0]) < 1.0  # the ball lies where it was held


@pytest.mark.parametrize("asked", [{"turn": 0.5}, {"turn": -0.5}, {"left": 0.6}, {"forward": -0.6}])
@pytest.mark.parametrize(("near", "guilty"), [(0.39, True), (0.41, False), (inf, False)])
def test_only_who_keeps_an_opponent_within_40_cm_off_the_ball_holds_it(near, guilty, asked):
    match = court(HOLDING)
    assert (hold(match, 1, at_work(match, 1, 0.3, **asked), 4.0, near) is not None) == guilty
    assert guilty or match.robots["holding"][0, 1] == 0.0


def test_a_mate_or_an_opponent_that_is_out_is_not_kept_off_the_ball():
    for other, active in ((2, 1), (4, 0)):
        match = court(HOLDING)
        actions = at_work(match, 1, 0.0, turn=0.5)
        put(match, other, 0.0, 0.3)
        match.robots["active"][0, other] = active
        match.robots["holding"][0, 1] = 2.9
        assert hold(match, 1, actions, 1.0, near=inf) is None and match.robots["holding"][0, 1] < 2.0


@pytest.mark.parametrize(("r", "x", "limit"), [(1, 0.3, 3.0), (KEEPER, -1.2, 5.0), (4, -1.2, 3.0)])
def test_the_full_time_is_legal_and_one_step_more_is_not(r, x, limit):
    match = court(HOLDING)
    actions = at_work(match, r, x, turn=0.5)
    match.robots["holding"][0, r] = limit - DT
    assert hold(match, r, actions, DT) is None and match.robots["holding"][0, r] == limit
    assert hold(match, r, actions, DT) == DT


@pytest.mark.parametrize("asked", [{"forward": 1.0}, {"forward": 0.5, "turn": 0.5}, {"forward": 0.3}, {}])
def test_a_ball_that_is_walked_ahead_with_or_stood_before_is_never_held(asked):
    match = court(HOLDING)
    assert hold(match, 1, at_work(match, 1, -0.9, **asked), 8.0) is None
    assert match.robots["holding"][0, 1] == 0.0


def test_who_stands_with_it_goes_on_who_walks_ahead_lets_go_and_what_an_opponent_touches_is_not_trapped():
    match = court(HOLDING)
    standing = at_work(match, 1, -0.5)
    match.robots["holding"][0, 1] = 2.0
    hold(match, 1, standing, 1.0)
    assert match.robots["holding"][0, 1] == 2.0
    hold(match, 1, at_work(match, 1, float(match.robots["x"][0, 1]), forward=1.0), 1.0)
    assert match.robots["holding"][0, 1] == 1.0
    match, off = court(HOLDING), court("holding=False")
    actions = at_work(match, 1, 0.0, forward=-0.3)
    put(match, 4, 2.0 * POCKET - 0.002, 0.0, pi)
    match.robots["holding"][0, 1] = 2.9
    assert hold(match, 1, actions, DT, near=inf) is None and match.robots["holding"][0, 1] == 2.9 - DT
    assert hold(off, 1, at_work(off, 1, 0.3, turn=0.5), 5.0) is None


@pytest.mark.parametrize(("x", "seconds"), [(-1.2, 5.0), (0.0, 3.0)])
def test_the_goalkeeper_has_five_seconds_in_its_area_and_comes_back_at_once(x, seconds):
    match = court(HOLDING)
    assert hold(match, KEEPER, at_work(match, KEEPER, x, turn=0.5), 6.0) == pytest.approx(seconds + DT, abs=DT)
    keeper = match.robots[0, KEEPER]
    assert keeper["active"] == 1 and keeper["penalty"] == 0.0 and keeper["x"] == 0.0
    assert match.robot_events["returned"][0, KEEPER] == 1


@pytest.mark.parametrize(("opponent", "guilty"), [(True, [1]), (False, [])])
@pytest.mark.parametrize("heading", [0.25 * pi, -0.25 * pi])
def test_a_ball_that_a_robot_covers_in_a_corner_is_trapped_though_it_walks_ahead(heading, opponent, guilty):
    """But not if there is no opponent whom it keeps off."""
    match = court(HOLDING, league=UPRIGHT)
    side = 1.0 if heading > 0.0 else -1.0
    x, y = 1.5 - 0.043, side * (1.0 - 0.043)
    place(match, ball=(x, y), robots={1: (x - POCKET * cos(heading), y - POCKET * sin(heading), heading)})
    if opponent:
        place(match, robots={OPPONENT: (x - 0.37, y - side * 0.05)})
    found = fouls(match, asks(match, r1=0.6), 4.0)
    assert rows(found) == guilty and all(foul == Foul.HOLDING and 3.0 < second < 3.8 for second, _, foul in found)


@pytest.mark.parametrize(("opponent", "guilty"), [(True, [1]), (False, [])])
@pytest.mark.parametrize(("league", "off"), [(UPRIGHT, 0.043), (LEGGED, 0.07)])
def test_a_ball_pressed_straight_against_a_board_or_a_ramp_is_trapped_with_an_opponent_near(
    league, off, opponent, guilty
):
    match = court(HOLDING, league=league)
    place(match, ball=(0.3, 1.0 - off), robots={1: (0.3, 1.0 - off - POCKET, 0.5 * pi)})
    if opponent:
        place(match, robots={OPPONENT: (0.64, 0.75, pi)})
    assert rows(fouls(match, asks(match, r1=0.6), 4.0)) == guilty


def test_a_ball_pushed_along_an_upright_board_is_free():
    match = court(HOLDING, league=UPRIGHT)
    place(match, ball=(-1.0 + POCKET, 1.0 - 0.045), robots={1: (-1.0, 1.0 - 0.11, 0.0)})
    for step in range(8 * 16):
        place(match, robots={OPPONENT: (match.balls["x"][0] + 0.1, 0.65)})
        match.step(asks(match, r1=0.7))
        assert match.robot_events["foul"].sum() == 0 and (step < 16 or match.balls["x"][0] > -1.0)
    assert match.robots["holding"][0, 1] == 0.0


@pytest.mark.parametrize(("away", "covered"), [(0.0, True), (0.5, True), (2.0, False)])
def test_a_robot_that_has_backed_off_by_the_breadth_of_a_paw_covers_nothing(away, covered):
    """`away`: in radii of a paw."""
    match = court(HOLDING)
    y = 1.0 - 0.07  # on a ramp
    put(match, 1, 0.3, y - POCKET - away * BODY.tip_radius, 0.5 * pi)
    put_ball(match, 0.3, y)
    assert is_covered(match.robots[0, 1], match.balls[0], match.batch.constants[0]) == covered


def test_carrying_is_a_rule_of_its_own_and_what_it_goes_without_the_ball_is_not_carried():
    match, free, held = court(CARRYING), court(CARRYING), court(HOLDING)
    actions = at_work(match, 1, -0.9, forward=1.0)
    match.robots["carry_x"][0, 1] = -0.9
    second = hold(match, 1, actions, 6.0)
    assert second is not None and 0.3 < match.league.drive.forward * second * 1.1 < 0.42
    assert hold(held, 1, at_work(held, 1, -0.9, forward=1.0), 6.0) is None
    free.robots["carry_x"][0, 1] = free.robots["carry_y"][0, 1] = -0.4
    place(free, robots={1: (0.3, 0.2)})
    assert fouls(free, stand(free), DT) == []
    assert (free.robots["carry_x"][0, 1], free.robots["carry_y"][0, 1]) == pytest.approx((0.3, 0.2))


def shoved(fall, fall_time=3.0, matches=1, rules="falling=True"):
    """Return matches in which robot 1 stands before robot 4, which may fall."""
    league = find_league(LEGGED)
    league = replace(league, drive=replace(league.drive, fall=fall, fall_time=fall_time))
    match = stage(league, matches, 3, 3, rules=f"simple:dropped_ball=False,{rules}", ball=(0.0, -0.9))
    face(match, 1, 4, 0.3)
    match.rebuild()
    return match


def test_who_is_pushed_falls_lies_still_and_gets_up_who_pushes_does_not_and_in_the_league_nobody_falls():
    match = shoved(find_league(LEGGED).drive.fall, matches=4)
    for _ in range(64):
        match.step(asks(match, r1=1.0))
        assert (match.robots["fallen"] == 0.0).all()
    match = shoved(100.0)
    down = []
    while not (True in down and not down[-1]):
        match.step(asks(match, r1=0.0 if True in down else 1.0, r4=-1.0 if True in down else 0.0))
        down.append(bool(match.robots["fallen"][0, 4] > 0.0))
        assert match.robots["fallen"][0, 1] == 0.0 and match.robot_events["foul"].sum() == 0
        assert len(down) < 100 and (not down[-1] or match.robots["walk"]["forward"][0, 4] == 0.0)
    assert sum(down) == 3 * 16


def test_the_share_of_falls_is_the_impulse_times_the_leagues_number():
    count, fall = 400, 0.5
    match = shoved(fall, 1e3, matches=count)
    play(match, 3.0, asks(match, r1=1.0))
    fallen, league = (match.robots["fallen"][:, 4] > 0.0).mean(), match.league
    most = league.body.mass * league.drive.thrust * fall * 3.0  # [1] falls expected if it pushed all the time
    assert 0.3 * (1.0 - np.exp(-most)) < fallen < 1.0 - np.exp(-most)
    assert not match.robots["fallen"][:, 1].any()


def test_the_impulse_is_of_opponents_that_push_nearby_as_fast_as_they_walk_towards_it():
    match = shoved(0.0)
    league, k = match.league, match.batch.constants[0]
    most = league.body.mass * league.drive.thrust * league.dt  # [N s] of one that pushes at top speed
    match.robot_events["pushes"][0, 1:3] = 1
    match.robots["walk"]["forward"][0, 1:3] = league.drive.forward, 0.5 * league.drive.forward

    def impulse():
        return impulse_on(match.robots[0], match.robot_events[0], 4, k)

    put(match, 2, -1.2, 0.4, 0.0, forward=0.5 * league.drive.forward)  # pushes somebody far away
    assert impulse() == pytest.approx(most)
    x = float(match.robots["x"][0, 4])
    put(match, 2, x + NOSES, 0.4, pi, forward=0.5 * league.drive.forward)
    assert impulse() == pytest.approx(1.5 * most)
    match.robot_events["pushes"][0, 2] = 0
    assert impulse() == pytest.approx(most)
    match.robots["team"][0, 1] = 1
    assert impulse() == 0.0


def test_who_stands_beside_a_push_does_not_fall_and_nobody_does_with_the_switch_off():
    match = shoved(1e6)
    place(match, robots={5: (0.5, 0.68, 0.5 * pi)})
    play(match, actions=asks(match, r1=1.0), steps=16)
    assert match.robots["fallen"][0, 4] > 0.0 and match.robots["fallen"][0, 5] == 0.0
    match = shoved(100.0, fall_time=6.0, rules="falling=False,keeper_pushing=True")  # pushes are seen all the same
    assert fouls(match, asks(match, r1=1.0), 3.0) == [] and (match.robots["fallen"] == 0.0).all()
    match.robots["fallen"][0, 4] = 0.5  # it has lain for 5.5 s
    assert fouls(match, stand(match), 1.0 / 16.0) == [] and match.robots["active"][0, 4] == 1


@pytest.mark.parametrize(("down", "guilty"), [(5.0, []), (6.0, [4])])
def test_who_lies_for_more_than_five_seconds_is_put_on_the_halfway_line_at_once(down, guilty):
    match = shoved(0.0, down)
    match.robots["fallen"][0, 4] = down
    found = fouls(match, stand(match), 7.0)
    assert [row for _, row, _ in found] == guilty
    assert all(foul == Foul.FALLEN and second == 5.0 + 1 / 16 for second, _, foul in found)
    robot = match.robots[0, 4]
    assert robot["active"] == 1 and robot["fallen"] == 0.0 and (robot["x"] == 0.0) == bool(guilty)
