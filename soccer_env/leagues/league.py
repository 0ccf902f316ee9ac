"""League: frozen dataclasses whose numbers have units and sources, and are checked on construction.

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

from dataclasses import dataclass, field, fields
from typing import Any, Literal

from soccer_env.guards.checking import ABOVE_ZERO, Range, raise_not_allowed
from soccer_env.leagues.checks import PYTHON_ONLY, LeaguePart, check_family
from soccer_env.leagues.materials import Materials
from soccer_env.leagues.robot import Block, Body, Drive, Faults, Head, Kicker
from soccer_env.leagues.robot_kind import check_kind
from soccer_env.leagues.rules import Rules
from soccer_env.types import MAX_DELAY_STEPS, MAX_TEAM

MAX_RATE = 1000  # [1/s] control steps
MAX_ROUNDS = 100_000  # of the contact solver in a control step: more would take too long
AHEAD_OF_RAMP = 0.41421356237309503  # [ball radii] tan 22.5: from the foot of a ramp to a ball that touches it
MAX_LEAP = 0.25  # [m] of the ball in a substep: half of a board's thickness; a longer leap ends behind the board


@dataclass(frozen=True)
class Pitch(LeaguePart):
    """The field of play, its goals and boards; see the map at the head of this file. Lengths in metres."""

    BOUNDS = dict.fromkeys(("length", "width", "goal_width", "goal_depth"), ABOVE_ZERO)
    ORDER = (("goal_width", "less than", "width"), ("board_foot", "at most", "ramp"))

    length: float  # [m] along x, between the goal lines
    width: float  # [m] along y, between the touchlines
    goal_width: float  # [m] between the posts
    goal_depth: float  # [m] behind the goal line
    penalty_depth: float  # [m] of the penalty area, from the goal line
    penalty_width: float  # [m]
    circle: float  # [m] radius of the centre circle
    walled: bool  # True: boards stand on the lines, and the ball cannot leave the pitch
    goal_area_depth: float = 0.0  # [m] from the goal line; 0: there is no goal area
    goal_area_width: float = 0.0  # [m]
    band_side: float = 0.0  # [m] room for robots beyond a touchline
    band_end: float = 0.0  # [m] room for robots beyond a goal line
    ramp: float = 0.0  # [m] width in plan of the sloped foot of a board, 45 degrees, which rolls the ball back
    board_foot: float = 0.0  # [m] from a board to where paws stop: the ramp less what a paw steps up
    post_radius: float = 0.02  # [m]
    line: float = field(default=0.025, metadata=PYTHON_ONLY)  # [m] width of the lines


@dataclass(frozen=True)
class BallModel(LeaguePart):
    """The ball and how it rolls."""

    BOUNDS = dict.fromkeys(("radius", "mass", "shell", "top_speed"), ABOVE_ZERO)

    radius: float  # [m]
    mass: float  # [kg]
    rolling: float  # [m/s2] constant deceleration of a rolling ball
    sliding: float  # [m/s2] deceleration of a sliding ball
    pivot: float  # [rad/s2] deceleration of its spin about the vertical
    shell: float  # [1] inertia over mass times radius squared: 2/5 solid, 2/3 a hollow shell
    top_speed: float  # [m/s] limit of its speed


@dataclass(frozen=True)
class Slots(LeaguePart):
    """The numbers of slots for other players in a robot's tracks and observations."""

    NUMBER = Range(0, MAX_TEAM)

    teammates: int  # slots, for the nearest
    opponents: int  # slots, for the nearest

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.teammates + self.opponents == 0:
            raise ValueError("Slots must hold at least one player")


@dataclass(frozen=True)
class Substeps(LeaguePart):
    """The substeps of the physics in a control step."""

    BOUNDS = {
        "travel": ABOVE_ZERO,
        **dict.fromkeys(("least", "close", "most", "iterations", "jam_iterations"), Range(1, 1000)),
    }
    ORDER = (("least", "at most", "close"), ("close", "at most", "most"), ("iterations", "at most", "jam_iterations"))

    least: int  # fewest substeps of a control step
    close: int  # fewest while a robot is within reach of the ball or of another robot
    most: int  # most substeps, while something moves fast
    travel: float  # [m] that the fastest body may move in a substep
    iterations: int  # rounds of the contact solver
    jam_iterations: int  # rounds while the ball touches two things or more, or legs hold each other
    slop: float = field(metadata=PYTHON_ONLY)  # [m] overlap of bodies that is left alone

    def __post_init__(self) -> None:
        super().__post_init__()
        rounds = self.most * self.jam_iterations
        if rounds > MAX_ROUNDS:
            raise ValueError(f"Substeps.most times jam_iterations must be at most {MAX_ROUNDS}, got {rounds}")


