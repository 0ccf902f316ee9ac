"""Drills for every league: an empty goal near and far, a run from a chaser, a shot, the ball between two, a kick-off.

Places are shares of the pitch. All ranges are assumed.

    run-to-score        contested-ball       win-the-ball          kick-off-goal

     C     D*  |goal      D   o   A           D      *A               K  | D*  A    K|goal
"""

from functools import partial
from math import atan2, cos, pi, sin
from typing import Any

from soccer_env.leagues.league import League
from soccer_env.scenes.scene import (
    PATIENT,
    Scene,
    SceneRandom,
    last_row,
    put_inside,
    put_robot,
    put_with_ball,
    send_away,
)
from soccer_env.types import AWAY, HOME

ATTACK = 60.0  # [s] time limit of an attack, assumed; legged robots need half a minute for half a pitch
Range = tuple[float, float]


def place_empty_goal(
    league: League, ball: Any, robots: Any, draw: SceneRandom, away: Range = (0.15, 0.3), behind: Range = (0.05, 0.15)
) -> None:
    """Place the ball in front of the empty goal, home's last robot behind the ball, all other robots far behind.

    away: distance of the ball from the goal; behind: of the robot from the ball; both in lengths of the pitch.
    """
    goal = league.pitch.length / 2
    away_m = draw.between(*away) * league.pitch.length
    angle = draw.between(-0.6, 0.6)  # [rad] off the middle of the goal
    ball["x"], ball["y"] = goal - away_m * cos(angle), away_m * sin(angle)
    back = league.body.front + league.ball.radius + draw.between(*behind) * league.pitch.length
    off = atan2(-ball["y"], goal - ball["x"]) + draw.between(-1.0, 1.0)
    x, y = ball["x"] - back * cos(off), ball["y"] - back * sin(off)
    limit = league.pitch.width / 2 - league.body.reach - league.foot
    striker = last_row(robots, HOME)
    send_away(league, robots, striker)
    put_robot(robots[striker], x, min(max(y, -limit), limit), off + draw.between(-0.5, 0.5))


def place_shot(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Shoot between away's posts from 4 m (a third of a shorter pitch) at 4 m/s (80 % of a weaker kicker's speed)."""
    goal = league.pitch.length / 2
    away = min(4.0, league.pitch.length / 3)
    angle = draw.between(-0.5, 0.5)
    ball["x"], ball["y"] = goal - away * cos(angle), away * sin(angle)
    aim = draw.between(-0.9, 0.9) * (league.pitch.goal_width / 2 - league.ball.radius)
    direction = atan2(aim - ball["y"], goal - ball["x"])
    roll(ball, direction, min(4.0, 0.8 * league.kicker.fastest))
    keeper = goalkeeper_of_away(robots)
    send_away(league, robots, keeper)
    put_robot(robots[keeper], goal - league.body.reach - 0.05, 0.0, pi)


def roll(ball: Any, direction: float, speed: float) -> None:
    """Set the ball rolling in a direction [rad] at a speed [m/s]."""
    ball["vx"], ball["vy"] = speed * cos(direction), speed * sin(direction)
    ball["roll_x"], ball["roll_y"] = ball["vx"], ball["vy"]


def goalkeeper_of_away(robots: Any) -> int:
    """Return the row of away's goalkeeper, or of away's last player if it has no goalkeeper."""
    keepers = [r for r in range(len(robots)) if robots[r]["team"] != HOME and robots[r]["keeper"]]
    return keepers[0] if keepers else len(robots) - 1


def place_run(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place home's last robot with the ball before the empty goal, and away's last robot behind it."""
    runner, chaser = last_row(robots, HOME), last_row(robots, AWAY)
    send_away(league, robots, runner, chaser)
    length, width = league.pitch.length, league.pitch.width
    x, y = draw.between(0.13, 0.18) * length, draw.between(-0.25, 0.25) * width
    put_with_ball(league, ball, robots[runner], x, y, atan2(-y, length / 2 - x) + draw.between(-0.3, 0.3))
    back, aside = draw.between(0.12, 0.13) * length, draw.between(-0.1, 0.1) * width
    put_inside(league, robots[chaser], x - back, y + aside, 0.0)


def place_contested(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place the ball midway between home's and away's last robots, both turned to the ball."""
    ours, theirs = last_row(robots, HOME), last_row(robots, AWAY)
    send_away(league, robots, ours, theirs)
    length = league.pitch.length
    ball["x"], ball["y"] = draw.between(0.15, 0.25) * length, draw.between(-0.25, 0.25) * league.pitch.width
    apart, way = draw.between(0.1, 0.14) * length, draw.between(-0.6, 0.6)
    for row, facing in ((ours, way), (theirs, way + pi)):
        x, y = ball["x"] - apart * cos(facing), ball["y"] - apart * sin(facing)
        put_robot(robots[row], x, y, facing + draw.between(-0.3, 0.3))


def place_attacker(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place away's last robot with the ball, and home's last robot between the ball and home's goal."""
    ours, theirs = last_row(robots, HOME), last_row(robots, AWAY)
    send_away(league, robots, ours, theirs)
    length, width = league.pitch.length, league.pitch.width
    x, y = draw.between(0.25, 0.32) * length, draw.between(-0.2, 0.2) * width
    put_with_ball(league, ball, robots[theirs], x, y, pi + draw.between(-0.3, 0.3))
    put_robot(robots[ours], draw.between(0.03, 0.08) * length, y + draw.between(-0.1, 0.1) * width, 0.0)


def place_kick_off(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place home's last robot behind the ball on the centre spot; all others keep their places of a kick-off."""
    back = league.body.front + league.ball.radius + draw.between(0.01, 0.02) * league.pitch.length
    way = draw.between(-0.3, 0.3)
    put_robot(robots[last_row(robots, HOME)], -back * cos(way), -back * sin(way), way + draw.between(-0.2, 0.2))


DRILLS = (
    Scene(
        "empty-goal",
        "home's last robot, the ball and an empty goal close by; a stuck ball is dropped, a stuck game ends it",
        place_empty_goal,
        "home scores",
        60.0,
        in_play=True,
    ),  # fmt: skip
    Scene("shot-at-keeper", "a shot on target at away's goalkeeper", place_shot, "away saves", 10.0, in_play=True),
    Scene("empty-goal-far", "home's last robot with the ball far before an empty goal",
          partial(place_empty_goal, away=(0.3, 0.42), behind=(0.03, 0.06)), "home scores", 60.0, True, rules=PATIENT),
    Scene("run-to-score", "a run at an empty goal, one of away's behind", place_run, "home scores", ATTACK, True,
          ("chaser",), rules=PATIENT),
    Scene("contested-ball", "the ball midway between two robots", place_contested, "home gets free", ATTACK, True,
          ("chaser",), rules=PATIENT),
    Scene("win-the-ball", "one of away's runs with the ball at one of home's", place_attacker,
          "home gets the ball", ATTACK, True, ("chaser",), rules=PATIENT),
    Scene("kick-off-goal", "home kicks off and has a minute to score", place_kick_off, "home scores", 60.0,
          opponents=("chaser",) * 3, players=3),
)  # fmt: skip
