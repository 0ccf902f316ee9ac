"""The sensors of an ERS-210, and the memory of Sacks's software, as numbers with their sources.

Every number was written down before the first claim was measured with it. "assumed" marks a guess of ours.
"""

from dataclasses import dataclass
from math import pi, tan

from soccer_env.leagues.options import GREATEST, SIGNED, Options
from soccer_env.leagues.pose_memory import PoseMemory

DEGREE = pi / 180.0
SMALLEST_WIDTH, SMALLEST_HEIGHT = 44.0, 36.0  # [px] of the smallest layer; each step of resolution doubles them
RESOLUTIONS = {"44x36": 0, "88x72": 1, "176x144": 2}  # working layers of the camera, ERS-210 data sheet
RANGES = {"size": 0, "infrared": 1}
SIZES = {"closer": 0, "height": 1, "width": 2}
ODOMETRY = {"full": 0, "rotation": 1, "none": 2}
POSITIONS = {"filtered": 0, "raw": 1}
SLOTS = {"all": 0, "nearest": 1}
PLAYER_BLOBS = {"largest": 0, "combined": 1}
PLAYER_VIEWS = {"front": 0, "side": 1}
PROBABILITIES = ("ball_miss", "player_miss", "sticker_miss", "landmark_miss", "red_as_orange", "audio_loss")
LENGTHS = ("patch_size", "goal_height", "landmark_radius", "head_size", "trunk_height", "infrared_far")
PATCHES_MOST = 64  # room in a sketch of the picture, shared with other orange things
STICKERS_MOST = 3  # on a side of the trunk: room in a sketch of the picture
AVERAGED_MOST = 6  # estimates of the ball's position: room in a robot's memory


