"""Play beside published means: when they are level, and that play of now is not absurdly far from them."""

import pytest

from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.pages.tables import plausibility
from soccer_env.train.pages.tables.plausibility import PUBLISHED, SHOWN, cell_of, plausibility_rows, verdict
from soccer_env.train.pages.tables.teams import row_of


@pytest.mark.parametrize(
    ("low", "high", "word"),
    [(0.1, 0.3, "level"), (0.01, 0.05, "below"), (0.03, 0.11, "below"), (0.35, 2.0, "level"), (0.5, 0.7, "above")],
)
def test_a_mean_is_level_with_a_published_one_if_their_intervals_meet(low, high, word):
    """A mean of 0.6 is above 5.25 goals in 20 minutes, although one of the twelve games had 14 goals."""
    assert verdict("legged-2001", "goals", low, high) == word
    assert verdict("legged-2001", "passes", low, high) == ""


def test_published_figures_are_those_of_the_games_they_name() -> None:
    """Student's t gives 0.14 and 0.07 for the half widths: with so few games, resampling is a little narrower."""
    legged, middle = (PUBLISHED[league, "goals"] for league in ("legged-2001", "middle-size-2006"))
    for known, mean, half in ((legged, 63 / 12 / 20, 0.13), (middle, 72 / 10 / 30, 0.07)):
        value, low, high = known.rate
        assert value == pytest.approx(mean)
        assert 0.7 * half < mean - low < half and 0.7 * half < high - mean < half
    assert legged.text.endswith("12 games of 20 min: 63 goals, 1 to 14 a game")
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
    assert value < 2 * max(PUBLISHED["legged-2001", "goals"].goals) / 20.0
    assert 50.0 < play["in_play"][0] <= 100.0
    row = row_of(settings, result) | {"play": play}
    assert cell_of(row, "goals").split()[-1] in ("below", "level", "above")
    assert cell_of(row, "passes").endswith(")"), "nothing is published of passes"
