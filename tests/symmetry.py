"""Mirror a match left-right, or turn it half round with the teams swapped, and compare two matches."""

import numpy as np

from soccer_env import Match

SWAPPED_TEAMS = ("restart_team", "kick_off_team", "last_touch_team")  # fields that hold HOME, AWAY or NO_TEAM
LATERAL = ("y", "vy", "heading", "omega", "place_y", "place_heading", "pan")  # of a robot, odd under the mirror
WALKS = ("target", "walk")


def mirror(match: Match) -> None:
    """Mirror everything in a match left-right; noise draws are mirrored from then on."""
    for field in ("y", "vy", "roll_y", "angle", "spin"):
        match.balls[field] *= -1.0
    for field in LATERAL:
        match.robots[field] *= -1.0
    for field in (*WALKS, "delayed", "command"):
        for part in ("left", "turn", *(("pan",) if field == "command" else ())):
            match.robots[field][part] *= -1.0
    for field in ("restart_y", "still_y"):
        match.matches[field] *= -1.0
    match.matches["handedness"] *= -1.0
    match.reseat()


def turn(match: Match) -> None:
    """Turn a match of equal teams half round and swap the names of the teams; home still attacks the same way."""
    half = len(match.agents) // 2
    order = np.r_[half : 2 * half, 0:half]
    for field in ("x", "y", "vx", "vy", "roll_x", "roll_y"):
        match.balls[field] *= -1.0
    match.balls["angle"] = wrapped(match.balls["angle"] + np.pi)
    match.robots[:] = match.robots[:, order]
    match.robots["team"] = 1 - match.robots["team"]
    for field in ("x", "y", "vx", "vy", "place_x", "place_y"):
        match.robots[field] *= -1.0
    for field in ("heading", "place_heading"):
        match.robots[field] = wrapped(match.robots[field] + np.pi)
    for field in ("restart_x", "restart_y", "still_x", "still_y"):
        match.matches[field] *= -1.0
    for field in SWAPPED_TEAMS:
        match.matches[field] = np.where(match.matches[field] >= 0, 1 - match.matches[field], -1)
    last = match.matches["last_touch_robot"]
    match.matches["last_touch_robot"] = np.where(last >= 0, (last + half) % (2 * half), -1)
    match.matches["score"] = match.matches["score"][:, ::-1]
    match.reseat()


def wrapped(angle: np.ndarray) -> np.ndarray:
    """Return angles in (-pi, pi]."""
    return np.pi - (np.pi - angle) % (2.0 * np.pi)


def differences(one: np.ndarray, two: np.ndarray, prefix: str = "") -> dict[str, float]:
    """Return the largest difference of each number of two record arrays; angles are compared round the circle."""
    found = {}
    for name in one.dtype.names or ():
        a, b = one[name], two[name]
        if a.dtype.names:
            found |= differences(a, b, f"{prefix}{name}.")
        elif name not in ("noise", "handedness", "seed", "ball_x", "ball_y"):
            with np.errstate(invalid="ignore"):
                gap = np.abs(np.nan_to_num(a - b, posinf=0.0, neginf=0.0))
            if name in ("heading", "angle", "place_heading"):
                gap = np.abs(wrapped(gap))
            found[prefix + name] = float(gap.max()) if gap.size else 0.0
    return found


def assert_same(one: Match, two: Match, tolerance: float) -> None:
    """Compare all records of two matches."""
    for name in ("matches", "balls", "robots", "events", "robot_events"):
        gaps = differences(getattr(one, name), getattr(two, name))
        worst = max(gaps, key=lambda field: gaps[field])
        assert gaps[worst] <= tolerance, f"{name}: {worst} differs by {gaps[worst]}"
