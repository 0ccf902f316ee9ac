"""What poses cost whose white lines and goals lie elsewhere than the robot sees them."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env.belief.omni import field_lines as kernels
from soccer_env.belief.omni.field_lines import LINE_VIEW
from soccer_env.belief.omni.lines import line_tables
from soccer_env.belief.particles import PARTICLE
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.perception.omni.sense import OMNI_SENSOR_STATE, sense_slice
from soccer_env.perception.sensing import SensorArrays, SensorNumbers
from soccer_env.random_numbers import start_streams
from soccer_env.records.beliefs import OWN_POSE
from soccer_env.records.percepts import OMNI_PERCEPT
from soccer_env.records.world import World
from soccer_env.types import NOISE_STREAMS

LEAGUE = find_league("middle-size-2006")
SENSORS = LEAGUE.sensors.changed({"line_miss": 0.0, "goal_miss": 0.0, "camera_delay": 0})
K, S, W, TABLES = constants_of(LEAGUE), SENSORS.record(), LEAGUE.memory.record(), line_tables(LEAGUE)
STAND_STILL = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
POSES = [(3.0, 2.0, 0.4), (-4.5, -1.0, 2.0), (0.5, -3.0, -2.8), (5.0, 3.3, 1.0)]


def seen_from(x: float, y: float, heading: float) -> np.ndarray:
    """Return the percept of a robot in the team frame that misses nothing."""
    world, percepts = World.empty(1, 1), np.zeros((1, 1), OMNI_PERCEPT)
    world.matches["home_direction"] = world.matches["handedness"] = 1.0
    robots = world.robots
    robots["x"], robots["y"], robots["heading"], robots["active"] = x, y, heading, 1
    sensing = SensorArrays(percepts, np.zeros((1, 1), OMNI_SENSOR_STATE), np.zeros((1, 1, 0), OMNI_PERCEPT))
    sense_slice(world, sensing, SensorNumbers(K, S, 0), np.zeros(1, bool), np.zeros(1, np.int64), 0, 1)
    return percepts[:, 0]


def look(percepts: np.ndarray, settings: np.ndarray = W, **own: float) -> tuple[np.ndarray, int]:
    view, pose = np.zeros(1, LINE_VIEW), np.zeros(1, OWN_POSE)
    for name, value in own.items():
        pose[name] = value
    return view, kernels.measure_lines_and_goals(percepts[0], pose[0], view[0], K[0], S[0], settings[0])


def cost_at(percepts: np.ndarray, x: float, y: float, heading: float) -> float:
    view, _ = look(percepts)
    particles, noise = np.zeros(1, PARTICLE), np.zeros(NOISE_STREAMS, np.uint64)
    particles["x"], particles["y"], particles["heading"] = x, y, heading
    kernels.weigh_particles_by_lines(particles, view[0], STAND_STILL, 6.5, 5.0, noise, 1.0, K[0], W[0], TABLES[0])
    return float(particles["weight"][0])


@pytest.mark.parametrize("pose", POSES)
def test_mh08_the_true_pose_costs_next_to_nothing_and_others_more(pose: tuple[float, float, float]) -> None:
    percepts, (x, y, heading) = seen_from(*pose), pose
    _, seen = look(percepts)
    assert seen >= 10
    true = cost_at(percepts, *pose)
    assert true < 0.1 * seen
    for other in ((x + 0.5, y, heading), (x, y - 0.5, heading), (x, y, heading + 0.3), (x, y, heading + np.pi)):
        assert cost_at(percepts, *other) > true + 2.0


@pytest.mark.parametrize("pose", POSES)
def test_mh08_goals_tell_a_pose_from_its_half_turn_which_lines_cannot(pose: tuple[float, float, float]) -> None:
    percepts, turned = seen_from(*pose), (-pose[0], -pose[1], pose[2] + np.pi)
    assert cost_at(percepts, *turned) > cost_at(percepts, *pose) + 6.0
    percepts["own_goal"]["seen"] = percepts["opponent_goal"]["seen"] = 0
    assert cost_at(percepts, *turned) == pytest.approx(cost_at(percepts, *pose), abs=0.01)


def test_line_points_lie_where_the_directions_say_from_the_front_counter_clockwise() -> None:
    percepts = seen_from(*POSES[0])
    percepts["lines"] = 0.0
    percepts["lines"][0, 6] = 2.0  # a quarter turn to the left, of 24 directions
    view, _ = look(percepts)
    point = view["points"][0, 0]
    assert view["count"][0] == 1
    assert (point["ahead"], point["left"]) == pytest.approx((0.0, 2.0), abs=1e-12)


def test_what_an_old_picture_shows_is_moved_by_the_motion_since() -> None:
    """At 2 m/s ahead and 3 rad/s, a line 2 m ahead is 1.96 m ahead 20 ms later, and 0.06 rad to the right."""
    percepts = seen_from(*POSES[0])
    percepts["lines"], percepts["age"] = 0.0, 0.02
    percepts["lines"][0, 0] = 2.0
    view, _ = look(percepts, forward=2.0, turn=3.0)
    point = view["points"][0, 0]
    assert np.hypot(point["ahead"], point["left"]) == pytest.approx(1.96, abs=1e-6)
    assert np.arctan2(point["left"], point["ahead"]) == pytest.approx(-0.06, abs=1e-6)
    raw, _ = look(percepts, replace(LEAGUE.memory, delay_compensation=False).record(), forward=2.0, turn=3.0)
    assert raw["points"]["ahead"][0, 0] == 2.0


def test_an_outlier_among_the_lines_costs_no_more_than_its_share_and_none_is_read_outside_the_table() -> None:
    percepts, pose = seen_from(*POSES[0]), POSES[0]
    true = cost_at(percepts, *pose)
    percepts["lines"][0, np.flatnonzero(percepts["lines"][0])[0]] *= 0.5
    assert cost_at(percepts, *pose) < true + 4.5
    percepts["lines"][0, :24] = 1e6
    assert np.isfinite(cost_at(percepts, 6.5, 5.0, 0.0))


def drawn(percepts: np.ndarray, count: int) -> np.ndarray:
    """Return fresh particles (count,)."""
    view, noise, particles = look(percepts)[0], np.zeros(NOISE_STREAMS, np.uint64), np.zeros(count, PARTICLE)
    start_streams(noise, 3, 0, 1)
    for i in range(count):
        kernels.draw_from_goal(particles[i], view[0], 6.5, 5.0, noise, 1.0, W[0])
    return particles


def test_fresh_particles_see_the_goal_as_the_robot_sees_it_and_lie_anywhere_on_the_field_without_one() -> None:
    percepts = seen_from(*POSES[0])
    percepts["lines"], percepts["own_goal"]["seen"] = 0.0, 0
    costs = [cost_at(percepts, *map(float, particle[["x", "y", "heading"]])) for particle in drawn(percepts, 200)]
    assert np.median(costs) < 0.5  # the bearing fits exactly, the range within its noise
    percepts["opponent_goal"]["seen"] = 0
    particles = drawn(percepts, 500)
    assert abs(particles["x"]).max() <= 6.5 and abs(particles["y"]).max() <= 5.0
    assert particles["x"].std() > 3.0 and particles["heading"].std() > 1.5
