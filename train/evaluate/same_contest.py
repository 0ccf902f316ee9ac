"""What a folder of results says, read without a change to it, and the contest that it tells of, made again."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from soccer_env.guards.checking import brief
from soccer_env.guards.names import MODULE_PATH
from soccer_env.leagues import LEAGUES, find_league
from soccer_env.leagues.league import League
from soccer_env.scenes import names_in
from soccer_env.teams import Team, in_module
from soccer_env.train.evaluate.contest import Contest, contest_of
from soccer_env.train.evaluate.results import EVALUATION, MATCHES, MatchLine
from soccer_env.train.evaluate.settings import Conditions, EvaluateSettings, conditions_of
from soccer_env.train.files import read_bounded, records_in
from soccer_env.train.provenance import LIBRARIES, made_with, of_modules, settings_hash
from soccer_env.train.results_folder import GROWN, PARTS, SETTINGS, check_kinds, settings_before

VERSIONS = (*LIBRARIES, "code")  # of what a result was made with: what may differ, and is then said
CODE = ("soccer_env", "code")  # if these do, hashes of teams and leagues cannot be told from another version's
RESULT = "result.json"
MOST = 10_000_000  # matches


@dataclass(frozen=True)
class Found:
    """An evaluation as its folder tells of it."""

    path: Path
    conditions: dict[str, Any]
    made_with: dict[str, str]
    sizes: tuple[int, ...]  # matches that it asks for, and those that it asked for before it grew
    lines: dict[int, dict[str, Any]]  # of finished matches, by number
    result: dict[str, Any] | None  # what result.json says, if there is one

    @property
    def pairs(self) -> list[int]:
        """Return the finished pairs: those whose two matches both have a line."""
        return sorted(number // 2 for number in self.lines if number % 2 == 0 and number + 1 in self.lines)


def read_folder(path: Path) -> Found:
    """Return what a folder says; ValueError if it is none of an evaluation, or damaged."""
    if not path.is_dir():
        raise ValueError(f"{path} is no folder" if path.exists() else f"there is no folder {path}")
    result = read_result(path / RESULT)  # before the lines, from which it follows: an evaluation may go on just now
    before = settings_before(path, EVALUATION)
    if before is None:
        raise ValueError(f"{path} holds no evaluation: there is no {SETTINGS}")
    conditions, made_with, about = (before[part] for part in PARTS)
    matches = conditions.get("matches")
    if not isinstance(matches, int) or isinstance(matches, bool) or not 2 <= matches <= MOST or matches % 2:
        raise ValueError(f"{path / SETTINGS}: matches must be an even number of 2 to {MOST}, got {brief(matches)}")
    if not all(isinstance(value, str) for value in made_with.values()):
        raise ValueError(f"{path / SETTINGS}: what it was made with must be texts, got {brief(made_with)}")
    earlier = [size for size in about.get(GROWN) or () if isinstance(size, int) and not isinstance(size, bool)]
    sizes = (matches, *earlier)
    mine = {settings_hash({**conditions, "matches": size}, made_with) for size in sizes}
    lines = read_matches(path / MATCHES, matches, mine, conditions, made_with)
    return Found(path, conditions, made_with, sizes, lines, result)


def read_matches(
    path: Path, matches: int, mine: set[str], conditions: dict[str, Any], made_with: dict[str, str]
) -> dict[int, dict[str, Any]]:
    """Return the lines of finished matches, by number; those of this evaluation when it was smaller count as its own.

    ValueError for lines of another one, for a match that it has not, and for one that has two different lines.
    """
    current = settings_hash(conditions, made_with)
    names = sorted(field.name for field in fields(MatchLine))
    lines: dict[int, dict[str, Any]] = {}
    for record in records_in(path, read_bounded(path))[0] if path.exists() else ():
        if sorted(record) != names:
            raise ValueError(f"{path}: a line has the fields {', '.join(names)}, got {brief(sorted(record))}")
        check_kinds(path, record, MatchLine)
        number = record["match"]
        if not 0 <= number < matches:
            raise ValueError(f"{path}: match must be 0 to {matches - 1}, got {number}")
        if record["settings"] not in mine:
            raise ValueError(f"{path}: match {number} belongs to other settings than those of {SETTINGS} beside it")
        record["settings"] = current
        if lines.setdefault(number, record) != record:
            raise ValueError(f"{path}: match {number} has two lines that differ")
    return lines


def read_result(path: Path) -> dict[str, Any] | None:
    """Return what a result.json says, None if there is none; ValueError if it cannot be read."""
    if not path.exists():
        return None
    try:
        found = json.loads(read_bounded(path))
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{path} cannot be read as JSON ({error})") from error
    return found if isinstance(found, dict) else {}


def same_contest(
    found: Found, where: Mapping[str, str], league: League | None, teams: Mapping[str, Team]
) -> tuple[Contest, list[str]]:
    """Return the contest that a folder tells of, and in words what else it was made with than there is now.

    ValueError for conditions that cannot be, for what cannot be made again, and for another team than played.
    """
    asked = conditions_in(found, where, league, teams)
    own = league or league_of(asked, where)
    check_conditions(found, asked, own)
    given = {name: asked[name] for name in ("home", "away")}
    conditions = Conditions(**{**asked, "players": tuple(asked["players"]), "senses": tuple(asked["senses"])})
    try:
        contest = contest_of(conditions, own, teams)
        contest.start("home", [0]).close()
    except (ValueError, OSError, ImportError) as error:
        both = ", ".join(map(brief, given.values()))
        raise ValueError(
            f"the contest of {found.path} cannot be made again: {error}. Its teams were {both}: --home and --away say "
            "where a file is now; a team or league object is given in Python, recheck(folder, teams={name: team})"
        ) from error
    modules = [where.get("league", ""), *names_in(conditions.scene)]
    return contest, differences_of(found, {**made_with(own, contest.first, contest.second), **of_modules(modules)})


def conditions_in(
    found: Found, where: Mapping[str, str], league: League | None, teams: Mapping[str, Team]
) -> dict[str, Any]:
    """Return the conditions of a folder, with what is said anew; ValueError for code that is named by it alone."""
    known, theirs = {field.name for field in fields(Conditions)}, found.conditions
    if set(theirs) != known:
        raise ValueError(
            f"{found.path / SETTINGS} must name the conditions {', '.join(sorted(known))}, got {brief(sorted(theirs))}"
            f": it is damaged, or made by another version ({brief(found.made_with.get('soccer_env', 'unknown'))})"
        )
    asked = dict(theirs)
    for name in ("home", "away", "scene", "league"):
        said, there = where.get(name, ""), theirs[name]
        if not isinstance(there, str):
            raise ValueError(f"{found.path / SETTINGS}: {name} must be a name, got {brief(there)}")
        given = there in teams if name in ("home", "away") else name == "league" and league is not None
        named = [there, *names_in(there)] if name == "scene" else [there]  # several with shares, each may be code
        names_code = in_module(there) if name in ("home", "away") else any(map(MODULE_PATH.fullmatch, named))
        if names_code and not said and not given:
            raise ValueError(
                f"the {name} of {found.path} is code, {brief(there)}, that is not run because a folder names it; if "
                f"you trust it: --{name} {there}"
            )
        asked[name] = said or there
    return asked


def league_of(asked: dict[str, Any], where: Mapping[str, str]) -> League:
    """Return the league of some conditions; ValueError says how one of a user's own is given."""
    name = asked["league"]
    if not where.get("league") and name not in LEAGUES:
        raise ValueError(
            f"league {brief(name)} is none of this package's: --league MODULE:NAME, or recheck(folder, league=...) "
            "in Python, says what it is"
        )
    return find_league(name)


