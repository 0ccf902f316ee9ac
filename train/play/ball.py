"""Where the ball lies, and how far it comes back from boards and robots."""

from __future__ import annotations

import numpy as np

from soccer_env.leagues.league import Pitch
from soccer_env.train.play.figures import IN_PLAY, PLAYED, Measure, Samples, a_minute, percentile, share
from soccer_env.train.play.recording import Recording
from soccer_env.types import NO_TEAM

STILL = 0.02  # [m/s]
AT_LINE, IN_CORNER = 0.20, 0.25  # [m]
CLOSE = 0.01  # [m] a board this near may have been hit
QUICK = 0.2  # [1] of the fastest kick: a ball slower than that does not count as one that rebounds
SENT_BACK = 0.5  # [1] of the speed towards a board that is gone after a blow
FREE, WATCHED = 0.5, 3.0  # [s] untouched before a blow; that a rebound is followed


def times(recording: Recording) -> Samples:
    """Time in play: what is left of a match without placing and waiting for restarts."""
    return {PLAYED: recording.seconds(recording.live), IN_PLAY: recording.seconds(recording.in_play)}


def goals(recording: Recording) -> Samples:
    """Goals that the referee gives, of both teams together."""
    return {"goals": ((recording.events["goal"] != NO_TEAM) & recording.live).sum(axis=0)}


def whistles(recording: Recording) -> Samples:
    """Restarts of any kind that the referee calls, goals' kick-offs among them, and opponents that he pulls apart."""
    events, live = recording.events, recording.live
    return {
        "restarts": ((events["restart"] != 0) & live).sum(axis=0),
        "separations": ((events["separated"] == 1) & live).sum(axis=0),
    }


def lying(recording: Recording) -> Samples:
    """Time in play in which the ball is slower than 2 cm/s."""
    balls = recording.balls
    return {"still": recording.seconds(recording.in_play & (np.hypot(balls["vx"], balls["vy"]) < STILL))}


def at_boards(recording: Recording) -> Samples:
    """Time in play in which the ball's centre is within 20 cm of a goal line or touchline, or 25 cm of two (a corner).

    A ball in a goal is at its line.
    """
    along, aside = to_lines(recording.league.pitch, recording.balls)
    corner = (along < IN_CORNER) & (aside < IN_CORNER)
    return {
        "at_boards": recording.seconds(recording.in_play & (np.minimum(along, aside) < AT_LINE)),
        "in_corner": recording.seconds(recording.in_play & corner),
    }


