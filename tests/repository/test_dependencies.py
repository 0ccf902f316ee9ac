"""What others make: versions are locked, bounded above where we use private parts, and those parts are still there."""

import re
import sys
from importlib.metadata import version
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
SETTINGS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT = SETTINGS["project"]
PYTHONS = ("3.10", "3.11", "3.12", "3.13")
BOUND = {  # what would be missed, and where
    "numba": "soccer_env/compiling/numba_parts.py",
    "pymunk": "soccer_env/physics/engine/pymunk_parts.py",
    "tyro": "train/command/parsing.py",
    "gymnasium": "the API of its major version",
    "pettingzoo": "the API of its major version",
}


def locked() -> list[tuple[Requirement, int]]:
    text = (ROOT / "requirements.lock").read_text(encoding="utf-8").replace("\\\n", " ")
    lines = [line.split("--hash=sha256:") for line in text.splitlines() if line]
    for _, *hashes in lines:
        assert all(re.fullmatch(r"[0-9a-f]{64} *", one) for one in hashes)
    return [(Requirement(line.strip()), len(hashes)) for line, *hashes in lines]


def applies(requirement: Requirement, python: str) -> bool:
    environment = {"python_version": python, "python_full_version": f"{python}.1", "extra": ""}
    return requirement.marker is None or requirement.marker.evaluate(environment)


def test_every_package_has_one_version_and_hashes() -> None:
    for python in PYTHONS:
        names = [canonicalize_name(one.name) for one, _ in locked() if applies(one, python)]
        assert len(set(names)) == len(names)
    assert all(re.fullmatch(r"==[^,*]+", str(one.specifier)) and hashes for one, hashes in locked())


def test_what_the_package_needs_is_locked_within_its_bounds() -> None:
    wanted = [*PROJECT["dependencies"], *PROJECT["optional-dependencies"]["render"]]
    wanted += SETTINGS["build-system"]["requires"]
    for python in PYTHONS:
        found = {canonicalize_name(one.name): str(one.specifier)[2:] for one, _ in locked() if applies(one, python)}
        for need in map(Requirement, wanted):
            if applies(need, python):
                version = found.get(canonicalize_name(need.name))
                assert version is not None and version in need.specifier, f"{need} on {python}: make lock"


@pytest.mark.parametrize("package", BOUND)
def test_the_version_is_bounded_above(package: str) -> None:
    (asked,) = (need for need in map(Requirement, PROJECT["dependencies"]) if need.name == package)
    operators = sorted(one.operator for one in asked.specifier)
    assert operators == ["<", ">="], f"'{asked}' must have an upper bound, for the sake of {BOUND[package]}"
    assert version(package) in asked.specifier
