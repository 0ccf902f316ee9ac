"""Robots that walk about without a match, so that what they believe of their own pose can be held against the truth.

    world = World(LEGGED, robots=20)
    world.tell()                     where they stand
    errors = world.walk(60.0)        (frames, robots) distances from the truth [m]
    world.kidnap()                   somewhere else, without being told

They go from one random point to the next. Legs and wheels slip, which the odometry does not feel. The legged robot's
head sweeps from side to side; its blobs are made from the true pose through `optics`, with dither and misses, and no
camera. The middle-size robot's picture comes from its sensor.
"""

from dataclasses import replace

import numpy as np

from soccer_env.belief.legged.landmarks import believe_pose_legged
from soccer_env.belief.omni.field_lines import believe_pose_omni
from soccer_env.belief.omni.lines import line_tables
from soccer_env.belief.own_pose import POSE_MEMORY
from soccer_env.belief.particles import PARTICLE
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.optics import head_camera as optics
from soccer_env.perception.body import measure_odometry
from soccer_env.perception.omni.sense import OMNI_SENSOR_STATE
from soccer_env.perception.omni.sense import sense_slice as sense_omni
from soccer_env.perception.sensing import SensorArrays, SensorNumbers
from soccer_env.random_numbers import draw_normal, draw_uniform, start_streams
from soccer_env.records.beliefs import OWN_POSE
from soccer_env.records.percepts import LANDMARKS, LEGGED_PERCEPT, NO_POSE, OMNI_PERCEPT, POSE_TOLD
from soccer_env.records.world import World as TrueWorld
from soccer_env.types import BALL, EVENTS, MATCH, NOISE_STREAMS, ROBOT, ROBOT_EVENTS, RobotStream
from tests.scenes.projection import pixel_of_direction

CAMERA = int(RobotStream.CAMERA)
NOBODY = 0  # is near enough to push


