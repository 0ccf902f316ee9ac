"""The wheel holds everything under its right name, and works beside files that would shadow bare names."""

import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
SETTINGS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
FOLDERS = {"soccer_env": "soccer_env", **SETTINGS["tool"]["setuptools"]["package-dir"]}

NOT_INSTALLED = "soccer_env/train/pages/"
# Where a name was imported from, one line each.
PROGRAM = """
import soccer_env, soccer_env.train, soccer_env.agents, soccer_env.baselines
for module in (soccer_env, soccer_env.train, soccer_env.agents, soccer_env.baselines):
    print(module.__file__)
"""
NOT_EDITABLE = "sys.meta_path[:] = [f for f in sys.meta_path if 'Editable' not in getattr(f, '__name__', '')]"


def run(*command: str, cwd: Path, **variables: str) -> str:
    """Run a command and return what it printed; its errors are the assertion's message."""
    environment = {**os.environ, **variables}
    done = subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{' '.join(command)}\n{done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the wheel from a copy, so that no build folder of the checkout leaks in or is left behind."""
    source = tmp_path_factory.mktemp("source")
    for name in ("pyproject.toml", "README.md", "LICENSE", "MANIFEST.in"):
        shutil.copy(ROOT / name, source)
    for folder in FOLDERS.values():
        shutil.copytree(ROOT / folder, source / folder, ignore=shutil.ignore_patterns("__pycache__"))
    target = tmp_path_factory.mktemp("wheel")
    options = (
        "--log", str(target / "log"), "--no-deps", "--no-build-isolation", "--no-index", "--wheel-dir", str(target),
    )  # fmt: skip
    run(sys.executable, "-m", "pip", "wheel", *options, str(source), cwd=source)
    (built,) = target.glob("soccer_env-*.whl")
    return built


def files_on_disk() -> set[str]:
    """Return the modules of the checkout by the path that they have once installed."""
    return {
        "/".join([*package.split("."), *file.relative_to(ROOT / folder).parts])
        for package, folder in FOLDERS.items()
        for file in (ROOT / folder).rglob("*.py")
    }


def installed() -> set[str]:
    """Return the modules that the wheel holds: all but what makes the pages of the repository."""
    return {file for file in files_on_disk() if not file.startswith(NOT_INSTALLED)}


def test_the_top_level_holds_what_was_agreed() -> None:
    if not (ROOT / ".git").exists():
        pytest.skip("no checkout")
    tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    folders = {path.split("/")[0] for path in tracked.split("\0") if "/" in path}
    assert folders == {".ci", "soccer_env", "baselines", "agents", "train", "tests"}, "a run wrote into the checkout?"


@pytest.mark.skipif(shutil.which("make") is None, reason="needs make")
def test_types_are_checked_in_every_folder(tmp_path: Path) -> None:
    for name in ("Makefile", "pyproject.toml", *FOLDERS.values()):
        (tmp_path / name).symlink_to(ROOT / name)
    for _ in range(2):  # the second time over what the first has left
        run("make", "types", cwd=tmp_path)
    checked, _ = SETTINGS["tool"]["mypy"]["files"]
    walk = os.walk(tmp_path / checked, followlinks=True)
    files = {Path(folder, name) for folder, _, names in walk for name in names if name.endswith(".py")}
    assert {file.relative_to((tmp_path / checked).parent).as_posix() for file in files} == files_on_disk()


def test_every_package_is_listed() -> None:
    listed = SETTINGS["tool"]["setuptools"]["packages"]
    with_modules = {file.rpartition("/")[0].replace("/", ".") for file in installed()}
    with_init = {file.rpartition("/")[0].replace("/", ".") for file in installed() if file.endswith("/__init__.py")}
    assert with_modules == with_init, "a folder with modules lacks __init__.py"
    assert sorted(listed) == sorted(with_init), "[tool.setuptools] packages in pyproject.toml differs from the folders"


def test_wheel_holds_the_package_and_its_pages_but_no_pictures_and_nothing_else(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {name for name in names if name.endswith(".py")} == installed()
    assert {"soccer_env/py.typed", "soccer_env/REFERENCES.md"} <= names
    page = [file for file in (ROOT / "soccer_env/shows/browser").iterdir() if file.is_file() and file.suffix != ".py"]
    assert page and {f"soccer_env/shows/browser/{file.name}" for file in page} <= names
    assert {name.split("/")[0].split("-")[0] for name in names} == {"soccer_env"}
    (entry_points,) = (name for name in names if name.endswith(".dist-info/entry_points.txt"))
    assert "soccer = soccer_env.train.command.command_line:main" in zipfile.ZipFile(wheel).read(entry_points).decode()
    folders = (
        "", "perception/", "baselines/", "baselines/heinemann_2006/", "baselines/sacks_2001/",
        "baselines/weigel_2001/", "agents/policies/", "train/",
    )  # fmt: skip
    assert {f"soccer_env/{folder}README.md" for folder in folders} <= names
    assert [name for name in names if "/pictures/" in name] == []
    assert wheel.stat().st_size < 1_700_000


def test_setuptools_has_no_objection(wheel: Path) -> None:
    said = (wheel.parent / "log").read_text(encoding="utf-8")
    assert "creating" in said
    assert [line for line in said.splitlines() if "absent from" in line or "Deprecat" in line or "!!" in line] == []


def test_the_source_archive_holds_every_tracked_file(tmp_path: Path) -> None:
    if not (ROOT / ".git").exists():
        pytest.skip("no checkout")
    asked = ("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard")
    files = {path for path in run(*asked, cwd=ROOT).split("\0") if path and (ROOT / path).is_file()}
    for path in files:
        (tmp_path / "source" / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / path, tmp_path / "source" / path)
    build = f"from setuptools import build_meta; build_meta.build_sdist({str(tmp_path)!r})"
    run(sys.executable, "-c", build, cwd=tmp_path / "source")
    (archive,) = tmp_path.glob("soccer_env-*.tar.gz")
    with tarfile.open(archive) as tar:
        held = {member.name.partition("/")[2] for member in tar.getmembers() if member.isfile()}
    assert files - held == set()
    made = {"PKG-INFO", "setup.cfg"}
    assert {name for name in held - files - made if not name.startswith("soccer_env.egg-info/")} == set()


def test_wheel_works_beside_files_of_the_same_names(wheel: Path, tmp_path: Path) -> None:
    installed = tmp_path / "installed"
    zipfile.ZipFile(wheel).extractall(installed)
    found = run(sys.executable, "-c", PROGRAM, cwd=decoys(tmp_path / "research"), PYTHONPATH=str(installed)).split()
    assert [Path(file).relative_to(installed).as_posix() for file in found] == [
        f"soccer_env/{folder}__init__.py" for folder in ("", "train/", "agents/", "baselines/")
    ]


def test_a_script_in_the_root_of_a_checkout_works_without_an_editable_install(tmp_path: Path) -> None:
    for folder in FOLDERS.values():
        (tmp_path / folder).symlink_to(ROOT / folder)
    script = tmp_path / "first.py"
    script.write_text(f"import sys\n{NOT_EDITABLE}\n{PROGRAM}", encoding="utf-8")
    found = run(sys.executable, str(script), cwd=tmp_path).split()
    assert [Path(file).relative_to(tmp_path).as_posix() for file in found] == [
        "soccer_env/__init__.py", "train/__init__.py", "agents/__init__.py", "baselines/__init__.py",
    ]  # fmt: skip


def decoys(folder: Path) -> Path:
    """Make a folder like a research repository, whose modules must never be imported in our place."""
    for name in ("train.py", "agents/__init__.py", "baselines/__init__.py"):
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("raise ImportError('the wrong module')\n", encoding="utf-8")
    return folder
