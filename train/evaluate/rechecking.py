"""Replay a random sample of an evaluation and compare every line bit for bit: `soccer evaluate --recheck FOLDER`.

    result = recheck("runs/match", pairs=5)

Results are text that anybody can edit; but a match follows from its seed, so anybody can check it by playing it again.
Nothing is written, and no code that the folder names is run.
"""

import json
import secrets
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from soccer_env.guards.checking import check_whole_number, short_repr
from soccer_env.leagues.league import League
from soccer_env.teams import Team
from soccer_env.train.evaluate.contest import Contest, play_batches
from soccer_env.train.evaluate.line_checks import check_line
from soccer_env.train.evaluate.results import MatchLine, summarise
from soccer_env.train.evaluate.same_contest import StoredEvaluation, read_folder, rebuild_contest
from soccer_env.train.evaluate.settings import ALL, PAIRS, Conditions
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import settings_hash

DEEP = 2  # levels of a field's name, as in statistics.shots_for; deeper differences are only counted
NOTHING = "nothing"
AT_ONCE = 8  # pairs side by side for each thread: few, because a batch reports only when all its matches have ended


@dataclass(frozen=True)
class Difference:
    """A field of a match's result line that differs after the match is played again."""

    pair: int
    match: int
    field: str  # statistics.shots_for
    there: str  # in the folder
    again: str  # played again
    more: int  # further differing numbers of this field

    def __str__(self) -> str:
        more = f", and {self.more} more of its numbers" if self.more else ""
        return f"match {self.match}: {self.field} is {self.there} there, {self.again} played again{more}"


Tell = Callable[[int, list[Difference]], None]


@dataclass(frozen=True)
class RecheckResult:
    """The result of playing a sample of an evaluation's matches again."""

    folder: str
    asked: int  # pairs of the whole evaluation
    finished: int  # pairs that the folder holds
    seed: int  # of the draw
    pairs: tuple[int, ...]  # played again, sorted
    differences: tuple[Difference, ...]
    result: tuple[str, ...] | None  # fields of result.json that do not follow from all lines; None: not checked
    made_otherwise: tuple[str, ...]  # versions that differ from the folder's: why lines may differ

    @property
    def agrees(self) -> bool:
        """Tell whether all lines and all fields of result.json agree."""
        return not self.differences and not self.result

    @property
    def differing(self) -> tuple[int, ...]:
        """Return the numbers of the pairs with differing lines."""
        return tuple(sorted({difference.pair for difference in self.differences}))

    def as_dict(self) -> dict[str, Any]:
        """Return the result as a dictionary of plain values, for JSON."""
        return {"agrees": self.agrees, "differing": list(self.differing), **asdict(self)}


def recheck(
    folder: str | Path, *, pairs: int | str = PAIRS, seed: int | None = None, threads: int = 1,
    where: Mapping[str, str] = MappingProxyType({}), league: League | None = None,
    teams: Mapping[str, Team] = MappingProxyType({}), tell: Tell | None = None,
) -> RecheckResult:  # fmt: skip
    """Play `pairs` of an evaluation's finished pairs again ("all": every one) and compare every line bit for bit.

    `seed` draws the pairs; None draws an unpredictable seed. `where` gives the current paths of the policy files "home"
    and "away", and names "home", "away", "league" and "scene" again if they are MODULE:NAME; `league` and `teams` are
    the arguments of `evaluate`. `tell` gets each finished pair with its differences. Raises ValueError for a folder
    without a finished pair, and for a contest that cannot be rebuilt.
    """
    stored = read_folder(Path(folder))
    contest, made_otherwise = rebuild_contest(stored, where, league, teams)
    seed = secrets.randbits(32) if seed is None else seed
    drawn = sample(stored.pairs, pairs, seed)
    if not drawn:
        raise ValueError(f"{folder} has no finished pair yet")
    differing = compare(stored, contest, drawn, threads, tell or (lambda pair, differences: None))
    follows = None if made_otherwise else result_differences(stored, contest)
    return RecheckResult(
        folder=str(folder), asked=stored.conditions["matches"] // 2, finished=len(stored.pairs), seed=seed,
        pairs=tuple(drawn), differences=tuple(differing), result=follows, made_otherwise=tuple(made_otherwise),
    )  # fmt: skip