class World:
    """Some robots, each alone on its field. `memory` changes settings of the memory by name."""

    def __init__(self, league, robots=1, seed=1, particles=96, sensors=None, **memory):
        found = find_league(league)
        found = replace(found, memory=found.memory.changed(memory), sensors=found.sensors.changed(sensors or {}))
        self.league, self.rng, self.count, self.frame = found, np.random.default_rng(seed), robots, 0
        self.legged = found.sensors.KIND == "legged"
        self.k, self.s, self.w = constants_of(found), found.sensors.record(), found.memory.record()
        self.matches, self.balls = np.zeros(robots, MATCH), np.zeros(robots, BALL)
        self.matches["home_direction"] = self.matches["handedness"] = 1.0
        self.robots, self.events = np.zeros((robots, 1), ROBOT), np.zeros((robots, 1), ROBOT_EVENTS)
        self.robots["active"] = 1
        self.percepts = np.zeros((robots, 1), LEGGED_PERCEPT if self.legged else OMNI_PERCEPT)
        self.pending = np.zeros((robots, 1, 0 if self.legged else found.sensors.camera_delay), self.percepts.dtype)
        self.states = np.zeros((robots, 1), OMNI_SENSOR_STATE)
        self.memories = np.zeros(robots, POSE_MEMORY)
        self.own, self.particles = np.zeros(robots, OWN_POSE), np.zeros((robots, particles), PARTICLE)
        self.noise = np.zeros((robots, NOISE_STREAMS), np.uint64)
        for i in range(robots):
            start_streams(self.noise[i], seed * 1000 + i, 0, 1)
            start_streams(self.robots["noise"][i, 0], seed * 1000 + i, 0, 1)
        self.tables = np.zeros(1, np.dtype([("unused", "f8")])) if self.legged else line_tables(found)
        self.blind = False
        self.kidnap()
        self.aims = self.somewhere()

    @property
    def truth(self):
        return self.robots[:, 0]

    def somewhere(self):
        """Return random points (robots, 2) [m], a robot's length away from the edge."""
        room = np.array([self.league.pitch.length, self.league.pitch.width]) / 2 - 1.2 * self.league.body.reach
        return self.rng.uniform(-room, room, (self.count, 2))

    def kidnap(self):
        """Put all robots somewhere else without telling them."""
        self.truth["x"], self.truth["y"] = self.somewhere().T
        self.truth["heading"] = self.rng.uniform(-np.pi, np.pi, self.count)
        if not self.legged:  # as after a placement: pictures on their way show another place
            self.truth["placed"] = 1

    def tell(self):
        """Tell all robots where they stand, as after a placement."""
        body, sensors = self.percepts["body"][:, 0], self.league.sensors
        spreads = {"x": sensors.place_noise, "y": sensors.place_noise, "heading": sensors.place_turn_noise}
        for name, spread in spreads.items():
            body[name] = self.truth[name] + self.rng.normal(0.0, spread, self.count)
        body["handedness"], body["upright"], body["pose"] = 1.0, 1, POSE_TOLD
        body["forward"] = body["left"] = body["turn"] = 0.0
        self.believe()

    def walk(self, seconds, speed=1.0):
        """Let all robots walk about; return the errors of their poses (frames, robots) [m]."""
        errors = []
        for _ in range(round(seconds * self.league.control_rate)):
            self.move(speed)
            self.sense()
            self.believe()
            errors.append(self.errors())
        return np.array(errors)

    def errors(self):
        return np.hypot(self.own["x"] - self.truth["x"], self.own["y"] - self.truth["y"])

    def heading_errors(self):
        return abs(np.angle(np.exp(1j * (self.own["heading"] - self.truth["heading"]))))

    def move(self, speed):
        """Walk one frame towards the aims, with slip."""
        robots, drive, dt = self.truth, self.league.drive, self.league.dt
        away = self.aims - np.stack([robots["x"], robots["y"]], axis=-1)
        near = np.hypot(*away.T) < 0.1 * self.league.pitch.width
        self.aims[near] = self.somewhere()[near]
        bearing = np.angle(np.exp(1j * (np.arctan2(away[:, 1], away[:, 0]) - robots["heading"])))
        if self.frame % max(1, round(drive.slip_time / dt)) == 0:
            for name in ("forward", "left", "turn"):
                robots["slip"][name] = 1.0 + drive.slip * self.rng.normal(size=self.count)
        walk = robots["walk"]
        walk["turn"] = speed * np.clip(3.0 * bearing, -0.8, 0.8)
        walk["forward"] = 0.8 * speed * drive.forward * np.clip(np.cos(bearing), 0.0, 1.0)
        walk["left"] = 0.3 * speed * drive.sideways * np.sin(bearing)
        forward, left = (dt * walk[name] * robots["slip"][name] for name in ("forward", "left"))
        cosine, sine = np.cos(robots["heading"]), np.sin(robots["heading"])
        robots["x"] += cosine * forward - sine * left
        robots["y"] += sine * forward + cosine * left
        robots["heading"] += dt * walk["turn"] * robots["slip"]["turn"]
        robots["heading"] = np.angle(np.exp(1j * robots["heading"]))
        self.frame += 1
        self.matches["step"] = self.frame

    def sense(self):
        """Fill the percepts."""
        self.percepts["body"]["pose"] = NO_POSE
        self.percepts["body"]["upright"] = 1
        if self.legged:
            phase = 2.0 * np.pi * self.frame * self.league.dt / self.league.memory.search_period
            self.percepts["pan"], self.percepts["tilt"] = 1.3 * np.sin(phase), -0.15
            see_from(self.truth, self.percepts[:, 0], self.k, self.s)
        else:
            rows = np.zeros(1, np.int64)
            world = TrueWorld(self.matches, self.balls, self.robots, np.zeros(self.count, EVENTS), self.events)
            sensing, numbers = SensorArrays(self.percepts, self.states, self.pending), SensorNumbers(self.k, self.s, 0)
            sense_omni(world, sensing, numbers, np.zeros(self.count, bool), rows, 0, self.count)
            self.percepts["body"]["pose"] = NO_POSE
            self.truth["placed"] = 0
        if self.blind:
            kinds = (
                ("landmarks", "own_goal", "opponent_goal") if self.legged else ("own_goal", "opponent_goal", "lines")
            )
            for name in kinds:
                self.percepts[name] = np.zeros((), self.percepts.dtype[name].base)

    def believe(self):
        """Bring the own poses up to the percepts."""
        believe_all(
            self.percepts[:, 0],
            self.own,
            self.memories,
            self.particles,
            self.noise,
            self.k,
            self.s,
            self.w,
            self.tables,
        )


