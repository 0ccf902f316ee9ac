"""Who meets whom: everybody once, neighbours that have not met, or winners alone."""

from collections import Counter
from itertools import combinations

import pytest

from soccer_env.train.tournament.systems import (
    KNOCK_OUT,
    ROUND_ROBIN,
    SWISS,
    SYSTEMS,
    Score,
    count_pairings,
    default_rounds,
    most_rounds,
    next_round,
)


def rounds_of(system: str, teams: int, rounds: int = 0) -> list[list[Score]]:
    """Play a tournament in which the team named earlier wins."""
    played: list[list[Score]] = []
    while pairs := next_round(system, teams, rounds or default_rounds(teams), played):
        played.append([Score(first, second, 1.0, 1.0) for first, second in pairs])
    return played


def pairs_of(played: list[list[Score]]) -> list[tuple[int, int]]:
    return [(score.first, score.second) for scores in played for score in scores]


def test_in_a_round_robin_everybody_meets_everybody_once() -> None:
    assert pairs_of(rounds_of(ROUND_ROBIN, 5)) == list(combinations(range(5), 2))


@pytest.mark.parametrize("teams", range(2, 14))
def test_in_a_swiss_tournament_nobody_meets_a_team_twice_and_byes_go_round(teams: int) -> None:
    played = rounds_of(SWISS, teams, most_rounds(teams))
    pairs = pairs_of(played)
    assert len(played) == most_rounds(teams) >= default_rounds(teams)
    assert len(set(pairs)) == len(pairs) and all(first < second for first, second in pairs)
    games = Counter(team for pair in pairs for team in pair)
    assert {len(played) - games[team] for team in range(teams)} <= ({0, 1} if teams % 2 else {0})


def test_swiss_neighbours_in_the_table_meet() -> None:
    first, second, _ = rounds_of(SWISS, 8)
    assert [(one.first, one.second) for one in first] == [(0, 1), (2, 3), (4, 5), (6, 7)]
    assert [(one.first, one.second) for one in second] == [(0, 2), (1, 3), (4, 6), (5, 7)]


def test_in_a_knock_out_the_first_teams_have_byes_and_the_favourites_meet_in_the_final() -> None:
    assert [[(one.first, one.second) for one in scores] for scores in rounds_of(KNOCK_OUT, 6)] == [
        [(2, 5), (3, 4)], [(0, 3), (1, 2)], [(0, 1)],
    ]  # fmt: skip


@pytest.mark.parametrize(("points", "goals", "through"), [(0.4, 5.0, 1), (0.5, -0.1, 1), (0.5, 0.0, 0), (0.6, -1.0, 0)])
def test_a_knock_out_is_decided_by_points_then_goals_then_the_order_of_names(
    points: float, goals: float, through: int
) -> None:
    (final,) = next_round(KNOCK_OUT, 3, 0, [[Score(0, 1, points, goals)]])
    assert final == (through, 2)


@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("teams", [2, 5, 8])
def test_the_number_of_pairings_is_known_before(system: str, teams: int) -> None:
    rounds = default_rounds(teams)
    assert len(pairs_of(rounds_of(system, teams, rounds))) == count_pairings(system, teams, rounds)
