"""`state()`: the whole truth of a match as one vector, for centralised critics; every entry is named."""

from __future__ import annotations

from typing import Any

import numpy as np

from soccer_env.types import HOME, Phase

Match = Any  # soccer_env.match.Match, which stands above this file

GAME = ("clock", "half", "phase", "placing", "restart_home", "home_direction", "goals_home", "goals_away")
BALL = ("ball_x", "ball_y", "ball_vx", "ball_vy", "ball_roll_x", "ball_roll_y")
ROBOT = (
    "present",
    "keeper",
    "x",
    "y",
    "cos",
    "sin",
    "vx",
    "vy",
    "omega",
    "walk_forward",
    "walk_left",
    "walk_turn",
    "gait_phase",
    "pan",
    "tilt",
    "kick",
    "has_ball",
    "fallen",
)
SECONDS = 60.0  # [s] half-way point of the soft scale for clocks without an end, assumed


def names(match: Match) -> list[str]:
    """Return the name of each entry of the state vector."""
    sides = [f"{side}_{number}" for side in ("home", "away") for number in range(match.settings.max_players)]
    return [*GAME, *BALL, *(f"{side}_{name}" for side in sides for name in ROBOT)]


def write(match: Match) -> np.ndarray:
    """Return (M, n) float32 in [-1, 1]: game, ball, then max_players rows for home and for away.

    Absent players are zeros.
    """
    players = match.settings.max_players
    players_of_both = np.zeros((match.count, 2, players, len(ROBOT)))
    home_rows = match.settings.rows[HOME]
    numbers = robot_numbers(match)
    players_of_both[:, 0, :home_rows] = numbers[:, :home_rows]
    players_of_both[:, 1, : numbers.shape[1] - home_rows] = numbers[:, home_rows:]
    parts = [game_numbers(match), ball_numbers(match), players_of_both.reshape(match.count, -1)]
    state: np.ndarray = np.clip(np.concatenate(parts, axis=1), -1.0, 1.0).astype(np.float32)
    return state


def game_numbers(match: Match) -> np.ndarray:
    """Return (M, 8) numbers of the game."""
    game = match.matches
    half = game["half_length"]
    share = np.where(np.isfinite(half), game["clock"] / half, game["clock"] / (game["clock"] + SECONDS))
    side = np.select([game["restart_team"] == 0, game["restart_team"] == 1], [1.0, -1.0], 0.0)
    score = game["score"] / (game["score"] + 2.0)
    return np.stack(
        [
            share,
            game["half"],
            game["phase"] / max(Phase),
            game["placing"],
            side,
            game["home_direction"],
            score[:, 0],
            score[:, 1],
        ],
        axis=1,
    )


def ball_numbers(match: Match) -> np.ndarray:
    """Return (M, 6) numbers of the ball."""
    pitch, ball, top = match.league.pitch, match.balls, match.league.ball.top_speed
    length = pitch.length / 2 + pitch.goal_depth
    width = pitch.width / 2 + pitch.band_side
    return np.stack(
        [
            ball["x"] / length,
            ball["y"] / width,
            ball["vx"] / top,
            ball["vy"] / top,
            ball["roll_x"] / top,
            ball["roll_y"] / top,
        ],
        axis=1,
    )


def robot_numbers(match: Match) -> np.ndarray:
    """Return (M, R, 18) numbers of the robots; zeros for inactive ones."""
    pitch, drive, robots = match.league.pitch, match.league.drive, match.robots
    walk, heading, active = robots["walk"], robots["heading"], robots["active"].astype(float)
    kick = np.where(robots["kick_clock"] > 0.0, 1.0, np.where(robots["kick_clock"] < 0.0, -1.0, 0.0))
    columns = [
        active,
        robots["keeper"],
        robots["x"] / (pitch.length / 2 + pitch.goal_depth),
        robots["y"] / (pitch.width / 2 + pitch.band_side),
        np.cos(heading),
        np.sin(heading),
        robots["vx"] / drive.forward,
        robots["vy"] / drive.forward,
        robots["omega"] / drive.turn,
        walk["forward"] / drive.forward,
        walk["left"] / drive.forward,
        walk["turn"] / drive.turn,
        robots["gait_phase"] / max(drive.gait_steps, 1),
        robots["pan"] / np.pi,
        robots["tilt"] / np.pi,
        kick,
        robots["has_ball"],
        robots["fallen"] > 0.0,
    ]
    return np.stack([np.asarray(column, float) * active for column in columns], axis=-1)
