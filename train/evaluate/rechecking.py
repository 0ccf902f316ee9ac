"""Play a random sample of an evaluation again and compare every line bit for bit: `soccer evaluate --recheck FOLDER`.

    result = recheck("runs/match", pairs=5)

Results are text that anybody can change. A match follows from its seed, so whoever doubts them can see for themselves.
Nothing is written, and nothing that the folder names as code is run.
"""

import json
import secrets
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from soccer_env.guards.checking import brief, whole_number
from soccer_env.leagues.league import League
from soccer_env.teams import Team
from soccer_env.train.evaluate.contest import Contest, play_batches
from soccer_env.train.evaluate.line_checks import check_line
from soccer_env.train.evaluate.results import MatchLine, summarise
from soccer_env.train.evaluate.same_contest import Found, read_folder, same_contest
from soccer_env.train.evaluate.settings import ALL, PAIRS, Conditions
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import settings_hash

DEEP = 2  # names of a field that stand by themselves: statistics.shots_for, maps.heat_for; the rest is counted
NOTHING = "nothing"
AT_ONCE = 8  # pairs side by side for each thread: few, as what came of them is told when all have ended


@dataclass(frozen=True)
class Difference:
    """A field of a match's line that is not what the match comes to."""

    pair: int
    match: int
    field: str  # statistics.shots_for
    there: str  # in the folder
    again: str  # played again
    more: int  # numbers of this field that differ beside the one that is shown

    def __str__(self) -> str:
        more = f", and {self.more} more of its numbers" if self.more else ""
        return f"match {self.match}: {self.field} is {self.there} there, {self.again} played again{more}"


Tell = Callable[[int, list[Difference]], None]


@dataclass(frozen=True)
class RecheckResult:
    """What came of playing a sample of an evaluation again."""

    folder: str
    asked: int  # pairs that the evaluation asks for
    finished: int  # pairs of which the folder tells
    seed: int  # of the draw
    pairs: tuple[int, ...]  # that were played again, sorted
    differences: tuple[Difference, ...]
    result: tuple[str, ...] | None  # fields of result.json that do not follow from all lines; None: not looked at
    made_otherwise: tuple[str, ...]  # versions that differ from those that made the folder: why lines may differ

    @property
    def agrees(self) -> bool:
        """Tell whether nothing differs."""
        return not self.differences and not self.result

    @property
    def differing(self) -> tuple[int, ...]:
        """Return the pairs that differ."""
        return tuple(sorted({difference.pair for difference in self.differences}))

    def as_dict(self) -> dict[str, Any]:
        """Return this for programs."""
        return {"agrees": self.agrees, "differing": list(self.differing), **asdict(self)}


def recheck(
    folder: str | Path, *, pairs: int | str = PAIRS, seed: int | None = None, threads: int = 1,
    where: Mapping[str, str] = MappingProxyType({}), league: League | None = None,
    teams: Mapping[str, Team] = MappingProxyType({}), tell: Tell | None = None,
) -> RecheckResult:  # fmt: skip
    """Play `pairs` of an evaluation's finished pairs again ("all": every one) and compare every line bit for bit.

    The pairs are drawn by `seed`, None for one that nobody knows before. `where` says where "home" and "away", policy
    files, lie now, and names them, "league" and "scene" again if they are MODULE:NAME; `league` and `teams` are what
    `evaluate` was given. `tell` gets each pair with its differences as it is done. Raises ValueError for a folder
    without a finished pair, and for a contest that cannot be made again.
    """
    found = read_folder(Path(folder))
    contest, made_otherwise = same_contest(found, where, league, teams)
    seed = secrets.randbits(32) if seed is None else seed
    drawn = sample(found.pairs, pairs, seed)
    if not drawn:
        raise ValueError(f"{folder} has no finished pair yet")
    differing = compare(found, contest, drawn, threads, tell or (lambda pair, found: None))
    follows = None if made_otherwise else unlike_result(found, contest)
    return RecheckResult(
        folder=str(folder), asked=found.conditions["matches"] // 2, finished=len(found.pairs), seed=seed,
        pairs=tuple(drawn), differences=tuple(differing), result=follows, made_otherwise=tuple(made_otherwise),
    )  # fmt: skip


