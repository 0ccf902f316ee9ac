"""Read a folder of results without changing it, and rebuild the contest that produced them."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from soccer_env.guards.checking import short_repr
from soccer_env.guards.names import MODULE_PATH
from soccer_env.leagues import LEAGUES, find_league
from soccer_env.leagues.league import League
from soccer_env.scenes import scene_names
from soccer_env.teams import Team, is_module_team
from soccer_env.train.evaluate.contest import Contest, contest_of
from soccer_env.train.evaluate.results import EVALUATION, MATCHES, MatchLine
from soccer_env.train.evaluate.settings import Conditions, EvaluateSettings, conditions_of
from soccer_env.train.files import read_bounded, records_in
from soccer_env.train.provenance import LIBRARIES, made_with, module_hashes, settings_hash
from soccer_env.train.results_folder import GROWN, PARTS, SETTINGS, check_kinds, settings_before

VERSIONS = (*LIBRARIES, "code")  # entries of `made_with` that may differ: the difference is reported
CODE = ("soccer_env", "code")  # if these differ, the hashes of teams and leagues may differ, too
RESULT = "result.json"
MOST = 10_000_000  # matches


@dataclass(frozen=True)
class StoredEvaluation:
    """An evaluation read from its folder."""

    path: Path
    conditions: dict[str, Any]
    made_with: dict[str, str]
    sizes: tuple[int, ...]  # its number of matches, and the numbers before it grew
    lines: dict[int, dict[str, Any]]  # of finished matches, by number
    result: dict[str, Any] | None  # the contents of result.json, if it exists

    @property
    def pairs(self) -> list[int]:
        """Return the numbers of the finished pairs, for which both matches have a result line."""
        return sorted(number // 2 for number in self.lines if number % 2 == 0 and number + 1 in self.lines)


def read_folder(path: Path) -> StoredEvaluation:
    """Read the evaluation in a folder; ValueError if there is none or it is damaged."""
    if not path.is_dir():
        raise ValueError(f"{path} is no folder" if path.exists() else f"there is no folder {path}")
    result = read_result(path / RESULT)  # before the lines: an evaluation may be adding some at this moment
    before = settings_before(path, EVALUATION)
    if before is None:
        raise ValueError(f"{path} holds no evaluation: there is no {SETTINGS}")
    conditions, made_with, about = (before[part] for part in PARTS)
    matches = conditions.get("matches")
    if not isinstance(matches, int) or isinstance(matches, bool) or not 2 <= matches <= MOST or matches % 2:
        raise ValueError(f"{path / SETTINGS}: matches must be an even number of 2 to {MOST}, got {short_repr(matches)}")
    if not all(isinstance(value, str) for value in made_with.values()):
        raise ValueError(f"{path / SETTINGS}: what it was made with must be texts, got {short_repr(made_with)}")
    earlier = [size for size in about.get(GROWN) or () if isinstance(size, int) and not isinstance(size, bool)]
    sizes = (matches, *earlier)
    mine = {settings_hash({**conditions, "matches": size}, made_with) for size in sizes}
    lines = read_matches(path / MATCHES, matches, mine, conditions, made_with)
    return StoredEvaluation(path, conditions, made_with, sizes, lines, result)


def read_matches(
    path: Path, matches: int, mine: set[str], conditions: dict[str, Any], made_with: dict[str, str]
) -> dict[int, dict[str, Any]]:
    """Read the result lines of finished matches, by match number, including those of an earlier, smaller evaluation.

    ValueError for lines of another evaluation, for a match out of range, and for a match with two different lines.
    """
    current = settings_hash(conditions, made_with)
    names = sorted(field.name for field in fields(MatchLine))
    lines: dict[int, dict[str, Any]] = {}
    for record in records_in(path, read_bounded(path))[0] if path.exists() else ():
        if sorted(record) != names:
            raise ValueError(f"{path}: a line has the fields {', '.join(names)}, got {short_repr(sorted(record))}")
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
    """Return the contents of a result.json, None without the file; ValueError if it cannot be read."""
    if not path.exists():
        return None
    try:
        contents = json.loads(read_bounded(path))
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{path} cannot be read as JSON ({error})") from error
    return contents if isinstance(contents, dict) else {}


def rebuild_contest(
    stored: StoredEvaluation, where: Mapping[str, str], league: League | None, teams: Mapping[str, Team]
) -> tuple[Contest, list[str]]:
    """Rebuild the contest of a folder; return it with a list of the versions that differ from the present ones.

    ValueError for impossible conditions, for a contest that cannot be rebuilt, and for a changed team.
    """
    values = updated_conditions(stored, where, league, teams)
    own = league or league_of_conditions(values, where)
    check_conditions(stored, values, own)
    conditions = Conditions(**{**values, "players": tuple(values["players"]), "senses": tuple(values["senses"])})
    try:
        contest = contest_of(conditions, own, teams)
        contest.start("home", [0]).close()
    except (ValueError, OSError, ImportError) as error:
        both = ", ".join(short_repr(values[side]) for side in ("home", "away"))
        raise ValueError(
            f"the contest of {stored.path} cannot be made again: {error}. Its teams were {both}: --home and --away say "
            "where a file is now; a team or league object is given in Python, recheck(folder, teams={name: team})"
        ) from error
    modules = [where.get("league", ""), *scene_names(conditions.scene)]
    return contest, version_differences(
        stored, {**made_with(own, contest.first, contest.second), **module_hashes(modules)}
    )


def updated_conditions(
    stored: StoredEvaluation, where: Mapping[str, str], league: League | None, teams: Mapping[str, Team]
) -> dict[str, Any]:
    """Return the conditions stored in a folder, updated by `where`; ValueError for code named by the folder alone."""
    known, theirs = {field.name for field in fields(Conditions)}, stored.conditions
    if set(theirs) != known:
        raise ValueError(
            f"{stored.path / SETTINGS} must name the conditions {', '.join(sorted(known))}, got "
            f"{short_repr(sorted(theirs))}: it is damaged, or made by another version "
            f"({short_repr(stored.made_with.get('soccer_env', 'unknown'))})"
        )
    conditions = dict(theirs)
    for name in ("home", "away", "scene", "league"):
        said, there = where.get(name, ""), theirs[name]
        if not isinstance(there, str):
            raise ValueError(f"{stored.path / SETTINGS}: {name} must be a name, got {short_repr(there)}")
        given = there in teams if name in ("home", "away") else name == "league" and league is not None
        named = [there, *scene_names(there)] if name == "scene" else [there]  # several with shares, each may be code
        names_code = is_module_team(there) if name in ("home", "away") else any(map(MODULE_PATH.fullmatch, named))
        if names_code and not said and not given:
            raise ValueError(
                f"the {name} of {stored.path} is code, {short_repr(there)}, that is not run because a folder names it; "
                f"if you trust it: --{name} {there}"
            )
        conditions[name] = said or there
    return conditions


def league_of_conditions(conditions: dict[str, Any], where: Mapping[str, str]) -> League:
    """Return the league that the conditions name; ValueError if it is a user's own league not named in `where`."""
    name = conditions["league"]
    if not where.get("league") and name not in LEAGUES:
        raise ValueError(
            f"league {short_repr(name)} is none of this package's: --league MODULE:NAME, or recheck(folder, "
            "league=...) in Python, says what it is"
        )
    return find_league(name)


