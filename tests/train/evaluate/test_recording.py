"""`soccer record`, `replay` and `watch`: what is recorded plays again, and so do replays that evaluations keep."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pytest import MonkeyPatch

from soccer_env.replay import Replay
from soccer_env.train.command.command_line import main
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.evaluate.play_settings import RecordSettings
from soccer_env.train.evaluate.recording import record, start_match
from soccer_env.train.evaluate.replays import Keep, kept_in
from soccer_env.train.evaluate.results import MatchLine


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_a_recorded_match_plays_again(league: str, tmp_path: Path, soccer: Any) -> None:
    path, match = tmp_path / "new" / "a.replay", "--away random --minutes 0.1 --players 2v3"
    soccer("record", "--league", league, *match.split(), "--out", path)
    steps = {"legged-2001": 96, "middle-size-2006": 300}[league]
    soccer("replay", path)
    assert f"{steps} control steps agree" in soccer("replay", path, "--verify")


def test_a_file_that_is_no_replay_is_refused_in_one_line(tmp_path: Path, soccer: Any) -> None:
    path = tmp_path / "b.replay"
    path.write_bytes(b"PK nothing")
    assert "is not a replay that can be read" in soccer("replay", path, code=2)
    soccer("replay", tmp_path / "missing", code=2)


def test_a_replay_that_cannot_be_written_leaves_nothing_behind(tmp_path: Path) -> None:
    settings = RecordSettings(minutes=0.01, players=1, out=tmp_path / "a.replay")
    replay = record(settings)
    (tmp_path / "folder").mkdir()
    with pytest.raises(OSError):
        replay.write(tmp_path / "folder")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.replay", "folder"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("--scene empty-goal --seed 1", "drill empty-goal: success"),
        ("--scene shot-at-keeper --away still --seed 3", "drill shot-at-keeper: success"),
        ("--scene mover-and-still --seed 1", "drill mover-and-still: failure"),
        ("--scene ball-in-corner --home still --players 2v2", "drill ball-in-corner: out of time"),
        ("--scene empty-goal --episode goal --minutes 1 --players 2 --seed 1", ""),
        ("--scene scattered --minutes 0.1 --players 2", ""),
        ("--league middle-size-2006 --scene empty-goal", "drill empty-goal: "),
    ],
)
def test_a_scene_is_recorded_as_it_is_meant(words: str, said: str, tmp_path: Path, soccer: Any) -> None:
    path, picture = tmp_path / "a.replay", tmp_path / "a.png"
    assert said in soccer("record", *words.split(), "--out", path)
    soccer("replay", path)
    soccer("export", path, "--out", picture, "--width", "320")
    assert picture.exists()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--players 0", "players must be 1 to 11"),
        ("--home nobody", "unknown team"),
        ("--minutes -1", "minutes"),
        ("--scene emty-goal", "unknown scene 'emty-goal', did you mean 'empty-goal' or"),
        ("--scene empty-goal --minutes 1", "minutes must be None in a drill"),
        ("--episode drill", "needs a scene with a success test"),
        ("--scene dribble-past-two --players 1", "away must be 2 to"),
        ("--scene dribble-past-one --league middle-size-2006", "scene 'dribble-past-one'"),
        ("--scene empty-goal --episode dril", "did you mean 'drill'?"),
    ],
)
def test_what_cannot_be_recorded_is_one_line(words: str, message: str, tmp_path: Path, soccer: Any) -> None:
    assert message in soccer("record", *words.split(), "--out", tmp_path / "a.replay", code=2)
    assert not (tmp_path / "a.replay").exists()


def test_a_drill_of_ones_own_without_an_end_is_refused(tmp_path: Path, monkeypatch: MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    text = "from soccer_env.scenes import Scene\nENDLESS = Scene('endless', 'without limit', success='home scores')\n"
    (tmp_path / "endless_drills.py").write_text(text)
    with pytest.raises(ValueError, match="might never end"):
        start_match(RecordSettings(scene="endless_drills:ENDLESS"))


SHORT: dict[str, Any] = {"home": "chaser", "away": "still", "matches": 4, "minutes": 1.5, "players": 1, "seed": 1}


def short(out: Path, **changes: Any) -> Any:
    return evaluate(EvaluateSettings(**{**SHORT, "out": out, **changes}))


def line(match: int, ours: int, theirs: int) -> MatchLine:
    return MatchLine(match, match // 2, 7, "home", ours, theirs, 9, f"state {match}", "")


def files(out: Path) -> set[str]:
    return {path.name for path in (out / "replays").iterdir()}


def test_best_and_worst_are_by_goal_difference_then_goals_then_who_came_first() -> None:
    lines = [line(0, 1, 1), line(1, 3, 1), line(2, 4, 2), line(3, 0, 1), line(4, 1, 2), line(5, 1, 2)]
    kept = Keep("worst, best").matches_to_keep(lines)
    assert [(kind, one.match) for kind, one in kept] == [("best", 2), ("worst", 4)]
    assert [one.match for _, one in Keep("goals").matches_to_keep([line(0, 0, 0), line(1, 0, 2)])] == [1]
    assert Keep("goals,best").matches_to_keep([]) == []


def test_what_is_kept_is_what_was_played(tmp_path: Path) -> None:
    result = short(tmp_path, keep="best,worst,goals")
    kept = kept_in(tmp_path)
    lines = {one.match: one for one in result.lines}
    goals = sum(one.goals_for + one.goals_against for one in result.lines)
    assert goals > 0 and [one.kind for one in kept] == ["best", "worst"] + ["goals"] * goals
    for one in kept:
        replay = Replay.read(tmp_path / one.file)
        of = lines[one.match]
        assert replay.check() == len(replay) and (tmp_path / one.file).stat().st_size == one.bytes
        assert f"match-{of.match}-seed-{of.seed}" in one.file and (one.seed, one.state) == (of.seed, of.state)
        last = list(replay.play())[-1]
        if one.kind != "goals":
            score = [of.goals_for, of.goals_against]
            assert last.matches["score"][0].tolist() == (score if of.side == "home" else score[::-1])
            assert len(replay) == of.steps
    assert main(["replay", str(tmp_path / kept[0].file), "--verify"]) == 0


def test_a_clip_of_a_goal_ends_after_it(tmp_path: Path) -> None:
    short(tmp_path, keep="goals")
    for one in kept_in(tmp_path):
        play = Replay.read(tmp_path / one.file).play()
        scored = [step for step, match in enumerate(play) if match.events["goal"][0] >= 0]
        rate = 16  # [1/s] of the legged league
        assert scored and one.seconds - scored[-1] / rate <= 1.5


def test_more_matches_bring_what_is_kept_up_to_date(tmp_path: Path) -> None:
    short(tmp_path, keep="best,goals")
    before = {one.file: (tmp_path / one.file).stat().st_mtime_ns for one in kept_in(tmp_path)}
    result = short(tmp_path, matches=10)  # nothing is asked for: as before
    kept = kept_in(tmp_path)
    best = Keep("best").matches_to_keep(result.lines)[0][1].match
    assert [one.match for one in kept if one.kind == "best"] == [best]
    assert sum(one.kind == "goals" for one in kept) == sum(x.goals_for + x.goals_against for x in result.lines)
    assert files(tmp_path) == {Path(one.file).name for one in kept} | {"kept.json"}
    for one in kept:  # what was there is not played again
        if one.file in before:
            assert (tmp_path / one.file).stat().st_mtime_ns == before[one.file]


def test_files_that_are_damaged_or_gone_are_made_again(tmp_path: Path) -> None:
    short(tmp_path, keep="best,worst")
    whole = {one.file: (tmp_path / one.file).read_bytes() for one in kept_in(tmp_path)}
    first, second = whole
    (tmp_path / first).write_bytes(b"cut")
    (tmp_path / second).unlink()
    short(tmp_path)
    assert {one.file for one in kept_in(tmp_path)} == set(whole)
    assert all(Replay.read(tmp_path / name).check() for name in whole)


def test_a_list_names_no_file_elsewhere(tmp_path: Path) -> None:
    short(tmp_path, keep="best")
    path = tmp_path / "replays" / "kept.json"
    found = json.loads(path.read_text())
    for name in ("file", "page"):
        path.write_text(json.dumps(found | {"replays": [found["replays"][0] | {name: "../../precious.replay"}]}))
        assert kept_in(tmp_path) == []


def test_anew_removes_replays_and_nothing_else(tmp_path: Path) -> None:
    short(tmp_path, keep="best", keep_pages=True)
    (tmp_path / "replays" / "mine.txt").write_text("mine")
    assert any(name.endswith(".html") for name in files(tmp_path))
    short(tmp_path, seed=2, anew=True)
    assert files(tmp_path) == {"mine.txt"}


def test_what_cannot_be_kept_is_said(tmp_path: Path, soccer: Any) -> None:
    assert "unknown keep 'besd'" in soccer("evaluate", "--keep", "besd", "--out", tmp_path / "a", code=2)
    assert not (tmp_path / "a").exists()
    assert "replays are kept in a folder: give out as well" in soccer("evaluate", "--keep", "best", code=2)


class Forgetful:
    """A team that plays every match differently."""

    name = "forgetful"
    memory_dtype = np.dtype([])
    fingerprint = "1"

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        commands = view.stand()
        commands[..., 0] = np.random.default_rng().uniform(-1.0, 1.0)
        return commands


def test_a_team_that_does_not_repeat_itself_is_named(tmp_path: Path) -> None:
    settings = EvaluateSettings(**{**SHORT, "home": "forgetful", "matches": 2, "out": tmp_path, "keep": "best"})
    with pytest.raises(ValueError, match="match 0 .* cannot be kept: played again, it ended differently"):
        evaluate(settings, teams={"forgetful": Forgetful()})
    assert evaluate(replace(settings, keep=""), teams={"forgetful": Forgetful()}).lines
