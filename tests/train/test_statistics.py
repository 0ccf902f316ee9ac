"""Statistics agree with scipy and cover what they claim, and so does every interval that the package reports."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.statistics.figures import spell_quantile
from soccer_env.statistics.records import BINS
from soccer_env.train.evaluate.results import MatchLine, summarise
from soccer_env.train.evaluate.settings import EvaluateSettings, conditions_of
from soccer_env.train.evaluate.statistics import statistics_by_name, totals
from soccer_env.train.pages.tables.drills import half_width
from soccer_env.train.papers.verdicts import counted, judge_criterion, measured
from soccer_env.train.statistics import interquartile_mean, paired_bootstrap, required_matches, wilson_interval

stats = pytest.importorskip("scipy.stats")
DRAWS = np.random.default_rng(3).normal(0.4, 1.5, 37)


def test_bootstrap_equals_scipys() -> None:
    expected = stats.bootstrap((DRAWS,), np.mean, n_resamples=10_000, method="percentile", rng=np.random.default_rng(5))
    mean, low, high = paired_bootstrap(DRAWS, seed=5)
    assert mean == pytest.approx(DRAWS.mean())
    assert (low, high) == pytest.approx(tuple(expected.confidence_interval), abs=1e-12)


def test_bootstrap_is_repeatable_in_blocks_or_not_and_as_wide_as_the_pairs_differ(monkeypatch) -> None:
    whole = paired_bootstrap(DRAWS)
    assert paired_bootstrap(DRAWS) == whole and whole[1] < whole[0] < whole[2]
    monkeypatch.setattr("soccer_env.train.statistics.BLOCK", 1000)
    assert paired_bootstrap(DRAWS) == whole
    assert paired_bootstrap([2.0] * 8) == (2.0, 2.0, 2.0)


def test_higher_confidence_is_wider_and_more_pairs_are_narrower() -> None:
    _, low, high = paired_bootstrap(DRAWS)
    _, lower, higher = paired_bootstrap(DRAWS, confidence=0.99)
    assert lower < low and high < higher
    _, first, last = paired_bootstrap(np.tile(DRAWS, 4))
    assert last - first == pytest.approx((high - low) / 2, rel=0.1)


def test_bootstrap_covers_the_true_mean() -> None:
    rng = np.random.default_rng(0)
    inside = 0
    for trial in range(200):
        _, low, high = paired_bootstrap(rng.normal(1.0, 2.0, 40), resamples=500, seed=trial)
        inside += low <= 1.0 <= high
    assert 180 <= inside <= 199  # 95 % of 200 is 190; percentile intervals of 40 pairs are a little narrow


def test_pairing_narrows_the_interval() -> None:
    """What a seed gives to one side it gives to the other in the swapped match: the pair's mean cancels it."""
    rng = np.random.default_rng(1)
    luck = rng.normal(0.0, 3.0, 50)
    matches = np.stack([0.5 + luck, 0.5 - luck], axis=1) + rng.normal(0.0, 0.1, (50, 2))
    _, low, high = paired_bootstrap(matches.mean(axis=1))
    _, alone_low, alone_high = paired_bootstrap(matches.ravel())
    assert high - low < (alone_high - alone_low) / 5


@pytest.mark.parametrize(("wins", "trials"), [(0, 10), (10, 10), (1, 2), (7, 10), (190, 200), (1, 1)])
@pytest.mark.parametrize("confidence", [0.9, 0.95, 0.99])
def test_wilson_equals_scipys(wins: int, trials: int, confidence: float) -> None:
    expected = stats.binomtest(wins, trials).proportion_ci(confidence, method="wilson")
    share, low, high = wilson_interval(wins, trials, confidence=confidence)
    assert share == wins / trials
    assert (low, high) == pytest.approx((expected.low, expected.high), abs=1e-12)


