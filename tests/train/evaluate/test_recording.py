"""`soccer record`, `replay` and `watch`: what is recorded plays again."""

from pathlib import Path

import pytest

from soccer_env.train.command.command_line import main
from soccer_env.train.evaluate.play_settings import RecordSettings
from soccer_env.train.evaluate.recording import record, start


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_a_recorded_match_plays_again(league: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "new" / "a.replay"
    command = ["--league", league, "--away", "random", "--minutes", "0.1", "--players", "2v3", "--out", str(path)]
    assert main(["record", *command]) == 0
    assert main(["replay", str(path)]) == 0
    assert main(["replay", str(path), "--verify"]) == 0
    steps = {"legged-2001": 96, "middle-size-2006": 300}[league]
    assert f"{steps} control steps agree" in capsys.readouterr().out


def test_a_file_that_is_no_replay_is_refused_in_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "b.replay"
    path.write_bytes(b"PK nothing")
    assert main(["replay", str(path)]) == 2
    assert main(["replay", str(tmp_path / "missing")]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 2 and "is not a replay that can be read" in lines[0]


@pytest.mark.parametrize(
    ("flag", "value", "message"),
    [
        ("--players", "0", "players must be 1 to 11"),
        ("--home", "nobody", "unknown team"),
        ("--minutes", "-1", "minutes"),
    ],
)
def test_wrong_settings_end_in_one_line(
    flag: str, value: str, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["record", flag, value]) == 2
    assert message in capsys.readouterr().err


def test_a_place_that_cannot_be_written_is_refused_before_the_match(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("soccer_env.train.evaluate.recording.start", lambda settings: pytest.fail("it played"))
    (tmp_path / "file").write_bytes(b"")
    assert main(["record", "--out", str(tmp_path)]) == 2
    assert main(["record", "--out", str(tmp_path / "file" / "a.replay")]) == 2
    first, second = capsys.readouterr().err.splitlines()
    assert "is a folder" in first and "its folder cannot be made" in second


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
def test_a_scene_is_recorded_as_it_is_meant(
    words: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, picture = tmp_path / "a.replay", tmp_path / "a.png"
    assert main(["record", *words.split(), "--out", str(path)]) == 0
    assert said in capsys.readouterr().out
    assert main(["replay", str(path)]) == 0
    assert main(["export", str(path), "--out", str(picture), "--width", "320"]) == 0 and picture.exists()


def test_a_drill_is_played_by_those_whom_it_is_meant_for(tmp_path: Path) -> None:
    replay = record(RecordSettings(scene="mover-and-still", home="still", out=tmp_path / "a.replay"))
    assert replay.settings["teams"] == {"home_0": "still", "away_0": "still", "away_1": "walker@0.5"}
    replay = record(RecordSettings(scene="mover-and-still", home="still", players="1v3", out=tmp_path / "a.replay"))
    assert list(replay.settings["teams"].values()) == ["still", "still", "still", "walker@0.5"]
    replay = record(RecordSettings(scene="shot-at-keeper", out=tmp_path / "a.replay"))
    assert list(replay.settings["teams"].values()) == ["still", "chaser", "chaser"]
    assert replay.settings["scene"]["success"] == "away saves"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--scene emty-goal", "unknown scene 'emty-goal', did you mean 'empty-goal'?"),
        ("--scene empty-goal --minutes 1", "minutes must be None in a drill"),
        ("--episode drill", "needs a scene with a success test"),
        ("--scene dribble-past-two --players 1", "away must be 2 to"),
        ("--scene dribble-past-one --league middle-size-2006", "scene 'dribble-past-one'"),
        ("--scene empty-goal --episode dril", "did you mean 'drill'?"),
    ],
)
def test_a_scene_that_cannot_be_is_one_line(
    words: str, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["record", *words.split(), "--out", str(tmp_path / "a.replay")]) == 2
    printed = capsys.readouterr().err
    assert message in printed and printed.count("\n") == 1
    assert not (tmp_path / "a.replay").exists()


def test_a_drill_of_ones_own_without_an_end_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    text = (
        "from soccer_env.scenes import Scene\nENDLESS = Scene('endless', 'no limit of time', success='home scores')\n"
    )
    (tmp_path / "endless_drills.py").write_text(text)
    with pytest.raises(ValueError, match="might never end"):
        start(RecordSettings(scene="endless_drills:ENDLESS"))


def test_a_drill_can_be_watched_to_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    assert main(["watch", "--scene", "shot-at-keeper", "--away", "still", "--speed", "100", "--width", "320"]) == 0


def test_a_match_can_be_watched_to_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    assert main(["watch", "--minutes", "0.02", "--speed", "50", "--width", "320"]) == 0