@dataclass(frozen=True)
class LeggedSensors(Options):
    """Camera, infrared ranger, odometry, touch, tilt and loudspeaker of an ERS-210.  MS04, MS05, MS06, MS37"""

    KIND = "legged"
    HAS_RANGER = True  # an infrared ranger, whose obstacle is in beliefs and in observations of beliefs
    NAMES = {"resolution": RESOLUTIONS}
    BOUNDS = {
        **dict.fromkeys(PROBABILITIES, (0.0, 1.0)), **dict.fromkeys(LENGTHS, (0.001, GREATEST)),
        **dict.fromkeys(("view_width", "view_height"), (DEGREE, 179.0 * DEGREE)),
        **dict.fromkeys(("camera_up", "sticker_head_x"), SIGNED),
        "scale_error": (0.0, 0.5), "patches": (0.0, PATCHES_MOST),
        "trunk_stickers": (1, STICKERS_MOST),
    }  # fmt: skip
    ORDER = (
        ("patch_low", "at most", "patch_high"), ("landmark_low", "at most", "landmark_high"),
        ("trunk_low", "at most", "trunk_height"), ("infrared_near", "at most", "infrared_far"),
    )  # fmt: skip
    DERIVED = {
        "picture_width": lambda s: s.layer() * SMALLEST_WIDTH,  # [px]
        "picture_height": lambda s: s.layer() * SMALLEST_HEIGHT,  # [px]
        "focal_x": lambda s: 0.5 * s.layer() * SMALLEST_WIDTH / tan(0.5 * s.view_width),  # [px]
        "focal_y": lambda s: 0.5 * s.layer() * SMALLEST_HEIGHT / tan(0.5 * s.view_height),  # [px]
    }
    EVEN = {"patches": "for patches stand in pairs opposite each other"}

    resolution: str = "88x72"  # [px] the layer of the paper's "low resolution camera" (claim S15)
    view_width: float = 57.6 * DEGREE  # [rad] ERS-210 data sheet
    view_height: float = 47.8 * DEGREE  # [rad] ERS-210 data sheet
    neck_ahead: float = 0.075  # [m] neck pivot ahead of the body's centre, CMPack'02 kinematics
    neck_height: float = 0.155  # [m] neck pivot over the ground: 105 mm stance and 50 mm, CMPack'02 kinematics
    camera_ahead: float = 0.0666  # [m] camera ahead of the pivot, head level, CMPack'02 kinematics
    camera_up: float = 0.048  # [m] camera above the pivot, head level, CMPack'02 kinematics
    dither: float = 0.45  # [px] sd of a blob's width, height and place: walk and threshold flicker, 0.3 to 0.6 assumed
    scale_error: float = 0.03  # [1] sd of a robot's own scale of sizes, drawn once an episode, assumed
    ball_miss: float = 0.02  # [1] probability that a frame misses the ball, assumed
    player_miss: float = 0.02  # [1] probability that a frame misses a whole player, assumed: as the ball  MS37
    sticker_miss: float = 0.03  # [1] probability that a frame misses one sticker, assumed: 5 % with player_miss  MS37
    landmark_miss: float = 0.05  # [1] probability that a frame misses a goal or landmark, assumed
    # CMVision, the vision library of those years, drops regions below CMV_MIN_AREA = 10 or 20 of 320x240 pixels: as
    # shares of the picture 0.8 or 1.7 of 88x72.
    least_area: float = 2.0  # [px] at 88x72, smaller regions of any colour are dropped, assumed: as `area_small`  MS14
    patches: float = 2.0  # orange patches round the field in each match, an even number: in pairs, assumed
    patch_size: float = 0.08  # [m] across, assumed
    patch_low: float = 0.3  # [m] lowest height of a patch: above the boards, assumed
    patch_high: float = 1.0  # [m] greatest height, assumed
    patch_away: float = 0.5  # [m] distance from the boards, assumed
    red_as_orange: float = 0.02  # [1] probability that a frame shows an orange spot on a sticker, assumed
    board_height: float = 0.10  # [m] boards hide lower things behind them, assumed
    goal_height: float = 0.30  # [m] league rules, remembered, unverified
    landmark_radius: float = 0.05  # [m] cylinders about 10 cm wide, remembered, unverified
    landmark_low: float = 0.20  # [m] lower edge of the colours, remembered, unverified
    landmark_high: float = 0.40  # [m] upper edge of the colours, remembered, unverified
    trunk_height: float = 0.18  # [m] of a robot's trunk, assumed
    trunk_low: float = 0.05  # [m] underside of the trunk between the legs, assumed
    head_size: float = 0.09  # [m] cube that stands for the head, assumed
    jersey: float = 1.0  # [1] scale of all stickers; S37 to S39 are run from 0.7 to 1.3
    trunk_stickers: int = 2  # on each side: "multiple stickers attached to given parts", 4.1.1; how many: assumed  MS37
    sticker_flank_width: float = 0.06  # [m] assumed
    sticker_flank_height: float = 0.06  # [m] assumed
    sticker_flank_apart: float = 0.119  # [m] between middles: from shoulder to hip, CMPack'02 kinematics
    sticker_chest_width: float = 0.045  # [m] assumed
    sticker_chest_height: float = 0.055  # [m] assumed: "slightly smaller", Sacks 2001, 4.1.2
    sticker_chest_apart: float = 0.05  # [m] between middles, assumed: a lowered head hides both, Sacks 2001, 4.3.3
    sticker_rump_width: float = 0.045  # [m] assumed
    sticker_rump_height: float = 0.055  # [m] assumed
    sticker_rump_apart: float = 0.05  # [m] between middles, assumed
    sticker_head_width: float = 0.05  # [m] assumed
    sticker_head_height: float = 0.035  # [m] assumed
    sticker_head_x: float = 0.02  # [m] head stickers ahead of the neck pivot, assumed
    trunk_sticker_middle: float = 0.13  # [m] height of the trunk stickers' middle, assumed
    head_sticker_middle: float = 0.225  # [m] height of the head stickers' middle, head level, assumed
    head_down: float = 30.0 * DEGREE  # [rad] lower heads hide stickers, Sacks 2001, 4.3.3; assumed
    infrared_near: float = 0.10  # [m] readings below are discarded, Sacks 2001, 2  MS05
    infrared_far: float = 0.90  # [m] readings above are discarded, Sacks 2001, 2  MS05
    infrared_noise: float = 0.004  # [m] sd close by, assumed so that the law crosses the size law at 40 cm
    infrared_growth: float = 0.018  # [m] sd at 0.4 m, assumed like infrared_noise
    infrared_power: float = 3.0  # [1] growth with the distance over 0.4 m, assumed like infrared_noise
    infrared_pointing: float = 1.5 * DEGREE  # [rad] sd of the beam's direction, assumed
    odometry_noise: float = 0.03  # [1] sd of each component of a step's displacement, assumed; slip comes on top
    pose_noise: float = 0.08  # [m] sd of the noisy pose made by perception/body.py, assumed
    pose_turn_noise: float = 0.10  # [rad] sd of the heading of the noisy pose, assumed
    pose_time: float = 1.0  # [s] correlation time of the errors of the noisy pose, assumed
    place_noise: float = 0.03  # [m] sd between a robot's place at a restart and the place that it is told, assumed
    place_turn_noise: float = 0.05  # [rad] sd between its heading and the heading that it is told, assumed
    audio_period: float = 1.0  # [s] between two words of 4 bits: 4 bits a second, assumed
    audio_delay: float = 0.5  # [s] assumed
    audio_loss: float = 0.2  # [1] share of words that are not understood, assumed

    def layer(self) -> int:
        """Return by how much the picture is larger than the smallest layer."""
        return 1 << RESOLUTIONS[self.resolution]


