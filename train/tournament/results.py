"""The result of a tournament: a standing and ratings for each team, and the results of all pairings."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from soccer_env.train.evaluate.replays import Kept
from soccer_env.train.evaluate.results import LEAST_PAIRS, Estimate, EvaluationResult
from soccer_env.train.results_folder import RunKind
from soccer_env.train.tournament.ratings import matches_needed, rate_teams
from soccer_env.train.tournament.settings import PAIRINGS
from soccer_env.train.tournament.systems import KNOCK_OUT, SWISS, Score, byes, loser

FILES = ("result.json", "report.html")
KIND = RunKind(
    "a tournament", ("teams", "system", "league"), FILES, lambda _: [f"{PAIRINGS}/[0-9]*"], grows=("teams", "matches")
)


@dataclass(frozen=True)
class Pairing:
    """A finished pairing; teams are numbers in the order in which they were named."""

    round: int  # 1, 2, ...
    first: int
    second: int
    result: EvaluationResult  # of the first team
    folder: str  # in the folder of the tournament
    kept: tuple[Kept, ...] = ()  # replays

    @property
    def score(self) -> Score:
        """Return the score, from which later pairings follow."""
        return Score(self.first, self.second, self.result.points.mean, self.result.goal_difference.mean)

    @property
    def points(self) -> np.ndarray:
        """Return the first team's points in each match (N,)."""
        return np.array([line.points for line in self.result.lines])


@dataclass(frozen=True)
class Standing:
    """A team's results and ratings."""

    team: str
    matches: int
    wins: int
    draws: int
    losses: int
    goals_for: int
    goals_against: int
    points: float  # 1 for a win, 0.5 for a draw; of a Swiss tournament 1 for each match of a bye as well
    pairings_won: int
    openskill: Estimate
    elo: Estimate


@dataclass(frozen=True)
class TournamentResult:
    """The result of a tournament; `standings` and `above` begin with the best team."""

    conditions: dict[str, Any]
    made_with: dict[str, str]  # versions and hashes
    standings: tuple[Standing, ...]
    above: dict[str, dict[str, float]]  # by names: the probability that one team's Elo rating is above the other's
    pairings: tuple[Pairing, ...]  # in the order in which they were played
    half_width: float  # [Elo] wanted, of the ratings' intervals
    matches_needed: int | None  # of a pairing, for it; None if results do not scatter

    @property
    def names(self) -> list[str]:
        """Return the names of the teams, the best first."""
        return [standing.team for standing in self.standings]

    @property
    def few(self) -> bool:
        """Tell whether there are too few matches for intervals."""
        return int(self.conditions["matches"]) < 2 * LEAST_PAIRS

    def as_dict(self) -> dict[str, Any]:
        """Return the result as a dict of plain values, the contents of result.json."""
        names = self.conditions["teams"]
        return {
            **self.conditions,
            "made_with": self.made_with,
            "standings": [asdict(standing) for standing in self.standings],
            "above": self.above,
            "half_width": self.half_width,
            "matches_needed": self.matches_needed,
            "pairings": [pairing_record(pairing, names) for pairing in self.pairings],
        }


def pairing_record(pairing: Pairing, names: Sequence[str]) -> dict[str, Any]:
    """Return the result of a pairing as plain values; its folder has all matches."""
    result = pairing.result
    kept = ("wins", "draws", "losses", "goals_for", "goals_against", "matches_needed", "verdict")
    return {
        "round": pairing.round,
        "home": names[pairing.first],
        "away": names[pairing.second],
        **{name: getattr(result, name) for name in kept},
        "goal_difference": asdict(result.goal_difference),
        "points": asdict(result.points),
        "settings_hash": result.lines[0].settings,
        "folder": pairing.folder,
    }


def summarise(
    conditions: dict[str, Any], made_with: dict[str, str], rounds: Sequence[Sequence[Pairing]], half_width: float
) -> TournamentResult:
    """Rate all teams and put them in order: by points, in a knock-out by pairings won; equal teams by Elo."""
    names, system = conditions["teams"], conditions["system"]
    pairings = tuple(pairing for one in rounds for pairing in one)
    ratings = rate_teams(len(names), [(one.first, one.second, one.points) for one in pairings])
    standings = [
        standing_of(team, name, pairings, free_points(team, len(names), rounds, conditions), *both)
        for team, (name, both) in enumerate(zip(names, zip(ratings.openskill, ratings.elo, strict=True), strict=True))
    ]

    def rank(team: int) -> tuple[float, float]:
        one = standings[team]
        return (-one.pairings_won if system == KNOCK_OUT else -one.points, -one.elo.mean)

    order = sorted(range(len(names)), key=rank)
    above = {names[a]: {names[b]: float(ratings.above[a, b]) for b in order if a != b} for a in order}
    needed = matches_needed(ratings.elo, half_width, conditions["matches"])
    ranked = tuple(standings[team] for team in order)
    return TournamentResult(conditions, made_with, ranked, above, pairings, half_width, needed)


def free_points(team: int, teams: int, rounds: Sequence[Sequence[Pairing]], conditions: dict[str, Any]) -> float:
    """Return the points of a team for the byes of a Swiss tournament."""
    if conditions["system"] != SWISS:
        return 0.0
    return float(conditions["matches"] * sum(team in byes(teams, [one.score for one in played]) for played in rounds))


def standing_of(
    team: int, name: str, pairings: Sequence[Pairing], free: float, openskill: Estimate, elo: Estimate
) -> Standing:
    """Return a team's standing; `free`: its points without a match."""
    home = [one.result for one in pairings if one.first == team]
    away = [one.result for one in pairings if one.second == team]
    wins = sum(one.wins for one in home) + sum(one.losses for one in away)
    draws = sum(one.draws for one in home + away)
    losses = sum(one.losses for one in home) + sum(one.wins for one in away)
    scores = [one.score for one in pairings if team in (one.first, one.second)]
    return Standing(
        team=name, matches=wins + draws + losses, wins=wins, draws=draws, losses=losses,
        goals_for=sum(one.goals_for for one in home) + sum(one.goals_against for one in away),
        goals_against=sum(one.goals_against for one in home) + sum(one.goals_for for one in away),
        points=wins + 0.5 * draws + free, pairings_won=sum(loser(score) != team for score in scores),
        openskill=openskill, elo=elo,
    )  # fmt: skip
