"""A kind of robot is one declared thing: here is a third one, which hears a beacon in the ball and plays a match."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from soccer_env import Match, shows
from soccer_env.belief.believing import make_belief_kernel
from soccer_env.belief.particles import PARTICLE
from soccer_env.compiled import compiled
from soccer_env.data_out.collect import collect_match
from soccer_env.data_out.table_files import write_tables
from soccer_env.data_out.tables import match_tables
from soccer_env.guards.ranges import Range, ranged_record
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.leagues.options import Options
from soccer_env.leagues.robot_kind import CENTI, KINDS, POLAR, NotedPercepts, PerceptSummary, RobotKind, kind_of
from soccer_env.observations import entry_names
from soccer_env.observations.entry import Entry
from soccer_env.perception.body import POSE_ERROR
from soccer_env.perception.sensing import make_sensor_kernel
from soccer_env.random_numbers import draw_normal
from soccer_env.records.percepts import BODY_PERCEPT
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.thoughts.thought import NoteReader
from soccer_env.types import HOME, RobotStream
from tests.scenes.staging import play

CAMERA = int(RobotStream.CAMERA)
PERCEPT = np.dtype([("body", BODY_PERCEPT), ("ahead", "f4"), ("left", "f4")])  # [m] robot frame: the ball
SENSOR_STATE = np.dtype([("pose_error", POSE_ERROR), ("unused", "f4")])
MEMORY = ranged_record([("heard", "i8", Range(0, 1000))])  # frames in which the beacon was heard


@dataclass(frozen=True)
class BeaconSensors(Options):
    """Ears for a beacon in the ball, and what every robot feels."""

    KIND = "beacon"

    beacon_noise: float = 0.02  # [m] sd of the ball's place
    odometry_noise: float = 0.02
    pose_noise: float = 0.05
    pose_turn_noise: float = 0.05
    pose_time: float = 1.0
    place_noise: float = 0.0
    place_turn_noise: float = 0.0


@dataclass(frozen=True)
class BeaconMemory(Options):
    """A robot that trusts what it hears."""

    confidence: float = 100.0


@compiled
def nothing(k, s):  # type: ignore[no-untyped-def]
    return 0


@compiled
def sense_robot(match, ball, robots, r, percept, state, pending, scratch, k, s):  # type: ignore[no-untyped-def]
    robot = robots[r]
    cosine, sine = np.cos(robot.heading), np.sin(robot.heading)
    x, y = ball.x - robot.x, ball.y - robot.y
    percept.ahead = cosine * x + sine * y + s.beacon_noise * draw_normal(robot.noise, CAMERA)
    percept.left = cosine * y - sine * x + match.handedness * s.beacon_noise * draw_normal(robot.noise, CAMERA)


@compiled
def no_scratch():  # type: ignore[no-untyped-def]
    return 0


@compiled
def believe_robot(  # type: ignore[no-untyped-def]
    percept, belief, tracks, memory, particles, noise, gaze, scratch, k, s, w, table
):
    own, ball, body = belief.own, belief.ball, percept.body
    own.x, own.y, own.heading, own.confidence = body.x, body.y, body.heading, w.confidence
    ball.x, ball.y, ball.confidence = percept.ahead, percept.left, w.confidence
    ball.distance = ball.filtered_distance = np.hypot(ball.x, ball.y)
    ball.bearing = ball.filtered_bearing = np.arctan2(ball.y, ball.x)
    memory.heard += 1


@compiled
def say_nothing(percepts, beliefs, tracks, messages, noise, k, s, w, home, rows):  # type: ignore[no-untyped-def]
    pass


def entries(league: League) -> list[Entry]:
    return [Entry("ball_ahead", "the beacon, ahead", "10 m"), Entry("ball_left", "the beacon, to the left", "10 m")]


@compiled
def observe_slice(percepts, beliefs, robots, out, constants, sensors, half_length, rows, first, last):  # type: ignore[no-untyped-def]
    for m in range(first, last):
        for r in rows:
            out[m, r, 0] = min(max(percepts[m, r].ahead / 10.0, -1.0), 1.0)
            out[m, r, 1] = min(max(percepts[m, r].left / 10.0, -1.0), 1.0)


BEACON = RobotKind(
    percept=PERCEPT, sensor_state=SENSOR_STATE, memory=MEMORY, message=np.dtype([("unused", "i8")]), particle=PARTICLE,
    sense=make_sensor_kernel(nothing, sense_robot), believe=make_belief_kernel(no_scratch, believe_robot, say_nothing),
    entries=entries, observe=observe_slice, tables=lambda league: np.zeros(1, np.dtype([("unused", "f8")])),
)  # fmt: skip


@pytest.fixture
def league(monkeypatch: pytest.MonkeyPatch) -> Iterator[League]:
    """Return a league whose robots hear the ball; their kind is known as long as the test lasts."""
    monkeypatch.setitem(KINDS, "beacon", f"{__name__}:BEACON")
    yield replace(find_league("middle-size-2006"), name="beacons", sensors=BeaconSensors(), memory=BeaconMemory())


def test_a_new_kind_of_robot_plays_by_its_sensors(league: League) -> None:
    match = Match(league, home=2, away=2, matches=2, seed=1, controllers={"home": "chaser"}, observe="percepts",
                  rules="simple")  # fmt: skip
    assert match.observation_names == ["ball_ahead", "ball_left"]
    play(match, steps=150, actions=np.zeros((2, 4, 4)))
    x, y = match.balls["x"][:, None] - match.robots["x"], match.balls["y"][:, None] - match.robots["y"]
    assert match.beliefs["ball"]["distance"] == pytest.approx(np.hypot(x, y), abs=0.15)
    observed = 10.0 * np.hypot(match.observations[..., 0], match.observations[..., 1])
    near = np.hypot(x, y) < 9.0  # entries end at 10 m
    assert near.sum() >= 4 and observed[near] == pytest.approx(np.hypot(x, y)[near], abs=0.15)
    kicked = np.hypot(match.balls["x"], match.balls["y"]) > 0.3
    assert kicked[match.matches["kick_off_team"] == HOME].all()  # the chasers found it and kicked off
    assert (match.beliefs["situation"]["teammates"] == 1).all()  # everybody is told how the match stands


def test_its_memory_is_saved_and_its_ranges_are_held(league: League) -> None:
    match = Match(league, home=1, away=1, seed=1, observe="belief")
    play(match, steps=10, actions=np.zeros((1, 2, 4)))
    saved, memories = match.save(), match.batch.senses.memories  # type: ignore[union-attr]
    assert (memories["heard"] == 11).all()  # the first look, and one after each step
    memories["heard"] = 1001
    damaged = match.save()
    with pytest.raises(ValueError, match="heard of memories is out of range"):
        match.load(damaged)
    match.load(saved)
    assert (memories["heard"] == 11).all()


def test_an_unknown_kind_of_sensors_is_refused_by_name() -> None:
    legged = find_league("legged-2001")
    for kind, make in (
        ("'beacon'", lambda: replace(legged, sensors=BeaconSensors(), memory=BeaconMemory())),
        (".*", lambda: replace(legged, sensors=object())),
        ("None", lambda: entry_names(replace(legged, sensors=None), "percepts")),
    ):
        with pytest.raises(ValueError, match=f"unknown kind of sensors {kind}; known: legged, omni"):
            make()


@pytest.mark.parametrize("name", KINDS)
def test_every_known_kind_is_where_it_is_said_to_be(name: str) -> None:
    kinds = {league.sensors.KIND: league.sensors for league in map(find_league, ("legged-2001", "middle-size-2006"))}
    kind = kind_of(kinds[name])
    assert isinstance(kind, RobotKind)
    assert "body" in (kind.percept.names or ()) and "pose_error" in (kind.sensor_state.names or ())


def hear(percepts: np.ndarray, beliefs: np.ndarray) -> dict[str, np.ndarray]:
    bearing, distance = np.arctan2(percepts["left"], percepts["ahead"]), np.hypot(percepts["left"], percepts["ahead"])
    return {"beacon": CENTI * np.stack([bearing, distance], axis=-1)[:, None]}


def heard(percepts: np.ndarray) -> PerceptSummary:
    yes, none = np.ones(len(percepts), bool), np.zeros(len(percepts))
    return PerceptSummary(yes, ~yes, ~yes, none, none, none)


@pytest.mark.parametrize("noted", [None, NotedPercepts((["beacon", 1, POLAR],), hear, heard)])
def test_it_is_recorded_replayed_exported_and_drawn(
    league: League, noted: NotedPercepts | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(globals(), "BEACON", replace(BEACON, noted=noted))
    match = Match(league, home=2, away=1, seed=1, controllers={"home": "chaser", "away": "still"})
    recorder = Recorder(match, Thoughts(match))
    play(match, steps=100)
    x, y = match.balls["x"][0] - match.robots["x"][0], match.balls["y"][0] - match.robots["y"][0]
    replay = Replay.read(recorder.stop().write(tmp_path / "a.replay"))
    assert replay.check() == 100
    notes = replay.notes()
    thought = NoteReader.of(notes).thought(notes.numbers[-1], 1)  # type: ignore[arg-type, union-attr]
    plain, drawn = (shows.frame(replay, 2.0, robot="home_1", sight=sight) for sight in (False, True))
    if noted is None:
        assert thought.groups == {}
    else:
        assert thought.groups["beacon"][0, 1] / CENTI == pytest.approx(np.hypot(x, y)[1], abs=0.15)
        assert (plain != drawn).any(axis=2).sum() > 100  # the ray to the ball
    assert shows.html(replay, tmp_path / "a.html", sight=True, robot="home_1").stat().st_size > 50_000
    tables = write_tables([match_tables(collect_match(replay))], tmp_path / "a.csv")
    assert all(path.stat().st_size for path in tables.values())
