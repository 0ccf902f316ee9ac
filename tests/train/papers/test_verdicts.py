"""Verdicts say what the head of the claim table asks for, from intervals that agree with scipy's."""

import numpy as np
import pytest

from soccer_env.train.papers import verdicts
from soccer_env.train.papers.verdicts import CONTEXT, NOT, REPRODUCED, UNDECIDED, Finding
from soccer_env.train.statistics import clustered_share, unit_bootstrap, wilson_interval

stats = pytest.importorskip("scipy.stats")
DRAWS = np.random.default_rng(3).normal(0.4, 1.5, 37)


def finding(verdict: str) -> Finding:
    return Finding(verdict, "", 0.0, 0.0, 0.0, verdict, 1)


UNDER_TEN, BETWEEN = {"at_most": 10.0}, {"at_least": 0.45, "at_most": 0.6}
CASES = [
    (UNDER_TEN, 3.0, 9.0, REPRODUCED), (UNDER_TEN, 3.0, 10.0, REPRODUCED), (UNDER_TEN, 3.0, 10.1, UNDECIDED),
    (UNDER_TEN, 10.0, 12.0, UNDECIDED), (UNDER_TEN, 10.1, 12.0, NOT), (UNDER_TEN, -np.inf, np.inf, UNDECIDED),
    ({"at_least": 3.0}, 3.0, 5.0, REPRODUCED), ({"at_least": 3.0}, 2.0, 2.9, NOT),
    (BETWEEN, 0.5, 0.59, REPRODUCED), (BETWEEN, 0.61, 0.7, NOT), (BETWEEN, 0.4, 0.7, UNDECIDED),
    ({"above": 0.0}, 0.1, 0.2, REPRODUCED), ({"above": 0.0}, 0.0, 0.0, NOT), ({"above": 0.0}, 0.0, 0.2, UNDECIDED),
    ({"below": 0.0}, -2.0, -1.0, REPRODUCED),
]  # fmt: skip


@pytest.mark.parametrize(("bounds", "low", "high", "verdict"), CASES)
def test_the_whole_interval_decides(bounds: dict[str, float], low: float, high: float, verdict: str) -> None:
    assert verdicts.judge(verdicts.exact("", lambda samples: 0.0, **bounds), low, high) == verdict


def test_a_reported_number_decides_nothing_and_an_exact_one_has_no_width() -> None:
    median = verdicts.reported("median", lambda samples: float(np.median(samples["x"])))
    found = verdicts.judge_criterion(median, {"x": DRAWS})
    assert found.verdict == CONTEXT and found.low < found.estimate < found.high
    found = verdicts.judge_criterion(verdicts.exact("", lambda samples: 3.0, unit="cm", at_most=3.0), {})
    assert (found.low, found.high, found.verdict) == (3.0, 3.0, REPRODUCED)


def test_a_claim_needs_all_of_its_criteria_and_one_violation_is_enough() -> None:
    good, bad, open_, told = (finding(verdict) for verdict in (REPRODUCED, NOT, UNDECIDED, CONTEXT))
    assert verdicts.combine([good, good, told]) == REPRODUCED
    assert verdicts.combine([good, open_]) == UNDECIDED
    assert verdicts.combine([good, open_, bad]) == NOT
    assert verdicts.combine([told]) == verdicts.combine([]) == CONTEXT
    assert verdicts.deciding_finding([good, open_, bad]) is bad
    assert verdicts.deciding_finding([told, good]) is good
    assert verdicts.deciding_finding([]) is None


def test_one_of_several_criteria_refutes_at_a_confidence_that_they_share() -> None:
    """Intervals of a normal mean: 1.96 standard errors at 95 %, 2.24 at 97.5 %."""
    error = 1.0

    def interval(samples: dict[str, np.ndarray], level: float) -> tuple[float, float, float]:
        wide = float(stats.norm.ppf(0.5 + 0.5 * level)) * error
        return 2.1, 2.1 - wide, 2.1 + wide

    low = verdicts.Criterion("", "", interval, lambda samples: 1, high=0.0)
    assert [verdicts.judge_criterion(low, {}, criteria=m).verdict for m in (1, 2)] == [NOT, UNDECIDED]
    high = verdicts.Criterion("", "", interval, lambda samples: 1, low=0.0)
    assert verdicts.judge_criterion(high, {}, criteria=9).verdict == REPRODUCED


