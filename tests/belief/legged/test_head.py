"""The head keeps the believed ball at the centre of the picture, and searches when there is none."""

from math import cos, inf, pi, sin
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.belief.legged.head import FAR_TILT, HEAD_MEMORY, NEAR_TILT, choose_gaze
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.optics.head_camera import camera_place
from soccer_env.records.beliefs import BELIEF
from soccer_env.records.percepts import LEGGED_PERCEPT
from soccer_env.types import GAZE
from tests.belief.legged.staged_ball import Watcher
from tests.scenes.projection import pixel_of_direction
from tests.scenes.staging import LEGGED, robot_actions, stage, steady

LEAGUE = find_league(LEGGED)
RADIUS = LEAGUE.ball.radius
CENTRED = 3.0 * pi / 180.0  # [rad] from the optical axis that counts as the image's centre
PERIOD = LEAGUE.memory.search_period
SENSORS = np.rec.array(LEAGUE.sensors.record())[0]


@compiled
def choose(percepts, beliefs, height, memories, gazes, constants, sensors, settings):  # type: ignore[no-untyped-def]
    for i in range(beliefs.shape[0]):
        choose_gaze(percepts[i], beliefs[i], height, memories[i], gazes[i], constants[0], sensors[0], settings[0])


class Head:
    """The head of one robot with a belief that the test sets: distance [m], bearing [rad], age [s] of the ball."""

    def __init__(
        self, *ball: float, age: float = 0.0, confidence: float = 100.0, hand: float = 1.0, **memory: float
    ) -> None:
        self.percepts, self.beliefs = np.zeros(1, LEGGED_PERCEPT), np.zeros(1, BELIEF)
        self.memories, self.gazes = np.zeros(1, HEAD_MEMORY), np.zeros(1, GAZE)
        self.percepts["body"]["handedness"] = hand
        self.settings = LEAGUE.memory.changed(memory).record()
        self.height = RADIUS  # [m] of the line of sight to the blob at the ball's believed distance
        if ball:
            self.believe(*ball, age=age, confidence=confidence)

    def believe(self, distance: float, bearing: float, age: float = 0.0, confidence: float = 100.0) -> None:
        for name, value in (("distance", distance), ("bearing", bearing), ("age", age), ("confidence", confidence)):
            self.beliefs["ball"][name] = value

    def gaze(self) -> tuple[float, float]:
        """Return the pan and tilt of the next frame [rad]."""
        robot = self.percepts, self.beliefs, self.height, self.memories, self.gazes
        choose(*robot, constants_of(LEAGUE), LEAGUE.sensors.record(), self.settings)
        return float(self.gazes["pan"][0]), float(self.gazes["tilt"][0])

    def sweep(self, seconds: float) -> np.ndarray:
        """Return the gazes (frames, 2) of a head that goes on as it is."""
        return np.array([self.gaze() for _ in range(round(seconds * LEAGUE.control_rate))])


def from_camera(pan: float, tilt: float, x: float, y: float) -> np.ndarray:
    """Return where a ball at a place in the robot's frame [m] is from the camera (3,) [m]."""
    return np.array([x, y, RADIUS]) - camera_place(pan, tilt, SENSORS)


def off_centre(pan: float, tilt: float, x: float, y: float) -> float:
    """Return the angle [rad] between the optical axis and a ball at a place in the robot's frame [m]."""
    to = from_camera(pan, tilt, x, y)
    axis = np.array([cos(tilt) * cos(pan), cos(tilt) * sin(pan), sin(tilt)])
    return float(np.arccos(np.clip(np.dot(axis, to) / np.linalg.norm(to), -1.0, 1.0)))


@pytest.mark.parametrize("bearing", [0.0, 0.5, -1.1])
@pytest.mark.parametrize("distance", [0.2, 0.35, 0.8, 2.5])
def test_ms07_the_believed_ball_is_put_at_the_centre_of_the_picture(distance: float, bearing: float) -> None:
    head = Head(distance, bearing)
    pan, tilt = head.gaze()
    x, y = distance * cos(bearing), distance * sin(bearing)
    assert off_centre(pan, tilt, x, y) == pytest.approx(0.0, abs=1e-7)
    to = from_camera(pan, tilt, x, y)
    direction = np.arctan2(to[1], to[0]), np.arctan2(to[2], np.hypot(to[0], to[1]))
    u, v, inside = pixel_of_direction(*direction, pan, tilt, SENSORS)
    assert (u, v) == pytest.approx((0.0, 0.0), abs=1e-6) and inside == 1


