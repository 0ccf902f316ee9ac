"""Who has the ball, for how long, and what he does with it."""

from __future__ import annotations

import numpy as np

from soccer_env.train.play.figures import Measure, Samples, a_minute, most, percentile, share
from soccer_env.train.play.recording import Recording
from soccer_env.train.play.runs import bridged, by_match, runs_of

LOST = 0.5  # [s] without the ball that end a spell
BESIDE = 1.15  # reaches of both bodies within which an opponent goes beside who has the ball: 0.66 m in middle size
MOVES = 0.15  # [m/s] of who goes with the ball
AGAIN = 1.0  # [s] without a touch after which the next one counts anew


def spells(recording: Recording) -> Samples:
    """Time for which one robot has the ball in its pocket or at its kicker, breaks of up to 0.5 s closed."""
    has_ball = (recording.robots["has_ball"] == 1) & recording.in_play[..., None]
    runs = runs_of(bridged(has_ball, recording.steps(LOST)) & recording.in_play[..., None])
    _, matches, robots = has_ball.shape
    return {
        "spells": by_match(runs.steps * recording.league.dt, runs.columns, matches, robots),
        "held": recording.seconds(has_ball.any(axis=-1)),
    }


def escorts(recording: Recording) -> Samples:
    """Time for which one robot goes with the ball while an opponent stays at its side, breaks of up to 0.3 s closed."""
    robots = recording.robots
    has_ball = bridged((robots["has_ball"] == 1) & recording.in_play[..., None], recording.steps(LOST))
    goes = has_ball & recording.in_play[..., None] & (np.hypot(robots["vx"], robots["vy"]) > MOVES)
    runs = runs_of(bridged(goes & opponent_beside(recording), recording.steps(0.3)) & recording.in_play[..., None])
    _, matches, players = has_ball.shape
    return {"escorts": by_match(runs.steps * recording.league.dt, runs.columns, matches, players)}


def opponent_beside(recording: Recording) -> np.ndarray:
    """Return which robots (T, M, R) have an opponent beside them."""
    robots, found = recording.robots, np.zeros(recording.robots.shape, bool)
    for other in range(robots.shape[-1]):
        one = robots[..., other : other + 1]
        near = np.hypot(robots["x"] - one["x"], robots["y"] - one["y"]) < BESIDE * 2.0 * recording.league.body.reach
        found |= near & (robots["team"] != one["team"]) & (one["active"] == 1)
    return found


def touches(recording: Recording) -> Samples:
    """Touches of the ball by a robot that has not touched it for 1 s; and how often another robot touches it last."""
    touch = (recording.deeds["touch"] == 1) & recording.in_play[..., None]
    runs = runs_of(bridged(touch, recording.steps(AGAIN)))
    _, matches, robots = touch.shape
    last = recording.matches["last_touch_robot"]
    changes = (last[1:] != last[:-1]) & (last[1:] >= 0) & recording.in_play[1:]
    return {"touches": np.bincount(runs.columns // robots, minlength=matches), "changes": changes.sum(axis=0)}


def kicks(recording: Recording) -> Samples:
    """Kicks that reach the ball, and its speed at the end of the control step of each."""
    kick = (recording.deeds["kick"] == 1) & recording.live[..., None]
    speed = np.hypot(recording.balls["vx"], recording.balls["vy"])
    steps, columns = np.nonzero(kick.any(axis=-1))
    return {
        "kicks": kick.sum(axis=(0, 2)),
        "kick_speeds": by_match(speed[steps, columns], columns, kick.shape[1], 1),
    }


MEASURES = (
    Measure(
        spells,
        (
            share("somebody has the ball", "held"),
            percentile("spell of one robot, median", "spells", 50.0, "s"),
            percentile("spell of one robot, 90 %", "spells", 90.0, "s"),
            most("spell of one robot, longest", "spells", "s"),
        ),
    ),
    Measure(
        escorts,
        (
            percentile("goes with the ball beside an opponent, 90 %", "escorts", 90.0, "s"),
            most("goes with the ball beside an opponent, longest", "escorts", "s"),
        ),
    ),
    Measure(touches, (a_minute("touches", "touches"), a_minute("changes of who touched last", "changes"))),
    Measure(
        kicks,
        (
            a_minute("kicks", "kicks"),
            *(percentile(f"speed of a kicked ball, {p} %", "kick_speeds", float(p), "m/s") for p in (10, 50, 90)),
        ),
    ),
)
