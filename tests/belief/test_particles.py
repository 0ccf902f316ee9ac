"""Particles: how they are moved, weighed, kept and drawn anew, and what pose is read from them; and the odometry."""

import numpy as np
import pytest

from soccer_env.belief import particles as kernels
from soccer_env.belief.odometry import move_point
from soccer_env.belief.own_pose import POSE_MEMORY
from soccer_env.belief.particles import PARTICLE
from soccer_env.leagues.legged_sensors import LeggedMemory
from soccer_env.random_numbers import start_streams
from soccer_env.records.beliefs import OWN_POSE
from soccer_env.types import NOISE_STREAMS

W = LeggedMemory().record()[0]


def noise_of(seed: int = 1) -> np.ndarray:
    noise = np.zeros(NOISE_STREAMS, np.uint64)
    start_streams(noise, seed, 0, 1)
    return noise


def set_of(x: object, y: object = 0.0, heading: object = 0.0, weight: object = 1.0, count: int = 96) -> np.ndarray:
    particles = np.zeros(count, PARTICLE)
    for name, value in (("x", x), ("y", y), ("heading", heading), ("weight", weight)):
        particles[name] = value
    return particles


def pose_at(x: float, y: float, heading: float) -> np.ndarray:
    own = np.zeros(1, OWN_POSE)
    own["x"], own["y"], own["heading"] = x, y, heading
    return own


def test_a_draw_has_mean_0_and_deviation_1_and_an_outlier_costs_no_more_than_half_the_bound() -> None:
    noise = noise_of()
    found = np.array([kernels.draw_triangular(noise) for _ in range(20_000)])
    assert found.mean() == pytest.approx(0.0, abs=0.03) and found.std() == pytest.approx(1.0, abs=0.02)
    assert abs(found).max() < 2.5
    assert kernels.bounded_cost(0.01, 9.0) == pytest.approx(0.005, rel=0.01)  # as a normal distribution would have it
    assert kernels.bounded_cost(9.0, 9.0) == pytest.approx(2.25)
    assert kernels.bounded_cost(1e12, 9.0) == pytest.approx(4.5)


def test_particles_are_placed_as_widely_as_robots_and_move_as_the_odometry_says_in_the_axes_at_its_end() -> None:
    particles = set_of(0.0, count=4000)
    kernels.place_particles(particles, pose_at(1.0, -0.5, 3.1)[0], 0.03, 0.05, noise_of(), 1.0)
    assert particles["x"].mean() == pytest.approx(1.0, abs=0.003)
    assert particles["x"].std() == pytest.approx(0.03, rel=0.05)
    assert np.angle(np.exp(1j * (particles["heading"] - 3.1))).std() == pytest.approx(0.05, rel=0.05)
    assert abs(particles["heading"]).max() <= np.float32(np.pi)
    particle = set_of(1.0, 0.5, np.pi / 2, count=1)
    turned = np.pi / 2 + 0.2
    kernels.move_particles(particle, (0.1, 0.05, 0.2, 0.0, 0.0, 0.0), 9.0, 9.0, noise_of(), 1.0)
    x, y = 1.0 + 0.1 * np.cos(turned) - 0.05 * np.sin(turned), 0.5 + 0.1 * np.sin(turned) + 0.05 * np.cos(turned)
    assert particle.tolist()[0] == pytest.approx((x, y, turned, 1.0), abs=1e-6)
    kernels.move_particles(particles, (0.0, 0.0, 0.0, 0.04, 0.2, 0.0), 9.0, 9.0, noise_of(), 1.0)
    assert particles["y"].std() == pytest.approx(np.hypot(0.03, 0.04), rel=0.05)
    assert np.angle(np.exp(1j * (particles["heading"] - 3.1))).std() == pytest.approx(np.hypot(0.05, 0.2), rel=0.05)


def test_a_share_of_the_particles_stays_behind_in_case_the_robot_is_held_and_none_leaves_the_field() -> None:
    particles, far = set_of(0.0, count=4000), set_of(1.4)
    kernels.move_particles(particles, (0.1, 0.0, 0.0, 0.0, 0.0, 0.25), 9.0, 9.0, noise_of(), 1.0)
    assert (particles["x"] == 0.0).mean() == pytest.approx(0.25, abs=0.03)
    for _ in range(50):
        kernels.move_particles(far, (0.5, 0.5, 1.0, 0.5, 1.0, 0.0), 1.5, 1.0, noise_of(), 1.0)
    assert abs(far["x"]).max() <= 1.5 and abs(far["y"]).max() <= 1.0


def test_costs_become_weights_of_which_the_best_is_1_however_large_the_costs_are() -> None:
    particles = set_of(0.0, weight=np.linspace(500.0, 600.0, 96))
    total, mean, best = kernels.weights_from_costs(particles)
    assert best == 0 and particles["weight"][0] == 1.0
    assert mean == pytest.approx(550.0)
    assert total == pytest.approx(particles["weight"].sum(), rel=1e-6)


def test_mh08_resampling_keeps_each_particle_as_often_as_its_weight_deserves() -> None:
    weight = np.repeat([0.0, 1.0, 3.0], 32)
    particles, equal = set_of(np.arange(96), weight=weight), set_of(np.arange(96))
    kernels.resample(particles, 128.0, 96, noise_of())
    copies = np.bincount(particles["x"].astype(int), minlength=96)
    assert (abs(copies - 96 * weight / 128.0) < 1.0).all()  # systematic: within one of what is due
    assert (particles["weight"] == 1.0).all()
    kernels.resample(equal, 96.0, 96, noise_of())
    assert (equal["x"] == np.arange(96)).all()


