"""Drills for every league: an empty goal, and a shot at the goalkeeper."""

from math import atan2, cos, pi, sin
from typing import Any

from soccer_env.leagues.league import League
from soccer_env.scenes.scene import Scene, SceneRandom, last_row, put_robot, send_away
from soccer_env.types import HOME


def place_empty_goal(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place the ball in front of the empty goal, home's last robot behind the ball, all other robots far behind."""
    goal = league.pitch.length / 2
    away = draw.between(0.15, 0.3) * league.pitch.length
    angle = draw.between(-0.6, 0.6)  # [rad] off the middle of the goal
    ball["x"], ball["y"] = goal - away * cos(angle), away * sin(angle)
    back = league.body.front + league.ball.radius + draw.between(0.05, 0.15) * league.pitch.length
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
)