def check_conditions(stored: StoredEvaluation, conditions: dict[str, Any], league: League) -> None:
    """Raise ValueError unless some settings of `evaluate` would give exactly these conditions."""
    where = stored.path / SETTINGS
    players, senses = conditions["players"], conditions["senses"]
    if not all(isinstance(both, list) and len(both) == 2 for both in (players, senses)):
        raise ValueError(
            f"{where}: players and senses must be two each, got {short_repr(players)} and {short_repr(senses)}"
        )
    words = {**conditions, "players": f"{players[0]}v{players[1]}", "senses": f"home={senses[0]},away={senses[1]}"}
    try:
        settings = EvaluateSettings(**words)
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from error
    conditions["league"] = league.name
    if league.name != stored.conditions["league"]:
        raise ValueError(
            f"{where}: the league was {short_repr(stored.conditions['league'])}, got {short_repr(league.name)}"
        )
    meant = {**asdict(conditions_of(settings, league)), "players": list(players), "senses": list(senses)}
    for name, value in conditions.items():
        if meant[name] != value or type(meant[name]) is not type(value):
            raise ValueError(f"{where}: {name} must be {short_repr(meant[name])}, got {short_repr(value)}")


def version_differences(stored: StoredEvaluation, now: dict[str, str]) -> list[str]:
    """Describe the versions and hashes that differ from a folder's; ValueError for another team or league.

    If the package's code differs, another team cannot be told from a new version: this is reported as a difference.
    """
    names = dict.fromkeys([*stored.made_with, *now])
    other = [name for name in names if stored.made_with.get(name) != now.get(name)]
    words = {
        name: f"{name} {short_repr(stored.made_with.get(name))} there, {short_repr(now.get(name))} now"
        for name in other
    }
    players = [words[name] for name in other if name not in VERSIONS]
    if players and not any(name in CODE for name in other):
        raise ValueError(f"{stored.path} was not made with this ({'; '.join(players)}): what played there is another")
    return list(words.values())
