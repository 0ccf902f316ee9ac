"""The rules of the legged league: for each, a function that stages the match in which the referee applies the rule.

Rows 0 to 2 are home, red, attacking +x; rows 0 and 3 are goalkeepers.
"""

from dataclasses import replace
from functools import partial
from math import pi

from soccer_env.leagues import find_league
from soccer_env.leagues.league import AHEAD_OF_RAMP
from soccer_env.match import staging
from soccer_env.train.pages.pictures.rules import Ruling, Staged, stage_rule
from soccer_env.types import Foul

LEAGUE = find_league("legged-2001")
NOSES = 2.0 * (LEAGUE.body.tip_x + LEAGUE.body.tip_radius) + 0.002  # [m] between two robots whose paws touch
POCKET = LEAGUE.body.front + LEAGUE.ball.radius + 0.001  # [m] of a ball between the forepaws from the robot's middle
FOOT = LEAGUE.pitch.ramp + AHEAD_OF_RAMP * LEAGUE.ball.radius + 0.001  # [m] from a board to a ball before its ramp
EDGE = 0.5 * LEAGUE.pitch.width - FOOT  # [m] of a ball at a board
PLACES = ((-1.25, 0.0, 0.0), (-0.7, -0.55, 0.3), (-0.6, 0.5, -0.3), (1.25, 0.0, pi), (0.7, 0.55, pi), (0.6, -0.5, pi))

staged = partial(stage_rule, LEAGUE, PLACES)


def stage_ball_in_corner() -> Staged:
    """Stage a ball that a robot covers in a corner."""
    x, y = 0.5 * LEAGUE.pitch.length - FOOT, EDGE
    away = POCKET / 2.0**0.5
    return staged((x, y), {2: (x - away, y - away, 0.25 * pi), 4: (1.15, 0.6, 0.5)}, {2: 0.6})


def stage_ball_at_board() -> Staged:
    """Stage a goalkeeper that presses the ball against the board of its goal line."""
    x = FOOT - 0.5 * LEAGUE.pitch.length
    return staged((x, 0.4), {0: (x + POCKET, 0.4, pi), 4: (x + 0.1, 0.72, pi)}, {0: 0.6})


def stage_return_after_penalty() -> Staged:
    """Stage a robot whose penalty is over, with the ball on the other side."""
    match, actions = staged((0.2, -0.5), {}, {})
    staging.send_off(match, [2])
    match.robots["penalty"][0, 2] = 1.0
    return match, actions


def stage_blocked_opponents() -> Staged:
    """Stage two opponents that have blocked each other for nearly 15 s, in red's half."""
    match, actions = staged((-0.9, 0.0), {2: (-0.5, 0.4, 0.0), 4: (NOSES - 0.502, 0.4, pi)}, {})
    match.robots["locked"][0, [2, 4]] = 14.5
    return match, actions


def stage_fallen_robot() -> Staged:
    """Stage a fallen robot, in a league where getting up takes longer than the rules allow."""
    league = replace(LEAGUE, drive=replace(LEAGUE.drive, fall_time=6.0))
    match, actions = stage_rule(league, PLACES, (0.3, -0.2), {2: (0.5, 0.3, 0.4)}, {})
    match.robots["fallen"][0, 2] = league.drive.fall_time
    return match, actions


def stage_pardon() -> Staged:
    """Stage a goal while a robot serves a penalty."""
    match, actions = staged((1.2, 0.2, 1.0), {3: (1.25, -0.2, pi)}, {})
    staging.send_off(match, [2])
    match.robots["penalty"][0, 2] = 20.0
    match.rebuild()
    return match, actions


