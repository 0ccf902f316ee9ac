"""Where a training's settings come from: a file, flags that overrule it, modules of one's own; errors in one line."""

import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from soccer_env.agents.policy_file import load
from soccer_env.compiling import sources as stamps
from soccer_env.train.command.parsing import read_settings
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.toml_file import settings_of
from tests.train.ppo.staged_training import ROLLOUT, tiny_settings, train_plainly

ROOT = Path(__file__).parents[3]


def test_a_file_gives_settings_and_flags_overrule_it(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('steps = 77\nminutes = 1\nmirror = false\nhidden = "8"\nout = "there"\n')
    found = settings_of(path)
    assert found == TrainSettings(steps=77, minutes=1, mirror=False, hidden="8", out=Path("there"))
    again = read_settings(TrainSettings, ["--steps", "88", "--mirror"], "train", found)
    assert again == replace(found, steps=88, mirror=True)
    path.write_text('hidden = [32, 16]\nplayers = ["1v1", "2v2"]\n')  # lists are texts with commas
    assert (settings_of(path).hidden_sizes, settings_of(path).sizes) == ((32, 16), ((1, 1), (2, 2)))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("step = 3\n", "unknown setting 'step', did you mean 'steps'\\? known: league, players, opponents, steps"),
        ('steps = "many"\n', "steps must be a whole number of at least 0, got 'many'"),
        ("mirror = 1\n", "mirror must be True or False, got 1"),
        ("out = 3\n", "out must be a path, got 3"),
        ("steps = -1\n", "steps must be a whole number of at least 0"),
        ('observe = "x-rays"\n', "observe must be one of belief"),
        ("anew = true\n", "anew is for the command line"),
        ("steps 3\n", "cannot be read: "),
        ("name = '\udcff'\n", "cannot be read: "),
        ("a = " + "[" * 5000, "cannot be read: maximum recursion depth"),
        (".".join("a" * 100_000) + " = 1", "cannot be read: has 200003 bytes, more than the limit of 16384"),
        (".".join("a" * 8000) + " = 1", "unknown setting 'a'"),
    ],
)
def test_a_wrong_file_is_named(tmp_path: Path, content: str, message: str) -> None:
    path = tmp_path / "mine.toml"
    path.touch()
    assert settings_of(path) == TrainSettings()
    path.write_bytes(content.encode(errors="surrogateescape"))
    with pytest.raises(ValueError, match=f"mine.toml: {message}|mine.toml {message}"):
        settings_of(path)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--config"], "--config needs a file"),
        (["--config", "nowhere.toml"], "nowhere.toml cannot be read: "),
        (["--config", "."], "cannot be read: "),
        (["--config", "/dev/zero"], "/dev/zero cannot be read: is not a regular file"),
        (["--steps", "-1"], "steps must be a whole number of at least 0, got -1"),
        (["--learning-rate", "nan"], "learning_rate must be a number above 0 and at most 1, got nan"),
        (["--opponent", "still"], "unknown option '--opponent'"),
    ],
)
def test_a_wrong_command_is_one_line(words: list[str], message: str, soccer: Any) -> None:
    assert message in soccer("train", *words, code=2)


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


pytest.importorskip("stable_baselines3")

MINE = """
from dataclasses import replace
import numpy as np
from soccer_env import OwnTerm, Rewards, Scene, team_of_function
from soccer_env.leagues import find_league

legged = find_league("legged-2001")
ICY = replace(legged, name="icy", ball=replace(legged.ball, rolling=0.05))
asked = []


def touched(match):
    asked.append("reward")
    return match.robot_events["touch"].astype(float)


def beside(league, ball, robots, draw):
    asked.append("scene")
    ball["x"] = 0.5


def ahead(observations):
    asked.append("team")
    actions = np.zeros((*observations.shape[:2], 4))
    actions[..., 0] = 1.0
    return actions


PAID = Rewards.only(goal=3.0, extra={"touch": touched})
BESIDE = Scene("beside", "the ball ahead", place=beside, in_play=True)
team = team_of_function(ahead, action_repeat=4, fingerprint="1")
"""
OWN = {
    "league": "own_parts:ICY", "rewards": "own_parts:PAID", "scenes": "kick-off:0.5,own_parts:BESIDE:0.5",
    "opponents": "still,own_parts:team", "evaluate_against": "own_parts:team",
}  # fmt: skip


@pytest.fixture
def mine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    (tmp_path / "own_parts.py").write_text(MINE)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    yield tmp_path
    sys.modules.pop("own_parts", None)


def test_all_parts_of_ones_own_are_trained_with(mine: Path) -> None:
    result = train_plainly(tiny_settings(mine / "run", **OWN, steps=2 * ROLLOUT))
    asked = sys.modules["own_parts"].asked
    assert {"reward", "scene", "team"} == set(asked)
    assert result.steps >= 2 * ROLLOUT
    assert load(mine / "run" / "last.safetensors").league == "icy"
    assert result.evaluations[-1]["rows"][0]["opponent"] == "own_parts:team"
    (mine / "own_parts.py").write_text(MINE.replace("rolling=0.05", "rolling=0.0625"))
    for kept in (stamps.source_hashes, stamps._hash_and_imports):  # once per process, and this is to be the next
        kept.cache_clear()
    with pytest.raises(ValueError, match="own_parts"):
        train_plainly(tiny_settings(mine / "run", **OWN, steps=3 * ROLLOUT))