def believe_all(percepts, own, memories, particles, noise, k, s, w, tables):
    """Bring the own poses of some robots up to their percepts."""
    if "pan" in percepts.dtype.names:
        believe_legged(percepts, own, memories, particles, noise, k, s, w)
    else:
        believe_omni(percepts, own, memories, particles, noise, k, s, w, tables)


@compiled
def believe_legged(percepts, own, memories, particles, noise, constants, sensors, settings):
    for i in range(percepts.shape[0]):
        believe_pose_legged(
            percepts[i], own[i], NOBODY, memories[i], particles[i], noise[i], constants[0], sensors[0], settings[0]
        )


@compiled
def believe_omni(percepts, own, memories, particles, noise, constants, sensors, settings, tables):
    for i in range(percepts.shape[0]):
        believe_pose_omni(
            percepts[i],
            own[i],
            0,
            memories[i],
            particles[i],
            noise[i],
            constants[0],
            sensors[0],
            settings[0],
            tables[0],
        )


@compiled
def see_from(robots, percepts, constants, sensors):
    """Fill in odometry and blobs of landmarks and goals from true poses that attack +x, with dither and misses."""
    k, s = constants[0], sensors[0]
    for i in range(robots.shape[0]):
        robot, percept = robots[i], percepts[i]
        measure_odometry(robot, percept.body, k, s)
        percept.body.handedness = 1.0
        for which in range(LANDMARKS):
            x = (0.5 * k.pitch_length + s.landmark_radius) * (which // 2 - 1)
            y = (0.5 * k.pitch_width + s.landmark_radius) * (1 - 2 * (which % 2))
            radius, low, high = s.landmark_radius, s.landmark_low, s.landmark_high
            see_box(robot, percept, percept.landmarks[which], x, y, x, y, radius, low, high, s)
        end, half = 0.5 * k.pitch_length, 0.5 * k.pitch_goal_width
        see_box(robot, percept, percept.own_goal[0], -end, -half, -end, half, 0.0, 0.0, s.goal_height, s)
        see_box(robot, percept, percept.opponent_goal[0], end, half, end, -half, 0.0, 0.0, s.goal_height, s)


@compiled
def see_box(robot, percept, blob, left_x, left_y, right_x, right_y, radius, low, high, s):
    """Fill in the box round a thing between two uprights, as whole pixels."""
    blob.area = 0
    u_left, v_high, first = pixel_of(robot, percept, left_x, left_y, high, radius, s)
    u_right, v_low, second = pixel_of(robot, percept, right_x, right_y, low, -radius, s)
    _, v_other, third = pixel_of(robot, percept, left_x, left_y, low, 0.0, s)
    if not (first and second and third) or u_left <= u_right or draw_uniform(robot.noise, CAMERA) < s.landmark_miss:
        return
    width, height = 0.5 * optics.image_width(s), 0.5 * optics.image_height(s)
    v_low = min(v_low, v_other)
    left = int(round(min(u_left + s.dither * draw_normal(robot.noise, CAMERA), width)))
    right = int(round(max(u_right + s.dither * draw_normal(robot.noise, CAMERA), -width)))
    top = int(round(min(v_high + s.dither * draw_normal(robot.noise, CAMERA), height)))
    bottom = int(round(max(v_low + s.dither * draw_normal(robot.noise, CAMERA), -height)))
    if left > right and top > bottom:
        blob.left, blob.right, blob.high, blob.low = left, right, top, bottom
        blob.area = min((left - right) * (top - bottom), 32767)


@compiled
def pixel_of(robot, percept, x, y, z, aside, s):
    """Return u, v [px] of a point of the field, `aside` to its left [m], and whether it lies before the camera."""
    pan, tilt = np.float64(percept.pan), np.float64(percept.tilt)
    camera_x, camera_y, camera_z = optics.camera_place(pan, tilt, s)
    cosine, sine = np.cos(robot.heading), np.sin(robot.heading)
    ahead = cosine * (x - robot.x) + sine * (y - robot.y) - camera_x
    left = cosine * (y - robot.y) - sine * (x - robot.x) - camera_y
    far = max(np.sqrt(ahead * ahead + left * left), 1e-3)
    bearing = np.arctan2(left, ahead) + np.arcsin(min(max(aside / far, -1.0), 1.0))
    u, v, _ = pixel_of_direction(bearing, np.arctan2(z - camera_z, far), pan, tilt, s)
    return u, v, np.cos(bearing - pan) > 0.2
