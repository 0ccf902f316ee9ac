"""Moments of play in which a robot is held, or thinks itself stuck, and what becomes of it: branches of one match.

Matches of 3 v 3 in which nobody recovers are watched; where a robot that goes for the ball is held by others, and where
its counters trip, the whole match is copied. A branch goes on from there with other settings for that robot's team:
bodies, noise and memories are the same in all branches, which pairs them. In branches the referee whistles for nothing
and pulls nobody apart; penalties that had begun before run off. Who is sent off is neither held nor free.
"""

from dataclasses import dataclass, fields, replace
from functools import lru_cache
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import APPROACH
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.match import Match
from soccer_env.match.saving import parts
from soccer_env.match.staging import PATIENT, memory_of
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.staging import kick_off, play
from soccer_env.types import HOME, Phase

BASE = "sacks-2001:recovery=False"  # who plays, and goes on playing against the team of a branch
MATCHES, SECONDS = 8, 60.0  # of 3 v 3 a batch, [s] of each
WINDOW = 1.5  # [s] that tell whether a robot is held, assumed; so are the five below
SHARE = 0.25  # [1] of the way that its legs walked: who gets on less is held
ASKED = 0.03  # [m] that they walked at least
TOUCHING = 0.5  # [1] of that time in contact with somebody
STILL = 0.03  # [m] that a still ball moves at most in that time
AGAIN = 10.0  # [s] after which the same robot may be sampled once more
MOST = 12  # moments of a match at most
HELD, TRIPPED = 0, 1  # kinds of moments
OUT = -1  # what a player does who is sent off


@dataclass(frozen=True)
class Moments:
    """Copies of matches (N,) at moments that belong to one robot each, and what those were like."""

    parts: dict[str, np.ndarray]  # everything that the future depends on, by name
    match: np.ndarray  # of the batch from which the moment is
    robot: np.ndarray  # row
    team: np.ndarray  # HOME or AWAY
    kind: np.ndarray  # HELD or TRIPPED
    held: np.ndarray  # True: held by somebody, of a robot whose counters tripped too
    touching: np.ndarray  # True: in contact
    still: np.ndarray  # True: the ball lay still
    near: np.ndarray  # True: nearer to it than the distance within which both counters must agree
    theirs: np.ndarray  # True: an opponent had it

    def __len__(self) -> int:
        return len(self.match)


class Watch:
    """What robots (M, R) did in the last WINDOW seconds, or as many as are asked for."""

    def __init__(self, match: Match, seconds: float = WINDOW) -> None:
        self.match = match
        self.size = round(seconds * match.league.control_rate)
        self.rows: list[np.ndarray] = []

    def look(self) -> None:
        """Note where everybody is after a control step."""
        match, robots = self.match, self.match.robots
        walk = np.hypot(robots["walk"]["forward"], robots["walk"]["left"]) * match.league.dt
        touch = match.robot_events["collision"] == 1
        here = (robots["active"] == 1) & (match.robot_events["returned"] == 0)
        ball_x, ball_y = (np.broadcast_to(match.balls[name][:, None], robots.shape) for name in ("x", "y"))
        now = np.stack([robots["x"], robots["y"], walk, touch, behaviours(match) == APPROACH, ball_x, ball_y, here])
        self.rows = [*self.rows[1 - self.size :], now]

    def full(self) -> bool:
        """Tell whether the window is filled."""
        return len(self.rows) == self.size

    def path(self, at: int = 0) -> np.ndarray:
        """Return how far [m] everybody got in the window; `at` 5: how far the ball did."""
        way = self.rows[-1][at : at + 2] - self.rows[0][at : at + 2]
        found: np.ndarray = np.hypot(way[0], way[1])
        return found

    def mean(self, row: int) -> np.ndarray:
        """Return the mean of a row of the window."""
        found: np.ndarray = np.mean([now[row] for now in self.rows], axis=0)
        return found

    def touches(self) -> np.ndarray:
        """Return who was in contact for most of the window."""
        return self.mean(3) >= TOUCHING

    def there(self) -> np.ndarray:
        """Return who was on the field throughout, and was not put somewhere else by a whistle."""
        found: np.ndarray = self.mean(7) == 1.0
        return found

    def held(self) -> np.ndarray:
        """Return who went for the ball, in contact with somebody, and got on much less than its legs walked."""
        walked = self.mean(2) * self.size
        gone = self.path() < SHARE * walked
        found: np.ndarray = (self.mean(4) == 1.0) & self.touches() & (walked > ASKED) & gone
        return found

    def short(self) -> np.ndarray:
        """Return who went for the ball, in contact with somebody, and came much less nearer to it than its legs walked.

        Unlike one that is held it may move: two that push the ball on before both of them come no nearer either.
        """
        first, last = (np.hypot(now[5] - now[0], now[6] - now[1]) for now in (self.rows[0], self.rows[-1]))
        walked = self.mean(2) * self.size
        nearer = first - last >= SHARE * walked
        found: np.ndarray = (self.mean(4) == 1.0) & self.touches() & (walked > ASKED) & ~nearer
        return found

    def still(self) -> np.ndarray:
        """Return where the ball lay still."""
        return self.path(5) < STILL


