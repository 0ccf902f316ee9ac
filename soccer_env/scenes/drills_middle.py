"""Drills of the middle-size league: shots at a post, a rolling ball, the challenge of 2003, attacks.  [H. 2006, 1, 4]

    "we showed in the technical challenge at the world championship in Padova 2003, that our high-level control code was
    still good enough, to win the technical challenge by dribbling the ball around static obstacles"

Every distance, angle and speed is drawn from a range; all are assumed, except the kick's speed of up to 10 m/s.

    far-post-shot        challenge-2003                       three-v-one            counter-attack

             |  K |              o        o                       A                        A
      o ->   |    |goal   D*                       |goal    A*         D    K|      D  A*         D     K|goal
      (the farther post)             o        o                   A                  D
"""

from functools import partial
from math import atan2, cos, pi, sin
from typing import Any

from soccer_env.leagues.league import League
from soccer_env.scenes.drills import goalkeeper_of_away, roll
from soccer_env.scenes.drills_legged import PATIENT, last_rows, put_inside, touch_distance
from soccer_env.scenes.scene import Scene, SceneRandom, last_row, put_robot, send_away
from soccer_env.types import AWAY, HOME

STEP = 1.2  # [m] between two obstacles of the challenge, along the pitch
ASIDE = 0.35  # [m] of obstacles beside the straight way, to either side in turn
OBSTACLES = 4
LONGEST = 20.0  # [s] time limit of an attack


def place_post_shot(league: League, ball: Any, robots: Any, draw: SceneRandom, far: bool) -> None:
    """Kick the ball from 3 to 5 m at 4 to 10 m/s at a post of away's goal, the goalkeeper between ball and goal."""
    goal, side = league.pitch.length / 2, draw.side()
    away, angle = draw.between(3.0, 5.0), side * draw.between(0.3, 0.8)
    ball["x"], ball["y"] = goal - away * cos(angle), away * sin(angle)
    inside = league.pitch.goal_width / 2 - league.ball.radius - draw.between(0.05, 0.35)
    aim = (-side if far else side) * inside
    roll(ball, atan2(aim - ball["y"], goal - ball["x"]), draw.between(4.0, 10.0))
    ball["roll_x"] = ball["roll_y"] = 0.0  # a kicked ball slides first
    keeper = goalkeeper_of_away(robots)
    send_away(league, robots, keeper)
    out = draw.between(0.5, 1.0)
    put_robot(robots[keeper], goal - out * cos(angle), out * sin(angle), pi - angle)


