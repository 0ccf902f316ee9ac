"""Where a training's settings come from: a file, and flags that overrule it; what is wrong is named in one line."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from soccer_env.train.command.command_line import main
from soccer_env.train.command.parsing import read_settings
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.toml_file import settings_of

ROOT = Path(__file__).parents[3]


def test_a_file_gives_settings_and_flags_overrule_it(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('steps = 77\nminutes = 1\nmirror = false\nhidden = "8"\nout = "there"\n')
    found = settings_of(path)
    assert found == TrainSettings(steps=77, minutes=1, mirror=False, hidden="8", out=Path("there"))
    again = read_settings(TrainSettings, ["--steps", "88", "--mirror"], "train", found)
    assert again == replace(found, steps=88, mirror=True)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", None),
        ("step = 3\n", "unknown setting 'step', did you mean 'steps'\\? known: league, players, opponents, steps"),
        ("[training]\nsteps = 3\n", "unknown setting 'training'"),
        ('steps = "many"\n', "steps must be a whole number of at least 0, got 'many'"),
        ("steps = 3.0\n", "steps must be a whole number of at least 0, got 3.0"),
        ("mirror = 1\n", "mirror must be True or False, got 1"),
        ('minutes = "2"\n', "minutes must be a number above 0 and below 10000, got '2'"),
        ("hidden = 64\n", "hidden must be a text"),
        ("out = 3\n", "out must be a path, got 3"),
        ("steps = -1\n", "steps must be a whole number of at least 0"),
        ("gamma = nan\n", "gamma must be a number above 0"),
        ('observe = "x-rays"\n', "observe must be one of belief"),
        ("anew = true\n", "anew is for the command line"),
        ("steps 3\n", "cannot be read: "),
        ("steps = 3\nsteps = 4\n", "cannot be read: "),
        ("name = '\udcff'\n", "cannot be read: "),
        ("a = " + "[" * 5000, "cannot be read: maximum recursion depth"),
        (".".join("a" * 100_000) + " = 1", "cannot be read: has 200003 bytes, more than the limit of 16384"),
        (".".join("a" * 8000) + " = 1", "unknown setting 'a'"),
    ],
)
def test_a_wrong_file_is_named(tmp_path: Path, content: str, message: str | None) -> None:
    path = tmp_path / "mine.toml"
    path.write_bytes(content.encode(errors="surrogateescape"))
    if message is None:
        assert settings_of(path) == TrainSettings()
        return
    with pytest.raises(ValueError, match=f"mine.toml: {message}|mine.toml {message}"):
        settings_of(path)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--config"], "--config needs a file"),
        (["--config", "nowhere.toml"], "nowhere.toml cannot be read: "),
        (["--config=nowhere.toml"], "nowhere.toml cannot be read: "),
        (["--config", "."], "cannot be read: "),
        (["--config", "/dev/zero"], "/dev/zero cannot be read: is not a regular file"),
        (["--steps", "-1"], "steps must be a whole number of at least 0, got -1"),
        (["--learning-rate", "nan"], "learning_rate must be a number above 0 and at most 1, got nan"),
        (["--decay", "maybe"], "maybe"),
        (["--opponent", "still"], "unknown option '--opponent'"),
        (["--observe", "x-rays"], "--observe"),
    ],
)
def test_a_wrong_command_is_one_line(words: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["train", *words]) == 2
    said = capsys.readouterr().err
    assert message in said and said.startswith("soccer: ") and said.count("\n") == 1


MISSING = """
import sys
from soccer_env.train.command.command_line import main

class Missing:
    @staticmethod
    def find_spec(name, path=None, target=None):
        if name.partition(".")[0] == missing:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

sys.meta_path.insert(0, Missing)
for missing in ("torch", "stable_baselines3", "openskill"):
    for name in list(sys.modules):  # whatever order they are imported in
        if name.partition(".")[0] == missing or name.startswith("soccer_env.train.ppo"):
            del sys.modules[name]
    print(main(["train", "--steps", "1"]), file=sys.stderr)
"""


@pytest.mark.slow
def test_a_missing_package_is_said_with_what_installs_it(tmp_path: Path) -> None:
    said = subprocess.run([sys.executable, "-c", MISSING], capture_output=True, text=True, cwd=ROOT, check=True).stderr
    lines = said.splitlines()
    assert lines[1::2] == ["2", "2", "2"], said
    for line, missing in zip(lines[::2], ("torch", "stable_baselines3", "openskill")):
        assert 'pip install "soccer_env[train]"' in line and missing in line


def test_lists_of_a_file_are_texts_with_commas(tmp_path: Path) -> None:
    file = tmp_path / "run.toml"
    file.write_text('hidden = [32, 16]\nplayers = ["1v1", "2v2"]\n')
    settings = settings_of(file)
    assert settings.hidden_sizes == (32, 16) and settings.sizes == ((1, 1), (2, 2))
