"""Every entry of the truth and of `state()` by name, written anew from the records with complex numbers.

A place of the field is x + iy; seen from a robot it is (place - own place) exp(-i heading): ahead + i left.
"""

from math import cos, hypot, pi, sin
from typing import Any

import numpy as np

from soccer_env import Match
from soccer_env.types import Phase

Numbers = dict[str, float]


def soft(value: float, half: float) -> float:
    """Return a value on a scale that never ends at 1: `half` gives one half."""
    return value / (abs(value) + half)


def clipped(value: float) -> float:
    return min(max(value, -1.0), 1.0)


def point(record: Any, x: str = "x", y: str = "y") -> complex:
    return complex(record[x], record[y])


def parts(name: str, value: complex, scale: float = 1.0) -> Numbers:
    """Return what lies ahead and to the left, on a scale."""
    return {f"{name}x": clipped(value.real / scale), f"{name}y": clipped(value.imag / scale)}


def facing(name: str, angle: float) -> Numbers:
    return {f"{name}cos": cos(angle), f"{name}sin": sin(angle)}


def diagonal_of(match: Match) -> float:
    return hypot(match.league.pitch.length, match.league.pitch.width)


def side_of(match: Match, m: int, r: int) -> float:
    """Return +1 for a robot whose team attacks +x now, else -1."""
    return float(match.matches["home_direction"][m]) * (1.0 if r < match.settings.home else -1.0)


def clocks_of(robot: Any, name: str) -> Numbers:
    """Return what the referee counts of a robot; each league counts kinds of pushing and holding of its own."""
    pushing = max(robot["pushing"], robot["keeper_pushing"], robot["charging"])
    holding = max(robot["holding"], robot["handling"])
    trespass = max(robot["trespass"], robot["area_clock"], robot["crowd_clock"])
    return {
        f"{name}pushing": soft(pushing, 1.0), f"{name}holding": soft(holding, 1.0),
        f"{name}trespass": soft(trespass, 1.0),
        f"{name}penalty": soft(robot["penalty"], 10.0), f"{name}card": float(robot["yellow"] % 2),
    }  # fmt: skip


def is_barred(match: Match, m: int, r: int) -> bool:
    """Tell whether a robot has taken the restart, and nobody else has touched the ball since."""
    game = match.matches[m]
    return bool(game["taker"] == r and game["phase"] == Phase.PLAY)


# What every observation has


def body_of(match: Match, m: int, r: int) -> Numbers:
    """Return gait, head, kicker, goalkeeper and the last command."""
    me, steps = match.robots[m, r], match.league.drive.gait_steps
    angle = 2.0 * pi * me["gait_phase"] / steps
    gait = {"gait_cos": cos(angle), "gait_sin": sin(angle)} if steps > 1 else {"gait_cos": 0.0, "gait_sin": 0.0}
    clock = me["kick_clock"]
    return {
        **gait, "pan": me["pan"] / pi, "tilt": me["tilt"] / (pi / 2.0),
        "kick_ready": 1.0 if clock == 0.0 else -1.0 if clock < 0.0 else 0.0,
        "keeper": 1.0 if me["keeper"] == 1 else -1.0,
        **{f"last_{name}": me["command"][name] for name in ("forward", "left", "turn", "kick")},
    }  # fmt: skip


def goals_of(match: Match, place: complex, heading: float) -> Numbers:
    """Return where both goals lie, from a pose in the team frame."""
    goal, turn = match.league.pitch.length / 2.0, np.exp(-1j * heading)
    own, other = ((sign * goal - place) * turn for sign in (-1.0, 1.0))
    return parts("goal_", other, diagonal_of(match)) | parts("own_goal_", own, diagonal_of(match))


def ball_of(match: Match, place: complex, velocity: complex) -> Numbers:
    """Return where the ball lies and goes, robot frame."""
    diagonal, slow = diagonal_of(match), match.league.ball.top_speed / 10.0
    near = diagonal / 10.0
    return {
        **parts("ball_", place, diagonal), **facing("ball_", np.angle(place)),
        "ball_near_x": soft(place.real, near), "ball_near_y": soft(place.imag, near),
        "ball_near": near / (abs(place) + near),
        "ball_vx": soft(velocity.real, slow), "ball_vy": soft(velocity.imag, slow),
    }  # fmt: skip


