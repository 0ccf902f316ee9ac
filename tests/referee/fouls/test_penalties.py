"""Robots that are taken out for 30 s and come back at the halfway line."""

from math import pi

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.types import Phase
from tests.scenes.fouls import NOSES, asks, court, face, fouls, rows
from tests.scenes.staging import LEGGED, deepest_overlaps, place, put, put_ball, stage, stand

RULE = "pushing=True,pardon=True"
STEP = 1.0 / 16.0
PARKED = 50.0  # [m]


def penalised(r=1, ball=-0.88, matches=1, rules=RULE, **settings):
    """Return matches in which robot r has just been taken out for pushing, and its actions."""
    match = court(rules, matches, **settings)
    face(match, r, (r + 3) % 6, 0.3)
    put_ball(match, 0.0, ball)
    match.robots["pushing"][:, r] = 2.9
    match.rebuild()
    actions = asks(match, **{f"r{r}": 1.0})
    for _ in range(60):
        match.step(actions)
        if match.robot_events["foul"][0, r]:
            return match, actions
    raise AssertionError("no whistle")


def back_after(match, actions, r=1, seconds=31.0):
    """Return after how many seconds robot r comes back, or None."""
    for step in range(round(seconds / STEP)):
        match.step(actions)
        if match.robot_events["returned"][0, r]:
            return (step + 1) * STEP
    return None


def soon_back(r=1, **settings):
    """Return a match in which the time out of robot r is over in two steps."""
    match = court(RULE, **settings)
    match.robots["penalty"][0, r] = 0.1
    return match


@pytest.mark.parametrize(("r", "ball"), [(1, -0.88), (4, 0.88)])
def test_it_is_parked_for_30_s_and_comes_back_at_the_halfway_line_away_from_the_ball(r, ball):
    match, actions = penalised(r, ball)
    assert match.robots["x"][0, r] >= PARKED and match.robots["placed"][0, r] == 0
    assert back_after(match, actions, r) == 30.0
    robot, side = match.robots[0, r], -np.sign(ball)
    assert robot["x"] == 0.0 and robot["active"] == 1 and robot["placed"] == 1 and robot["penalty"] == 0.0
    edge = match.league.pitch.width / 2 - abs(robot["y"])
    assert np.sign(robot["y"]) == side and 0.23 < edge < 0.26  # beside the ramp
    assert robot["heading"] == pytest.approx(-side * pi / 2) and robot["vx"] == robot["vy"] == 0.0


def test_out_it_does_not_move_touch_or_push_and_where_somebody_stands_it_comes_back_beside():
    match, actions = penalised()
    for _ in range(40):
        match.step(actions)
        assert match.robots["x"][0, 1] == PARKED + 2.0 and match.robots["vx"][0, 1] == 0.0
        assert match.robot_events["touch"][0, 1] == match.robot_events["collision"][0, 1] == 0
    assert match.robots["penalty"][0, 1] == 27.5
    match, other = soon_back(), soon_back(4)
    line = match.league.pitch.width / 2 - 0.2
    place(match, robots={5: (0.0, line, 0.0), 4: (1.0, 0.0, 0.0), 2: (-0.35, line, 0.0)})
    assert back_after(match, stand(match)) == 2 * STEP
    assert -1.0 < match.robots["x"][0, 1] < -0.5 and match.robots["y"][0, 1] > 0.7
    assert deepest_overlaps(match)["robot robot"] == 0.0
    place(other, ball=(0.0, -0.001), robots={1: (0.0, line, 0.0)})
    assert back_after(other, stand(other), 4) == 2 * STEP and other.robots["x"][0, 4] > 0.25


@pytest.mark.parametrize(("r", "ball", "hand", "side"), [
    (1, -0.88, 1.0, 1.0), (1, 0.88, 1.0, -1.0), (4, -0.88, 1.0, 1.0), (4, 0.88, 1.0, -1.0), (1, 0.0, 1.0, 1.0),
    (4, 0.0, 1.0, -1.0), (1, 0.0, -1.0, -1.0), (4, 0.0, -1.0, 1.0),
])  # fmt: skip
def test_it_comes_back_away_from_the_ball_and_if_that_lies_in_the_middle_on_its_left(r, ball, hand, side):
    match = soon_back(r)
    match.matches["handedness"] = hand
    put_ball(match, 0.4, ball)
    match.rebuild()
    assert back_after(match, stand(match), r, 1.0) == 2 * STEP
    robot = match.robots[0, r]
    assert robot["x"] == 0.0 and np.sign(robot["y"]) == side and robot["heading"] == pytest.approx(-side * pi / 2)