@dataclass(frozen=True)
class League(LeaguePart):
    """A league: pitch, ball, robots, rules and time. Make variants with `dataclasses.replace`."""

    BOUNDS = {"control_rate": Range(1, MAX_RATE), "team_size": Range(1, MAX_TEAM)}

    name: str  # in lists, files and results
    family: str  # by which teams, scenes and policies know it: "legged", "middle-size" or your own
    control_rate: int  # [1/s] control steps
    team_size: int  # players a side in the league's own matches
    pitch: Pitch  # the field of play, goals and boards
    ball: BallModel  # the ball and how it rolls
    body: Body  # shape and mass of a robot
    materials: Materials  # elasticity and friction of each pair that collides
    drive: Drive  # legs or wheels
    kicker: Kicker  # how hard and how well robots kick
    head: Head  # where the camera can look
    rules: Rules  # switches and numbers
    slots: Slots  # room for other players in tracks and observations
    substeps: Substeps  # of the physics in a control step
    evaluation_minutes: float  # [min] of play in an evaluation
    evaluation_placement: Literal["instant", "drive"] = "instant"  # how robots reach their places in an evaluation
    source: str = ""  # of the numbers
    block: Block = Block()  # of goalkeepers that spread their forelegs
    faults: Faults = Faults()  # how often robots fail
    sensors: Any = None  # Options such as LeggedSensors, OmniSensors; their KIND names the RobotKind, see robot_kind.py
    memory: Any = None  # Options that go with the sensors, such as LeggedMemory, OmniMemory

    def __post_init__(self) -> None:
        super().__post_init__()
        check_family("League.family", self.family)
        if not isinstance(self.materials, Materials):
            raise_not_allowed("League.materials", "Materials", self.materials)
        if self.sensors is not None:
            check_kind(self.sensors)
        self._check_ball_tunnelling()
        if self.body.legs and self.drive.gait_steps % 2 != 0:
            raise ValueError(f"Drive.gait_steps must be even for a body with legs, got {self.drive.gait_steps}")
        if self.block.raise_time > 0.0 and not self.body.legs:
            raise ValueError("Block.raise_time must be 0 for a body without legs")
        if self.delay_steps >= MAX_DELAY_STEPS:
            raise ValueError(f"Drive.delay spans {self.delay_steps} control steps, at most {MAX_DELAY_STEPS - 1} fit")
        if 2.0 * self.body.reach > min(self.pitch.length, self.pitch.width) / 4:
            raise ValueError("Body.reach is too large for the pitch: robots need room to be placed")

    def __repr__(self) -> str:
        """Return a short description of the league; `in_full` lists every number."""
        size = f"{self.pitch.length:g} x {self.pitch.width:g} m"
        teams = f"{self.team_size} a side, {self.control_rate} steps a second"
        return f"<League {self.name}: {self.family}, {size}, {teams}>"

    def in_full(self) -> str:
        """Return the repr of the league with all its fields: every number."""
        return f"League({', '.join(f'{item.name}={getattr(self, item.name)!r}' for item in fields(self))})"

    def _check_ball_tunnelling(self) -> None:
        """Raise ValueError if the ball could pass through a board within a substep."""
        fastest = MAX_LEAP * self.substeps.most * self.control_rate
        if self.ball.top_speed > fastest:
            raise ValueError(
                f"BallModel.top_speed must be at most {fastest:g} with {self.substeps.most} substeps in "
                f"1/{self.control_rate} s, got {self.ball.top_speed:g}: the ball would pass through the boards"
            )

    def require_family(self, families: tuple[str, ...], who: str) -> None:
        """Raise ValueError, naming a team or scene `who`, unless the league's family is in `families`; empty: any."""
        if families and self.family not in families:
            raise ValueError(f"{who} is for {' and '.join(families)} leagues, {self.name!r} is {self.family}")

    @property
    def dt(self) -> float:
        """Return the length of a control step [s]."""
        return 1.0 / self.control_rate

    @property
    def foot(self) -> float:
        """Return how far [m] the ramps keep legged robots off the boards; 0 for robots on wheels."""
        return self.pitch.board_foot if self.body.legs else 0.0

    @property
    def delay_steps(self) -> int:
        """Return the actuation delay in whole control steps, rounded."""
        return round(self.drive.delay * self.control_rate)