def sample(pairs: Sequence[int], count: int | str, seed: int) -> list[int]:
    """Draw `count` random pairs, sorted; all pairs if there are no more than `count`."""
    if count == ALL or check_whole_number("pairs", count, 1) >= len(pairs):
        return list(pairs)
    drawn = np.random.default_rng(seed).choice(np.array(pairs), int(count), replace=False)
    return sorted(drawn.tolist())


def compare(
    stored: StoredEvaluation, contest: Contest, pairs: Sequence[int], threads: int, tell: Tell
) -> list[Difference]:
    """Play pairs again and return the differences; `tell` is called after each pair with its differences."""
    differing: dict[int, list[Difference]] = {}
    steps = sum(max(0, stored.lines[number]["steps"]) for pair in pairs for number in (2 * pair, 2 * pair + 1))
    size = -(-len(pairs) // max(-(-len(pairs) // AT_ONCE), (threads + 1) // 2))
    batches = [
        [2 * pair + side for pair in pairs[first : first + size]]
        for first in range(0, len(pairs), size)
        for side in (0, 1)
    ]
    settings = settings_hash(stored.conditions, stored.made_with)
    with Progress(f"{len(pairs)} pairs of {stored.path.name} again", steps) as progress:

        def take(lines: list[MatchLine]) -> None:
            for line in lines:
                differing[line.match] = differences(stored.lines[line.match], asdict(line))
                if line.match % 2:  # the second match of a pair comes after the first
                    tell(line.pair, differing[line.match - 1] + differing[line.match])

        play_batches(contest, batches, settings, threads, take, progress.advance)
    return [difference for number in sorted(differing) for difference in differing[number]]


def result_differences(stored: StoredEvaluation, contest: Contest) -> tuple[str, ...] | None:
    """Return the fields of result.json that disagree with the match lines; None if there is no such file.

    While an evaluation grows, its folder holds the result of the smaller one.
    """
    there = stored.result
    if there is None:
        return None
    matches = there.get("matches")
    if not isinstance(matches, int) or matches not in stored.sizes:
        return (f"its matches, {short_repr(matches)},",)
    missing = matches - sum(number < matches for number in stored.lines)
    if missing:
        return (f"all of it, as {missing} of its {matches} matches have no line,",)
    values: dict[str, Any] = {**stored.conditions, "matches": matches}
    conditions = Conditions(**{**values, "players": tuple(values["players"]), "senses": tuple(values["senses"])})
    settings = settings_hash(values, stored.made_with)
    lines = [MatchLine(**{**stored.lines[number], "settings": settings}) for number in range(matches)]
    try:
        for line in lines:
            check_line(line, conditions.players)
    except ValueError as error:
        return (f"all of it, for {error}",)
    result = summarise(conditions, stored.made_with, lines, contest.league.pitch).as_dict()
    again = json.loads(json.dumps(result))
    names = dict.fromkeys([*there, *again])
    return tuple(short_repr(name) for name in names if json.dumps(there.get(name)) != json.dumps(again.get(name)))


def differences(there: dict[str, Any], again: dict[str, Any]) -> list[Difference]:
    """Return the fields in which two lines of a match differ, each field once; 1 differs from "1"."""
    both = [dict(leaves(record)) for record in (there, json.loads(json.dumps(again)))]
    fields: dict[tuple[Any, ...], list[tuple[tuple[Any, ...], str, str]]] = {}
    for place in dict.fromkeys([*both[0], *both[1]]):
        before, now = (exact_text(record[place]) if place in record else NOTHING for record in both)
        if before != now:
            fields.setdefault(place[:DEEP], []).append((place, before, now))
    result = []
    for places in fields.values():
        place, before, now = places[0]
        name = ".".join(key if isinstance(key, str) and key.isidentifier() else short_repr(key) for key in place)
        result.append(Difference(again["pair"], again["match"], name, before, now, len(places) - 1))
    return result


def leaves(value: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], Any]]:
    """Yield every leaf of nested dicts and lists, with its path of keys; an empty dict or list is a leaf."""
    if isinstance(value, (dict, list)) and value:
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from leaves(inner, (*place, key))
    else:
        yield place, value


def exact_text(value: Any) -> str:
    """Convert a value to text that is equal only for values that are equal bit for bit."""
    return short_repr(value) if isinstance(value, str) and len(value) < 60 else json.dumps(value)[:200]