def sample(pairs: Sequence[int], count: int | str, seed: int) -> list[int]:
    """Return so many of the pairs at random, sorted; all if there are no more."""
    if count == ALL or whole_number("pairs", count, 1) >= len(pairs):
        return list(pairs)
    drawn = np.random.default_rng(seed).choice(np.array(pairs), int(count), replace=False)
    return sorted(drawn.tolist())


def compare(found: Found, contest: Contest, pairs: Sequence[int], threads: int, tell: Tell) -> list[Difference]:
    """Play pairs again; return what differs, by match. `tell` gets each pair once both of its matches are played."""
    differing: dict[int, list[Difference]] = {}
    steps = sum(max(0, found.lines[number]["steps"]) for pair in pairs for number in (2 * pair, 2 * pair + 1))
    size = -(-len(pairs) // max(-(-len(pairs) // AT_ONCE), (threads + 1) // 2))
    batches = [
        [2 * pair + side for pair in pairs[first : first + size]]
        for first in range(0, len(pairs), size)
        for side in (0, 1)
    ]
    with Progress(f"{len(pairs)} pairs of {found.path.name} again", steps) as progress:

        def take(lines: list[MatchLine]) -> None:
            for line in lines:
                differing[line.match] = differences(found.lines[line.match], asdict(line))
                if line.match % 2:  # the second match of a pair comes after the first
                    tell(line.pair, differing[line.match - 1] + differing[line.match])

        play_batches(
            contest, batches, settings_hash(found.conditions, found.made_with), threads, take, progress.advance
        )
    return [difference for number in sorted(differing) for difference in differing[number]]


def unlike_result(found: Found, contest: Contest) -> tuple[str, ...] | None:
    """Return the fields of a folder's result.json that do not follow from its lines; None if there is no such file.

    An evaluation that grows has the result of the smaller one until it is finished.
    """
    there = found.result
    if there is None:
        return None
    matches = there.get("matches")
    if not isinstance(matches, int) or matches not in found.sizes:
        return (f"its matches, {brief(matches)},",)
    missing = matches - sum(number < matches for number in found.lines)
    if missing:
        return (f"all of it, as {missing} of its {matches} matches have no line,",)
    asked: dict[str, Any] = {**found.conditions, "matches": matches}
    conditions = Conditions(**{**asked, "players": tuple(asked["players"]), "senses": tuple(asked["senses"])})
    settings = settings_hash(asked, found.made_with)
    lines = [MatchLine(**{**found.lines[number], "settings": settings}) for number in range(matches)]
    try:
        for line in lines:
            check_line(line, conditions.players)
    except ValueError as error:
        return (f"all of it, for {error}",)
    result = summarise(conditions, found.made_with, lines, contest.league.pitch).as_dict()
    again = json.loads(json.dumps(result))
    names = dict.fromkeys([*there, *again])
    return tuple(brief(name) for name in names if json.dumps(there.get(name)) != json.dumps(again.get(name)))


def differences(there: dict[str, Any], again: dict[str, Any]) -> list[Difference]:
    """Return the fields in which two records of a match differ, each once; a number and its text are different."""
    both = [dict(leaves(record)) for record in (there, json.loads(json.dumps(again)))]
    fields: dict[tuple[Any, ...], list[tuple[tuple[Any, ...], str, str]]] = {}
    for place in dict.fromkeys([*both[0], *both[1]]):
        before, now = (text_of(record[place]) if place in record else NOTHING for record in both)
        if before != now:
            fields.setdefault(place[:DEEP], []).append((place, before, now))
    found = []
    for places in fields.values():
        place, before, now = places[0]
        name = ".".join(map(name_of, place))
        found.append(Difference(again["pair"], again["match"], name, before, now, len(places) - 1))
    return found


def leaves(value: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], Any]]:
    """Yield every value that is neither a table nor a list, with the names and numbers that lead to it.

    A table and a list are values themselves if nothing is in them.
    """
    if isinstance(value, (dict, list)) and value:
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from leaves(inner, (*place, key))
    else:
        yield place, value


def text_of(value: Any) -> str:
    """Return a value so that two texts are the same only if the values are, bit for bit."""
    return brief(value) if isinstance(value, str) and len(value) < 60 else json.dumps(value)[:200]


def name_of(key: Any) -> str:
    """Return a name on the way to a value as it can be printed."""
    return key if isinstance(key, str) and key.isidentifier() else brief(key)