@pytest.mark.parametrize("count", [1, 3, 4, 5, 8, 37])
def test_interquartile_mean_equals_scipys_trimmed_mean(count: int) -> None:
    assert interquartile_mean(DRAWS[:count]) == pytest.approx(stats.trim_mean(DRAWS[:count], 0.25))


def test_required_matches_gives_that_interval() -> None:
    needed = required_matches(DRAWS, 0.25)
    assert needed % 2 == 0
    pairs = np.random.default_rng(9).choice(DRAWS, needed // 2)
    _, low, high = paired_bootstrap(pairs)
    assert (high - low) / 2 == pytest.approx(0.25, rel=0.15)
    assert required_matches(DRAWS, 0.125) == pytest.approx(4 * needed, abs=8)


@pytest.mark.parametrize("bad", [[], [[1.0, 2.0]], [float("nan")], [float("inf"), 1.0]])
def test_bad_numbers_are_refused(bad: list) -> None:
    with pytest.raises(ValueError, match="at least one finite number"):
        paired_bootstrap(bad)


def test_bad_settings_are_refused() -> None:
    with pytest.raises(ValueError, match="3 of 2"):
        wilson_interval(3, 2)
    with pytest.raises(ValueError, match="between 0 and 1, got 95"):
        paired_bootstrap([1.0], confidence=95)
    with pytest.raises(ValueError, match="two pairs"):
        required_matches([1.0], 0.1)


PAIRS = 40
LEVEL = 0.95  # of all that is reported
Reported = tuple[float, float, float]  # value, low, high
Samples = dict[str, np.ndarray]  # (PAIRS, 2): of both matches of each pair


def drawn() -> Samples:
    """Return numbers of matches whose pairs scatter less than they do, with a long tail on one side."""
    rng = np.random.default_rng(6)
    luck = rng.normal(0.0, 2.0, PAIRS)
    even = np.stack([luck, -luck], axis=1) + rng.exponential(1.0, (PAIRS, 1))
    played = rng.uniform(50.0, 70.0, (PAIRS, 2))
    spells = rng.integers(0, 5, (PAIRS, 2, BINS)) * (np.arange(BINS) % 3 == 0)
    return {
        "goals": np.rint(even).astype(int), "shots": np.rint(np.abs(even)).astype(int), "played": played,
        "in_play": 0.7 * played, "still": 0.2 * played * rng.exponential(1.0, (PAIRS, 1)), "spells": spells,
    }  # fmt: skip


def lines_of(found: Samples) -> list[dict[str, Any]]:
    empty = dict.fromkeys([name for name, _ in statistics_by_name()], 0) | {"spell_lengths_against": [0] * BINS}
    return [
        {
            **empty, "shots_for": int(found["shots"][p, i]), "spell_lengths_for": found["spells"][p, i].tolist(),
            **{name: float(found[name][p, i]) for name in ("played", "in_play", "still")},
        }
        for p, i in np.ndindex(PAIRS, 2)
    ]  # fmt: skip


def evaluated(name: str) -> Callable[[Samples], Reported]:
    def report(found: Samples) -> Reported:
        lines = [
            MatchLine(2 * p + i, p, 0, "", max(goals, 0), max(-goals, 0), 0, "", "")
            for p, i in np.ndindex(PAIRS, 2)
            for goals in [int(found["goals"][p, i])]
        ]
        conditions = conditions_of(EvaluateSettings(matches=2 * PAIRS), find_league("legged-2001"))
        estimate = getattr(summarise(conditions, {}, lines), name)
        return estimate.mean, estimate.low, estimate.high

    return report


def of_play(name: str) -> Callable[[Samples], Reported]:
    def report(found: Samples) -> Reported:
        total = totals(lines_of(found))[name]
        assert total.value is not None and total.low is not None and total.high is not None
        return total.value, total.low, total.high

    return report


def ratio(part: str, whole: str, scale: float) -> Callable[[Samples], float]:
    return lambda found: scale * float(found[part].sum() / found[whole].sum())


def of_claim(found: Samples) -> Reported:
    """Return the finding on a measured criterion at the level of a claim that is looked at five times."""
    finding = judge_criterion(measured("", ratio("still", "played", 1.0), above=0.0), found, 1.0 - (1.0 - LEVEL) / 5)
    return finding.estimate, finding.low, finding.high


def of_counts(found: Samples) -> Reported:
    """Return the finding on a share whose trials hang together in units."""
    hits, trials = in_units(found)
    finding = judge_criterion(counted("", "hits", "trials", at_least=0.0), {"hits": hits, "trials": trials})
    return finding.estimate, finding.low, finding.high


def in_units(found: Samples) -> tuple[np.ndarray, np.ndarray]:
    trials = np.full(PAIRS, 12)
    return np.minimum(np.abs(found["goals"]).sum(axis=1), trials), trials


CASES: dict[str, tuple[Callable[[Samples], Reported], Callable[[Samples], float], float]] = {
    # what is reported, the quantity of any pairs, the level
    "goal difference": (evaluated("goal_difference"), lambda x: x["goals"].mean(), LEVEL),
    "points": (evaluated("points"), lambda x: (0.5 + 0.5 * np.sign(x["goals"])).mean(), LEVEL),
    "win rate": (evaluated("win_rate"), lambda x: (x["goals"] > 0).mean(), LEVEL),
    "shots a minute": (of_play("shots_for"), ratio("shots", "played", 60.0), LEVEL),
    "still": (of_play("still"), ratio("still", "in_play", 100.0), LEVEL),
    "median spell": (of_play("spell_median_for"), lambda x: spell_quantile(x["spells"].sum(axis=(0, 1)), 0.5), LEVEL),
    "claim": (of_claim, ratio("still", "played", 1.0), 1.0 - (1.0 - LEVEL) / 5),
    "counted": (of_counts, lambda x: 100.0 * in_units(x)[0].mean() / 12.0, LEVEL),
}


def by_scipy(value: Callable[[Samples], float], found: Samples, level: float) -> tuple[float, float]:
    """Return scipy's percentile interval of a quantity, pairs drawn as pairs."""

    def of_rows(rows: np.ndarray) -> float:
        return value({name: numbers[rows.astype(int)] for name, numbers in found.items()})

    units = len(next(iter(found.values())))
    given = {"n_resamples": 4000, "method": "percentile", "vectorized": False, "confidence_level": level}
    ends = stats.bootstrap((np.arange(units),), of_rows, rng=np.random.default_rng(8), **given).confidence_interval
    return float(ends.low), float(ends.high)


def assert_like_scipys(reported: Reported, value: Callable[[Samples], float], found: Samples, level: float) -> None:
    """Assert that a reported interval is scipy's, but for what so many resamples may differ."""
    told, low, high = reported
    expected_low, expected_high = by_scipy(value, found, level)
    assert told == pytest.approx(value(found))
    near = (0.1 if level == LEVEL else 0.15) * (expected_high - expected_low) / 2.0
    assert (low, high) == pytest.approx((expected_low, expected_high), abs=near)  # 90 % is 16 % narrower than 95 %


@pytest.mark.parametrize("name", CASES)
def test_an_interval_over_pairs_is_scipys_in_both_tails(name: str) -> None:
    report, value, level = CASES[name]
    found = drawn()
    assert_like_scipys(report(found), value, found, level)


@pytest.mark.parametrize(("wins", "runs"), [(0, 20), (3, 20), (71, 100)])
def test_the_interval_of_a_drill_is_wilsons(wins: int, runs: int) -> None:
    expected = stats.binomtest(wins, runs).proportion_ci(LEVEL, method="wilson")
    longer = max(wins / runs - expected.low, expected.high - wins / runs)
    assert half_width({"successes": wins, "runs": runs}) == pytest.approx(100.0 * longer)
