"""Stage pictures: robots, a ball and a camera put somewhere, what is drawn of them, and a ray-cast image to compare.

scene = Scene(matches=100, robots=4)
scene.put(1, x=1.0, y=0.0, heading=pi);  scene.put_ball(0.8, 0.1)
pieces, found = scene.draw()     without noise, robot 0 looks
percepts = scene.look()          with noise, all robots look
cast_ball(scene, m, finer=4)     (visible, whole) masks of the ball's pixels, by casting a ray through each
"""

from typing import Any, NamedTuple

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.optics.head_camera import camera_place, focal_x, focal_y, image_height, image_width
from soccer_env.perception.legged.occlusion import PIECE, PIECES
from soccer_env.perception.legged.picture import draw_scene, take_picture
from soccer_env.perception.legged.sense import LEGGED_SENSOR_STATE
from soccer_env.perception.legged.sketch import KINDS, make_sketch
from soccer_env.records.percepts import LEGGED_PERCEPT
from soccer_env.types import BALL, MATCH, ROBOT
from tests.scenes.staging import LEGGED

FAR_AWAY = 50.0  # [m]
SURE = {
    "dither": 0.0, "scale_error": 0.0, "ball_miss": 0.0, "player_miss": 0.0, "sticker_miss": 0.0,
    "landmark_miss": 0.0, "patches": 0.0, "red_as_orange": 0.0,
}  # fmt: skip


@compiled
def draw_all(matches, balls, robots, constants, sensors, pieces, found):  # type: ignore[no-untyped-def]
    sketches = make_sketch(constants[0], sensors[0])
    for m in range(matches.shape[0]):
        draw_scene(matches[m], balls[m], robots[m], constants[0], sensors[0], 0, sketches[0])
        found[m] = sketches[0].counts
        pieces[m] = sketches[0].pieces


@compiled
def look_all(matches, balls, robots, constants, sensors, percepts, states):  # type: ignore[no-untyped-def]
    sketches = make_sketch(constants[0], sensors[0])
    for m in range(matches.shape[0]):
        for r in range(robots.shape[1]):
            take_picture(
                matches[m], balls[m], robots[m], percepts[m, r], states[m, r], constants[0], sensors[0], r, sketches
            )


