"""Shots at the goalkeeper of 2006: from 3 to 5 m, kicked at 4 to 10 m/s at the farther post or the nearer one."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.staging import MIDDLE, begin_scene, put, put_ball, stage_team

Look = Callable[[Match], None] | None
SHOTS = 48  # of a batch
LOOK, SECONDS = 1.0, 3.0  # [s] of looking at the ball before it is kicked, and longest of a shot
FROM = (3.0, 5.0)  # [m] of the ball from the middle of the goal
ANGLES = (0.3, 0.8)  # [rad] of it off the middle of the pitch, so that one post is farther
BESIDE = (0.05, 0.35)  # [m] between the ball and its target post
SPEEDS = (4.0, 10.0)  # [m/s] at the kick; then the ball slides, and rolls on at 0.6 of this speed
SLOW = 0.2  # [m/s] below which a ball counts as stopped
SLOWER = 6.0  # [m/s] up to which a shot counts as slower
FEWER = 20  # of a batch that repeats every shot ten times
SHOT_TEXT = (
    f"shots a batch from {FROM[0]:g} to {FROM[1]:g} m, {ANGLES[0]:g} to {ANGLES[1]:g} rad off the middle, at "
    f"{SPEEDS[0]:g} to {SPEEDS[1]:g} m/s at the kick, {100 * BESIDE[0]:.0f} to {100 * BESIDE[1]:.0f} cm inside a post, "
    f"at a goalkeeper that has looked at the ball for {LOOK:g} s, by sensors and particles"
)


@dataclass(frozen=True)
class ShotOutcomes:
    """The outcome of the shots of a batch, arrays (M,)."""

    speed: np.ndarray  # [m/s] at the kick
    goal: np.ndarray  # bool: it went in
    moved: np.ndarray  # [m] the farthest that the keeper is from its place at the kick before the ball is level with it
    error: np.ndarray  # [m] rms error of the believed ball while it rolled


def face_shots(
    batch: Batch, settings: dict[str, Any], *, shots: int = SHOTS, near_post: bool = False, league: str = MIDDLE,
    look: Look = None, **more: Any,
) -> ShotOutcomes:  # fmt: skip
    """Kick shots at a goalkeeper of heinemann-2006 with `settings`, return outcomes; `more`: options of the match.

    `look` is called in every step after the kick.
    """
    rng, match = batch.rng(), stage_team(batch, "heinemann-2006", settings, league, matches=shots, home=2, **more)
    pitch, ball = match.league.pitch, match.league.ball
    goal, side = -pitch.length / 2, rng.choice([-1.0, 1.0], shots)
    away, angle = rng.uniform(*FROM, shots), side * rng.uniform(*ANGLES, shots)
    x, y = goal + away * np.cos(angle), away * np.sin(angle)
    post = side if near_post else -side
    aim = post * (pitch.goal_width / 2 - ball.radius - rng.uniform(*BESIDE, shots))
    way, speed = np.arctan2(aim - y, goal - x), rng.uniform(*SPEEDS, shots)
    facing = np.arctan2(y, x - goal)
    put(match, 0, goal + 0.8 * np.cos(facing), 0.8 * np.sin(facing), facing)
    put_ball(match, x, y)
    begin_scene(match, placed=True)
    return shoot(match, (x, y), speed, way, look)


def shoot(
    match: Match, place: tuple[np.ndarray, np.ndarray], speed: np.ndarray, way: np.ndarray, look: Look = None
) -> ShotOutcomes:
    """Hold the ball for LOOK seconds, kick it, and return the outcomes of the shots."""
    rate, count = match.league.control_rate, match.count
    for _ in range(round(LOOK * rate)):
        put_ball(match, *place)
        match.rebuild()
        match.step()
    put_ball(match, *place, speed * np.cos(way), speed * np.sin(way), rolls=False)
    match.rebuild()
    start = match.robots["x"][:, 0].copy(), match.robots["y"][:, 0].copy()
    ball_radius = match.league.ball.radius
    level = match.league.body.disc_radius + ball_radius
    goal, open_, moved, square = np.zeros(count, bool), np.ones(count, bool), np.zeros(count), []
    for _ in range(round(SECONDS * rate)):
        match.step()
        if look is not None:
            look(match)
        keeper, ball = match.robots[:, 0], match.balls
        goal |= match.matches["score"][:, 1] > 0
        error = ball_error(match)
        square.append(np.where(open_, error * error, np.nan))
        far = np.hypot(keeper["x"] - start[0], keeper["y"] - start[1])
        moved = np.where(open_ & (ball["x"] - keeper["x"] > level), np.maximum(moved, far), moved)
        stopped = goal | (ball["vx"] > -SLOW) | (ball["x"] < -match.league.pitch.length / 2 - ball_radius)
        open_ &= ~stopped & (ball["x"] > keeper["x"])
        if stopped.all():
            break
    match.close()
    seen = np.sqrt(np.nanmean(np.array(square), axis=0))
    return ShotOutcomes(speed, goal, moved, seen)


def ball_error(match: Match) -> np.ndarray:
    """Return the error (M,) [m] of the goalkeeper's believed ball, relative to its own true pose."""
    keeper, believed, ball = match.robots[:, 0], match.beliefs["ball"][:, 0], match.balls
    cosine, sine = np.cos(keeper["heading"]), np.sin(keeper["heading"])
    x = keeper["x"] + cosine * believed["x"] - sine * believed["y"]
    y = keeper["y"] + sine * believed["x"] + cosine * believed["y"]
    return np.asarray(np.hypot(ball["x"] - x, ball["y"] - y))
