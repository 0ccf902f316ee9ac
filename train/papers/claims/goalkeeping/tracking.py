"""The believed velocities of ball and robots in play, and the challenge of 2003.  [Heinemann et al. 2006, 1]"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.scenes import find_scene
from soccer_env.train.papers.claim import FIRST, PLAYED, Batch, claim, compare
from soccer_env.train.papers.staging import MIDDLE, make_matches
from soccer_env.train.papers.values import median
from soccer_env.train.papers.verdicts import Samples, measured, reported

MATCHES, SETTLE, SECONDS = 8, 2.0, 12.0  # of 5 v 5, [s] not measured, [s] of each
EVERY = 10  # cycles between two samples
MOVES = 0.5  # [m/s] of a thing that moves
KICKED = 2.6  # [m/s] of a ball faster than robots
SEEN = 0.1  # [s] greatest age of a belief that counts
APART = 0.5  # [m] greatest distance of a track from the robot that it stands for
THIRD = 100.0 / 3.0  # [%] of a speed that an accurate velocity errs by at most, assumed


def turned(x: Any, y: Any, heading: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return vectors of a robot's axes in the axes of the field."""
    cosine, sine = np.cos(heading), np.sin(heading)
    return cosine * x - sine * y, sine * x + cosine * y


def velocity_errors(match: Match) -> dict[str, np.ndarray]:
    """Return errors of believed velocities over the true speeds [1], NaN for things at rest or not seen.

    "ball", "kicked" (M, R), "robots" (M, R, slots), of opponents.
    """
    robots, ball, believed = match.robots, match.balls, match.beliefs["ball"]
    speed = np.hypot(ball["vx"], ball["vy"])[:, None]
    vx, vy = turned(believed["vx"], believed["vy"], robots["heading"])
    error = np.hypot(vx - ball["vx"][:, None], vy - ball["vy"][:, None]) / np.maximum(speed, MOVES)
    there = (believed["age"] < SEEN) & (robots["has_ball"] == 0) & (robots["active"] == 1)
    found = {name: np.where(there & (speed > least), error, np.nan) for name, least in
             (("ball", MOVES), ("kicked", KICKED))}  # fmt: skip
    tracks, heading = match.tracks, robots["heading"][..., None]
    x, y = turned(tracks["x"], tracks["y"], heading)
    x, y = x + robots["x"][..., None], y + robots["y"][..., None]
    gaps = np.hypot(x[..., None] - robots["x"][:, None, None], y[..., None] - robots["y"][:, None, None])
    gaps = np.where(robots["team"][:, None, None, :] == robots["team"][..., None, None], np.inf, gaps)
    nearest, rows = gaps.argmin(axis=-1), np.arange(match.count)[:, None, None]
    vx, vy = turned(tracks["vx"], tracks["vy"], heading)
    true_x, true_y = robots["vx"][rows, nearest], robots["vy"][rows, nearest]
    speed = np.hypot(true_x, true_y)
    own = (tracks["present"] == 1) & (tracks["teammate"] == 0) & (tracks["age"] < SEEN)
    own &= (gaps.min(axis=-1) < APART) & (speed > MOVES)
    found["robots"] = np.where(own, np.hypot(vx - true_x, vy - true_y) / np.maximum(speed, MOVES), np.nan)
    return found


def watch_velocities(batch: Batch) -> Samples:
    """Return the relative errors (M, robots and samples) of each robot's believed velocities in play."""
    match = make_matches(
        batch, MIDDLE, batch.play_rules, matches=MATCHES, home=5, away=5, senses="sensors",
        controllers={"home": "heinemann-2006", "away": "chaser"},
    )  # fmt: skip
    rows: dict[str, list[np.ndarray]] = {}
    for step in range(round((SETTLE + SECONDS) * match.league.control_rate)):
        match.step()
        if step >= SETTLE * match.league.control_rate and step % EVERY == 0:
            for name, error in velocity_errors(match).items():
                rows.setdefault(name, []).append(error.reshape(MATCHES, -1))
    match.close()
    return {name: np.concatenate(errors, axis=1) for name, errors in rows.items()}


H29 = claim(
    "H29", "1", "Robust tracking gives an accurate model of the environment, with the velocities of the objects.",
    f"{MATCHES} matches a batch of 5 v 5 against the chaser, {SECONDS:g} s each, by sensors and particles: "
    f"error of the believed velocity of ball and opponents that move at {MOVES:g} m/s and more and were seen within "
    f"{SEEN:g} s, over their speed (median). \"Accurate\" is read as a third; the paper gives no number.",
    measured("ball", "ball", of=median, unit="%", at_most=THIRD),
    measured("opponents", "robots", of=median, unit="%", at_most=THIRD),
    reported("balls faster than robots", "kicked", of=median, unit="%"),
    rules=PLAYED, measure=watch_velocities, batches=4, seconds=3.0,
    ingredients=("memory.ball_agility, player_agility: leagues/omni_sensors.py",),
)  # fmt: skip

RUNS = 24  # of the challenge a batch and variant
CHALLENGE = "challenge-2003"
BALLS: dict[str, dict[str, Any]] = {
    "coloured": {"senses": "sensors"},
    "plain": {"senses": "sensors", "sensors": {"ball_coloured": False}},
    "ideal": {"senses": "ideal"},
}


def dribble_round(batch: Batch, senses: dict[str, Any]) -> Samples:
    """Return in which runs of the challenge (M,) a robot gets "past" with the ball, and in which untouched: "clean"."""
    scene = find_scene(CHALLENGE)
    sides = {"home": "heinemann-2006:dribbles_round=True", "away": "still"}
    match = make_matches(batch, MIDDLE, scene.rules, matches=RUNS, home=1, away=4, scene=scene, episode="drill",
                         controllers=sides, **senses)  # fmt: skip
    past, touched = np.zeros((2, RUNS), bool)
    over = past.copy()
    while not over.all():
        match.step()
        past |= match.events["drill"] == 1
        touched |= ~over & (match.robot_events["collision"][:, 0] == 1)
        over |= past | match.terminated | match.truncated
    match.close()
    return {"past": past.astype(float), "clean": (past & ~touched).astype(float)}


H25 = claim(
    "H25", "1", "The code won the challenge of 2003: round static obstacles, and with an uncoloured ball.",
    f"{RUNS} runs a batch of the drill {CHALLENGE}, past four still obstacles (dribbles_round=True), by "
    "sensors, with a coloured ball and with one that is found by its shape: past all of them with the ball, touching "
    "none. To win is read as most runs.",
    measured("past without a touch", "coloured clean", unit="%", above=50.0),
    measured("uncoloured ball: past", "plain past", unit="%", above=50.0),
    reported("past without a touch, ideal senses", "ideal clean", unit="%"),
    measure=lambda batch: compare(BALLS, partial(dribble_round, batch), FIRST), batches=12, seconds=2.0,
    ingredients=("dribbles_round, which the team leaves off in matches", "the drill's places"),
)  # fmt: skip
