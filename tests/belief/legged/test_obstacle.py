"""What a legged robot makes of a reading of its ranger that no player in memory accounts for.  [Sacks 2001, 4.3.3]"""

from collections.abc import Iterator
from math import atan2, cos, hypot, inf, pi, sin
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.belief.legged.obstacle import believe_obstacle
from soccer_env.compiled import compiled
from soccer_env.optics.head_camera import camera_place
from soccer_env.records.beliefs import BELIEF
from tests.belief.legged.staged_players import LEAGUE, Onlooker
from tests.scenes.staging import LEGGED, put, put_ball, stage
from tests.scenes.symmetry import assert_same, mirrored_beliefs, mirrored_percepts

CHEST = 0.105  # [m] ahead of a body's middle
SHARP = {"infrared_noise": 0.0, "infrared_growth": 0.0, "infrared_pointing": 0.0}


@compiled
def believe(percepts, beliefs, tracks, constants, sensors, settings):
    """Call the stage as its caller does, for some robots: percepts (N,), tracks (N, slots)."""
    for n in range(percepts.shape[0]):
        believe_obstacle(percepts[n], beliefs[n], tracks[n], constants[0], sensors[0], settings[0])


class Ranger(Onlooker):
    """An Onlooker that believes in obstacles too."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        self.beliefs = np.zeros(1, BELIEF)

    def believe(self, percepts: np.ndarray) -> None:
        """Believe a percept (1,) as it is."""
        super().believe(percepts)
        believe(percepts, self.beliefs, self.tracks, self.constants, self.sensors, self.settings)

    def measure(self, reading: float, **frame: Any) -> tuple[float, float]:
        """Believe a frame in which the ranger reads so much [m]; return distance and bearing of the obstacle."""
        self.look(**frame, infrared=reading)
        found = self.beliefs["obstacle"][0]
        return float(found["distance"]), float(found["bearing"])

    def aim(self, reading: float, height: float, pan: float = 0.0) -> None:
        """Turn the head so that a beam as long as the reading [m] ends at a height [m]."""
        tilts = np.linspace(0.6, -1.4, 20001)
        s = LEAGUE.sensors
        ends = s.neck_height + s.camera_up * np.cos(tilts) + (s.camera_ahead + reading) * np.sin(tilts)
        self.pan, self.tilt = pan, float(tilts[np.abs(ends - height).argmin()])

    def middle(self, reading: float) -> tuple[float, float]:
        """Return distance [m] and bearing [rad] of a body whose chest the beam meets."""
        ahead, left, _ = camera_place(self.pan, self.tilt, self.sensors[0])
        away = reading * cos(self.tilt) + CHEST
        x, y = ahead + away * cos(self.pan), left + away * sin(self.pan)
        return hypot(x, y), atan2(y, x)


def remember(robot: Ranger, *distances: float) -> None:
    """Let a robot know of players so far away, straight ahead, team-mates first."""
    robot.tracks["present"] = 0
    for slot, distance in enumerate(distances):
        track = robot.tracks[0, slot]
        track["present"], track["distance"], track["x"] = 1 if distance < inf else 0, distance, min(distance, 1e3)
        track["age"] = 0.1


def test_ms49_a_reading_much_closer_than_every_player_is_an_obstacle() -> None:
    robot, without = Ranger(), Ranger(obstacle=False)
    for pan, reading in ((0.0, 0.15), (0.8, 0.25), (-1.3, 0.39)):
        for one in (robot, without):
            one.aim(reading, 0.15, pan)
            remember(one, inf, inf, 1.6)
        assert robot.measure(reading) == pytest.approx(robot.middle(reading), abs=1e-6)
        assert robot.tracks["distance"][0, 2] == 1.6
        assert without.measure(reading) == (0.0, 0.0)


def test_ms49_the_reading_must_be_significantly_closer_than_every_player() -> None:
    """MS49: closer than two thirds of the distance of the nearest player of either team, from camera to surface."""
    robot = Ranger()
    robot.aim(0.25, 0.15)
    found, _ = robot.middle(0.25)
    reading = 0.25 * cos(robot.tilt)
    behind = found - reading  # [m] camera and half a body, which no reading counts
    for factor, there in ((1.49, False), (1.51, True)):
        for near in range(5):
            distances = [3.0] * 5
            distances[near] = behind + factor * reading
            remember(robot, *distances)
            assert (robot.measure(0.25)[0] > 0.0) is there
    remember(robot)
    assert robot.measure(0.25)[0] == pytest.approx(found)  # nobody is known
    robot.settings["obstacle_share"] = 0.5
    remember(robot, behind + 1.9 * reading)
    assert robot.measure(0.25) == (0.0, 0.0)


def test_ms49_ball_boards_and_carpet_are_no_obstacles() -> None:
    """MS49: what the beam meets lies more than 2 cm above boards of 10 cm, or above the ball where they are lower."""
    for boards, lowest in ((0.10, 0.12), (0.02, 0.104)):
        robot = Ranger()
        robot.sensors["board_height"] = boards
        for reading in (0.1, 0.2, 0.39):
            for height in (0.0, 0.05, lowest - 0.002, lowest + 0.002, 0.18):
                robot.aim(reading, height, 0.4)
                assert (robot.measure(reading)[0] > 0.0) is (height > lowest)


def test_only_a_reading_within_the_reliable_range_is_believed_by_a_robot_that_stands() -> None:
    robot = Ranger()
    for reading, there in ((0.1, True), (0.399, True), (0.401, False), (0.9, False), (0.0, False)):
        robot.aim(max(reading, 0.1), 0.15)
        assert (robot.measure(reading)[0] > 0.0) is there
    robot.aim(0.2, 0.15)
    for body in ({}, {"upright": 0}, {"active": 0}):
        assert (robot.measure(0.2, **body) != (0.0, 0.0)) is (not body)


def test_a_mirrored_robot_believes_in_a_mirrored_obstacle_and_percepts_beyond_all_measure_break_nothing() -> None:
    robot, image, rng, believed = Ranger(), Ranger(), np.random.default_rng(3), 0
    for _ in range(400):
        robot.pan, robot.tilt = rng.uniform(-1.56, 1.56), rng.uniform(-0.5, 0.5)
        remember(robot, rng.uniform(0.2, 2.0))
        image.tracks[:] = robot.tracks
        percepts = robot.percept([], [], infrared=rng.uniform(0.1, 0.5))
        robot.believe(percepts)
        image.believe(mirrored_percepts(percepts))
        assert_same(mirrored_beliefs(robot.beliefs), image.beliefs, 0.0)
        believed += int(robot.beliefs["obstacle"]["distance"][0] > 0.0)
    assert believed > 50
    robot, rng = Ranger(), np.random.default_rng(4)
    numbers = [0.0, -0.0, 1e-30, 0.1, 0.4, -1.0, pi, 1e6, -1e6, 3e38, -3e38, inf, -inf, np.nan]
    with np.errstate(invalid="ignore", over="ignore"):
        for _ in range(2000):
            percepts = robot.percept([], [])
            percepts["infrared"] = rng.choice(numbers)
            percepts["pan"], percepts["tilt"] = rng.choice(numbers[:11], 2)
            percepts["body"]["active"], percepts["body"]["upright"] = rng.integers(0, 2, 2)
            robot.tracks["present"] = rng.integers(0, 2, 5)
            robot.tracks["distance"] = rng.choice([0.0, 0.2, 1e6, inf], 5)
            robot.believe(percepts)
            found = robot.beliefs["obstacle"][0]
            assert np.isfinite(found["distance"]) and found["distance"] >= 0.0
            assert abs(found["bearing"]) <= pi + 1e-6


def facing(matches: int, distance: Any, view: Any = 0.0, **settings: Any) -> Match:
    """Return matches in which home's robot stands in the middle and away's faces it so far away [m], head level."""
    match = stage(LEGGED, matches=matches, observe="belief", actions="full", **settings)
    put(match, 0, 0.0, 0.0)
    put(match, 1, distance, 0.0, pi - view)
    put_ball(match, -1.4, 0.9)
    match.rebuild()
    return match


def stare(match: Match, seconds: float, tilt: float) -> Iterator[None]:
    """Let robot 0 look at the trunk ahead of it, robot 1 hold its head at a tilt [rad]; yield after every frame."""
    head, s = match.league.head, match.league.sensors
    actions = np.zeros((match.count, 2, 7))
    actions[..., 4] = 1.0
    for _ in range(round(seconds * match.league.control_rate)):
        away = match.robots["x"][:, 1] - CHEST - s.neck_ahead
        actions[:, 0, 6] = -np.arctan2(s.neck_height - 0.15, away) - np.arcsin(s.camera_up / away)
        actions[:, 1, 6] = tilt
        actions[..., 6] = (2.0 * actions[..., 6] - head.tilt_high - head.tilt_low) / (head.tilt_high - head.tilt_low)
        match.step(actions)
        yield


def come_near(**memory: Any) -> tuple[Match, np.ndarray, np.ndarray, np.ndarray]:
    """Let a player that was seen 1 m away be 0.45 to 0.6 m away the next moment, its head down.

    Return the match, the true distance, that of the nearest track and that of the obstacle (T, M) [m].
    """
    match = facing(24, 1.0, np.linspace(-0.4, 0.4, 24), memory=memory)
    for _ in stare(match, 1.0, 0.0):
        pass
    match.robots["x"][:, 1] = np.tile(np.linspace(0.45, 0.6, 4), 6)
    match.robots["y"][:, 1], match.robots["tilt"][:, 1] = 0.0, -1.0
    match.rebuild()
    rows: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    for _ in stare(match, 1.5, -1.0):
        slots = match.tracks[:, 0]
        nearest = np.where(slots["present"] == 1, slots["distance"], inf).min(axis=1)
        apart = np.hypot(*(match.robots[name][:, 1] - match.robots[name][:, 0] for name in ("x", "y")))
        rows.append((apart, nearest, match.beliefs["obstacle"]["distance"][:, 0].astype(float)))
    true, tracked, found = np.moveaxis(np.array(rows[16:]), 0, 1)  # once the heads have come to rest
    return match, true, tracked, found


def test_ms49_a_player_with_its_head_down_that_seems_far_away_is_an_obstacle() -> None:
    """MS49: its jersey is hidden, so that memory knows of it far away at best; the ranger tells where it is."""
    _, true, tracked, found = come_near()
    lost, there = tracked > 1.5 * true + 0.1, found > 0.0
    assert lost.mean() > 0.3  # a dangerous thing not to know
    assert there[lost].mean() > 0.9
    short = (true - found)[there]  # by as much as a lowered head is before the chest
    assert short.max() < 0.12 and short.min() > -0.05 and short.mean() == pytest.approx(0.067, abs=0.02)
    match, _, _, found = come_near(obstacle=False)
    assert not found.any() and not match.beliefs["obstacle"]["bearing"].any()


def test_nobody_without_a_ranger_and_nobody_who_knows_the_truth_has_an_obstacle() -> None:
    for league, senses in ((LEGGED, "ideal"), ("middle-size-2006", "sensors"), ("middle-size-2006", "ideal")):
        match = Match(league, home=2, away=2, seed=1, observe="belief", senses=senses)
        match.beliefs["obstacle"]["distance"] = 0.3
        match.step(np.zeros((1, 4, 4)))
        assert not match.beliefs["obstacle"]["distance"].any()
        assert any(name.startswith("obstacle") for name in match.observation_names) is (league == LEGGED)
