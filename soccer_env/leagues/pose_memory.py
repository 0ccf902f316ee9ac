"""What every robot keeps of its own pose: the settings of the particles, the same in all leagues.  MH08"""

from dataclasses import dataclass
from math import pi

from soccer_env.leagues.options import Options

DEGREE = pi / 180.0
SHARES = ("pose_fresh", "pose_stuck", "pose_fast", "pose_slow", "pose_fit")
WIDTHS = ("pose_bearing_noise", "pose_range_noise", "pose_radius", "pose_angle")
DRIFTS = ("pose_slip", "pose_drift", "pose_turn_drift", "pose_push", "pose_push_turn")


@dataclass(frozen=True, kw_only=True)
class PoseMemory(Options):
    """How a robot finds its own pose; a league gives the numbers that have no value here.  MH08"""

    BOUNDS = {
        "particles": (1, 65536), "pose_every": (1, 1000), **dict.fromkeys(SHARES, (0.0, 1.0)),
        **dict.fromkeys(WIDTHS, (1e-3, 1e3)), **dict.fromkeys(DRIFTS, (0.0, 100.0)),
    }  # fmt: skip

    particles: int = 96  # of the own pose  MH08
    pose_every: int  # frames between two updates of the particles, assumed
    pose_bearing_noise: float = 4.0 * DEGREE  # [rad] sd that the bearing of a landmark or goal is trusted to, assumed
    pose_range_noise: float  # [1] of the distance, the same
    pose_fresh: float = 0.02  # [1] share of particles drawn anew from what is seen, at least, assumed
    pose_slip: float  # [1] of a motion: sd of what a particle adds to it, about twice the robot's slip, assumed
    pose_stuck: float  # [1] share of particles that stay behind: a held robot walks on the spot, assumed
    pose_drift: float  # [m/s^0.5] sd that time adds: pushes are not felt, assumed
    pose_turn_drift: float  # [rad/s^0.5] the same
    pose_push: float  # [m/s] sd that another player adds who is near enough to push, assumed
    pose_push_turn: float  # [rad/s] the same
    pose_radius: float  # [m] within which particles are one cluster, assumed
    pose_angle: float = 0.50  # [rad] the same
    pose_fast: float = 0.2  # [1] weight of the newest fit in its short-term average, assumed
    pose_slow: float = 0.02  # [1] in its long-term average, assumed
    pose_fit: float = 0.5  # [1] least fit that a robot expects that knows where it is, assumed
    pose_fading: float = 3.0  # [1/s] loss of confidence (0 to 100) by dead reckoning alone, assumed