def behaviours(match: Match) -> np.ndarray:
    """Return what all players (M, R) of teams of this package do; OUT of those that are sent off.

    A player that is out remembers what it did, and goes on with it when it comes back.
    """
    doing = np.stack([memory_of(match, r)["behaviour"] for r in range(match.robots.shape[1])], axis=1)
    return np.where(match.robots["active"] == 1, doing, OUT)


def of_camera(match: Match, distance: np.ndarray, bearing: np.ndarray) -> np.ndarray:
    """Return distances [m] from the camera, level ahead, of what is seen from the middles of bodies."""
    ahead = match.league.head.camera_ahead
    found: np.ndarray = np.hypot(distance * np.cos(bearing) - ahead, distance * np.sin(bearing))
    return found


def tripped(match: Match) -> np.ndarray:
    """Return whose (M, R) counters say that it is stuck, by the paper's settings, on its way to the ball."""
    team = SacksSettings()
    memory = np.stack([memory_of(match, r) for r in range(match.robots.shape[1])], axis=1)
    ball = match.beliefs["ball"]
    near = of_camera(match, ball["filtered_distance"], ball["filtered_bearing"]) < team.near
    both = ~near | (memory["near"] >= team.near_time)
    found: np.ndarray = (behaviours(match) == APPROACH) & (memory["stuck"] >= team.stuck_count) & both
    return found


def sample(batch: Batch) -> Moments:
    """Watch a batch of matches and copy them where somebody is held, and where somebody's counters trip.

    The same for all claims: of a batch only seed, index and pose count.
    """
    return _sample(replace(batch, claim="moments"))


@lru_cache(maxsize=64)
def _sample(batch: Batch) -> Moments:
    """Return the same of a batch that can be looked up."""
    match = kick_off(batch, matches=MATCHES, team=BASE)
    watch = Watch(match)
    since = np.full((2, *match.robots.shape), np.inf)
    found: list[tuple[dict[str, np.ndarray], dict[str, Any]]] = []
    taken = np.zeros(MATCHES, int)
    for _ in play(match, SECONDS):
        watch.look()
        since += match.league.dt
        if not watch.full():
            continue
        now = np.stack([watch.held(), tripped(match)])
        begins = now & (since > AGAIN) & ((match.matches["phase"] == Phase.PLAY) & (taken < MOST))[:, None]
        since[now] = 0.0
        for kind, m, r in np.argwhere(begins):
            taken[m] += 1
            found.append(copy_moment(match, watch, int(kind), int(m), int(r)))
    match.close()
    return gathered(match, found)


def gathered(match: Match, found: list[tuple[dict[str, np.ndarray], dict[str, Any]]]) -> Moments:
    """Return what was copied of matches such as this one; no moments, of nothing."""
    copies = {
        name: np.stack([saved[name] for saved, _ in found]) if found else array[:0]
        for name, array in parts(match).items()
    }
    return Moments(copies, *(np.array([words[item.name] for _, words in found]) for item in fields(Moments)[1:]))


def copy_moment(match: Match, watch: Watch, kind: int, m: int, r: int) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Return copies of the parts of match m, and what the moment is like for robot r."""
    saved = {name: array[m].copy() for name, array in parts(match).items()}
    robots, ball = match.robots[m], match.balls[m]
    x, y = ball["x"] - robots["x"][r], ball["y"] - robots["y"][r]
    bearing = np.arctan2(y, x) - robots["heading"][r]
    words = {
        "match": m,
        "robot": r,
        "team": int(robots["team"][r]),
        "kind": kind,
        "held": bool(watch.held()[m, r]),
        "touching": bool(watch.touches()[m, r]),
        "still": bool(watch.still()[m, r]),
        "near": bool(of_camera(match, np.hypot(x, y), bearing) < SacksSettings().near),
        "theirs": bool(((robots["team"] != robots["team"][r]) & (robots["has_ball"] == 1)).any()),
    }
    return saved, words


def branch(batch: Batch, moments: Moments, chosen: np.ndarray, team: int, settings: dict[str, Any]) -> Match:
    """Return matches that go on from the chosen moments (mask or rows), one team with settings by name."""
    sides: dict[str, Any] = {"home": BASE, "away": BASE}
    sides["home" if team == HOME else "away"] = make_team("sacks-2001", **settings)
    match = kick_off(batch, rules=PATIENT, matches=len(moments.match[chosen]), controllers=sides)
    for name, array in parts(match).items():
        array[...] = moments.parts[name][chosen]
    match.rebuild()
    return match
