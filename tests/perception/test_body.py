"""What a robot feels of itself: the steps that it makes (not the ground that it covers), balance, its kicker."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.compiled import compiled
from soccer_env.leagues.omni_sensors import OmniSensors
from soccer_env.percept_types import BODY_PERCEPT
from soccer_env.perception.body import light_barrier
from soccer_env.types import ROBOT
from tests.scenes.staging import LEGGED, MIDDLE, WALK, asking, each_league, place, play, put, stage, stand, steady
from tests.scenes.symmetry import Records, assert_same, mirrored, mirrored_percepts, swapped_rows, turned

EXACT = {"odometry_noise": 0.0}
SINGLE = 1e-6  # [m, rad] a percept is no finer


def feeling(league: Any, matches: int = 1, home: int = 1, away: int = 1, **settings: Any) -> Match:
    """Return matches whose robots feel themselves, robot 0 in the middle and the ball far away."""
    match = stage(league, matches, home, away, observe="percepts", **settings)
    put(match, 0, 0.0, 0.0)
    place(match, ball=(-0.4 * match.league.pitch.length, -0.4 * match.league.pitch.width))
    return match


def body(match: Match) -> np.ndarray:
    """Return what robot 0 of each match feels."""
    return match.percepts["body"][:, 0]


def travelled(match: Match, actions: np.ndarray, steps: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the displacement ahead [m] by odometry and in truth, robot 0 of each match, after some steps."""
    felt, start = np.zeros(match.count), match.robots["x"][:, 0].copy()
    for _ in range(steps):
        match.step(actions)
        felt += body(match)["forward"]
    return felt, match.robots["x"][:, 0] - start


@each_league
def test_on_firm_ground_the_odometry_is_the_path(name: str) -> None:
    match = feeling(steady(name), sensors=EXACT)
    felt, true = travelled(match, asking(match, forward=1.0), 40)
    assert true[0] > 0.1
    assert felt == pytest.approx(true, rel=1e-5)


@each_league
def test_a_turning_walk_adds_up_to_the_pose(name: str) -> None:
    match = feeling(steady(name), sensors=EXACT)
    x, y, heading = 0.0, 0.0, 0.0
    for _ in range(48):
        match.step(asking(match, forward=0.2, left=-0.2, turn=0.1))
        one = body(match)[0]
        x += np.cos(heading) * one["forward"] - np.sin(heading) * one["left"]
        y += np.sin(heading) * one["forward"] + np.cos(heading) * one["left"]
        heading += one["turn"]
    robot = match.robots[0, 0]
    assert (x, y) == pytest.approx((robot["x"], robot["y"]), abs=2e-4)  # wheels slide a little as they start
    assert np.cos(heading - robot["heading"]) == pytest.approx(1.0, abs=1e-10)


@each_league
def test_a_stuck_robot_feels_that_it_walks(name: str) -> None:
    match = feeling(steady(name), sensors=EXACT)
    edge = match.league.pitch.length / 2 + match.league.pitch.band_end
    put(match, 0, edge - match.league.body.reach, 0.4 * match.league.pitch.width)  # its nose at the boards
    match.rebuild()
    felt, true = travelled(match, asking(match, forward=1.0), 4 * match.league.control_rate)
    assert felt > 0.8 * 3.0 * match.league.drive.forward
    assert abs(true) < 0.2 * felt


def test_slip_is_not_felt() -> None:
    match = feeling(LEGGED, 40, sensors=EXACT)
    felt, true = travelled(match, asking(match, forward=1.0), 64)
    assert np.ptp(felt) < 1e-6
    assert true.std() > 0.01 * true.mean()


@each_league
def test_odometry_errs_in_proportion_to_the_step(name: str) -> None:
    match = feeling(steady(name), 40, sensors={"odometry_noise": 0.05})
    found, actions = [], asking(match, forward=0.6, left=0.3, turn=0.5)
    for _ in range(30):
        match.step(actions)  # until everybody walks
    for _ in range(30):
        match.step(actions)
        walk = match.robots["walk"][:, 0]
        found.append([body(match)[part] / (walk[part] * match.league.dt) for part in WALK])
    felt = np.array(found)
    assert felt.mean(axis=(0, 2)) == pytest.approx(1.0, abs=0.01)
    assert felt.std(axis=(0, 2)) == pytest.approx(0.05, rel=0.1)


