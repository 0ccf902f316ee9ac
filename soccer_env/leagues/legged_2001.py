"""The Sony legged league of 2001: AIBO ERS-210 robots on a walled field of 3 x 2 m.  [Sacks 2001, 1]  MS56

+-----------------------------------------------+   3.0 x 2.0 m, boards all round, with ramps of 0.1 m before them
|                       |                       |   goals 0.6 m wide, 0.3 m deep
|---+                   |                   +---|   16 control steps a second, gait steps of half a second
+   |                  ( o )                |   +
+   |                   |                   |   +
|---+                   |                   +---|
|                       |                       |
+-----------------------------------------------+
"""

from dataclasses import replace
from math import pi

from soccer_env.leagues.league import BallModel, League, Pitch, Slots, Substeps
from soccer_env.leagues.legged_sensors import LeggedMemory, LeggedSensors
from soccer_env.leagues.materials import Materials, Pair
from soccer_env.leagues.robot import Block, Body, Drive, Head, Kicker
from soccer_env.leagues.rules import Rules

PITCH = Pitch(
    length=3.0,  # [m] Sacks 2001, 1
    width=2.0,  # [m] Sacks 2001, 1
    goal_width=0.6,  # [m] league rules, remembered, unverified
    goal_depth=0.3,  # [m] league rules, remembered, unverified
    penalty_depth=0.5,  # [m] league rules, remembered, unverified
    penalty_width=1.0,  # [m] league rules, remembered, unverified
    circle=0.15,  # [m] radius; 300 mm across in the 2004 rule book
    walled=True,  # league rules of 2001 to 2004
    # Boards were ramps ("if too much then walk up against ramp", rUNSWift 2003, offEdgeKick.cc), 0.1 m wide in plan
    # ("WALL_THICKNESS = 0; //was 10;", rUNSWift 2005, FieldDef.h): a floor of 2.8 x 1.8 m, which is the other size of
    # the field in sources. Their angle, 45 degrees, is remembered. Where the goal line ran was not found: it stays at
    # the outer edge. The corners of 2003 were cut by triangles; whether those of 2001 were was not found: they are not.
    ramp=0.1,  # [m] sources above
    board_foot=0.075,  # [m] paws step up 25 mm: WALK_HIND_LIFT_INITIAL in Tekkotsu's UPennWalkMC.cc
    post_radius=0.02,  # [m] assumed
    line=0.025,  # [m] 2004 rule book
)

BALL = BallModel(
    radius=0.042,  # [m] a ball 84 mm across: 84 to 86 mm, remembered; 43 mm radius in the 2008 simulator model
    mass=0.05,  # [kg] 40 to 60 g, remembered, unverified
    rolling=0.3,  # [m/s2] plastic on carpet, assumed; -0.26 to -0.7 in the small-size reference
    sliding=3.0,  # [m/s2] small-size reference
    pivot=7.0,  # [rad/s2] 2/3 of the sliding friction at a patch of carpet 4 mm in radius, assumed, over shell r^2
    shell=2.0 / 3.0,  # a hollow ball
    top_speed=2.0,  # [m/s] assumed
)

SMOOTH_BODY = Body(  # of one piece: 270 x 155 mm with the forelegs; about 255 x 150 by the ERS-210's kinematics
    mass=1.45,  # [kg] 1.4 to 1.5, remembered
    disc_radius=0.0,
    disc_x=0.0,
    corners=((-0.125, -0.0775), (0.085, -0.0775), (0.105, -0.06), (0.105, 0.06), (0.085, 0.0775), (-0.125, 0.0775)),
    tip_x=0.125,  # [m] forepaws, ahead of the chest; assumed
    tip_y=0.0625,  # [m] shoulders at +-59.2 mm, ERS-210 kinematics
    tip_radius=0.02,  # [m] assumed
    front=0.105,  # [m] the chest, assumed
    reach=0.159,  # [m] outermost point of the paws
    height=0.27,  # [m] 266 to 281 mm, remembered
)

