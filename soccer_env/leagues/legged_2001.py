"""The Sony legged league of 2001: AIBO ERS-210 robots on a walled field of 3 x 2 m.  [Sacks 2001, 1]  MS56

+-----------------------------------------------+   3.0 x 2.0 m, boards all round
|                       |                       |   goals 0.6 m wide, 0.3 m deep
|---+                   |                   +---|   16 control steps a second, gait steps of half a second
+   |                  ( o )                |   +
+   |                   |                   |   +
|---+                   |                   +---|
|                       |                       |
+-----------------------------------------------+
"""

from __future__ import annotations

from dataclasses import replace
from math import pi

from soccer_env.leagues.league import BallModel, League, Pitch, Rules, Slots, Substeps
from soccer_env.leagues.legged_sensors import LeggedMemory, LeggedSensors
from soccer_env.leagues.robot import Body, Drive, Head, Kicker

PITCH = Pitch(
    length=3.0,  # [m] Sacks 2001, 1
    width=2.0,  # [m] Sacks 2001, 1
    goal_width=0.6,  # [m] league rules, remembered, unverified
    goal_depth=0.3,  # [m] league rules, remembered, unverified
    penalty_depth=0.5,  # [m] league rules, remembered, unverified
    penalty_width=1.0,  # [m] league rules, remembered, unverified
    circle=0.15,  # [m] radius; 300 mm across in the 2004 rule book
    walled=True,  # league rules of 2001 to 2004
    post_radius=0.02,  # [m] assumed
    line=0.025,  # [m] 2004 rule book
)

BALL = BallModel(
    radius=0.042,  # [m] a ball 84 mm across: 84 to 86 mm, remembered; 43 mm radius in the 2008 simulator model
    mass=0.05,  # [kg] 40 to 60 g, remembered, unverified
    rolling=0.3,  # [m/s2] plastic on carpet, assumed; -0.26 to -0.7 in the small-size reference
    sliding=3.0,  # [m/s2] small-size reference
    shell=2.0 / 3.0,  # a hollow ball
    elasticity=0.6,  # assumed
    friction=0.3,  # assumed
    top_speed=2.0,  # [m/s] assumed
)

BODY = Body(  # 270 x 155 mm with the forelegs; about 255 x 150 by the ERS-210's kinematics
    mass=1.45,  # [kg] 1.4 to 1.5, remembered
    disc_radius=0.0,
    disc_x=0.0,
    corners=((-0.125, -0.0775), (0.085, -0.0775), (0.105, -0.06), (0.105, 0.06), (0.085, 0.0775), (-0.125, 0.0775)),
    tip_x=0.125,  # [m] forepaws, ahead of the chest; assumed
    tip_y=0.0625,  # [m] shoulders at +-59.2 mm, ERS-210 kinematics
    tip_radius=0.02,  # [m] assumed
    front=0.105,  # [m] the chest, assumed
    reach=0.159,  # [m] outermost point of the paws
    elasticity=0.3,  # assumed
    friction=0.4,  # assumed
    height=0.27,  # [m] 266 to 281 mm, remembered
)

DRIVE = Drive(
    kind="gait",
    forward=0.12,  # [m/s] Sacks 2001, 3.3: "our robots' fastest speed is about 12 cm/second"
    backward=0.10,  # [m/s] assumed
    sideways=0.08,  # [m/s] assumed
    turn=0.8,  # [rad/s] assumed
    acceleration=0.24,  # [m/s2] twice the top speed a second, CMPack'02 walk
    turn_acceleration=1.6,  # [rad/s2] the same
    traction=3.0,  # [m/s2] rubber paws on carpet, assumed
    turn_traction=30.0,  # [rad/s2] assumed
    delay=0.1,  # [s] 0.1 to 0.2, assumed
    gait_steps=8,  # half a second, Sacks 2001, 4.3.2
    slip=0.08,  # 8 %, assumed
    slip_time=0.5,  # [s] a gait step
    fall=0.0,  # off until the foul rules use it
    fall_time=3.0,  # [s] assumed
    leg_disturbance=0.0,  # off: dribbling comes from contact and gait alone  MS51
)

KICKER = Kicker(
    slowest=0.8,  # [m/s] assumed
    fastest=1.5,  # [m/s] assumed
    least=0.3,  # assumed
    wind_up=0.6,  # [s] assumed
    recharge=0.5,  # [s] assumed
    spread=10.0 * pi / 180.0,  # [rad] assumed
    reach=0.03,  # [m] assumed
    half_width=0.045,  # [m] between the paws
    keeper_kicks=True,
)

HEAD = Head(
    pan_limit=89.6 * pi / 180.0,  # [rad] ERS-210 joint table
    tilt_low=-82.0 * pi / 180.0,  # [rad] ERS-210 joint table
    tilt_high=43.0 * pi / 180.0,  # [rad] ERS-210 joint table
    pan_speed=3.011,  # [rad/s] maker's recommendation
    tilt_speed=2.105,  # [rad/s] maker's recommendation
    camera_height=LeggedSensors.neck_height + LeggedSensors.camera_up,  # [m] head level
    camera_ahead=0.142,  # [m] ahead of the body's centre, from the kinematics
)

RULES = Rules(
    half_minutes=10.0,  # rule books of 2004 and 2008
    kick_off_distance=0.4,  # [m] assumed: opponents stay in their own half, outside the circle
    restart_distance=0.4,  # [m] assumed
    restart_time=10.0,  # [s] assumed
    in_play_distance=0.05,  # [m] assumed
    placing_time=10.0,  # [s] assumed
    stuck_time=15.0,  # [s] robots pulled apart after 10 to 20 s, remembered
    stuck_radius=0.10,  # [m] assumed
    separation=0.5,  # [m] assumed
    corner_offset=0.0,
    goal_kick_x=0.5,  # [m] unused on a walled field
    goal_kick_y=0.3,  # [m] unused on a walled field
    drop_x=0.75,  # [m] a quarter of the length, assumed
    drop_y=0.5,  # [m] a quarter of the width, assumed
    contact_time=15.0,  # [s] "after a set time", Sacks 2001, 1; as a stuck ball, assumed  MS55
)

LEAGUE = League(  # MS56
    name="legged-2001",
    family="legged",
    control_rate=16,  # [1/s] camera frames used: four of them are "about 1/4 second", Sacks 2001, 3.1.1
    team_size=3,  # Sacks 2001, 1
    pitch=PITCH,
    ball=BALL,
    body=BODY,
    drive=DRIVE,
    kicker=KICKER,
    head=HEAD,
    rules=RULES,
    slots=Slots(teammates=2, opponents=3),  # Sacks 2001, 4.1.1
    substeps=Substeps(least=2, most=12, travel=0.0125, iterations=10, slop=0.001),
    evaluation_minutes=10.0,  # [min] a half of the league's own length, assumed
    source="Sacks 2001, University of Pennsylvania",
    sensors=LeggedSensors(),
    memory=LeggedMemory(),
)

INNER = replace(LEAGUE, name="legged-2001-inner", pitch=replace(PITCH, length=2.8, width=1.8))  # the other reading
LEGS = replace(LEAGUE, name="legged-2001-legs", drive=replace(DRIVE, leg_disturbance=1.0))  # legs get at the ball  MS51
