"""From cell to cell: which is next, how long it takes, and until when obstacles are moved; the search's queue."""

from math import atan2, cos, pi, sin, sqrt

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner.records import NODE
from soccer_env.baselines.weigel_2001.planner.searching import pop, push
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.baselines.weigel_2001.planner.stepping import (
    cell_of,
    next_cell,
    obstacle_time,
    step_length,
    step_time,
)

PLAY = PlannerSettings().record()[0]


def test_mh15_a_step_takes_38_or_54_milliseconds() -> None:
    """0.1 m and 2.6 m/s."""
    assert 1e3 * step_time(1, 0, PLAY) == pytest.approx(38.46, abs=0.01)
    assert 1e3 * step_time(-1, 1, PLAY) == pytest.approx(54.39, abs=0.01)
    assert step_length(0, 0, PLAY) == 0.0


@pytest.mark.parametrize("degrees", range(0, 360, 5))
def test_mh11_a_quantised_step_goes_to_the_nearest_of_eight_neighbours(degrees: int) -> None:
    play = PlannerSettings(stepping="quantised").record()[0]
    angle = degrees * pi / 180.0
    du, dv, *rests = next_cell(cos(angle), sin(angle), 0.3, -0.2, play)
    off = abs((atan2(dv, du) - angle + pi) % (2.0 * pi) - pi)
    assert off <= pi / 8.0 + 1e-9 and max(abs(du), abs(dv)) == 1
    assert rests == [0.0, 0.0]


@pytest.mark.parametrize("degrees", range(3, 360, 17))
def test_mh11_carried_steps_keep_to_the_line_within_half_a_cell(degrees: int) -> None:
    angle = degrees * pi / 180.0
    x, y = cos(angle), sin(angle)
    u = v = 0
    rest_x = rest_y = 0.0
    for step in range(1, 41):
        du, dv, rest_x, rest_y = next_cell(x, y, rest_x, rest_y, PLAY)
        assert max(abs(du), abs(dv)) == 1
        u, v = u + du, v + dv
        assert abs(x * v - y * u) <= 0.5 + 1e-9, "off the line"
        assert max(abs(u), abs(v)) == step


def test_mh11_no_direction_is_no_step() -> None:
    assert next_cell(0.0, 0.0, 0.4, 0.4, PLAY)[:2] == (0, 0)
    assert next_cell(0.0, 0.0, 0.4, 0.4, PlannerSettings(stepping="quantised").record()[0])[:2] == (0, 0)


def test_a_mirrored_step_is_the_steps_mirror_image() -> None:
    rng = np.random.default_rng(3)
    for x, y, rest_x, rest_y in rng.uniform(-0.5, 0.5, (200, 4)):
        du, dv, a, b = next_cell(x, y, rest_x, rest_y, PLAY)
        assert next_cell(x, -y, rest_x, -rest_y, PLAY) == (du, -dv, a, -b)


def test_a_cell_is_the_nearest_the_mirrored_place_has_the_mirrored_one_and_none_is_outside() -> None:
    places = [0.0, 0.04, 0.05, 0.06, 0.25, 1.0, 4.97, 5.2, 80.0, float("inf")]
    assert [cell_of(place, 50, PLAY) for place in places] == [0, 0, 1, 1, 3, 10, 50, 50, 50, 50]
    assert [cell_of(-place, 50, PLAY) for place in places] == [0, 0, -1, -1, -3, -10, -50, -50, -50, -50]
    assert cell_of(float("nan"), 50, PLAY) == -50


def test_mh17_weigels_planner_sees_obstacles_as_they_are_now() -> None:
    still = PlannerSettings(time_variant=False).record()[0]
    assert [obstacle_time(t, still) for t in (-1.0, 0.0, 1.7)] == [0.0, 0.0, 0.0]
    assert [obstacle_time(t, PLAY) for t in (-1.0, 0.0, 1.7)] == [0.0, 0.0, 1.7]


def test_mh16_by_the_papers_words_alone_obstacles_are_moved_back_beyond_the_present() -> None:
    assert obstacle_time(-0.4, PlannerSettings(literal=True).record()[0]) == -0.4


def test_the_search_takes_the_least_first_and_of_equal_ones_the_older() -> None:
    rng = np.random.default_rng(1)
    nodes, heap = np.zeros(200, NODE), np.zeros(200, "i4")
    nodes["potential"] = rng.integers(0, 40, 200)
    size = 0
    for node in range(200):
        size = push(heap, size, node, nodes)
    taken = [pop(heap, size - i, nodes) for i in range(200)]
    assert taken == sorted(range(200), key=lambda node: (nodes["potential"][node], node))


def test_a_step_is_the_root_of_its_squares() -> None:
    assert step_length(3, -4, PLAY) == pytest.approx(0.5)
    assert step_length(1, 1, PLAY) == pytest.approx(0.1 * sqrt(2.0))
