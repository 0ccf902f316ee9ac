"""Plots of plans and travels on matplotlib axes: pitch, obstacles, cells, path and forces.  MH18

    import matplotlib.pyplot as plt

    canvas, axes = plt.subplots()
    draw_plan(axes, planner.plan((4.0, 3.0), (4.0, -2.0), obstacles))
    canvas.savefig("plan.png")

As in the paper's figure the planned path is a thin blue line, the travelled one a thick red one. This
module does not import matplotlib.
"""

from typing import Any

import numpy as np

from soccer_env.baselines.weigel_2001.planner.plan import Plan
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.baselines.weigel_2001.planner.travelling import CYCLE, Travel

PLANNED, TRAVELLED, OBSTACLES, LINES = "tab:blue", "tab:red", "0.45", "0.7"
ROUND = np.linspace(0.0, 2.0 * np.pi, 41)


def draw_plan(axes: Any, plan: Plan, forces: bool = True) -> None:
    """Plot a plan: obstacles with their motion until the plan's end, the cells, the path, the forces."""
    draw_pitch(axes, plan.settings)
    draw_obstacles(axes, plan.at(0.0)[1], plan.obstacles, plan.time)
    cells = plan.cells * plan.settings.cell
    axes.plot(*cells.T, "s", color=PLANNED, alpha=0.25, markersize=2, label="cells")
    axes.plot(*plan.path.T, "-", color=PLANNED, linewidth=1.0, label=f"planned, {plan.time:.2f} s")
    if forces:
        towards, away = plan.forces()
        axes.quiver(*cells.T, *(towards + away).T, color=LINES, width=0.002)
    draw_robot_and_target(axes, plan.path[0], plan.path[-1])


def draw_travel(axes: Any, travel: Travel, cycle: int) -> None:
    """Plot a travel at the start of a cycle: the path planned then, and the path driven so far.  MH18"""
    cycle = min(cycle, len(travel.stations) - 1)
    draw_pitch(axes, travel.settings)
    left = (len(travel.stations) - 1 - cycle) * CYCLE
    draw_obstacles(axes, travel.others(cycle), travel.obstacles, left)
    if len(travel.planned(cycle)):
        axes.plot(*travel.planned(cycle).T, "-", color=PLANNED, linewidth=1.0, label="planned")
    axes.plot(*travel.path[: cycle + 1].T, "-", color=TRAVELLED, linewidth=2.5, label=f"travelled, {cycle * CYCLE:g} s")
    end = travel.plans[0]["target"] if len(travel.plans) > 1 else travel.stations[-1]
    draw_robot_and_target(axes, travel.path[cycle], np.array([end["x"], end["y"]]))


def draw_pitch(axes: Any, settings: PlannerSettings) -> None:
    """Plot the lines of the pitch, with equal scale on both axes."""
    x, y = 0.5 * settings.pitch_length, 0.5 * settings.pitch_width
    axes.plot([-x, x, x, -x, -x], [-y, -y, y, y, -y], color=LINES, linewidth=0.8)
    axes.plot([0.0, 0.0], [-y, y], color=LINES, linewidth=0.8)
    axes.set_aspect("equal")
    axes.set(xlabel="x [m]", ylabel="y [m]")


def draw_obstacles(axes: Any, places: np.ndarray, obstacles: np.ndarray, seconds: float) -> None:
    """Plot obstacles as circles at `places` (n, 2) [m], each with a line to its position `seconds` later."""
    for (x, y), one in zip(places, obstacles, strict=True):
        axes.fill(x + one["radius"] * np.cos(ROUND), y + one["radius"] * np.sin(ROUND), color=OBSTACLES)
        to_x, to_y = x + seconds * one["vx"], y + seconds * one["vy"]
        axes.plot([x, to_x], [y, to_y], ":", color=OBSTACLES, linewidth=0.8)


def draw_robot_and_target(axes: Any, robot: np.ndarray, target: np.ndarray) -> None:
    """Plot marks at the positions of robot and target."""
    axes.plot(robot[0], robot[1], "x", color=TRAVELLED, markersize=8)
    axes.plot(target[0], target[1], "+", color=TRAVELLED, markersize=8)
