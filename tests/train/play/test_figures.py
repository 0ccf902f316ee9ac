"""Figures follow from samples: shares, rates and percentiles, with intervals over matches."""

import numpy as np
import pytest

from soccer_env.train.play.figures import a_minute, most, often_from, percentile, share, share_from, work_out


def arrays(*values: list[float]) -> np.ndarray:
    found = np.empty(len(values), object)
    for m, ones in enumerate(values):
        found[m] = np.array(ones)
    return found


SAMPLES = {
    "played": np.array([60.0, 180.0]),
    "in_play": np.array([50.0, 150.0]),
    "still": np.array([10.0, 70.0]),
    "goals": np.array([1, 5]),
    "times": arrays([1.0, 2.0], [3.0, 4.0, 10.0]),
    "nothing": arrays([], []),
}


@pytest.mark.parametrize(
    ("figure", "expected"),
    [
        (share("", "still"), 40.0),
        (share("", "in_play", "played"), 100.0 * 200 / 240),
        (a_minute("", "goals"), 1.5),
        (percentile("", "times", 50.0, "mm", 1000.0), 3000.0),
        (share_from("", "times", 3.0), 60.0),
        (often_from("", "times", 3.0), 0.75),
        (most("", "times", "s"), 10.0),
    ],
)
def test_a_figure_adds_up_or_pools_all_matches(figure, expected: float) -> None:  # type: ignore[no-untyped-def]
    assert work_out(figure, SAMPLES).value == pytest.approx(expected)


def test_intervals_are_over_matches_and_an_extreme_has_none() -> None:
    found = work_out(a_minute("", "goals"), SAMPLES)
    assert (found.low, found.high) == pytest.approx((1.0, 5.0 / 3.0))
    longest = work_out(most("", "times", "s"), SAMPLES)
    assert (longest.low, longest.high) == (None, None)


def test_a_figure_of_nothing_is_none() -> None:
    found = work_out(percentile("", "nothing", 99.0, "mm"), SAMPLES)
    assert (found.value, found.low, found.high) == (None, None, None)
