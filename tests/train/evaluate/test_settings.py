"""Settings of an evaluation: what they mean, what is refused, the command that repeats them, policies as trained."""

import json
import shlex
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from soccer_env.agents.policy_file import dump
from soccer_env.leagues import find_league
from soccer_env.train.command.command_line import main
from soccer_env.train.command.parsing import read_settings
from soccer_env.train.evaluate.settings import Conditions, EvaluateSettings, command_of, conditions_of
from tests.agents.staged_policies import random_policy

LEGGED, MIDDLE = find_league("legged-2001"), find_league("middle-size-2006")


def test_what_is_left_open_comes_from_the_league_full_is_both_halves_and_team_sizes_may_differ() -> None:
    legged, middle = conditions_of(EvaluateSettings(), LEGGED), conditions_of(EvaluateSettings(), MIDDLE)
    assert (legged.minutes, legged.players, legged.placement) == (10.0, (3, 3), "instant")
    assert (middle.minutes, middle.players, middle.placement) == (4.0, (5, 5), "drive")
    assert conditions_of(EvaluateSettings(minutes="full"), LEGGED).minutes == 2 * LEGGED.rules.half_minutes
    assert conditions_of(EvaluateSettings(players="3v5"), LEGGED).players == (3, 5)
    assert conditions_of(EvaluateSettings(players=4), LEGGED).players == (4, 4)


def test_senses_for_one_team_each() -> None:
    both = conditions_of(EvaluateSettings(senses="home=ideal,away=sensors"), LEGGED)
    assert (both.senses, both.senses_text) == (("ideal", "sensors"), "home=ideal,away=sensors")
    assert conditions_of(EvaluateSettings(senses="ideal"), LEGGED).senses_text == "ideal"


@pytest.mark.parametrize(
    "wrong",
    [
        {"matches": 3}, {"matches": 0}, {"matches": 2.0}, {"matches": True}, {"seed": -1}, {"threads": 0},
        {"minutes": 0}, {"minutes": float("nan")}, {"minutes": float("inf")}, {"minutes": "half"}, {"minutes": -4.0},
        {"players": 0}, {"players": 12}, {"players": "3v"}, {"players": "v"}, {"players": "1v2v3"}, {"players": True},
        {"senses": "eyes"}, {"senses": "home=ideal,away=eyes"}, {"senses": ""}, {"pose": "compass"},
        {"placement": "walk"}, {"at_least": 95}, {"picture": True},
    ],
)  # fmt: skip
def test_wrong_settings_are_refused_by_name(wrong: dict) -> None:
    with pytest.raises(ValueError, match=next(iter(wrong))):
        EvaluateSettings(**wrong)


@pytest.mark.parametrize(
    "settings",
    [
        EvaluateSettings(),
        EvaluateSettings(home="chaser@0.5", minutes=2.5, players="3v5", threads=2, out=Path("runs/a b"), picture=True),
        EvaluateSettings(minutes="full", senses="home=ideal,away=sensors", placement="drive", at_least=0.95, seed=7),
    ],
)
def test_the_command_of_settings_gives_these_settings(settings: EvaluateSettings) -> None:
    program, name, *words = shlex.split(command_of(settings))
    assert (program, name) == ("soccer", "evaluate")
    assert read_settings(EvaluateSettings, words, "evaluate") == settings
    assert "anew" not in command_of(replace(settings, anew=True, out=Path("x"))), "a report throws no matches away"


WORDS = ["--away", "still", "--players", "1", "--matches", "2", "--minutes", "0.05", "--seed", "1"]


def file_of(folder: Path, **known: Any) -> str:
    """Return the path of a policy file that says of its training what is known."""
    file = folder / "lively.safetensors"
    file.write_bytes(dump(random_policy(**known)))
    return str(file)


def test_another_pose_needs_a_flag_and_the_report_says_what_it_was(tmp_path: Path, soccer: Any) -> None:
    home, out = file_of(tmp_path, pose="percept"), tmp_path / "out"
    said = soccer("evaluate", "--home", home, "--out", out, *WORDS, code=2)
    assert home in said and not out.exists()
    assert "--pose percept plays it as it was trained, --pose particles tests it so" in said
    soccer("evaluate", "--home", home, "--pose", "particles", "--out", out, *WORDS)
    assert "| lively was trained with | pose percept |" in (out / "report.md").read_text()
    assert json.loads((out / "result.json").read_text())["trained"] == {"lively": "pose percept"}
    assert "was trained with" not in soccer("evaluate", "--home", home, "--pose", "percept", *WORDS)


def test_a_folder_is_gone_on_with_whether_the_default_is_given_or_not(tmp_path: Path) -> None:
    """And its settings are those that older versions wrote: the pose that is played, never None."""
    words = ["evaluate", "--home", "random", "--out", str(tmp_path / "out"), *WORDS]
    assert main(words) == 0
    found = json.loads((tmp_path / "out/settings.json").read_text())["conditions"]
    assert found.keys() == Conditions.__dataclass_fields__.keys()
    assert (found["pose"], found["senses"]) == ("particles", ["sensors", "sensors"])
    assert main([*words, "--pose", "particles", "--senses", "sensors"]) == 0
    assert main([*words, "--pose", "percept"]) == 2
