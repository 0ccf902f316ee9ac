"""Falling over: from the impulse of a push, never in the league as it is; who lies for too long is carried away."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.referee.fouls.legged.falling import impulse_on
from soccer_env.types import Foul
from tests.scenes.fouls import NOSES, asks, face, fouls
from tests.scenes.staging import LEGGED, place, put, stage, stand


def shoved(fall, fall_time=3.0, matches=1, rules="falling=True"):
    """Return matches in which robot 1 stands before robot 4, which may fall."""
    league = find_league(LEGGED)
    league = replace(league, drive=replace(league.drive, fall=fall, fall_time=fall_time))
    match = stage(league, matches, 3, 3, rules=f"simple:dropped_ball=False,{rules}", ball=(0.0, -0.9))
    face(match, 1, 4, 0.3)
    match.rebuild()
    return match


def test_in_the_league_nobody_falls():
    match = shoved(find_league(LEGGED).drive.fall, matches=4)
    for _ in range(64):
        match.step(asks(match, r1=1.0))
        assert (match.robots["fallen"] == 0.0).all()


def test_who_is_pushed_falls_lies_still_and_gets_up_and_who_pushes_does_not():
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
    fallen = []
    for _ in range(16 * 3):
        match.step(asks(match, r1=1.0))
        fallen.append((match.robots["fallen"][:, 4] > 0.0).mean())
    league = match.league
    most = league.body.mass * league.drive.thrust * fall * 3.0  # [1] falls expected if it pushed all the time
    assert 0.3 * (1.0 - np.exp(-most)) < fallen[-1] < 1.0 - np.exp(-most)
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


def test_who_stands_beside_a_push_does_not_fall():
    match = shoved(1e6)
    place(match, robots={5: (0.5, 0.68, 0.5 * pi)})
    for _ in range(16):
        match.step(asks(match, r1=1.0))
    assert match.robots["fallen"][0, 4] > 0.0 and match.robots["fallen"][0, 5] == 0.0


def test_with_the_switch_off_nobody_falls():
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
