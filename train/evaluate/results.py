"""The results of an evaluation: one line for each match, and the summary of all lines."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from soccer_env.leagues.league import Pitch
from soccer_env.match.settings import to_plain_types
from soccer_env.statistics.maps import sum_maps
from soccer_env.train.evaluate.settings import Conditions
from soccer_env.train.evaluate.statistics import Total, totals
from soccer_env.train.results_folder import RunKind
from soccer_env.train.statistics import paired_bootstrap, required_matches

CLEAR_POINTS = 0.95  # [1] share of the points for "beats clearly"
LEAST_PAIRS = 5  # fewer pairs say nothing about the scatter of results: no verdict
SELF_PLAY = "no verdict on a team against itself: the goal difference is home less away"
MATCHES = "matches.jsonl"  # of a folder: a line for each finished match
LEFT_OUT = ("settings", "statistics", "maps")  # fields of a line that result.json omits: matches.jsonl has them
FILES = (MATCHES, "result.json", "report.md", "report.html", "match.png")
REPLAYS, KEPT = "replays", "kept.json"  # the folder of kept replays, and the list in it
KEPT_FILES = [f"{REPLAYS}/*-match-[0-9]*-seed-[0-9]*.{kind}" for kind in ("replay", "html")] + [f"{REPLAYS}/{KEPT}"]
EVALUATION = RunKind("an evaluation", ("home", "away", "scene"), FILES, lambda _: KEPT_FILES, grows=("matches",))
HALF_WIDTH = 0.25  # [goals a match] half width of the interval for which the number of matches is estimated


@dataclass(frozen=True)
class MatchLine:
    """The result of a finished match, a line of matches.jsonl; goals are counted from the first team's side."""

    match: int  # 0, 1, ...; matches 2 p and 2 p + 1 are pair p, from one seed except in self-play
    pair: int
    seed: int  # of the match
    side: str  # the first team played as "home" or as "away"
    goals_for: int
    goals_against: int
    steps: int  # control steps
    state: str  # hash of the final state, equal if the match is played again
    settings: str  # hash of the conditions, versions and code
    statistics: dict[str, Any] = field(default_factory=dict)  # of the match, see `soccer list statistics`
    maps: dict[str, Any] = field(default_factory=dict)  # see `statistics.maps.maps_of`

    @property
    def points(self) -> float:
        """Return the first team's points: 1 for a win, 0.5 for a draw, 0 for a defeat."""
        return 0.5 * (1 + (self.goals_for > self.goals_against) - (self.goals_for < self.goals_against))


@dataclass(frozen=True)
class Estimate:
    """A mean with its 95 % interval."""

    mean: float
    low: float
    high: float


@dataclass(frozen=True)
class EvaluationResult:
    """The result of an evaluation, seen from the first team's (home's) side."""

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
    statistics: dict[str, Total]  # of play, by name; nothing if lines lack them
    maps: dict[str, Any]  # of all matches together; nothing if lines lack them
    lines: tuple[MatchLine, ...]  # sorted
    trained: dict[str, str] = field(default_factory=dict)  # training settings that differ, by the policy's name

    def as_dict(self) -> dict[str, Any]:
        """Return the result as a dict of plain values, the contents of result.json."""
        record = asdict(self)
        conditions, lines = record.pop("conditions"), record.pop("lines")
        conditions |= {"players": self.conditions.sizes, "senses": self.conditions.senses_text}
        record["settings_hash"] = self.lines[0].settings
        record["version"] = self.made_with.get("soccer_env", "")
        record["results"] = [{name: line[name] for name in line if name not in LEFT_OUT} for line in lines]
        return {**conditions, **record}


def summarise(
    conditions: Conditions, made_with: dict[str, str], lines: Sequence[MatchLine], pitch: Pitch | None = None
) -> EvaluationResult:
    """Compute the result of an evaluation from the lines of all matches; maps get the dimensions of `pitch`."""
    ordered = tuple(sorted(lines, key=lambda line: line.match))
    if [line.match for line in ordered] != list(range(conditions.matches)):
        raise ValueError(f"expected matches 0 to {conditions.matches - 1}, got {len(ordered)} lines")
    differences = pair_means(ordered, lambda line: line.goals_for - line.goals_against)
    points = Estimate(*paired_bootstrap(pair_means(ordered, lambda line: line.points)))
    difference = Estimate(*paired_bootstrap(differences))
    maps = sum_maps([line.maps for line in ordered]) if all(line.maps for line in ordered) else {}
    if maps and pitch is not None:
        maps["pitch"] = to_plain_types(pitch)
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
        verdict=SELF_PLAY if conditions.self_play else judge(difference, points, len(differences)),
        statistics=totals([line.statistics for line in ordered]),
        maps=maps,
        lines=ordered,
    )


def pair_means(lines: Sequence[MatchLine], value: Callable[[MatchLine], float]) -> list[float]:
    """Return, for each pair of matches, the mean of the function `value` over its two lines; lines sorted by match."""
    return [(value(first) + value(second)) / 2 for first, second in zip(lines[::2], lines[1::2], strict=True)]


def judge(difference: Estimate, points: Estimate, pairs: int) -> str:
    """Return the verdict about the first team, such as "beats clearly", from its goal difference and points."""
    if pairs < LEAST_PAIRS:
        return f"no verdict from fewer than {2 * LEAST_PAIRS} matches"
    if difference.low > 0.0:
        return "beats clearly" if points.mean >= CLEAR_POINTS else "beats"
    if difference.high < 0.0:
        return "loses clearly" if points.mean <= 1.0 - CLEAR_POINTS else "loses"
    return "no difference shown"