RULINGS = (
    Ruling("pushing", ("pushing",), "red 2 walks into blue 1, off the ball: 30 s out",
           partial(staged, (-0.6, -0.3), {2: (0.0, 0.3, 0.0), 4: (NOSES, 0.3, pi)}, {2: 1.0}), 2, Foul.PUSHING),
    Ruling("pushing, a charge", ("pushing",), "red 2 and blue 1 walk into each other: both out",
           partial(staged, (0.0, -0.5), {1: (-0.3, -0.5, 0.0), 2: (0.0, 0.4, 0.0), 4: (NOSES, 0.4, pi)},
                   {2: 1.0, 4: 1.0}), 4, Foul.PUSHING),
    Ruling("goalkeeper pushing", ("keeper_pushing",), "red 2 pushes the goalkeeper for 1 s: out",
           partial(staged, (1.2, 0.4), {2: (1.0, 0.1, 0.0), 3: (1.0 + NOSES, 0.1, pi)}, {2: 1.0}), 2,
           Foul.KEEPER_PUSHING),
    Ruling("goal annulled", ("keeper_pushing",), "red 1 has shot, but red 2 pushes the goalkeeper",
           partial(staged, (0.9, -0.15, 0.75), {2: (1.0, 0.15, 0.0), 3: (1.0 + NOSES, 0.15, pi)}, {2: 1.0},
                   red_2={"keeper_pushing": 0.4})),
    Ruling("ball holding", ("holding",), "red 2 covers the ball in the corner for 3 s: out", stage_ball_in_corner, 2,
           Foul.HOLDING),
    Ruling("ball holding, goalkeeper", ("holding",), "5 s in its area: to the halfway line", stage_ball_at_board, 0,
           Foul.HOLDING),
    Ruling("illegal defender", ("illegal_defender",), "red 2 has two feet in its own area: out",
           partial(staged, (0.3, 0.0), {2: (-1.15, 0.3, 0.0)}, {}), 2, Foul.ILLEGAL_DEFENDER),
    Ruling("leaving the field", ("leaving_field",), "red 2 stands in a goal for 5 s: out",
           partial(staged, (0.0, 0.3), {2: (1.58, -0.1, 0.0)}, {}), 2, Foul.LEFT_FIELD),
    Ruling("back after 30 s", (), "red 2, at the halfway line, far from the ball", stage_return_after_penalty, 2,
           after=True),
    Ruling("kick-off shot", ("kick_off_shot",), "no goal: blue kicks off",
           partial(staged, (0.5, -0.2, 1.2), {}, {}, kick_off_shot=0)),
    Ruling("local game stuck", ("local_stuck",), "30 s: red 2, the nearest, to the halfway line",
           partial(staged, (-0.3, 0.2), {2: (-0.3 - POCKET, 0.2, 0.0), 4: (POCKET - 0.29, 0.2, pi)}, {}, local_x=-0.3,
                   local_y=0.2, local_clock=29.0), 2, Foul.GAME_STUCK),
    Ruling("global game stuck", ("global_stuck",), "30 s without a touch: red, in its half, kicks off",
           partial(staged, (-0.4, 0.0), {}, {}, idle_clock=29.0), event="stuck", longest=5.0),
    Ruling("dropped ball", ("dropped_ball",), "15 s within 10 cm: dropped 50 cm off the board",
           partial(staged, (0.3, EDGE), {2: (0.3 - POCKET, EDGE - 0.03, 0.0), 4: (0.3 + POCKET, EDGE - 0.03, pi)}, {},
                   still_clock=14.0), event="restart", after=True),
    Ruling("pulled apart", ("contact_time",), "15 s in contact: one robot goes", stage_blocked_opponents,
           event="separated", after=True),
    Ruling("falling", ("falling",), "red 2 has lain for 5 s: to the halfway line", stage_fallen_robot, 2, Foul.FALLEN),
    Ruling("pardon", ("pardon",), "a kick-off after a goal: red 2 is back", stage_pardon, 2, after=True, longest=5.0),
    Ruling("carrying (of 2008)", ("carrying",), "red 2 has carried the ball for 50 cm: out",
           partial(staged, (POCKET, 0.2), {2: (0.0, 0.2, 0.0)}, {2: 0.5}, running=True, rules="league:carrying=True",
                   red_2={"carry_x": -0.49, "carry_y": 0.2, "has_ball": 1}), 2, Foul.HOLDING),
    Ruling("illegal attacker (off)", ("illegal_attacker",), "red 2 has waited there for 10 s: out",
           partial(staged, (-0.3, 0.0), {2: (1.1, -0.35, 0.0)}, {}, rules="league:illegal_attacker=True"), 2,
           Foul.ILLEGAL_ATTACKER),
)  # fmt: skip
