"""The settings of a robot's estimate of its own pose, by particles, in all leagues.  MH08"""

from dataclasses import dataclass
from math import pi

from soccer_env.leagues.options import Options

DEGREE = pi / 180.0
SHARES = ("pose_fresh", "pose_stuck", "pose_fast", "pose_slow", "pose_fit")
WIDTHS = ("pose_bearing_noise", "pose_range_noise", "pose_radius", "pose_angle")
DRIFTS = ("pose_slip", "pose_drift", "pose_turn_drift", "pose_push", "pose_push_turn")


@dataclass(frozen=True, kw_only=True)
class PoseMemory(Options):
    """How a robot finds its own pose; each league gives the numbers that have no default here.  MH08"""

    BOUNDS = {
        "particles": (1, 65536), "pose_every": (1, 1000), **dict.fromkeys(SHARES, (0.0, 1.0)),
        **dict.fromkeys(WIDTHS, (1e-3, 1e3)), **dict.fromkeys(DRIFTS, (0.0, 100.0)),
    }  # fmt: skip

    particles: int = 96  # for the own pose  MH08
    pose_every: int  # frames between two updates of the particles, assumed
    pose_bearing_noise: float = 4.0 * DEGREE  # [rad] assumed sd of the bearing of a landmark or goal
    pose_range_noise: float  # [1] of the distance: assumed sd of the distance of a landmark or goal
    pose_fresh: float = 0.02  # [1] least share of particles drawn anew from the landmarks in sight, assumed
    pose_slip: float  # [1] sd of a particle's motion, as a share of it, about twice the robot's slip, assumed
    pose_stuck: float  # [1] share of particles that stay behind: a held robot walks on the spot, assumed
    pose_drift: float  # [m/s^0.5] sd that time adds: pushes are not felt, assumed
    pose_turn_drift: float  # [rad/s^0.5] sd of the heading that time adds, assumed
    pose_push: float  # [m/s] sd that a player near enough to push adds, assumed
    pose_push_turn: float  # [rad/s] sd of the turn that such a player adds, assumed
    pose_radius: float  # [m] within which particles are one cluster, assumed
    pose_angle: float = 0.50  # [rad] within which particles are one cluster, assumed
    pose_fast: float = 0.2  # [1] weight of the newest fit in its short-term average, assumed
    pose_slow: float = 0.02  # [1] weight of the newest fit in its long-term average, assumed
    pose_fit: float = 0.5  # [1] least fit that a localized robot expects, assumed
    pose_fading: float = 3.0  # [1/s] loss of confidence (0 to 100) by dead reckoning alone, assumed