@pytest.mark.parametrize("bounds", [{}, {"at_least": 1.0, "above": 1.0}, {"more": 1.0}])
def test_bounds_that_say_nothing_are_refused(bounds: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="bounds are at_least"):
        verdicts.measured("", lambda samples: 0.0, **bounds)


def test_units_with_many_frames_are_drawn_whole() -> None:
    """Frames of one run err alike: the interval must not shrink because a run has many of them."""
    runs = np.random.default_rng(2).normal(0.0, 1.0, (30, 1))
    few = unit_bootstrap({"x": runs}, lambda x: float(x["x"].mean()))
    many = unit_bootstrap({"x": np.repeat(runs, 50, axis=1)}, lambda x: float(x["x"].mean()))
    assert many == pytest.approx(few)


def test_a_value_that_is_not_always_there_leaves_the_interval_open() -> None:
    rare = np.array([1.0] + [np.nan] * 9)

    def value(samples: dict[str, np.ndarray]) -> float:
        found = samples["x"][np.isfinite(samples["x"])]
        return float(found.mean()) if len(found) else float("nan")

    assert unit_bootstrap({"x": rare}, value) == (1.0, -np.inf, np.inf)
    assert verdicts.judge_criterion(verdicts.measured("", value, at_least=0.0), {"x": rare}).verdict == UNDECIDED
    assert verdicts.judge_criterion(verdicts.measured("", value, at_least=0.0), {"x": rare[1:]}).verdict == UNDECIDED


@pytest.mark.parametrize("wins", [0, 1, 17, 40])
def test_a_counted_share_of_single_trials_is_wilsons(wins: int) -> None:
    hits, trials = np.arange(40) < wins, np.ones(40)
    expected = stats.binomtest(wins, 40).proportion_ci(method="wilson")
    share, low, high = clustered_share(hits, trials)
    assert (share, low, high) == pytest.approx(wilson_interval(wins, 40), abs=1e-12)
    assert (low, high) == pytest.approx((expected.low, expected.high), abs=1e-12)
    half = verdicts.counted("", "hits", "trials", at_most=50.0)
    found = verdicts.judge_criterion(half, {"hits": hits, "trials": trials})
    assert found.high == pytest.approx(100.0 * expected.high)


def test_trials_that_go_the_same_way_in_a_unit_count_as_one() -> None:
    hits = np.where(np.arange(40) < 10, 25, 0)
    assert clustered_share(hits, np.full(40, 25)) == pytest.approx(wilson_interval(10, 40), abs=1e-12)
    assert clustered_share(np.zeros(40), np.full(40, 25)) == pytest.approx(wilson_interval(0, 40), abs=1e-12)


def test_a_counted_share_covers_the_truth() -> None:
    rng = np.random.default_rng(5)
    inside = 0
    for _ in range(300):
        chances = rng.beta(2.0, 6.0, 60)  # mean 0.25, differing between units
        _, low, high = clustered_share(rng.binomial(12, chances), np.full(60, 12))
        inside += low <= 0.25 <= high
    assert 270 <= inside <= 298  # 95 % of 300 is 285


def test_no_trials_mean_that_every_share_is_possible() -> None:
    share, low, high = clustered_share(np.zeros(3), np.zeros(3))
    assert np.isnan(share) and (low, high) == (0.0, 1.0)
    with pytest.raises(ValueError, match="hits must be 0 to trials"):
        clustered_share([2], [1])


def test_a_criterion_says_in_words_where_it_has_to_lie() -> None:
    def value(samples: dict[str, np.ndarray]) -> float:
        return 3.0

    assert verdicts.measured("", value, at_least=80.0).asked == "at least 80"
    assert verdicts.measured("", value, above=0.0, below=0.125).asked == "above 0 and below 0.125"
    assert verdicts.counted("", "hits", "trials", at_most=5.0).asked == "at most 5"
    assert verdicts.reported("", value).asked == ""
    both = verdicts.exact("", value, at_least=35.0, at_most=55.0)
    assert verdicts.judge_criterion(both, {}).asked == "at least 35 and at most 55"
