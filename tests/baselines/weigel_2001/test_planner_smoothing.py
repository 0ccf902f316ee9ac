"""The driven path against closed forms: a corner is a mean of its neighbours, ends are where they are asked."""

from math import hypot

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner.planning import length_of, smooth
from soccer_env.baselines.weigel_2001.planner.records import POINT, SCRATCH
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings


def smoothed(
    cells: list[tuple[int, int]], begin: tuple[float, float], end: tuple[float, float], many: int
) -> np.ndarray:
    """Return the path (N, 2) [m] of a way of cells, smoothed over so many on each side."""
    scratch = np.zeros(1, SCRATCH)
    scratch["count"] = len(cells)
    scratch["way"]["u"][0, : len(cells)], scratch["way"]["v"][0, : len(cells)] = np.transpose(cells)
    first, last = np.array([begin, end], POINT)
    smooth(first, last, PlannerSettings(smoothing=many).record()[0], scratch[0])
    path = scratch["path"][0, : len(cells)]
    assert length_of(path, len(path)) == pytest.approx(np.hypot(np.diff(path["x"]), np.diff(path["y"])).sum())
    return np.stack([path["x"], path["y"]], axis=-1)


CORNER = [(i, 0) for i in range(-10, 1)] + [(0, i) for i in range(1, 11)]


def test_a_corner_is_the_mean_of_its_nine_cells() -> None:
    path = smoothed(CORNER, (-1.0, 0.0), (0.0, 1.0), 4)
    assert path[10] == pytest.approx((-1.0 / 9.0, 1.0 / 9.0))  # 0.1 m times (4 + 3 + 2 + 1) / 9
    assert path[:6, 1] == pytest.approx(0.0) and path[15:, 0] == pytest.approx(0.0)


def test_unsmoothed_the_path_is_the_cells_way() -> None:
    assert smoothed(CORNER, (-1.0, 0.0), (0.0, 1.0), 0) == pytest.approx(0.1 * np.array(CORNER))


@pytest.mark.parametrize("count", [2, 3, 5, 9, 30])
def test_a_straight_way_stays_one_and_is_shifted_evenly_onto_both_ends(count: int) -> None:
    begin, end = (0.04, -0.03), (0.1 * (count - 1) - 0.02, 0.05)
    path = smoothed([(i, 0) for i in range(count)], begin, end, 4)
    assert path == pytest.approx(np.linspace(begin, end, count))
    assert np.hypot(*np.diff(path, axis=0).T).sum() == pytest.approx(hypot(end[0] - begin[0], end[1] - begin[1]))
