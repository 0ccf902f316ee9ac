"""The middle-size league of 2006: omnidirectional robots on a field of 12 x 8 m.  [Heinemann et al. 2006, 2]  MH23

    +----|  |   50 control steps a second
| +|-+  |               .--+--.               |  +-|+ |
| || |  |              (   o   )              |  | || |
| +|-+  |               '--+--'               |  +-|+ |
|  |----+                  |                  +----|  |
|  |                       |                       |  |
|  +-----------------------+-----------------------+  |
+-----------------------------------------------------+
"""

from dataclasses import replace
from math import pi

from soccer_env.leagues.league import BallModel, League, Pitch, Slots, Substeps
from soccer_env.leagues.materials import Materials, Pair
from soccer_env.leagues.omni_sensors import OmniMemory, OmniSensors
from soccer_env.leagues.robot import Body, Drive, Head, Kicker
from soccer_env.leagues.rules import Rules

PITCH = Pitch(  # MH23
    length=12.0,  # [m] Tribots 2005 field geometry
    width=8.0,  # [m] Tribots 2005 field geometry
    goal_width=2.0,  # [m] Tribots 2005 field geometry
    goal_depth=0.5,  # [m] Tribots 2005 field geometry
    penalty_depth=1.5,  # [m] Tribots 2005 field geometry
    penalty_width=5.0,  # [m] Tribots 2005 field geometry
    goal_area_depth=0.5,  # [m] Tribots 2005 field geometry
    goal_area_width=3.0,  # [m] Tribots 2005 field geometry
    circle=1.0,  # [m] radius; Paderborn 2005 field
    walled=False,
    band_side=1.0,  # [m] Tribots 2005
    band_end=0.5,  # [m] Tribots 2005: the goals reach the boards
    post_radius=0.0625,  # [m] assumed: posts as thick as the later lines, 125 mm
    line=0.05,  # [m] Tribots 2005
)

BALL = BallModel(
    radius=0.11,  # [m] FIFA size 5
    mass=0.43,  # [kg] 410 to 450 g, FIFA
    rolling=0.4,  # [m/s2] 0.3 to 0.6 on thin carpet, remembered
    sliding=3.0,  # [m/s2] small-size reference
    pivot=3.7,  # [rad/s2] 2/3 of the sliding friction at a patch of carpet 15 mm in radius, assumed, over shell r^2
    shell=2.0 / 3.0,  # a hollow ball: it rolls at 0.6 of the speed of a kick
    top_speed=11.0,  # [m/s] the kicker's 10 m/s on a moving robot, assumed
)

BODY = Body(  # a round base that fits 50 x 50 cm, with a guide that holds a quarter of the ball
    mass=30.0,  # [kg] at most 80 by the rules, assumed
    disc_radius=0.22,  # [m] outline 440 x 470 mm, Tribots 2005
    disc_x=-0.04,  # [m] so that the kicker lies at 180 mm, Tribots 2005
    corners=(),
    tip_x=0.19,  # [m] guide, assumed
    tip_y=0.15,  # [m] guide, assumed
    tip_radius=0.045,  # [m] guide, assumed
    front=0.18,  # [m] kicker, Tribots 2005; 55 mm of the ball lie within the hull, of 73 mm (a third) allowed
    reach=0.287,  # [m] outermost point of the guide
    height=0.8,  # [m] at most 0.85 by the rules
)

MATERIALS = Materials(
    ball_board=Pair(0.7, 0.3),  # assumed
    ball_post=Pair(0.7, 0.3),  # assumed
    ball_net=Pair(0.05, 0.3),  # assumed: a goal catches the ball
    # From steel a size 5 ball bounces with sqrt(1.25 / 2) to sqrt(1.55 / 2) = 0.79 to 0.88 in FIFA's drop test from
    # 2 m; a robot's thin panels give way.
    ball_robot=Pair(0.6, 0.3),  # assumed
    robot_robot=Pair(0.2, 0.3),  # assumed
    robot_board=Pair(0.2, 0.3),  # assumed
)

DRIVE = Drive(  # MH01
    kind="omnidirectional",
    forward=2.6,  # [m/s] Heinemann et al. 2006, 2
    backward=2.6,  # [m/s] Heinemann et al. 2006, 2
    sideways=2.6,  # [m/s] Heinemann et al. 2006, 2
    turn=6.0,  # [rad/s] assumed; 3.0 in Tribots 2005
    acceleration=4.0,  # [m/s2] 3 to 5, Falcons, Tribots 2005
    turn_acceleration=20.0,  # [rad/s2] assumed; 12 in Tribots 2005
    traction=6.0,  # [m/s2] rubber rollers on carpet, friction 0.6, assumed
    thrust=4.0,  # [m/s2] the motors' braking, Tribots 2005
    turn_traction=30.0,  # [rad/s2] assumed
    turn_thrust=20.0,  # [rad/s2] assumed
    delay=0.1,  # [s] 0.14 CAMBADA, 0.2 Tribots 2005; a default of this package
    gait_steps=1,
    slip=0.02,  # assumed
    slip_time=0.5,  # [s] assumed
    fall=0.0,
    fall_time=0.0,
)

