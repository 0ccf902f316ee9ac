"""Teams by name: teams of this package, of installed packages, of files and of your own modules.

A package of yours ships teams by name with the entry point group `soccer_env.teams`; in its pyproject.toml:

    [project.entry-points."soccer_env.teams"]
    lions = "my_package.lions:team"

An entry point names a factory, not a team: it takes `strength` (0 to 1, the number after the @ of lions@0.5) and, by
name, the settings of the team (lions:brave=True), and returns the team.

    def team(strength: float = 1.0, brave: bool = False) -> Team: ...

MODULE:NAME names such a factory, or a team, in your own module.
"""

from collections.abc import Callable
from importlib import import_module
from importlib.metadata import entry_points
from inspect import signature
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.guards.checking import short_repr
from soccer_env.guards.names import MODULE_PATH, object_in_module, unknown
from soccer_env.teams.team import Team

NAMES = {  # strings only: resolved at first use
    "still": "soccer_env.baselines.still:team",
    "random": "soccer_env.baselines.random:team",
    "walker": "soccer_env.baselines.walker:team",
    "chaser": "soccer_env.baselines.chaser:team",
    "sacks-2001": "soccer_env.baselines.sacks_2001:team",
    "sacks-2001-tuned": "soccer_env.baselines.sacks_2001:tuned",
    "sacks-2001-future": "soccer_env.baselines.sacks_2001:team_with_future_work",
    "heinemann-2006": "soccer_env.baselines.heinemann_2006:team",
    "weigel-2001": "soccer_env.baselines.heinemann_2006:weigel",
    "learned": "soccer_env.agents.learned:team",
    "learned-2006": "soccer_env.agents.learned:team_2006",
}
FILES = {  # by the ending of a file that is named as a team
    ".safetensors": "soccer_env.agents.learned:from_file",
    ".zip": "soccer_env.agents.learned:from_zip",
    ".onnx": "soccer_env.agents.onnx_team:from_onnx",
}
ENTRY_POINTS = "soccer_env.teams"
TORCH = (".pt", ".pth", ".ckpt", ".pkl", ".pickle")  # files of torch, whose pickles could run anything


def registered_teams() -> dict[str, str]:
    """Return the factories (MODULE:NAME) of all known teams by name, including those of installed packages."""
    installed = {point.name: point.value for point in entry_points(group=ENTRY_POINTS)}
    return {**installed, **NAMES}


def parse_team(text: str) -> tuple[str, float, dict[str, Any]]:
    """Split NAME, NAME@STRENGTH or NAME@STRENGTH:switch=value,... into name, strength and settings.

    ValueError for a strength outside 0 to 1 and for settings of another form.
    """
    if Path(text).is_file():
        return text, 1.0, {}
    spec, colon, switches = text.partition(":")
    name, _, strength = spec.partition("@")
    try:
        number = float(strength) if "@" in spec else 1.0
    except ValueError:
        number = -1.0
    if not 0.0 <= number <= 1.0:
        raise ValueError(f"strength of team {text!r} must be a number from 0 to 1, got {strength!r}")
    return name, number, dict(parse_switch(text, part) for part in switches.split(",")) if colon else {}


def parse_switch(text: str, part: str) -> tuple[str, Any]:
    """Split SWITCH=VALUE in a team's text; True, False and numbers are converted to Python values."""
    name, equals, value = part.partition("=")
    if not (name.isidentifier() and equals and value):
        raise ValueError(f"settings of team {text!r} must be written as name=value,name=value, got {part!r}")
    if value in ("True", "False"):
        return name, value == "True"
    for kind in (int, float):
        try:
            return name, kind(value)
        except ValueError:
            continue
    return name, value


def make_team(team: str | Team, strength: float | None = None, **settings: Any) -> Team:
    """Make the team of a name (NAME, NAME@STRENGTH, NAME@STRENGTH:SWITCH=VALUE,...); return a team object unchanged.

    A name may be the path of a policy file, of a zip of stable-baselines3 or of an ONNX file
    (FILE.zip:observe=belief,action_repeat=8), or MODULE:NAME: a team in a module of your own, or a function there that
    takes strength= and returns one. ValueError says which names and settings exist.
    """
    if not isinstance(team, str):
        if isinstance(team, type):
            raise ValueError(f"a team is an object: give {team.__name__}(), not the class")
        if not (callable(getattr(team, "act", None)) and hasattr(team, "memory_dtype") and hasattr(team, "name")):
            raise ValueError(f"a team needs name, memory_dtype and act, got {short_repr(team)}{wrapping_advice(team)}")
        return team
    if is_module_team(team):
        return team_in_module(team, strength, settings)
    name, from_name, changes = parse_team(team)
    strength = changes.pop("strength", strength)  # NAME:strength=0.5 is NAME@0.5
    if strength is not None:
        from_name = parse_team(f"{name}@{strength}")[1]
    ending, known = Path(name).suffix, registered_teams()
    if ending in FILES and name not in known:
        if from_name != 1.0:
            raise ValueError(f"a policy has no strength, got {from_name:g} for {name!r}")
        return team_of_file(name, FILES[ending], {**changes, **settings})
    if name not in known:
        raise ValueError(unknown_team_error(name, known))
    factory = import_factory(known[name])
    changes = {**changes, **settings}
    accepted = signature(factory).parameters.values() if callable(factory) else ()
    if not any(one.name == "strength" or one.kind is one.VAR_KEYWORD for one in accepted):
        raise ValueError(f"team {name!r} must be a function that takes strength=, {known[name]} is {factory!r}")
    check_settings_accepted(name, factory, changes)
    made: Team = factory(strength=from_name, **changes)
    return make_team(made)


