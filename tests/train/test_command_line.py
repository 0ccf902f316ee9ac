"""The command line: light, plain about what is wrong, and never a traceback for a user's mistake."""

import subprocess
import sys
from pathlib import Path
from typing import get_args

import pytest

from soccer_env.train import command_line
from soccer_env.train.command_line import main
from soccer_env.train.listing import What

# not gymnasium and pettingzoo: importing the package registers its environments there
HEAVY = ("numba", "torch", "pymunk", "tyro", "rich", "scipy", "matplotlib", "pygame")


@pytest.mark.parametrize("words", [["--help"], ["--version"], ["nonsense"]])
def test_what_needs_nothing_imports_nothing(words: list[str], tmp_path: Path) -> None:
    program = (
        "import sys\nfrom soccer_env.train.command_line import main\n"
        f"main({words!r})\nprint('heavy:', sorted(set({HEAVY!r}) & set(sys.modules)))"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[-1] == "heavy: []"


def test_help_of_a_command_compiles_nothing(tmp_path: Path) -> None:
    program = (
        "import sys\nfrom soccer_env.train.command_line import main\n"
        "try:\n    main(['evaluate', '--help'])\nfinally:\n    print('heavy:', {'numba', 'torch'} & set(sys.modules))"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "--matches" in run.stdout
    assert "heavy: set()" in run.stdout


def test_help_names_every_command_and_none_that_is_not_built(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--help"]) == 0
    text = capsys.readouterr().out
    assert set(command_line.SUMMARIES) == set(command_line.COMMANDS)
    assert all(f"  {name} " in text for name in command_line.SUMMARIES)
    assert all(kind in command_line.SUMMARIES["list"] for kind in get_args(What))
    assert main([]) == 2


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (["football"], "unknown command 'football'; known: evaluate"),
        (["evaluate", "--goals", "3"], "Unrecognized options: --goals, 3"),
        (["evaluate", "--matches", "many"], "--matches"),
        (["evaluate", "--matches", "3"], "matches must be an even whole number, for each seed is played twice"),
        (["evaluate", "--matches"], "--matches"),
        (["evaluate", "--minutes", "half"], "--minutes"),
        (["evaluate", "--seed", "-1"], "seed must be a whole number of at least 0, got -1"),
        (["evaluate", "--league", "cricket"], "unknown league 'cricket'; known: legged-2001, middle-size-2006"),
        (["evaluate", "--home", "winners"], "unknown team 'winners'; known: still, random"),
        (["evaluate", "--home", "still", "--away", "random@2"], "strength of team 'random@2' must be"),
        (["evaluate", "--home", "still", "--scene", "picnic"], "unknown scene 'picnic'; known: kick-off"),
        (["evaluate", "--home", "still", "--scene", "empty-goal"], "drill"),
        (["evaluate", "--players", "12"], "players must be 1 to 11"),
        (["evaluate", "--picture"], "picture needs a folder"),
        (["list", "cups"], "unknown list 'cups'; known: leagues"),
        (["evalaute"], "unknown command 'evalaute', did you mean 'evaluate'? known: evaluate, list"),
        (["list", "senses"], "unknown list 'senses', did you mean 'scenes'? known: leagues"),
        (["evaluate", "--home", "sacks-2000"], "unknown team 'sacks-2000', did you mean 'sacks-2001'? known: still"),
        (["evaluate", "--league", "leged-2001"], "unknown league 'leged-2001', did you mean 'legged-2001'? known: "),
        (["evaluate", "--home", "still", "--scene", "kickoff"], "unknown scene 'kickoff', did you mean 'kick-off'?"),
        (["list", "observations", "--league", "x"], "unknown league 'x'"),
    ],
)
def test_a_mistake_is_one_line_and_exit_code_2(
    words: list[str], complaint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert complaint in printed.err
    assert printed.err.startswith("soccer: ")
    assert printed.err.count("\n") == 1


def test_a_folder_that_cannot_be_made_is_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    words = ["evaluate", "--home", "still", "--away", "still", "--out", str(tmp_path / "file" / "inside")]
    assert main(words) == 2
    assert "Not a directory" in capsys.readouterr().err


@pytest.mark.parametrize("what", ["leagues", "teams", "scenes", "observations", "rules", "actions", "rewards"])
def test_lists_name_what_there_is(what: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", what]) == 0
    text = capsys.readouterr().out
    expected = {
        "leagues": ("legged-2001", "middle-size-2006", "3 x 2 m", "family"),
        "teams": ("random", "still", "NAME@0.5", "family"),
        "scenes": ("kick-off", "family"),
        "observations": ("own_x", "ball_x", "73 numbers"),
        "rules": ("keeper_pushing", "simple"),
        "actions": ("forward", "discrete"),
        "rewards": ("progress", "sparse"),
    }[what]
    assert all(word in text for word in expected)


def test_a_traceback_can_be_had(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOCCER_ENV_TRACEBACK", "1")
    with pytest.raises(ValueError, match="unknown team"):
        main(["evaluate", "--home", "winners"])
