"""Matches as arrays of records over time, and a second count of their play: by whole arrays, not step by step."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.types import Phase

STILL = 0.02  # [m/s]
AT_LINE, IN_CORNER = 0.20, 0.25  # [m]
CROWD, MARGIN = 3, 0.10  # robots that make a scrum; [m] beyond the reach of a robot that lies at the ball
LOST, AGAIN = 0.5, 1.0  # [s] without the ball that end a spell; without a touch after which the next one counts anew
KEPT = ("matches", "balls", "robots", "robot_events")


@dataclass(frozen=True)
class Recording:
    """M matches of T control steps with R robots: how they stood after each step, and what happened in it."""

    league: League
    live: np.ndarray  # (T, M) False once the match was over
    matches: np.ndarray  # (T, M) MATCH
    balls: np.ndarray  # (T, M) BALL
    robots: np.ndarray  # (T, M, R) ROBOT
    deeds: np.ndarray  # (T, M, R) ROBOT_EVENTS

    @cached_property
    def in_play(self) -> np.ndarray:
        """Return where (T, M) the ball is in play: no restart is being placed or waited for."""
        return self.live & (self.matches["phase"] == Phase.PLAY) & (self.matches["placing"] == 0)

    def steps(self, seconds: float) -> int:
        """Return how many control steps a time [s] takes, at least one."""
        return max(1, round(seconds * self.league.control_rate))

    def seconds(self, flags: np.ndarray) -> np.ndarray:
        """Return for how long (M,) [s] a flag (T, M) holds."""
        return flags.sum(axis=0) * self.league.dt


def running(match: Match) -> Iterator[tuple[np.ndarray, ...]]:
    """Step matches to the end of the last; yield after each step which (M,) moved on, and copies of their records."""
    while not match.terminated.all():
        live = ~match.terminated
        match.step(None)
        yield (live, *(getattr(match, name).copy() for name in KEPT))


def recording_of(match: Match, moments: list[tuple[np.ndarray, ...]]) -> Recording:
    """Return the recording that all moments of matches make."""
    return Recording(match.league, *(np.stack(column) for column in zip(*moments, strict=True)))


class Runs(NamedTuple):
    """Unbroken stretches of a flag (T, ...), column by column, in order of time."""

    columns: np.ndarray  # (N,) of the flag with all axes but time made one
    starts: np.ndarray  # (N,) first step
    ends: np.ndarray  # (N,) first step after it

    @property
    def steps(self) -> np.ndarray:
        """Return how many steps (N,) each lasts."""
        return self.ends - self.starts


def runs_of(flags: np.ndarray) -> Runs:
    """Return the runs of a flag (T, ...)."""
    flat = flags.reshape(len(flags), -1).T.astype(np.int8)
    edge = np.diff(flat, axis=1, prepend=0, append=0)
    columns, starts = np.nonzero(edge == 1)
    return Runs(columns, starts, np.nonzero(edge == -1)[1])


def bridged(flags: np.ndarray, steps: int) -> np.ndarray:
    """Return a flag (T, ...) with breaks of at most so many steps closed."""
    flat = flags.reshape(len(flags), -1).copy()
    for column, first, last in zip(*runs_of(~flags), strict=True):
        if first > 0 and last < len(flags) and last - first <= steps:
            flat[first:last, column] = True
    return flat.reshape(flags.shape)


def times(play: Recording) -> dict[str, np.ndarray]:
    """Return the times (M,) [s] that matches last, of the ball at rest, at the lines and in a corner, and of scrums."""
    pitch, body, balls = play.league.pitch, play.league.body, play.balls
    along, aside = pitch.length / 2 - np.abs(balls["x"]), pitch.width / 2 - np.abs(balls["y"])
    away = np.hypot(*(play.robots[name] - balls[name][..., None] for name in ("x", "y")))
    about = (away < body.reach + play.league.ball.radius + MARGIN) & (play.robots["active"] == 1)
    flags = {
        "in_play": True,
        "still": np.hypot(balls["vx"], balls["vy"]) < STILL,
        "at_boards": np.minimum(along, aside) < AT_LINE,
        "in_corner": (along < IN_CORNER) & (aside < IN_CORNER),
        "scrum": about.sum(axis=-1) >= CROWD,
    }
    in_play = {name: play.seconds(play.in_play & flag) for name, flag in flags.items()}
    return {"played": play.seconds(play.live), **in_play}


def touches(play: Recording) -> np.ndarray:
    """Return how often (M,) a robot touches the ball that has not touched it for 1 s."""
    touch = (play.deeds["touch"] == 1) & play.in_play[..., None]
    _, matches, robots = touch.shape
    columns = runs_of(bridged(touch, play.steps(AGAIN))).columns
    return np.bincount(columns // robots, minlength=matches)


def kicks(play: Recording) -> np.ndarray:
    """Return how many kicks (M,) reach the ball."""
    return ((play.deeds["kick"] == 1) & play.live[..., None]).sum(axis=(0, 2))


def held(play: Recording) -> np.ndarray:
    """Return for how long (M,) [s] somebody has the ball."""
    return play.seconds((play.robots["has_ball"] == 1).any(axis=-1) & play.in_play)


def spells(play: Recording) -> list[np.ndarray]:
    """Return the times [s], a match each, for which one robot has the ball, breaks of up to 0.5 s closed."""
    inside = play.in_play[..., None]
    runs = runs_of(bridged((play.robots["has_ball"] == 1) & inside, play.steps(LOST)) & inside)
    _, matches, robots = play.robots.shape
    return [runs.steps[runs.columns // robots == m] * play.league.dt for m in range(matches)]


MINUTES = {"legged-2001": 3.0, "middle-size-2006": 1.5}


def chasers(name: str, **settings: Any) -> Match:
    """Return matches of the chaser against itself that see the truth."""
    players = find_league(name).team_size
    given = {"home": players, "away": players, "senses": "ideal", "minutes": MINUTES[name], **settings}
    given.setdefault("matches", len(given["seeds"]) if "seeds" in given else 3)
    return Match(name, controllers={"home": "chaser", "away": "chaser"}, **given)
