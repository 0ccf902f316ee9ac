"""Variation: numbers of the league that differ from episode to episode, drawn from the match's own seed.

    Match(variation={"kicker.fastest": (0.8, 1.2), "drive.delay": (0.5, 2.0, "log")})

A range holds factors of the league's own number, and the name of their distribution ("even" if it is left out). Of
faults and changing light, which are 0 in the leagues, it holds the numbers themselves. Physics, kicks, faults and
sensors use the drawn numbers. Teams, beliefs, observations and the referee's book know the league's own: no robot is
told that it kicks weakly today.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from statistics import NormalDist
from typing import Any
from zlib import crc32

import numpy as np

from soccer_env.guards.checking import check_choice, field_type_name, is_number, raise_not_allowed
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
THEMSELVES = ("faults.dropouts", "faults.breakdowns", "sensors.light_drift")  # not drawn as factors
SENSED = ("_noise", "_miss", "_loss", "dither", "scale_error", "false_balls", "light_drift")  # ends of names of sensors
BELL = NormalDist(0.5, 0.25)  # over a range from 0 to 1; of the tails beyond, 4.6 %, nothing is drawn
DISTRIBUTIONS = {  # how a number between low and high follows from one drawn evenly between 0 and 1
    "even": lambda low, high, share: low + (high - low) * share,
    "log": lambda low, high, share: low * (high / low) ** share,  # halves are as likely as doubles
    "bell": lambda low, high, share: (
        low + (high - low) * BELL.inv_cdf(BELL.cdf(0.0) + (BELL.cdf(1.0) - BELL.cdf(0.0)) * share)
    ),
}
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
    """Ranges and distributions of factors by name, from which the leagues of single episodes follow."""

    ranges: tuple[tuple[str, float, float, str], ...]

    @property
    def plain(self) -> dict[str, list[Any]]:
        """Return the ranges as plain values, as the setting takes them."""
        return {name: [low, high] + [kind] * (kind != "even") for name, low, high, kind in self.ranges}

    @property
    def in_space(self) -> bool:
        """Tell whether an episode needs a Space of its own."""
        return any(name.startswith(IN_SPACE) for name, *_ in self.ranges)

    def factors(self, match: Any) -> dict[str, float]:
        """Return by name the factor of each number in the present episode of a match, a MATCH record."""
        noise, factors = np.zeros(NOISE_STREAMS, np.uint64), {}
        for name, low, high, kind in self.ranges:
            start_streams(noise, match["seed"], match["episode"], OWNERS + crc32(name.encode()))
            drawn = DISTRIBUTIONS[kind](low, high, float(draw_uniform(noise, 0)))
            factors[name] = min(max(drawn, low), high)  # against rounding
        return factors

    def extremes(self) -> Iterator[dict[str, float]]:
        """Yield factors at the ends of the ranges: all low, all high, and each number alone at the other end."""
        low, high = {name: low for name, low, *_ in self.ranges}, {name: high for name, _, high, _ in self.ranges}
        yield from (low, high)
        for name in low:
            yield from (low | {name: high[name]}, high | {name: low[name]})


def vary_league(league: League, factors: Mapping[str, float]) -> League:
    """Return a league with its numbers times the factors; ValueError if a league cannot have such a number."""
    for name, factor in factors.items():
        league = change(league, name.split("."), factor, name in THEMSELVES)
    return league


def change(part: Any, path: list[str], factor: float, itself: bool) -> Any:
    """Return a copy of a part of a league in which the number at the path of names is multiplied, or is the factor."""
    value = getattr(part, path[0])
    if path[1:]:
        return replace(part, **{path[0]: change(value, path[1:], factor, itself)})
    return replace(part, **{path[0]: factor if itself else value * factor})


def find_variation(value: Any, league: League) -> Variation | None:
    """Return the checked variation of a setting, {name: (low, high, distribution)}; ValueError says what exists."""
    if not value:
        return None
    if not isinstance(value, Mapping):
        raise_not_allowed("variation", "a mapping of names to (low, high)", value)
    known, ranges = names_of(league), []
    for name, drawn in value.items():
        if name not in known:
            raise ValueError(unknown("variation", str(name), known, where=f"league {league.name!r}"))
        ranges.append((str(name), *check_range(f"variation of {name}", drawn)))
    found = Variation(tuple(ranges))
    for factors in found.extremes():
        try:
            vary_league(league, factors)
        except ValueError as error:
            raise ValueError(f"variation leads out of the league's ranges: {error}") from None
    return found


def check_range(name: str, drawn: Any) -> tuple[float, float, str]:
    """Return (low, high, distribution) of a range, or of a single number, that a user gave; ValueError for others."""
    drawn = (drawn, drawn) if is_number(drawn) else drawn
    if not (isinstance(drawn, (tuple, list)) and len(drawn) in (2, 3) and all(is_number(one) for one in drawn[:2])):
        raise_not_allowed(name, 'two factors, low and high, perhaps with a distribution: (0.5, 2.0, "log")', drawn)
    low, high, kind = float(drawn[0]), float(drawn[1]), drawn[2] if drawn[2:] else "even"
    check_choice(f"distribution in {name}", kind, DISTRIBUTIONS)
    if not 0.0 <= low <= high <= GREATEST:
        raise_not_allowed(name, f"two factors from 0 to {GREATEST:g}, the lower first", drawn)
    if kind == "log" and low == 0.0:
        raise_not_allowed(name, "two factors above 0, as their distribution is log", drawn)
    return low, high, kind
