"""The rules of the legged league, each staged once.

Rows 0 to 2 are home, red, attacking +x; rows 0 and 3 are goalkeepers.
"""

from __future__ import annotations

from functools import partial
from math import pi

from soccer_env import staging
from soccer_env.leagues import find_league
from soccer_env.train.pictures.rules import Ruling
from soccer_env.train.pictures.staged_rules import Staged, stage_rule
from soccer_env.types import Foul

LEAGUE = find_league("legged-2001")
NOSES = 2.0 * (LEAGUE.body.tip_x + LEAGUE.body.tip_radius) + 0.002  # [m] between two robots whose paws touch
POCKET = LEAGUE.body.front + LEAGUE.ball.radius + 0.001  # [m] of a ball between the forepaws from the robot's middle
EDGE = 0.5 * LEAGUE.pitch.width - LEAGUE.ball.radius - 0.001  # [m] of a ball at a board
PLACES = ((-1.25, 0.0, 0.0), (-0.7, -0.55, 0.3), (-0.6, 0.5, -0.3), (1.25, 0.0, pi), (0.7, 0.55, pi), (0.6, -0.5, pi))

staged = partial(stage_rule, LEAGUE, PLACES)


def pushing() -> Staged:
    """Return a robot that walks into one who stands, away from the ball."""
    return staged((-0.6, -0.3), {2: (0.0, 0.3, 0.0), 4: (NOSES, 0.3, pi)}, {2: 1.0})


def charge() -> Staged:
    """Return two robots that walk into each other, while mates are nearer to the ball."""
    return staged((0.0, -0.5), {1: (-0.3, -0.5, 0.0), 2: (0.0, 0.4, 0.0), 4: (NOSES, 0.4, pi)}, {2: 1.0, 4: 1.0})


def keeper_push() -> Staged:
    """Return an attacker that walks into the goalkeeper."""
    return staged((1.2, 0.4), {2: (1.0, 0.1, 0.0), 3: (1.0 + NOSES, 0.1, pi)}, {2: 1.0})


def annulled_goal() -> Staged:
    """Return a goal by a mate while the goalkeeper is pushed."""
    match, actions = staged((0.9, -0.15), {2: (1.0, 0.15, 0.0), 3: (1.0 + NOSES, 0.15, pi)}, {2: 1.0})
    staging.put_ball(match, 0.9, -0.15, 0.75)
    match.robots["keeper_pushing"][0, 2] = 0.4
    staging.begin(match)
    return match, actions


def corner() -> Staged:
    """Return a ball that a robot covers in a corner."""
    x, y = 0.5 * LEAGUE.pitch.length - LEAGUE.ball.radius - 0.001, EDGE
    away = POCKET / 2.0**0.5
    return staged((x, y), {2: (x - away, y - away, 0.25 * pi), 4: (1.1, 0.55, 0.5)}, {2: 0.6})


def board() -> Staged:
    """Return a goalkeeper that presses the ball against the board of its goal line."""
    x = LEAGUE.ball.radius + 0.001 - 0.5 * LEAGUE.pitch.length
    return staged((x, 0.4), {0: (x + POCKET, 0.4, pi)}, {0: 0.6})


def defender() -> Staged:
    """Return a field player that stays in its own area."""
    return staged((0.3, 0.0), {2: (-1.15, 0.3, 0.0)}, {})


def in_goal() -> Staged:
    """Return an attacker that stays in the opponents' goal."""
    return staged((0.0, 0.3), {2: (1.58, -0.1, 0.0)}, {})


def kick_off_shot() -> Staged:
    """Return a goal straight from the kick-off."""
    match, actions = staged((0.5, -0.2), {}, {}, kick_off_shot=0)
    staging.put_ball(match, 0.5, -0.2, 1.2)
    staging.begin(match)
    return match, actions


def back() -> Staged:
    """Return a robot whose time out is over, and the ball on the other side."""
    match, actions = staged((0.2, -0.5), {}, {})
    staging.send_off(match, [2])
    match.robots["penalty"][0, 2] = 1.0
    return match, actions


def scrum() -> Staged:
    """Return two robots that have fought for the ball for half a minute."""
    match, actions = staged((-0.3, 0.2), {2: (-0.3 - POCKET, 0.2, 0.0), 4: (POCKET - 0.29, 0.2, pi)}, {})
    match.matches["local_x"], match.matches["local_y"], match.matches["local_clock"] = -0.3, 0.2, 29.0
    return match, actions


def idle() -> Staged:
    """Return a ball that nobody has touched for half a minute."""
    return staged((-0.4, 0.0), {}, {}, idle_clock=29.0)


RULINGS = (
    Ruling("pushing", "red 2 walks into blue 1, off the ball: 30 s out", pushing, 2, Foul.PUSHING),
    Ruling("pushing, a charge", "red 2 and blue 1 walk into each other: both out", charge, 4, Foul.PUSHING),
    Ruling("goalkeeper pushing", "red 2 pushes the goalkeeper for 1 s: out", keeper_push, 2, Foul.KEEPER_PUSHING),
    Ruling("goal annulled", "red 1 has shot, but red 2 pushes the goalkeeper", annulled_goal),
    Ruling("ball holding", "red 2 covers the ball in the corner for 3 s: out", corner, 2, Foul.HOLDING),
    Ruling("ball holding, goalkeeper", "5 s in its area: to the halfway line", board, 0, Foul.HOLDING),
    Ruling("illegal defender", "red 2 has two feet in its own area: out", defender, 2, Foul.ILLEGAL_DEFENDER),
    Ruling("leaving the field", "red 2 stands in a goal for 5 s: out", in_goal, 2, Foul.LEFT_FIELD),
    Ruling("back after 30 s", "red 2, at the halfway line, far from the ball", back, 2, after=True),
    Ruling("kick-off shot", "no goal: blue kicks off", kick_off_shot),
    Ruling("local game stuck", "30 s: red 2, the nearest, to the halfway line", scrum, 2, Foul.GAME_STUCK),
    Ruling("global game stuck", "30 s without a touch: red, in its half, kicks off", idle, event="stuck"),
)