def own_of(match: Match, place: complex, heading: float, velocity: complex, turn: float) -> Numbers:
    """Return the own pose, team frame, and the own speed, robot frame."""
    pitch, drive = match.league.pitch, match.league.drive
    return {
        "own_x": clipped(place.real / (pitch.length / 2.0 + pitch.goal_depth)),
        "own_y": clipped(place.imag / (pitch.width / 2.0 + pitch.band_side)), **facing("own_", heading),
        "own_forward": clipped(velocity.real / drive.forward), "own_left": clipped(velocity.imag / drive.forward),
        "own_turn": clipped(turn / drive.turn),
    }  # fmt: skip


def game_of(match: Match, m: int, r: int) -> Numbers:
    """Return how the match stands for the team of a robot."""
    game, team = match.matches[m], int(r >= match.settings.home)
    ours, theirs = game["score"][team], game["score"][1 - team]
    left = game["half_length"] - game["clock"] + (game["half_length"] if game["half"] == 0 else 0.0)
    return {
        "in_play": 1.0 if game["phase"] == Phase.PLAY else -1.0, "placing": float(game["placing"]),
        "restart": {team: 1.0, 1 - team: -1.0, -1: 0.0}[int(game["restart_team"])],
        "time_left": 1.0 if np.isinf(left) else left / (2.0 * game["half_length"]),
        "score": soft(float(ours - theirs), 2.0),
    }  # fmt: skip


# Truth


def truth_of(match: Match, m: int, r: int) -> Numbers:
    """Return what robot r of match m sees of the truth."""
    me, ball, drive = match.robots[m, r], match.balls[m], match.league.drive
    here, turn = point(me), np.exp(-1j * me["heading"])
    side = side_of(match, m, r)
    heading = me["heading"] + (0.0 if side > 0.0 else pi)
    told = {
        **own_of(match, side * here, heading, point(me, "vx", "vy") * turn, me["omega"]),
        **body_of(match, m, r), **game_of(match, m, r), **goals_of(match, side * here, heading),
        **ball_of(match, (point(ball) - here) * turn, point(ball, "vx", "vy") * turn),
        "has_ball": float(me["has_ball"]), "upright": -1.0 if me["fallen"] > 0.0 else 1.0,
        "active": 1.0 if me["active"] == 1 else -1.0,
    }  # fmt: skip
    for slot, other in others_of(match, m, r).items():
        if other is None:
            told |= dict.fromkeys([f"{slot}_{name}" for name in ("present", "x", "y", "vx", "vy", "cos", "sin")], 0.0)
            continue
        told |= {f"{slot}_present": 1.0, **facing(f"{slot}_", other["heading"] - me["heading"])}
        told |= parts(f"{slot}_", (point(other) - here) * turn, diagonal_of(match))
        told |= parts(f"{slot}_v", point(other, "vx", "vy") * turn, drive.forward)
    return told


def rates_of(match: Match, m: int, r: int) -> Numbers:
    """Return what an ideal belief tells of the ball besides: how its distance and its bearing change."""
    me, ball, slow = match.robots[m, r], match.balls[m], match.league.ball.top_speed / 10.0
    place = (point(ball) - point(me)) * np.exp(-1j * me["heading"])
    nears = (point(ball, "vx", "vy") - point(me, "vx", "vy")) * np.exp(-1j * me["heading"])
    change = nears / place  # d log(place) / dt: that of log(distance), and i times that of the bearing
    near = diagonal_of(match) / 10.0
    return {
        "ball_raw_x": soft(place.real, near), "ball_raw_y": soft(place.imag, near),
        "ball_radial": soft(abs(place) * change.real, slow), "ball_angular": soft(change.imag - me["omega"], 1.0),
    }  # fmt: skip


