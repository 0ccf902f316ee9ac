"""The point-mass simulator that the author tried first, with the team's own forces and steering.  [Sacks 2001, 4.3]

A point goes to the opponents' goal past points that stand or move (MS54). Every play.replan [s] the point decides as a
dribbler does (`steering.choose_dribble_direction`) and goes on at the pace of steps of
play.step_length. There is no ball, no delay and nothing to bump into: "this model would not carry over well to the
actual robots".

    runs = PointWorld(SacksSettings(keep_side=False)).run([[-1.0, 0.0]], players([[0.0, 0.3]]))
    runs.path[:, 0], runs.clearance[0], runs.flips[0]

`k`: the league's constants; `play`: the team's settings.
"""

from dataclasses import dataclass, field, replace
from math import atan2, cos, sin
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import MEMORY
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.baselines.sacks_2001.steering import (
    BEHIND_LINE,
    choose_dribble_direction,
    direction_to_goal,
    off_ahead,
    step_speed,
)
from soccer_env.compiled import compiled, scratch_records
from soccer_env.geometry import length, wrap
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.records.beliefs import BELIEF, TRACK

ARRIVED = 0.20  # [m] from the destination, 10 cm behind the goal line: in the goal's mouth, assumed
BLOB_NEAR, BLOB_FAR = 0.5, 2.5  # [m] a jersey of 2 to 10 pixels at 88x72: a false blob is small, assumed
BLOB_ASIDE = 1.2  # [rad] beside the goal's direction at most, assumed: the view of a glancing head

POINT_PLAYER = np.dtype(
    [
        ("x", "f8"),  # [m] team frame
        ("y", "f8"),  # [m]
        ("vx", "f8"),  # [m/s] team frame
        ("vy", "f8"),  # [m/s]
        ("chase", "f8"),  # [m/s] at which it comes for the dribbler instead; 0: it does not
    ]
)


SIDE = 0.35  # [rad] off the goal beyond which a way counts as left or right of it: 20 degrees, assumed
ROUNDING = 1e-9  # [m]


@dataclass(frozen=True)
class PointRuns:
    """M runs of points over T decisions; values are NaN once a point has arrived."""

    path: np.ndarray  # (T + 1, M, 2) [m] team frame
    off: np.ndarray  # (T, M) [rad] of each step off the goal's direction, left positive
    others: np.ndarray  # (T + 1, M, P, 2) [m] the other players
    goal: float  # [m] x of the destination
    replan: float  # [s] between two decisions

    @property
    def arrived(self) -> np.ndarray:
        """Tell which points arrived (M,)."""
        return np.asarray(np.isnan(self.path[-1, :, 0]))

    @property
    def clearance(self) -> np.ndarray:
        """Return the least distance to another player (M,) [m], at decisions and between decisions."""
        gap = self.others - self.path[:, :, None]
        before, change = gap[:-1], np.diff(gap, axis=0)
        square = np.maximum((change**2).sum(axis=-1), ROUNDING**2)
        share = np.clip(-(before * change).sum(axis=-1) / square, 0.0, 1.0)
        nearest = np.linalg.norm(before + share[..., None] * change, axis=-1)
        return np.asarray(np.nanmin(nearest, axis=(0, 2)))

    @property
    def flips(self) -> np.ndarray:
        """Count how often each path changes between left and right of the goal's direction (M,)."""
        return count_flips(self.off)

    @property
    def steps(self) -> np.ndarray:
        """Count the decisions of each run (M,)."""
        return np.asarray(np.isfinite(self.off).sum(axis=0))

    @property
    def retreats(self) -> np.ndarray:
        """Count the steps that lead away from the goal (M,)."""
        distance = np.hypot(self.goal - self.path[..., 0], self.path[..., 1])
        return np.asarray((np.diff(distance, axis=0) > ROUNDING).sum(axis=0))

    @property
    def length(self) -> np.ndarray:
        """Return the lengths of the paths (M,) [m]."""
        return np.asarray(np.nansum(np.linalg.norm(np.diff(self.path, axis=0), axis=-1), axis=0))

    @property
    def deviation(self) -> np.ndarray:
        """Return the greatest distance of each path from the straight line between start and goal (M,) [m]."""
        start = self.path[0]
        line = np.stack([self.goal - start[:, 0], -start[:, 1]], axis=-1)
        way = self.path - start
        across = (line[:, 0] * way[..., 1] - line[:, 1] * way[..., 0]) / np.linalg.norm(line, axis=-1)
        return np.asarray(np.nanmax(np.abs(across), axis=0))

    @property
    def turns(self) -> np.ndarray:
        """Return the change of direction from each step to the next (T - 1, M) [rad]."""
        way = np.diff(self.path, axis=0)
        turn = np.diff(np.arctan2(way[..., 1], way[..., 0]), axis=0)
        return (turn + np.pi) % (2.0 * np.pi) - np.pi


def count_flips(off: np.ndarray) -> np.ndarray:
    """Count the changes (M,) between more than SIDE left and right of the goal's direction; off (T, M) [rad]."""
    side = np.where(np.abs(off) > SIDE, np.sign(off), 0.0)
    count, last = np.zeros(side.shape[1], int), np.zeros(side.shape[1])
    for now in side:
        count += now * last < 0.0
        last = np.where(now != 0.0, now, last)
    return count


