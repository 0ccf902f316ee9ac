"""What a legged robot remembers of other players: what its own steps, time and other sightings do to it."""

from math import pi

import numpy as np
import pytest

from soccer_env.belief.odometry import move_point
from soccer_env.records.beliefs import TRACK
from tests.belief.legged.staged_players import AHEAD, LEFT, RIGHT, Onlooker, full_blob, near, places

# What happens to what is remembered


def test_ms36_players_in_memory_are_moved_by_own_steps() -> None:
    robot, still = Onlooker(), Onlooker(player_odometry=False)
    for one in (robot, still):
        one.look([one.show(*LEFT)], [one.show(*RIGHT)])
    start = np.array(places(robot.tracks[0]))
    expected = [tuple(place) for place in start]
    for _ in range(48):
        for one in (robot, still):
            one.look(forward=0.0075, left=-0.002, turn=0.04)
        expected = [move_point(*place, 0.0075, -0.002, 0.04) for place in expected]
    assert np.array(places(robot.tracks[0])) == pytest.approx(np.array(expected), abs=1e-7)
    assert np.hypot(*(np.array(expected) - start).T).min() > 1.0
    assert places(still.tracks[0]) == [tuple(place) for place in start]
    used = robot.tracks[robot.tracks["present"] == 1]
    assert used["distance"] == pytest.approx(np.hypot(used["x"], used["y"]))
    assert used["bearing"] == pytest.approx(np.arctan2(used["y"], used["x"]))


def test_ms03_trust_in_a_player_fades_while_it_is_not_seen() -> None:
    robot = Onlooker()
    opponent = robot.opponents[0:1]
    robot.look([robot.show(*AHEAD)])
    robot.wait(3.0)
    assert (opponent["confidence"][0], opponent["age"][0]) == pytest.approx((70.0, 3.0))
    robot.wait(9.0)
    assert (opponent["confidence"][0], opponent["present"][0]) == (0.0, 1)
    robot.look([robot.show(*AHEAD)])
    assert (opponent["confidence"][0], opponent["age"][0]) == (100.0, 0.0)
    robot.settings["fading"] = 0.0
    robot.wait(3.0)
    assert opponent["confidence"][0] == 100.0


def test_what_has_not_been_seen_for_long_is_forgotten_and_a_robot_that_was_carried_forgets_all() -> None:
    robot = Onlooker(ghost_time=5.0)
    robot.look([robot.show(*AHEAD)], [robot.show(*LEFT)])
    robot.wait(4.9)
    assert robot.tracks["present"].sum() == 2
    robot.wait(0.2)
    assert robot.tracks["present"].sum() == 0
    empty = np.zeros((1, 5), TRACK)
    empty["number"][0, [0, 2]] = -1
    assert robot.tracks.tobytes() == empty.tobytes()
    robot = Onlooker()
    robot.look([robot.show(*LEFT)], [robot.show(*AHEAD)])
    robot.look([robot.show(*RIGHT)], pose=2)
    assert places(robot.tracks[0]) == [near(RIGHT)]
    robot.look(pose=1)
    assert places(robot.tracks[0]) == [near(RIGHT)]


@pytest.mark.parametrize("body", [{"upright": 0}, {"active": 0}])
def test_a_robot_that_is_down_or_out_does_not_look(body: dict[str, int]) -> None:
    robot = Onlooker()
    robot.look([robot.show(*LEFT)])
    robot.look([robot.show(*RIGHT)], **body)
    assert places(robot.opponents) == [near(LEFT)]
    assert robot.opponents["age"][0] == robot.dt and robot.memories["opponents"][0] == 0


def test_a_ghost_pushes_a_real_player_out_of_a_full_memory_and_a_missed_one_costs_it_nothing() -> None:
    robot = Onlooker()
    for pan in (-1.2, 0.0, 1.2):
        robot.pan = pan
        robot.look([robot.show(*move_point(0.9, 0.0, 0.0, 0.0, -pan))])
    robot.pan = 0.0
    robot.look([robot.show(0.9, 0.0), full_blob(25.0, 15.0, 2)])
    lost = [bearing for bearing in (-1.2, 0.0, 1.2) if np.abs(robot.opponents["bearing"] - bearing).min() > 0.1]
    assert len(places(robot.opponents)) == 3 and len(lost) == 1 and lost != [0.0]
    robot = Onlooker()
    robot.look([robot.show(*LEFT), robot.show(*RIGHT)])
    before = places(robot.opponents)
    robot.look([robot.show(*LEFT)])
    assert places(robot.opponents) == before


def test_one_player_alone_leaves_the_other_slots_empty_under_the_final_rule_alone() -> None:
    used = {}
    for powers in ((1.0, 0.0), (3.0, 1.0)):
        robot, rng = Onlooker(distance_power=powers[0], angle_power=powers[1]), np.random.default_rng(3)
        for _ in range(160):
            robot.look([robot.show(1.0 + 0.08 * rng.standard_normal(), 0.005 * rng.standard_normal())])
        used[powers] = len(places(robot.opponents))
    assert used == {(1.0, 0.0): 3, (3.0, 1.0): 1}


@pytest.mark.parametrize("mode", ["largest", "combined"])
@pytest.mark.parametrize("slots", ["all", "nearest"])
def test_blobs_of_no_size_or_of_the_whole_picture_break_nothing(mode: str, slots: str) -> None:
    robot = Onlooker(player_blob=mode, slots=slots)
    point, whole = (3, 3, 2, 2, 1), (44, -44, 36, -36, 6336)
    for tilt in (-1.5, 0.0, 0.75):
        robot.tilt = tilt
        robot.look([point, point, whole, (44, -44, 300, -300, 32767)], [point], infrared=0.1, turn=pi)
        robot.look([whole], [whole], infrared=0.39, forward=-2.0)
    assert finite(robot) and len(places(robot.tracks[0])) >= 2


def finite(robot: Onlooker) -> bool:
    """Tell whether every number of the tracks is finite."""
    return all(np.isfinite(robot.tracks[name]).all() for name in TRACK.names or ())
