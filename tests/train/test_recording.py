"""`soccer record`, `replay` and `watch`: what is recorded plays again."""

from pathlib import Path

import pytest

from soccer_env.train.command_line import main


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_a_recorded_match_plays_again(league: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "new" / "a.replay"
    command = ["--league", league, "--away", "random", "--minutes", "0.1", "--players", "2v3", "--out", str(path)]
    assert main(["record", *command]) == 0
    assert main(["replay", str(path)]) == 0
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


def test_a_match_can_be_watched_to_its_end() -> None:
    assert main(["watch", "--minutes", "0.02", "--speed", "50", "--width", "320"]) == 0