@dataclass(frozen=True)
class PointWorld:
    """A field of points. `body`: the robot faces the goal, and its steps keep within play.body_limit (MS48)."""

    play: SacksSettings = field(default_factory=SacksSettings)
    body: bool = False
    range_noise: float = 0.0  # [1] sd of a player's seen distance, over the distance
    false_blobs: float = 0.0  # [1] probability that a decision sees a player who is not there
    league: str = "legged-2001"

    def run(
        self, start: Any, others: np.ndarray, seconds: float = 60.0, rng: np.random.Generator | None = None
    ) -> PointRuns:
        """Run one dribbling point in each of M worlds: start (M, 2) [m, team frame], others (M, P) of POINT_PLAYER."""
        start, (m, p) = np.asarray(start, float), others.shape
        decisions = round(seconds / self.play.replan)
        errors, blobs = self.draw_noise((decisions, m, p), np.random.default_rng(0) if rng is None else rng)
        path, off = np.full((decisions + 1, m, 2), np.nan), np.full((decisions, m), np.nan)
        places = np.full((decisions + 1, m, p, 2), np.nan)
        constants = constants_of(find_league(self.league))
        play = replace(self.play, distance_from="middle").record()  # points have neither camera nor surface
        run_all(start, others, errors, blobs, constants, play, self.body, path, off, places)
        goal = 0.5 * float(constants["pitch_length"][0]) + BEHIND_LINE
        return PointRuns(path, off, places, goal, self.play.replan)

    def draw_noise(self, shape: tuple[int, ...], rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """Draw factors on distances (T, M, P), and distance and bearing of false blobs (T, M, 2), distance 0: none."""
        errors = np.maximum(1.0 + self.range_noise * rng.standard_normal(shape), 0.1)
        far = rng.uniform(BLOB_NEAR, BLOB_FAR, shape[:2])
        aside = rng.uniform(-BLOB_ASIDE, BLOB_ASIDE, shape[:2])
        far[rng.random(shape[:2]) >= self.false_blobs] = 0.0
        return errors, np.stack([far, aside], axis=-1)


def players(places: Any, velocities: Any = 0.0, chase: Any = 0.0) -> np.ndarray:
    """Return players (M, P) at places (M, P, 2) or (P, 2) [m], with velocities [m/s] or a speed of chasing [m/s]."""
    places = np.asarray(places, float)
    places = places[None] if places.ndim == 2 else places
    made = np.zeros(places.shape[:2], POINT_PLAYER)
    made["x"], made["y"] = places[..., 0], places[..., 1]
    made["vx"], made["vy"] = np.moveaxis(np.broadcast_to(velocities, places.shape), -1, 0)
    made["chase"] = chase
    return made


@compiled
def run_all(start, others, errors, blobs, constants, settings, body, path, off, places):
    """Run all worlds: fill path (T + 1, M, 2), off (T, M) and places (T + 1, M, P, 2) until each point has arrived."""
    k, play = constants[0], settings[0]
    belief, tracks = scratch_records(1, BELIEF), scratch_records(others.shape[1] + 1, TRACK)
    for m in range(start.shape[0]):
        memory = scratch_records(1, MEMORY)
        own = belief[0].own
        own.x, own.y = start[m, 0], start[m, 1]
        crowd = others[m].copy()
        note_places(own, crowd, path[0, m], places[0, m])
        for t in range(off.shape[0]):
            goal_x, goal_y = direction_to_goal(own, k)
            if length(goal_x, goal_y) <= ARRIVED:
                break
            own.heading = atan2(goal_y, goal_x)
            look_at_points(own, crowd, errors[t, m], blobs[t, m], tracks)
            choose_dribble_direction(belief[0], tracks, memory[0], k, play)
            way = memory[0].way
            if body:
                way = own.heading + off_ahead(belief[0], tracks, memory[0], k, play)
            off[t, m] = wrap(way - own.heading)
            move_players(crowd, own, play.replan)
            far = step_speed(k, play) * play.replan
            own.x, own.y = own.x + far * cos(way), own.y + far * sin(way)
            note_places(own, crowd, path[t + 1, m], places[t + 1, m])


@compiled
def look_at_points(own, crowd, errors, blob, tracks):
    """Fill `tracks` with the players as the robot that is a point sees them; the last slot takes a falsely seen one."""
    for p in range(len(crowd)):
        dx, dy = crowd[p].x - own.x, crowd[p].y - own.y
        put_track(tracks[p], errors[p] * length(dx, dy), wrap(atan2(dy, dx) - own.heading))
    put_track(tracks[len(crowd)], blob[0], blob[1])
    tracks[len(crowd)].present = 1 if blob[0] > 0.0 else 0


@compiled
def put_track(track, distance, bearing):
    """Write a player seen at a distance [m] and bearing [rad] into a track."""
    track.present, track.age = 1, 0.0
    track.distance, track.bearing = distance, bearing
    track.x, track.y = distance * cos(bearing), distance * sin(bearing)


@compiled
def move_players(crowd, own, seconds):
    """Move the players for a time [s]: straight on, or straight to the dribbler."""
    for p in range(len(crowd)):
        one = crowd[p]
        dx, dy = own.x - one.x, own.y - one.y
        away = length(dx, dy)
        if one.chase > 0.0 and away > 0.0:
            far = min(one.chase * seconds, away)
            one.x, one.y = one.x + far * dx / away, one.y + far * dy / away
        else:
            one.x, one.y = one.x + one.vx * seconds, one.y + one.vy * seconds


@compiled
def note_places(own, crowd, path, places):
    """Write the places of the dribbler and of the players into `path` and `places`."""
    path[0], path[1] = own.x, own.y
    for p in range(len(crowd)):
        places[p, 0], places[p, 1] = crowd[p].x, crowd[p].y
