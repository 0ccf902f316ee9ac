"""What we use of other packages without their promise: their versions are bounded above, and it is still there."""

import re
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PRIVATE = {  # the one file that may name what a package does not promise, and how that looks in an import
    "numba": ("soccer_env/compiling/numba_parts.py", r"numba\.(core|np)\b"),
    "pymunk": ("soccer_env/physics/engine/pymunk_parts.py", r"pymunk\._"),
    "tyro": ("train/command/parsing.py", r"tyro(\._| import _)"),
}
OF_SB3 = re.compile(r"\bmodel\._[a-z]|stable_baselines3\..*\._")  # what stable-baselines3 does not promise


def test_numba_still_has_the_class_that_our_cache_is_made_of() -> None:
    """Without it nothing of ours can be imported, hence no import of ours here."""
    from numba import njit
    from numba.core import caching

    where = f"numba {version('numba')} has no %s: see soccer_env/compiling/, and bound numba in pyproject.toml"
    for name in ("_Cache", "CompileResultCacheImpl"):
        assert hasattr(caching, name), where % f"core.caching.{name}"
    for name in ("reduce", "rebuild", "check_cachable"):
        assert hasattr(caching.CompileResultCacheImpl, name), where % f"CompileResultCacheImpl.{name}"
    assert "_cache" in vars(njit(lambda: None)), where % "Dispatcher._cache"
    asked_for = caching._Cache.__abstractmethods__
    assert asked_for <= {"cache_path", "load_overload", "save_overload", "enable", "disable", "flush"}, (
        f"numba {version('numba')} asks more of a cache than ours has: {sorted(asked_for)}"
    )


def test_one_file_of_each_names_what_is_private() -> None:
    for file in (file for top in ("soccer_env", "baselines", "agents", "train") for file in (ROOT / top).rglob("*.py")):
        text, name = file.read_text(encoding="utf-8"), file.relative_to(ROOT).as_posix()
        for where, pattern in PRIVATE.values():
            found = [line for line in text.splitlines() if re.match(rf"\s*(from|import) {pattern}", line)]
            assert not found or name == where, f"{name}: {found}"
        assert not OF_SB3.search(text), name


@pytest.mark.parametrize(
    ("gone", "module", "package"),
    [
        ("numba.core.ccallback", "soccer_env.compiling.numba_parts", "numba"),
        ("pymunk._chipmunk_cffi", "soccer_env.physics.engine.pymunk_parts", "pymunk"),
    ],
)
def test_a_version_that_lacks_a_part_is_named(gone: str, module: str, package: str) -> None:
    code = f"import sys, importlib, {package}; sys.modules[{gone!r}] = None; importlib.import_module({module!r})"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    last = ran.stderr.strip().splitlines()[-1]
    assert last.startswith(f"ImportError: {package} {version(package)} is not a version that soccer_env knows"), last
