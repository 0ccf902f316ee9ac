"""The parts of a league's robots: body, drive, kicker, block and head, checked on construction."""

from dataclasses import dataclass, field
from math import hypot

from soccer_env.guards.checking import ABOVE_ZERO, ANY, SHARE, Range
from soccer_env.leagues.checks import PYTHON_ONLY, LeaguePart, is_convex

GAIT, WHEELS_OMNI, WHEELS_DIFFERENTIAL = 0, 1, 2
DRIVE_KINDS = {"gait": GAIT, "omnidirectional": WHEELS_OMNI, "differential": WHEELS_DIFFERENTIAL}
MOST_CORNERS = 8  # room for corners of a hull in the constants


@dataclass(frozen=True)
class Body(LeaguePart):
    """A robot's outline seen from above, its origin at the centre of mass, x forward.

    A convex hull (corners), a disc or a capsule, with two round posts in front, the tips, that form the pocket for the
    ball, and two posts behind if hind_y is above 0. With legs the four posts are the places of the legs in mid-stroke,
    and swing with the gait.
    """

    BOUNDS = {**dict.fromkeys(("mass", "reach"), ABOVE_ZERO), **dict.fromkeys(("tip_x", "disc_x", "hind_x"), ANY)}

    mass: float  # [kg]
    disc_radius: float  # [m] 0: the body is a hull with corners
    disc_x: float  # [m] centre of the disc
    corners: tuple[tuple[float, float], ...]  # [m] corners of the hull, counter-clockwise; empty for a disc
    tip_x: float  # [m] centres of the tips, at +-tip_y
    tip_y: float  # [m]
    tip_radius: float  # [m]
    front: float  # [m] x of the surface that touches a ball in the pocket
    reach: float  # [m] greatest distance of the outline from the origin
    height: float  # [m]
    disc_back: float = 0.0  # [m] length of a capsule's spine, from the disc backwards; 0: a disc
    hind_x: float = 0.0  # [m] centres of the hind posts, at +-hind_y, as thick as the tips
    hind_y: float = 0.0  # [m] 0: none
    legs: bool = False  # True: posts swing with the gait, and meet the feet of boards
    inertia: float = field(
        default=0.0, metadata=PYTHON_ONLY
    )  # [m2] moment over mass; 0: computed from the hull or disc

    def __post_init__(self) -> None:
        super().__post_init__()
        if (self.disc_radius > 0.0) == bool(self.corners):
            raise ValueError("Body needs either a disc_radius above zero or corners, not both")
        if len(self.corners) > MOST_CORNERS:
            raise ValueError(f"Body.corners must be at most {MOST_CORNERS}, got {len(self.corners)}")
        if self.corners and not is_convex(self.corners):
            raise ValueError(f"Body.corners must be finite and run counter-clockwise round a hull, got {self.corners}")
        if self.disc_back > 0.0 and self.corners:
            raise ValueError(f"Body.disc_back must be 0 for a hull, got {self.disc_back}")
        in_quarters = self.hind_x < 0.0 < self.tip_x and min(self.tip_y, self.hind_y, self.tip_radius) > 0.0
        if self.legs and (self.corners or not in_quarters):
            raise ValueError("Body.legs needs a disc_radius above zero and four posts, one in each quarter round it")
        outermost = max(  # of the outline, which a disc of radius `reach` round the origin has to contain
            *(hypot(x, y) + self.tip_radius for x, y in self.posts or ((0.0, 0.0),)),
            abs(self.disc_x) + self.disc_radius,
            abs(self.disc_x - self.disc_back) + self.disc_radius,
            *(hypot(x, y) for x, y in self.corners),
        )
        if self.reach < outermost - 0.001:
            raise ValueError(f"Body.reach must be at least {outermost:.3f}, got {self.reach}")

    @property
    def posts(self) -> tuple[tuple[float, float], ...]:
        """Return the centres of the existing posts [m]: left fore, right fore, left hind, right hind."""
        pairs = [(self.tip_x, self.tip_y)] if self.tip_radius > 0.0 else []
        pairs += [(self.hind_x, self.hind_y)] if self.hind_y > 0.0 else []
        return tuple((x, side * y) for x, y in pairs for side in (1.0, -1.0))


MOVING = (
    *("forward", "backward", "turn", "acceleration", "turn_acceleration", "traction", "turn_traction"),
    *("thrust", "turn_thrust", "gait_steps", "slip_time"),
)


