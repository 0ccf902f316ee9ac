"""From commands to motion: delay, gait steps, acceleration, top speeds, slip, and what a base cannot do."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.scenes.leagues import LEGGED, MIDDLE, each_league, endless, steady
from tests.scenes.staging import place, play, put, record_each_step, robot_actions, speed, stage, stand, steps_in

DIFFERENTIAL = "middle-size-2006-differential"


def on_its_own(league, matches=1, **settings):
    """Return matches with robot 0 at rest in the middle, the ball far away and nobody else."""
    match = stage(league, matches, **settings)
    put(match, 0, 0.0, 0.0)
    place(match, ball=(-0.4 * match.league.pitch.length, -0.4 * match.league.pitch.width))
    return match


def walked(match: Match, actions: np.ndarray, steps: int) -> np.ndarray:
    """Return the speed ahead of robot 0 of the first match after each step."""
    vx, vy, heading = record_each_step(
        match, lambda: [match.robots[n][0, 0] for n in ("vx", "vy", "heading")], 0.0, actions, steps
    ).T
    return np.cos(heading) * vx + np.sin(heading) * vy


@pytest.mark.parametrize(("name", "steps"), [("legged-2001-smooth", 2), (MIDDLE, 5)])
def test_a_command_moves_the_robot_a_tenth_of_a_second_later_to_the_control_step(name, steps):
    league = replace(steady(name), drive=replace(steady(name).drive, gait_steps=1))
    assert league.delay_steps == steps
    speeds = walked(on_its_own(league), robot_actions(on_its_own(league), forward=1.0), steps + 1)
    assert (speeds[:steps] == 0.0).all() and speeds[steps] > 0.0


@pytest.mark.parametrize("delay", [0.0, 0.06, 0.14, 0.2])
def test_the_delay_is_a_setting(delay):
    league = replace(steady(MIDDLE), drive=replace(steady(MIDDLE).drive, delay=delay))
    speeds = walked(on_its_own(league), robot_actions(on_its_own(league), forward=1.0), 12)
    assert np.argmax(speeds > 0.0) == round(50 * delay)


def test_a_legged_robot_takes_a_new_command_only_when_its_gait_step_of_8_control_steps_ends():
    match = on_its_own(steady(LEGGED))
    targets = targets_of(match, 40)
    changes = np.flatnonzero(np.diff(targets) != 0.0) + 1
    np.testing.assert_array_equal(changes, [8, 16, 24, 32])
    # what it takes was asked for two control steps before
    np.testing.assert_allclose(targets[changes], 0.12 * (changes - 2 + 1) / 40.0)
    for phase in (*range(1, 8), 0):
        match.step(stand(match))
        assert match.robots["gait_phase"][0, 0] == phase


def targets_of(match: Match, steps: int) -> np.ndarray:
    """Return the speeds ahead [m/s] that robot 0 goes for, asked for another one at every step."""
    found = []
    for step in range(steps):
        match.step(robot_actions(match, forward=(step + 1) / steps))
        found.append(match.robots["target"]["forward"][0, 0])
    return np.array(found)


def test_gait_steps_are_even_even_if_slip_is_drawn_at_other_times():
    """A trap: a slip of 12 control steps used to cut every second gait step of 8 short."""
    league = find_league(LEGGED)
    targets = targets_of(on_its_own(replace(league, drive=replace(league.drive, slip_time=0.75))), 48)
    np.testing.assert_array_equal(np.flatnonzero(np.diff(targets)) + 1, [8, 16, 24, 32, 40])


def test_wheels_follow_at_every_control_step_and_reach_2_6_m_per_s_after_0_65_s():
    np.testing.assert_allclose(targets_of(on_its_own(steady(MIDDLE)), 20)[5:], 2.6 * np.arange(1, 16) / 20.0)
    match = on_its_own(steady(MIDDLE))
    speeds = walked(match, robot_actions(match, forward=1.0), 60)
    delay, top = 5, 2.6
    expected = np.minimum(4.0 * 0.02 * np.maximum(np.arange(60) + 1 - delay, 0), top)
    np.testing.assert_allclose(speeds, expected, atol=1e-9)
    assert np.argmax(speeds > top - 1e-9) + 1 - delay == np.ceil(0.65 / 0.02)


@each_league
def test_no_robot_gains_or_loses_speed_faster_than_it_can(name):
    league = steady(name)
    match = on_its_own(league, 50, seed=3)
    rng = np.random.default_rng(0)
    for _ in range(steps_in(match, 3.0)):
        before = match.robots[:, 0].copy()
        match.step(rng.uniform(-1.0, 1.0, (50, 2, 4)))
        after = match.robots[:, 0]
        change = np.hypot(after["vx"] - before["vx"], after["vy"] - before["vy"])
        stands = ~np.any([after["walk"][axis] for axis in ("forward", "left", "turn")], axis=0)
        most = np.where(stands, league.drive.traction, league.drive.thrust)
        assert (change <= most * league.dt + 1e-9).all()
        walk = np.hypot(*(after["walk"][axis] - before["walk"][axis] for axis in ("forward", "left")))
        assert (walk <= league.drive.acceleration * league.dt + 1e-9).all()
        turn = abs(after["omega"] - before["omega"])
        assert (turn <= league.drive.turn_acceleration * league.dt + 1e-9).all()


@pytest.mark.parametrize(("name", "command", "expected"), [
    (LEGGED, (1.0, 0.0), 0.12), (LEGGED, (-1.0, 0.0), 0.10), (LEGGED, (0.0, 1.0), 0.08), (LEGGED, (0.0, -0.5), 0.04),
    (MIDDLE, (0.0, -1.0), 2.6), (MIDDLE, (0.6, 0.8), 2.6), (MIDDLE, (1.0, 1.0), 2.6), (DIFFERENTIAL, (1.0, 0.0), 1.6),
    (DIFFERENTIAL, (1.0, 1.0), 1.6),
])  # fmt: skip
def test_robots_walk_at_the_speed_that_is_asked_of_them(name, command, expected):
    match = on_its_own(steady(name))
    actions = robot_actions(match, forward=command[0], left=command[1])
    play(match, 1.5, actions)
    assert speed(match.robots)[0, 0] == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(("name", "rate"), [(LEGGED, 0.8), (MIDDLE, 6.0)])
def test_robots_turn_at_their_top_rate_and_no_faster(name, rate):
    match = on_its_own(steady(name))
    for _ in range(steps_in(match, 2.0)):
        match.step(robot_actions(match, turn=1.0))
        assert match.robots["omega"][0, 0] <= rate + 1e-9
    assert match.robots["omega"][0, 0] == pytest.approx(rate)


def test_a_turn_counter_clockwise_is_positive_left_is_to_the_left_and_a_differential_base_cannot_move_there():
    match = on_its_own(steady(MIDDLE), 2)
    play(match, actions=robot_actions(match, turn=[0.2, 0.0], left=[0.0, 0.5]), steps=25)
    assert match.robots["heading"][0, 0] > 0.1 and match.robots["heading"][1, 0] == 0.0
    assert match.robots["y"][1, 0] > 0.1 and abs(match.robots["x"][1, 0]) < 1e-9
    match = on_its_own(find_league(DIFFERENTIAL), 20)
    match.robots["heading"][:, 0] = np.linspace(-3.0, 3.0, 20)
    match.rebuild()
    play(match, actions=robot_actions(match, left=1.0), steps=100)
    assert not speed(match.robots)[:, 0].any()
    aside = 0.0
    for _ in range(100):  # in a curve, ground holds the wheels against the side
        match.step(robot_actions(match, forward=0.5, left=1.0, turn=0.1))
        robot = match.robots[:, 0]
        aside = max(aside, abs(np.cos(robot["heading"]) * robot["vy"] - np.sin(robot["heading"]) * robot["vx"]).max())
    assert aside < 0.02


def test_a_differential_base_never_exceeds_2_m_per_s2_nor_10_rad_per_s2():
    """A trap: a slip that is drawn anew used to jerk the base at twice its limit, the traction of standing wheels.

    Straight ahead and back, or turning on the spot, with commands that change at random and slip.
    """
    league = endless(DIFFERENTIAL)
    assert (league.drive.acceleration, league.drive.turn_acceleration) == (2.0, 10.0)
    assert (league.drive.thrust, league.drive.turn_thrust) == (2.0, 10.0)
    match = on_its_own(replace(league, drive=replace(league.drive, slip=0.1)), 40, seed=3)
    rng = np.random.default_rng(0)
    drives, change, spin = np.arange(40) % 2 == 0, np.zeros(40), np.zeros(40)
    for step in range(steps_in(match, 8.0)):
        if step % 30 == 0:
            command = rng.choice([-1.0, -0.3, 0.0, 0.5, 1.0], 40)
            actions = robot_actions(match, forward=np.where(drives, command, 0.0), turn=np.where(drives, 0.0, command))
        before = match.robots[:, 0].copy()
        match.step(actions)
        after = match.robots[:, 0]
        change = np.maximum(change, np.hypot(after["vx"] - before["vx"], after["vy"] - before["vy"]))
        spin = np.maximum(spin, abs(after["omega"] - before["omega"]))
    assert change.max() <= 2.0 * league.dt + 1e-9 and spin.max() <= 10.0 * league.dt + 1e-9
    assert change.max() > 1.99 * league.dt and spin.max() > 9.9 * league.dt


@pytest.mark.parametrize(("name", "slip"), [(LEGGED, 0.08), (MIDDLE, 0.02)])
def test_a_walk_misses_its_speed_by_the_leagues_slip(name, slip):
    matches = 300
    match = on_its_own(name, matches, home=1, away=1)
    v = []
    for step in range(steps_in(match, 4.0)):
        match.step(robot_actions(match, forward=0.5))
        if step >= steps_in(match, 1.5):
            v.append(speed(match.robots)[:, 0].copy())
    asked = 0.5 * match.league.drive.forward
    ratio = np.array(v)[:: steps_in(match, 0.5)] / asked  # one of each draw
    assert ratio.size == 5 * matches
    assert ratio.mean() == pytest.approx(1.0, abs=4.0 * slip / np.sqrt(ratio.size))
    assert ratio.std() == pytest.approx(slip, rel=4.0 / np.sqrt(2.0 * ratio.size))


@pytest.mark.parametrize("name", [LEGGED, MIDDLE])
def test_slip_holds_for_half_a_second_and_then_is_drawn_anew(name):
    match = on_its_own(name)
    drawn = record_each_step(
        match, lambda: match.robots["slip"]["forward"][0, 0], 3.0, robot_actions(match, forward=1.0)
    )
    assert len(np.unique(drawn)) == 6
    assert (np.diff(np.flatnonzero(np.diff(drawn))) == steps_in(match, 0.5)).all()


@each_league
def test_nobody_is_faster_than_top_speed_times_slip_and_who_is_told_nothing_or_is_out_stands_still(name):
    match = on_its_own(endless(name), 100, seed=5)
    rng = np.random.default_rng(1)
    drive = match.league.drive
    greatest = np.ones(100)
    commands = rng.uniform(-1.0, 1.0, (8, 100, 2, 4))
    for step in range(steps_in(match, 4.0)):
        match.step(commands[step * 8 // steps_in(match, 4.0)])
        slip = match.robots["slip"][:, 0]
        greatest = np.maximum(greatest, np.maximum(slip["forward"], slip["left"]))
        assert (speed(match.robots)[:, 0] <= drive.forward * greatest + 1e-9).all()
    match, out = on_its_own(name, 5), stage(name, 4, robots={1: (0.5, 0.5)})
    for one, actions in ((match, None), (out, robot_actions(out, forward=1.0, left=1.0, turn=1.0, kick=1.0))):
        before = one.robots[:, 0].copy()
        play(one, actions=actions, steps=100)
        for axis in ("x", "y", "heading", "vx", "vy", "omega"):
            np.testing.assert_array_equal(one.robots[axis][:, 0], before[axis])
    assert not out.robot_events["kick"].any()
