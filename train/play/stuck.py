"""Robots that want to walk and are stopped by others, and how long they stay so."""

from __future__ import annotations

import numpy as np

from soccer_env.train.play.figures import Measure, Samples, often_from, percentile, share_from
from soccer_env.train.play.recording import Recording
from soccer_env.train.play.runs import Runs, bridged, by_match, runs_of

WANTS = 0.15  # [1] of the top speed ahead: who wants less than that does not want to get anywhere, assumed
MAKES = 0.25  # [1] of the walk that is wanted
TOUCH = 0.004  # [m] a robot this near is touched
BREAK = 0.5  # [s] of getting on that does not end being blocked: a gait step
LONG, NOTED = 1.5, 1.0  # [s] that being blocked, and being blocked on the way to the ball, lasts at least to count
FAR = 0.35  # [m] from the ball: the robot is on its way to it


def blocked(recording: Recording) -> Samples:
    """Time for which a robot wants to walk, touches another robot and makes less than 25 % of the walk it wants.

    It wants at least 15 % of its top speed; breaks of up to 0.5 s are closed; what lasts less than 1.5 s is left out.
    """
    return {"blocked": lasting(recording, blocked_runs(recording, LONG))}


def approaching(recording: Recording) -> Samples:
    """Time for which a robot is blocked that stays more than 35 cm from the ball (centres), 1 s and more."""
    runs = blocked_runs(recording, NOTED)
    distance = recording.ball_distance.reshape(len(recording.live), -1)
    least = [distance[first:last, column].min() for column, first, last in zip(*runs, strict=True)]
    return {"approaching": lasting(recording, runs.where(np.array(least, np.float64) > FAR))}


def blocked_runs(recording: Recording, least: float) -> Runs:
    """Return when robots are blocked for so long [s] or longer."""
    flags = stopped(recording) & touching(recording) & recording.in_play[..., None]
    runs = runs_of(bridged(flags, recording.steps(BREAK)) & recording.in_play[..., None])
    return runs.where(runs.steps >= recording.steps(least))


def stopped(recording: Recording) -> np.ndarray:
    """Return where (T, M, R) a robot makes less than MAKES of the walk that its gait or wheels aim at."""
    robots = recording.robots
    ahead, left = robots["target"]["forward"], robots["target"]["left"]
    wanted = np.hypot(ahead, left)
    cosine, sine = np.cos(robots["heading"]), np.sin(robots["heading"])
    along_x, along_y = cosine * ahead - sine * left, sine * ahead + cosine * left
    made = robots["vx"] * along_x + robots["vy"] * along_y  # times what is wanted
    able = (robots["active"] == 1) & (robots["kick_clock"] <= 0.0) & (robots["fallen"] <= 0.0)
    found: np.ndarray = able & (wanted > WANTS * recording.league.drive.forward) & (made < MAKES * wanted * wanted)
    return found


def touching(recording: Recording) -> np.ndarray:
    """Return where (T, M, R) a robot touches another."""
    found = np.zeros(recording.robots.shape, bool)
    for pair, rows in enumerate(recording.gaps.pairs):
        found[..., rows] |= (recording.gaps.robot_robot[..., pair] < TOUCH)[..., None]
    return found


def lasting(recording: Recording, runs: Runs) -> np.ndarray:
    """Return how long [s] runs last, as an array (M,) of arrays."""
    _, matches, robots = recording.robots.shape
    return by_match(runs.steps * recording.league.dt, runs.columns, matches, robots)


MEASURES = (
    Measure(
        blocked,
        (
            often_from("blocked 1.5 s and more", "blocked", LONG),
            percentile("blocked, median", "blocked", 50.0, "s"),
            percentile("blocked, 90 %", "blocked", 90.0, "s"),
            share_from("blocked, 5 s and more", "blocked", 5.0),
            share_from("blocked, 10 s and more", "blocked", 10.0),
        ),
    ),
    Measure(
        approaching,
        (
            often_from("approaching and blocked 1 s and more", "approaching", NOTED),
            percentile("approaching and blocked, median", "approaching", 50.0, "s"),
            percentile("approaching and blocked, 90 %", "approaching", 90.0, "s"),
            share_from("approaching and blocked, 5 s and more", "approaching", 5.0),
            share_from("approaching and blocked, 10 s and more", "approaching", 10.0),
        ),
    ),
)
