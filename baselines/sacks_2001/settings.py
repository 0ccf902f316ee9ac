"""The numbers and switches of the legged team of 2001.  [Sacks 2001, 3.3, 3.4, 4.2, 4.3]

The paper's constants are the defaults. "assumed" marks our guess where the paper gives no value; every rule that the
paper tests with and without is a switch  (MS52).
"""

from dataclasses import dataclass
from math import pi

from soccer_env.leagues.options import Options

DEGREE = pi / 180.0
GOAL_FORCES = {"unit": 0, "proportional": 1}
DISTANCES = {"surface": 0, "middle": 1}
SHARE = (0.0, 1.0)
TIME = (0.01, 10.0)
RANGE = (0.01, 100.0)
ANGLE = (0.0, pi)


@dataclass(frozen=True)
class SacksSettings(Options):
    """The settings of sacks-2001; `make_team("sacks-2001", recovery=False)` changes a switch by name."""

    NAMES = {"goal_force": GOAL_FORCES, "distance_from": DISTANCES}
    BOUNDS = {
        "strength": SHARE, "near_step": SHARE, "orbit_share": SHARE, "dribble_turn": SHARE, "weak_pace": SHARE,
        "settle": TIME, "replan": TIME, "player_range": RANGE, "wall_range": RANGE, "exponent": (1, 3),
        "goal_limit": ANGLE, "body_limit": ANGLE, "blocked_limit": ANGLE, "keep_side_angle": ANGLE,
    }  # fmt: skip

    strength: float = 1.0  # [1] 0 to 1: pace, how often it decides, how straight it aims

    # stuck, 3.3
    recovery: bool = True  # the stuck counters and what follows from them; False: an attacker pushes on for ever
    stuck_count: int = 9  # readings, net, after which the robot is stuck: some seconds, assumed  MS19
    near_zero: float = 0.03  # [m/s] "near zero": a ball that comes nearer more slowly does not, assumed  MS19
    clearly: float = 0.05  # [m/s] "significantly less than zero": one that comes nearer faster does, assumed  MS19
    two_counters: bool = True  # the second counter near the ball; False: the first version of 3.3  MS20
    near: float = 0.35  # [m] from the camera, within which steps shrink and both counters must agree, 3.3  MS20, MS21
    near_time: float = 8.0  # [s] there before it may think itself stuck: 7 s take it to the ball, assumed  MS20
    near_step: float = 0.25  # [1] shortest share of a full step: 3 cm/s, a velocity "close to zero", assumed  MS21

    # recovery, 3.4
    back_steps: int = 10  # Sacks 2001, 3.4  MS23
    side_steps: int = 5  # assumed  MS24
    rotate_beyond: float = 30.0 * DEGREE  # [rad] a ball farther aside is turned to, Sacks 2001, 3.4  MS25
    rotate_steps: int = 6  # longest, assumed  MS25

    # potential field, 4.2, 4.3
    avoidance: bool = True  # dribble round the others; False: orbit and shoot, what the team did before  MS27
    exponent: int = 1  # of the distance in a player's force: 3 theory, 2, 1  MS39
    goal_force: str = "unit"  # proportional: theory  MS40
    goal_gain: float = 1.0  # [1/m] k1 of the proportional force: 1 at a distance of 1 m, assumed  MS38
    cut_off: bool = True  # False: forces have no greatest distance  MS38
    cosine_factor: bool = True  # nobody beside or behind repels  MS41
    player_gain: float = 0.8  # [m^exponent] k2: 800 for distances in mm, Sacks 2001, 4.3.2  MS42
    player_range: float = 1.0  # [m] x0, the same  MS42
    distance_from: str = "surface"  # camera to surface, as sensed, 4.1.2; middle: of both  MS42, MS48, MS49
    walls: bool = True  # MS43
    wall_gain: float = 0.2  # [m^exponent] k2: 200 for distances in mm, the same  MS43
    wall_range: float = 0.35  # [m] the same  MS43
    replan: float = 0.5  # [s] between two decisions on the way, the same  MS45
    step_length: float = 0.035  # [m] of a step, the same; 0.04 kicked the ball away  MS45
    goal_limit: float = 70.0 * DEGREE  # [rad] greatest angle from the goal's direction, Sacks 2001, 4.3.3  MS46
    clamp: bool = True  # False: no limit, the robot may be pushed away from the goal  MS46
    keep_side: bool = True  # MS47
    patience: int = 0  # decisions for which a change of side has to last: "made their reaction too slow", 4.3.3
    keep_side_angle: float = 135.0 * DEGREE  # [rad] between the goal's force and the others', the same  MS47
    body_limit: float = 45.0 * DEGREE  # [rad] greatest angle from straight ahead, the same  MS48
    body_clamp: bool = True  # False: no limit  MS48
    blocked_limit: float = 55.0 * DEGREE  # [rad] if another player stands right ahead, the same  MS48
    blocked_range: float = 0.15  # [m] "directly in front": as near as this, 40 cm between two middles, assumed  MS48
    blocked_angle: float = 20.0 * DEGREE  # [rad] and as little aside, assumed  MS48
    infrared_obstacle: bool = True  # the ranger's reading instead of one of the players  MS49
    player_age: float = 5.0  # [s] unseen after which a player repels no more, assumed

    unsure: float = 40.0  # [1] confidence in the own pose below which a robot looks up for landmarks, assumed
    unsure_glance: float = 1.6  # [s] of looking up while dribbling then, assumed

    # orbit and shoot, 4
    avoid_chasing: bool = False  # True: walks round the others on the way to the ball too, 4
    possession_time: float = 2.0  # [s] for which a ball that was between the paws counts as there, assumed  MS27
    contested_range: float = 0.36  # [m] an opponent as near ahead has the ball as well: push on, assumed  MS27
    contested_angle: float = 50.0 * DEGREE  # [rad] and as little aside, assumed  MS27
    orbit_beyond: float = 60.0 * DEGREE  # [rad] off the goal from which the robot orbits the ball, assumed  MS26
    orbit_until: float = 15.0 * DEGREE  # [rad] off the goal at which it has done so, assumed  MS26
    orbit_time: float = 6.0  # [s] after which it turns with the ball instead: a board is in the way, assumed
    orbit_share: float = 1.0  # [1] of the top speed sideways, assumed  MS26
    shoots: bool = True  # facing the goal, nobody to dribble round; False: dribbles on, as in the tests of 4.3.4  MS26
    choose_shots: bool = False  # ours: aims where the goal is open, shoots by the three settings below alone  MS26
    shot_range: float = 1.5  # [m] from which it shoots then, assumed  MS26
    shot_room: float = 2.0 * DEGREE  # [rad] that a shot must leave then beside posts and opponents, assumed  MS26
    foiled_time: float = 4.0  # [s] without another shot then after one that something stopped at once, assumed  MS26
    plays_aside: bool = False  # ours: kicks aside, past an opponent right ahead or a board  MS26
    dribble_turn: float = 0.4  # [1] of the top turn rate, towards the goal while dribbling, assumed
    glance_period: float = 2.0  # [s] of looking at the ball and up in turn while dribbling, assumed
    glance_time: float = 0.9  # [s] of it looking up; 0: the head stays on the ball, assumed

    # the others of the team, 1, 3.2
    lost: float = 2.0  # [s] unseen after which the ball is searched for, assumed
    role_time: float = 1.0  # [s] for which the other role has to be right before it is taken, assumed
    cover: float = 0.8  # [m] of a supporter behind the ball, assumed
    aside: float = 0.45  # [m] and aside of it, assumed
    angular_keeper: bool = True  # the goalkeeper goes by the ball's angular velocity  MS53
    keeper_out: float = 0.30  # [m] from the middle of the goal that it stands, assumed
    keeper_zone: float = 0.55  # [m] from the middle of the goal within which it clears the ball, assumed
    keeper_clears: bool = True  # the goalkeeper kicks a ball between its paws clear: the paper does not say, ours
    keeps_out: bool = True  # field players keep out of their own penalty area: the paper does not say, the rules, ours
    keeper_alarm: float = 0.10  # [m/s] a ball that comes nearer faster is a shot, assumed

    # the paper's future work, 5: sacks-2001-future
    passes: bool = False  # to a remembered team-mate when the goal is blocked  MS53
    keeper_speed: bool = False  # the goalkeeper's reaction depends on how fast the ball comes  MS53
    keeper_blocks: bool = False  # the goalkeeper spreads its forelegs for a shot, in a league where it can  MS53
    free_side: bool = False  # sidesteps to the side with fewer players  3.4
    decisive: bool = False  # a side is kept until the other has clearly become better: a cure for indecision  5

    # strength below 1
    weak_pace: float = 0.7  # [1] pace at strength 0, assumed
    weak_wait: float = 0.6  # [s] between decisions at strength 0, assumed
    weak_aim: float = 0.35  # [rad] deviation of the aim at strength 0, assumed

    # walking: what go needs
    settle: float = 0.7  # [s] in which a turn or a step is to be done, assumed
    lead: float = 3.0  # [s] longest by which a rolling ball is led, assumed
    arrived: float = 0.03  # [m] near enough, assumed
    walk_ahead: float = 0.25  # [m] a walk this long is done facing ahead, assumed
    walks_turned: float = 0.0  # [m] a longer walk goes on sideways and backwards during a turn; 0: none, assumed
