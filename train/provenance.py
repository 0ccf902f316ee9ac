"""The provenance of a result: versions, and hashes of the code and of the teams."""

import datetime
import hashlib
import importlib.metadata
import json
import platform
import subprocess
import sys
from collections.abc import Iterable
from typing import Any

import numpy as np

from soccer_env.compiling.sources import ROOT, source_file, source_hashes
from soccer_env.guards.names import MODULE_PATH
from soccer_env.leagues import LEAGUES
from soccer_env.leagues.league import League
from soccer_env.teams import CompiledTeam, Team, make_team
from soccer_env.types import WORLD

LIBRARIES = ("soccer_env", "pymunk", "numba", "numpy")
DIGITS = 12  # of a hash, in hexadecimal
UNKNOWN = "unknown"  # in place of the hash of a team whose state cannot be hashed


def module_hashes(names: Iterable[str]) -> dict[str, str]:
    """Return a hash of the code of each module that a name of the form MODULE:NAME refers to, by module."""
    paths = {MODULE_PATH.fullmatch(name.partition("@")[0]) for name in names}
    modules = {path[1] for path in paths if path is not None and path[1] in sys.modules}
    return {module: module_hash(module) for module in sorted(modules)}


def made_with(league: League, home: str | Team, away: str | Team) -> dict[str, str]:
    """Return the versions and hashes on which matches depend: code, the two teams and the league."""
    versions = {name: version_of(name) for name in LIBRARIES} | {"world": str(WORLD)}
    hashes = {"code": module_hash("soccer_env.match.match"), "home_team": team_hash(home), "away_team": team_hash(away)}
    own = {} if LEAGUES.get(league.name) is league else {"league": digest(league.in_full())}
    return {**versions, **hashes, **own}


def play_facts() -> dict[str, str]:
    """Return versions, machine and world: where they agree, the same match ends in the same state."""
    versions = {name: version_of(name) for name in LIBRARIES[1:]}
    return {**versions, "machine": f"{platform.system()} {platform.machine()}", "world": str(WORLD)}


def version_of(package: str) -> str:
    """Return the version of an installed package without importing it."""
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return str(getattr(sys.modules.get(package), "__version__", "not installed"))


def module_hash(module: str) -> str:
    """Return a hash over a module and all files of the package that it imports; "" for a module without a file."""
    path = source_file(module, module)
    return digest("".join(sorted(source_hashes(module, path).values()))) if path else ""


def team_hash(team: str | Team) -> str:
    """Return a hash of a team: its code and its state; UNKNOWN if the state cannot be hashed.

    A team object may have a text `fingerprint`, which then replaces its state.
    """
    found = make_team(team)
    if isinstance(found, CompiledTeam):
        code = "".join(module_hash(module) for module in sorted(modules_of(found.kernel) | {type(found).__module__}))
        kept = [found.name, str(found.memory_dtype), hashlib.sha256(found.settings.tobytes()).hexdigest()]
        return digest(code + json.dumps(kept))
    state = getattr(found, "fingerprint", None) or state_of(found)
    if state is None and isinstance(team, str):
        state = team  # a name has the strength and the settings in it
    return UNKNOWN if state is None else digest(module_hash(type(found).__module__) + f"{type(found).__name__} {state}")


def modules_of(function: Any) -> set[str]:
    """Return the modules that define a function and the functions in its closure."""
    plain = getattr(function, "py_func", function)
    inner = [cell.cell_contents for cell in getattr(plain, "__closure__", None) or ()]
    return {plain.__module__}.union(*(modules_of(one) for one in inner if hasattr(one, "__module__") and callable(one)))


def state_of(team: Any) -> str | None:
    """Return the attributes of a team object as text; None if any is neither a plain value nor an array."""
    try:
        return json.dumps(vars(team), sort_keys=True, default=as_text)
    except (TypeError, ValueError):  # an object of another kind, no attributes to look at, a circle
        return None


def as_text(value: Any) -> list[str]:
    """Return texts that identify an array (dtype, shape, hash) or a dtype; TypeError for any other object."""
    if isinstance(value, np.dtype):
        return [str(value)]
    if not isinstance(value, (np.ndarray, np.generic)) or value.dtype.hasobject:
        raise TypeError(f"not a plain value: {value!r}")
    return [str(value.dtype), str(value.shape), hashlib.sha256(value.tobytes()).hexdigest()]


def check_team_hashes(made: dict[str, str]) -> None:
    """Raise ValueError for a team without a hash: a folder could mistake another team's results for its own."""
    if UNKNOWN in made.values():
        raise ValueError(
            "a team keeps what cannot be compared with another run's: give it a `fingerprint` (of team_of_function, "
            "or an attribute of an object), a text that changes with how it plays, or evaluate without out"
        )


def date_and_commit() -> dict[str, str]:
    """Return the present date and commit."""
    return {"date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(), "commit": commit()}


def digest(text: str) -> str:
    """Return a short hash of a text."""
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]


def settings_hash(conditions: dict[str, Any], made: dict[str, str]) -> str:
    """Return the hash of settings that every line of a result carries, so that lines of other settings are refused."""
    return digest(json.dumps([conditions, made], sort_keys=True))


def commit() -> str:
    """Return the commit of the checkout that this code runs from, with "+" if tracked files differ; "" without git."""
    if not (ROOT.parent / ".git").exists():
        return ""
    try:
        name = _git("rev-parse", "--short", "HEAD")
        return name + ("+" if name and _git("status", "--porcelain", "--untracked-files=no") else "")
    except (OSError, subprocess.SubprocessError):
        return ""


def _git(*words: str) -> str:
    done = subprocess.run(["git", *words], cwd=ROOT.parent, capture_output=True, text=True, timeout=10, check=False)
    return done.stdout.strip() if done.returncode == 0 else ""
