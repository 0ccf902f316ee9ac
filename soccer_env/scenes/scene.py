"""The class Scene, and the functions that all scenes use to place robots."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, inf, sin
from typing import Any

from soccer_env.geometry import wrap
from soccer_env.leagues.league import League
from soccer_env.random_numbers import GOLDEN, draw_uniform, mix_bits
from soccer_env.scenes.judging import SUCCESS
from soccer_env.types import HOME, MAX_TEAM, NO_TEAM, MatchStream, Phase

SCENE = int(MatchStream.SCENE)
PATIENT = "simple:dropped_ball=False"  # no whistles, no robots pulled apart: the drill tests recovery
BETWEEN = 0.003  # [m] between a ball at the kicker, or between the paws, and the body
ROOM = 0.01  # [m] left to a board
HELD_OUT = 10  # one start in so many is held out


class SceneRandom:
    """Random numbers for placing, from a noise stream of the scene alone."""

    def __init__(self, match: Any) -> None:
        self.noise = match["noise"]

    def between(self, low: float, high: float) -> float:
        """Draw a number from [low, high)."""
        return low + (high - low) * float(draw_uniform(self.noise, SCENE))

    def side(self) -> float:
        """Draw a side at random: +1 (left) or -1 (right)."""
        return 1.0 if self.between(0.0, 1.0) < 0.5 else -1.0


Place = Callable[[League, Any, Any, SceneRandom], None]


@dataclass(frozen=True, repr=False)
class Scene:
    """A start of an episode: `place(league, ball, robots, draw)` changes the kick-off formation.

    Field frame, home attacks +x. `success` makes the scene a drill: words of `judging.SUCCESS`, or a function of the
    Match that returns (M,) after every control step, 1 for a success, -1 for a failure and 0 while play goes on; a goal
    then ends nothing by itself. `opponents` names the team of each opponent with a part in the drill (the last rows of
    away): a suggestion for lists; the caller chooses the teams.
    """

    name: str  # in lists, commands and results
    description: str  # in a line, for lists
    place: Place | None = None  # place(league, ball, robots, draw), see above; None: as at a kick-off
    success: str | Callable[[Any], Any] = "none"  # the success test of a drill; "none": no drill
    time_limit: float = inf  # [s] of a drill, which then ends undecided
    in_play: bool = False  # True: play is on; False: home's restart
    opponents: tuple[str, ...] = ()  # names of teams, with strengths
    players: int = 1  # of home that the drill is meant for, with a goalkeeper: also a suggestion
    most: int = MAX_TEAM  # players a side
    families: tuple[str, ...] = ()  # of the leagues that the scene fits (`League.family`); empty: all
    rules: str = "league"  # of the drill, unless the caller names other rules
    shows: Place | None = None  # moves the ball for the robots' first look only
    restart: Phase = Phase.KICK_OFF  # where play is not on; of others than a kick-off, the rules place the robots

    def __post_init__(self) -> None:
        if not callable(self.success) and self.success not in SUCCESS:
            words = f"one of {', '.join(SUCCESS)}, or a function of the match"
            raise ValueError(f"Scene.success must be {words}, got {self.success!r}")
        if not self.time_limit > 0.0:
            raise ValueError(f"Scene.time_limit must be above zero, got {self.time_limit}")

    def __repr__(self) -> str:
        """Return the scene in short: <Scene empty-goal: home scores, 60 s>."""
        success = getattr(self.success, "__name__", "a function") if callable(self.success) else self.success
        limit = f", {self.time_limit:g} s" if self.time_limit < inf else ""
        return f"<{type(self).__name__} {self.name}: {self.description if success == 'none' else success + limit}>"

    @property
    def meant_for(self) -> str:
        """Return a text on the intended players: number of home, names of opponents, greatest team size."""
        if self.success == "none":
            return "any"
        meant = f"{self.players} v {', '.join(self.opponents)}" if self.opponents else f"{self.players}"
        return meant if self.most == MAX_TEAM else f"{meant}; {self.most} a side at most"

    def of_episode(self, seed: int, episode: int) -> Scene:
        """Return the scene that begins an episode: this scene, or the scene drawn from a mixture."""
        return self

    def set_up(self, league: League, match: Any, ball: Any, robots: Any) -> None:
        """Change the records of an episode that has begun with the kick-off formation."""
        if self.place is not None:
            self.place(league, ball, robots, SceneRandom(match))
        if self.in_play or self.restart != Phase.KICK_OFF:
            match["phase"], match["restart_team"] = (Phase.PLAY, NO_TEAM) if self.in_play else (self.restart, HOME)
            match["restart_x"], match["restart_y"] = ball["x"], ball["y"]
        match["still_x"], match["still_y"] = ball["x"], ball["y"]

    def check(self, league: League, home: int, away: int) -> None:
        """Raise ValueError if the scene does not fit the league or the number of players a side."""
        league.require_family(self.families, f"scene {self.name!r}")
        least = max(len(self.opponents), 1)
        for side, size, low in (("home", home, 1), ("away", away, least)):
            if not low <= size <= self.most:
                raise ValueError(f"{side} must be {low} to {self.most} in scene {self.name!r}, got {size}")


def put_robot(robot: Any, x: float, y: float, heading: float) -> None:
    """Place a robot at a pose x, y, heading [m, m, rad]."""
    robot["x"], robot["y"], robot["heading"] = x, y, float(wrap(heading))


def last_row(robots: Any, team: int) -> int:
    """Return the row of a team's last active robot."""
    return max(r for r in range(len(robots)) if robots[r]["team"] == team and robots[r]["active"])


