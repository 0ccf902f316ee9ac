"""Drills of the legged league, up to three players a side: reach the ball, dribble past opponents, save a far shot.

Home's last robot has to succeed; the opponents with a part in a drill are the last robots of away. All other robots
stand at home's end. Every distance and angle is drawn from a range; all ranges are assumed, since Sacks (2001) says of
his tests only that there were still and moving players [4.3.4].

    dribble-past-three          mover-and-still          gap-500

              o                           o <-             o
    D*   o        o  |goal       D*                 D*          |goal  500 mm between the centres
                     |               o                     o
"""

from collections.abc import Callable
from math import atan2, cos, pi, sin
from typing import Any

from soccer_env.leagues.league import League
from soccer_env.scenes.drills import goalkeeper_of_away, roll
from soccer_env.scenes.scene import (
    PATIENT,
    Place,
    Scene,
    SceneRandom,
    last_row,
    last_rows,
    put_inside,
    put_robot,
    send_away,
    touch_distance,
)
from soccer_env.types import AWAY, HOME

GAP = 0.5  # [m] between the centres of two players, "gap-500"
KEEPER_OUT = 0.30  # [m] of the goalkeeper from the middle of its goal


def place_ball_behind(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place a still opponent ahead of home's robot, and the ball behind the opponent."""
    seeker, blocker = last_row(robots, HOME), last_row(robots, AWAY)
    send_away(league, robots, seeker, blocker)
    ball["x"], ball["y"] = draw.between(0.3, 1.1), draw.between(-0.2, 0.2)
    way = draw.between(-0.8, 0.8)
    behind, ahead = draw.between(0.22, 0.33), draw.between(0.36, 0.5)
    aside, facing = draw.between(-0.05, 0.05), draw.between(-pi, pi)
    x, y = ball["x"] - behind * cos(way), ball["y"] - behind * sin(way)
    put_robot(robots[blocker], x - aside * sin(way), y + aside * cos(way), facing)
    put_inside(league, robots[seeker], x - ahead * cos(way), y - ahead * sin(way), way + draw.between(-0.2, 0.2))


def place_head_on(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place two robots face to face, with the ball between the paws of both."""
    seeker, blocker = last_row(robots, HOME), last_row(robots, AWAY)
    send_away(league, robots, seeker, blocker)
    ball["x"], ball["y"] = draw.between(0.0, 1.0), draw.between(-0.5, 0.5)
    way = draw.between(-1.0, 1.0)
    for r, side in ((seeker, -1.0), (blocker, 1.0)):
        far, facing = side * touch_distance(league), way if side < 0.0 else way + pi
        put_robot(robots[r], ball["x"] + far * cos(way), ball["y"] + far * sin(way), facing + draw.between(-0.02, 0.02))


def place_facing_wall(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place home's robot facing the board on a touchline, a paw at the board, and the ball behind its back."""
    seeker = last_row(robots, HOME)
    send_away(league, robots, seeker)
    side, off = draw.side(), draw.between(-0.4, 0.4)
    body = league.body
    paws = body.tip_x * cos(off) + body.tip_y * abs(sin(off)) + body.tip_radius  # [m] from the centre to the board
    x, y = draw.between(-0.2, 1.1), side * (league.pitch.width / 2 - league.foot - paws)
    put_robot(robots[seeker], x, y, side * pi / 2 + off)
    away, behind = draw.between(0.35, 0.8), -side * pi / 2 + draw.between(-0.7, 0.7)
    ball["x"], ball["y"] = min(x + away * cos(behind), 1.3), y + away * sin(behind)


def start_dribble(
    league: League, ball: Any, robots: Any, draw: SceneRandom, others: int
) -> tuple[Any, list[Any], float]:
    """Place the ball between the paws of home's last robot; return robot, opponents and direction of the goal [rad]."""
    row, rows = last_row(robots, HOME), last_rows(robots, AWAY, others)
    send_away(league, robots, row, *rows)
    robot = robots[row]
    ball["x"], ball["y"] = draw.between(-0.38, -0.3), draw.between(-0.3, 0.3)
    way = atan2(-ball["y"], league.pitch.length / 2 - ball["x"])
    facing = way + draw.between(-0.15, 0.15)
    put_robot(
        robot,
        ball["x"] - touch_distance(league) * cos(facing),
        ball["y"] - touch_distance(league) * sin(facing),
        facing,
    )
    return robot, [robots[r] for r in rows], way


def put_at_distance(league: League, robot: Any, other: Any, distance: float, angle: float, heading: float) -> None:
    """Place the robot `other` at a distance [m] and field angle [rad] from `robot`, with a heading [rad]."""
    x, y = robot["x"] + distance * cos(angle), robot["y"] + distance * sin(angle)
    put_inside(league, other, float(x), float(y), heading)


def place_still(count: int) -> Place:
    """Return a function that places `count` still players on the path to the goal, one behind another."""

    def place(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
        robot, players, way = start_dribble(league, ball, robots, draw, count)
        for number, player in enumerate(players):
            distance = 0.6 + 0.42 * number + draw.between(-0.04, 0.1)
            aside = draw.between(-0.12, 0.12) + (0.0 if number == 0 else 0.1 * draw.side())
            angle = way + atan2(aside, distance)
            put_at_distance(league, robot, player, distance, angle, draw.between(-pi, pi))

    return place


def place_mover(near: float, far: float, aside: float, meets: tuple[float, float]) -> Place:
    """Return a function that places a moving player `near` to `far` [m] away, up to `aside` [rad] off the path to goal.

    The moving player heads for a point on the path to the goal, `meets` [m] from the dribbler.
    """

    def place(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
        robot, (mover,), way = start_dribble(league, ball, robots, draw, 1)
        send_mover(league, robot, mover, draw, way, (near, far), draw.side() * draw.between(0.4, 1.0) * aside, meets)

    return place


def send_mover(
    league: League, robot: Any, mover: Any, draw: SceneRandom, way: float, distance: tuple[float, float], off: float,
    meets: tuple[float, float],
) -> None:  # fmt: skip
    """Place a moving player at a distance [m], `off` [rad] from the path to the goal, heading for a point on it."""
    put_at_distance(league, robot, mover, draw.between(*distance), way + off, 0.0)
    ahead = draw.between(*meets)
    x, y = robot["x"] + ahead * cos(way) - mover["x"], robot["y"] + ahead * sin(way) - mover["y"]
    mover["heading"] = atan2(y, x)


def place_mover_and_still(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place a still player to one side of the path to the goal, and a moving player that comes from the other side."""
    robot, (still, mover), way = start_dribble(league, ball, robots, draw, 2)
    side = draw.side()
    put_at_distance(
        league, robot, still, draw.between(0.5, 0.7), way - side * draw.between(0.25, 0.5), draw.between(-pi, pi)
    )
    send_mover(league, robot, mover, draw, way, (0.75, 1.1), side * draw.between(0.25, 0.6), (0.25, 0.5))


def place_gap(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place two still players side by side on the path to the goal, half a metre between their centres."""
    robot, players, way = start_dribble(league, ball, robots, draw, 2)
    distance, middle = draw.between(0.6, 0.9), draw.between(-0.05, 0.05)
    x, y = robot["x"] + distance * cos(way), robot["y"] + distance * sin(way)
    for player, side in zip(players, (1.0, -1.0), strict=True):
        aside, facing = middle + side * GAP / 2, way + pi + draw.between(-0.3, 0.3)
        put_inside(league, player, float(x - aside * sin(way)), float(y + aside * cos(way)), facing)


def place_far_post_shot(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Shoot from one side just inside the other post, as hard as a legged robot kicks.

    The goalkeeper stands on the line from the ball to the middle of its goal and faces the ball. Kicks too slow to
    reach the goal are left out.
    """
    goal, side = league.pitch.length / 2, draw.side()
    away, angle = draw.between(0.8, 1.1), side * draw.between(0.3, 0.8)
    ball["x"], ball["y"] = goal - away * cos(angle), away * sin(angle)
    post = -side * (league.pitch.goal_width / 2 - league.ball.radius - draw.between(0.0, 0.06))
    direction = atan2(post - ball["y"], goal - ball["x"])
    keeper = goalkeeper_of_away(robots)
    send_away(league, robots, keeper)
    roll(ball, direction, draw.between(1.0, league.kicker.fastest))
    put_robot(robots[keeper], goal - KEEPER_OUT * cos(angle), KEEPER_OUT * sin(angle), pi - angle)


def legged_drill(name: str, description: str, place: Callable[..., None], success: str, *opponents: str) -> Scene:
    """Return a legged drill of at most one minute."""
    limit = 10.0 if success == "away saves" else 60.0  # [s] assumed; the way to the goal takes half a minute at 7 cm/s
    return Scene(
        name, description, place, success, limit, True, opponents, most=3, families=("legged",), rules=PATIENT,
    )  # fmt: skip


GOT, PAST = "home gets the ball", "home gets past"
DRILLS_LEGGED = (
    legged_drill("ball-behind-robot", "the ball lies behind a still opponent", place_ball_behind, GOT, "still"),
    legged_drill("head-on-push", "two robots face to face over the ball", place_head_on, "home gets free",
        "walker@1.0"),
    legged_drill("facing-wall", "a robot faces a board, the ball behind it", place_facing_wall, GOT, "still"),
    legged_drill("dribble-past-one", "one still player on the way to the goal", place_still(1), PAST, "still"),
    legged_drill("dribble-past-two", "two still players, one behind the other", place_still(2), PAST, "still", "still"),
    legged_drill("dribble-past-three", "three still players", place_still(3), PAST, "still", "still", "still"),
    legged_drill("dribble-past-mover-near", "a player that walks in, at 50 to 70 cm", place_mover(0.5, 0.7, 0.7,
          (0.2, 0.4)), PAST, "walker@0.5"),
    legged_drill("dribble-past-mover-far", "a player that walks in, at 110 to 150 cm", place_mover(1.1, 1.5, 0.4,
          (0.3, 0.6)), PAST, "walker@0.5"),
    legged_drill("dribble-past-mover-head-on", "a player that walks at the dribbler, at 70 to 130 cm",
          place_mover(0.7, 1.3, 0.05, (0.0, 1e-6)), PAST, "walker@0.5"),
    legged_drill("mover-and-still", "a player walks in from one side, another stands on the other",
          place_mover_and_still, PAST, "still", "walker@0.5"),
    legged_drill("gap-500", "two still players, 500 mm between their centres", place_gap, PAST, "still", "still"),
    legged_drill("far-post-shots", "a shot at the far post of away's goalkeeper", place_far_post_shot, "away saves",
          "sacks-2001"),
)  # fmt: skip
