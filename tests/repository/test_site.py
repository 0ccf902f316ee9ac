"""The site: every package has a page in its reference, and it builds strictly from the pages where they lie."""

import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("mkdocs")
pytest.importorskip("material")
pytest.importorskip("mkdocstrings")

ROOT = Path(__file__).parents[2]
LINKED = (
    *("Makefile", "pyproject.toml", "mkdocs.yml", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "README.md"),
    *(".ci", "soccer_env", "baselines", "agents", "train"),
)


def test_every_package_stands_in_the_reference_with_all_its_modules() -> None:
    spec = importlib.util.spec_from_file_location("site_hook", ROOT / ".ci/site/hook.py")
    assert spec is not None and spec.loader is not None
    hook = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(hook)
    packages = dict(hook.packages())
    assert {"soccer_env", "soccer_env.belief.legged", "soccer_env.train.ppo"} <= set(packages)
    for name, folder in packages.items():
        page = hook.package_page(name, folder)
        assert f"::: {name}\n" in page
        for file in folder.glob("*.py"):
            assert (f"::: {name}.{file.stem}\n" in page) is not file.stem.startswith("__")
        assert f"[`{name}`]({name}.md) | {hook.first_line(folder / '__init__.py')} |" in hook.index_page()


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("make") is None, reason="needs make")
def test_the_site_builds_strictly(tmp_path: Path) -> None:
    for name in LINKED:
        (tmp_path / name).symlink_to(ROOT / name)
    subprocess.run(["make", "types"], cwd=tmp_path, check=True, capture_output=True)
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet"]
    environment = {**os.environ, "NO_MKDOCS_2_WARNING": "1"}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    home = (tmp_path / "site/index.html").read_text(encoding="utf-8")
    assert "soccer_env/pictures/match.gif" in home and (tmp_path / "site/soccer_env/pictures/match.gif").is_file()
    assert "fonts.googleapis.com" not in home
    reference = (tmp_path / "site/reference/soccer_env.belief.legged/index.html").read_text(encoding="utf-8")
    assert "Return the least area [px] of a ball" in reference  # the docstring of a compiled function
