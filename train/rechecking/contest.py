"""The contest of a folder again: its teams, league and scene as they were, or in words why they cannot be had."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, fields
from typing import Any

from soccer_env.checking import brief
from soccer_env.leagues import LEAGUES, find_league
from soccer_env.leagues.league import League
from soccer_env.names import MODULE_PATH
from soccer_env.scenes import names_in
from soccer_env.teams import Team, in_module
from soccer_env.train.evaluate.contest import Contest, contest_of
from soccer_env.train.evaluate.settings import Conditions, EvaluateSettings, conditions_of
from soccer_env.train.provenance import LIBRARIES, made_with, of_modules
from soccer_env.train.rechecking.folder import Found
from soccer_env.train.rechecking.settings import RecheckSettings
from soccer_env.train.results_folder import SETTINGS

VERSIONS = (*LIBRARIES, "code")  # of what a result was made with: what may differ, and is then said
CODE = ("soccer_env", "code")  # if these do, hashes of teams and leagues cannot be told from another version's


def same_contest(
    found: Found, settings: RecheckSettings, league: League | None, teams: Mapping[str, Team]
) -> tuple[Contest, list[str]]:
    """Return the contest that a folder tells of, and in words what else it was made with than there is now.

    ValueError for conditions that cannot be, for what cannot be made again, and for another team than played.
    """
    asked = conditions_in(found, settings, league, teams)
    own = league or league_of(asked, settings)
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
            "where a file is now; a team or league object is given in Python, recheck(settings, teams={name: team})"
        ) from error
    now = {
        **made_with(own, contest.first, contest.second),
        **of_modules([settings.league, *names_in(conditions.scene)]),
    }
    return contest, differences_of(found, now)


def conditions_in(
    found: Found, settings: RecheckSettings, league: League | None, teams: Mapping[str, Team]
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
        said, there = getattr(settings, name), theirs[name]
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


def league_of(asked: dict[str, Any], settings: RecheckSettings) -> League:
    """Return the league of some conditions; ValueError says how one of a user's own is given."""
    name = asked["league"]
    if not settings.league and name not in LEAGUES:
        raise ValueError(
            f"league {brief(name)} is none of this package's: --league MODULE:NAME, or recheck(settings, league=...) "
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
