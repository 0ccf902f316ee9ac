"""Ratings find the strengths behind results, their intervals cover them, and they do not depend on the teams' order."""

from itertools import combinations
from math import log10

import numpy as np
import pytest
from openskill.models import PlackettLuce

from soccer_env.train.evaluate.results import Estimate
from soccer_env.train.tournament.ratings import LOGIT, Results, matches_needed, rate_teams

STRENGTHS = np.array([1.2, 0.5, 0.1, -0.3, -1.5])  # natural logarithms of odds, mean 0


def played(strengths: np.ndarray, pairs: int, rng: np.random.Generator) -> Results:
    """Return the points of pairings whose chances follow from strengths; a third of the matches are drawn."""
    results = []
    for first, second in combinations(range(len(strengths)), 2):
        share = 1.0 / (1.0 + np.exp(strengths[second] - strengths[first]))
        drawn = rng.random(2 * pairs) < 2.0 * min(share, 1.0 - share) / 3.0
        won = rng.random(2 * pairs) < (share - 0.5 * drawn.mean()) / (1.0 - drawn.mean())
        results.append((first, second, np.where(drawn, 0.5, won)))
    return results


def points(*scored: float) -> np.ndarray:
    return np.array(scored)


def test_three_wins_of_four_are_the_elo_difference_of_its_definition() -> None:
    ratings = rate_teams(2, [(0, 1, np.tile(points(1.0, 1.0, 1.0, 0.0), 2500))])
    assert ratings.elo[0].mean - ratings.elo[1].mean == pytest.approx(400.0 * log10(3.0), abs=0.1)
    assert ratings.elo[0].mean + ratings.elo[1].mean == pytest.approx(3000.0)


def test_known_strengths_are_found_from_many_matches() -> None:
    ratings = rate_teams(5, played(STRENGTHS, 1500, np.random.default_rng(1)))
    assert [one.mean - 1500.0 for one in ratings.elo] == pytest.approx((LOGIT * STRENGTHS).tolist(), abs=10.0)
    assert np.argsort([-one.mean for one in ratings.openskill]).tolist() == [0, 1, 2, 3, 4]
    assert ratings.above[np.triu_indices(5, 1)].min() > 0.99


def test_the_intervals_cover_the_truth_in_about_nineteen_tournaments_of_twenty() -> None:
    rng, true = np.random.default_rng(2), 1500.0 + LOGIT * STRENGTHS
    inside = [
        one.low <= value <= one.high
        for _ in range(60)
        for one, value in zip(rate_teams(5, played(STRENGTHS, 20, rng)).elo, true, strict=True)
    ]
    assert 0.90 <= np.mean(inside) <= 0.99


def test_openskill_intervals_cover_the_skills_that_its_own_model_plays_by() -> None:
    rng, inside, beta = np.random.default_rng(3), [], PlackettLuce().beta
    for _ in range(20):
        skills = rng.normal(25.0, 4.0, 4)
        results = played((skills - skills.mean()) / (beta * np.sqrt(2.0)), 20, rng)
        ratings = rate_teams(4, results).openskill
        shift = np.mean([one.mean for one in ratings]) - skills.mean()  # only differences are told
        inside += [one.low <= skill + shift <= one.high for one, skill in zip(ratings, skills, strict=True)]
    assert np.mean(inside) >= 0.9


def test_openskill_ratings_are_those_of_the_package_match_after_match() -> None:
    model = PlackettLuce()
    first, second = model.rating(), model.rating()
    for ranks in ([0.0, 1.0], [0.5, 0.5]):
        (first,), (second,) = model.rate([[first], [second]], ranks=ranks)
    found = rate_teams(2, [(0, 1, points(1.0, 0.5))]).openskill
    assert [one.mean for one in found] == [first.mu, second.mu]
    assert found[0].high - found[0].mean == pytest.approx(1.96 * first.sigma)


def test_elo_does_not_depend_on_the_order_of_teams_or_matches() -> None:
    results = played(STRENGTHS, 10, np.random.default_rng(4))
    turned = [(4 - second, 4 - first, 1.0 - scored[::-1]) for first, second, scored in results[::-1]]
    one, other = (rate_teams(5, given) for given in (results, turned))
    assert [x.mean for x in one.elo] == pytest.approx([x.mean for x in other.elo[::-1]])
    assert one.above + one.above.T == pytest.approx(np.ones((5, 5)))


def test_a_team_that_always_wins_and_teams_that_never_met_have_finite_ratings() -> None:
    best, *_, worst = rate_teams(4, [(0, 1, np.ones(40)), (2, 3, np.ones(40))]).elo
    assert 1500.0 < best.mean < 2500.0 and worst.mean == pytest.approx(3000.0 - best.mean)


def test_equal_teams_are_each_above_the_other_half_of_the_time() -> None:
    assert rate_teams(2, [(0, 1, np.full(20, 0.5))]).above[0, 1] == 0.5


def test_the_number_of_matches_for_an_interval_gives_that_interval() -> None:
    few = rate_teams(5, played(STRENGTHS, 20, np.random.default_rng(5))).elo
    needed = matches_needed(few, 25.0, 40)
    assert needed is not None and needed % 2 == 0 and needed > 40
    many = rate_teams(5, played(STRENGTHS, needed // 2, np.random.default_rng(6))).elo
    assert max(0.5 * (one.high - one.low) for one in many) == pytest.approx(25.0, rel=0.15)
    assert matches_needed([Estimate(1500.0, 1500.0, 1500.0)], 25.0, 40) is None
