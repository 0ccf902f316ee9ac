"""The sensors of a middle-size robot of 2006, and the tracking of its world model, as numbers with their sources.

Every number was written down before the first claim was measured with it. "assumed" marks a guess of ours.
"""

from dataclasses import dataclass
from math import sqrt

from soccer_env.leagues.options import GREATEST, Options
from soccer_env.leagues.pose_memory import PoseMemory
from soccer_env.records.percepts import LINES

LEAST = 1e-3  # [m, s, 1] least divisor: of lengths, times and widths
ROUNDING = 1.0 / 12.0  # [px2] variance of a whole pixel
MOST_DELAY = 3  # [frames] by which a picture may be late
PROBABILITIES = (
    *("ball_miss", "player_miss", "false_balls", "line_miss", "goal_miss", "barrier_miss", "radio_loss"),
    *("light_drift", "odometry_noise"),
)
LENGTHS = ("camera_height", "detection_width", "line_range", "light_period", "table_width")
NOISES = ("pixel_noise", "pose_noise", "pose_turn_noise", "place_noise", "place_turn_noise")
COLOUR_TABLES = {"adaptive": 0, "fixed": 1}
FILTERS = {"kalman": 0, "least-squares": 1, "none": 2}


@dataclass(frozen=True)
class OmniSensors(Options):
    """Omnidirectional camera, wheel encoders, light barrier, radio.  [Heinemann et al. 2006, 1, 2]  MH02, MH05, MH07"""

    KIND = "omni"
    NAMES = {"colour_table": COLOUR_TABLES}
    BOUNDS = {
        "image": (16, 4096), "lines": (1, LINES), "search_every": (1, 1000), "camera_delay": (0, MOST_DELAY),
        "hidden_radius": (0.0, 1e3),
        **dict.fromkeys(PROBABILITIES, (0.0, 1.0)), **dict.fromkeys(NOISES, (0.0, 100.0)),
        **dict.fromkeys(LENGTHS, (LEAST, GREATEST)), "mirror_edge": (LEAST, 1e3), "mirror_eccentricity": (1.0, 1e3),
    }  # fmt: skip
    ORDER = (("hidden_radius", "less than", "mirror_edge"),)
    DERIVED = {
        "mirror_scale": lambda s: s.mirror()[0],  # [px]
        "mirror_bend": lambda s: s.mirror()[1],  # [1]
        "reading_noise": lambda s: sqrt(s.pixel_noise * s.pixel_noise + ROUNDING),  # [px] sd of a thing's place
    }

    image: int = 580  # [px] across, Heinemann et al. 2006, 2  MH02
    camera_height: float = 0.75  # [m] of the mirror's focus, the single viewpoint, assumed
    mirror_edge: float = 10.0  # [m] distance of the ground at the image's edge, assumed
    # The value hardly matters: between 1.1 and 1.3 no radius within the picture differs by more than 2 %.
    mirror_eccentricity: float = 1.3  # [1] of the hyperbola, optics/mirror_camera.py, assumed
    # The own body hides a ball at the kicker (0.29 m), but not a ball at the flank (0.33 m).
    hidden_radius: float = 0.30  # [m] ground that the own body hides, assumed
    pixel_noise: float = 0.7  # [px] sd of a blob's place in the image, assumed
    ball_range: float = 8.0  # [m] distance at which half of the frames show the ball, assumed
    player_range: float = 9.0  # [m] distance at which half of the frames show a player, assumed
    detection_width: float = 1.0  # [m] over which detection falls off, assumed
    ball_miss: float = 0.02  # [1] probability that a frame misses a near ball, assumed
    player_miss: float = 0.05  # [1] probability that a frame misses a near player, assumed
    false_balls: float = 0.01  # [1/frame] wrong balls, assumed
    ball_coloured: bool = True  # False: a plain ball, found half as often and mistaken more often, assumed  MH24
    light_drift: float = 0.0  # [1] amplitude of the change of light (1: from dark to glaring); 0: constant light  MH07
    light_period: float = 120.0  # [s] period of the change of light, assumed
    colour_table: str = "adaptive"  # trained online on objects at known places; fixed: a static table  MH07
    table_time: float = 2.0  # [s] in which new colours replace old ones in the adaptive table, assumed
    table_width: float = 0.25  # [1] difference of light at which a table misses half of the objects, assumed
    lines: int = 24  # directions of the search for white lines, assumed
    search_every: int = 5  # [frames] between two pictures that are searched for goals and white lines, assumed
    line_range: float = 4.0  # [m] assumed
    line_miss: float = 0.2  # [1] assumed
    goal_miss: float = 0.1  # [1] assumed
    camera_delay: int = 1  # [frames] from exposure to percept, assumed: the image is taken and searched
    odometry_noise: float = 0.02  # [1] sd of each component of a step's displacement, assumed; slip comes on top
    barrier_miss: float = 0.01  # [1] share of frames in which the light barrier at the kicker errs, assumed
    pose_noise: float = 0.10  # [m] sd of the noisy pose made by perception/body.py, assumed
    pose_turn_noise: float = 0.05  # [rad] sd of the heading of the noisy pose, assumed
    pose_time: float = 1.0  # [s] correlation time of the errors of the noisy pose, assumed
    place_noise: float = 0.05  # [m] sd between a robot's place at a restart and the place that it is told, assumed
    place_turn_noise: float = 0.05  # [rad] sd between its heading and the heading that it is told, assumed
    radio_period: float = 0.1  # [s] between two messages, assumed  MH05
    radio_delay: float = 0.06  # [s] assumed  MH05
    radio_loss: float = 0.05  # [1] share of messages that are lost, assumed  MH05

    def mirror(self) -> tuple[float, float]:
        """Return scale [px] and bend [1] of the mirror's curve, see optics/mirror_camera.py."""
        bend = 2.0 * self.mirror_eccentricity / (1.0 + self.mirror_eccentricity * self.mirror_eccentricity)
        edge, height = self.mirror_edge, self.camera_height
        return 0.5 * self.image * (height + bend * sqrt(edge * edge + height * height)) / edge, bend


