"""Moments of play in which a robot is held, or believes that it is stuck, and branches of the match from them.

In matches of 3 v 3 without recovery, the whole match is copied where a robot that goes for the ball is held by others,
and where its counters trip. A branch continues from there with other settings for that robot's team; bodies, noise and
memories are equal in all branches, which pairs them. In branches the referee whistles for nothing and pulls nobody
apart; running penalties end in time. A robot that is sent off is neither held nor free.
"""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import APPROACH
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.match import Match
from soccer_env.match.saving import parts
from soccer_env.match.staging import PATIENT, memory_of
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import Batch, shared
from soccer_env.train.papers.staging import kick_off, play
from soccer_env.types import HOME, Phase

BASE = "sacks-2001:recovery=False"  # both teams before a branch, and the opponents in it
MATCHES, SECONDS = 8, 60.0  # of 3 v 3 a batch, [s] of each
WINDOW = 1.5  # [s] that decide whether a robot is held, assumed, like the five below
SHARE = 0.25  # [1] of the way that its legs walked: a held robot moves less
WALKED = 0.03  # [m] that its legs walked at least
TOUCHING = 0.5  # [1] least share of the window in contact
STILL = 0.03  # [m] greatest movement of a still ball in the window
AGAIN = 10.0  # [s] after which a robot may be sampled once more
MOST = 12  # moments of a match at most
HELD, TRIPPED = 0, 1  # kinds of moments
OUT = -1  # behaviour of a player that is sent off


@dataclass(frozen=True)
class Moments:
    """Copies of matches (N,), each at a moment of one robot, and the circumstances of these moments."""

    parts: dict[str, np.ndarray]  # everything that the future depends on, by name
    match: np.ndarray  # number in the batch
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


class MotionWindow:
    """A sliding window over the movements of robots (M, R): the last `seconds` seconds."""

    def __init__(self, match: Match, seconds: float = WINDOW) -> None:
        self.match = match
        self.size = round(seconds * match.league.control_rate)
        self.rows: list[np.ndarray] = []

    def look(self) -> None:
        """Append the robots' and the ball's positions and states after a control step to the window."""
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
        """Return the distances [m] that the robots moved from start to end of the window; with `at` 5, the ball's."""
        way = self.rows[-1][at : at + 2] - self.rows[0][at : at + 2]
        return np.asarray(np.hypot(way[0], way[1]))

    def mean(self, row: int) -> np.ndarray:
        """Return the mean over the window of one recorded quantity, by its row in `look`."""
        return np.asarray(np.mean([now[row] for now in self.rows], axis=0))

    def touches(self) -> np.ndarray:
        """Tell which robots were in contact for most of the window."""
        return self.mean(3) >= TOUCHING

    def there(self) -> np.ndarray:
        """Tell which robots were on the field throughout, and were not moved by the referee."""
        return np.asarray(self.mean(7) == 1.0)

    def held(self) -> np.ndarray:
        """Tell which robots went for the ball, in contact, and moved much less than their legs walked."""
        walked = self.mean(2) * self.size
        gone = self.path() < SHARE * walked
        return np.asarray((self.mean(4) == 1.0) & self.touches() & (walked > WALKED) & gone)

    def fell_short(self) -> np.ndarray:
        """Tell which robots went for the ball, in contact, and approached it much less than their legs walked.

        Unlike held robots they may move: two robots that push the ball ahead of them come no nearer to the ball.
        """
        first, last = (np.hypot(now[5] - now[0], now[6] - now[1]) for now in (self.rows[0], self.rows[-1]))
        walked = self.mean(2) * self.size
        nearer = first - last >= SHARE * walked
        return np.asarray((self.mean(4) == 1.0) & self.touches() & (walked > WALKED) & ~nearer)

    def still(self) -> np.ndarray:
        """Tell in which matches the ball lay still."""
        return self.path(5) < STILL


