"""Runs of the legged dribbling drills: who plays them, how they end."""

from __future__ import annotations

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.match_settings import Senses
from soccer_env.scenes import Scene, find_scene
from soccer_env.scenes.judging import LOST, LOST_TIME, PAST
from soccer_env.teams import make_team
from soccer_env.train.reproduce.claim import Batch
from soccer_env.train.reproduce.dribble_runs import NO_SHOTS, start_dribbling
from soccer_env.train.reproduce.staging import LEGGED
from soccer_env.train.reproduce.verdicts import Samples
from soccer_env.types import HOME

TOP = 0.12  # [m/s] of a walker at strength 1: the top speed ahead of the legged league
PAPER = 0.06  # [m/s] of movers in the drills
LONGEST = 40.0  # [s] of a run


def start_drill(
    batch: Batch, scene: str | Scene, settings: dict[str, Any], matches: int, mover: float, senses: Senses = "sensors"
) -> Match:
    """Return matches at the start of a drill's scene, with nobody to end them; movers walk at a speed [m/s]."""
    found = find_scene(scene)
    sides: dict[str, Any] = {"home": make_team("sacks-2001", **settings)}
    for row, name in enumerate(found.opponents):
        sides[f"away_{row}"] = "still" if name == "still" else f"walker@{mover / TOP:g}"
    match = Match(
        LEGGED, home=1, away=len(found.opponents), matches=matches, seeds=batch.seeds(matches), threads=batch.threads,
        scene=found, senses=senses, pose=batch.pose, controllers=sides,
    )  # fmt: skip
    start_dribbling(match)
    return match


def gap_to_others(match: Match) -> np.ndarray:
    """Return the distance (M,) [m] from robot 0 to the nearest other robot, between the middles of their bodies."""
    robot, others = match.robots[:, :1], match.robots[:, 1:]
    gap: np.ndarray = np.hypot(others["x"] - robot["x"], others["y"] - robot["y"]).min(axis=1)
    return gap


def play_drill(
    batch: Batch,
    scene: str | Scene,
    settings: dict[str, Any],
    matches: int,
    mover: float = PAPER,
    senses: Senses = "sensors",
) -> Samples:
    """Let sacks-2001, with settings by name and without shots, play a drill's scene; arrays (M,).

    As the drill judges, but a touch ends nothing: "past": beyond everybody with the ball, or in the goal; "clean": that
    without a touch; "touched" before the end; "lost": the ball was far for a while. "seconds" until then; "nearest" [m]
    that the middles of bodies came.
    """
    match = start_drill(batch, scene, NO_SHOTS | settings, matches, mover, senses)
    past, touched, lost = np.zeros((3, matches), bool)
    away = np.zeros(matches)
    seconds = np.zeros(matches)
    nearest = np.full(matches, np.inf)
    for _ in range(round(LONGEST * match.league.control_rate)):
        running = ~(past | lost)
        if not running.any():
            break
        match.step()
        robot, ball = match.robots[:, 0], match.balls
        touched |= running & (match.robot_events["collision"][:, 0] == 1)
        beyond = ball["x"] > match.robots["x"][:, 1:].max(axis=1) + PAST
        past |= running & ((beyond & (robot["has_ball"] == 1)) | (match.events["goal"] == HOME))
        near = np.hypot(ball["x"] - robot["x"], ball["y"] - robot["y"]) <= LOST
        away = np.where(near, 0.0, away + match.league.dt)
        lost |= running & ~past & (away > LOST_TIME)
        seconds += running * match.league.dt
        nearest = np.where(running, np.minimum(nearest, gap_to_others(match)), nearest)
    match.close()
    found = {
        "past": past,
        "clean": past & ~touched,
        "touched": touched,
        "lost": lost,
        "seconds": seconds,
        "nearest": nearest,
    }
    return {name: values.astype(float) for name, values in found.items()}