class Scene:
    """M scenes. Robot 0 stands on the centre spot and looks along +x, its head level; nobody else is on the field.

    Robot 1 is an opponent, all others are team-mates. Without noise, unless `sensors` bring it.
    """

    def __init__(self, matches: int = 1, robots: int = 2, league: League | None = None, **sensors: Any) -> None:
        self.league = find_league(LEGGED) if league is None else league
        self.matches, self.balls = np.zeros(matches, MATCH), np.zeros(matches, BALL)
        self.robots = np.zeros((matches, robots), ROBOT)
        self.percepts = np.zeros((matches, robots), LEGGED_PERCEPT)
        self.states = np.zeros((matches, robots), LEGGED_SENSOR_STATE)
        self.matches["handedness"] = self.matches["home_direction"] = 1.0
        self.matches["seed"] = np.arange(matches)
        self.robots["team"][:, 1:2] = 1
        self.robots["number"] = np.arange(robots)
        self.robots["active"][:, 0] = 1
        self.robots["x"][:, 1:] = self.balls["x"] = FAR_AWAY
        noise = self.robots["noise"]
        noise[:] = np.random.default_rng(4).integers(0, 1 << 63, noise.shape, np.uint64)
        self.constants = constants_of(self.league)
        self.settings = self.league.sensors.changed(SURE | sensors)
        self.sensors = self.settings.record()

    def put(self, r: int, x: Any, y: Any, heading: Any = 0.0, pan: Any = 0.0, tilt: Any = 0.0) -> None:
        """Put a robot of every scene somewhere, its head turned."""
        self.robots["active"][:, r] = 1
        for name, value in zip(("x", "y", "heading", "pan", "tilt"), (x, y, heading, pan, tilt), strict=True):
            self.robots[name][:, r] = value

    def put_ball(self, x: Any, y: Any) -> None:
        """Put the ball of every scene somewhere."""
        self.balls["x"], self.balls["y"] = x, y

    def look_at(self, r: int, x: Any, y: Any, height: Any = 0.0) -> None:
        """Turn the head of robot r to a point, as far as it can turn."""
        robot, head = self.robots[:, r], self.league.head
        for _ in range(30):
            ahead, left, up = np.transpose([self.camera(m, r)[:3] for m in range(len(self.robots))])
            away = np.hypot(x - ahead, y - left)
            tilt = np.arctan2(height - up, away)
            pan = np.arctan2(y - robot["y"], x - robot["x"]) - robot["heading"]
            robot["tilt"] = np.clip(tilt, head.tilt_low, head.tilt_high)
            robot["pan"] = np.clip((pan + np.pi) % (2 * np.pi) - np.pi, -head.pan_limit, head.pan_limit)

    def camera(self, m: int, r: int = 0) -> np.ndarray:
        """Return where a robot's camera is [m] and its axes, ahead, left and up, as 12 numbers, field frame."""
        robot, s = self.robots[m, r], self.sensors.view(np.recarray)[0]
        ahead, left, height = camera_place(robot["pan"], robot["tilt"], s)
        place = turn(robot["heading"]) @ [ahead, left, height] + [robot["x"], robot["y"], 0.0]
        axes = turn(robot["heading"] + robot["pan"]) @ raise_by(robot["tilt"])
        return np.concatenate([place, *axes.T])

    def draw(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the pieces (M, KINDS, PIECES) that robot 0 would see and how many there are (M, KINDS)."""
        found = np.zeros((len(self.matches), KINDS), np.int64)
        pieces = np.zeros((len(self.matches), KINDS, PIECES), PIECE)
        draw_all(self.matches, self.balls, self.robots, self.constants, self.sensors, pieces, found)
        return pieces, found

    def seen_area(self, kind: int) -> np.ndarray:
        """Return the area (M,) [px] of all pieces of a kind."""
        pieces, found = self.draw()
        shown = np.arange(PIECES) < found[:, kind, None]
        return (pieces["area"][:, kind] * shown).sum(axis=1)

    def look(self, frames: int = 1) -> np.ndarray:
        """Let all robots take some pictures; return their percepts (M, R) of the last."""
        for _ in range(frames):
            look_all(self.matches, self.balls, self.robots, self.constants, self.sensors, self.percepts, self.states)
        return self.percepts


def turn(angle: float) -> np.ndarray:
    """Return the rotation about the vertical."""
    return np.array([[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])


def raise_by(angle: float) -> np.ndarray:
    """Return the rotation that tilts ahead upward."""
    return np.array([[np.cos(angle), 0.0, -np.sin(angle)], [0.0, 1.0, 0.0], [np.sin(angle), 0.0, np.cos(angle)]])


# Casting rays


class Box(NamedTuple):
    """An upright box: middle [m], heading [rad], half its edges [m]."""

    middle: np.ndarray
    heading: float
    half: np.ndarray


class Sticker(NamedTuple):
    """An upright rectangle: middle [m], normal, half its width and height [m]."""

    middle: np.ndarray
    normal: np.ndarray
    half_width: float
    half_height: float


class Image(NamedTuple):
    """Pixels (rows, columns): their middles [px], and the rays through them (rows, columns, 3), field frame."""

    u: np.ndarray
    v: np.ndarray
    eye: np.ndarray
    rays: np.ndarray


def image_of(scene: Scene, m: int, finer: int = 4, box: tuple[float, ...] | None = None) -> Image:
    """Return the image of robot 0, `finer` times as fine as its camera's, or the part of it within a box [px]."""
    s = scene.sensors.view(np.recarray)[0]
    width, height = image_width(s), image_height(s)
    u = (np.arange(width * finer) + 0.5) / finer - 0.5 * width
    v = (np.arange(height * finer) + 0.5) / finer - 0.5 * height
    if box is not None:
        u, v = u[(u > box[1] - 1) & (u < box[0] + 1)], v[(v > box[3] - 1) & (v < box[2] + 1)]
    u, v = np.meshgrid(u, v)
    numbers = scene.camera(m)
    eye, ahead, left, up = numbers.reshape(4, 3)
    rays = ahead + (u / focal_x(s))[..., None] * left + (v / focal_y(s))[..., None] * up
    return Image(u, v, eye, rays)


def bodies_of(scene: Scene, m: int, rows: Any = None) -> list[Box]:
    """Return trunk and head of the robots in `rows`, of all but robot 0."""
    s, boxes = scene.settings, []
    body = scene.league.body
    back, front, half_width = body.hind_x - body.tip_radius, body.front, body.hind_y + body.tip_radius
    low, high, half = s.trunk_low, s.trunk_height, 0.5 * s.head_size
    for r in range(1, scene.robots.shape[1]) if rows is None else rows:
        robot = scene.robots[m, r]
        if robot["active"]:
            origin = np.array([robot["x"], robot["y"], 0.0])
            middle = origin + turn(robot["heading"]) @ [0.5 * (front + back), 0.0, 0.5 * (low + high)]
            size = np.array([0.5 * (front - back), half_width, 0.5 * (high - low)])
            boxes.append(Box(middle, robot["heading"], size))
            neck = origin + turn(robot["heading"]) @ [s.neck_ahead, 0.0, s.neck_height]
            gaze = turn(robot["heading"] + robot["pan"])
            head = neck + gaze @ raise_by(robot["tilt"]) @ [s.camera_ahead - half, 0.0, s.camera_up]
            boxes.append(Box(head, robot["heading"] + robot["pan"], np.full(3, half)))
    return boxes


def stickers_of(scene: Scene, m: int, r: int) -> tuple[list[Sticker], list[Sticker]]:
    """Return the stickers of a robot's trunk and of its head."""
    s, (trunk, head) = scene.settings, bodies_of(scene, m, [r])
    robot = scene.robots[m, r]
    on_trunk, on_head = [], []
    for angle in (0.0, np.pi, 0.5 * np.pi, -0.5 * np.pi):
        normal = turn(trunk.heading + angle) @ [1.0, 0.0, 0.0]
        reach, part = (trunk.half[0], "chest" if angle == 0.0 else "rump") if angle in (0.0, np.pi) else (
            trunk.half[1], "flank")  # fmt: skip
        middle = np.array([*(trunk.middle + reach * normal)[:2], s.trunk_sticker_middle])
        size = [0.5 * s.jersey * getattr(s, f"sticker_{part}_{name}") for name in ("width", "height")]
        along = getattr(s, f"sticker_{part}_apart") * np.array([-normal[1], normal[0], 0.0])
        for place in np.arange(s.trunk_stickers) - 0.5 * (s.trunk_stickers - 1):
            on_trunk.append(Sticker(middle + place * along, normal, *size))
    neck = np.array([robot["x"], robot["y"], s.neck_height]) + turn(trunk.heading) @ [s.neck_ahead, 0.0, 0.0]
    up = s.head_sticker_middle - s.neck_height
    crown = neck + turn(head.heading) @ raise_by(robot["tilt"]) @ [s.sticker_head_x, 0.0, up]
    for angle in (0.0, np.pi, 0.5 * np.pi, -0.5 * np.pi):
        normal = turn(head.heading + angle) @ [1.0, 0.0, 0.0]
        base = head.middle if angle in (0.0, np.pi) else crown
        middle = np.array([*(base + 0.5 * s.head_size * normal)[:2], crown[2]])
        size = [0.5 * s.jersey * getattr(s, f"sticker_head_{name}") for name in ("width", "height")]
        on_head.append(Sticker(middle, normal, *size))
    return on_trunk, on_head


def reach_boxes(image: Image, boxes: list[Box]) -> np.ndarray:
    """Return how many of its own lengths each ray goes until it enters a box; inf for none."""
    nearest = np.full(image.u.shape, np.inf)
    for box in boxes:
        back = turn(-box.heading)
        start, rays = back @ (image.eye - box.middle), image.rays @ back.T
        with np.errstate(divide="ignore", invalid="ignore"):
            one, other = (-box.half - start) / rays, (box.half - start) / rays
        enter, leave = np.minimum(one, other).max(axis=-1), np.maximum(one, other).min(axis=-1)
        nearest = np.where((leave >= np.maximum(enter, 0.0)) & (enter < nearest), np.maximum(enter, 0.0), nearest)
    return nearest


def reach_ball(image: Image, x: float, y: float, radius: float) -> np.ndarray:
    """Return how many of its own lengths each ray goes until it meets the ball; inf for none."""
    to = np.array([x, y, radius]) - image.eye
    square, along = (image.rays**2).sum(axis=-1), image.rays @ to
    inside = along**2 - square * (to @ to - radius**2)
    return np.where((inside >= 0.0) & (along > 0.0), (along - np.sqrt(np.maximum(inside, 0.0))) / square, np.inf)


def reach_sticker(image: Image, sticker: Sticker) -> np.ndarray:
    """Return how many of its own lengths each ray goes until it meets the face of a sticker; inf for none."""
    facing = image.rays @ sticker.normal
    with np.errstate(divide="ignore", invalid="ignore"):
        away = ((sticker.middle - image.eye) @ sticker.normal) / facing
    met = image.eye + away[..., None] * image.rays - sticker.middle
    across = np.array([-sticker.normal[1], sticker.normal[0], 0.0])
    inside = (abs(met @ across) <= sticker.half_width) & (abs(met[..., 2]) <= sticker.half_height)
    return np.where(inside & (facing < 0.0) & (away > 0.0), away, np.inf)


def cast_ball(scene: Scene, m: int, finer: int = 4, box: tuple[float, ...] | None = None) -> tuple[np.ndarray, Any]:
    """Return which pixels show the ball, and which would without the other robots."""
    image = image_of(scene, m, finer, box)
    ball = scene.balls[m]
    away = reach_ball(image, ball["x"], ball["y"], scene.league.ball.radius)
    return np.isfinite(away) & (away < reach_boxes(image, bodies_of(scene, m))), np.isfinite(away)


def cast_jersey(scene: Scene, m: int, r: int, finer: int = 4, box: tuple[float, ...] | None = None) -> tuple[int, int]:
    """Return how many pixels show the jersey of robot r, and how many would without the other robots."""
    image, s = image_of(scene, m, finer, box), scene.settings
    others = [row for row in range(1, scene.robots.shape[1]) if row != r]
    trunk, head = stickers_of(scene, m, r)
    lowered = scene.robots[m, r]["tilt"] < -s.head_down
    own_head = reach_boxes(image, bodies_of(scene, m, [r])[1:]) if lowered else np.full(image.u.shape, np.inf)
    others_before = reach_boxes(image, bodies_of(scene, m, others))
    seen = whole = 0
    for stickers, hidden_from in ((trunk, own_head), ([] if lowered else head, np.full(image.u.shape, np.inf))):
        for sticker in stickers:
            away = reach_sticker(image, sticker)
            alone = np.isfinite(away) & (away < hidden_from)
            seen, whole = seen + (alone & (away < others_before)).sum(), whole + alone.sum()
    return seen, whole