@pytest.mark.parametrize(("distance", "bearing"), [(0.5, 3.0), (0.5, -2.0), (0.0, 0.0), (0.02, 1.0), (1e6, 0.3)])
def test_the_gaze_stays_within_the_joint_limits(distance: float, bearing: float) -> None:
    limits, (pan, tilt) = LEAGUE.head, Head(distance, bearing).gaze()
    assert abs(pan) <= limits.pan_limit and limits.tilt_low <= tilt <= limits.tilt_high


def test_ms07_a_ball_that_was_seen_a_moment_ago_is_still_looked_at() -> None:
    head = Head(0.6, 0.4, age=0.9, confidence=91.0)
    head.height = 0.3  # of the line along which it was seen: where it lies now only the ground tells
    assert off_centre(*head.gaze(), 0.6 * cos(0.4), 0.6 * sin(0.4)) < 1e-6


@pytest.mark.parametrize("share", [(1.0, 1.0), (0.4, 0.4), (0.2, 0.2)])
@pytest.mark.parametrize(("x", "y"), [(0.35, 0.0), (0.5, -0.2), (0.7, 0.4)])
def test_ms07_a_blob_comes_to_the_middle_of_the_picture_however_far_it_seems(x, y, share) -> None:
    """MS07: a ball of which a fifth is seen in width and height seems five times as far away; its blob is centred."""
    head, eye = Head(), Watcher(averaged=1, infrared_override=False, under_head=False)
    for _ in range(4):  # the camera moves with the head, so that the first turn only comes near
        eye.see(x, y, share=share)
        head.believe(eye.ball["distance"], eye.ball["bearing"])
        head.height = float(eye.memories["height"][0])
        eye.head = head.gaze()
    u, v, *_ = eye.project(x, y)
    assert abs(u) < 0.01 * eye.focal[0] and abs(v) < 0.01 * eye.focal[1]  # half a degree
    assert eye.ball["distance"] > 0.9 * np.hypot(x, y) / share[0] * (1.0 if share[0] == 1.0 else 0.6)


@pytest.mark.parametrize("bearing", [0.3, -0.3, 2.9, -1e-9])
def test_ms07_the_search_begins_on_the_side_where_the_ball_was_believed(bearing: float) -> None:
    pans = Head(0.9, bearing, age=1.1, confidence=89.0).sweep(PERIOD)[:, 0]
    assert pans[0] == pytest.approx(np.sign(bearing) * LEAGUE.head.pan_limit)
    assert (np.diff(pans) * np.sign(bearing) < 0.0).all()
    assert pans[-1] == pytest.approx(-np.sign(bearing) * LEAGUE.head.pan_limit, rel=0.1)


def test_the_search_sweeps_near_and_far_ground_in_turn_without_a_jump() -> None:
    gazes = Head(0.9, 0.3, age=inf, confidence=50.0).sweep(4 * PERIOD)
    assert np.abs(np.diff(gazes[:, 0])).max() < 1.1 * 2 * LEAGUE.head.pan_limit / (PERIOD * LEAGUE.control_rate)
    tilts = gazes[:: round(PERIOD * LEAGUE.control_rate), 1]
    assert tilts == pytest.approx([FAR_TILT, NEAR_TILT, FAR_TILT, NEAR_TILT])
    assert np.ptp(gazes[:, 0]) == pytest.approx(2 * LEAGUE.head.pan_limit, rel=0.05)


def test_ms07_a_glimpse_of_a_patch_does_not_begin_the_search_again() -> None:
    head, steady = (Head(0.9, 0.3, age=2.0, confidence=80.0) for _ in range(2))
    for one in (head, steady):
        one.sweep(1.7 * PERIOD)
    head.believe(2.5, -0.6)  # one frame long
    head.gaze()
    head.believe(2.5, -0.6, age=0.3, confidence=97.0)
    assert head.gaze() == steady.gaze()  # on with the sweep at the feet, long before search_after


