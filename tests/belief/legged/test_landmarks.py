"""What poses cost that see the landmarks and goals of a legged field elsewhere than the robot sees them."""

import numpy as np
import pytest

from soccer_env.belief.legged import landmarks as kernels
from soccer_env.belief.legged.landmarks import LANDMARK_VIEW
from soccer_env.belief.particles import PARTICLE
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.random_numbers import start_streams
from soccer_env.records.percepts import LEGGED_PERCEPT
from soccer_env.types import NOISE_STREAMS, ROBOT
from tests.scenes.pose_worlds import see_from

LEAGUE = find_league("legged-2001")
SENSORS = LEAGUE.sensors.changed({"dither": 0.0, "landmark_miss": 0.0, "resolution": "176x144"})
K, S, W = constants_of(LEAGUE), SENSORS.record(), LEAGUE.memory.record()
STAND_STILL = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
MIDDLE = (0.0, 0.0)


def seen_from(x: float, y: float, heading: float, pan: float = 0.0) -> np.ndarray:
    """Return the percept of a robot in the team frame, without noise."""
    robots, percepts = np.zeros(1, ROBOT), np.zeros(1, LEGGED_PERCEPT)
    robots["x"], robots["y"], robots["heading"], robots["active"] = x, y, heading, 1
    percepts["pan"], percepts["body"]["upright"] = pan, 1
    see_from(robots, percepts, K, S)
    return percepts


def look(percepts: np.ndarray) -> tuple[np.ndarray, int]:
    view = np.zeros(1, LANDMARK_VIEW)
    return view, kernels.measure_landmarks(percepts[0], view[0], K[0], S[0], W[0])


def cost_at(percepts: np.ndarray, x: float, y: float, heading: float) -> float:
    view, _ = look(percepts)
    particles, noise = np.zeros(1, PARTICLE), np.zeros(NOISE_STREAMS, np.uint64)
    particles["x"], particles["y"], particles["heading"] = x, y, heading
    kernels.weigh_particles_by_landmarks(particles, view[0], STAND_STILL, noise, 1.0, K[0], W[0])
    return float(particles["weight"][0])


def test_a_robot_that_looks_at_the_opponents_left_corner_sees_landmark_4_there() -> None:
    percepts = seen_from(0.0, 0.0, np.arctan2(1.0, 1.5))
    assert np.flatnonzero(percepts["landmarks"]["area"][0]).tolist() == [4]
    view, _ = look(percepts)
    sight = view["sights"][0, 0]
    assert (sight["x"], sight["y"]) == (1.55, 1.05)  # a cylinder of 0.1 m just outside the corner
    assert np.arctan2(sight["left"], sight["ahead"]) == pytest.approx(0.0, abs=0.02)
    assert sight["far"] == pytest.approx(np.hypot(1.55, 1.05) - view["camera_x"][0], rel=0.03)


@pytest.mark.parametrize("pan", [-1.2, 0.0, 0.7])
@pytest.mark.parametrize("pose", [(0.3, 0.2, 0.1), (-1.0, -0.5, 2.5), (1.2, 0.7, -2.0)])
def test_mh08_the_true_pose_costs_next_to_nothing_and_others_more(pose: tuple[float, float, float], pan: float) -> None:
    percepts = seen_from(*pose, pan)
    _, seen = look(percepts)
    assert seen > 0
    x, y, heading = pose
    true = cost_at(percepts, x, y, heading)
    assert true < 0.1 * seen
    assert cost_at(percepts, x, y, heading + 0.3) > true + 1.0
    assert cost_at(percepts, x, y, heading + np.pi) > true + 2.0
    assert cost_at(percepts, -x, -y, heading + np.pi) > true + 1.0  # the half-turned pose


def test_mh08_a_landmark_cut_by_the_upper_edge_gives_a_bearing_but_no_range_and_one_cut_by_a_side_nothing() -> None:
    upright = seen_from(0.5, 0.0, np.arctan2(1.0, 1.0))
    whole, numbers = look(upright)
    percepts = upright.copy()
    percepts["landmarks"]["high"][0, 4] = 72  # the upper edge at 176x144
    cut, fewer = look(percepts)
    assert fewer == numbers - 1
    assert whole["sights"]["far"][0, 0] > 0.0 and cut["sights"]["far"][0, 0] == 0.0
    percepts = upright.copy()
    percepts["landmarks"]["left"][0, 4] = 88  # the left edge
    assert look(percepts)[0]["count"][0] == 0
    upright["body"]["upright"] = 0
    assert look(upright)[1] == 0, "a robot that lies on its side sees nothing to go by"


def test_a_pose_from_which_the_goal_would_end_before_its_visible_end_costs_much() -> None:
    """Beyond a post there is nothing of a goal; before it something may hide the rest, or part it."""
    percepts = seen_from(0.0, 0.0, 0.0)
    goal = percepts["opponent_goal"][0, 0]
    assert goal["area"] > 0
    true, width = cost_at(percepts, *MIDDLE, 0.0), goal["left"] - goal["right"]
    half_hidden, too_wide, parted = percepts.copy(), percepts.copy(), percepts.copy()
    half_hidden["opponent_goal"]["left"][0, 0] -= width // 2
    too_wide["opponent_goal"]["left"][0, 0] += width // 2
    hidden, impossible = cost_at(half_hidden, *MIDDLE, 0.0) - true, cost_at(too_wide, *MIDDLE, 0.0) - true
    assert 0.3 < hidden < 1.0 < 1.5 < impossible
    pieces = parted["opponent_goal"][0]
    pieces[1] = pieces[0]
    pieces[0]["right"], pieces[1]["left"] = 3, -3
    assert cost_at(parted, *MIDDLE, 0.0) == true


def test_an_end_of_a_goal_at_the_images_border_says_only_that_the_post_lies_beyond() -> None:
    percepts = seen_from(0.0, 0.0, 0.0)
    percepts["opponent_goal"]["right"][0, 0] = 0
    open_end = cost_at(percepts, *MIDDLE, 0.0)
    percepts = seen_from(0.0, 0.0, 0.0, pan=0.6)  # 34 degrees to the left of it
    assert percepts["opponent_goal"]["right"][0, 0] == -88
    assert cost_at(percepts, *MIDDLE, 0.0) < 0.1 < open_end


def test_fresh_particles_see_what_the_robot_sees() -> None:
    percepts = seen_from(0.3, 0.2, 0.6)
    view, seen = look(percepts)
    assert seen >= 2
    noise = np.zeros(NOISE_STREAMS, np.uint64)
    start_streams(noise, 3, 0, 1)
    fresh, anywhere = [], []
    for i in range(200):
        particles = np.zeros(1, PARTICLE)
        kernels.draw_from_landmark(particles[0], view[0], noise, 1.0, K[0], W[0])
        fresh.append(cost_at(percepts, *(float(particles[name][0]) for name in ("x", "y", "heading"))))
        angle = 2.4 * i
        anywhere.append(cost_at(percepts, 1.4 * np.cos(angle), 0.9 * np.sin(3.0 * angle), 5.0 * angle))
    assert np.median(fresh) < 0.5 * np.median(anywhere)
