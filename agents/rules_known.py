"""The rules that a policy was trained under, stored in its file, and a warning if it plays under other rules.

Under other rules a policy behaves as in its training, and may for example hold a ball that must not be held. The logger
`soccer_env.agents` warns of that once.
"""

import logging
from collections.abc import Mapping
from dataclasses import fields, replace
from functools import cache
from math import isfinite
from typing import Any

from soccer_env.guards.checking import raise_not_allowed, short_repr
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.leagues.rules import SWITCHES, Rules, rule_set

MAX_RULES = 200  # entries of a policy file
MAX_NAME = 500  # characters of the name of a rule set
NOT_RULES = ("name", "half_minutes")  # how long a match lasts is a setting of its own
LOG = logging.getLogger("soccer_env.agents")


def league_with_rules(league: str | League, rules: str) -> League:
    """Return the league with other rules."""
    preset = find_league(league)
    return replace(preset, rules=rule_set(preset.rules, rules))


def recorded(rules: Rules) -> dict[str, Any]:
    """Return the rules as stored in a policy file: every switch and number by name, and the name of the set."""
    return {item.name: getattr(rules, item.name) for item in fields(Rules) if item.name != "half_minutes"}


def check_rules_table(rules: object) -> None:
    """Raise ValueError unless rules are a table of switches and finite numbers with a name, or empty."""
    if not isinstance(rules, Mapping) or len(rules) > MAX_RULES:
        raise_not_allowed("rules", f"a table of at most {MAX_RULES} entries", rules)
    if rules and not (isinstance(rules.get("name"), str) and len(rules["name"]) <= MAX_NAME):
        raise_not_allowed("rules['name']", f"a text of at most {MAX_NAME} characters", rules.get("name"))
    if rules and not rules["name"].isprintable():
        raise_not_allowed("rules['name']", "plain text", rules["name"])
    for name, value in rules.items():
        if not (isinstance(name, str) and name.isidentifier() and len(name) <= 64):
            raise_not_allowed("a key of rules", "the name of a rule", name)
        if name != "name" and not (type(value) in (bool, int, float) and isfinite(value)):
            raise ValueError(f"rules[{name!r}] must be True, False or a finite number, got {short_repr(value)}")


def rule_differences(known: Mapping[str, Any], rules: Rules) -> list[str]:
    """Return each rule that differs, such as "pushing (on, off)": value in the policy, then in the league."""
    here = {name: value for name, value in recorded(rules).items() if name not in NOT_RULES}
    names = [*SWITCHES, *(name for name in here if name not in SWITCHES), *(name for name in known if name not in here)]
    return [
        f"{name} ({rule_in_words(known.get(name))}, {rule_in_words(here.get(name))})"
        for name in names
        if name not in NOT_RULES and known.get(name) != here.get(name)
    ]


def rule_in_words(value: Any) -> str:
    """Return the value of a rule in words."""
    if value is None:
        return "not there"
    return {True: "on", False: "off"}[value] if isinstance(value, bool) else f"{value:g}"


def tell_of_rules(name: str, known: Mapping[str, Any], rules: Rules) -> None:
    """Warn, once per process, if a policy plays under rules that are unknown or differ from its training."""
    if not known:
        warn_once(
            f"policy {name!r} does not say under which rules it was trained, and now plays under {rules.name!r}; to "
            "record them, write the file with save_policy or convert_sb3 and rules=..., or give FILE.zip:rules=league"
        )
        return
    differing = rule_differences(known, rules)
    if differing:
        warn_once(
            f"policy {name!r} was trained under the rules {known['name']!r} and plays under {rules.name!r}; "
            f"what differs (there, here): {', '.join(differing)}"
        )


@cache
def warn_once(text: str) -> None:
    """Log a warning, but each text only once."""
    LOG.warning(text)