def place_rolling(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Roll the ball past home's last robot, from 3 to 5 m away at 1 to 3 m/s, passing it up to 1 m aside."""
    receiver = last_row(robots, HOME)
    send_away(league, robots, receiver)
    x, y, way = draw.between(0.0, 1.5), draw.between(-1.0, 1.0), draw.between(-pi / 2, pi / 2)
    away, aside = draw.between(3.0, 3.5), draw.between(-1.0, 1.0)
    ball["x"], ball["y"] = x + away * cos(way), min(max(y + away * sin(way), -3.6), 3.6)
    put_robot(robots[receiver], x, y, way)
    course = atan2(y - ball["y"], x - ball["x"]) + atan2(aside, away)
    roll(ball, course, draw.between(1.0, 3.0))


def place_obstacles(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place still obstacles on the path to the goal from home's last robot, which has the ball.  MH24"""
    dribbler, others = last_row(robots, HOME), last_rows(robots, AWAY, OBSTACLES)
    send_away(league, robots, dribbler, *others)
    x, y, side = draw.between(-2.6, -2.3), draw.between(-0.5, 0.5), draw.side()
    put_with_ball(league, ball, robots[dribbler], x, y, 0.0)
    for number, row in enumerate(others):
        off = side * (-1.0) ** number * ASIDE + draw.between(-0.1, 0.1)
        put_robot(robots[row], x + 1.6 + STEP * number + draw.between(-0.1, 0.1), y + off, draw.between(-pi, pi))


def put_with_ball(league: League, ball: Any, robot: Any, x: float, y: float, heading: float) -> None:
    """Place a robot at a pose [m, m, rad] with the ball at its kicker."""
    put_robot(robot, x, y, heading)
    ball["x"], ball["y"] = x + touch_distance(league) * cos(heading), y + touch_distance(league) * sin(heading)


def field_player_rows(robots: Any, team: int, most: int) -> list[int]:
    """Return the rows of up to `most` field players of a team, or the goalkeeper's row if it has no field player."""
    rows = last_rows(robots, team, len(robots))
    field = [r for r in rows if not robots[r]["keeper"]]
    return (field or rows)[-most:]


def place_three_v_one(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place up to three home players, the last with the ball, against away's goalkeeper and one field player."""
    side = draw.side()
    places = [(draw.between(2.0, 3.0), side * 2.0), (draw.between(2.0, 3.0), -side * 2.0)]
    place_attack(league, ball, robots, draw, places, [(draw.between(3.4, 4.0), draw.between(-0.5, 0.5))])


def place_counter_attack(league: League, ball: Any, robots: Any, draw: SceneRandom) -> None:
    """Place two home players, the last with the ball, against a player and the goalkeeper; two opponents behind."""
    side = draw.side()
    behind = [(draw.between(-1.6, -1.2), 1.5), (draw.between(-1.6, -1.2), -1.5)]
    place_attack(
        league, ball, robots, draw, [(0.5, side * draw.between(1.5, 2.5))], [*behind, (draw.between(2.0, 3.0), 0.0)]
    )


def place_attack(
    league: League, ball: Any, robots: Any, draw: SceneRandom,
    mates: list[tuple[float, float]], defenders: list[tuple[float, float]],
) -> None:  # fmt: skip
    """Place home's last field player with the ball near the centre spot, then its mates and away's players."""
    own = field_player_rows(robots, HOME, 1 + len(mates))
    keeper, others = goalkeeper_of_away(robots), field_player_rows(robots, AWAY, len(defenders))
    others = [row for row in others if row != keeper]
    send_away(league, robots, keeper, *own, *others)
    put_with_ball(league, ball, robots[own[-1]], draw.between(-0.3, 0.3), draw.between(-0.4, 0.4), 0.0)
    for row, (x, y) in zip(own[:-1], mates, strict=False):
        put_inside(league, robots[row], x, y, 0.0)
    for row, (x, y) in zip(reversed(others), reversed(defenders), strict=False):
        put_inside(league, robots[row], x, y, pi)
    put_robot(robots[keeper], league.pitch.length / 2 - 0.8, 0.0, pi)


def middle_size_drill(name: str, description: str, place: Any, success: str, limit: float, **more: Any) -> Scene:
    """Return a drill of the middle-size league, whose referee calls no fouls and no dropped balls."""
    return Scene(name, description, place, success, limit, True, families=("middle-size",), rules=PATIENT, **more)


DRILLS_MIDDLE = (
    middle_size_drill("far-post-shot", "a kick at the farther post of away's goal", partial(place_post_shot, far=True),
          "away saves", 10.0),
    middle_size_drill("near-post-shot", "a kick at the nearer post of away's goal", partial(place_post_shot, far=False),
          "away saves", 10.0),
    middle_size_drill("receive-pass", "a ball that rolls past home's last robot", place_rolling,
        "home gets the ball", 6.0),
    middle_size_drill("challenge-2003", "home's last robot with the ball, four still obstacles on its way",
          place_obstacles, "home gets past", 20.0, opponents=("still",) * OBSTACLES),
    middle_size_drill("three-v-one", "three of home's with the ball before one of away's and its goalkeeper",
          place_three_v_one, "home scores", LONGEST, opponents=("chaser", "chaser"), players=4),
    middle_size_drill("counter-attack", "two of home's with the ball run at one of away's and its goalkeeper",
          place_counter_attack, "home scores", LONGEST, opponents=("chaser",) * 4, players=3),
)  # fmt: skip
