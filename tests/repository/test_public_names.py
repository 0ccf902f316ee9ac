"""The public names: importing them is light, and a type checker knows them and refuses a wrong setting."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import soccer_env

ROOT = Path(__file__).parents[2]
HEAVY = ("torch", "stable_baselines3", "matplotlib", "scipy", "pygame")
USER = """
from soccer_env import Match, soccer_v0

match = Match("legged-2001", home=2, senses="ideal")
reveal_type(match)
reveal_type(soccer_v0.parallel_env(home=1))
Match(homee=2)
Match(home="two")
Match(senses="sensor")
soccer_v0.parallel_env(render_modes="human")
soccer_v0.parallel_env(render_mode="humn")
soccer_v0.parallel_env(infos="flatt")
Match(observe="thruth")
Match(rewards="sprase")
"""


@pytest.mark.parametrize(
    ("statement", "heavy"),
    [
        ("import soccer_env", HEAVY),
        ("from soccer_env import Match, make_team, soccer_v0", HEAVY),
        ("from soccer_env.train.ppo import train", ("numba", "torch")),
        ("import soccer_env.train.papers.settings", ("numba", "pymunk", "scipy", "matplotlib")),
    ],
)
def test_import_is_light(statement: str, heavy: tuple[str, ...], tmp_path: Path) -> None:
    # numba looks at scipy's version, where scipy is installed, as it is imported: that much is not ours.
    program = (
        f"import sys{'' if 'numba' in heavy else ', numba'}\nbefore = set(sys.modules)\n"
        f"{statement}\n"
        f"print(sorted(name for name in set(sys.modules) - before if name.split('.')[0] in {heavy!r}))"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert run.stdout.strip() == "[]"


@pytest.mark.slow
@pytest.mark.whole
def test_mypy_knows_the_public_names_and_refuses_wrong_settings(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    (tmp_path / "user.py").write_text(USER)
    words = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), "user.py"]
    seen = {**os.environ, "MYPYPATH": str(ROOT)}  # type checkers do not follow an editable install
    ran = subprocess.run(words, cwd=tmp_path, env=seen, capture_output=True, text=True, check=False)
    said = ran.stdout.splitlines()
    found = {int(line.split(":")[1]): line for line in reversed(said) if line.split(":")[0].endswith("user.py")}
    assert 'Revealed type is "soccer_env.match.match.Match"' in found[5]
    assert 'Revealed type is "soccer_env.soccer_v0.ParallelSoccer"' in found[6]
    assert 'Unexpected keyword argument "homee" for "Match"; did you mean "home"?' in found[7]
    assert 'Argument "home" to "Match" has incompatible type "str"' in found[8]
    assert 'Argument "senses" to "Match" has incompatible type "Literal[' in found[9]
    assert 'Unexpected keyword argument "render_modes"' in found[10]
    for line, name in enumerate(("render_mode", "infos", "observe", "rewards"), start=11):
        assert f'Argument "{name}" to ' in found[line] and "has incompatible type" in found[line]


def test_dir_lists_what_can_be_imported() -> None:
    assert {*soccer_env.__all__} <= {*dir(soccer_env)}
    assert all(getattr(soccer_env, name) is not None for name in soccer_env.__all__)
    with pytest.raises(AttributeError, match="module 'soccer_env' has no attribute 'Mach'"):
        soccer_env.Mach  # noqa: B018
