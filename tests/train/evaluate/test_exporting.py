"""`soccer export`: one file for each replay of a folder, pictures of maps of a result.json, nothing written over."""

import json
from pathlib import Path
from typing import Any

import pytest

from soccer_env.statistics.records import CELLS_LONG, CELLS_WIDE
from soccer_env.train.command.command_line import main
from soccer_env.train.evaluate.exporting import check_targets_free

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
        ("x.svg", b"<?xml"), ("x.cdf", b""), ("x.csv", b"match,"), ("x.parquet", b"PAR1"),
    ],
)  # fmt: skip
def test_a_folder_becomes_a_file_for_each_match_or_one_table(
    folder: Path, tmp_path: Path, name: str, starts: bytes, soccer: Any
) -> None:
    if name.endswith(".parquet"):
        pytest.importorskip("pyarrow")
    if name.endswith((".gif", ".mp4", ".png", ".svg")):
        pytest.importorskip({".gif": "PIL", ".mp4": "imageio_ffmpeg", ".png": "pygame", ".svg": "matplotlib"}[name[1:]])
    command = ["export", folder, "--out", tmp_path / name, *(["--maps"] if name == "x.svg" else [])]
    soccer(*command)
    tables = name in ("x.csv", "x.parquet")
    stem, ending = name.split(".")
    names = {f"{stem}{part}.{ending}" for part in (("", "_events") if tables else ("_b", "_a_c"))}
    assert {path.name for path in tmp_path.iterdir()} == names
    if name != "x.cdf":
        contents = {path: path.read_bytes() for path in tmp_path.iterdir()}
        assert all(content.lower().startswith(starts.lower()) for content in contents.values())
        assert "exists already" in soccer(*command, code=2)
        assert all(path.read_bytes() == content for path, content in contents.items())


@pytest.mark.parametrize("anew", [False, True])
def test_a_link_a_folder_or_a_file_of_another_kind_is_in_the_way(tmp_path: Path, anew: bool) -> None:
    link, folder, file = tmp_path / "x.parquet", tmp_path / "y.csv", tmp_path / "z.cdf"
    link.symlink_to(tmp_path / "nowhere")
    folder.mkdir()
    file.write_bytes(b"")
    for target in (link, folder, file):
        with pytest.raises(ValueError, match=f"{target.name} is in the way"):
            check_targets_free([tmp_path / "free.csv", target], anew)
    (tmp_path / "own.cdf").mkdir()
    check_targets_free([tmp_path / "own.cdf"], anew=True)


@pytest.mark.parametrize("name", ["x.html", "x.cdf"])
def test_replays_whose_files_would_be_one_are_refused(folder: Path, tmp_path: Path, name: str, soccer: Any) -> None:
    (tmp_path / "in/a").mkdir(parents=True)
    for place in ("in/a/c.replay", "in/a_c.replay"):
        (tmp_path / place).write_bytes((folder / "b.replay").read_bytes())
    assert "would both be written to" in soccer("export", tmp_path / "in", "--out", tmp_path / name, code=2)
    assert [path.name for path in tmp_path.iterdir()] == ["in"]


PITCH = {"length": 3.0, "width": 2.0, "goal_width": 0.6, "goal_depth": 0.3, "penalty_depth": 0.5, "penalty_width": 1.0,
         "circle": 0.15}  # fmt: skip
HEAT = [[column for column in range(CELLS_LONG)] for _ in range(CELLS_WIDE)]
SHOTS = [[9, 1, "goal", 1.2, 0.1], [19, 1, "saved", 1.0, 0.0], [29, 0, "off_target", 0.5, -0.2]]


def result(**maps: Any) -> dict[str, Any]:
    """Return what a result.json holds that a picture needs."""
    found: dict[str, Any] = {"pitch": PITCH, "heat_ball": HEAT}
    for side in ("for", "against"):
        found[f"heat_{side}"] = HEAT
        found[f"players_{side}"] = [[-1.0, 0.0, 1.0], [2.0, 1.0, 4.0]]
        found[f"passes_{side}"] = [[0, 3], [1, 0]]
        found[f"shots_{side}"] = SHOTS
    return {"home": "$a_<script>$", "away": "b", "maps": found | maps}


def export(folder: Path, record: Any, name: str = "x.png") -> int:
    (folder / "result.json").write_text(json.dumps(record))
    return main(["export", str(folder / "result.json"), "--maps", "--out", str(folder / name)])


@pytest.mark.parametrize(("name", "start"), [("x.png", b"\x89PNG"), ("x.svg", b"<?xml"), ("x.pdf", b"%PDF")])
def test_maps_are_drawn_whatever_teams_are_called(tmp_path: Path, name: str, start: bytes) -> None:
    assert export(tmp_path, result(), name) == 0
    content = (tmp_path / name).read_bytes()
    assert content.startswith(start)
    assert b"<script>" not in content
    assert export(tmp_path, result(), name) == 2, "nothing is written over"
    assert (tmp_path / name).read_bytes() == content


@pytest.mark.parametrize(
    "maps",
    [
        {"heat_for": [[1.0]]}, {"heat_ball": [[float("nan")] * CELLS_LONG] * CELLS_WIDE}, {"heat_for": "many"},
        {"players_for": []}, {"players_for": [[0.0] * 3] * 99}, {"passes_against": [[1]]}, {"passes_for": [[[]]]},
        {"shots_for": [[1, 2, "nonsense", 0.0, 0.0]]}, {"shots_for": [[1, 2, "goal", float("inf"), 0.0]]},
        {"shots_against": [[]]}, {"pitch": None}, {"pitch": PITCH | {"length": 1e9}}, {"pitch": PITCH | {"width": 0.0}},
    ],
)  # fmt: skip
def test_a_result_of_nonsense_is_refused_in_a_line(tmp_path: Path, maps: dict[str, Any], capsys: Any) -> None:
    assert export(tmp_path, result(**maps)) == 2
    (said,) = capsys.readouterr().err.strip().splitlines()
    assert "is not a result.json with maps" in said
    assert not (tmp_path / "x.png").exists()


@pytest.mark.parametrize("record", [[], {}, {"maps": {}}, 3, None, "x"])
def test_other_json_is_refused(tmp_path: Path, record: Any) -> None:
    assert export(tmp_path, record) == 2
