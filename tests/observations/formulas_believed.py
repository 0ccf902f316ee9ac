"""Every entry of what is believed and sensed by name, written anew from the records of beliefs and percepts."""

from typing import Any

import numpy as np

from soccer_env import Match
from soccer_env.types import Phase
from tests.observations import formulas
from tests.observations.formulas import Numbers, body_of, clipped, diagonal_of, facing, own_of, parts, point, soft

# Beliefs


def belief_of(match: Match, m: int, r: int) -> Numbers:
    """Return what robot r of match m observes of its own belief."""
    belief, me = match.beliefs[m, r], match.robots[m, r]
    own, ball, situation, obstacle = (belief[name] for name in ("own", "ball", "situation", "obstacle"))
    near, slow = diagonal_of(match) / 10.0, match.league.ball.top_speed / 10.0
    raw = ball["distance"] * np.exp(1j * ball["bearing"])
    told = {
        **own_of(match, point(own), own["heading"], point(own, "forward", "left"), own["turn"]),
        **body_of(match, m, r), **situation_of(match, situation),
        **formulas.goals_of(match, point(own), own["heading"]),
        **formulas.ball_of(match, point(ball), point(ball, "vx", "vy")),
        "own_confidence": own["confidence"] / 100.0, "has_ball": float(ball["held"]),
        "upright": -1.0 if me["fallen"] > 0.0 else 1.0, "active": 2.0 * situation["active"] - 1.0,
        "keeper": 2.0 * situation["keeper"] - 1.0,
        "ball_raw_x": soft(raw.real, near), "ball_raw_y": soft(raw.imag, near),
        "ball_radial": soft(ball["radial"], slow), "ball_angular": soft(ball["angular"], 1.0),
        "ball_confidence": ball["confidence"] / 100.0,
        "ball_age": aged(ball["age"]), **formulas.clocks_of(me, "own_"),
        "own_penalty": soft(situation["penalty"], 10.0), "own_barred": float(formulas.is_barred(match, m, r)),
        "ball_still": soft(match.matches["still_clock"][m], 10.0),
    }  # fmt: skip
    if "infrared_far" in match.league.sensors.record().dtype.names:
        there = 1.0 if obstacle["distance"] > 0.0 else 0.0
        told["obstacle_near"] = there * near / (obstacle["distance"] + near)
        told |= {name: there * value for name, value in facing("obstacle_", float(obstacle["bearing"])).items()}
    slots = match.league.slots
    names = [f"teammate_{i}" for i in range(slots.teammates)] + [f"opponent_{i}" for i in range(slots.opponents)]
    home = match.robots["team"][m, r] == 0
    mine, theirs = (match.settings.home, match.settings.away)[:: 1 if home else -1]
    others = {"teammate": mine - 1, "opponent": theirs}  # a robot knows how many play: ghosts beyond them are left out
    for name, track in zip(names, match.tracks[m, r], strict=True):
        kind, number = name.split("_")
        told |= track_of(match, name, track, int(number) < others[kind])
    return told


def situation_of(match: Match, told: Any) -> Numbers:
    """Return how the match stands, as a robot was told."""
    half = match.settings.half_length
    return {
        "in_play": 1.0 if told["phase"] == Phase.PLAY else -1.0, "placing": float(told["placing"]),
        "restart": told["ours"], "score": soft(float(told["goals_for"]) - float(told["goals_against"]), 2.0),
        "time_left": 1.0 if np.isinf(half) else min(max(told["seconds_left"] / (2.0 * half), 0.0), 1.0),
    }  # fmt: skip


def track_of(match: Match, name: str, track: Any, exists: bool) -> Numbers:
    """Return what is believed of another player; all 0 where the slot is empty, or for one too many."""
    told = {
        "present": 1.0, **parts("", point(track), diagonal_of(match)), **facing("", track["heading"]),
        **parts("v", point(track, "vx", "vy"), match.league.drive.forward),
        "confidence": track["confidence"] / 100.0, "age": aged(track["age"]),
    }  # fmt: skip
    return {f"{name}_{key}": value * float(exists and track["present"] == 1) for key, value in told.items()}


def aged(age: float) -> float:
    return 1.0 if np.isinf(age) else age / (age + 1.0)


# Percepts


def percepts_of(match: Match, m: int, r: int) -> Numbers:
    """Return what robot r of match m observes of its percept of this frame."""
    percept, drive, dt = match.percepts[m, r], match.league.drive, 1.0 / match.league.control_rate
    body = percept["body"]
    known = float(body["pose"] > 0)
    pose = own_of(match, point(body), float(body["heading"]), 0j, 0.0)
    told = {
        "pose_known": known, **{f"own_{name}": known * pose[f"own_{name}"] for name in ("x", "y", "cos", "sin")},
        "odometry_forward": clipped(body["forward"] / (drive.forward * dt)),
        "odometry_left": clipped(body["left"] / (drive.forward * dt)),
        "odometry_turn": clipped(body["turn"] / (drive.turn * dt)),
        **body_of(match, m, r), "held": float(body["held"]), "upright": 2.0 * body["upright"] - 1.0,
        "active": 2.0 * body["active"] - 1.0, **situation_of(match, match.beliefs[m, r]["situation"]),
    }  # fmt: skip
    return told | (legged_sight(match, percept) if match.league.body.legs else omni_sight(match, percept))


def legged_sight(match: Match, percept: Any) -> Numbers:
    """Return ranger, switches and blobs."""
    sensors = match.league.sensors
    width, height = map(int, sensors.resolution.split("x"))  # [px]
    told = {
        "infrared_valid": float(percept["infrared"] > 0.0),
        "infrared": clipped(percept["infrared"] / sensors.infrared_far),
        **{f"touch_{name}": float(percept["touch"][name]) for name in ("head", "chin", "back")},
        "touch_feet": percept["touch"]["feet"] / 4.0,
    }  # fmt: skip
    for colour in ("ball", "teammates", "opponents", "own_goal", "opponent_goal", "landmarks"):
        for i, blob in enumerate(percept[colour]):
            left, right, high, low = (float(blob[name]) for name in ("left", "right", "high", "low"))
            numbers = {
                "seen": 1.0, "x": (left + right) / width, "y": (high + low) / height,
                "width": (left - right) / width, "height": (high - low) / height,
            }  # fmt: skip
            told |= {f"{colour}_{i}_{name}": value * float(blob["area"] > 0) for name, value in numbers.items()}
    return told


def omni_sight(match: Match, percept: Any) -> Numbers:
    """Return what the mirror shows, and white lines."""
    slots, sensors = match.league.slots, match.league.sensors
    players = {f"player_{i}": percept["players"][i] for i in range(slots.teammates + slots.opponents)}
    told: Numbers = {}
    for name, thing in {**{n: percept[n] for n in ("ball", "own_goal", "opponent_goal")}, **players}.items():
        numbers = {"seen": 1.0, **facing("", float(thing["bearing"])), "near": 2.0 / (thing["distance"] + 2.0)}
        if name in players:
            numbers["teammate"] = 1.0 if thing["teammate"] == 1 else -1.0
        told |= {f"{name}_{key}": value * float(thing["seen"] == 1) for key, value in numbers.items()}
    for i, distance in enumerate(percept["lines"][: sensors.lines].tolist()):
        told[f"line_{i}"] = min(distance / sensors.line_range, 1.0) if distance > 0.0 else 1.0
    return told
