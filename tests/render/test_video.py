"""Films of replays: how long they are, what they refuse, and that a film that fails leaves nothing behind."""

import sys
from copy import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, shows
from soccer_env.replay import Recorder, Replay
from soccer_env.shows.film import drawn_steps
from soccer_env.shows.film_settings import FilmSettings

pytest.importorskip("pygame")


@pytest.fixture(scope="module")
def replay() -> Replay:
    match = Match("middle-size-2006", home=1, away=1, controllers={"home": "chaser", "away": "random"}, seed=3)
    recorder = Recorder(match)
    for _ in range(60):
        match.step()
    return recorder.stop()


def test_an_mp4_has_as_many_frames_as_its_length_asks_for(replay: Replay, tmp_path: Path) -> None:
    ffmpeg = pytest.importorskip("imageio_ffmpeg")
    path = shows.video(replay, tmp_path / "a.mp4", width=321)
    frames, seconds = ffmpeg.count_frames_and_secs(str(path))
    assert (frames, round(seconds, 2)) == (31, 31 / 25)  # 1.2 s and the start, at 25 frames a second
    assert [file.name for file in tmp_path.iterdir()] == ["a.mp4"]


def test_speed_and_the_part_that_is_shown_choose_the_steps() -> None:
    settings = FilmSettings(speed=4.0, start=1.0, seconds=2.0)
    steps, fps = drawn_steps(settings, ".mp4", 50, 500)
    assert fps == 25.0 and steps.tolist() == list(range(50, 151, 8))
    slow, fps = drawn_steps(FilmSettings(speed=0.25), ".mp4", 16, 4)
    assert fps == 4.0 and slow.tolist() == [0, 1, 2, 3, 4]
    with pytest.raises(ValueError, match="start must be at most 10, the length of the replay in seconds, got 11"):
        drawn_steps(FilmSettings(start=11.0), ".mp4", 50, 500)


def test_a_file_that_exists_is_not_written_over(replay: Replay, tmp_path: Path) -> None:
    pytest.importorskip("PIL")
    path = tmp_path / "a.gif"
    path.write_bytes(b"mine")
    with pytest.raises(ValueError, match=r"a\.gif exists already; give another path or anew=True"):
        shows.video(replay, path)
    assert path.read_bytes() == b"mine"
    shows.video(replay, path, anew=True, width=240)
    assert path.read_bytes().startswith(b"GIF89a")


@pytest.mark.parametrize("ending", [".mp4", ".gif"])
def test_a_film_that_fails_leaves_nothing_behind(replay: Replay, tmp_path: Path, ending: str) -> None:
    pytest.importorskip("imageio_ffmpeg")
    forged = Replay(replay.settings, replay.start, replay.commands, replay.gazes, ["0" * 32] * 60, replay.log)
    with pytest.raises(ValueError, match="differs from the recorded match at control step 0"):
        shows.video(forged, tmp_path / f"a{ending}", width=240)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("settings", "message"),
    [({"speed": 0.0}, "speed must be"), ({"fps": -1.0}, "fps must be"), ({"width": 3}, "width must be 240 to 2560")],
)
def test_wrong_settings_are_named(replay: Replay, tmp_path: Path, settings: dict[str, float], message: str) -> None:
    pytest.importorskip("PIL")
    with pytest.raises(ValueError, match=message):
        shows.video(replay, tmp_path / "a.gif", **settings)
    with pytest.raises(TypeError, match="unknown setting 'sped', did you mean 'speed'"):
        shows.video(replay, tmp_path / "a.gif", sped=1.0)


@pytest.mark.parametrize(("ending", "module"), [(".mp4", "imageio_ffmpeg"), (".gif", "PIL.Image")])
def test_a_missing_extra_is_named(replay: Replay, tmp_path: Path, ending: str, module: str, monkeypatch: Any) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ImportError, match=r'not installed: pip install "soccer_env\[video\]"'):
        shows.video(replay, tmp_path / f"a{ending}")
    with pytest.raises(ValueError, match=r"must end with .mp4 or .gif, got '.*a.avi'"):
        shows.video(replay, tmp_path / "a.avi")


def test_a_replay_is_exported_by_the_command(replay: Replay, tmp_path: Path, soccer: Any) -> None:
    pytest.importorskip("PIL")
    source, out = replay.write(tmp_path / "a.replay"), tmp_path / "new" / "a.gif"
    assert "a.gif, 0." in soccer("export", source, "--out", out, "--width", "240", "--seconds", "0.5")
    assert "exists already; give another --out, or --anew" in soccer("export", source, "--out", out, code=2)
    assert "--out must end with " in soccer("export", source, "--out", tmp_path / "a.avi", code=2)
    source.write_bytes(source.read_bytes()[:-100])
    said = soccer("export", source, "--out", tmp_path / "b.gif", code=2)
    assert "is not a replay that can be read: it is cut short, damaged or no replay" in said
    assert not (tmp_path / "b.gif").exists()


def test_a_replay_of_another_version_says_which(replay: Replay, tmp_path: Path, monkeypatch: Any, soccer: Any) -> None:
    replay = copy(replay)
    replay.made_by = "0.0.1"
    path = replay.write(tmp_path / "a.replay")
    assert Replay.read(path).made_by == "0.0.1"
    forged = Replay(replay.settings, replay.start, replay.commands, replay.gazes, ["0" * 32] * 60, replay.log, "0.0.1")
    with pytest.raises(ValueError, match=r"step 0; soccer_env 0\.0\.1 recorded it, and this is \d"):
        forged.check()
    monkeypatch.setattr("soccer_env.replay.checks.FORMAT", "soccer_env replay 99")
    with pytest.raises(ValueError, match=r"'soccer_env replay 2', written by soccer_env 0\.0\.1; soccer_env .* reads"):
        Replay.read(path)
    monkeypatch.undo()
    replay.settings = {"league": "mine"}
    np.savez(tmp_path / "c.npz", a=np.zeros(3))
    for file, said in (
        (replay.write(path), "the settings of this replay are damaged"),
        (tmp_path / "c.npz", "it is an archive of something else"),
    ):
        assert said in soccer("export", file, "--out", tmp_path / "b.html", code=2)
    assert not (tmp_path / "b.html").exists()


def test_gymnasium_records_a_video(tmp_path: Path) -> None:
    pytest.importorskip("moviepy")
    import gymnasium
    from gymnasium.wrappers import RecordVideo

    made = gymnasium.make("soccer_env/Legged2001-1v1-v0", render_mode="rgb_array")
    env = RecordVideo(made, str(tmp_path), disable_logger=True)
    env.reset(seed=1)
    for _ in range(5):
        env.step(env.action_space.sample())
    env.close()
    assert [file.suffix for file in tmp_path.iterdir()] == [".mp4"]
