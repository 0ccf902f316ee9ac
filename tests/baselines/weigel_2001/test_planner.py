"""`Planner` and `Plan` as Python sees them: bad input, what a plan tells, what it is worth, pictures."""

from collections.abc import Callable
from math import hypot, inf, nan, pi
from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner import Planner
from soccer_env.baselines.weigel_2001.planner.drawing import draw_plan, draw_travel
from soccer_env.baselines.weigel_2001.planner.measuring import total_turn
from tests.scenes.planning import CROSSING_A, CROSSING_B

HERE, THERE = (0.0, 0.0), (3.0, 1.0)


@pytest.mark.parametrize(("asked", "complaint"), [
    ({"robot": (0.0, nan)}, r"robot must be finite and within 1000 m of the middle of the pitch, got \(0.0, nan\)"),
    ({"robot": (0.0, 1.0, 2.0)}, "robot must be two numbers x, y, got"),
    ({"robot": None}, "robot must be two numbers x, y, got None"),
    ({"target": (inf, 0.0)}, "target must be finite and within 1000 m"),
    ({"target": (0.0, 1001.0)}, "target must be finite and within 1000 m"),
    ({"target": ("a", 0.0)}, "target must be two numbers x, y"),
    ({"obstacles": (1.0, 2.0)}, r"obstacles must be rows of x, y, vx, vy, .* got \(2,\)"),
    ({"obstacles": [(1.0, 2.0)]}, r"obstacles must be rows of x, y, vx, vy, .* got \(1, 2\)"),
    ({"obstacles": [(1.0, 2.0, 0.0, 0.0), (1.0,)]}, "obstacles must be rows of x, y, vx, vy"),
    ({"obstacles": [(1.0, 2.0, 0.0, nan)]}, r"obstacles\[0\].vy must be -100 to 100, got nan"),
    ({"obstacles": [(0.0,) * 4, (0.0, 2e3, 0.0, 0.0)]}, r"obstacles\[1\].y must be -1000 to 1000, got 2000.0"),
    ({"obstacles": [(1.0, 2.0, 0.0, 0.0, -0.1)]}, r"obstacles\[0\].radius must be 0 to 5, got -0.1"),
    ({"obstacles": np.zeros((33, 4))}, "obstacles must be at most 32, got 33"),
    ({"side": 0}, "side must be one of -1, 1, got 0"), ({"side": 2}, "side must be -1 to 1, got 2"),
    ({"side": 0.5}, "side must be a whole number"),
])  # fmt: skip
@pytest.mark.parametrize("act", ["plan", "travel"])
def test_bad_input_is_named(act: str, asked: dict[str, Any], complaint: str) -> None:
    ask: Callable[..., Any] = getattr(Planner(), act)
    with pytest.raises(ValueError, match=complaint):
        ask(**{"robot": HERE, "target": THERE, **asked})


@pytest.mark.parametrize(("given", "settings", "complaint"), [
    ((), {"form": "khatib"}, "PlannerSettings.form must be one of scalar, vector, got 'khatib'"),
    ((), {"repulsion": "scalar"}, "PlannerSettings.repulsion must be one of inverse, khatib, got 'scalar'"),
    ((), {"cell": 0.05}, "cell must be so large that 12 x 8 m and a margin of 1 m are at most 32768"),
    ((), {"floor": 0.5, "reach": 0.2}, "floor must be less than reach 0.2, got 0.5"),
    ((), {"gian": 0.2}, "unknown name 'gian' in PlannerSettings, did you mean 'gain'"),
    ((3,), {}, "settings must be a PlannerSettings, got 3"),
])  # fmt: skip
def test_bad_settings_are_named(given: tuple[Any, ...], settings: dict[str, Any], complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint):
        Planner(*given, **settings)
    with pytest.raises(ValueError, match=r"seconds must be 0.02 to 1000, got -1"):
        Planner().travel(HERE, THERE, seconds=-1)


def test_a_plan_tells_where_everybody_will_be_and_a_travel_its_smallest_gap_and_all_its_turns() -> None:
    """One goes ahead of the robot at its speed, 1.2 m off; one comes by as close as 0.8 m."""
    plan = Planner().plan((0.0, 0.0), (2.6, 0.0), [(1.0, 3.0, 0.5, -0.25)])
    robot, others = plan.at(0.4)
    assert robot == pytest.approx((1.04, 0.0), abs=1e-6)
    assert others.tolist() == [pytest.approx([1.2, 2.9])]
    assert plan.at(9.0)[0] == pytest.approx((2.6, 0.0))
    with pytest.raises(ValueError, match="t must be a number of at least 0, got -1"):
        plan.at(-1)
    planner = Planner(reach=0.1)  # all ways are straight
    assert planner.plan((0.0, 0.0), (4.0, 0.0), [(0.0, 1.2, 2.6, 0.0)]).clearance() == pytest.approx(0.7, abs=1e-3)
    assert planner.plan((0.0, 0.0), (4.0, 0.0), [(4.0, 0.8, -2.6, 0.0)]).clearance() == pytest.approx(0.3, abs=1e-3)
    assert planner.plan((0.0, 0.0), (4.0, 0.0)).clearance() > 1e6
    square = np.array([(0, 0), (1, 0), (1, 0), (1, 1), (2, 1)], float)
    assert total_turn(square) == pytest.approx(pi) and total_turn(square[:2]) == 0.0
    assert Planner().plan((0.0, 0.0), (3.0, 0.0)).turn == pytest.approx(0.0, abs=1e-6)


def test_the_forces_at_the_cells_are_those_of_the_time_when_they_are_reached() -> None:
    plan = Planner().plan(*CROSSING_A)
    towards, away = plan.forces()
    assert towards == pytest.approx(plan.path[0] - 0.1 * plan.cells), "of the robot: it is planned backwards"
    near = int(np.argmax(np.hypot(*away.T)))
    obstacle = plan.obstacles[0]
    then = max(plan.cell_times[near], 0.0)
    place = np.array([obstacle["x"] + then * obstacle["vx"], obstacle["y"] + then * obstacle["vy"]])
    apart = 0.1 * plan.cells[near] - place
    size = 0.15 * (1.0 / (hypot(*apart) - 0.5) - 1.0)
    assert away[near] == pytest.approx(size * apart / hypot(*apart))


@pytest.mark.parametrize("scene", [CROSSING_A, CROSSING_B])
def test_mh18_plans_and_travels_are_drawn(scene: Any) -> None:
    figure = pytest.importorskip("matplotlib.figure")
    canvas = figure.Figure()
    axes = canvas.subplots(1, 4)
    planner = Planner()
    draw_plan(axes[0], planner.plan(*scene))
    travel = planner.travel(*scene)
    for one, cycle in zip(axes[1:], (1, 30, 60), strict=True):
        draw_travel(one, travel, cycle)
        lines = {line.get_label().split(",")[0]: line.get_xydata() for line in one.get_lines()}
        assert lines["planned"].tolist() == travel.planned(cycle).tolist()
        assert lines["travelled"].tolist() == travel.path[: cycle + 1].tolist()
    canvas.draw_without_rendering()
