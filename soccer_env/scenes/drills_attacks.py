"""Attacks of several robots: home's last robot has the ball, away's goalkeeper stands in its goal.

Places are metres on a pitch of 12 m by 8 m; on a shorter pitch they shrink with it. All ranges are assumed.

    three-v-one           counter-attack          pass-and-shoot          two-v-two              keep-away

          A                        A                      A                     A     D            A
    A*         D   K|goal   D  A*       D   K|goal               K|goal                K|goal           D    K|goal
          A                 D                        A*   D                  A*    D            A*
"""

from math import pi
from typing import Any

from soccer_env.leagues.league import League
from soccer_env.scenes import scene
from soccer_env.scenes.drills import ATTACK, goalkeeper_of_away
from soccer_env.types import AWAY, HOME

LENGTH = 12.0  # [m] of the pitch for which places are given
KEPT = 10.0  # [s] for which the ball has to be kept, assumed


def field_player_rows(robots: Any, team: int, most: int) -> list[int]:
    """Return the rows of up to `most` field players of a team, or the goalkeeper's row if it has no field player."""
    rows = scene.last_rows(robots, team, len(robots))
    field = [r for r in rows if not robots[r]["keeper"]]
    chosen = field or rows
    return chosen[max(len(chosen) - most, 0) :]


def place_three_v_one(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place up to three home players, the last with the ball, against away's goalkeeper and one field player."""
    side = draw.side()
    places = [(draw.between(2.0, 3.0), side * 2.0), (draw.between(2.0, 3.0), -side * 2.0)]
    place_attack(league, ball, robots, draw, places, [(draw.between(3.4, 4.0), draw.between(-0.5, 0.5))])


def place_counter_attack(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place two home players, the last with the ball, against a player and the goalkeeper; two opponents behind."""
    side = draw.side()
    behind = [(draw.between(-1.6, -1.2), 1.5), (draw.between(-1.6, -1.2), -1.5)]
    place_attack(
        league, ball, robots, draw, [(0.5, side * draw.between(1.5, 2.5))], [*behind, (draw.between(2.0, 3.0), 0.0)]
    )


def place_attack(
    league: League, ball: Any, robots: Any, draw: scene.SceneRandom,
    mates: list[tuple[float, float]], defenders: list[tuple[float, float]], start: tuple[float, float] = (0.0, 0.0),
) -> None:  # fmt: skip
    """Place home's last field player with the ball near `start`, then its mates and away's players."""
    scale = league.pitch.length / LENGTH
    own = field_player_rows(robots, HOME, 1 + len(mates))
    keeper, others = goalkeeper_of_away(robots), field_player_rows(robots, AWAY, len(defenders))
    others = [row for row in others if row != keeper]
    scene.send_away(league, robots, keeper, *own, *others)
    x, y = start[0] + draw.between(-0.3, 0.3), start[1] + draw.between(-0.4, 0.4)
    scene.put_with_ball(league, ball, robots[own[-1]], scale * x, scale * y, 0.0)
    for row, (x, y) in zip(own[:-1], mates, strict=False):
        scene.put_inside(league, robots[row], scale * x, scale * y, 0.0)
    for row, (x, y) in zip(reversed(others), reversed(defenders), strict=False):
        scene.put_inside(league, robots[row], scale * x, scale * y, pi)
    scene.put_robot(robots[keeper], league.pitch.length / 2 - 0.8 * scale, 0.0, pi)


def place_pass_and_shoot(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place a defender in the way of the player with the ball; its mate stands free on the other side."""
    side = draw.side()
    mates = [(draw.between(2.4, 3.4), -side * draw.between(1.6, 2.4))]
    place_attack(league, ball, robots, draw, mates, [(draw.between(2.6, 3.2), side * 0.9)], (0.7, side * 1.6))


def place_two_v_two(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place two home players before two defenders and the goalkeeper."""
    side = draw.side()
    mates = [(draw.between(0.6, 1.4), -side * draw.between(1.2, 2.0))]
    defenders = [(draw.between(3.0, 3.6), way * draw.between(0.7, 1.3)) for way in (1.0, -1.0)]
    place_attack(league, ball, robots, draw, mates, defenders, (0.7, side * 1.2))


def place_keep_away(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place two home players on two sides, and one of away's, which comes for the ball."""
    side = draw.side()
    mates = [(draw.between(1.0, 2.5), -side * draw.between(1.6, 2.6))]
    place_attack(league, ball, robots, draw, mates, [(draw.between(3.0, 3.8), side * 0.6)], (0.9, side * 1.0))


def place_alone_at_keeper(league: League, ball: Any, robots: Any, draw: scene.SceneRandom) -> None:
    """Place a home player alone before the goalkeeper."""
    place_attack(league, ball, robots, draw, [], [], (draw.between(2.0, 3.5), draw.between(-2.0, 2.0)))


def attack(name: str, description: str, place: scene.Place, players: int, *opponents: str, **more: Any) -> scene.Scene:
    """Return an attack, in which the referee calls no fouls and no dropped balls."""
    usual = {"success": "home scores", "time_limit": ATTACK, "in_play": True, "rules": scene.PATIENT}
    return scene.Scene(name, description, place, players=players, opponents=opponents, **{**usual, **more})


HALF = "chaser@0.5"
QUICK: dict[str, Any] = {"families": ("middle-size",), "time_limit": 20.0}  # [s] legged robots walk too slowly
ATTACKS = (
    attack("three-v-one", "three of home's with the ball before one of away's and its goalkeeper", place_three_v_one, 4,
           "chaser", "chaser", **QUICK),
    attack("counter-attack", "two of home's with the ball run at one of away's and its goalkeeper",
           place_counter_attack, 3, *("chaser",) * 4, **QUICK),
    attack("pass-and-shoot", "a defender in the way, a mate free on the other side", place_pass_and_shoot, 3,
           HALF, HALF),
    attack("two-v-two", "two of home's before two of away's and its goalkeeper", place_two_v_two, 3, HALF, HALF, HALF),
    attack("one-v-keeper", "one of home's with the ball alone before away's goalkeeper", place_alone_at_keeper, 1,
           HALF, "still"),
    attack("keep-away", "two of home's keep the ball from one of away's", place_keep_away, 3,
           HALF, HALF, success="home keeps the ball", time_limit=KEPT),
)  # fmt: skip