def behaviours(match: Match) -> np.ndarray:
    """Return the current behaviour of each player (M, R) of this package's teams, OUT for players that are sent off.

    A player that is sent off remembers its behaviour, and resumes it when it returns.
    """
    doing = np.stack([memory_of(match, r)["behaviour"] for r in range(match.robots.shape[1])], axis=1)
    return np.where(match.robots["active"] == 1, doing, OUT)


def distance_from_camera(match: Match, distance: np.ndarray, bearing: np.ndarray) -> np.ndarray:
    """Convert distances [m] from body centres, at bearings [rad], to distances from a camera that looks ahead."""
    ahead = match.league.head.camera_ahead
    return np.asarray(np.hypot(distance * np.cos(bearing) - ahead, distance * np.sin(bearing)))


def counters_have_tripped(match: Match) -> np.ndarray:
    """Tell which robots (M, R) on the path to the ball are stuck by both counters of Sacks (2001)."""
    team = SacksSettings()
    memory = np.stack([memory_of(match, r) for r in range(match.robots.shape[1])], axis=1)
    ball = match.beliefs["ball"]
    near = distance_from_camera(match, ball["filtered_distance"], ball["filtered_bearing"]) < team.near
    both = ~near | (memory["near"] >= team.near_time)
    return np.asarray((behaviours(match) == APPROACH) & (memory["stuck"] >= team.stuck_count) & both)


@shared("moments", most=64)
def sample_moments(batch: Batch) -> Moments:
    """Play a batch of matches, and copy them where a robot is held and where its counters trip.

    All claims share these moments, which depend only on the batch's seed, index and pose.
    """
    match = kick_off(batch, matches=MATCHES, team=BASE)
    watch = MotionWindow(match)
    since = np.full((2, *match.robots.shape), np.inf)
    copies: list[tuple[dict[str, np.ndarray], dict[str, Any]]] = []
    taken = np.zeros(MATCHES, int)
    for _ in play(match, SECONDS):
        watch.look()
        since += match.league.dt
        if not watch.full():
            continue
        now = np.stack([watch.held(), counters_have_tripped(match)])
        begins = now & (since > AGAIN) & ((match.matches["phase"] == Phase.PLAY) & (taken < MOST))[:, None]
        since[now] = 0.0
        for kind, m, r in np.argwhere(begins):
            taken[m] += 1
            copies.append(copy_moment(match, watch, int(kind), int(m), int(r)))
    match.close()
    return stack_moments(match, copies)


def stack_moments(match: Match, copies: list[tuple[dict[str, np.ndarray], dict[str, Any]]]) -> Moments:
    """Stack copies of moments into arrays; `match` gives the shapes if there are no copies."""
    stacked = {
        name: np.stack([saved[name] for saved, _ in copies]) if copies else array[:0]
        for name, array in parts(match).items()
    }
    return Moments(stacked, *(np.array([words[item.name] for _, words in copies]) for item in fields(Moments)[1:]))


def copy_moment(
    match: Match, watch: MotionWindow, kind: int, m: int, r: int
) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Return copies of the parts of match m, and the circumstances of the moment for robot r."""
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
        "near": bool(distance_from_camera(match, np.hypot(x, y), bearing) < SacksSettings().near),
        "theirs": bool(((robots["team"] != robots["team"][r]) & (robots["has_ball"] == 1)).any()),
    }
    return saved, words


def branch(batch: Batch, moments: Moments, chosen: np.ndarray, team: int, settings: dict[str, Any]) -> Match:
    """Return matches that continue from the chosen moments (mask or rows), one team with the given settings."""
    sides: dict[str, Any] = {"home": BASE, "away": BASE}
    sides["home" if team == HOME else "away"] = make_team("sacks-2001", **settings)
    match = kick_off(batch, rules=PATIENT, matches=len(moments.match[chosen]), controllers=sides)
    for name, array in parts(match).items():
        array[...] = moments.parts[name][chosen]
    match.rebuild()
    return match
