"""Who meets whom: round robin, Swiss or knock-out. Teams are numbers, in the order in which they were named.

A round follows from the results of the rounds before it alone, so a stopped tournament goes on with the same pairings.
"""

from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

ROUND_ROBIN, SWISS, KNOCK_OUT = "round-robin", "swiss", "knock-out"
SYSTEMS = (ROUND_ROBIN, SWISS, KNOCK_OUT)
Pair = tuple[int, int]  # two teams, the one named earlier first


class Score(NamedTuple):
    """The result of a finished pairing."""

    first: int
    second: int
    points: float  # the first team's share of the points, 0 to 1
    goals: float  # its goal difference


def next_round(system: str, teams: int, rounds: int, played: Sequence[Sequence[Score]]) -> list[Pair]:
    """Return the pairings of the round after the rounds `played`; [] at the end. `rounds`: of a Swiss tournament."""
    if system == ROUND_ROBIN:
        return [] if played else list(combinations(range(teams), 2))
    if system == SWISS:
        return swiss_round(teams, played) if len(played) < rounds else []
    return knock_out_round(teams, played)


def count_pairings(system: str, teams: int, rounds: int) -> int:
    """Return the number of pairings of a whole tournament."""
    return {ROUND_ROBIN: teams * (teams - 1) // 2, SWISS: rounds * (teams // 2), KNOCK_OUT: teams - 1}[system]


def default_rounds(teams: int) -> int:
    """Return the rounds that a Swiss tournament needs for a single unbeaten team."""
    return (teams - 1).bit_length()


def most_rounds(teams: int) -> int:
    """Return the number of Swiss rounds in which all teams surely find opponents that they have not met."""
    return (teams + 1) // 2


def swiss_round(teams: int, played: Sequence[Sequence[Score]]) -> list[Pair]:
    """Pair neighbours in the table that have not met; of an odd number one of the last has a bye, once at most."""
    points, met = swiss_points(teams, played), {(score.first, score.second) for scores in played for score in scores}
    met |= {(team, teams) for scores in played for team in byes(teams, scores)}  # number `teams` is the bye
    order = sorted(range(teams), key=lambda team: (-points[team], team)) + [teams] * (teams % 2)
    return sorted(pair for pair in pair_neighbours(order, met) or [] if teams not in pair)


def swiss_points(teams: int, played: Sequence[Sequence[Score]]) -> list[float]:
    """Return each team's points, 1 for a whole pairing; a bye counts as 1."""
    points = [0.0] * teams
    for scores in played:
        for score in scores:
            points[score.first] += score.points
            points[score.second] += 1.0 - score.points
        for team in byes(teams, scores):
            points[team] += 1.0
    return points


def byes(teams: int, scores: Sequence[Score]) -> set[int]:
    """Return the teams without an opponent in a round."""
    return set(range(teams)) - {team for score in scores for team in (score.first, score.second)}


def pair_neighbours(order: list[int], met: set[Pair]) -> list[Pair] | None:
    """Pair all teams of `order`, each with the nearest below it that allows the rest to be paired; None: impossible."""
    if not order:
        return []
    for other in order[1:]:
        pair = (min(order[0], other), max(order[0], other))
        if pair not in met:
            rest = pair_neighbours([team for team in order[1:] if team != other], met)
            if rest is not None:
                return [pair, *rest]
    return None


def knock_out_round(teams: int, played: Sequence[Sequence[Score]]) -> list[Pair]:
    """Pair the first team left with the last, and so on; in the first round the first teams have byes if need be."""
    out = {loser(score) for scores in played for score in scores}
    left = [team for team in range(teams) if team not in out]
    playing = left[(1 << default_rounds(len(left))) - len(left) :]
    return [(playing[at], playing[-1 - at]) for at in range(len(playing) // 2)]


def loser(score: Score) -> int:
    """Return the team that is out: by points, then by goals; of two equal teams the one that was named later."""
    return score.first if (score.points, score.goals) < (0.5, 0.0) else score.second
