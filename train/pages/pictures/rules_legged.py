"""The rules of the legged league: for each, a function that stages the match in which the referee applies the rule.

Rows 0 to 2 are home, red, attacking +x; rows 0 and 3 are goalkeepers.
"""

from dataclasses import replace
from functools import partial
from math import pi

from soccer_env.leagues import find_league
from soccer_env.match import staging
from soccer_env.train.pages.pictures.rules import Ruling, Staged, stage_rule
from soccer_env.types import Foul

LEAGUE = find_league("legged-2001")
NOSES = 2.0 * (LEAGUE.body.tip_x + LEAGUE.body.tip_radius) + 0.002  # [m] between two robots whose paws touch
POCKET = LEAGUE.body.front + LEAGUE.ball.radius + 0.001  # [m] of a ball between the forepaws from the robot's middle
EDGE = 0.5 * LEAGUE.pitch.width - LEAGUE.ball.radius - 0.001  # [m] of a ball at a board
PLACES = ((-1.25, 0.0, 0.0), (-0.7, -0.55, 0.3), (-0.6, 0.5, -0.3), (1.25, 0.0, pi), (0.7, 0.55, pi), (0.6, -0.5, pi))

staged = partial(stage_rule, LEAGUE, PLACES)


def stage_pushing() -> Staged:
    """Stage a robot that walks into a standing opponent, away from the ball."""
    return staged((-0.6, -0.3), {2: (0.0, 0.3, 0.0), 4: (NOSES, 0.3, pi)}, {2: 1.0})


def stage_charge() -> Staged:
    """Stage two robots that walk into each other, while mates are nearer to the ball."""
    return staged((0.0, -0.5), {1: (-0.3, -0.5, 0.0), 2: (0.0, 0.4, 0.0), 4: (NOSES, 0.4, pi)}, {2: 1.0, 4: 1.0})


def stage_keeper_push() -> Staged:
    """Stage an attacker that walks into the goalkeeper."""
    return staged((1.2, 0.4), {2: (1.0, 0.1, 0.0), 3: (1.0 + NOSES, 0.1, pi)}, {2: 1.0})


def stage_annulled_goal() -> Staged:
    """Stage a goal by a mate while the goalkeeper is pushed."""
    match, actions = staged((0.9, -0.15), {2: (1.0, 0.15, 0.0), 3: (1.0 + NOSES, 0.15, pi)}, {2: 1.0})
    staging.put_ball(match, 0.9, -0.15, 0.75)
    match.robots["keeper_pushing"][0, 2] = 0.4
    staging.begin_scene(match)
    return match, actions


def stage_ball_in_corner() -> Staged:
    """Stage a ball that a robot covers in a corner."""
    x, y = 0.5 * LEAGUE.pitch.length - LEAGUE.ball.radius - 0.001, EDGE
    away = POCKET / 2.0**0.5
    return staged((x, y), {2: (x - away, y - away, 0.25 * pi), 4: (1.1, 0.55, 0.5)}, {2: 0.6})


def stage_ball_at_board() -> Staged:
    """Stage a goalkeeper that presses the ball against the board of its goal line."""
    x = LEAGUE.ball.radius + 0.001 - 0.5 * LEAGUE.pitch.length
    return staged((x, 0.4), {0: (x + POCKET, 0.4, pi)}, {0: 0.6})


def stage_illegal_defender() -> Staged:
    """Stage a field player that stays in its own area."""
    return staged((0.3, 0.0), {2: (-1.15, 0.3, 0.0)}, {})


def stage_robot_in_goal() -> Staged:
    """Stage an attacker that stays in the opponents' goal."""
    return staged((0.0, 0.3), {2: (1.58, -0.1, 0.0)}, {})


def stage_kick_off_shot() -> Staged:
    """Stage a goal straight from the kick-off."""
    match, actions = staged((0.5, -0.2), {}, {}, kick_off_shot=0)
    staging.put_ball(match, 0.5, -0.2, 1.2)
    staging.begin_scene(match)
    return match, actions


def stage_return_after_penalty() -> Staged:
    """Stage a robot whose penalty is over, with the ball on the other side."""
    match, actions = staged((0.2, -0.5), {}, {})
    staging.send_off(match, [2])
    match.robots["penalty"][0, 2] = 1.0
    return match, actions


def stage_local_game_stuck() -> Staged:
    """Stage two robots that have fought for the ball for half a minute."""
    match, actions = staged((-0.3, 0.2), {2: (-0.3 - POCKET, 0.2, 0.0), 4: (POCKET - 0.29, 0.2, pi)}, {})
    match.matches["local_x"], match.matches["local_y"], match.matches["local_clock"] = -0.3, 0.2, 29.0
    return match, actions