DIFFERENTIAL = Drive(  # the Pioneer 2 of the years before
    kind="differential",
    forward=1.6,  # [m/s] Heinemann et al. 2006, 1
    backward=1.6,  # [m/s] Heinemann et al. 2006, 1
    sideways=0.0,
    turn=4.0,  # [rad/s] assumed
    acceleration=2.0,  # [m/s2] assumed
    turn_acceleration=10.0,  # [rad/s2] assumed
    traction=6.0,  # [m/s2] rubber wheels on carpet, friction 0.6, assumed
    thrust=2.0,  # [m/s2] its acceleration
    turn_traction=30.0,  # [rad/s2] assumed
    turn_thrust=10.0,  # [rad/s2] its turn acceleration
    delay=0.1,  # [s] assumed
    gait_steps=1,
    slip=0.02,  # assumed
    slip_time=0.5,  # [s] assumed
    fall=0.0,
    fall_time=0.0,
)

KICKER = Kicker(
    slowest=0.0,  # [m/s] Heinemann et al. 2006, 2: strength is set in real time
    fastest=10.0,  # [m/s] Heinemann et al. 2006, 2  MH04
    least=0.0,
    wind_up=0.0,
    recharge=1.0,  # [s] assumed
    spread=2.0 * pi / 180.0,  # [rad] assumed
    speed_spread=0.05,  # assumed: charge of the capacitors, friction of the plunger
    miss=0.2,  # assumed
    reach=0.04,  # [m] assumed
    half_width=0.08,  # [m] a kicker 210 mm wide, Tribots 2005; assumed to hit cleanly within 160 mm
    keeper_kicks=False,  # "all field players", Heinemann et al. 2006, 2
)

RULES = Rules(
    half_minutes=15.0,  # remembered
    kick_off_distance=2.0,  # [m] remembered
    restart_distance=1.0,  # [m] remembered
    restart_time=10.0,  # [s] remembered
    in_play_distance=0.2,  # [m] 0.2 to 0.5, remembered
    placing_time=10.0,  # [s] assumed
    stuck_time=10.0,  # [s] assumed
    stuck_radius=0.3,  # [m] assumed
    separation=1.0,  # [m] assumed
    corner_offset=0.2,  # [m] assumed
    goal_kick_x=1.5,  # [m] the penalty area's edge, assumed
    goal_kick_y=1.5,  # [m] assumed
    drop_distance=0.0,  # [m] there are no boards
    direct_kick_off=False,  # remembered: all restarts of the middle size were indirect
    direct_throw_in=False,
    direct_goal_kick=False,
    direct_corner_kick=False,
    direct_free_kick=False,
    second_touch=True,  # FIFA 2005, Laws 8 and 13 to 17
    distances=True,  # FIFA 2005, Laws 8 and 13 to 17
    charging=True,  # FIFA 2005, Law 12; its numbers are assumed
    keeper_charge=True,  # FIFA 2005, Law 12
    handling=True,  # remembered
    goal_area=True,  # remembered
    penalty_area=True,  # remembered
    cards=True,  # FIFA 2005, Law 12; the number of fouls is assumed
)

LEAGUE = League(
    name="middle-size-2006",
    family="middle-size",
    control_rate=50,  # [1/s] Heinemann et al. 2006, 2: a global cycle of 20 ms  MH03
    team_size=5,  # rules of 2006
    pitch=PITCH,
    ball=BALL,
    body=BODY,
    materials=MATERIALS,
    drive=DRIVE,
    kicker=KICKER,
    head=Head(camera_height=0.75),  # [m] omnidirectional camera, assumed
    rules=RULES,
    slots=Slots(teammates=4, opponents=5),
    substeps=Substeps(least=2, close=4, most=8, travel=0.044, iterations=10, jam_iterations=100, slop=0.002),
    evaluation_minutes=4.0,  # [min] assumed
    evaluation_placement="drive",
    source="Heinemann et al. 2006, University of Tübingen",
    sensors=OmniSensors(),
    memory=OmniMemory(),
)

OLD_BASE = replace(LEAGUE, name="middle-size-2006-differential", drive=DIFFERENTIAL)
