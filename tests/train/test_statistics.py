"""Statistics agree with scipy and cover what they claim."""

import numpy as np
import pytest

from soccer_env.train.statistics import interquartile_mean, paired_bootstrap, required_matches, wilson_interval

stats = pytest.importorskip("scipy.stats")
DRAWS = np.random.default_rng(3).normal(0.4, 1.5, 37)


def test_bootstrap_equals_scipys() -> None:
    expected = stats.bootstrap((DRAWS,), np.mean, n_resamples=10_000, method="percentile", rng=np.random.default_rng(5))
    mean, low, high = paired_bootstrap(DRAWS, seed=5)
    assert mean == pytest.approx(DRAWS.mean())
    assert (low, high) == pytest.approx(tuple(expected.confidence_interval), abs=1e-12)


def test_bootstrap_in_blocks_is_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = paired_bootstrap(DRAWS, seed=1)
    monkeypatch.setattr("soccer_env.train.statistics.BLOCK", 1000)
    assert paired_bootstrap(DRAWS, seed=1) == whole


def test_bootstrap_is_repeatable_and_its_mean_lies_inside() -> None:
    mean, low, high = paired_bootstrap(DRAWS)
    assert paired_bootstrap(DRAWS) == (mean, low, high)
    assert low < mean < high


def test_bootstrap_of_equal_pairs_has_no_width() -> None:
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


def test_interquartile_mean_ignores_an_outlier() -> None:
    assert interquartile_mean([1.0, 2.0, 3.0, 1000.0]) == 2.5


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