def stage_global_game_stuck() -> Staged:
    """Stage a ball that nobody has touched for half a minute."""
    return staged((-0.4, 0.0), {}, {}, idle_clock=29.0)


def stage_stuck_ball() -> Staged:
    """Stage two robots that keep a ball at a board."""
    match, actions = staged((0.3, EDGE), {2: (0.3 - POCKET, EDGE - 0.03, 0.0), 4: (0.3 + POCKET, EDGE - 0.03, pi)}, {})
    match.matches["still_clock"] = 14.0
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
    match, actions = staged((1.2, 0.2), {3: (1.25, -0.2, pi)}, {})
    staging.send_off(match, [2])
    match.robots["penalty"][0, 2] = 20.0
    staging.put_ball(match, 1.2, 0.2, 1.0)
    staging.begin_scene(match)
    return match, actions


def stage_carrying() -> Staged:
    """Stage a robot that has walked ahead with the ball for nearly 50 cm, under the rule of 2008."""
    match, actions = staged((POCKET, 0.2), {2: (0.0, 0.2, 0.0)}, {2: 0.5}, running=True, rules="league:carrying=True")
    match.robots["carry_x"][0, 2], match.robots["carry_y"][0, 2] = -0.49, 0.2
    match.robots["has_ball"][0, 2] = 1
    return match, actions


def stage_illegal_attacker() -> Staged:
    """Stage an attacker that waits before the opponents' goal."""
    return staged((-0.3, 0.0), {2: (1.1, -0.35, 0.0)}, {}, rules="league:illegal_attacker=True")


RULINGS = (
    Ruling("pushing", ("pushing",), "red 2 walks into blue 1, off the ball: 30 s out", stage_pushing, 2, Foul.PUSHING),
    Ruling("pushing, a charge", ("pushing",), "red 2 and blue 1 walk into each other: both out", stage_charge, 4,
           Foul.PUSHING),
    Ruling("goalkeeper pushing", ("keeper_pushing",), "red 2 pushes the goalkeeper for 1 s: out", stage_keeper_push, 2,
           Foul.KEEPER_PUSHING),
    Ruling("goal annulled", ("keeper_pushing",), "red 1 has shot, but red 2 pushes the goalkeeper",
        stage_annulled_goal),
    Ruling("ball holding", ("holding",), "red 2 covers the ball in the corner for 3 s: out", stage_ball_in_corner, 2,
        Foul.HOLDING),
    Ruling("ball holding, goalkeeper", ("holding",), "5 s in its area: to the halfway line", stage_ball_at_board, 0,
        Foul.HOLDING),
    Ruling("illegal defender", ("illegal_defender",), "red 2 has two feet in its own area: out",
        stage_illegal_defender, 2,
           Foul.ILLEGAL_DEFENDER),
    Ruling("leaving the field", ("leaving_field",), "red 2 stands in a goal for 5 s: out", stage_robot_in_goal, 2,
        Foul.LEFT_FIELD),
    Ruling("back after 30 s", (), "red 2, at the halfway line, far from the ball", stage_return_after_penalty, 2,
        after=True),
    Ruling("kick-off shot", ("kick_off_shot",), "no goal: blue kicks off", stage_kick_off_shot),
    Ruling("local game stuck", ("local_stuck",), "30 s: red 2, the nearest, to the halfway line",
        stage_local_game_stuck, 2,
           Foul.GAME_STUCK),
    Ruling("global game stuck", ("global_stuck",), "30 s without a touch: red, in its half, kicks off",
        stage_global_game_stuck,
           event="stuck", longest=5.0),
    Ruling("dropped ball", ("dropped_ball",), "15 s within 10 cm: dropped, off the board", stage_stuck_ball,
        event="restart",
           after=True),
    Ruling("pulled apart", ("contact_time",), "15 s in contact: one robot goes", stage_blocked_opponents,
        event="separated", after=True),
    Ruling("falling", ("falling",), "red 2 has lain for 5 s: to the halfway line", stage_fallen_robot, 2, Foul.FALLEN),
    Ruling("pardon", ("pardon",), "a kick-off after a goal: red 2 is back", stage_pardon, 2, after=True, longest=5.0),
    Ruling("carrying (of 2008)", ("carrying",), "red 2 has carried the ball for 50 cm: out", stage_carrying, 2,
        Foul.HOLDING),
    Ruling("illegal attacker (off)", ("illegal_attacker",), "red 2 has waited there for 10 s: out",
        stage_illegal_attacker, 2,
           Foul.ILLEGAL_ATTACKER),
)  # fmt: skip
