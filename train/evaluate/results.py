"""What an evaluation found: one line for each match, and the result that follows from the lines."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from soccer_env.train.evaluate.settings import Conditions
from soccer_env.train.files import append_lines, read_lines
from soccer_env.train.provenance import settings_hash
from soccer_env.train.statistics import paired_bootstrap, required_matches
from soccer_env.whole_files import write_whole

CLEAR_POINTS = 0.95  # [1] share of the points that "beats clearly" asks for [DESIGN.md]
LEAST_PAIRS = 5  # fewer say nothing about how results scatter: no verdict
MIRRORED = "no verdict: a team against itself plays each match of a pair twice, which says nothing"
HALF_WIDTH = 0.25  # [goals a match] for which the number of matches is worked out


@dataclass(frozen=True)
class MatchLine:
    """A finished match, goals from the first team's side."""

    match: int  # 0, 1, ...; matches 2 p and 2 p + 1 are pair p
    pair: int
    seed: int  # of the match
    side: str  # the first team played as "home" or as "away"
    goals_for: int
    goals_against: int
    steps: int  # control steps
    state: str  # hash of the last state: the same match again has the same
    settings: str  # hash of the conditions and of what the match was made with

    @property
    def points(self) -> float:
        """Return 1 for a win, 0.5 for a draw, 0 for a defeat."""
        return 0.5 * (1 + (self.goals_for > self.goals_against) - (self.goals_for < self.goals_against))


@dataclass(frozen=True)
class Estimate:
    """A mean with its 95 % interval."""

    mean: float
    low: float
    high: float


@dataclass(frozen=True)
class EvaluationResult:
    """The result of an evaluation from the first team's (home's) side; what is counted per match says so."""

    conditions: Conditions
    made_with: dict[str, str]  # versions and hashes
    wins: int
    draws: int
    losses: int
    goals_for: int
    goals_against: int
    goal_difference: Estimate  # a match
    win_rate: Estimate  # wins / matches
    points: Estimate  # share: a draw counts half
    matches_needed: int | None  # for +-HALF_WIDTH goals a match; None if pairs do not scatter
    verdict: str
    lines: tuple[MatchLine, ...]  # sorted

    def as_dict(self) -> dict[str, Any]:
        """Return what result.json holds."""
        record = asdict(self)
        conditions, lines = record.pop("conditions"), record.pop("lines")
        conditions |= {"players": self.conditions.sizes, "senses": self.conditions.senses_text}
        record["settings_hash"] = self.lines[0].settings
        record["version"] = self.made_with.get("soccer_env", "")
        record["results"] = [{name: line[name] for name in line if name != "settings"} for line in lines]
        return {**conditions, **record}


def summarise(conditions: Conditions, made_with: dict[str, str], lines: Sequence[MatchLine]) -> EvaluationResult:
    """Return the result of all matches of an evaluation."""
    ordered = tuple(sorted(lines, key=lambda line: line.match))
    if [line.match for line in ordered] != list(range(conditions.matches)):
        raise ValueError(f"expected matches 0 to {conditions.matches - 1}, got {len(ordered)} lines")
    differences = pair_means(ordered, lambda line: line.goals_for - line.goals_against)
    points = Estimate(*paired_bootstrap(pair_means(ordered, lambda line: line.points)))
    difference = Estimate(*paired_bootstrap(differences))
    return EvaluationResult(
        conditions=conditions,
        made_with=made_with,
        wins=sum(line.points == 1.0 for line in ordered),
        draws=sum(line.points == 0.5 for line in ordered),
        losses=sum(line.points == 0.0 for line in ordered),
        goals_for=sum(line.goals_for for line in ordered),
        goals_against=sum(line.goals_against for line in ordered),
        goal_difference=difference,
        win_rate=Estimate(*paired_bootstrap(pair_means(ordered, lambda line: float(line.points == 1.0)))),
        points=points,
        matches_needed=required_matches(differences, HALF_WIDTH) if len(set(differences)) > 1 else None,
        verdict=MIRRORED if is_mirrored(conditions) else judge(difference, points, len(differences)),
        lines=ordered,
    )


def pair_means(lines: Sequence[MatchLine], value: Callable[[MatchLine], float]) -> list[float]:
    """Return the mean of a quantity over the two matches of each pair, from sorted lines."""
    return [(value(first) + value(second)) / 2 for first, second in zip(lines[::2], lines[1::2], strict=True)]


