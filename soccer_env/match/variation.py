"""Variation: numbers of the league that differ from episode to episode, drawn from the match's own seed.

    Match(variation={"kicker.fastest": (0.8, 1.2), "sensors.ball_miss": (0.0, 3.0)})

A range holds factors of the league's own number, each as likely as another; of the faults, whose rates are 0 in the
leagues, it holds the rates themselves. Physics, kicks, faults and sensors use the drawn numbers. Teams, beliefs,
observations and the referee's book know the league's own: no robot is told that it kicks weakly today.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any
from zlib import crc32

import numpy as np

from soccer_env.guards.checking import field_type_name, is_number, raise_not_allowed
from soccer_env.guards.names import unknown
from soccer_env.leagues.league import League
from soccer_env.random_numbers import draw_uniform, start_streams
from soccer_env.types import NOISE_STREAMS

OWNERS = 1 << 32  # of random numbers, one for each name, far from those of match and robots
GREATEST = 1000.0  # factor
PARTS = {  # of a league: the fields that may vary; None: all its numbers
    "ball": ("mass", "rolling", "sliding", "pivot"),
    "body": ("mass",),
    "drive": None,
    "kicker": None,
    "faults": ("dropouts", "breakdowns"),
}
RATES = "faults."  # numbers that are drawn themselves, not as factors
SENSED = ("_noise", "_miss", "_loss", "dither", "scale_error", "false_balls")  # ends of names of sensors
IN_SPACE = ("ball.", "body.", "materials.")  # numbers that a Space holds from its beginning


def names_of(league: League) -> list[str]:
    """Return the names of the numbers of a league that can vary, such as "ball.mass"."""
    names = [
        f"{part}.{field.name}"
        for part, chosen in PARTS.items()
        for field in fields(getattr(league, part))
        if field_type_name(field) == "float" and (chosen is None or field.name in chosen)
    ]
    names += [f"materials.{pair}.{name}" for pair in league.materials.pairs() for name in ("elasticity", "friction")]
    if league.sensors is None:  # of a replay, which repeats commands
        return names
    sensors = [field.name for field in fields(league.sensors) if field_type_name(field) == "float"]
    return names + [f"sensors.{name}" for name in sensors if name.endswith(SENSED)]


@dataclass(frozen=True)
class Variation:
    """Ranges of factors by name, from which the leagues of single episodes follow."""

    ranges: tuple[tuple[str, float, float], ...]

    @property
    def plain(self) -> dict[str, list[float]]:
        """Return the ranges as plain values, as the setting takes them."""
        return {name: [low, high] for name, low, high in self.ranges}

    @property
    def in_space(self) -> bool:
        """Tell whether an episode needs a Space of its own."""
        return any(name.startswith(IN_SPACE) for name, _, _ in self.ranges)

    def factors(self, match: Any) -> dict[str, float]:
        """Return by name the factor of each number in the present episode of a match, a MATCH record."""
        noise, factors = np.zeros(NOISE_STREAMS, np.uint64), {}
        for name, low, high in self.ranges:
            start_streams(noise, match["seed"], match["episode"], OWNERS + crc32(name.encode()))
            factors[name] = low + (high - low) * float(draw_uniform(noise, 0))
        return factors

    def extremes(self) -> Iterator[dict[str, float]]:
        """Yield factors at the ends of the ranges: all low, all high, and each number alone at the other end."""
        low, high = {name: low for name, low, _ in self.ranges}, {name: high for name, _, high in self.ranges}
        yield from (low, high)
        for name in low:
            yield from (low | {name: high[name]}, high | {name: low[name]})


def vary_league(league: League, factors: Mapping[str, float]) -> League:
    """Return a league with its numbers times the factors; ValueError if a league cannot have such a number."""
    for name, factor in factors.items():
        league = change(league, name.split("."), factor, name.startswith(RATES))
    return league


def change(part: Any, path: list[str], factor: float, itself: bool) -> Any:
    """Return a copy of a part of a league in which the number at the path of names is multiplied, or is the factor."""
    value = getattr(part, path[0])
    if path[1:]:
        return replace(part, **{path[0]: change(value, path[1:], factor, itself)})
    return replace(part, **{path[0]: factor if itself else value * factor})


def find_variation(value: Any, league: League) -> Variation | None:
    """Return the checked variation of a setting, {name: (low, high)}; ValueError says which names and ranges exist."""
    if not value:
        return None
    if not isinstance(value, Mapping):
        raise_not_allowed("variation", "a mapping of names to (low, high)", value)
    known = names_of(league)
    for name, both in value.items():
        if name not in known:
            raise ValueError(unknown("variation", str(name), known, where=f"league {league.name!r}"))
        if not (isinstance(both, (tuple, list)) and len(both) == 2 and all(is_number(one) for one in both)):
            raise_not_allowed(f"variation of {name}", "two factors, low and high", both)
        if not 0.0 <= both[0] <= both[1] <= GREATEST:
            raise_not_allowed(f"variation of {name}", f"two factors from 0 to {GREATEST:g}, the lower first", both)
    found = Variation(tuple((str(name), float(low), float(high)) for name, (low, high) in value.items()))
    for factors in found.extremes():
        try:
            vary_league(league, factors)
        except ValueError as error:
            raise ValueError(f"variation leads out of the league's ranges: {error}") from None
    return found
