"""Every number of an observation follows from its own fields of the records: each field is changed in turn.

A layout is right if a changed field changes the entries that are listed for it and no other, in the row of the robot
that it belongs to, and if every entry is listed for some field.
"""

from collections.abc import Iterator, Mapping

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.observations.entry import OWN_COMMAND
from soccer_env.types import Phase
from tests.scenes.staging import LEAGUES, LEGGED, MIDDLE, scatter

SIZES = [(1, 1), (3, 2), (6, 6)]
SOME = 0.002  # what floats hold before they are changed: little, so that nothing is clipped
STEP = 0.001  # by how much they are changed

GOALS = "goal_x goal_y own_goal_x own_goal_y"
PLACE = "ball_x ball_y ball_near_x ball_near_y ball_cos ball_sin ball_near"
COMMANDS = {f"command.{name}": f"last_{name}" for name in ("forward", "left", "turn", "kick")}
FELT = {"pan": "pan", "tilt": "tilt", "kick_clock": "kick_ready", "gait_phase": "gait_cos gait_sin", **COMMANDS}
SITUATION = {
    "situation.phase": "in_play", "situation.ours": "restart", "situation.placing": "placing",
    "situation.seconds_left": "time_left", "situation.goals_for": "score", "situation.goals_against": "score",
}  # fmt: skip

MATCH = {
    "phase": "in_play", "restart_team": "restart", "placing": "placing", "clock": "time_left", "half": "time_left",
    "half_length": "time_left", "score.0": "score", "score.1": "score",
    "home_direction": f"own_x own_y own_cos own_sin {GOALS}",
}  # fmt: skip
BALL = {"x": PLACE, "y": PLACE, "vx": "ball_vx ball_vy", "vy": "ball_vx ball_vy"}
MYSELF = {
    **FELT, "vx": "own_forward own_left", "vy": "own_forward own_left", "omega": "own_turn", "has_ball": "has_ball",
    "fallen": "upright", "active": "active", "keeper": "keeper",
}  # fmt: skip
OTHER = {"x": "x y", "y": "x y", "vx": "vx vy", "vy": "vx vy", "heading": "cos sin"}

BELIEF = {
    "own.x": f"own_x {GOALS}", "own.y": f"own_y {GOALS}", "own.heading": f"own_cos own_sin {GOALS}",
    "own.forward": "own_forward", "own.left": "own_left", "own.turn": "own_turn", "own.confidence": "own_confidence",
    "ball.held": "has_ball", "situation.active": "active", "situation.keeper": "keeper",
    "ball.x": "ball_x ball_near_x ball_cos ball_sin ball_near",
    "ball.y": "ball_y ball_near_y ball_cos ball_sin ball_near", "ball.vx": "ball_vx", "ball.vy": "ball_vy",
    "ball.distance": "ball_raw_x ball_raw_y", "ball.bearing": "ball_raw_x ball_raw_y", "ball.radial": "ball_radial",
    "ball.angular": "ball_angular", "ball.confidence": "ball_confidence", "ball.age": "ball_age", **SITUATION,
}  # fmt: skip
OBSTACLE = {"obstacle.distance": "obstacle_near", "obstacle.bearing": "obstacle_cos obstacle_sin"}
TRACK = {
    "present": "present x y vx vy cos sin confidence age", "x": "x", "y": "y", "vx": "vx", "vy": "vy",
    "heading": "cos sin", "confidence": "confidence", "age": "age",
}  # fmt: skip

BODY = {
    "body.pose": "pose_known own_x own_y own_cos own_sin", "body.x": "own_x", "body.y": "own_y",
    "body.heading": "own_cos own_sin", "body.forward": "odometry_forward", "body.left": "odometry_left",
    "body.turn": "odometry_turn", "body.held": "held", "body.upright": "upright",
    "body.active": "active",
}  # fmt: skip
BLOB = {
    "left": "x width", "right": "x width", "high": "y height", "low": "y height", "area": "seen x y width height",
}  # fmt: skip
SIGHTING = {"distance": "near", "bearing": "cos sin", "seen": "seen cos sin near"}
BLOBS = {**dict.fromkeys(("ball", "teammates", "opponents", "own_goal", "opponent_goal"), 4), "landmarks": 6}


