"""`soccer export` of a folder: one file for each replay below it, and nothing written over."""

from pathlib import Path

import pytest

from soccer_env.train.command.command_line import main
from soccer_env.train.evaluate.exporting import check_free

PLAYED = ["--home", "chaser", "--away", "still", "--players", "1", "--minutes", "0.03"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("replays")
    (found / "a").mkdir()
    for name, league in (("b.replay", "legged-2001"), ("a/c.replay", "middle-size-2006")):
        assert main(["record", "--league", league, "--out", str(found / name), *PLAYED]) == 0
    return found


@pytest.mark.parametrize(
    ("name", "starts"),
    [
        ("x.html", b"<!doctype html>"), ("x.png", b"\x89PNG"), ("x.gif", b"GIF89a"), ("x.mp4", b"\x00\x00\x00"),
        ("x.svg", b"<?xml"), ("x.xml", b"<?xml"), ("x.cdf", b""), ("x.csv", b"match,"), ("x.parquet", b"PAR1"),
    ],
)  # fmt: skip
def test_a_folder_becomes_a_file_for_each_match_or_one_table(
    folder: Path, tmp_path: Path, name: str, starts: bytes, capsys: pytest.CaptureFixture[str]
) -> None:
    if name.endswith(".parquet"):
        pytest.importorskip("pyarrow")
    if name.endswith((".gif", ".mp4", ".png", ".svg")):
        pytest.importorskip({".gif": "PIL", ".mp4": "imageio_ffmpeg", ".png": "pygame", ".svg": "matplotlib"}[name[1:]])
    command = ["export", str(folder), "--out", str(tmp_path / name), *(["--maps"] if name == "x.svg" else [])]
    assert main(command) == 0
    tables = name in ("x.csv", "x.parquet")
    stem, ending = name.split(".")
    names = {f"{stem}{part}.{ending}" for part in (("", "_events") if tables else ("_b", "_a_c"))}
    assert {path.name for path in tmp_path.iterdir()} == names
    if name != "x.cdf":
        contents = {path: path.read_bytes() for path in tmp_path.iterdir()}
        assert all(content.lower().startswith(starts.lower()) for content in contents.values())
        assert main(command) == 2 and "exists already" in capsys.readouterr().err
        assert all(path.read_bytes() == content for path, content in contents.items())


@pytest.mark.parametrize("anew", [False, True])
def test_a_link_a_folder_or_a_file_of_another_kind_is_in_the_way(tmp_path: Path, anew: bool) -> None:
    link, folder, file = tmp_path / "x.xml", tmp_path / "y.csv", tmp_path / "z.cdf"
    link.symlink_to(tmp_path / "nowhere")
    folder.mkdir()
    file.write_bytes(b"")
    for target in (link, folder, file):
        with pytest.raises(ValueError, match=f"{target.name} is in the way"):
            check_free([tmp_path / "free.csv", target], anew)
    (tmp_path / "own.cdf").mkdir()
    check_free([tmp_path / "own.cdf"], anew=True)


@pytest.mark.parametrize("name", ["x.html", "x.xml"])
def test_replays_whose_files_would_be_one_are_refused(
    folder: Path, tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "in/a").mkdir(parents=True)
    for place in ("in/a/c.replay", "in/a_c.replay"):
        (tmp_path / place).write_bytes((folder / "b.replay").read_bytes())
    assert main(["export", str(tmp_path / "in"), "--out", str(tmp_path / name)]) == 2
    assert "would both be written to" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["in"]