@dataclass(frozen=True)
class OmniMemory(PoseMemory):
    """How positions and velocities of ball and robots are tracked over time.  [Heinemann et al. 2006, 1, 3]  MH06"""

    NAMES = {"filter": FILTERS}
    BOUNDS = {
        "surprise_count": (1, 100), "window": (2.0, 100.0), "pose_line_noise": (LEAST, 1e3),
        **dict.fromkeys(("ball_agility", "player_agility"), (0.0, 1e3)),
    }  # fmt: skip

    fading: float = 25.0  # [1/s] loss of confidence (0 to 100) in an object out of sight, assumed
    filter: str = "kalman"  # least-squares: a fading line fit; none: the last reading  MH06
    # Of 4, 8, 15, 25, 40 and 60 m/s2 it has the least error in play, 5 v 5 by sensors, over kicked, rolling, dribbled
    # and lying balls: the geometric mean of the errors of places and velocities, each over its least, is 1.03 (8: 1.06,
    # 15: 1.13). 15 tracks balls faster than robots better (5.7 cm and 1.17 m/s off, not 6.8 cm and 1.29 m/s), and all
    # others worse (rolling: 3.6 cm and 0.36 m/s off, not 3.1 cm and 0.25 m/s).
    ball_agility: float = 4.0  # [m/s2] sd of a ball's unforeseen acceleration, measured
    player_agility: float = 3.0  # [m/s2] sd of a player's unforeseen acceleration, assumed
    window: float = 8.0  # [frames] of the least-squares fit: 3 to 10, Tribots 2005
    surprise: float = 0.5  # [m] error of a prediction above which a track starts anew, Tribots 2005
    surprise_count: int = 2  # readings in a row that must surprise before a track starts anew, assumed
    gate: float = 1.0  # [m] distance beyond which a reading belongs to no known player, assumed
    delay_compensation: bool = True
    shared: bool = True  # messages of team-mates fill in for objects out of sight  MH05
    shared_age: float = 0.5  # [s] unseen before a team-mate's ball is believed, assumed
    ghost_time: float = 1.0  # [s] unseen after which an opponent is forgotten, assumed
    # The own pose, all assumed; PoseMemory defines these fields.
    pose_every: int = 5
    pose_line_noise: float = 0.20  # [m] sd that a line point is trusted to, assumed
    pose_range_noise: float = 0.10
    pose_slip: float = 0.05
    pose_stuck: float = 0.02
    pose_drift: float = 0.10
    pose_turn_drift: float = 0.05
    pose_push: float = 1.0
    pose_push_turn: float = 2.0
    pose_radius: float = 0.60
