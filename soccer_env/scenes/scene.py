"""What a scene is, and the parts that all scenes are made of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import Any

from soccer_env.geometry import wrap
from soccer_env.leagues.league import League
from soccer_env.random_numbers import uniform
from soccer_env.scenes.judging import SUCCESS
from soccer_env.types import MAX_TEAM, MatchStream

SCENE = int(MatchStream.SCENE)


class Draw:
    """Draws of a scene's own noise stream."""

    def __init__(self, match: Any) -> None:
        self.noise = match["noise"]

    def between(self, low: float, high: float) -> float:
        """Draw a number from [low, high)."""
        return low + (high - low) * float(uniform(self.noise, SCENE))

    def side(self) -> float:
        """Draw +1 (left) or -1 (right)."""
        return 1.0 if self.between(0.0, 1.0) < 0.5 else -1.0


Place = Callable[[League, Any, Any, Draw], None]


@dataclass(frozen=True, repr=False)
class Scene:
    """A start: `place(league, ball, robots, draw)` moves what the kick-off formation put down.

    Field frame, home attacks +x. `success` makes it a drill: words of `judging.SUCCESS`, or a function of the Match
    that returns for each of its matches (M,), after every control step, 1 for a success, -1 for a failure and 0 where
    play goes on; a goal then ends nothing by itself. `opponents` names the teams that a drill is meant for, one for
    each opponent that has a part in it (the last rows of away): a suggestion that lists show; the caller decides who
    plays.
    """

    name: str  # by which lists, commands and results call it
    description: str  # in a line, for lists
    place: Place | None = None  # place(league, ball, robots, draw), see above; None: as at a kick-off
    success: str | Callable[[Any], Any] = "none"  # what ends a drill, and how; "none": no drill
    time_limit: float = inf  # [s] of a drill, which then ends undecided
    in_play: bool = False  # True: play is on; False: a kick-off
    opponents: tuple[str, ...] = ()  # names of teams, with strengths
    players: int = 1  # of home's that it is meant for, a goalkeeper among them: a suggestion as well
    most: int = MAX_TEAM  # players a side
    families: tuple[str, ...] = ()  # of leagues that it is for (`League.family`); empty: all
    rules: str = "league"  # of its drill, unless others are asked for
    shows: Place | None = None  # moves the ball to where robots see it in their first look; it is back at once

    def __post_init__(self) -> None:
        if not callable(self.success) and self.success not in SUCCESS:
            words = f"one of {', '.join(SUCCESS)}, or a function of the match"
            raise ValueError(f"Scene.success must be {words}, got {self.success!r}")
        if not self.time_limit > 0.0:
            raise ValueError(f"Scene.time_limit must be above zero, got {self.time_limit}")

    def __repr__(self) -> str:
        """Return what tells it from others at a glance: <Scene empty-goal: home scores, 60 s>."""
        success = getattr(self.success, "__name__", "a function") if callable(self.success) else self.success
        limit = f", {self.time_limit:g} s" if self.time_limit < inf else ""
        return f"<{type(self).__name__} {self.name}: {self.description if success == 'none' else success + limit}>"

    @property
    def meant_for(self) -> str:
        """Return in words for how many players of home, and against whom, it is meant; and how many a side it takes."""
        if self.success == "none":
            return "any"
        meant = f"{self.players} v {', '.join(self.opponents)}" if self.opponents else f"{self.players}"
        return meant if self.most == MAX_TEAM else f"{meant}; {self.most} a side at most"

    def of_episode(self, seed: int, episode: int) -> Scene:
        """Return the scene in which an episode begins: this one, unless it is a mixture."""
        return self

    def check(self, league: League, home: int, away: int) -> None:
        """Raise ValueError if the scene is not for this league, or not for so many players a side."""
        league.must_be_of(self.families, f"scene {self.name!r}")
        least = max(len(self.opponents), 1)
        for side, size, low in (("home", home, 1), ("away", away, least)):
            if not low <= size <= self.most:
                raise ValueError(f"{side} must be {low} to {self.most} in scene {self.name!r}, got {size}")


def put(robot: Any, x: float, y: float, heading: float) -> None:
    """Put a robot somewhere [m, m, rad], at rest."""
    robot["x"], robot["y"], robot["heading"] = x, y, float(wrap(heading))


def last_of(robots: Any, team: int) -> int:
    """Return the row of a team's last active robot."""
    return max(r for r in range(len(robots)) if robots[r]["team"] == team and robots[r]["active"])


def send_away(league: League, robots: Any, *but: int) -> None:
    """Put every active robot but some at home's end of the pitch, in two columns or three, out of play."""
    columns = 2 if len(robots) <= 2 * league.team_size else 3
    rows = -(-len(robots) // columns)
    edge, step = league.pitch.width / 2 - league.body.reach - league.foot, 2.5 * league.body.reach
    for r in range(len(robots)):
        if r not in but and robots[r]["active"]:
            column, row = r % columns, r // columns
            x = -league.pitch.length / 2 + (column + 0.6) * step
            put(robots[r], x, edge - row * min(step, 2 * edge / max(rows - 1, 1)), 0.0)