@dataclass(frozen=True)
class LeggedMemory(PoseMemory):
    """The memory of a robot of Sacks's team; every rule is a switch.  [Sacks 2001, 3, 4.1]  MS52"""

    NAMES = {
        "ball_range": RANGES, "ball_size": SIZES, "odometry": ODOMETRY, "radial_from": POSITIONS,
        "angular_from": POSITIONS, "slots": SLOTS, "player_blob": PLAYER_BLOBS, "player_view": PLAYER_VIEWS,
    }  # fmt: skip
    BOUNDS = {"averaged": (1, AVERAGED_MOST)}
    # A velocity needs two readings; after a near sighting the ball must not need a smaller blob than after a far one.
    ORDER = (("velocity_interval", "at most", "velocity_gap"), ("area_small", "at most", "area_large"))

    fading: float = 10.0  # [1/s] loss of confidence (0 to 100) in an object out of sight, assumed  MS03
    ball_range: str = "size"  # infrared: the ranger alone, the experiment of 3.1.1  MS09
    ball_size: str = "closer"  # the closer of height and width  MS11
    under_head: bool = True  # height / tan(tilt) when the ball is almost under the head  MS10
    under_head_tilt: float = 55.0 * DEGREE  # [rad] down to the ball, from which under_head holds, assumed
    infrared_override: bool = True  # the ranger wins below a share of the size range  MS12
    infrared_share: float = 2.0 / 3.0  # [1] Sacks 2001, 3.1.1
    centred: float = 0.0  # [rad] off the blob at which it is still "in the center of the camera image", 3.1.1  MS12
    horizon: bool = True  # a blob much above the horizontal is no ball  MS13
    horizon_angle: float = 5.0 * DEGREE  # [rad] "much above", assumed
    double_area: bool = True  # a larger least area after a near sighting  MS14
    area_small: float = 2.0  # [px] at 88x72, least area, assumed
    area_large: float = 12.0  # [px] at 88x72, least area after a near sighting, assumed
    area_recent: float = 1.0  # [s] "recently", assumed
    area_near: float = 0.8  # [m] "nearby", assumed
    odometry: str = "full"  # rotation: the old memory, bearing alone; none  MS15
    odometry_while_dribbling: bool = False  # footnote 2  MS15
    averaged: int = 4  # estimates in the filtered position; 1 switches the filter off  MS16
    averaged_within: float = 1.0  # [s] older estimates drop out of the filtered position, assumed  MS16
    velocity_interval: float = 1.0 / 3.0  # [s] Sacks 2001, 3.2  MS17
    velocity_gap: float = 1.5  # [s] longest time between two sightings for a velocity, Sacks 2001, 3.2  MS17
    velocity_gate: bool = True  # False: a velocity after every gap  MS17
    radial_from: str = "filtered"  # footnote 4  MS18
    angular_from: str = "raw"  # footnote 4  MS18
    slots: str = "all"  # nearest: the old memory, only the nearest player of each team  MS28
    grouping: float = 3.0  # [mean sizes] gap within which two blobs are one player  MS29
    distance_power: float = 3.0  # [1] of the matching  MS30, MS31
    angle_power: float = 1.0  # [1] of the matching, 0 switches the angle off  MS30, MS31
    empty_distance: float = 1.0  # [m] distance of an empty slot from a player in sight, assumed  MS30
    empty_angle: float = 1.0  # [rad] angle between an empty slot and a player in sight, assumed  MS30
    uncertainty_least: float = 0.5  # just seen  MS32
    uncertainty_most: float = 100.0  # not seen in a long time  MS32
    uncertainty_growth: float = 100.0 / 30.0  # [1/s] assumed: a long time is half a minute  MS32
    player_blob: str = "largest"  # combined: the box round all blobs of a player  MS34
    player_view: str = "front"  # the view from which the height table was made  MS33
    player_infrared: bool = True  # MS35
    player_infrared_far: float = 0.40  # [m] "its maximum reliable range", Sacks 2001, 4.1.2  MS35, MS49
    player_odometry: bool = True  # MS36
    obstacle: bool = True  # a reading significantly closer than every player is an obstacle  MS49
    obstacle_share: float = 2.0 / 3.0  # [1] of the nearest player's distance: "significantly", assumed as in MS12
    obstacle_margin: float = 0.02  # [m] above ball and boards, twice the error of a near reading's height, assumed
    ghost_time: float = 20.0  # [s] unseen after which a slot counts as empty, assumed
    dribbling_distance: float = 0.20  # [m] a ball ahead and nearer than this is being dribbled, assumed: chest and ball
    search_after: float = 1.0  # [s] unseen before the head searches, assumed
    search_period: float = 3.0  # [s] of one sweep of the searching head, assumed
    # The own pose, all assumed; PoseMemory defines these fields.
    pose_every: int = 4
    pose_range_noise: float = 0.25
    pose_slip: float = 0.15
    pose_stuck: float = 0.05
    pose_drift: float = 0.02
    pose_turn_drift: float = 0.03
    pose_push: float = 0.02
    pose_push_turn: float = 0.1
    pose_radius: float = 0.30