def others_of(match: Match, m: int, r: int) -> dict[str, Any]:
    """Return who fills each slot: the nearest active ones first; None for an empty one."""
    robots, slots, home = match.robots[m], match.league.slots, match.settings.home
    found: dict[str, Any] = {}
    for kind, mates, room in (("teammate", True, slots.teammates), ("opponent", False, slots.opponents)):
        those = [o for o in range(len(robots)) if o != r and robots["active"][o] == 1]
        those = [o for o in those if ((o < home) == (r < home)) == mates]
        those.sort(key=lambda o: abs(point(robots[o]) - point(robots[r])))
        found |= {f"{kind}_{i}": robots[those[i]] if i < len(those) else None for i in range(room)}
    return found


# state()


def state_of(match: Match, m: int, side: str, players: int) -> Numbers:
    """Return the state of match m with room for `players` a side, in the field's frame or from a team's side."""
    game, ball, league = match.matches[m], match.balls[m], match.league
    first = int(side == "away")  # whose numbers come first
    half_turn = 1.0 if side == "field" else side_of(match, m, match.settings.home if first else 0)
    names = ("home", "away") if side == "field" else ("own", "other")
    ends = ("goals_home", "goals_away") if side == "field" else ("goals_own", "goals_other")
    length = game["half_length"]
    told = {
        "clock": game["clock"] / length if np.isfinite(length) else soft(game["clock"], 60.0),
        "half": float(game["half"]), "phase": game["phase"] / 8.0, "placing": float(game["placing"]),
        f"restart_{names[0]}": {first: 1.0, 1 - first: -1.0, -1: 0.0}[int(game["restart_team"])],
        "home_direction" if side == "field" else "own_direction": game["home_direction"] if side == "field" else 1.0,
        ends[0]: soft(float(game["score"][first]), 2.0), ends[1]: soft(float(game["score"][1 - first]), 2.0),
        **on_field(match, "ball_", half_turn * point(ball)),
        **parts("ball_v", half_turn * point(ball, "vx", "vy"), league.ball.top_speed),
        **parts("ball_roll_", half_turn * point(ball, "roll_x", "roll_y"), league.ball.top_speed),
        "ball_still": soft(game["still_clock"], 10.0),
    }  # fmt: skip
    home = match.settings.home
    teams = [match.robots[m, :home], match.robots[m, home:]]
    for name, robots in zip(names, teams[::-1] if first else teams, strict=True):
        for number in range(players):
            there = number < len(robots) and robots["active"][number] == 1
            numbers = player_of(match, robots[number if there else 0], half_turn)
            numbers["barred"] = float(is_barred(match, m, number + (0 if robots is teams[0] else home)))
            told |= {f"{name}_{number}_{key}": value * float(there) for key, value in numbers.items()}
            out = robots[number]["penalty"] if number < len(robots) else 0.0
            told[f"{name}_{number}_penalty"] = soft(out, 10.0)
    return told


def on_field(match: Match, name: str, place: complex) -> Numbers:
    """Return a place on the scales of the field."""
    pitch = match.league.pitch
    x, y = place.real / (pitch.length / 2.0 + pitch.goal_depth), place.imag / (pitch.width / 2.0 + pitch.band_side)
    return {f"{name}x": clipped(x), f"{name}y": clipped(y)}


def player_of(match: Match, robot: Any, half_turn: float) -> Numbers:
    """Return what the state tells of a robot on the field."""
    drive, walk, clock = match.league.drive, robot["walk"], robot["kick_clock"]
    return {
        "present": 1.0, "keeper": float(robot["keeper"]), **on_field(match, "", half_turn * point(robot)),
        "cos": half_turn * cos(robot["heading"]), "sin": half_turn * sin(robot["heading"]),
        **parts("v", half_turn * point(robot, "vx", "vy"), drive.forward),
        "omega": clipped(robot["omega"] / drive.turn),
        "walk_forward": walk["forward"] / drive.forward, "walk_left": walk["left"] / drive.forward,
        "walk_turn": walk["turn"] / drive.turn, "gait_phase": robot["gait_phase"] / max(drive.gait_steps, 1),
        "pan": robot["pan"] / pi, "tilt": robot["tilt"] / pi,
        "kick": 1.0 if clock > 0.0 else -1.0 if clock < 0.0 else 0.0,
        "has_ball": float(robot["has_ball"]), "fallen": float(robot["fallen"] > 0.0), **clocks_of(robot, ""),
        "ball_age": 0.0,
    }  # fmt: skip
