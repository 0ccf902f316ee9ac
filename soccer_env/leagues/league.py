"""What a league is: frozen dataclasses whose every number has a unit and a source, checked on construction.

Map of a pitch; the field frame has its origin at the centre spot, x to the right, y up. Lengths in metres:

          band_end                 length                  band_end
         |<------>|<------------------------------------->|<------>|
    ---- +---------------------------------------------------------+ ----
    band |        touchline (y = +width/2)                         | band
    side |        +---------------------+---------------------+    | side
    ---- |        |                     |                     |    | ----
         |        |-----+               |               +-----|    |
         |        |     |            .--+--.            |     |    |
         |    +---|     |           (   |   )           |     |---+   goal_width
         |home|   |     |           (   o   ) radius of |     |   |away's
         |    +---|     |            '--+--'  circle    |     |---+
         |     ^  |-----+               |               +-----|    |
         | goal_  |  penalty_depth x    |                     |    |
         | depth  |  penalty_width      |                     |    |
         |        +---------------------+---------------------+    |
         +---------------------------------------------------------+
                goal line (x = -length/2)        (x = +length/2)

A walled pitch has no band: boards stand on the touchlines and goal lines, and the ball cannot leave it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from math import hypot, isfinite
from typing import Any

import numpy as np

from soccer_env.types import MAX_DELAY_STEPS, MAX_TEAM

GAIT = 0
WHEELS_OMNI = 1
WHEELS_DIFFERENTIAL = 2
DRIVE_KINDS = {"gait": GAIT, "omnidirectional": WHEELS_OMNI, "differential": WHEELS_DIFFERENTIAL}
PLACEMENTS = ("instant", "drive")
NUMBERS = {"int": "a whole number", "float": "a number"}  # annotations of fields that hold one


def check(record: object, **tests: Callable[[float], bool]) -> None:
    """Raise ValueError for each number of a settings record that is none, is not finite or fails its test."""
    where = type(record).__name__
    for field in fields(record):  # type: ignore[arg-type]
        value, kind = getattr(record, field.name), str(field.type)
        if kind not in NUMBERS:
            continue
        if not is_number(value, kind):
            raise ValueError(f"{where}.{field.name} must be {NUMBERS[kind]}, got {value!r}")
        if not isfinite(value):
            raise ValueError(f"{where}.{field.name} must be finite, got {value}")
        if isinstance(value, np.generic):  # so that settings compare and are written as Python's own numbers
            object.__setattr__(record, field.name, value.item())
        test = tests.get(field.name, not_negative)
        if not test(value):
            raise ValueError(f"{where}.{field.name} must be {test.__name__.replace('_', ' ')}, got {value}")


def is_number(value: Any, kind: str) -> bool:
    """Tell whether a value is a number, Python's or numpy's, and a whole one if the kind is "int"."""
    whole = isinstance(value, (int, np.integer)) and not isinstance(value, bool)
    return whole or (kind == "float" and isinstance(value, (float, np.floating)))


def not_negative(value: float) -> bool:
    """Tell whether a number is zero or more."""
    return value >= 0.0


def positive(value: float) -> bool:
    """Tell whether a number is above zero."""
    return value > 0.0


def between_0_and_1(value: float) -> bool:
    """Tell whether a number is a fraction."""
    return 0.0 <= value <= 1.0


def any_number(value: float) -> bool:
    """Accept every finite number."""
    return True


def is_convex(corners: tuple[tuple[float, float], ...]) -> bool:
    """Tell whether finite corners run counter-clockwise round a convex hull."""
    points = np.asarray(corners, float)
    edges = np.roll(points, -1, axis=0) - points
    after = np.roll(edges, -1, axis=0)
    left_turns = edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0] > 0.0
    return len(points) >= 3 and bool(np.isfinite(points).all() and left_turns.all())


@dataclass(frozen=True)
class Pitch:
    """The field of play and what stands around it; see the map at the head of this file. Lengths in metres."""

    length: float
    width: float
    goal_width: float
    goal_depth: float
    penalty_depth: float
    penalty_width: float
    circle: float
    walled: bool
    goal_area_depth: float = 0.0
    goal_area_width: float = 0.0
    band_side: float = 0.0
    band_end: float = 0.0
    post_radius: float = 0.02
    line: float = 0.025
    wall_elasticity: float = 0.8  # [1] assumed; multiplied with the ball's
    wall_friction: float = 0.3  # [1] assumed
    net_elasticity: float = 0.05  # [1] assumed: a goal catches the ball

    def __post_init__(self) -> None:
        check(
            self,
            length=positive,
            width=positive,
            goal_width=positive,
            goal_depth=positive,
            wall_elasticity=between_0_and_1,
            net_elasticity=between_0_and_1,
        )
        if not self.goal_width < self.width:
            raise ValueError(f"Pitch.goal_width must be less than the width {self.width}, got {self.goal_width}")


@dataclass(frozen=True)
class BallModel:
    """The ball and how it rolls."""

    radius: float  # [m]
    mass: float  # [kg]
    rolling: float  # [m/s2] constant deceleration of a rolling ball
    sliding: float  # [m/s2] deceleration while it slides
    shell: float  # [1] inertia over mass times radius squared: 2/5 solid, 2/3 a hollow shell
    elasticity: float  # [1] restitution against robots and walls, multiplied with theirs
    friction: float  # [1]
    top_speed: float  # [m/s] nothing moves it faster

    def __post_init__(self) -> None:
        check(self, radius=positive, mass=positive, shell=positive, top_speed=positive, elasticity=between_0_and_1)


@dataclass(frozen=True)
class Body:
    """A robot's outline seen from above, its origin at the centre of mass, x forward.

    A convex hull (corners) or a disc, with two round tips in front that form the pocket for the ball.
    """

    mass: float  # [kg]
    disc_radius: float  # [m] 0: the hull is given by its corners
    disc_x: float  # [m] centre of the disc
    corners: tuple[tuple[float, float], ...]  # [m] corners of the hull, counter-clockwise; empty for a disc
    tip_x: float  # [m] centres of the tips, at +-tip_y
    tip_y: float  # [m]
    tip_radius: float  # [m]
    front: float  # [m] x of the surface that a ball in the pocket rests on
    reach: float  # [m] greatest distance of the outline from the origin
    elasticity: float  # [1]
    friction: float  # [1]
    height: float  # [m]

    def __post_init__(self) -> None:
        check(self, mass=positive, reach=positive, tip_x=any_number, disc_x=any_number, elasticity=between_0_and_1)
        if (self.disc_radius > 0.0) == bool(self.corners):
            raise ValueError("Body needs either a disc_radius above zero or corners, not both")
        if len(self.corners) > 8:
            raise ValueError(f"Body.corners must be at most 8, got {len(self.corners)}")
        if self.corners and not is_convex(self.corners):
            raise ValueError(f"Body.corners must be finite and run counter-clockwise round a hull, got {self.corners}")
        outermost = max(
            hypot(self.tip_x, self.tip_y) + self.tip_radius,
            abs(self.disc_x) + self.disc_radius,
            *(hypot(x, y) for x, y in self.corners),
        )
        if self.reach < outermost - 0.001:
            raise ValueError(f"Body.reach must be at least {outermost:.3f}, got {self.reach}")


@dataclass(frozen=True)
class Drive:
    """How a robot moves: speeds, acceleration, delay; a gait or wheels."""

    kind: str  # "gait", "omnidirectional", "differential"
    forward: float  # [m/s] top speed ahead
    backward: float  # [m/s] top speed back
    sideways: float  # [m/s] top speed to either side
    turn: float  # [rad/s] top turn rate
    acceleration: float  # [m/s2] at which a walk changes
    turn_acceleration: float  # [rad/s2]
    traction: float  # [m/s2] force that the ground bears, over mass
    turn_traction: float  # [rad/s2]
    delay: float  # [s] from a command to the motion, 0 to 0.2
    gait_steps: int  # control steps of a gait step, in which the walk cannot change; 1 for wheels
    slip: float  # [1] deviation of a walk from its command
    slip_time: float  # [s] for which a drawn slip holds
    fall: float  # [1/(N s)] probability of a fall for each unit of pushing impulse; 0 off
    fall_time: float  # [s] on the ground

    def __post_init__(self) -> None:
        check(
            self,
            forward=positive,
            backward=positive,
            turn=positive,
            acceleration=positive,
            turn_acceleration=positive,
            traction=positive,
            turn_traction=positive,
            gait_steps=positive,
            slip_time=positive,
        )
        if self.kind not in DRIVE_KINDS:
            raise ValueError(f"Drive.kind must be one of {', '.join(DRIVE_KINDS)}, got {self.kind!r}")
        if self.delay > 0.2:
            raise ValueError(f"Drive.delay must be 0 to 0.2 s, got {self.delay}")


@dataclass(frozen=True)
class Kicker:
    """How a robot kicks."""

    slowest: float  # [m/s] ball speed at the smallest strength
    fastest: float  # [m/s] ball speed at strength 1
    least: float  # [1] strengths below this are ignored
    wind_up: float  # [s] during which the robot stands
    recharge: float  # [s] until it can kick again
    spread: float  # [rad] deviation of the direction
    reach: float  # [m] how far ahead of the front the ball's near side may lie
    half_width: float  # [m] how far aside the ball's centre may lie
    keeper_kicks: bool  # False: a goalkeeper has no kicker

    def __post_init__(self) -> None:
        check(self, fastest=positive, least=between_0_and_1)
        if self.slowest > self.fastest:
            raise ValueError(f"Kicker.slowest must be at most fastest {self.fastest}, got {self.slowest}")


@dataclass(frozen=True)
class Head:
    """Joint limits and speeds of the head [rad, rad/s]; all zero: the camera is fixed."""

    pan_limit: float = 0.0
    tilt_low: float = 0.0
    tilt_high: float = 0.0
    pan_speed: float = 0.0
    tilt_speed: float = 0.0
    camera_height: float = 0.0  # [m]
    camera_ahead: float = 0.0  # [m] ahead of the origin, head level

    def __post_init__(self) -> None:
        check(self, tilt_low=any_number)


@dataclass(frozen=True)
class Rules:
    """The rule set of a league. Fouls of later versions add their fields here."""

    half_minutes: float  # [min] length of a half
    kick_off_distance: float  # [m] opponents' distance from the ball at a kick-off
    restart_distance: float  # [m] opponents' distance from the ball at the other restarts
    restart_time: float  # [s] after which the ball is in play although nobody took the restart
    in_play_distance: float  # [m] that the ball must move to be in play
    placing_time: float  # [s] that robots have to drive to their places
    stuck_time: float  # [s] that the ball may stay near one point
    stuck_radius: float  # [m] that counts as near
    separation: float  # [m] to which robots are pulled away from a dropped ball
    corner_offset: float  # [m] of the ball from the corner, along both lines
    goal_kick_x: float  # [m] of the ball from the goal line at a goal kick
    goal_kick_y: float  # [m] of the ball from the middle at a goal kick
    drop_x: float  # [m] of the drop spots from the centre
    drop_y: float  # [m]

    def __post_init__(self) -> None:
        check(self, half_minutes=positive, restart_time=positive, stuck_time=positive, stuck_radius=positive)


@dataclass(frozen=True)
class Slots:
    """Room for other players in tracks and observations."""

    teammates: int
    opponents: int

    def __post_init__(self) -> None:
        for name in ("teammates", "opponents"):
            value = getattr(self, name)
            if not (is_number(value, "int") and 0 <= value <= MAX_TEAM):
                raise ValueError(f"Slots.{name} must be 0 to {MAX_TEAM}, got {value!r}")
        if self.teammates + self.opponents == 0:
            raise ValueError("Slots must hold at least one player")


@dataclass(frozen=True)
class Substeps:
    """How finely the physics cuts a control step."""

    least: int
    most: int
    travel: float  # [m] that the fastest body may move in a substep
    iterations: int  # of the contact solver
    slop: float  # [m] overlap of bodies that is left alone

    def __post_init__(self) -> None:
        check(self, least=positive, most=positive, travel=positive, iterations=positive)
        if self.least > self.most:
            raise ValueError(f"Substeps.least must be at most {self.most}, got {self.least}")


@dataclass(frozen=True)
class League:
    """A league: pitch, ball, robots, rules and time. Variants by `dataclasses.replace`."""

    name: str
    control_rate: int  # [1/s] control steps
    team_size: int  # players a side in the league's own matches
    pitch: Pitch
    ball: BallModel
    body: Body
    drive: Drive
    kicker: Kicker
    head: Head
    rules: Rules
    slots: Slots
    substeps: Substeps
    evaluation_minutes: float  # [min] of play in an evaluation
    evaluation_placement: str = "instant"
    source: str = ""
    sensors: Any = None  # a LeggedSensors or OmniSensors
    memory: Any = None  # a LeggedMemory or OmniMemory, what goes with the sensors

    def __post_init__(self) -> None:
        check(self)
        if not 1 <= self.control_rate <= 1000:
            raise ValueError(f"League.control_rate must be 1 to 1000 a second, got {self.control_rate}")
        if not 1 <= self.team_size <= MAX_TEAM:
            raise ValueError(f"League.team_size must be 1 to {MAX_TEAM}, got {self.team_size}")
        if self.evaluation_placement not in PLACEMENTS:
            raise ValueError(
                f"League.evaluation_placement must be one of {PLACEMENTS}, got {self.evaluation_placement!r}"
            )
        if self.delay_steps >= MAX_DELAY_STEPS:
            raise ValueError(f"Drive.delay spans {self.delay_steps} control steps, at most {MAX_DELAY_STEPS - 1} fit")
        if 2.0 * self.body.reach > min(self.pitch.length, self.pitch.width) / 4:
            raise ValueError("Body.reach is too large for the pitch: robots need room to be placed")

    @property
    def dt(self) -> float:
        """Return the length of a control step [s]."""
        return 1.0 / self.control_rate

    @property
    def delay_steps(self) -> int:
        """Return the actuation delay in whole control steps, rounded."""
        return round(self.drive.delay * self.control_rate)

    def constants(self) -> np.ndarray:
        """Return the numbers that compiled kernels need, as one `CONSTANTS` record of shape (1,)."""
        from soccer_env.leagues.constants import constants_of

        return constants_of(self)
