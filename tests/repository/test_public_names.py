"""The public names: importing them is light, and all are there; what a type checker says of them: typed_user.py."""

import subprocess
import sys
from pathlib import Path

import pytest

import soccer_env

ROOT = Path(__file__).parents[2]
HEAVY = ("torch", "stable_baselines3", "matplotlib", "scipy", "pygame")


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


def test_dir_lists_what_can_be_imported() -> None:
    assert {*soccer_env.__all__} <= {*dir(soccer_env)}
    assert all(getattr(soccer_env, name) is not None for name in soccer_env.__all__)
    with pytest.raises(AttributeError, match="module 'soccer_env' has no attribute 'Mach'"):
        soccer_env.Mach  # noqa: B018