def leaves(records: np.ndarray, path: str = "") -> Iterator[tuple[str, np.ndarray]]:
    """Yield the path and the array (M, R) or (M,) of every number of records, as in ball.0.left or command.turn."""
    for name in records.dtype.names or ():
        array, axes = records[name], records.ndim
        parts = [(f"{path}{name}", array)]
        if array.ndim > axes:
            parts = [(f"{path}{name}.{i}", array[..., i]) for i in range(array.shape[axes])]
        for where, part in parts:
            if part.dtype.names:
                yield from leaves(part, f"{where}.")
            elif part.ndim == axes:
                yield where, part


def fill(records: np.ndarray) -> None:
    """Give every float some value, set every flag and let every blob have a size; other codes are kept."""
    whole = {"area": 60, "left": 20, "right": 10, "high": 9, "low": -5}
    flags = dict.fromkeys(("present", "active", "seen", "pose", "upright"), 1)
    for path, array in leaves(records):
        array[...] = SOME if array.dtype.kind == "f" else {**whole, **flags}.get(path.split(".")[-1], 0)


def changed_value(path: str, value: float) -> float:
    """Return another value for a field: floats a little larger, flags and codes the next or the one before."""
    if path.endswith((".area", ".pose")):
        return 0
    if path == "home_direction":
        return -value
    return value + STEP if isinstance(value, float | np.floating) else value ^ 1


def changes(match: Match, array: np.ndarray, at: tuple[int, ...], value: float) -> dict[int, set[str]]:
    """Return the names of the entries that differ in each robot's row of match 0 while a field holds a value."""
    match.batch.observe_anew(0, 1)
    before, kept = match.observations[0].copy(), array[at]
    array[at] = value
    match.batch.observe_anew(0, 1)
    array[at] = kept
    names = np.array(match.observation_names)
    return {r: set(names[row]) for r, row in enumerate(match.observations[0] != before) if row.any()}


def check(
    match: Match, records: np.ndarray, at: tuple[int, ...], sources: Mapping[str, str | set[str]], r: int,
    alone: bool = True, kept: tuple[str, ...] = (),
) -> set[str]:  # fmt: skip
    """Assert that each field of a record changes what `sources` says in robot r's row; return what was changed.

    `alone`: it changes nothing in other rows; `kept` are fields that are left as they are.
    """
    seen: set[str] = set()
    for path, array in leaves(records):
        if path in kept:
            continue
        entries = sources.get(path, set())
        expected = set(entries.split() if isinstance(entries, str) else entries) & set(match.observation_names)
        if match.league.name == MIDDLE:
            expected -= {"gait_cos", "gait_sin"}  # wheels have no gait
        found = changes(match, array, at, changed_value(path, array[at]))
        assert found.get(r, set()) == expected, path
        assert not alone or set(found) <= {r}, path
        seen |= expected
    return seen


def numbered(sources: Mapping[str, str], path: str, name: str) -> dict[str, str]:
    """Return sources with a path before each field and a name before each entry."""
    return {f"{path}.{field}": " ".join(f"{name}_{part}" for part in parts.split()) for field, parts in sources.items()}


def unchanged(match: Match, seen: set[str]) -> set[str]:
    """Return the entries that no field has changed; those of a gait are constant where there is none."""
    gait = {"gait_cos", "gait_sin"} if match.league.name == MIDDLE else set()
    return set(match.observation_names) - seen - gait


