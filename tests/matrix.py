"""Run the quick tests on each supported Python of this machine, with the oldest and the newest dependencies.

`make matrix` does so. Each pair has an environment with its own compiled code under build/matrix/. torch, whose
builds are large, stays out: tests of training skip themselves. Words after the file's name replace the tests.
"""

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
PYTHONS = ("3.10", "3.11", "3.12", "3.13")
RESOLUTIONS = {"oldest": "lowest-direct", "newest": "highest"}
UV = (sys.executable, "-m", "uv", "--quiet", "pip")
NEEDS = ("pyproject.toml", "--extra", "dev", "--extra", "render", "--only-binary", ":all:", "--no-header", "--upgrade")
SHOWN = ("pymunk", "numba", "numpy", "gymnasium", "pettingzoo")


def interpreter(version: str) -> str | None:
    """Return the interpreter of a version that starts: the one on the PATH, or one of pyenv."""
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    found = [shutil.which(f"python{version}"), *sorted(pyenv.glob(f"versions/{version}.*/bin/python"))]
    for path in filter(None, found):
        if subprocess.run([path, "-c", ""], capture_output=True).returncode == 0:  # pyenv's shims may not start
            return str(path)
    return None


def install(folder: Path, base: str, resolution: str) -> str:
    python = str(folder / "bin/python")
    locked = str(folder / "requirements.txt")
    if not Path(python).exists():
        subprocess.run([base, "-m", "venv", str(folder)], check=True)
    for words in (
        ("compile", *NEEDS, "--python", python, "--resolution", resolution, "--output-file", locked),
        ("sync", "--python", python, locked),
        ("install", "--python", python, "--no-deps", "--no-build-isolation", "--editable", "."),
    ):
        subprocess.run([*UV, *words], check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
    return python


def versions(folder: Path) -> str:
    lines = (folder / "requirements.txt").read_text(encoding="utf-8").splitlines()
    locked = dict(line.split("==") for line in lines if "==" in line and not line.startswith(" "))
    return ", ".join(f"{name} {locked[name]}" for name in SHOWN)


def run_environments(tests: list[str]) -> Iterator[tuple[str, bool]]:
    """Yield a line for each environment, and whether its tests passed."""
    for version in PYTHONS:
        base = interpreter(version)
        if base is None:
            yield f"{version}: not on this machine", True
            continue
        for age, resolution in RESOLUTIONS.items():
            folder = ROOT / "build/matrix" / f"{version}-{age}"
            python = install(folder, base, resolution)
            where = f"{version} {age}: {versions(folder)}"
            print(f"== {where}", flush=True)
            environment = os.environ | {"SOCCER_ENV_CACHE": str(folder / "compiled")}
            passed = subprocess.run([python, "-m", "pytest", *tests], cwd=ROOT, env=environment).returncode == 0
            yield f"{where}: {'passed' if passed else 'FAILED'}", passed


def main(tests: list[str]) -> int:
    played = list(run_environments(tests or ["-n", "auto", "--dist", "worksteal", "@tests/quick.txt"]))
    print("\n".join(line for line, _ in played))
    return 0 if all(passed for _, passed in played) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
