"""Drills for a single robot: find the ball or move it off the boards (lines), then score within a minute.

Home's last robot plays; all other robots stand at home's end, and no referee helps. All distances are assumed; they
are those on a pitch of 3 m and grow with the pitch.

    lost-ball-behind                 ball-at-board                   ball-in-corner

      (o) seen at first              +----o-----------+              +-----------o+
       D*       |goal                |      D         |              |        D   |
        o       |                    |                |goal          |            |goal
"""

from math import atan2, cos, pi, sin
from typing import Any

from soccer_env.leagues.league import League
from soccer_env.scenes.scene import PATIENT, Scene, SceneRandom, last_row, put_inside, put_robot, send_away
from soccer_env.types import HOME

LENGTH = 3.0  # [m] of the pitch for which distances are given
AT_BOARD = 0.05  # [m] between ball and board, assumed
IN_CORNER = 0.12  # [m] between ball and each of the two boards: ball centre within 25 cm of the corner, assumed


def place_lost_ball(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place the ball half a metre or more behind home's robot."""
    seeker = last_row(robots, HOME)
    send_away(league, robots, seeker)
    x, y, heading = draw.between(0.45, 0.7), draw.between(-0.15, 0.15), draw.between(-pi, pi)
    put_robot(robots[seeker], x, y, heading)
    away, behind = draw.between(0.5, 0.7), heading + pi + draw.between(-0.35, 0.35)
    ball["x"], ball["y"] = x + away * cos(behind), y + away * sin(behind)


def show_ball_ahead(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Show the ball, at the robot's first look only, as far ahead of home's robot as the ball really lies behind."""
    seeker = robots[last_row(robots, HOME)]
    ball["x"], ball["y"] = 2.0 * seeker["x"] - ball["x"], 2.0 * seeker["y"] - ball["y"]


def place_at_board(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place the ball at a touchline, home's robot a step away and turned to the ball."""
    scale = league.pitch.length / LENGTH
    side, gap = draw.side(), scale * draw.between(0.0, AT_BOARD)
    ball["x"], ball["y"] = scale * draw.between(-0.6, 1.1), side * (league.pitch.width / 2 - league.ball.radius - gap)
    place_robot_near_ball(league, ball, robots, draw, -side * pi / 2)


def place_in_corner(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place the ball in a corner beside away's goal, home's robot a step away and turned to the ball."""
    side, radius, most = draw.side(), league.ball.radius, IN_CORNER * (league.pitch.length / LENGTH)
    ball["x"] = league.pitch.length / 2 - radius - draw.between(0.0, most)
    ball["y"] = side * (league.pitch.width / 2 - radius - draw.between(0.0, most))
    place_robot_near_ball(league, ball, robots, draw, -side * 3 * pi / 4)


def place_robot_near_ball(league: League, ball: Any, robots: Any, draw: SceneRandom, inwards: float) -> None:
    """Place home's robot 0.4 to 0.8 m from the ball, facing it, up to 40 degrees off the direction `inwards` [rad]."""
    seeker = last_row(robots, HOME)
    send_away(league, robots, seeker)
    away, way = draw.between(0.4, 0.8) * (league.pitch.length / LENGTH), inwards + draw.between(-0.7, 0.7)
    put_inside(league, robots[seeker], ball["x"] + away * cos(way), ball["y"] + away * sin(way), 0.0)
    robot = robots[seeker]
    to_ball = atan2(ball["y"] - robot["y"], ball["x"] - robot["x"])
    put_robot(robot, robot["x"], robot["y"], to_ball + draw.between(-0.3, 0.3))


def one_robot_drill(name: str, description: str, place: Any, **more: Any) -> Scene:
    """Return a drill of one minute for a single robot."""
    return Scene(name, description, place, "home scores", 60.0, True, ("still",), most=3, rules=PATIENT, **more)


DRILLS_ALONE = (
    one_robot_drill(
        "lost-ball-behind",
        "a robot that saw the ball ahead, the ball behind it",
        place_lost_ball,
        shows=show_ball_ahead,
        families=("legged",),
    ),  # fmt: skip
    one_robot_drill("ball-at-board", "the ball at the line or board of a touchline", place_at_board),
    one_robot_drill("ball-in-corner", "the ball in a corner beside away's goal", place_in_corner),
)
