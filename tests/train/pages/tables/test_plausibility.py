"""Play beside published figures: when a figure lies inside, and that play of now is not absurdly far from it."""

import pytest

from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.pages.tables import plausibility
from soccer_env.train.pages.tables.plausibility import PUBLISHED, SHOWN, cell_of, plausibility_rows, verdict
from soccer_env.train.pages.tables.teams import row_of


@pytest.mark.parametrize(
    ("low", "high", "inside"),
    [(0.1, 0.3, True), (0.01, 0.05, True), (0.70, 2.0, True), (0.71, 2.0, False), (0.0, 0.04, False)],
)
def test_an_interval_that_meets_the_range_is_inside(low, high, inside):
    assert (PUBLISHED["legged-2001", "goals"].low, PUBLISHED["legged-2001", "goals"].high) == (0.05, 0.7)
    assert verdict("legged-2001", "goals", low, high) == ("inside" if inside else "outside")
    assert verdict("legged-2001", "passes", low, high) == ""


def test_published_figures_are_those_of_the_games_they_name() -> None:
    legged = (3, 3, 6, 3, 2, 3, 14, 2, 6, 11, 1, 9)
    assert (sum(legged), len(legged), min(legged) / 20, max(legged) / 20) == (63, 12, 0.05, 0.7)
    middle = (6, 10, 3, 4, 12, 6, 5, 8, 12, 6)
    assert (sum(middle), len(middle), max(middle) / 30) == (72, 10, PUBLISHED["middle-size-2006", "goals"].high)
    assert all((row.league, "goals") in PUBLISHED for row in plausibility_rows())


def test_a_row_shows_what_both_teams_did_together() -> None:
    """So few matches say little: the bound is twice the goals of the richest real game."""
    settings = EvaluateSettings(home="chaser", away="chaser", matches=8, minutes=3.0, senses="ideal", seed=5)
    result = evaluate(settings)
    play = plausibility.statistics_of_play(result)
    assert [*play] == [*SHOWN]
    value, low, high, unit = play["goals"]
    assert value == pytest.approx((result.goals_for + result.goals_against) / (8 * 3.0))
    assert unit == "/min"
    assert low <= value <= high
    assert value < 2 * PUBLISHED["legged-2001", "goals"].high
    assert 50.0 < play["in_play"][0] <= 100.0
    row = row_of(settings, result) | {"play": play}
    assert cell_of(row, "goals").endswith(") inside") or cell_of(row, "goals").endswith(") outside")
    assert cell_of(row, "passes").endswith(")"), "nothing is published of passes"
