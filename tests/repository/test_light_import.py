"""Importing the package takes in nothing heavy that only training, pictures or windows need."""

import subprocess
import sys
from pathlib import Path

import pytest

HEAVY = ("torch", "stable_baselines3", "matplotlib", "scipy", "pygame")


@pytest.mark.parametrize("statement", ["import soccer_env", "from soccer_env import Match, make_team, soccer_v0"])
def test_import_is_light(statement: str, tmp_path: Path) -> None:
    # numba looks at scipy's version, where scipy is installed, as it is imported: that much is not ours.
    program = (
        "import numba, sys\n"
        "before = set(sys.modules)\n"
        f"{statement}\n"
        f"print(sorted(name for name in set(sys.modules) - before if name.split('.')[0] in {HEAVY!r}))"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert run.stdout.strip() == "[]"