def put_inside(league: League, robot: Any, x: float, y: float, heading: float) -> None:
    """Place a robot at a pose [m, m, rad], shifted onto the pitch where the pose is off it."""
    room = league.body.reach + league.foot + ROOM
    edge_x, edge_y = league.pitch.length / 2 - room, league.pitch.width / 2 - room
    put_robot(robot, min(max(x, -edge_x), edge_x), min(max(y, -edge_y), edge_y), heading)


def touch_distance(league: League) -> float:
    """Return the distance [m] between a robot's centre and a ball held between its paws."""
    return league.body.front + league.ball.radius + BETWEEN


def put_with_ball(league: League, ball: Any, robot: Any, x: float, y: float, heading: float) -> None:
    """Place a robot at a pose [m, m, rad] with the ball at its kicker."""
    put_robot(robot, x, y, heading)
    ball["x"], ball["y"] = x + touch_distance(league) * cos(heading), y + touch_distance(league) * sin(heading)


def last_rows(robots: Any, team: int, count: int) -> list[int]:
    """Return the rows of a team's last `count` active robots, in order."""
    return [r for r in range(len(robots)) if robots[r]["team"] == team and robots[r]["active"]][-count:]


def choose_start(match: Any, starts: str) -> None:
    """Set the random numbers of a drill's start to those of a `starts` start: "all", "training" or "held-out".

    A start follows from the state of the scene's random numbers alone; its number is this state. Starts whose number
    is a multiple of HELD_OUT are held out. An unwanted number is replaced by its hash, until one fits.
    """
    noise = match["noise"]
    while starts != "all" and (int(noise[SCENE]) % HELD_OUT == 0) != (starts == "held-out"):
        noise[SCENE] = mix_bits(noise[SCENE] ^ GOLDEN)


def send_away(league: League, robots: Any, *but: int) -> None:
    """Move all active robots except the rows `but` to home's end of the pitch, in two or three columns."""
    columns = 2 if len(robots) <= 2 * league.team_size else 3
    rows = -(-len(robots) // columns)
    edge, step = league.pitch.width / 2 - league.body.reach - league.foot, 2.5 * league.body.reach
    for r in range(len(robots)):
        if r not in but and robots[r]["active"]:
            column, row = r % columns, r // columns
            x = -league.pitch.length / 2 + (column + 0.6) * step
            put_robot(robots[r], x, edge - row * min(step, 2 * edge / max(rows - 1, 1)), 0.0)
