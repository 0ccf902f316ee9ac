"""A policy is evaluated as it was trained, or as the flag says that somebody gave."""

import json
from pathlib import Path
from typing import Any

import pytest

from soccer_env.agents.policy_file import dump
from soccer_env.train.command.command_line import main
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.evaluate.settings import Conditions
from tests.agents.staged_policies import lively

WORDS = ["--away", "still", "--players", "1", "--matches", "2", "--minutes", "0.05", "--seed", "1"]


def file_of(folder: Path, **known: Any) -> str:
    """Return the path of a policy file that says of its training what is known."""
    file = folder / "lively.safetensors"
    file.write_bytes(dump(lively(**known)))
    return str(file)


def test_another_pose_needs_a_flag_and_the_report_says_what_it_was(tmp_path: Path, capsys: Any) -> None:
    home, out = file_of(tmp_path, pose="percept"), tmp_path / "out"
    assert main(["evaluate", "--home", home, "--out", str(out), *WORDS]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and home in said and not out.exists()
    assert "--pose percept plays it as it was trained, --pose particles tests it so" in said
    assert main(["evaluate", "--home", home, "--pose", "particles", "--out", str(out), *WORDS]) == 0
    assert "| lively was trained with | pose percept |" in (out / "report.md").read_text()
    assert json.loads((out / "result.json").read_text())["trained"] == {"lively": "pose percept"}
    assert main(["evaluate", "--home", home, "--pose", "percept", *WORDS]) == 0
    assert "was trained with" not in capsys.readouterr().out.split("written")[1]


def test_the_team_away_is_looked_at_too() -> None:
    with pytest.raises(ValueError, match=r"'mine' was trained with senses='ideal'.*--senses ideal plays it"):
        from soccer_env.agents.learned import team_of

        asked = EvaluateSettings(home="still", away="mine", players=1, matches=2, minutes=0.05)
        evaluate(asked, teams={"mine": team_of(lively(senses="ideal"))})


def test_who_observes_the_truth_is_not_offered_sensors(tmp_path: Path, capsys: Any) -> None:
    home = file_of(tmp_path, observe="truth", senses="ideal")
    assert main(["evaluate", "--home", home, *WORDS]) == 2
    said = capsys.readouterr().err
    assert said.endswith("--senses ideal plays it as it was trained\n"), said


def test_a_folder_is_gone_on_with_whether_the_default_is_given_or_not(tmp_path: Path) -> None:
    """And its settings are those that older versions wrote: the pose that is played, never None."""
    words = ["evaluate", "--home", "random", "--out", str(tmp_path / "out"), *WORDS]
    assert main(words) == 0
    found = json.loads((tmp_path / "out/settings.json").read_text())["conditions"]
    assert found.keys() == Conditions.__dataclass_fields__.keys()
    assert (found["pose"], found["senses"]) == ("particles", ["sensors", "sensors"])
    assert main([*words, "--pose", "particles", "--senses", "sensors"]) == 0
    assert main([*words, "--pose", "percept"]) == 2
