"""The three frames of the package on a pitch: field, team and robot, with bearing and distance."""

from math import atan2, cos, hypot, pi, sin

import numpy as np

from soccer_env.match import Match, staging
from soccer_env.render import Arrows, Label, Overlay, Picture, Polyline
from soccer_env.render.colours import BALL_SHINE, KEEPER, TEAMS_LIGHT, WHITE, Colour
from soccer_env.train.pages.pictures.legend import Entry, add_legend
from soccer_env.train.pages.pictures.settings import STILL_WIDTH
from soccer_env.types import Phase

ROBOT = (-0.70, -0.60, 0.45)  # [m, m, rad] pose of red 0 in the field frame
OTHER = (0.85, -0.55, 2.6)  # of blue 0
BALL = (-0.51, 0.48)  # [m]
AXIS = 0.42  # [m] length of the arrows
LETTERS = 24.0  # [px] in a picture of 1000 px

ENTRIES = (
    Entry(WHITE, "field frame, origin at the centre spot: in the first half also home's team frame"),
    Entry(TEAMS_LIGHT[1], "away's team frame in the first half: half a turn, so its own goal lies at -x too"),
    Entry(KEEPER, "robot frame: x forward, y left; heading is its angle in the field frame"),
    Entry(BALL_SHINE, "bearing and distance: where a thing lies in the robot frame"),
)


def frames_picture(width: int = STILL_WIDTH) -> np.ndarray:
    """Return the drawing of the frames, (H, W, 3) uint8."""
    match = Match(home=1, away=1, seed=0)
    staging.set_phase(match, Phase.PLAY)
    for row, pose in enumerate((ROBOT, OTHER)):
        staging.put(match, row, *pose)
    staging.put_ball(match, *BALL)
    size = width / 1000.0
    overlays = [*axes(0.0, 0.0, 0.0, WHITE, size), *axes(0.0, 0.0, pi, TEAMS_LIGHT[1], size)]  # of the field, of away
    overlays += [*axes_of_robot(size), *distance_and_bearing(size)]
    picture = Picture(match.league, width)
    frame = picture.draw(match.matches[0], match.balls[0], match.robots[0], title=("home", "away"), overlays=overlays)
    return add_legend(frame, ENTRIES, columns=1)


def axes_of_robot(size: float) -> list[Overlay]:
    """Return the drawn axes of the robot frame, and its heading as an arc from the direction of the field's x axis."""
    x, y, heading = ROBOT
    along = Polyline([(x, y), (x + 1.15 * AXIS, y)], WHITE, 1.5 * size)
    beside = (x + 0.36 * cos(0.4 * heading), y + 0.36 * sin(0.4 * heading))
    words = Label(beside, "heading", WHITE, LETTERS * size, align="left")
    return [along, arc(x, y, 0.0, heading, 0.33, WHITE, size), words, *axes(x, y, heading, KEEPER, size)]


def distance_and_bearing(size: float) -> list[Overlay]:
    """Return the drawn line from the robot to the ball (the distance), and the bearing as an arc."""
    x, y, heading = ROBOT
    direction = atan2(BALL[1] - y, BALL[0] - x)
    half_way = 0.62 * hypot(BALL[0] - x, BALL[1] - y)
    at = (x + half_way * cos(direction), y + half_way * sin(direction))
    high = heading + 0.65 * (direction - heading)  # clear of the name of the robot's x
    beside = (x + 0.35 * cos(high), y + 0.35 * sin(high))
    return [
        Polyline([(x, y), BALL], BALL_SHINE, 2.0 * size),
        arc(x, y, heading, direction, 0.26, BALL_SHINE, size),
        Label(beside, "bearing", BALL_SHINE, LETTERS * size, align="left"),
        Label(at, "distance", BALL_SHINE, LETTERS * size, (-8.0 * size, 0.0), "right"),
    ]


def axes(x: float, y: float, direction: float, colour: Colour, size: float) -> list[Overlay]:
    """Return the axes of a frame as two arrows with their names."""
    ahead, left = (cos(direction), sin(direction)), (-sin(direction), cos(direction))
    vectors = [(AXIS * u, AXIS * v) for u, v in (ahead, left)]
    overlays: list[Overlay] = [Arrows([(x, y)] * 2, vectors, colour, 4.0 * size)]
    for name, (u, v) in zip("xy", vectors, strict=True):
        overlays.append(Label((x + 1.13 * u, y + 1.13 * v), name, colour, 1.2 * LETTERS * size))
    return overlays


def arc(x: float, y: float, start: float, end: float, radius: float, colour: Colour, size: float) -> Polyline:
    """Return an arc of a circle about (x, y), from angle `start` to `end` [rad]."""
    angles = np.linspace(start, end, 24)
    return Polyline(np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], axis=-1), colour, 2.5 * size)
