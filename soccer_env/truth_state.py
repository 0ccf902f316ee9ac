"""`state()`: the whole truth of a match as one vector, for centralised critics; every entry is named."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from soccer_env.observations.entry import FIELD, NONE, ROBOT, TURN, Entry, X, Y, of_group
from soccer_env.types import HOME, Phase

Match = Any  # soccer_env.match.Match, which stands above this file

GAME = of_group(
    "game",
    Entry("clock", "play in this half", "the half; without an end soft: t / (t + 60 s)", NONE),
    Entry("half", "0 first half, 1 second half", "1", NONE),
    Entry("phase", "number of the phase of play, see `types.Phase`", "the last phase", NONE),
    Entry("placing", "1 while robots are driven to their places", "1", NONE),
    Entry("restart_home", "1 home's restart, -1 away's, 0 neither", "1", NONE),
    Entry("home_direction", "1: home attacks +x, -1: home attacks -x", "1", FIELD, X),
    Entry("goals_home", "goals of home", "soft: g / (g + 2)", NONE),
    Entry("goals_away", "goals of away", "soft: g / (g + 2)", NONE),
)
BALL = of_group(
    "ball",
    Entry("ball_x", "place along the field", "half length plus goal depth", FIELD, X),
    Entry("ball_y", "place across the field", "half width plus band", FIELD, Y),
    Entry("ball_vx", "speed along the field", "its top speed", FIELD, X),
    Entry("ball_vy", "speed across the field", "its top speed", FIELD, Y),
    Entry("ball_roll_x", "speed of rolling without sliding, along the field", "its top speed", FIELD, X),
    Entry("ball_roll_y", "speed of rolling without sliding, across the field", "its top speed", FIELD, Y),
)
PLAYER = (
    Entry("present", "1: there is such a player on the field; else all its entries are 0", "1", NONE, present=True),
    Entry("keeper", "1 goalkeeper, 0 field player", "1", NONE),
    Entry("x", "place along the field", "half length plus goal depth", FIELD, X),
    Entry("y", "place across the field", "half width plus band", FIELD, Y),
    Entry("cos", "cosine of its heading", "1", FIELD, X),
    Entry("sin", "sine of its heading", "1", FIELD, Y),
    Entry("vx", "speed along the field", "top speed ahead", FIELD, X),
    Entry("vy", "speed across the field", "top speed ahead", FIELD, Y),
    Entry("omega", "turn rate", "top turn rate", FIELD, TURN),
    Entry("walk_forward", "walk of legs or wheels, ahead", "top speed ahead", ROBOT, X),
    Entry("walk_left", "walk of legs or wheels, to the left", "top speed ahead", ROBOT, Y),
    Entry("walk_turn", "walk of legs or wheels, turn rate", "top turn rate", ROBOT, TURN),
    Entry("gait_phase", "control steps since the gait step began", "those of a gait step", NONE),
    Entry("pan", "head pan", "pi", ROBOT, TURN),
    Entry("tilt", "head tilt", "pi", ROBOT),
    Entry("kick", "0 ready, 1 winding up, -1 recharging", "1", NONE),
    Entry("has_ball", "1: the ball lies in the pocket or at the kicker", "1", NONE),
    Entry("fallen", "1 fallen, 0 upright", "1", NONE),
)
SECONDS = 60.0  # [s] half-way point of the soft scale for clocks without an end, assumed


def entries(players: int) -> list[Entry]:
    """Return the entries of the state vector with room for `players` a side, in order."""
    robots = [
        replace(entry, name=f"{side}_{number}_{entry.name}", group=side, slot=number)
        for side in ("home", "away")
        for number in range(players)
        for entry in PLAYER
    ]
    return [*GAME, *BALL, *robots]


def write(match: Match) -> np.ndarray:
    """Return (M, n) float32 in [-1, 1]: match, ball, then max_players rows for home and for away.

    Absent players are zeros.
    """
    players = match.settings.max_players
    players_of_both = np.zeros((match.count, 2, players, len(PLAYER)))
    home_rows = match.settings.rows[HOME]
    numbers = in_order(PLAYER, robot_numbers(match))
    players_of_both[:, 0, :home_rows] = numbers[:, :home_rows]
    players_of_both[:, 1, : numbers.shape[1] - home_rows] = numbers[:, home_rows:]
    game, ball = in_order(GAME, game_numbers(match)), in_order(BALL, ball_numbers(match))
    parts = [game, ball, players_of_both.reshape(match.count, -1)]
    state: np.ndarray = np.clip(np.concatenate(parts, axis=1), -1.0, 1.0).astype(np.float32)
    return state


def in_order(entries: Sequence[Entry], numbers: Mapping[str, Any]) -> np.ndarray:
    """Return numbers (...) by name as one array (..., n) in the order of the entries."""
    return np.stack([np.asarray(numbers[entry.name], float) for entry in entries], axis=-1)


def game_numbers(match: Match) -> dict[str, Any]:
    """Return the numbers (M,) of the game."""
    game = match.matches
    half = game["half_length"]
    score = game["score"] / (game["score"] + 2.0)
    return {
        "clock": np.where(np.isfinite(half), game["clock"] / half, game["clock"] / (game["clock"] + SECONDS)),
        "half": game["half"],
        "phase": game["phase"] / max(Phase),
        "placing": game["placing"],
        "restart_home": np.select([game["restart_team"] == 0, game["restart_team"] == 1], [1.0, -1.0], 0.0),
        "home_direction": game["home_direction"],
        "goals_home": score[:, 0],
        "goals_away": score[:, 1],
    }


def ball_numbers(match: Match) -> dict[str, Any]:
    """Return the numbers (M,) of the ball."""
    pitch = match.league.pitch
    ball = match.balls
    top = match.league.ball.top_speed
    return {
        "ball_x": ball["x"] / (pitch.length / 2 + pitch.goal_depth),
        "ball_y": ball["y"] / (pitch.width / 2 + pitch.band_side),
        "ball_vx": ball["vx"] / top,
        "ball_vy": ball["vy"] / top,
        "ball_roll_x": ball["roll_x"] / top,
        "ball_roll_y": ball["roll_y"] / top,
    }


def robot_numbers(match: Match) -> dict[str, Any]:
    """Return the numbers (M, R) of the robots; zeros for inactive ones."""
    pitch = match.league.pitch
    drive = match.league.drive
    robots = match.robots
    walk = robots["walk"]
    heading = robots["heading"]
    active = robots["active"].astype(float)
    numbers = {
        "present": active,
        "keeper": robots["keeper"],
        "x": robots["x"] / (pitch.length / 2 + pitch.goal_depth),
        "y": robots["y"] / (pitch.width / 2 + pitch.band_side),
        "cos": np.cos(heading),
        "sin": np.sin(heading),
        "vx": robots["vx"] / drive.forward,
        "vy": robots["vy"] / drive.forward,
        "omega": robots["omega"] / drive.turn,
        "walk_forward": walk["forward"] / drive.forward,
        "walk_left": walk["left"] / drive.forward,
        "walk_turn": walk["turn"] / drive.turn,
        "gait_phase": robots["gait_phase"] / max(drive.gait_steps, 1),
        "pan": robots["pan"] / np.pi,
        "tilt": robots["tilt"] / np.pi,
        "kick": np.where(robots["kick_clock"] > 0.0, 1.0, np.where(robots["kick_clock"] < 0.0, -1.0, 0.0)),
        "has_ball": robots["has_ball"],
        "fallen": robots["fallen"] > 0.0,
    }
    return {name: np.asarray(column, float) * active for name, column in numbers.items()}
