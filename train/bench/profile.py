"""`soccer bench --profile`: the time of a match step, mechanism by mechanism, of the chaser against itself by sensors.

Stages are timed in live play. Sensors share a compiled loop, and so do filters: a mechanism's time is what the loop
takes longer with it than without, over matches that stand still meanwhile.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import asdict, replace
from statistics import median
from time import process_time
from typing import Any

import numpy as np

from soccer_env.belief.believing import make_belief_kernel
from soccer_env.belief.legged import believe as dog
from soccer_env.belief.omni import believe as wheels
from soccer_env.compiled import compiled
from soccer_env.guards.whole_files import write_atomically
from soccer_env.perception.legged import picture, sense
from soccer_env.perception.omni import sense as mirror
from soccer_env.perception.sensing import make_sensor_kernel
from soccer_env.train.bench.benchmark import LEAGUES, Row, machine
from soccer_env.train.bench.loads import PLAYERS, CoreLoad
from soccer_env.train.bench.settings import BenchSettings
from soccer_env.train.progress import Progress

STAGES = ("teams", "drive", "physics", "referee", "sensors", "filters", "observations")
SENSORS = {  # in the order of the functions below
    "legged-2001": ("picture", "blobs", "touch", "infrared"),
    "middle-size-2006": ("bodies around", "ball", "players", "goals", "lines"),
}
FILTERS = {
    "legged-2001": ("own pose", "ball", "players", "obstacle", "gaze"),
    "middle-size-2006": ("own pose", "ball and players"),
}


def legged_sensors(parts: int) -> Any:
    """Return the loop that computes the first `parts` of SENSORS for legged robots."""

    @compiled
    def sense_robot(match, ball, robots, r, percept, state, pending, scratch, k, s):
        if parts > 0 and robots[r].active == 1 and robots[r].fallen <= 0.0:
            picture.draw_scene(match, ball, robots, k, s, r, scratch[0])
            if parts > 1:
                picture.deliver_blobs(scratch[0], percept, state, robots[r].noise, s)
        if parts > 2:
            sense.feel_touch(ball, robots[r], percept.touch, k, s)
        if parts > 3:
            percept.infrared = sense.measure_range(match, ball, robots, k, s, r)

    return make_sensor_kernel(sense.make_sketch, sense_robot)


def omni_sensors(parts: int) -> Any:
    """Return the loop that computes the first `parts` of SENSORS for middle-size robots."""

    @compiled
    def sense_robot(match, ball, robots, r, percept, state, pending, scratch, k, s):
        if parts == 0:
            return
        robot, hand = robots[r], match.handedness
        noise = robot.noise
        around, maps, glass = scratch
        count = mirror.find_bodies_around(robots, r, k, around)
        if parts > 1:
            mirror.find_ball(ball, robot, percept, around, count, glass, k, s, noise, hand, 1.0)
        if parts > 2:
            mirror.find_players(percept, around, count, glass, k, s, noise, hand, 1.0)
        if parts > 3:
            mirror.find_goals(match, robot, percept, around, count, glass, k, s, noise, hand, 1.0)
        if parts > 4:
            mirror.find_lines(robot, percept.lines, around, count, maps[0], glass, k, s, noise, hand, 1.0)

    return make_sensor_kernel(mirror.make_scratch, sense_robot)


def legged_filters(parts: int) -> Any:
    """Return the loop that updates the first `parts` of FILTERS for legged robots."""

    @compiled
    def believe_robot(percept, belief, tracks, memory, particles, noise, gaze, scratch, k, s, w, table):
        if parts > 0:
            crowded = dog.is_crowded(tracks, k)
            dog.believe_pose_legged(percept, belief.own, crowded, memory.pose, particles, noise, k, s, w)
        if parts > 1:
            dog.believe_ball(percept, belief.own, belief.ball, memory.ball, k, s, w, table)
        if parts > 2:
            dog.believe_players(percept, belief.own, tracks, memory.players, k, s, w, table)
        if parts > 3:
            dog.believe_obstacle(percept, belief, tracks, k, s, w)
        if parts > 4:
            dog.choose_gaze(percept, belief, np.float64(memory.ball.height), memory.head, gaze, k, s, w)

    return make_belief_kernel(dog.make_scratch, believe_robot, dog.exchange_words)


def omni_filters(parts: int) -> Any:
    """Return the loop that updates the first `parts` of FILTERS for middle-size robots."""

    @compiled
    def believe_robot(percept, belief, tracks, memory, particles, noise, gaze, scratch, k, s, w, table):
        if parts > 0:
            crowded = wheels.is_crowded(tracks, k)
            wheels.believe_pose_omni(percept, belief.own, crowded, memory.pose, particles, noise, k, s, w, table)
        if parts > 1:
            wheels.track_ball_and_players(percept, belief, tracks, memory, scratch, k, s, w)

    return make_belief_kernel(wheels.make_scratch, believe_robot, wheels.exchange_radio)


LOOPS = {"legged-2001": (legged_sensors, legged_filters), "middle-size-2006": (omni_sensors, omni_filters)}


class StagedLoad(CoreLoad):
    """Chaser play that adds up the processor time of each stage."""

    def __init__(self, league: str, matches: int, seed: int, players: int = PLAYERS) -> None:
        super().__init__(league, "chaser", matches, 1, seed, "particles", players)
        self.spent = dict.fromkeys(STAGES, 0.0)
        match, batch = self.match, self.match.batch
        for stage, owner, name in (
            ("teams", match, "_decide_slice"), ("sensors", batch, "sense"), ("filters", batch, "believe"),
            ("observations", batch, "observe"),
        ):  # fmt: skip
            setattr(owner, name, self._timed(stage, getattr(owner, name)))
        batch.act = self._act  # type: ignore[method-assign]  # the same stages, timed

    def _timed(self, stage: str, call: Callable[..., Any]) -> Callable[..., Any]:
        def timed(*arguments: Any) -> Any:
            start = process_time()
            result = call(*arguments)
            self.spent[stage] += process_time() - start
            return result

        return timed

    def _act(self, first: int, last: int) -> None:
        times = [process_time()]

        def advance(*arguments: Any) -> None:
            times.append(process_time())
            self.match.batch.physics.step_slice(*arguments)
            times.append(process_time())

        self.match.batch.senses.asleep[first:last] = self.match.matches["over"][first:last]  # type: ignore[union-attr]
        self.match.batch.act_in_stages(first, last, advance)
        for stage, spent in zip(("drive", "physics", "referee"), np.diff([*times, process_time()]), strict=True):
            self.spent[stage] += spent

    def stages(self, steps: int) -> dict[str, float]:
        """Return the seconds per match step of each stage."""
        self.spent = dict.fromkeys(STAGES, 0.0)
        self.run(steps)
        return {stage: spent / (steps * self.match.count) for stage, spent in self.spent.items()}

    def loops(self, name: str, kernels: list[Any], repetitions: int) -> list[float]:
        """Return the seconds per match step of the loop `name`, "sense" or "believe", with each of the kernels."""
        senses: Any = self.match.batch.senses
        kinds = [replace(senses.kind, **{name: kernel}) for kernel in kernels]
        samples: list[list[float]] = [[] for _ in kinds]
        for _ in range(repetitions + 1):
            for senses.kind, times in zip(kinds, samples, strict=True):
                start = process_time()
                getattr(senses, name)(0, self.match.count)
                times.append((process_time() - start) / self.match.count)
        return [min(times[1:]) for times in samples]  # the first call compiles


def profile_step(settings: BenchSettings) -> dict[str, Any]:
    """Measure both leagues and return the report that --out writes: machine, and rows in order of the step."""
    rows: list[Row] = []
    with Progress("bench", len(LEAGUES)) as progress:
        for league in LEAGUES:
            progress.note(league)
            rows += profile_rows(league, settings)
            progress.advance(1)
    report = {"machine": machine(), "rows": [asdict(row) for row in rows]}
    if settings.out is not None:
        settings.out.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(settings.out, json.dumps(report, indent=2) + "\n")
    return report


def profile_rows(league: str, settings: BenchSettings) -> Iterator[Row]:
    """Yield a row for each stage of a league's step, and for each mechanism of its sensors and filters."""
    load = StagedLoad(league, settings.matches, settings.seed)
    samples = [load.stages(settings.steps) for _ in range(settings.repetitions)]
    stages = {stage: median(sample[stage] for sample in samples) for stage in STAGES}
    whole = sum(stages.values())
    make_sensors, make_filters = LOOPS[league]
    for stage, spent in stages.items():
        yield Row(f"{league}: {stage}", spent, share_text(spent, whole))
        if stage == "sensors":
            kernels = [make_sensors(parts) for parts in range(len(SENSORS[league]) + 1)]
            names, times = SENSORS[league], load.loops("sense", kernels, settings.repetitions)
        elif stage == "filters":
            kernels = [make_filters(parts) for parts in range(len(FILTERS[league]) + 1)]
            names, times = FILTERS[league], load.loops("believe", kernels, settings.repetitions)
        else:
            continue
        for name, less, more in zip(names, times[:-1], times[1:], strict=True):
            yield Row(f"{league}: {stage}: {name}", more - less, share_text(more - less, whole))


def share_text(spent: float, whole: float) -> str:
    """Return a time [s] as microseconds and as a share of a whole step."""
    return f"{1e6 * spent:.2f} us, {100.0 * spent / whole:.0f} %"
