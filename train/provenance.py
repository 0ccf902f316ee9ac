"""What a result was made with: versions, and hashes of the code and of the teams that played."""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import subprocess
import sys
from typing import Any

from soccer_env.compiled_sources import ROOT, file_of, sources
from soccer_env.leagues import LEAGUES
from soccer_env.leagues.league import League
from soccer_env.teams import ObservingTeam, Team, make_team, parse_team, registered

LIBRARIES = ("soccer_env", "pymunk", "numba", "numpy")
DIGITS = 12  # of a hash, in hexadecimal


def made_with(league: League, home: str | Team, away: str | Team) -> dict[str, str]:
    """Return what must be the same for matches to be the same: versions, code, the two teams and the league."""
    versions = {name: version_of(name) for name in LIBRARIES}
    hashes = {"code": module_hash("soccer_env.match"), "home_team": team_hash(home), "away_team": team_hash(away)}
    own = {} if LEAGUES.get(league.name) is league else {"league": digest(repr(league))}
    return {**versions, **hashes, **own}


def version_of(package: str) -> str:
    """Return the version of an installed package without importing it."""
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return str(getattr(sys.modules.get(package), "__version__", "not installed"))


def module_hash(module: str) -> str:
    """Return one hash over a module and every file of the package that it imports, "" without a file."""
    path = file_of(module, module)
    return digest("".join(sorted(sources(module, path).values()))) if path else ""


def team_hash(team: str | Team) -> str:
    """Return a hash of what a team is: its module and what that imports, and the numbers of a learned one."""
    found = make_team(team)
    if isinstance(found, ObservingTeam):
        return digest(module_hash(type(found).__module__) + hashlib.sha256(found.settings.tobytes()).hexdigest())
    if not isinstance(team, str):
        return module_hash(type(team).__module__)
    name, _, _ = parse_team(team)
    return module_hash(registered().get(name, name).partition(":")[0])


def digest(text: str) -> str:
    """Return a short hash of a text."""
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]


def settings_hash(conditions: dict[str, Any], made: dict[str, str]) -> str:
    """Return the hash that every line of a result carries, so that lines of other settings are never mixed in."""
    return digest(json.dumps([conditions, made], sort_keys=True))


def commit() -> str:
    """Return the commit of the checkout that this package runs from, "+" added if files differ; "" without one."""
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