def middle_of_play(league: str, home: int, away: int, **settings: str) -> Match:
    """Return a match with everything in motion, all in generic places, and a finite clock."""
    match = Match(league, home=home, away=away, seed=3, minutes=2.0, pose="percept", **settings)
    rng = np.random.default_rng(5)
    scatter(match, rng, share=0.6)
    while closest_in_distance(match) < 4.0 * STEP:
        for axis in "xy":
            match.robots[axis] += rng.uniform(-0.01, 0.01, match.robots.shape)
    for records, names in ((match.robots, ("vx", "vy", "omega")), (match.balls, ("vx", "vy"))):
        for name in names:
            records[name] = 0.02
    match.matches["phase"], match.matches["restart_team"], match.matches["clock"] = Phase.PLAY, 0, 20.0
    return match


def closest_in_distance(match: Match) -> float:
    """Return the least difference [m] between the distances of two robots from a third: a tie would swap slots."""
    x, y = match.robots["x"][0], match.robots["y"][0]
    distances = np.sort(np.hypot(x[:, None] - x, y[:, None] - y), axis=1)
    return float(np.diff(distances[[0, -1]], axis=1).min())


def slots_seen(match: Match, r: int) -> dict[int, str]:
    """Return the slot (as in opponent_0) that each other player fills in the truth that robot r observes."""
    robots, slots = match.robots[0], {1: match.league.slots.teammates, 0: match.league.slots.opponents}
    order = np.argsort(np.hypot(robots["x"] - robots["x"][r], robots["y"] - robots["y"][r]))
    found: dict[int, str] = {}
    for mate, kind in ((1, "teammate"), (0, "opponent")):
        players = [int(o) for o in order if o != r and (robots["team"][o] == robots["team"][r]) == bool(mate)]
        found |= {player: f"{kind}_{slot}" for slot, player in enumerate(players[: slots[mate]])}
    return found


def moves(match: Match, slots: list[str]) -> dict[str, set[str]]:
    """Return what changes in the truth that a robot observes if it moves or turns, with these slots in use."""
    entries = [entry for entry in match.observation_entries if entry.group != OWN_COMMAND]
    relative = [entry.name for entry in entries if entry.frame == "robot" and entry.axis in ("x", "y")]
    used = {entry.name for entry in entries if entry.slot is None or f"{entry.group}_{entry.slot}" in slots}
    places = {*GOALS.split(), *PLACE.split(), *(f"{slot}_{axis}" for slot in slots for axis in "xy")}
    return {"x": places | {"own_x"}, "y": places | {"own_y"}, "heading": used & {*relative, "own_cos", "own_sin"}}


@pytest.mark.parametrize(("home", "away"), SIZES)
@pytest.mark.parametrize("league", LEAGUES)
def test_each_number_of_the_truth_has_its_source(league: str, home: int, away: int) -> None:
    match = middle_of_play(league, home, away)
    for r in (0, home + away - 1):
        slots = slots_seen(match, r)
        seen = check(match, match.matches, (0,), MATCH, r, alone=False)
        seen |= check(match, match.balls, (0,), BALL, r, alone=False)
        mine = {**MYSELF, **moves(match, list(slots.values()))}
        seen |= check(match, match.robots, (0, r), mine, r, alone=False, kept=("team",))
        for other in set(range(home + away)) - {r}:
            slot = slots.get(other)
            theirs = {field: {f"{slot}_{part}" for part in parts.split()} for field, parts in OTHER.items()}
            seen |= check(match, match.robots, (0, other), theirs if slot else {}, r, False, ("team", "active"))
        empty = {entry.name for entry in match.observation_entries if entry.slot is not None}
        empty -= {name for name in empty if name.rpartition("_")[0] in slots.values()}
        assert unchanged(match, seen) == empty | {f"{slot}_present" for slot in slots.values()}
        assert not match.observations[0, r][[match.observation_names.index(name) for name in empty]].any()


@pytest.mark.parametrize("league", LEAGUES)
def test_the_truth_shows_no_player_that_is_not_active(league: str) -> None:
    match = middle_of_play(league, 2, 2)
    for other, slot in slots_seen(match, 0).items():
        gone = changes(match, match.robots["active"], (0, other), 0)[0]
        kind = {name for name in match.observation_names if name.startswith(slot.partition("_")[0])}
        last = f"{slot[:-1]}{int(slot[-1]) + 1 if slot == 'opponent_0' else slot[-1]}"  # the next one moves up
        assert f"{slot}_x" in gone and f"{last}_present" in gone and gone <= kind