# With legs: 264 mm long (250 to 274 remembered) and 158 mm wide (152 to 156 remembered).  MS51
#
# Shoulders and hips are 59.5 mm ahead of and behind the centre, 59.2 mm aside (kinematics of the ERS-210), like the
# legs. A forepaw stands 60 mm ahead of its shoulder, a hind paw 45 mm behind its hip: the stance of the walk of
# the University of Pennsylvania of 2004 (touretzkyds/Tekkotsu, Motion/UPennWalkMC.cc: STANCE_FORE_Y0 = 60,
# STANCE_HIND_Y0 = -45), whose robot, the ERS-7, has legs 5 to 10 % longer. Posts right under the shoulders would hold
# the ball 78 mm ahead of the centre, where the camera, 142 mm ahead, never sees it: 135 degrees below the horizon,
# while at the lowest tilt of 82 degrees the picture ends at 106.
BODY = Body(
    mass=1.45,  # [kg] 1.4 to 1.5, remembered
    disc_radius=0.039,  # [m] half the width of the trunk between the legs: shoulders less a leg's thickness, assumed
    disc_x=0.066,  # [m] so that the chest is at 105 mm
    disc_back=0.122,  # [m] so that the rear end is at -95 mm, assumed
    corners=(),
    tip_x=0.1195,  # [m] forepaws: 59.5 + 60 mm
    tip_y=0.0592,  # [m] shoulders
    tip_radius=0.02,  # [m] assumed
    hind_x=-0.1045,  # [m] hind paws: -59.5 - 45 mm
    hind_y=0.0592,  # [m] hips
    front=0.105,  # [m] the chest, assumed
    reach=0.1535,  # [m] outermost point of the forepaws
    height=0.27,  # [m] 266 to 281 mm, remembered
    legs=True,
    inertia=(0.270**2 + 0.155**2) / 12.0,  # [m2] a rectangle of 270 x 155 mm, about the size of the ERS-210, remembered
)

MATERIALS = Materials(
    ball_board=Pair(0.7, 0.3),  # hard hollow plastic on painted wood, assumed
    ball_post=Pair(0.7, 0.3),  # the ends of the same boards
    ball_net=Pair(0.05, 0.3),  # assumed: a goal catches the ball
    ball_robot=Pair(0.5, 0.3),  # plastic on plastic shells and rubber paws of jointed legs, assumed
    robot_robot=Pair(0.1, 0.4),  # jointed legs give way, assumed
    robot_board=Pair(0.1, 0.4),  # rubber paws on wood, assumed
)

DRIVE = Drive(
    kind="gait",
    forward=0.12,  # [m/s] Sacks 2001, 3.3: "our robots' fastest speed is about 12 cm/second"
    backward=0.10,  # [m/s] assumed
    sideways=0.08,  # [m/s] assumed
    turn=0.8,  # [rad/s] assumed
    acceleration=0.24,  # [m/s2] twice the top speed a second, CMPack'02 walk
    turn_acceleration=1.6,  # [rad/s2] twice the top turn rate a second, CMPack'02 walk
    traction=3.0,  # [m/s2] rubber paws on carpet, all four, assumed
    thrust=3.0,  # [m/s2] the traction: in a trot two of four paws carry the whole weight (Coulomb)
    turn_traction=30.0,  # [rad/s2] assumed
    turn_thrust=15.0,  # [rad/s2] half the turn traction
    delay=0.1,  # [s] 0.1 to 0.2, assumed
    gait_steps=8,  # half a second, Sacks 2001, 4.3.2
    slip=0.08,  # 8 %, assumed
    slip_time=0.5,  # [s] a gait step
    fall=0.0,  # off: no source says how often a robot on four paws fell
    fall_time=3.0,  # [s] assumed
)

