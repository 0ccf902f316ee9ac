"""Parse team sizes and senses from text, and write settings as a command.

Shared by `soccer evaluate`, `record`, `watch`, `reproduce` and `train`.
"""

import re
import shlex
from collections.abc import Collection
from dataclasses import fields, replace
from typing import Any, TypeVar

from soccer_env.guards.checking import FROM_ZERO, CheckedFields, Range, raise_not_allowed
from soccer_env.match.arguments import Pose
from soccer_env.types import MAX_TEAM

T = TypeVar("T")
SENSES = ("ideal", "sensors")
SENSING = "sensors"  # a team that is not named
ADDRESS = re.compile(r"local|auto|[\w.-]+:\d+")  # of a Ray cluster
POSES: tuple[Pose, ...] = ("particles", "percept")  # the first of an evaluation


class CommandSettings(CheckedFields):
    """The settings of a command: a frozen dataclass whose fields are its flags."""

    TITLED = False
    BOUNDS = {"seed": FROM_ZERO, "threads": Range(1)}

    def __post_init__(self) -> None:
        super().__post_init__()
        ray = getattr(self, "ray", None)
        if ray is not None and not ADDRESS.fullmatch(ray):
            raise_not_allowed("ray", "local, auto or HOST:PORT", ray)
        if ray is not None and getattr(self, "threads", 1) != 1:
            raise ValueError("threads does not go with ray, which uses the cores of the cluster")


def with_ray(settings: T, address: str | None) -> T:
    """Return settings with a Ray cluster in place of threads; unchanged without an address."""
    if not address:
        return settings
    here: Any = settings
    changed: T = replace(here, threads=1, ray=address)
    return changed


def split_players(players: int | str | None, default: int) -> tuple[int, int]:
    """Parse team sizes: "3v5" gives (3, 5), 3 gives (3, 3), None gives `default` for both."""
    parts = [default] if players is None else str(players).lower().split("v")
    try:
        sizes = [int(part) for part in parts]
    except ValueError:
        sizes = []
    if len(sizes) not in (1, 2) or not all(1 <= size <= MAX_TEAM for size in sizes) or isinstance(players, bool):
        raise_not_allowed("players", f"1 to {MAX_TEAM}, or two such numbers as in 3v5", players)
    return sizes[0], sizes[-1]


def split_senses(senses: str) -> tuple[str, str]:
    """Parse "ideal" or "home=ideal,away=sensors"; return the senses of the first and of the second team."""
    named = dict(part.strip().partition("=")[::2] for part in senses.split(","))
    both = (
        (named.get("home", SENSING), named.get("away", SENSING)) if set(named) <= {"home", "away"} else (senses, senses)
    )
    if not set(both) <= set(SENSES):
        raise_not_allowed("senses", f"one of {', '.join(SENSES)}, or home=ideal,away=sensors", senses)
    return both


def split_variation(text: str) -> dict[str, tuple[Any, ...]]:
    """Parse "ball.mass=0.8:1.2,drive.delay=0.5:2:log,kicker.miss=2": ranges of factors, or single ones, by name."""
    ranges: dict[str, tuple[Any, ...]] = {}
    for part in text.split(",") if text else ():
        name, _, both = part.strip().partition("=")
        if name in ranges:
            raise ValueError(f"variation names {name} twice, in {text!r}")
        low, *high = both.split(":", 2)
        try:
            ranges[name] = float(low), float(high[0] if high else low), *high[1:]
        except ValueError:
            raise_not_allowed("variation", "written as NAME=LOW:HIGH,NAME=LOW:HIGH:log,NAME=FACTOR", text)
    return ranges


def command_line(command: str, settings: Any, always: Collection[str] = ()) -> str:
    """Return the command line with these settings, a dataclass; defaults are left out, except fields in `always`.

    `anew` is left out, too, because it would remove the run to resume; and `json`, which changes no result.
    """
    words = ["soccer", command]
    for field in fields(settings):
        value, flag = getattr(settings, field.name), "--" + field.name.replace("_", "-")
        if field.name in ("anew", "json") or (value == field.default and field.name not in always):
            continue
        if isinstance(value, bool):
            words += [flag if value else f"--no-{flag[2:]}"]
        else:
            short = f"{value:g}" if isinstance(value, float) else str(value)
            words += [flag, repr(value) if isinstance(value, float) and float(short) != value else short]
    return shlex.join(words)


def split_distinct_names(name: str, text: str) -> tuple[str, ...]:
    """Return the names in a text, between commas; ValueError if a name stands there twice."""
    names = split_names(text, name)
    if len(set(names)) < len(names):
        raise_not_allowed(name, "different", text)
    return names


def split_names(text: str, name: str) -> tuple[str, ...]:
    """Split a text at commas, but keep a part such as NAME:switch=value,switch=value whole."""
    parts: list[str] = []
    for part in text.split(","):
        if "=" in part and ":" not in part and parts:
            parts[-1] += "," + part
        else:
            parts.append(part.strip())
    if not all(parts):
        raise_not_allowed(name, "names with commas between them", text)
    return tuple(parts)


def layer_sizes(name: str, text: str) -> tuple[int, ...]:
    """Parse layer sizes such as "64,64"; ValueError for any other text."""
    try:
        sizes = tuple(int(part) for part in str(text).split(","))
    except ValueError:
        sizes = ()
    if not 1 <= len(sizes) <= 6 or not all(1 <= size <= 1024 for size in sizes):
        raise_not_allowed(name, "one to six layer sizes of 1 to 1024, as in 64,64", text)
    return sizes
