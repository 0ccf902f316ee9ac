"""`soccer evaluate --sweep`: a curve of evaluations over a number of the league."""

import json
from pathlib import Path
from typing import Any

import pytest

from soccer_env.train.command.command_line import main
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.tournament.sweeping import split_sweep, sweep

SHORT: dict[str, Any] = {"away": "still", "players": 1, "matches": 2, "minutes": 0.1}


def test_factors_are_evenly_spaced() -> None:
    assert split_sweep("kicker.fastest=0.5:1.5:3") == ("kicker.fastest", [0.5, 1.0, 1.5])


def test_each_point_is_the_evaluation_with_that_variation(tmp_path: Path) -> None:
    settings = EvaluateSettings(home="chaser,random", sweep="drive.forward=0.5:1:2", out=tmp_path, **SHORT)
    points = sweep(settings)
    assert [(point.home, point.factor) for point in points] == [
        ("chaser", 0.5), ("chaser", 1.0), ("random", 0.5), ("random", 1.0)
    ]  # fmt: skip
    alone = evaluate(EvaluateSettings(home="chaser", variation="drive.forward=0.5", **SHORT))
    assert alone.lines == points[0].result.lines
    told = json.loads((tmp_path / "sweep.json").read_text())
    assert told["points"] == [point.as_dict() for point in points]
    assert (tmp_path / "chaser-drive.forward-0.5" / "result.json").exists()
    again = sweep(settings)  # from the folders of its points
    assert [point.as_dict() for point in again] == told["points"]


def test_the_command_prints_a_row_for_each_point(capsys: pytest.CaptureFixture[str]) -> None:
    words = "evaluate --home chaser --away still --players 1 --matches 2 --minutes 0.1 --sweep ball.mass=0.5:1:2"
    assert main(words.split()) == 0
    assert "factor" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"sweep": "ball.mass"}, "NAME=LOW:HIGH:COUNT"),
        ({"sweep": "ball.mass=1:1:3"}, "2 to 1000 factors"),
        ({"sweep": "ball.mas=0.5:1:3"}, "did you mean 'ball.mass'"),
        ({"sweep": "ball.mass=0:1:3"}, "out of the league's ranges"),
        ({"sweep": "ball.mass=0.5:1:3", "at_least": 0.5}, "does not go with sweep"),
        ({"sweep": "ball.mass=0.5:1:3", "variation": "ball.mass=2"}, "twice"),
    ],
)
def test_wrong_sweeps_are_told_before_a_match_is_played(changes: dict[str, Any], words: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=words):
        sweep(EvaluateSettings(home="chaser", out=tmp_path / "new", **SHORT, **changes))
    assert not (tmp_path / "new").exists()