@each_league
def test_a_standing_robot_feels_no_step(name: str) -> None:
    match = feeling(name, 50)
    for _ in range(10):
        match.step(stand(match))
        assert not any(body(match)[part].any() for part in WALK)


def test_ms06_a_robot_feels_whether_it_lies_on_its_side() -> None:
    """MS06: an accelerometer that tells upright from lying."""
    match = feeling(LEGGED)
    match.step(stand(match))
    assert (body(match)["upright"], body(match)["kicked"]) == (1, 0)
    match.robots["fallen"][:, 0] = 1.0
    match.step(stand(match))
    assert body(match)["upright"] == 0
    play(match, steps=16)
    assert body(match)["upright"] == 1


def test_a_kick_is_felt_in_the_frame_in_which_it_hits() -> None:
    match = feeling(MIDDLE, home=2)
    place(match, ball=(0.18 + 0.11, 0.0), robots={1: (0.0, 0.0), 0: (-3.0, 1.0)})
    match.step(stand(match))
    match.step(asking(match, 1, kick=1.0))
    assert match.percepts["body"]["kicked"][0].tolist() == [0, 1, 0]
    match.step(stand(match))
    assert match.percepts["body"]["kicked"][0].tolist() == [0, 0, 0]


@compiled
def break_barriers(robots, bodies, sensors):  # type: ignore[no-untyped-def]
    for i in range(robots.shape[0]):
        light_barrier(robots[i], bodies[i], sensors[0])


@pytest.mark.parametrize("has_ball", [0, 1])
def test_the_light_barrier_errs_in_its_share_of_the_frames(has_ball: int) -> None:
    robots, bodies = np.zeros(20_000, ROBOT), np.zeros(20_000, BODY_PERCEPT)
    robots["has_ball"], robots["noise"] = has_ball, np.arange(20_000)[:, None] * 7919 + 1
    break_barriers(robots, bodies, OmniSensors(barrier_miss=0.01).record())
    assert (bodies["held"] != has_ball).mean() == pytest.approx(0.01, abs=0.003)
    break_barriers(robots, bodies, OmniSensors(barrier_miss=0.0).record())
    assert (bodies["held"] == has_ball).all()


@each_league
def test_a_robot_that_is_out_knows_it(name: str) -> None:
    match = feeling(name, home=2)
    match.step(stand(match))
    assert match.percepts["body"]["active"][0].tolist() == [1, 0, 0]
    assert (match.percepts["body"]["frame"] == match.matches["step"][0]).all()


# Symmetry


def walking(league: str) -> Match:
    """Return matches in which everybody walks and turns somewhere."""
    match = Match(league, home=2, away=2, matches=3, seed=4, observe="percepts")
    rng = np.random.default_rng(6)
    robots = match.robots
    robots["x"], robots["y"] = rng.uniform(-1, 1, (3, 4)), rng.uniform(-0.8, 0.8, (3, 4))
    robots["heading"] = rng.uniform(-np.pi, np.pi, (3, 4))
    for part in WALK:
        robots["walk"][part] = rng.uniform(-0.3, 0.3, (3, 4))
    robots["placed"][1] = 1
    return match


def felt_by(match: Match, frames: int = 3) -> np.ndarray:
    """Return what robots feel when they begin to, and a few frames later; nothing moves in between."""
    for m in range(match.count):
        match.batch.senses.start(m)
    for _ in range(frames):
        match.batch.senses.sense(0, match.count)
    return match.percepts.copy()


@each_league
def test_a_mirror_shows_mirrored_feelings(name: str) -> None:
    match, image = walking(name), walking(name)
    mirrored(Records.of(match)).put_into(image)
    lines = getattr(match.league.sensors, "lines", 0)
    assert_same(mirrored_percepts(felt_by(match), lines)["body"], felt_by(image)["body"], 0.0)


@each_league
def test_a_half_turn_with_the_teams_swapped_changes_no_feeling(name: str) -> None:
    match, image = walking(name), walking(name)
    turned(Records.of(match)).put_into(image)
    assert_same(swapped_rows(felt_by(match))["body"], felt_by(image)["body"], SINGLE)
