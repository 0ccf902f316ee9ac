"""Drills of the middle-size league: shots at a post, a rolling ball, the challenge of 2003, set pieces.  [H. 2006]

    "we showed in the technical challenge at the world championship in Padova 2003, that our high-level control code was
    still good enough, to win the technical challenge by dribbling the ball around static obstacles"

Every distance, angle and speed is drawn from a range; all are assumed, except the kick's speed of up to 10 m/s.

    far-post-shot        challenge-2003

             |  K |              o        o
      o ->   |    |goal   D*                       |goal
      (the farther post)             o        o
"""

from functools import partial
from math import atan2, cos, pi, sin
from typing import Any

from soccer_env.leagues.league import League
from soccer_env.scenes import scene
from soccer_env.scenes.drills import ATTACK, goalkeeper_of_away, roll
from soccer_env.types import AWAY, HOME, Phase

STEP = 1.2  # [m] between two obstacles of the challenge, along the pitch
ASIDE = 0.35  # [m] of obstacles beside the straight way, to either side in turn
OBSTACLES = 4


def place_post_shot(league: League, ball: Any, robots: Any, draw: scene.SceneRandom, far: bool) -> None:
    """Kick the ball from 3 to 5 m at 4 to 10 m/s at a post of away's goal, the goalkeeper between ball and goal."""
    goal, side = league.pitch.length / 2, draw.side()
    away, angle = draw.between(3.0, 5.0), side * draw.between(0.3, 0.8)
    ball["x"], ball["y"] = goal - away * cos(angle), away * sin(angle)
    inside = league.pitch.goal_width / 2 - league.ball.radius - draw.between(0.05, 0.35)
    aim = (-side if far else side) * inside
    roll(ball, atan2(aim - ball["y"], goal - ball["x"]), draw.between(4.0, 10.0))
    ball["roll_x"] = ball["roll_y"] = 0.0  # a kicked ball slides first
    keeper = goalkeeper_of_away(robots)
    scene.send_away(league, robots, keeper)
    out = draw.between(0.5, 1.0)
    scene.put_robot(robots[keeper], goal - out * cos(angle), out * sin(angle), pi - angle)


def place_rolling(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Roll the ball past home's last robot, from 3 to 5 m away at 1 to 3 m/s, passing it up to 1 m aside."""
    receiver = scene.last_row(robots, HOME)
    scene.send_away(league, robots, receiver)
    x, y, way = draw.between(0.0, 1.5), draw.between(-1.0, 1.0), draw.between(-pi / 2, pi / 2)
    away, aside = draw.between(3.0, 3.5), draw.between(-1.0, 1.0)
    ball["x"], ball["y"] = x + away * cos(way), min(max(y + away * sin(way), -3.6), 3.6)
    scene.put_robot(robots[receiver], x, y, way)
    course = atan2(y - ball["y"], x - ball["x"]) + atan2(aside, away)
    roll(ball, course, draw.between(1.0, 3.0))


def place_obstacles(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place still obstacles on the path to the goal from home's last robot, which has the ball.  MH24"""
    dribbler, others = scene.last_row(robots, HOME), scene.last_rows(robots, AWAY, OBSTACLES)
    scene.send_away(league, robots, dribbler, *others)
    x, y, side = draw.between(-2.6, -2.3), draw.between(-0.5, 0.5), draw.side()
    scene.put_with_ball(league, ball, robots[dribbler], x, y, 0.0)
    for number, row in enumerate(others):
        off = side * (-1.0) ** number * ASIDE + draw.between(-0.1, 0.1)
        scene.put_robot(robots[row], x + 1.6 + STEP * number + draw.between(-0.1, 0.1), y + off, draw.between(-pi, pi))


def place_for_corner(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place the ball near a corner beside away's goal."""
    near = league.rules.corner_offset
    ball["x"] = league.pitch.length / 2 - near - draw.between(0.4, 0.8)
    ball["y"] = draw.side() * (league.pitch.width / 2 - near - draw.between(0.4, 0.8))


def place_for_free_kick(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place the ball in away's half, outside the penalty area."""
    ball["x"], ball["y"] = draw.between(1.5, 3.5), draw.between(-2.5, 2.5)


def set_piece(name: str, description: str, place: Any, phase: Phase) -> scene.Scene:
    """Return a drill of three a side under the rules of the league: home takes a restart and has to score."""
    return scene.Scene(
        name, description, place, "home scores", ATTACK, opponents=("chaser",) * 3, players=3,
        families=("middle-size",), restart=phase,
    )  # fmt: skip


def middle_size_drill(name: str, description: str, place: Any, success: str, limit: float, **more: Any) -> scene.Scene:
    """Return a drill of the middle-size league, whose referee calls no fouls and no dropped balls."""
    return scene.Scene(
        name, description, place, success, limit, True, families=("middle-size",), rules=scene.PATIENT, **more
    )


DRILLS_MIDDLE = (
    middle_size_drill("far-post-shot", "a kick at the farther post of away's goal", partial(place_post_shot, far=True),
          "away saves", 10.0),
    middle_size_drill("near-post-shot", "a kick at the nearer post of away's goal", partial(place_post_shot, far=False),
          "away saves", 10.0),
    middle_size_drill("receive-pass", "a ball that rolls past home's last robot", place_rolling,
        "home gets the ball", 6.0),
    middle_size_drill("challenge-2003", "home's last robot with the ball, four still obstacles on its way",
          place_obstacles, "home gets past", 20.0, opponents=("still",) * OBSTACLES),
    set_piece("corner-kick", "a corner kick by home", place_for_corner, Phase.CORNER_KICK),
    set_piece("free-kick", "a free kick by home in the other half", place_for_free_kick, Phase.FREE_KICK),
)  # fmt: skip
