"""What we use of other packages without their promise: their versions are bounded above, and it is still there."""

import re
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
PRIVATE = {  # what would be missed, and where
    "numba": "numba.core.caching._Cache and numba.core.codegen.JITCodeLibrary, in soccer_env/compiling/",
    "pymunk": "pymunk._chipmunk, in soccer_env/physics/",
    "tyro": "the boxes that errors are printed in, in train/command/command_line.py",
}


def numbers(text: str) -> tuple[int, ...]:
    return tuple(int(number) for number in re.findall(r"\d+", text))


@pytest.mark.parametrize("package", PRIVATE)
def test_the_version_is_bounded_above(package: str) -> None:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    (asked,) = (line for line in settings["project"]["dependencies"] if re.match(rf"{package}\b", line))
    bounds = re.fullmatch(rf"{package}>=([\d.]+),<([\d.]+)", asked)
    assert bounds, f"{asked!r} must have an upper bound, for the sake of {PRIVATE[package]}"
    assert numbers(bounds[1]) <= numbers(version(package)) < numbers(bounds[2])


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
