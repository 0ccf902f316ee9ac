"""The command line: light, plain about what is wrong, and never a traceback for a user's mistake."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import weakref
from pathlib import Path
from typing import Any, get_args

import pytest

from soccer_env.teams import registry
from soccer_env.train.command import command_line
from soccer_env.train.command.command_line import main
from soccer_env.train.command.exit_codes import STOPPED
from soccer_env.train.command.listing import What

# not gymnasium and pettingzoo: importing the package registers its environments there
HEAVY = ("numba", "torch", "pymunk", "tyro", "rich", "scipy", "matplotlib", "pygame")


def heavy_after(words: list[str], folder: Path) -> tuple[str, str]:
    """Return what the command prints in a process of its own, and what of HEAVY it imported."""
    program = (
        "import sys\nfrom soccer_env.train.command.command_line import main\n"
        f"try:\n    main({words!r})\nfinally:\n    print('heavy:', sorted(set({HEAVY!r}) & set(sys.modules)))"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True, check=True)
    printed, _, heavy = run.stdout.partition("heavy: ")
    return printed, heavy.strip()


@pytest.mark.parametrize("words", [["--help"], ["--version"], ["nonsense"]])
def test_what_needs_nothing_imports_nothing(words: list[str], tmp_path: Path) -> None:
    assert heavy_after(words, tmp_path)[1] == "[]"


def test_help_names_every_command_that_is_built_and_compiles_nothing(tmp_path: Path, capsys: Any) -> None:
    printed, heavy = heavy_after(["evaluate", "--help"], tmp_path)
    assert "--matches" in printed and "numba" not in heavy and "torch" not in heavy
    assert main(["--help"]) == 0
    text = capsys.readouterr().out
    assert set(command_line.SUMMARIES) == set(command_line.COMMANDS)
    assert all(f"  {name} " in text for name in command_line.SUMMARIES)
    assert all(kind in command_line.SUMMARIES["list"] for kind in get_args(What))
    assert main([]) == 2


def test_a_ctrl_c_that_a_callback_swallows_comes_again(monkeypatch: Any) -> None:
    class Thing:
        pass

    def work(words: list[str]) -> int:
        thing = Thing()
        kept = weakref.ref(thing, lambda _: signal.raise_signal(signal.SIGINT))
        del thing
        for _ in range(500):
            time.sleep(0.01)
        return 0 if kept() is None else 1

    usual = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        assert command_line.run_guarded(work, []) == STOPPED
    finally:
        signal.signal(signal.SIGINT, usual)


@pytest.mark.parametrize("name", command_line.SUMMARIES)
def test_help_says_what_leaving_an_option_out_does(name: str, capsys: Any) -> None:
    with pytest.raises(SystemExit):
        main([name, "--help-all"])
    assert "None" not in capsys.readouterr().out


def test_the_basic_options_of_a_training_come_first(capsys: Any) -> None:
    with pytest.raises(SystemExit):
        main(["train", "--help"])
    flags = re.findall(r"^\W (--[a-z][a-z-]+)", capsys.readouterr().out, re.MULTILINE)
    basic = ["--league", "--players", "--opponents", "--steps", "--actions", "--action-repeat", "--out", "--seed"]
    assert flags == [*basic, "--threads", "--ray", "--anew"]


@pytest.mark.parametrize("name", command_line.SUMMARIES)
def test_the_help_of_a_command_fits_a_screen_and_says_how_many_options_it_leaves_out(name: str, capsys: Any) -> None:
    shown = []
    for flag in ("--help", "--help-all"):
        with pytest.raises(SystemExit):
            main([name, flag])
        shown.append(capsys.readouterr().out)
    flags = [len(re.findall(r"^\W --[a-z]", text, re.MULTILINE)) for text in shown]
    assert len(shown[0].splitlines()) <= 60
    left_out = re.findall(rf"`soccer {name} --help-all` explains (\d+) more options", shown[0])
    assert left_out == ([str(flags[1] - flags[0])] if flags[1] > flags[0] else [])


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (["evaluate", "--goals", "3"], "unknown option '--goals'"),
        (["evaluate", "--matchez", "4"], "unknown option '--matchez', did you mean '--matches'? known: --league"),
        (["evaluate", "4"], "unexpected argument '4'; options: --league"),
        (["evaluate", "--pose", "percpt"], "unknown --pose 'percpt', did you mean 'percept'? known: "),
        (["evaluate", "--minutes", "none"], "--minutes must be a number above 0 and below 10000 or full, got 'none'"),
        (["evaluate", "--anew=yes"], "unexpected argument 'yes'"),
        (["replay"], "FILE must be given (see soccer replay --help)"),
        (["evaluate", "--recheck", "x", "--matches", "40"], "matches does not go with recheck"),
        (["train", "--mirorr"], "unknown option '--mirorr', did you mean '--mirror' or '--no-mirror'?"),
        (["list", "teams", "--lague", "x"], "unknown option '--lague', did you mean '--league'?"),
        (["--tyro-print-completion", "bsh"], "unknown shell 'bsh', did you mean 'bash'?"),
        (["--print-completion"], "unknown shell ''; known: bash, zsh, fish"),
        (["evaluate", "--matches", "3"], "matches must be an even whole number, for each seed is played twice"),
        (["evaluate", "--matches"], "--matches"),
        (
            ["evaluate", "--scene", "empty-goal", "--minutes", "3"],
            "minutes goes with matches alone: a drill has its own",
        ),
        (["export", "nope.replay", "--out", "a.html"], "soccer: nope.replay: no such file or directory\n"),
        (["export", "nope.replay", "--out", "a.svg"], "; .svg needs --maps: heat maps, pass networks, shot maps"),
        (["evaluate", "--picture"], "picture needs a folder"),
        (["evalaute"], "unknown command 'evalaute', did you mean 'evaluate'? known: evaluate, list"),
        (["list", "senses"], "unknown list 'senses', did you mean 'scenes'? known: leagues"),
        (["evaluate", "--home", "sacks-2000"], "unknown team 'sacks-2000', did you mean 'sacks-2001'? known: still"),
    ],
)
def test_a_mistake_is_one_line_and_exit_code_2(words: list[str], complaint: str, soccer: Any) -> None:
    assert complaint in soccer(*words, code=2)


def test_a_folder_that_cannot_be_made_is_one_line(tmp_path: Path, soccer: Any) -> None:
    (tmp_path / "file").write_text("")
    words = ["evaluate", "--home", "still", "--away", "still", "--out", tmp_path / "file" / "inside"]
    assert "not a directory" in soccer(*words, code=2)


NAMED = {
    "leagues": ("legged-2001", "middle-size-2006", "3 x 2 m", "family"), "scenes": ("kick-off", "family"),
    "teams": ("random", "still", "NAME@0.5", "family"), "observations": ("own_x", "ball_x", "73 numbers"),
    "rules": ("keeper_pushing", "simple"), "actions": ("forward", "discrete"), "rewards": ("progress", "sparse"),
}  # fmt: skip


@pytest.mark.parametrize("what", NAMED)
def test_lists_name_what_there_is(what: str, soccer: Any) -> None:
    text = soccer("list", what)
    assert all(word in text for word in NAMED[what])


@pytest.mark.parametrize("what", get_args(What))
def test_lists_are_json_when_asked(what: str, soccer: Any) -> None:
    found = json.loads(soccer("list", what, "--json"))
    assert found and all(table["title"] and table["rows"] for table in found)
    for table in found:
        assert all(isinstance(value, str) for row in table["rows"] for value in row.values())
        assert len({tuple(row) for row in table["rows"]}) == 1
    assert what != "scenes" or found[0]["rows"][0]["name"] == "kick-off"


def test_help_of_list_names_its_options_and_the_package_runs_as_the_command(tmp_path: Path) -> None:
    cases = (["list", "--help"], 0, "--league --observe --json observations"), (["evalute"], 2, "evaluate")
    for words, code, said in cases:
        run = [sys.executable, "-m", "soccer_env", *words]
        done = subprocess.run(run, capture_output=True, text=True, cwd=tmp_path)
        assert done.returncode == code and all(word in done.stdout + done.stderr for word in said.split())


def test_a_result_is_json_when_asked_and_nothing_else_is_printed(tmp_path: Path, soccer: Any) -> None:
    words = ["evaluate", "--home", "still", "--away", "still", "--players", "1", "--matches", "2", "--minutes", "0.02"]
    printed = soccer(*words, "--json", "--out", tmp_path / "[red]")
    assert json.loads(printed) == json.loads((tmp_path / "[red]" / "result.json").read_text())
    assert "--json" not in (tmp_path / "[red]" / "settings.json").read_text(), "the same run, shown in another way"


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_every_command_and_option_can_be_completed(shell: str, soccer: Any) -> None:
    text = soccer("--tyro-print-completion", shell)
    assert soccer(f"--print-completion={shell}") == text
    assert all(word in text for word in (*command_line.COMMANDS, "--at-least", "--critic-first", "--against"))


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")
@pytest.mark.parametrize(
    ("typed", "completed"),
    [("soccer eva", "evaluate"), ("soccer evaluate --mat", "--matches"), ("soccer evaluate --pose part", "particles")],
)
def test_bash_completes(typed: str, completed: str, tmp_path: Path, capsys: Any) -> None:
    main(["--print-completion", "bash"])
    (tmp_path / "completion").write_text(capsys.readouterr().out)
    asked = f"source {tmp_path / 'completion'}; COMP_WORDS=({typed}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))\n"
    run = ["bash", "-c", asked + '_tyro_soccer; printf "%s\\n" "${COMPREPLY[@]}"']
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(run, capture_output=True, text=True, env={**os.environ, "PATH": path})
    assert [line.split("\t")[0].split(" (")[0].strip() for line in done.stdout.splitlines()] == [completed], done.stderr


@pytest.mark.skipif(shutil.which("zsh") is None, reason="there is no zsh")
def test_zsh_completes_once_it_has_sourced_the_script(tmp_path: Path, soccer: Any) -> None:
    (tmp_path / "completion").write_text(soccer("--print-completion", "zsh"))
    asked = f"autoload -Uz compinit; compinit -u -d {tmp_path / 'dump'}; source {tmp_path / 'completion'}\n"
    asked += '_describe() { print -r -- "${(P)2}" }; words=(soccer eva); CURRENT=2; $_comps[soccer]'
    done = subprocess.run(["zsh", "-f", "-c", asked], capture_output=True, text=True)
    assert done.stdout.strip() == "evaluate:evaluate", done.stderr


def test_a_list_of_teams_runs_nothing_of_other_packages(monkeypatch: Any, capsys: Any) -> None:
    lions = {"lions": "canary_that_does_not_exist:team"}
    monkeypatch.setattr("soccer_env.teams.registered_teams", lambda: lions | registry.NAMES)
    found = registry.import_factory
    kept = lambda where: found(where) if "canary" not in where else pytest.fail(where)  # noqa: E731
    monkeypatch.setattr(registry, "import_factory", kept)
    for what in ("teams", "settings"):
        assert main(["list", what]) == 0
    assert "canary" not in capsys.readouterr().err


def test_each_team_is_listed_in_its_own_words(soccer: Any) -> None:
    (table,) = json.loads(soccer("list", "teams", "--json"))
    told = {row["name"]: row["what it is"] for row in table["rows"]}
    assert len(set(told.values())) == len(told)
    assert told["weigel-2001"].startswith("A variant of heinemann-2006: ")
    assert told["sacks-2001-tuned"].startswith("A variant of sacks-2001: ")
    assert told["sacks-2001"].startswith("sacks-2001: the legged team of the University of Pennsylvania")


def test_a_traceback_can_be_had(monkeypatch: Any) -> None:
    monkeypatch.setenv("SOCCER_ENV_TRACEBACK", "1")
    with pytest.raises(ValueError, match="unknown team"):
        main(["evaluate", "--home", "winners"])