def wrapping_advice(given: object) -> str:
    """Return advice on how to make a team of a function or a torch module, "" for any other object."""
    if callable(getattr(given, "state_dict", None)):
        file = "mine.safetensors"
        return f": write save_policy(module, {file!r}, league=..., observe=...), then give {file!r} as the team"
    if callable(given):
        return f": write team_of_function({getattr(given, '__name__', 'function')}), which takes observations"
    return ""


def unknown_team_error(name: str, known: dict[str, str]) -> str:
    """Return the error message for an unknown team name; for a torch file, with advice how to make a team of it."""
    if Path(name).suffix not in TORCH:
        return unknown("team", name, known, more=f"a policy file ({', '.join(FILES)})")
    return (
        f"team {name!r} cannot be read: a file of torch may hold code; write the module as a policy file with "
        f"soccer_env.agents.save_policy(module, {Path(name).stem + '.safetensors'!r}, league=..., observe=...)"
    )


def result_name(given: str | Team, made: Team) -> str:
    """Return the name of a team in results, whether given as text or as object; a policy has its own name.

    A weakened team is called chaser@0.25, for example; a team with settings keeps its text.
    """
    if not isinstance(given, str):
        settings: Any = getattr(made, "settings", None)
        names = settings.dtype.names or () if isinstance(settings, np.ndarray) else ()
        return made.name + (strength_suffix(float(settings["strength"][0])) if "strength" in names else "")
    if is_module_team(given):
        _, at, written = given.partition("@")
        return made.name + at + written
    name, strength, changes = parse_team(given)
    if name not in registered_teams():
        return made.name
    return name + strength_suffix(strength) + (given[given.index(":") :] if changes else "")


def strength_suffix(strength: float) -> str:
    """Return the suffix @STRENGTH of a team's name, "" for full strength."""
    return "" if strength == 1.0 else f"@{strength:g}"


def is_module_team(text: str) -> bool:
    """Tell whether a text is MODULE:NAME or MODULE:NAME@STRENGTH, but neither a file nor a known team."""
    path = MODULE_PATH.fullmatch(text.partition("@")[0])
    return path is not None and path[1] not in registered_teams() and not Path(text).is_file()


def team_in_module(text: str, strength: float | None, settings: dict[str, Any]) -> Team:
    """Return the team MODULE:NAME, or call the function MODULE:NAME to make a team of a strength."""
    path, at, written = text.partition("@")
    made = object_in_module("team", path, object)
    if isinstance(made, type) or hasattr(made, "act"):
        if at or strength is not None or settings:
            raise ValueError(f"team {path!r} is no function: it takes neither strength nor settings")
        return make_team(made)
    if not (callable(made) and "strength" in signature(made).parameters):
        raise ValueError(f"team {path!r} must be a team, or a function that takes strength=, got {made!r}")
    given = parse_team(f"it@{written if at else 1.0 if strength is None else strength}")[1]
    check_settings_accepted(path, made, settings)
    return make_team(made(strength=given, **settings))


def team_of_file(path: str, where: str, settings: dict[str, Any]) -> Team:
    """Load the team of a policy file; ValueError says what is wrong with the file."""
    factory = import_factory(where)
    if "path" in settings:
        raise ValueError(f"the file of team {path!r} is given by its name, not by a setting path")
    check_settings_accepted(path, factory, settings)
    made: Team = factory(path, **settings)
    return made


def import_factory(where: str) -> Callable[..., Any]:
    """Import and return the factory of a team, the object MODULE:NAME."""
    module, _, attribute = where.partition(":")
    factory: Callable[..., Any] = getattr(import_module(module), attribute)
    return factory


def check_settings_accepted(name: str, factory: Callable[..., Any], settings: dict[str, Any]) -> None:
    """Raise ValueError for settings that a team's factory does not accept."""
    accepted = signature(factory).parameters
    if not any(parameter.kind is parameter.VAR_KEYWORD for parameter in accepted.values()):
        for unknown in settings.keys() - accepted.keys():
            raise ValueError(f"team {name!r} has no setting {unknown!r}; it has: {', '.join(accepted)}")
