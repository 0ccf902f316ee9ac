"""The lock file of `make match` fits pyproject.toml, and says what may be downloaded to the last bit."""

import re
import sys
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
PYTHONS = ("3.10", "3.11", "3.12", "3.13")


def locked() -> list[tuple[Requirement, int]]:
    """Return the locked packages, each with how many files may be downloaded."""
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
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    project = settings["project"]
    wanted = [
        *project["dependencies"],
        *project["optional-dependencies"]["render"],
        *settings["build-system"]["requires"],
    ]
    for python in PYTHONS:
        found = {canonicalize_name(one.name): str(one.specifier)[2:] for one, _ in locked() if applies(one, python)}
        for need in map(Requirement, wanted):
            if applies(need, python):
                version = found.get(canonicalize_name(need.name))
                assert version is not None and version in need.specifier, f"{need} on {python}: make lock"


def test_dependencies_whose_private_parts_are_used_are_bound_above() -> None:
    """Those of pymunk, numba and tyro; and major versions of the two APIs."""
    needs = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["dependencies"]
    bound = {need.name for need in map(Requirement, needs) if any(one.operator == "<" for one in need.specifier)}
    assert bound >= {"pymunk", "numba", "tyro", "gymnasium", "pettingzoo"}