def to_lines(pitch: Pitch, balls: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the distances [m] of a ball from the nearer goal line and touchline, below 0 beyond."""
    return pitch.length / 2 - np.abs(balls["x"]), pitch.width / 2 - np.abs(balls["y"])


def off_boards(recording: Recording) -> Samples:
    """Greatest gap between ball and board after a blow, until a robot touches the ball or 3 s are over.

    A blow takes half of the speed at which a ball comes to a board that has not been touched for 0.5 s and is faster
    than a fifth of the fastest kick; the sides of the goals and leagues with a band do not count.
    """
    found: list[list[float]] = [[] for _ in range(recording.live.shape[1])]
    if recording.league.pitch.walled:
        alone = untouched(recording)
        for gaps, speeds in sides(recording):
            for step, m in zip(*np.nonzero(hits(recording, gaps, speeds) & alone), strict=True):
                found[m].append(farthest(recording, gaps[:, m], int(step), m))
    return {"off_boards": as_samples(found)}


def sides(recording: Recording) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return the ball's gap (T, M) [m] from each of the four boards and its speed towards it; inf before a goal."""
    pitch, balls, radius = recording.league.pitch, recording.balls, recording.league.ball.radius
    before_goal = np.abs(balls["y"]) < pitch.goal_width / 2 + radius
    found = []
    for sign in (1.0, -1.0):
        gap = pitch.length / 2 - sign * balls["x"] - radius
        found.append((np.where(before_goal, np.inf, gap), sign * balls["vx"]))
        found.append((pitch.width / 2 - sign * balls["y"] - radius, sign * balls["vy"]))
    return found


def hits(recording: Recording, gaps: np.ndarray, speeds: np.ndarray) -> np.ndarray:
    """Return the steps (T, M) in which a ball hit a board that it came to at such speeds (T, M) [m/s]."""
    hit = np.zeros(gaps.shape, bool)
    before, after = speeds[:-1], speeds[1:]
    quick = before > QUICK * recording.league.kicker.fastest
    reached = gaps[:-1] < before * recording.league.dt + CLOSE
    hit[1:] = quick & reached & (after < (1.0 - SENT_BACK) * before)
    hit &= recording.in_play
    return hit


def untouched(recording: Recording) -> np.ndarray:
    """Return the steps (T, M) in which and for a while before which the ball was in play and nobody touched it."""
    alone: np.ndarray = recording.in_play & ~(recording.deeds["touch"] == 1).any(axis=-1)
    for back in range(1, recording.steps(FREE) + 1):
        alone[back:] &= recording.in_play[:-back] & ~(recording.deeds["touch"][:-back] == 1).any(axis=-1)
        alone[:back] = False
    return alone


def farthest(recording: Recording, gaps: np.ndarray, step: int, m: int) -> float:
    """Return the greatest of gaps (T,) [m] from a step on, until somebody touches the ball or it is not in play."""
    last = min(step + recording.steps(WATCHED), len(gaps))
    ends = (recording.deeds["touch"][step + 1 : last, m] == 1).any(axis=-1) | ~recording.in_play[step + 1 : last, m]
    until = step + 1 + int(np.argmax(ends)) if ends.any() else last
    finite = gaps[step:until][np.isfinite(gaps[step:until])]
    return float(max(finite.max(initial=0.0), 0.0))


def off_robots(recording: Recording) -> Samples:
    """Distance by which a ball leaves a robot after a blow, until a robot touches it anew or 3 s are over.

    A blow is the first touch after 0.5 s without one, by a ball that comes to the robot faster than a fifth of the
    fastest kick; a robot that kicks in it or in the next 0.5 s does not count.
    """
    found: list[list[float]] = [[] for _ in range(recording.live.shape[1])]
    fresh = np.zeros(recording.live.shape, bool)
    fresh[1:] = untouched(recording)[:-1]
    touch = (recording.deeds["touch"] == 1) & (fresh & recording.in_play)[..., None]
    closing = speed_to_robots(recording)
    for step, m, r in zip(*np.nonzero(touch), strict=True):
        kicks = recording.deeds["kick"][step : step + recording.steps(FREE), m] == 1
        if closing[step - 1, m, r] > QUICK * recording.league.kicker.fastest and not kicks.any():
            found[m].append(leaving(recording, int(step), m, r))
    return {"off_robots": as_samples(found)}


def speed_to_robots(recording: Recording) -> np.ndarray:
    """Return the speed (T, M, R) [m/s] at which the ball comes nearer to each robot's centre."""
    balls, robots = recording.balls[..., None], recording.robots
    x, y = robots["x"] - balls["x"], robots["y"] - balls["y"]
    towards = (balls["vx"] - robots["vx"]) * x + (balls["vy"] - robots["vy"]) * y
    found: np.ndarray = towards / np.maximum(recording.ball_distance, 1e-9)
    return found


def leaving(recording: Recording, step: int, m: int, r: int) -> float:
    """Return how much farther [m] from robot r the ball gets than at a step, until it is touched anew."""
    last = min(step + recording.steps(WATCHED), len(recording.live))
    touched = (recording.deeds["touch"][step:last, m] == 1).any(axis=-1)
    apart = int(np.argmin(touched)) if not touched.all() else last - step  # the blow itself may last some steps
    anew = touched[apart:] | ~recording.in_play[step + apart : last, m]
    until = step + apart + (int(np.argmax(anew)) if anew.any() else len(anew))
    distance = recording.ball_distance[step:until, m, r]
    return float(distance.max() - distance[0])


def as_samples(values: list[list[float]]) -> np.ndarray:
    """Return values of each match as an array (M,) of arrays."""
    found = np.empty(len(values), object)
    for m, ones in enumerate(values):
        found[m] = np.array(ones, np.float64)
    return found


MEASURES = (
    Measure(times, (share("ball in play", IN_PLAY, PLAYED),)),
    Measure(goals, (a_minute("goals", "goals"),)),
    Measure(whistles, (a_minute("restarts", "restarts"), a_minute("separations", "separations"))),
    Measure(lying, (share("ball lies still", "still"),)),
    Measure(at_boards, (share("ball at a board or line", "at_boards"), share("ball in a corner", "in_corner"))),
    Measure(
        off_boards,
        (
            percentile("rebound from a board, median", "off_boards", 50.0, "cm", 100.0),
            percentile("rebound from a board, 90 %", "off_boards", 90.0, "cm", 100.0),
        ),
    ),
    Measure(
        off_robots,
        (
            percentile("rebound from a robot, median", "off_robots", 50.0, "cm", 100.0),
            percentile("rebound from a robot, 90 %", "off_robots", 90.0, "cm", 100.0),
        ),
    ),
)
