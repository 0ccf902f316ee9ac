"""Timed loads: the middle-size planner over 5 m past nine moving obstacles, and the team that plans with it."""

from statistics import median
from time import perf_counter
from typing import Any

import numpy as np

from soccer_env.baselines.weigel_2001.planner.planning import begin_plan, plan_way
from soccer_env.baselines.weigel_2001.planner.records import OBSTACLE, PLAN, SCRATCH
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.baselines.weigel_2001.planner.walking import plan_pass
from soccer_env.compiled import compiled
from soccer_env.teams import TeamRandom, View
from soccer_env.train.bench.loads import CoreLoad
from soccer_env.types import NOISE_STREAMS

DISTANCE, OBSTACLES = 5.0, 9  # [m] of the straight way, [1]
FASTEST, ROOM = 2.0, 0.6  # [m/s] of an obstacle, [m] free around robot and target
LENGTH, WIDTH, RADIUS = 12.0, 8.0, 0.25  # [m] of the pitch, [m] of an obstacle
MATCHES, PLAYERS = 16, 5  # of the team's play: matches, players a side
TRIES = 5  # a scene's time is the median of these


def draw_scene(rng: np.random.Generator) -> tuple[tuple[float, float, float, float], np.ndarray]:
    """Draw a random scene: robot and target as x, y, x, y (4,) [m], and (n,) obstacles, anywhere on the pitch."""
    half = np.array([0.5 * LENGTH, 0.5 * WIDTH])
    robot = target = 2.0 * half
    while (np.abs(target) > half).any():
        robot, angle = rng.uniform(-half, half), rng.uniform(-np.pi, np.pi)
        target = robot + DISTANCE * np.array([np.cos(angle), np.sin(angle)])
    others = np.zeros(OBSTACLES, OBSTACLE)
    others["radius"] = RADIUS
    for obstacle in others:
        place = robot
        while min(np.hypot(*(place - robot)), np.hypot(*(place - target))) < ROOM:
            place = rng.uniform(-half, half)
        angle, speed = rng.uniform(-np.pi, np.pi), rng.uniform(0.0, FASTEST)
        velocity = speed * np.cos(angle), speed * np.sin(angle)
        obstacle["x"], obstacle["y"], obstacle["vx"], obstacle["vy"] = *place, *velocity
    return (float(robot[0]), float(robot[1]), float(target[0]), float(target[1])), others


class PlanLoad:
    """Time the planner of 2006 in many random scenes; it is compiled before the first timing."""

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)
        self.parts: Any = (PlannerSettings().record(), np.zeros(1, SCRATCH), np.zeros(1, PLAN))
        self.sample(1)

    def sample(self, scenes: int) -> tuple[list[float], list[float]]:
        """Return the seconds of a backward pass and of a whole plan, in each of `scenes` new scenes."""
        passes, plans = [], []
        for _ in range(scenes):
            places, others = draw_scene(self.rng)
            passes.append(median(self._pass(places, others) for _ in range(TRIES)))
            plans.append(median(self._plan(places, others) for _ in range(TRIES)))
        return passes, plans

    def _pass(self, places: tuple[float, float, float, float], others: np.ndarray) -> float:
        initialise_plan(*places, *self.parts)
        start = perf_counter()
        run_backward_pass(others, *self.parts)
        return perf_counter() - start

    def _plan(self, places: tuple[float, float, float, float], others: np.ndarray) -> float:
        start = perf_counter()
        make_plan(*places, others, *self.parts)
        return perf_counter() - start


class TeamLoad(CoreLoad):
    """The team of 2006 against itself, 5 v 5, by sensors and particles; every robot plans in every cycle."""

    def __init__(self, seed: int, matches: int = MATCHES) -> None:
        super().__init__("middle-size-2006", "heinemann-2006", matches, 1, seed, "particles", PLAYERS)

    def decide(self, times: int) -> float:
        """Let both teams decide `times` times from their current beliefs; return the seconds per robot and decision."""
        match, spent = self.match, 0.0
        for squad in match.squads:
            rows = squad.players
            rng = TeamRandom(np.zeros((match.count, len(rows), NOISE_STREAMS), np.uint64), np.arange(len(rows)))
            view, memory = View(match.league, match.beliefs[:, rows], match.tracks[:, rows]), squad.memory.copy()
            start = perf_counter()
            for _ in range(times):
                squad.team.act(view, memory, rng)
            spent += perf_counter() - start
        return spent / (times * match.robots.size)


# Kernels get arrays: handing over a single record takes Python longer than the planner needs.


@compiled
def initialise_plan(x, y, to_x, to_y, settings, scratch, plans):
    """Initialise the plan in `plans[0]`, from (x, y) to (to_x, to_y)."""
    begin_plan(x, y, to_x, to_y, 1, settings[0], scratch[0], plans[0])


@compiled
def run_backward_pass(others, settings, scratch, plans):
    """Run one backward pass of the planner, with T the time of the straight line."""
    plan_pass(plans[0].least_time, others, settings[0], scratch[0], plans[0])


@compiled
def make_plan(x, y, to_x, to_y, others, settings, scratch, plans):
    """Compute a whole plan from (x, y) to (to_x, to_y) into `plans[0]`."""
    plan_way(x, y, to_x, to_y, 1, others, settings[0], scratch[0], plans[0])
