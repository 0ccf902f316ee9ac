"""The numbers and switches of the middle-size team of 2006.  [Heinemann 2006, 2, 3, 4]

The paper gives few numbers; numbers marked "assumed" are ours. Every idea that the paper tests with and without is a
switch.
"""

from dataclasses import dataclass

import numpy as np

from soccer_env.baselines.chaser import team as chaser
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.leagues.options import Options
from soccer_env.leagues.robot import DRIVE_KINDS

PLANNERS = {"time_variant": 0, "static": 1, "none": 2}
KEEPERS = {"active": 0, "passive": 1}
STANCES = {"circle": 0, "line": 1}
SHARE = (0.0, 1.0)
TIME = (0.01, 10.0)
FAR = (0.01, 20.0)


@dataclass(frozen=True)
class HeinemannSettings(Options):
    """The settings of heinemann-2006; `make_team("heinemann-2006", planner="static")` changes a switch by name."""

    NAMES = {"planner": PLANNERS, "keeper": KEEPERS, "stance": STANCES}
    BOUNDS = {
        "strength": SHARE, "slowest": SHARE, "laziest": TIME, "crookedest": (0.0, 3.0), "dribble_room": (0.0, 5.0),
        "dribble_ahead": FAR, "cycle": TIME, "look_ahead_time": TIME, "look_ahead": FAR, "turning": SHARE,
        "bending": SHARE, "arrived": FAR, "fastest": (0.0, 20.0), "close": FAR, "keeper_reach": FAR,
        "keeper_radius": FAR, "keeper_out": FAR, "dribble_speed": FAR, "dribble_grip": FAR, "dribble_turn": FAR,
        "run_in": FAR,
        "pass_arrival": (0.0, 10.0), "pass_near": FAR, "pass_far": FAR, "pass_gain": (-20.0, 20.0),
        "pass_back": (-20.0, 20.0), "pass_room": (-1.0, 1.0), "pass_free": (0.0, 20.0), "pass_cosine": (-1.0, 1.0),
        "role_time": TIME, "word_delay": (0.0, 10.0),
    }  # fmt: skip

    strength: float = 1.0  # [1] 0 to 1: pace, how often it decides, how straight it aims, how hard it kicks
    slowest: float = 0.5  # [1] pace at strength 0, assumed: the chaser's 0.8 takes nothing off its points
    laziest: float = 0.3  # [s] between two decisions at strength 0, assumed
    crookedest: float = 0.3  # [rad] deviation of the aim at strength 0, assumed

    cycle: float = 0.02  # [s] between two decisions at least, Heinemann 2006, 2  MH03

    # ways, 3
    planner: str = "time_variant"  # static: that of Weigel et al.; none: bent aside from who is near  MH14, MH17
    velocity: bool = True  # others move as believed; False: they are planned round as if they stood  MH15
    fastest: float = 5.0  # [m/s] that an obstacle is taken to move at most, Heinemann 2006, 3  MH25
    keeps_off: float = 0.0  # [m] more than two radii that a way keeps from others' middles, assumed

    # driving, 2, 3
    look_ahead: float = 0.25  # [m] along the path that is driven to at least, assumed
    look_ahead_time: float = 0.2  # [s] at the robot's speed that is looked ahead beyond it, assumed
    bending: float = 0.7  # [1] share of the acceleration that a bend of the path may take, assumed
    turning: float = 0.4  # [1] share of the acceleration that turning at speed may take, assumed  MH01
    arrived: float = 0.06  # [m] from a place at which a robot is there, assumed

    # the goalkeeper, 4
    keeper: str = "active"  # moves into the ball's trajectory; passive: stays on the line ball to goal  MH19, MH20
    stance: str = "circle"  # half circle before the goal; line: on the goal line, 4  MH19
    keeper_radius: float = 1.2  # [m] of the half circle about the middle of the goal, assumed: 0.7 lets in more  MH19
    keeper_out: float = 0.35  # [m] from the goal line of a keeper on it, assumed: clear of the posts  MH19
    shot_speed: float = 0.5  # [m/s] of a ball that is taken for a shot, assumed  MH20
    shot_wide: float = 0.25  # [m] beside the posts that a shot may be believed to cross, assumed  MH20
    keeper_reach: float = 0.2  # [m] from its middle that a keeper stops a ball, assumed: the disc, 22 cm  MH20
    keeper_waits: bool = True  # takes the first point of the trajectory that it can be at in time; False: the nearest
    reaction: float = 0.1  # [s] from perception to motion: the league's delay, 0.1 to 0.2  MH21

    # play
    intercepts: bool = True  # goes to where a rolling ball can be met first; False: to where it is  MH22
    lead: float = 3.0  # [s] at most by which a rolling ball is led, assumed  MH22
    # At 0.7 m, with players at the ball as obstacles too, it touches others as often more than 1.2 m from the ball:
    # 6.4 +- 0.9 times a minute against 7.0 +- 0.9 (5 v 5 chaser), 2.5 +- 0.3 against 2.3 +- 0.4 (3 v 3). Half of these
    # touches are with mates, and four fifths of those with opponents within 2 m of the ball.
    close: float = 1.2  # [m] from the ball from which it is gone round without a plan, assumed
    run_in: float = 2.6  # [m/s] at which a ball is run at at most; up to 1 m/s it is met with care, assumed
    dribble_speed: float = 1.56  # [m/s] with the ball, assumed: 0.6 of the top speed; 2.2 CAMBADA
    dribble_grip: float = 0.35  # [m/s2] aside that the guide gives a ball, measured: 0.2 kept it, 0.5 lost it
    dribbles_round: bool = False  # True: along a plan round the others, not the way with the most room  MH24
    dribble_ahead: float = 0.7  # [m] along the plan that the ball is dribbled to, assumed
    dribble_room: float = 0.1  # [m] more than without the ball that is kept off others, assumed
    dribble_turn: float = 4.0  # [rad/s] with the ball at most, assumed
    passes: bool = True  # passes to mates; False: dribbles and shoots alone  MH04
    stands_open: bool = False  # True: supporters stand ahead of the ball for a pass, not behind it; it let in more
    pass_strength: bool = True  # as hard as the mate can take the ball; False: with all strength  MH04
    pass_arrival: float = 1.2  # [m/s] of a pass where the mate stands, assumed
    pass_near: float = 1.2  # [m] of a pass at least, assumed: nearer mates are in the way
    pass_far: float = 6.0  # [m] of a pass at most, assumed
    pass_gain: float = 3.0  # [m] nearer to the goal that a pass must bring, assumed
    pass_back: float = 0.0  # [m] farther from it that a pass may bring who is pressed, assumed
    pass_room: float = 0.05  # [rad] beside a pass past opponents, assumed
    pass_free: float = 1.3  # [m] from the mate to the nearest opponent at least, assumed
    pass_cosine: float = 0.995  # cosine of the angle off the pass at which it is kicked: 6 degrees, assumed
    word_delay: float = 0.06  # [s] of the referee box's word by radio, the sensors' `radio_delay`: assumed  MH05
    role_time: float = 0.3  # [s] for which another role has to be right before it is taken, assumed
    role_gain: float = 0.4  # [m] by which another must be nearer before a role is given up, assumed


SKILLS = chaser().settings.dtype
TEAM_SETTINGS = np.dtype(
    [
        *HeinemannSettings().record().dtype.descr,
        ("skills", SKILLS),  # numbers of the skills that are shared with the chaser, for this kind of base
        ("ways", PlannerSettings().record().dtype, (1,)),  # of the planner; pitch and speed are the league's
    ]
)


def settings_records(settings: HeinemannSettings) -> np.ndarray:
    """Return the settings as records for compiled code, one for each of `DRIVE_KINDS`."""
    rows = np.zeros(len(DRIVE_KINDS), TEAM_SETTINGS)
    own = settings.record()
    for name in own.dtype.names or ():
        rows[name] = own[name]
    rows["skills"] = chaser(settings.strength).settings
    rows["ways"][:] = PlannerSettings(time_variant=settings.planner == "time_variant").record()
    return rows