@pytest.mark.parametrize(("ball", "near", "far"), [(0.9, 0.0, 0.0), (0.0, -0.35, -0.2)])
def test_with_no_room_on_that_side_it_comes_back_on_the_other_clear_of_the_ball(ball, near, far):
    match = stage(LEGGED, 1, 11, 11, rules=f"simple:dropped_ball=False,{RULE}")
    match.robots["penalty"][0, 8] = 0.1
    line = match.league.pitch.width / 2 - 0.2
    place(match, ball=(ball, -0.8), robots={1 + index: (-1.3 + 0.25 * index, line, 0.0) for index in range(6)})
    assert back_after(match, stand(match), 8, 1.0) == 0.125
    assert match.robots["y"][0, 8] < -0.7 and near <= match.robots["x"][0, 8] <= far


def test_kick_off_and_half_time_end_penalties_a_dropped_ball_does_not_nor_anything_without_pardon():
    match, actions = penalised()
    put_ball(match, 1.53, 0.0, 0.5)
    match.rebuild()
    for _ in range(8):
        match.step(actions)
        if match.events["restart"][0] == Phase.KICK_OFF:
            break
    robot = match.robots[0, 1]
    assert match.robot_events["returned"][0, 1] == 1 and robot["active"] == 1 and robot["penalty"] == 0.0
    assert -1.5 < robot["x"] < 0.0 and robot["placed"] == 1
    assert deepest_overlaps(match)["robot robot"] == 0.0
    match, actions = penalised()
    match.matches["half_length"] = match.matches["clock"] + 1.0
    assert back_after(match, actions, seconds=2.0) == 1.0 and match.matches["home_direction"][0] == -1.0
    match, actions = penalised()
    match.batch.constants["rules_dropped_ball"] = 1
    match.matches["still_x"], match.matches["still_y"] = match.balls["x"], match.balls["y"]
    match.matches["still_clock"] = match.league.rules.stuck_time - STEP
    assert back_after(match, stand(match), seconds=STEP) is None and match.events["restart"][0] == Phase.DROP_BALL
    assert back_after(match, stand(match), seconds=29.0) is None
    match, actions = penalised(rules="pushing=True")
    match.matches["half_length"] = match.matches["clock"] + 1.0
    assert back_after(match, stand(match), seconds=1.0) is None and match.events["half_time"][0] == 1
    match.matches["half_length"] = np.inf
    assert back_after(match, stand(match)) == 29.0


def test_a_whole_team_may_be_out_and_come_back_and_padding_never_comes_on():
    match = court(RULE)
    match.robots["penalty"][0, 3:] = [5.0, 5.0, 6.0]
    place(match, robots={0: (-1.2, 0.0)})
    fouls(match, stand(match), 4.9)
    assert match.robots["active"][0, 3:].sum() == 0
    fouls(match, stand(match), 1.2)
    assert match.robots["active"][0, 3:].sum() == 3 and deepest_overlaps(match)["robot robot"] == 0.0
    padded = Match(LEGGED, home=2, away=2, max_players=4, seed=3, rules="league")
    padded.robots["penalty"][0, 1], padded.robots["active"][0, 1] = 0.5, 0
    fouls(padded, np.zeros((1, 8, 4)), 2.0)
    assert padded.robots["active"][0].tolist() == [1, 1, 0, 0, 1, 1, 0, 0]


@pytest.mark.parametrize("kick_clock", [0.3, -0.3])
def test_a_robot_that_is_taken_out_while_it_kicks_forgets_the_kick(kick_clock):
    match = court(RULE)
    face(match, 1, 4, 0.3)
    match.robots["pushing"][0, 1] = 3.0
    match.robots["walk"]["forward"][0, 1] = match.robots["target"]["forward"][0, 1] = 0.12
    match.robots["kick_clock"][0, 1] = kick_clock
    match.rebuild()
    assert rows(fouls(match, asks(match, r1=1.0), 0.2)) == [1]
    assert match.robots["kick_clock"][0, 1] == 0.0 and match.robots["active"][0, 1] == 0


def test_removal_time_zero_puts_it_back_at_once_and_legs_that_were_caught_come_free():
    match, _ = penalised(rules=f"{RULE},removal_time=0")
    assert match.robots["active"][0, 1] == 1 and match.robots["x"][0, 1] == 0.0
    assert match.robot_events["returned"][0, 1] == 1
    match = court(RULE)
    put(match, 1, 0.3, 0.4, 0.0)
    put(match, 4, 0.3 + NOSES - 0.05, 0.4 + 0.05, pi)  # a paw between the other's forepaws
    match.robots["pushing"][0, 1] = 3.2
    match.robots["walk"]["forward"][0, 1] = match.robots["target"]["forward"][0, 1] = 0.12
    match.rebuild()
    match.robots["caught_by"][0, 4] = 2
    match.robots["gait_phase"][0] = 1
    found = fouls(match, asks(match, r1=1.0), STEP)
    assert rows(found) == [1] and (match.robots["caught_by"] == 0).all()
    fouls(match, stand(match), 1.0)
    assert abs(match.robots["x"][0, 4] - 0.3 - NOSES) < 0.1 and abs(match.robots["vx"][0, 4]) < 0.05