KICKER = Kicker(
    slowest=0.8,  # [m/s] assumed
    fastest=1.5,  # [m/s] assumed
    least=0.3,  # assumed
    wind_up=0.6,  # [s] assumed
    recharge=0.5,  # [s] assumed
    spread=10.0 * pi / 180.0,  # [rad] assumed
    speed_spread=0.15,  # assumed: a leg repeats its swing to 10 to 20 %
    miss=0.5,  # assumed: every second kick at a ball beside a paw misses
    reach=0.03,  # [m] assumed
    half_width=0.045,  # [m] between the paws
    keeper_kicks=True,
    aside=50.0 * pi / 180.0,  # [rad] the UPenn kick: UPENN_OFFSET_ANGLE = 50, rUNSWift 2005, sUpennKick
    aside_wind_up=0.8,  # [s] UPENN_DURATION = 24 frames at 30 a second, sUpennKick
    squirt=0.5,  # assumed: every second kick at a ball between two robots lifts it out aside
    squirt_way=0.14,  # [m] aside: over a forepaw, its radius and the ball's, 121 mm, and a little more, assumed
)

# The block of a goalkeeper, only in the variant legged-2001-block.  MS53
#
# The motion is the goalkeeper's block in the middle of CMPack'03, a team with the same robot: `b_gcntr.mot` in Tekkotsu
# 4.0 (tools/convertmot/cmpack03-littleendian; its format is in tools/convertmot/convertmot.cc). The body is lowered,
# nose first; both forepaws move to (120, +-170) mm from its centre, stay there for 500 ms and are drawn in. That place
# is out of reach, so the inverse kinematics of the robot (Motion/OldKinematics.cc) stretches the leg towards it: seen
# from above a straight line from the shoulder through the knee at (91, 113) to the paw, 170 mm aside.
#
# The file gives 200 ms for the way out, too little for the joints: from the stance (angles by the same kinematics) the
# rotator has to turn by 77.3 degrees, the shoulder by 57.6, the knee by 50.9, at 2.81, 2.50 and 2.84 rad/s
# (Shared/ERS210Info.h): 0.48, 0.40 and 0.31 s. The team's dive to one side (`b_gdive.mot`) is left out: it topples the
# robot, and kinematics alone does not say how far the robot then lies aside.
BLOCK_MOTION = Block(
    raise_time=0.48,  # [s] the rotator's 77.3 degrees at 2.81 rad/s
    hold_time=0.5,  # [s] b_gcntr.mot
    recover_time=0.48,  # [s] the rotator's way back
    paw_x=0.12,  # [m] b_gcntr.mot
    paw_y=0.17,  # [m] b_gcntr.mot
    shoulder_x=0.0595,  # [m] ERS-210 kinematics
    shoulder_y=0.0592,  # [m] ERS-210 kinematics
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
    drop_distance=0.5,  # [m] a robot has room behind the ball on each side, assumed
    contact_time=15.0,  # [s] "after a set time", Sacks 2001, 1; assumed: the time of a stuck ball  MS55
    pardon=True,
    pushing=True,
    keeper_pushing=True,
    holding=True,
    illegal_defender=True,
    leaving_field=True,
    falling=True,
    kick_off_shot=True,
    local_stuck=True,
    global_stuck=True,
)

LEAGUE = League(  # MS56
    name="legged-2001",
    family="legged",
    control_rate=16,  # [1/s] camera frames used: four of them are "about 1/4 second", Sacks 2001, 3.1.1
    team_size=3,  # Sacks 2001, 1
    pitch=PITCH,
    ball=BALL,
    body=BODY,
    materials=MATERIALS,
    drive=DRIVE,
    kicker=KICKER,
    head=HEAD,
    rules=RULES,
    slots=Slots(teammates=2, opponents=3),  # Sacks 2001, 4.1.1
    substeps=Substeps(least=2, close=4, most=12, travel=0.0125, iterations=10, jam_iterations=20, slop=0.001),
    evaluation_minutes=10.0,  # [min] a half of the league's own length, assumed
    source="Sacks 2001, University of Pennsylvania",
    sensors=LeggedSensors(),
    memory=LeggedMemory(),
)

# Upright boards, against which the ball can lie
UPRIGHT = replace(LEAGUE, name="legged-2001-upright", pitch=replace(PITCH, ramp=0.0, board_foot=0.0))
SMOOTH = replace(LEAGUE, name="legged-2001-smooth", body=SMOOTH_BODY)  # a body of one piece, without legs
BLOCK = replace(LEAGUE, name="legged-2001-block", block=BLOCK_MOTION)  # its goalkeepers can spread their forelegs