@dataclass(frozen=True)
class Drive(LeaguePart):
    """How a robot moves: speeds, acceleration, delay; a gait or wheels."""

    NAMES = {"kind": DRIVE_KINDS}
    BOUNDS = {**dict.fromkeys(MOVING, ABOVE_ZERO), "delay": Range(0.0, 0.2)}

    kind: str  # "gait", "omnidirectional", "differential"
    forward: float  # [m/s] top speed ahead
    backward: float  # [m/s] top speed back
    sideways: float  # [m/s] top speed to either side
    turn: float  # [rad/s] top turn rate
    acceleration: float  # [m/s2] of a walk
    turn_acceleration: float  # [rad/s2]
    traction: float  # [m/s2] force that the ground bears under a standing robot, over mass
    thrust: float  # [m/s2] force that the ground bears under a moving robot, over mass
    turn_traction: float  # [rad/s2] torque that the ground bears under a standing robot, over moment of inertia
    turn_thrust: float  # [rad/s2] torque that the ground bears under a moving robot, over moment of inertia
    delay: float = field(metadata=PYTHON_ONLY)  # [s] from a command to the motion, 0 to 0.2
    gait_steps: int  # control steps for which the walk is latched; 1 for wheels
    slip: float  # [1] relative deviation of a walk from its command
    slip_time: float = field(metadata=PYTHON_ONLY)  # [s] for which a drawn slip holds
    fall: float  # [1/(N s)] probability of a fall for each unit of pushing impulse; 0 off
    fall_time: float  # [s] on the ground


@dataclass(frozen=True)
class Kicker(LeaguePart):
    """How a robot kicks."""

    BOUNDS = {"fastest": ABOVE_ZERO, "least": SHARE, "speed_spread": SHARE, "miss": SHARE, "squirt": SHARE}
    ORDER = (("slowest", "at most", "fastest"),)

    slowest: float  # [m/s] ball speed at the smallest strength
    fastest: float  # [m/s] ball speed at strength 1
    least: float  # [1] least strength; kicks below it are ignored
    wind_up: float  # [s] during which the robot stands
    recharge: float  # [s] until the robot can kick again
    spread: float  # [rad] deviation of the direction of a ball that lies well
    speed_spread: float  # [1] deviation of the speed, as a share of it
    miss: float  # [1] probability of missing a ball that lies as badly as possible
    reach: float  # [m] how far ahead of the front the ball's near side may lie
    half_width: float  # [m] how far aside the ball's centre may lie
    keeper_kicks: bool  # False: a goalkeeper has no kicker
    aside: float = 0.0  # [rad] direction of a kick with one foreleg, to a side; 0: there is no such kick
    aside_wind_up: float = 0.0  # [s] of a kick aside
    squirt: float = 0.0  # [1] probability that a kick lifts a ball between two robots out aside
    squirt_way: float = 0.0  # [m] by which it is lifted aside


@dataclass(frozen=True)
class Block(LeaguePart):
    """How a goalkeeper with legs blocks: it lies down on its chest, forelegs spread; all zero: it cannot.  MS53

    Once started, the motion runs to its end: legs out, held, and in again. Positions are seen from above, as in `Body`.
    """

    raise_time: float = 0.0  # [s] from the stance to the spread forelegs
    hold_time: float = 0.0  # [s] for which the forelegs stay spread
    recover_time: float = 0.0  # [s] back to the stance
    paw_x: float = 0.0  # [m] centres of the spread forepaws, at +-paw_y
    paw_y: float = 0.0  # [m]
    shoulder_x: float = 0.0  # [m] upper ends of the forelegs, at +-shoulder_y
    shoulder_y: float = 0.0  # [m]

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.raise_time > 0.0 and min(self.recover_time, self.paw_y - self.shoulder_y) <= 0.0:
            raise ValueError("Block needs a recover_time above zero and a paw_y above shoulder_y")


@dataclass(frozen=True)
class Faults(LeaguePart):
    """How often robots fail, for training and robustness; all robots of the real leagues' settings work.

    A robot that fails stands where it is, neither drives nor kicks nor turns its head, and goes on sensing.
    """

    dropouts: float = 0.0  # [1/min] of each robot: it fails for `dropout_time`, then works again
    dropout_time: float = 5.0  # [s]
    breakdowns: float = 0.0  # [1/min] of each robot: it fails for the rest of the episode

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.dropout_time <= 0.0 or self.dropouts * self.dropout_time > 60.0:
            raise ValueError("Faults needs a dropout_time above zero, and at most one dropout in each")


@dataclass(frozen=True)
class Head(LeaguePart):
    """Joint limits and speeds of the head [rad, rad/s]; all zero: the camera is fixed."""

    BOUNDS = {"tilt_low": ANY}

    pan_limit: float = 0.0  # [rad] to either side
    tilt_low: float = 0.0  # [rad] the lowest, below 0
    tilt_high: float = 0.0  # [rad] the highest
    pan_speed: float = 0.0  # [rad/s]
    tilt_speed: float = 0.0  # [rad/s]
    camera_height: float = 0.0  # [m]
    camera_ahead: float = 0.0  # [m] ahead of the origin, head level
