"""What two matches of which one cannot go on as the other differ in, in words: for the messages of load and branch.

A save carries its settings as `told` gives them, for this alone: whether it fits follows from fingerprints.
"""

import hashlib
import json
from collections.abc import Mapping
from typing import Any

from soccer_env.guards.checking import brief
from soccer_env.match.arguments import FREE

Match = Any  # soccer_env.match.match.Match, which stands above this file

DIGITS = 8  # of a hash that tells settings of many numbers from each other
LENGTH = ("max_cycles", "action_repeat")  # an episode's end in control steps follows from both
SENSED = "observe"  # decides what has to be sensed, and so what a save holds
INNER = ("padded", *LENGTH, SENSED)  # named under conditions, not by a difference alone


def told(match: Match) -> dict[str, list[str]]:
    """Return [words, hash] of each setting that a save or a branch may fail by, but for the teams."""
    settings = match.settings
    said = {name: value for name, value in settings.describe().items() if name not in FREE}
    said |= {name: getattr(settings, name) for name in LENGTH} | {"limit": settings.limit}
    said["max_players"] = settings.max_players if settings.padded else None
    said[SENSED] = settings.describe()[SENSED]
    said["senses"] = dict(zip(("home", "away"), settings.senses, strict=True))
    league = said["league"]
    said |= {name: league.pop(name) for name in ("rules", "sensors", "memory")}
    return {name: [in_words(name, value), digest(value)] for name, value in said.items()}


def told_of_teams(match: Match) -> list[str]:
    """Return words and hash of who plays: a learner's past selves change while a match runs."""
    teams = [team_of(match, squad) for squad in match.squads]
    return [in_words("teams", teams), digest(teams)]


def team_of(match: Match, squad: Any) -> list[Any]:
    """Return name, settings and robots of a team; of robots their names, as rows depend on how many there are."""
    name, settings, rows = squad.describe()
    return [name, settings, [match.agents[row] for row in rows]]


def in_words(name: str, value: Any) -> str:
    """Return the value of a setting, or what names it, in a few words."""
    if name == "teams":
        return "; ".join(f"{team} ({', '.join(agents)})" for team, _, agents in value) or "none"
    if name == "senses":
        return value["home"] if value["home"] == value["away"] else f"home={value['home']},away={value['away']}"
    return str(value.get("name", "")) if isinstance(value, Mapping) else brief(value)


def digest(value: Any) -> str:
    """Return a short hash of a setting."""
    return hashlib.sha256(json.dumps(value, sort_keys=True, default=str).encode()).hexdigest()[:DIGITS]


def differences(one: Any, other: Any, kinds_differ: bool = False) -> str:
    """Return the settings that differ as "minutes 3.0 there, 10.0 here"; "" if none is known to.

    one: what a save says, which may be anything; other: what `told` gives here. kinds_differ: not the same arrays.
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
    return "; ".join(phrase(name, one[name][0], other[name][0]) for name in names)


def phrase(name: str, there: str, here: str) -> str:
    """Return how the values of a setting differ."""
    there, here = (text if len(text) <= 60 and text.isprintable() else f"{text!r:.60}..." for text in (there, here))
    what = "teams differ:" if name == "teams" else name
    return f"{what} {there} there, {here} here" if there != here else f"{what} of other settings"
