"""Saves, loads, rebuilds and replays: one save has one future, and a replay plays again exactly."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.match import saving
from soccer_env.replay import Recorder, Replay
from soccer_env.types import WORLD, RobotStream
from tests.scenes.staging import refused

LEAGUES = ("legged-2001", "middle-size-2006")


def go(match: Match, steps: int, seed: int) -> str:
    rng = np.random.default_rng(seed)
    for _ in range(steps):
        match.step(rng.uniform(-1.0, 1.0, (match.count, len(match.agents), match.settings.actions.size)))
    return match.state_hash()


def lively(league: str, **settings: object) -> Match:
    """Return a match in which much happens."""
    teams = {"away": "chaser", "home_0": "random"}
    return Match(league, home=3, away=3, matches=2, seed=5, controllers=teams, **settings)


@pytest.mark.parametrize("league", LEAGUES)
def test_a_save_has_one_future_and_holds_the_memory_of_teams(league: str) -> None:
    match = lively(league)
    go(match, 300, 1)
    saved, memory = match.save(), [squad.memory.tobytes() for squad in match.squads]
    assert any(any(one) for one in memory)
    future = go(match, 300, 2), memory
    assert go_on_from(match, saved) == go_on_from(lively(league), saved) == future


def go_on_from(match: Match, saved: bytes) -> tuple[str, list[bytes]]:
    """Load a save and play the same actions; return the hash at the end, and the memory of teams before."""
    match.load(saved)
    memory = [squad.memory.tobytes() for squad in match.squads]
    return go(match, 300, 2), memory


@pytest.mark.parametrize("league", LEAGUES)
def test_a_match_with_three_saves_and_a_load_replays_bit_for_bit(league: str, tmp_path: Path) -> None:
    match = lively(league, autoreset="same_step", max_cycles=170)
    go(match, 50, 0)
    recorder = Recorder(match)
    go(match, 100, 1)
    saved = match.save()
    go(match, 100, 2)
    match.save()
    go(match, 100, 3)
    match.load(saved)
    go(match, 50, 4)
    match.save()
    go(match, 50, 5)
    replay = recorder.stop()
    assert Replay.read(replay.write(tmp_path / "match.replay")).check() == 400


@pytest.mark.parametrize("mode", ["next_step", "same_step", "off"])
def test_resets_replay_too(mode: str) -> None:
    match = lively("middle-size-2006", autoreset=mode, max_cycles=40)
    recorder = Recorder(match)
    go(match, 100, 1)
    match.reset()
    go(match, 60, 2)
    assert recorder.stop().check() == 160


def test_a_replay_holds_the_records_of_the_matches_that_began_anew_and_not_of_all() -> None:
    match = Match(home=1, away=1, matches=8, seed=5, minutes=0.2, autoreset="same_step")
    match.matches["half"], match.matches["clock"] = 1, match.settings.half_length - 0.2 * np.arange(1, 9)
    recorder = Recorder(match)
    go(match, 40, 1)
    replay = recorder.stop()
    assert [rows for _, rows, _ in replay.log] == [[m] for m in range(8)], "one after the other"
    assert max(len(records) for _, _, records in replay.log) < len(saving.dump(match, memory=False)) / 2
    assert replay.check() == 40


def test_a_replay_names_the_first_step_that_differs() -> None:
    match = lively("legged-2001")
    recorder = Recorder(match)
    go(match, 60, 1)
    replay = recorder.stop()
    replay.commands["forward"][33, 1, 2] += 1e-12
    with pytest.raises(ValueError, match="control step 33"):
        replay.check()


@pytest.mark.parametrize(("field", "change"), [("x", 1e-6), ("angle", 1e-6), ("vy", 0.2)])
def test_a_replay_notices_that_the_ball_alone_is_another(field: str, change: float) -> None:
    """In the second of two matches, from the tenth step on, a ball lies or rolls otherwise, which no robot feels."""
    match = Match(home=2, away=2, matches=2, seed=5)
    recorder = Recorder(match)
    for step in range(20):
        if step == 10:
            match.rebuild()
        match.step(np.zeros((2, 4, 4)))
    replay = recorder.stop()
    assert replay.check() == 20
    ((when, rows, records),) = replay.log
    forged = replay.make_match()
    saving.restore(forged, records, memory=False)
    forged.balls[field][1] += change
    replay.log = [(when, rows, saving.dump(forged, memory=False))]
    with pytest.raises(ValueError, match=f"differs from the recorded match at control step {when}"):
        replay.check()
    assert when == 10


@pytest.mark.parametrize("stream", RobotStream)
def test_a_replay_holds_the_noise_of_the_play_and_not_that_of_teams_and_senses(stream: RobotStream) -> None:
    """Slips, kicks, places and falls are drawn by physics and referee; who commands and who looks on draws the rest."""
    match = Match(home=1, away=1, seed=5)
    before = saving.play_hash(match)
    match.robots["noise"][0, 1, stream] += 1
    played = stream in (RobotStream.SLIP, RobotStream.KICK, RobotStream.PLACEMENT, RobotStream.FALL)
    assert (saving.play_hash(match) != before) == played


@pytest.mark.parametrize("damage", [b"", b"x", b"truncated", b"flipped", b"not bytes", b"other"])
def test_a_damaged_save_is_refused_and_changes_nothing(damage: bytes) -> None:
    match = Match(home=1, away=1, seed=1)
    saved = match.save()
    bad = {
        b"truncated": saved[:-100],
        b"flipped": saved[:500] + bytes([saved[500] ^ 1]) + saved[501:],
        b"not bytes": "text",
        b"other": Match("middle-size-2006", home=1, away=1, seed=1).save(),
    }.get(damage, damage)
    with refused(match, "save"):
        match.load(bad)  # type: ignore[arg-type]


class Forgetful:
    """A team that remembers nothing."""

    name = "forgetful"
    memory_dtype = np.dtype([])

    def act(self, view, memory, rng):  # type: ignore[no-untyped-def]
        return view.stand()


@pytest.mark.parametrize(
    ("records", "field", "value"),
    [
        ("robots", "team", 10**6), ("robots", "number", 7), ("robots", "x", np.inf), ("robots", "place_x", 1e300),
        ("matches", "phase", 99), ("matches", "clock", np.nan), ("matches", "last_touch_robot", 10**6),
        ("matches", "home_direction", 0.5), ("matches", "step", -1), ("balls", "angle", np.nan),
        ("robots", "pan", 100.0), ("robots", "tilt", -100.0), ("matches", "clock", -1e6), ("robots", "omega", np.nan),
    ],
)  # fmt: skip
def test_a_forged_save_is_refused(records: str, field: str, value: float) -> None:
    """Kernels index by what lies in the records: a wrong number would end the process."""
    match, forged = Match(home=1, away=1, seed=1), Match(home=1, away=1, seed=1)
    getattr(forged, records)[field] = value
    with refused(match, f"{field} of {records} is (out of range|not that of the match)"):
        match.load(saving.dump(forged))


@pytest.mark.parametrize("observe", ["truth", "belief", "percepts"])
def test_a_match_that_is_over_is_observed_alike_after_a_step_and_after_a_load(observe: str) -> None:
    settings: dict[str, Any] = {"home": 1, "away": 1, "minutes": 0.02, "observe": observe, "opponents": "chaser"}
    match, other = Match(**settings, seed=1), Match(**settings, seed=1)
    for step in range(40):  # of which the last ones come after the end
        match.step(np.full((1, 2, 4), 0.01 * step))
    assert match.terminated.all()
    seen = match.observations.copy()
    other.load(match.save())
    assert (other.observations == seen).all()
    if observe == "truth":
        assert seen[0, 0, match.observation_names.index("last_kick")] == np.float32(0.39)


def test_saves_and_replays_of_another_world_are_refused_in_a_line_that_says_what_plays_them(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    match = Match(home=1, away=1, seed=1, controllers={"home": "chaser", "away": "still"})
    recorder = Recorder(match)
    match.step()
    with monkeypatch.context() as older:
        older.setattr("soccer_env.match.saving.saves.WORLD", 1)
        older.setattr("soccer_env.replay.replay_file.WORLD", 1)
        saved, path = match.save(), recorder.stop().write(tmp_path / "match.replay")
    before = match.state_hash()
    with pytest.raises(
        ValueError, match=f"this save is of world 1, this is world {WORLD}: load it with the version of"
    ):
        match.load(saved)
    with pytest.raises(
        ValueError, match=f"recorded in world 1, this is world {WORLD}: load it with the version of soc"
    ):
        Replay.read(path)
    assert match.state_hash() == before