@pytest.mark.parametrize(("home", "away"), SIZES)
@pytest.mark.parametrize("league", LEAGUES)
def test_each_number_of_a_belief_has_its_source(league: str, home: int, away: int) -> None:
    match = middle_of_play(league, home, away, observe="belief")
    fill(match.beliefs), fill(match.tracks)
    slots = [f"teammate_{i}" for i in range(match.league.slots.teammates)]
    slots += [f"opponent_{i}" for i in range(match.league.slots.opponents)]
    for r in (0, home + away - 1):
        seen = check(match, match.beliefs, (0, r), {**BELIEF, **OBSTACLE}, r)
        seen |= check(match, match.robots, (0, r), {**FELT, "fallen": "upright"}, r)
        for i, slot in enumerate(slots):
            sources = {field: " ".join(f"{slot}_{part}" for part in parts.split()) for field, parts in TRACK.items()}
            seen |= check(match, match.tracks[:, :, i], (0, r), sources, r)
        assert unchanged(match, seen) == set()
    if league == LEGGED:
        nobody = changes(match, match.beliefs["obstacle"]["distance"], (0, 0), 0.0)
        assert nobody == {0: {"obstacle_near", "obstacle_cos", "obstacle_sin"}}


@pytest.mark.parametrize(("home", "away"), SIZES)
@pytest.mark.parametrize("league", LEAGUES)
def test_each_number_of_a_percept_has_its_source(league: str, home: int, away: int) -> None:
    match = middle_of_play(league, home, away, observe="percepts")
    fill(match.percepts)
    match.beliefs["situation"]["seconds_left"] = 30.0
    sources = dict(BODY)
    if league == LEGGED:
        sources["infrared"] = "infrared"
        sources |= {f"touch.{name}": f"touch_{name}" for name in ("head", "chin", "back", "feet")}
        for name, count in BLOBS.items():
            for i in range(count):
                sources |= numbered(BLOB, f"{name}.{i}", f"{name}_{i}")
    else:
        for name in ("ball", "own_goal", "opponent_goal"):
            sources |= numbered(SIGHTING, name, name)
        for i in range(match.league.slots.teammates + match.league.slots.opponents):
            player = {**SIGHTING, "seen": f"{SIGHTING['seen']} teammate", "teammate": "teammate"}
            sources |= numbered(player, f"players.{i}", f"player_{i}")
        sources |= {f"lines.{i}": f"line_{i}" for i in range(match.league.sensors.lines)}
    for r in (0, home + away - 1):
        seen = check(match, match.percepts, (0, r), sources, r)
        seen |= check(match, match.robots, (0, r), {**FELT, "keeper": "keeper"}, r)
        seen |= check(match, match.beliefs, (0, r), SITUATION, r)
        assert unchanged(match, seen) == ({"infrared_valid"} if league == LEGGED else set())
    if league == LEGGED:
        nothing = changes(match, match.percepts["infrared"], (0, 0), 0.0)
        assert nothing == {0: {"infrared_valid", "infrared"}}
    else:
        assert changes(match, match.percepts["lines"][..., 2], (0, 0), 0.0) == {0: {"line_2"}}


@pytest.mark.parametrize("observe", ["truth", "belief", "percepts"])
@pytest.mark.parametrize(("home", "away"), SIZES)
@pytest.mark.parametrize("league", LEAGUES)
def test_every_number_is_written_at_every_team_size(league: str, home: int, away: int, observe: str) -> None:
    match = Match(league, home=home, away=away, matches=2, seed=0, observe=observe)
    match.observations[:] = np.nan
    match.batch.observe_anew(0, 2)
    assert np.isfinite(match.observations).all()
