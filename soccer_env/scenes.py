"""Scenes: how an episode begins, and for drills what counts as success.

`kick-off` is a match. The drills are named starts with a success test and a time limit; more come with the teams that
need them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, cos, inf, pi, sin
from typing import Any

from soccer_env.compiled import compiled
from soccer_env.geometry import wrap
from soccer_env.leagues.league import League
from soccer_env.random_numbers import uniform
from soccer_env.types import HOME, NO_TEAM, MatchStream, Phase

SCENE = int(MatchStream.SCENE)
OVER = int(Phase.OVER)
NO_DRILL, SCORE, SAVE = 0, 1, 2
SUCCESS = {"none": NO_DRILL, "home scores": SCORE, "away saves": SAVE}
SLOW_BALL = 0.2  # [m/s] a shot this slow is saved, assumed


class Draw:
    """Draws of a scene's own noise stream."""

    def __init__(self, match: Any) -> None:
        self.noise = match["noise"]

    def between(self, low: float, high: float) -> float:
        """Draw a number from [low, high)."""
        return low + (high - low) * float(uniform(self.noise, SCENE))


Place = Callable[[League, Any, Any, Draw], None]


@dataclass(frozen=True)
class Scene:
    """A start: `place(league, ball, robots, draw)` moves what the kick-off formation put down.

    Field frame, home attacks +x.
    """

    name: str
    description: str
    place: Place | None = None
    success: str = "none"
    time_limit: float = inf  # [s]
    in_play: bool = False  # True: play is on; False: a kick-off

    def __post_init__(self) -> None:
        if self.success not in SUCCESS:
            raise ValueError(f"Scene.success must be one of {', '.join(SUCCESS)}, got {self.success!r}")
        if not self.time_limit > 0.0:
            raise ValueError(f"Scene.time_limit must be above zero, got {self.time_limit}")


def put(robot: Any, x: float, y: float, heading: float) -> None:
    """Put a robot somewhere [m, m, rad], at rest."""
    robot["x"], robot["y"], robot["heading"] = x, y, float(wrap(heading))


def place_empty_goal(league: League, ball: Any, robots: Any, draw: Draw) -> None:
    """Put the ball a short way off the empty goal, home's last robot behind it, everybody else far behind."""
    goal = league.pitch.length / 2
    away = draw.between(0.15, 0.3) * league.pitch.length
    angle = draw.between(-0.6, 0.6)  # [rad] off the middle of the goal
    ball["x"], ball["y"] = goal - away * cos(angle), away * sin(angle)
    back = league.body.front + league.ball.radius + draw.between(0.05, 0.15) * league.pitch.length
    off = atan2(-ball["y"], goal - ball["x"]) + draw.between(-1.0, 1.0)
    x, y = ball["x"] - back * cos(off), ball["y"] - back * sin(off)
    limit = league.pitch.width / 2 - league.body.reach
    striker = max(r for r in range(len(robots)) if robots[r]["team"] == HOME and robots[r]["active"])
    send_away(league, robots, striker)
    put(robots[striker], x, min(max(y, -limit), limit), off + draw.between(-0.5, 0.5))


def place_shot(league: League, ball: Any, robots: Any, draw: Draw) -> None:
    """Shoot at away's goal from 4 m (a third of a shorter pitch) at 4 m/s (80 % of a weaker kicker), at a point between
    the posts.
    """
    goal = league.pitch.length / 2
    away = min(4.0, league.pitch.length / 3)
    angle = draw.between(-0.5, 0.5)
    ball["x"], ball["y"] = goal - away * cos(angle), away * sin(angle)
    aim = draw.between(-0.9, 0.9) * (league.pitch.goal_width / 2 - league.ball.radius)
    direction = atan2(aim - ball["y"], goal - ball["x"])
    speed = min(4.0, 0.8 * league.kicker.fastest)
    ball["vx"], ball["vy"] = speed * cos(direction), speed * sin(direction)
    ball["roll_x"], ball["roll_y"] = ball["vx"], ball["vy"]
    keepers = [r for r in range(len(robots)) if robots[r]["team"] != HOME and robots[r]["keeper"]]
    keeper = keepers[0] if keepers else len(robots) - 1
    send_away(league, robots, keeper)
    put(robots[keeper], goal - league.body.reach - 0.05, 0.0, pi)


def send_away(league: League, robots: Any, but: int) -> None:
    """Put every active robot but one at home's end of the pitch, in two columns or three, out of play."""
    columns = 2 if len(robots) <= 2 * league.team_size else 3
    rows = -(-len(robots) // columns)
    edge, step = league.pitch.width / 2 - league.body.reach, 2.5 * league.body.reach
    for r in range(len(robots)):
        if r != but and robots[r]["active"]:
            column, row = r % columns, r // columns
            x = -league.pitch.length / 2 + (column + 0.6) * step
            put(robots[r], x, edge - row * min(step, 2 * edge / max(rows - 1, 1)), 0.0)


SCENES = {
    scene.name: scene
    for scene in (
        Scene("kick-off", "a match from the kick-off on"),
        Scene(
            "empty-goal",
            "home's last robot, the ball and an empty goal close by",
            place_empty_goal,
            "home scores",
            60.0,
            in_play=True,
        ),
        Scene("shot-at-keeper", "a shot on target at away's goalkeeper", place_shot, "away saves", 10.0, in_play=True),
    )
}


def find_scene(scene: str | Scene) -> Scene:
    """Return the scene of that name, or the object itself; ValueError says which names exist."""
    if isinstance(scene, Scene):
        return scene
    if not isinstance(scene, str) or scene not in SCENES:
        raise ValueError(f"unknown scene {scene!r}; known: {', '.join(SCENES)}")
    return SCENES[scene]


@compiled
def judge_drill(match, ball, events, k):
    """Decide a drill: +1 success, -1 failure, 0 open; a decided drill is over."""
    if k.drill == NO_DRILL:
        return
    result = 0
    if k.drill == SCORE:
        if events.goal != NO_TEAM:
            result = 1 if events.goal == HOME else -1
        elif events.out == 1:
            result = -1
    elif events.goal != NO_TEAM:
        result = -1
    elif events.out == 1 or ball.vx * match.home_direction <= SLOW_BALL:
        result = 1
    events.drill = result
    if result != 0:
        match.over = 1
        match.phase = OVER