def check_conditions(found: Found, asked: dict[str, Any], league: League) -> None:
    """Raise ValueError unless conditions are what the settings of an evaluation come to."""
    where = found.path / SETTINGS
    players, senses = asked["players"], asked["senses"]
    if not all(isinstance(both, list) and len(both) == 2 for both in (players, senses)):
        raise ValueError(f"{where}: players and senses must be two each, got {brief(players)} and {brief(senses)}")
    words = {**asked, "players": f"{players[0]}v{players[1]}", "senses": f"home={senses[0]},away={senses[1]}"}
    try:
        settings = EvaluateSettings(**words)
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from error
    asked["league"] = league.name
    if league.name != found.conditions["league"]:
        raise ValueError(f"{where}: the league was {brief(found.conditions['league'])}, got {brief(league.name)}")
    meant = {**asdict(conditions_of(settings, league)), "players": list(players), "senses": list(senses)}
    for name, value in asked.items():
        if meant[name] != value or type(meant[name]) is not type(value):
            raise ValueError(f"{where}: {name} must be {brief(meant[name])}, got {brief(value)}")


def differences_of(found: Found, now: dict[str, str]) -> list[str]:
    """Return in words what a folder was made with that is another now; ValueError if another team or league is.

    With other code nobody can tell a team from another version of itself: then that is said as well.
    """
    names = dict.fromkeys([*found.made_with, *now])
    other = [name for name in names if found.made_with.get(name) != now.get(name)]
    words = {name: f"{name} {brief(found.made_with.get(name))} there, {brief(now.get(name))} now" for name in other}
    players = [words[name] for name in other if name not in VERSIONS]
    if players and not any(name in CODE for name in other):
        raise ValueError(f"{found.path} was not made with this ({'; '.join(players)}): what played there is another")
    return list(words.values())