def test_a_robot_that_never_saw_the_ball_searches_and_its_mirror_image_the_other_way() -> None:
    one, other = Head(), Head(hand=-1.0)
    found, image = one.sweep(2.5 * PERIOD), other.sweep(2.5 * PERIOD)
    assert (image[:, 0] == -found[:, 0]).all() and (image[:, 1] == found[:, 1]).all()
    assert found[0, 0] == LEAGUE.head.pan_limit


def test_the_two_tilts_cover_all_ground_that_a_ball_may_lie_on_and_settings_say_when_they_are_searched() -> None:
    """One of the sweeps shows a fifth of a ball's height or more, from between the paws to the farthest corner."""
    half = 0.5 * LEAGUE.sensors.view_height
    between_paws = LEAGUE.body.front + RADIUS
    for distance in np.linspace(between_paws, 3.6, 300):
        seen = []
        for tilt in (NEAR_TILT, FAR_TILT):
            ahead, _, height = camera_place(0.0, tilt, SENSORS)
            down, level = RADIUS - height, distance - ahead
            off = abs(np.arctan2(down, level) - tilt)
            seen.append(off - np.arcsin(min(RADIUS / np.hypot(down, level), 1.0)) * 0.6 < half)
        assert any(seen), distance
    assert Head(0.9, 0.3, age=2.9, search_after=3.0).gaze()[0] < 0.5
    assert np.isfinite(Head(0.9, 0.3, search_after=0.0, search_period=0.0).sweep(1.0)).all()


def watch(match: Match, actions: Any, seconds: float) -> np.ndarray:
    """Return how far from the picture's centre [rad] the ball is in each frame; robot 0 believes in the true ball."""
    head, robot, ball = Head(), match.robots[0, 0:1], match.balls[0]
    match.batch.senses.believe = lambda first, last: None
    found = []
    for _ in range(round(seconds * match.league.control_rate)):
        x, y = ball["x"] - robot["x"][0], ball["y"] - robot["y"][0]
        cosine, sine = cos(robot["heading"][0]), sin(robot["heading"][0])
        ahead, left = cosine * x + sine * y, cosine * y - sine * x
        found.append(off_centre(robot["pan"][0], robot["tilt"][0], ahead, left))
        head.believe(float(np.hypot(ahead, left)), float(np.arctan2(left, ahead)))
        head.percepts["body"] = match.percepts["body"][0, 0]
        robot["gaze"]["pan"], robot["gaze"]["tilt"] = head.gaze()
        match.step(actions)
    return np.array(found)


def test_ms07_the_ball_stays_at_the_centre_of_the_picture_while_the_robot_walks() -> None:
    """MS07: the head follows at the speed of its joints; the beam on its axis meets the ball in most frames."""
    match = stage(steady(LEGGED), observe="belief", ball=(-0.5, -0.2), robots={0: (-1.0, -0.5, 0.2)})
    found = watch(match, robot_actions(match, forward=0.8, left=0.4, turn=0.15), 5.0)
    settled = found[8:]  # after half a second to find it
    assert (settled < CENTRED).mean() > 0.95
    assert np.median(settled) < 0.1 * CENTRED  # it leads by the robot's own motion, and does not lag behind


def test_the_head_leads_a_ball_that_lies_still_and_catches_one_aside_at_the_speed_of_its_joints() -> None:
    for distance, lead in ((0.5, True), (0.15, False)):
        head = Head(distance, 0.2)
        at_rest = head.gaze()
        head.percepts["body"]["turn"] = 0.05
        assert (head.gaze()[0] < at_rest[0]) == lead
    match = stage(steady(LEGGED), observe="belief", ball=(0.4, 0.6), robots={0: (0.0, 0.0)})
    found = watch(match, robot_actions(match), 1.0)
    frames = np.arctan2(0.6, 0.4 - 0.075) / LEAGUE.head.pan_speed * LEAGUE.control_rate
    assert (found > CENTRED).sum() == pytest.approx(frames, abs=1.5)