@pytest.mark.parametrize("kept", [0, 1, 40, 95])
def test_particles_that_are_to_be_drawn_anew_are_marked_by_weight_0(kept: int) -> None:
    particles = set_of(np.arange(96), weight=np.random.default_rng(2).random(96))
    kernels.resample(particles, float(particles["weight"].astype(float).sum()), kept, noise_of())
    assert (particles["weight"] == 0.0).sum() == 96 - kept


def test_mh08_of_two_clusters_the_pose_is_in_one_and_not_between_them() -> None:
    particles = set_of(np.where(np.arange(96) < 48, 1.0, -1.0))
    own = pose_at(0.9, 0.0, 0.1)
    weight, spread = kernels.estimate_pose(particles, own[0], 96.0, 95, W)
    assert own["x"][0] == pytest.approx(1.0) and own["heading"][0] == pytest.approx(0.0)
    assert weight == 48.0 and spread == 0.0


def test_mh08_the_pose_jumps_to_another_cluster_only_if_that_is_clearly_heavier() -> None:
    for others, at in ((50, 1.0), (80, -1.0)):
        particles = set_of(np.where(np.arange(96) < 96 - others, 1.0, -1.0))
        own = pose_at(1.0, 0.0, 0.0)
        kernels.estimate_pose(particles, own[0], 96.0, 95, W)
        assert own["x"][0] == at


def test_the_pose_does_not_jump_about_in_a_cloud_and_headings_are_averaged_across_the_half_turn() -> None:
    spread = np.linspace(-1.4, 1.4, 96)
    cloud = set_of(spread, 0.9 * np.sin(40.0 * spread), 3.0 * np.cos(70.0 * spread))
    own = pose_at(0.0, 5.0, 0.0)  # where there is no particle at all
    kernels.estimate_pose(cloud, own[0], 96.0, 95, W)
    assert (own["x"][0], own["y"][0]) == (0.0, 5.0)
    own = pose_at(0.0, 0.0, 3.0)
    kernels.estimate_pose(set_of(0.0, heading=np.where(np.arange(96) % 2 == 0, 3.1, -3.1)), own[0], 96.0, 0, W)
    assert abs(own["heading"][0]) == pytest.approx(np.pi, abs=1e-6)


def test_mh08_more_particles_are_drawn_anew_the_worse_they_fit() -> None:
    memory = np.zeros(1, POSE_MEMORY)
    memory["fast"] = memory["slow"] = 0.9
    shares = [kernels.share_to_redraw(memory[0], 0.9, W) for _ in range(20)]
    assert shares == pytest.approx([W["pose_fresh"]] * 20)
    shares = [kernels.share_to_redraw(memory[0], 0.05, W) for _ in range(20)]
    assert (np.diff(shares) >= 0.0).all() and shares[-1] == kernels.SHARE_MOST


def test_a_pose_that_is_drawn_from_a_thing_sees_it_as_it_is_seen() -> None:
    """A camera 0.1 m ahead and 0.02 m to the left of the robot's middle sees a thing at (1.5, 1) 0.8 m away."""
    noise, bearing = noise_of(), 0.4
    sight = (1.5, 1.0, np.cos(bearing), np.sin(bearing), 0.8, 0.0, 0.1, 0.02)
    for _ in range(100):
        particle = set_of(0.0, count=1)
        kernels.draw_from_sighting(particle[0], sight, 9.0, 9.0, noise, 1.0)
        x, y, heading = (float(particle[name][0]) for name in ("x", "y", "heading"))
        cosine, sine = np.cos(heading), np.sin(heading)
        away_x, away_y = 1.5 - (x + 0.1 * cosine - 0.02 * sine), 1.0 - (y + 0.1 * sine + 0.02 * cosine)
        assert np.hypot(away_x, away_y) == pytest.approx(0.8, abs=1e-5)
        seen = np.arctan2(cosine * away_y - sine * away_x, cosine * away_x + sine * away_y)
        assert seen == pytest.approx(bearing, abs=1e-5)


def test_a_thing_is_nearer_after_a_step_ahead_on_the_right_after_a_turn_to_the_left_and_motions_add_up() -> None:
    assert move_point(1.0, 0.2, 0.3, 0.0, 0.0) == (0.7, 0.2)
    assert move_point(1.0, 0.0, 0.0, 0.0, np.pi / 2) == pytest.approx((0.0, -1.0), abs=1e-15)
    assert move_point(1.0, 0.5, 1.0, 0.0, np.pi / 2) == pytest.approx((0.5, 0.0), abs=1e-15)
    x, y = move_point(0.9, 0.4, 0.1, -0.05, 0.3)
    ahead, left = 0.1 + np.cos(0.3) * 0.2 - np.sin(0.3) * 0.1, -0.05 + np.sin(0.3) * 0.2 + np.cos(0.3) * 0.1
    assert move_point(x, y, 0.2, 0.1, -0.7) == pytest.approx(move_point(0.9, 0.4, ahead, left, -0.4), abs=1e-15)
    assert move_point(0.9, -0.4, 0.1, 0.05, -0.3) == (x, -y)