def is_mirrored(conditions: Conditions) -> bool:
    """Tell whether a team plays itself: with sides swapped, both matches of a pair are then one and the same."""
    sizes, senses = conditions.players, conditions.senses
    return conditions.home == conditions.away and sizes[0] == sizes[1] and senses[0] == senses[1]


def judge(difference: Estimate, points: Estimate, pairs: int) -> str:
    """Return in words what the goal difference and the points of so many pairs say about the first team."""
    if pairs < LEAST_PAIRS:
        return f"no verdict from fewer than {2 * LEAST_PAIRS} matches"
    if difference.low > 0.0:
        return "beats clearly" if points.mean >= CLEAR_POINTS else "beats"
    if difference.high < 0.0:
        return "loses clearly" if points.mean <= 1.0 - CLEAR_POINTS else "loses"
    return "no difference shown"


PARTS = ("conditions", "made_with", "about")  # of settings.json
FILES = ("settings.json", "matches.jsonl", "result.json", "report.md", "match.png")


def remove_files(path: Path | None) -> None:
    """Remove the files of an evaluation from a folder; the settings last, since matches without them are refused."""
    if path is None:
        return
    for name in reversed(FILES):
        (path / name).unlink(missing_ok=True)


class Folder:
    """The files of one evaluation: FILES; or, without a path, none.

    `lines` are the matches already there. Raises ValueError if the folder holds an evaluation with other settings.
    """

    def __init__(self, path: Path | None, conditions: Conditions, made_with: dict[str, str], about: dict[str, str]):
        mine = {"conditions": asdict(conditions), "made_with": made_with, "about": about}
        mine = json.loads(json.dumps(mine))  # tuples become lists, as in the file
        self.path, self.about = path, about
        self.settings = settings_hash(mine["conditions"], made_with)
        self.lines: list[MatchLine] = []
        if path is None:
            return
        path.mkdir(parents=True, exist_ok=True)
        if (path / "settings.json").exists():
            self.about = check_same(path / "settings.json", mine)
            self.lines = self._read()
        elif (path / "matches.jsonl").exists():
            raise ValueError(f"{path} holds matches but no settings.json; give another folder")
        else:
            write_whole(path / "settings.json", json.dumps(mine, indent=2) + "\n")

    def add(self, lines: Sequence[MatchLine]) -> None:
        """Keep finished matches, on disk before this returns."""
        if self.path is not None:
            append_lines(self.path / "matches.jsonl", (asdict(line) for line in lines))
        self.lines += lines

    def write(self, name: str, content: str | bytes) -> None:
        """Write a file of the folder whole; without a folder nothing."""
        if self.path is not None:
            write_whole(self.path / name, content)

    def _read(self) -> list[MatchLine]:
        """Return the finished matches, each once."""
        path = Path(self.path or "") / "matches.jsonl"
        found: dict[int, MatchLine] = {}
        for record in read_lines(path):
            line = line_of(record, path)
            if line.settings != self.settings or found.setdefault(line.match, line) != line:
                raise ValueError(f"{path}: match {line.match} belongs to other settings; give another folder")
        return list(found.values())


def line_of(record: dict[str, Any], path: Path) -> MatchLine:
    """Return the match that a record of the file at `path` describes."""
    names = {field.name for field in fields(MatchLine)}
    if set(record) != names:
        raise ValueError(f"{path}: a match has the fields {', '.join(sorted(names))}, got {', '.join(sorted(record))}")
    return MatchLine(**record)


def read_conditions(path: Path) -> dict[str, Any]:
    """Return what a settings file says: conditions, made_with, about; ValueError if it does not."""
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{path} cannot be read as JSON ({error}); give another folder or anew") from error
    lacking = [part for part in PARTS if not (isinstance(found, dict) and isinstance(found.get(part), dict))]
    if lacking:
        raise ValueError(f"{path} holds no {', '.join(lacking)}: it is damaged; give another folder or anew")
    return dict(found)


def check_same(path: Path, mine: dict[str, Any], what: str = "an evaluation") -> dict[str, str]:
    """Return what else the settings file says; raise ValueError naming each condition that differs from mine."""
    theirs = read_conditions(path)
    differences = [
        f"{name} {theirs[part].get(name)!r} there, {mine[part].get(name)!r} now"
        for part in ("conditions", "made_with")
        for name in dict.fromkeys([*theirs[part], *mine[part]])
        if theirs[part].get(name) != mine[part].get(name)
    ]
    if differences:
        which = "; ".join(differences)
        raise ValueError(f"{path.parent} holds {what} with other settings ({which}); give another folder or anew")
    return dict(theirs["about"])
