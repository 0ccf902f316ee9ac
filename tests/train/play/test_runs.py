"""Runs of a flag over time."""

import numpy as np

from soccer_env.train.play.runs import bridged, by_match, runs_of

FLAGS = np.array([[0, 1, 1, 0, 0, 1, 0, 0, 0, 1], [1, 1, 0, 1, 0, 0, 0, 0, 0, 0]], bool).T


def test_runs_are_found_in_every_column_also_at_both_ends() -> None:
    runs = runs_of(FLAGS)
    found = list(zip(*(values.tolist() for values in runs), strict=True))
    assert found == [(0, 1, 3), (0, 5, 6), (0, 9, 10), (1, 0, 2), (1, 3, 4)]
    assert runs.steps.tolist() == [2, 1, 1, 2, 1]


def test_short_breaks_are_closed_and_the_ends_are_not_breaks() -> None:
    closed = bridged(FLAGS, 2)
    assert closed[:, 0].tolist() == [False, True, True, True, True, True, False, False, False, True]
    assert closed[:, 1].tolist() == [True] * 4 + [False] * 6


def test_values_of_columns_go_to_the_match_that_the_columns_belong_to() -> None:
    found = by_match(np.array([1.0, 2.0, 3.0]), np.array([0, 5, 3]), matches=3, each=2)
    assert [ones.tolist() for ones in found] == [[1.0], [3.0], [2.0]]
