"""Describe in words the settings in which two matches differ, for the errors of load and branch.

A save carries the result of `describe_settings` for these messages alone: fingerprints decide whether a save fits.
"""

import hashlib
import json
from collections.abc import Mapping
from typing import Any

from soccer_env.guards.checking import short_repr
from soccer_env.match.arguments import FREE

Match = Any  # soccer_env.match.match.Match, which stands above this file

DIGITS = 8  # of a hash that tells settings of many numbers from each other
LENGTH = ("max_cycles", "action_repeat")  # an episode's end in control steps follows from both
SENSED = "observe"  # decides which sensors are used, and so the arrays of a save
INNER = ("padded", *LENGTH, SENSED)  # `describe_differences` names these under conditions


def describe_settings(match: Match) -> dict[str, list[str]]:
    """Return [description, hash] of each setting that must be equal to load a save or a branch, without the teams."""
    settings = match.settings
    values = {name: value for name, value in settings.describe().items() if name not in FREE}
    values |= {name: getattr(settings, name) for name in LENGTH} | {"limit": settings.limit}
    values["max_players"] = settings.max_players if settings.padded else None
    values[SENSED] = settings.describe()[SENSED]
    values["actions"] = "skills" if settings.actions.name == "skills" else "commands"
    values["senses"] = dict(zip(("home", "away"), settings.senses, strict=True))
    league = values["league"]
    values |= {name: league.pop(name) for name in ("rules", "sensors", "memory")}
    return {name: [setting_in_words(name, value), short_hash(value)] for name, value in values.items()}


def describe_teams(match: Match) -> list[str]:
    """Return [description, hash] of the teams; teams are apart because they can change while a match runs."""
    teams = [team_description(match, squad) for squad in match.squads]
    return [setting_in_words("teams", teams), short_hash(teams)]


def team_description(match: Match, squad: Any) -> list[Any]:
    """Return [name, settings, agents] of a squad's team; agent names, unlike rows, do not depend on team sizes."""
    name, settings, rows = squad.describe()
    return [name, settings, [match.agents[row] for row in rows]]


def setting_in_words(name: str, value: Any) -> str:
    """Describe the value of a setting in a few words; a value that has a name by its name."""
    if name == "teams":
        return "; ".join(f"{team} ({', '.join(agents)})" for team, _, agents in value) or "none"
    if name == "senses":
        return value["home"] if value["home"] == value["away"] else f"home={value['home']},away={value['away']}"
    return str(value.get("name", "")) if isinstance(value, Mapping) else short_repr(value)


def short_hash(value: Any) -> str:
    """Return a short hash of the value of a setting."""
    return hashlib.sha256(json.dumps(value, sort_keys=True, default=str).encode()).hexdigest()[:DIGITS]


def describe_differences(one: Any, other: Any, kinds_differ: bool = False) -> str:
    """Describe the settings that differ, such as "minutes 3.0 there, 10.0 here"; "" if no difference is known.

    one: the settings in a save, unchecked; other: `describe_settings` of this match. kinds_differ: the layouts
    of the saved arrays differ.
    """
    if not isinstance(one, Mapping) or one.keys() != other.keys():
        return ""
    if not all(isinstance(pair, list) and [type(part) for part in pair] == [str, str] for pair in one.values()):
        return ""
    names = [name for name in other if name not in (*INNER, "limit") and one[name] != other[name]]
    if one["limit"] != other["limit"]:
        names += [name for name in LENGTH if one[name] != other[name]]
    if kinds_differ and one[SENSED] != other[SENSED]:
        names.append(SENSED)
    return "; ".join(describe_difference(name, one[name][0], other[name][0]) for name in names)


def describe_difference(name: str, there: str, here: str) -> str:
    """Describe the difference between two values of a setting, with long values cut short."""
    there, here = (text if len(text) <= 60 and text.isprintable() else f"{text!r:.60}..." for text in (there, here))
    what = "teams differ:" if name == "teams" else name
    return f"{what} {there} there, {here} here" if there != here else f"{what} of other settings"
