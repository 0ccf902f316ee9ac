"""Pictures of maps: of a result.json, and of nothing that is none."""

import json
from pathlib import Path
from typing import Any

import pytest

from soccer_env.statistics.records import CELLS_LONG, CELLS_WIDE
from soccer_env.train.command.command_line import main

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
    """Return the exit code of drawing a record."""
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
def test_a_result_of_nonsense_is_refused_in_a_line(
    tmp_path: Path, maps: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    assert export(tmp_path, result(**maps)) == 2
    said = capsys.readouterr().err.strip().splitlines()
    assert len(said) == 1
    assert "is not a result.json with maps" in said[0]
    assert not (tmp_path / "x.png").exists()


@pytest.mark.parametrize("record", [[], {}, {"maps": {}}, 3, None, "x"])
def test_other_json_is_refused(tmp_path: Path, record: Any) -> None:
    assert export(tmp_path, record) == 2
