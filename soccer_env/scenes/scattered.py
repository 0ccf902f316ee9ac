"""A start in the middle of play: random places of ball and robots; robots may first see the ball at a wrong place.

Dropped balls and scrums leave such situations; they are too rare in matches from the kick-off to learn from.
"""

from math import pi
from typing import Any

from soccer_env.geometry import length
from soccer_env.leagues.league import League
from soccer_env.scenes.scene import Scene, SceneRandom, put_robot

TRIES = 200  # places drawn for a robot until one is free
MISLED = 0.5  # [1] of the episodes: robots first see the ball at a wrong place, assumed
KEEPERS_ROOM = 0.5  # [m] in front of the goal line in which goalkeepers stand, assumed


def place_anywhere(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place the ball anywhere, robots anywhere clear of the ball and each other, goalkeepers before their goals."""
    draw_ball(league, ball, draw)
    taken = [(float(ball["x"]), float(ball["y"]))]
    for robot in robots:
        if robot["active"]:
            x, y = draw_place(league, robot, draw, taken)
            put_robot(robot, x, y, draw.between(-pi, pi))
            taken.append((x, y))


def draw_ball(league: League, ball: Any, draw: SceneRandom) -> None:
    """Place the ball at a random point of the pitch, at rest."""
    room_x, room_y = (0.5 * side - league.ball.radius for side in (league.pitch.length, league.pitch.width))
    ball["x"], ball["y"] = draw.between(-room_x, room_x), draw.between(-room_y, room_y)


def draw_place(league: League, robot: Any, draw: SceneRandom, taken: list[tuple[float, float]]) -> tuple[float, float]:
    """Draw a random place [m, m] for a robot, clear of the places that are taken."""
    room = league.body.reach + league.foot
    edge_x, edge_y = 0.5 * league.pitch.length - room, 0.5 * league.pitch.width - room
    for _ in range(TRIES):
        x, y = draw.between(-edge_x, edge_x), draw.between(-edge_y, edge_y)
        if robot["keeper"]:
            own = -1.0 if robot["team"] == 0 else 1.0
            x, y = own * (edge_x - draw.between(0.0, KEEPERS_ROOM)), 0.5 * y
        if all(length(x - other_x, y - other_y) > 2.0 * room for other_x, other_y in taken):
            return x, y
    return float(robot["x"]), float(robot["y"])  # its place at the kick-off


def show_wrong_ball(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Show robots the ball at a wrong place in half of the episodes, so that they begin with a wrong belief."""
    if draw.between(0.0, 1.0) < MISLED:
        draw_ball(league, ball, draw)


SCATTERED = Scene(
    "scattered", "in play: ball and robots anywhere", place_anywhere, in_play=True, most=5, shows=show_wrong_ball
)
