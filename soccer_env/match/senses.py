"""Percepts and beliefs of the robots of M matches, from simulated sensors and the memory of each kind of robot.

    world -> sense -> percepts -> believe -> beliefs, tracks, gazes
    world -> tell  -> the situation in beliefs: phase, score, clock

The belief half reads percepts and its own memory, never the truth nor the memory of the sensors; a test poisons both
between the halves.
"""

from typing import Any

import numpy as np

from soccer_env.belief.believing import BeliefArrays, MemoryNumbers
from soccer_env.leagues.league import League
from soccer_env.leagues.robot_kind import kind_of
from soccer_env.match.settings import Settings
from soccer_env.perception.ideal import tell_match_state
from soccer_env.perception.sensing import SensorArrays, SensorNumbers
from soccer_env.records.world import World
from soccer_env.types import AWAY, HOME

UNUSED = (
    "nobody in this match uses its sensors: robots are played from outside and observe the truth; "
    "give observe='belief' or 'percepts', a team, or senses='ideal'"
)


def sensing_sides(settings: Settings, squads: list[Any], learns: np.ndarray) -> tuple[int, ...]:
    """Return the sides (HOME, AWAY) whose sensors are used by a team of the squads, an observation or a skill.

    `learns` (R,) marks the rows of learners.
    """
    home, used = settings.rows[HOME], []
    for side, rows in ((HOME, range(home)), (AWAY, range(home, len(learns)))):
        teams = [squad.team for squad in squads if squad.players[0] in rows]
        played = not all(getattr(team, "blind", False) for team in teams)
        observe = settings.observes[side]
        tells = (
            observe if isinstance(observe, str) else "belief" if getattr(observe, "needs_beliefs", True) else "truth"
        )
        learning = any(learns[r] == 1 for r in rows)
        watched, chooses = learning and tells != "truth", learning and settings.actions.name == "skills"
        reads = played or watched or chooses
        if (settings.senses[side] == "sensors" and reads) or (watched and tells == "percepts"):
            used.append(side)
    return tuple(used)


class Senses:
    """Percepts (M, R) and beliefs of robots, with the states of their sensors and the memory behind the beliefs.

    The robots of `sides` (HOME, AWAY) sense. Unless their senses are ideal they also fill their rows of beliefs (M, R)
    and tracks (M, R, slots). Nothing is computed for the other side.
    """

    def __init__(
        self, settings: Settings, world: World, constants: np.ndarray, beliefs: np.ndarray, tracks: np.ndarray,
        sides: tuple[int, ...],
    ) -> None:  # fmt: skip
        league, (matches, robots) = settings.league, beliefs.shape
        self.settings = settings
        self.world = world
        self.constants = constants
        self.sides = sides
        self.kind = kind_of(league.sensors)
        self._sensing = rows_of_sides(sides, settings.rows)
        believing = tuple(side for side in sides if settings.senses[side] == "sensors")
        self._believing = rows_of_sides(believing, settings.rows)
        everyone = np.arange(robots)
        self.sensing, self.rows = everyone[self._sensing], everyone[self._believing]
        self.senses, self.believes = (np.isin(everyone, rows) for rows in (self.sensing, self.rows))
        self.asleep = np.zeros(matches, bool)  # over before this step: an ended match draws no noise
        self._make_arrays(beliefs, tracks)
        self.sensors, self.memory_settings = league.sensors.record(), league.memory.record()
        if settings.variation is not None:  # after the league's own sensors those of each match
            self.sensors = self.sensors.repeat(1 + matches)
        self.tables = self.kind.tables(league)
        pose_sensed = int(settings.pose == "percept")
        home = settings.rows[HOME]
        self._sensor_numbers = tuple(SensorNumbers(constants, self.sensors, pose_sensed))
        self._memory_numbers = tuple(MemoryNumbers(constants, self.sensors, self.memory_settings, self.tables, home))

    def _make_arrays(self, beliefs: np.ndarray, tracks: np.ndarray) -> None:
        """Allocate the records of sensors and memory, filled with zeros."""
        shape = beliefs.shape
        kind = self.kind
        settings = self.settings
        self.percepts = np.zeros(shape, kind.percept)
        self.sensor_states = np.zeros(shape, kind.sensor_state)
        self.pending = np.zeros((*shape, kind.late(settings.league.sensors)), kind.percept)
        self.beliefs, self.tracks = beliefs, tracks
        self.memories, self.messages = np.zeros(shape, kind.memory), np.zeros(shape, kind.message)
        count = settings.league.memory.particles if settings.pose == "particles" else 0
        self.particles = np.zeros((*shape, count), kind.particle)
        noise, gazes = self.world.robots["noise"], self.world.robots["gaze"]
        self._truth = tuple(self.world)
        self._perception = tuple(SensorArrays(self.percepts, self.sensor_states, self.pending))
        self._minds = tuple(BeliefArrays(beliefs, tracks, self.memories, self.particles, self.messages, noise, gazes))

    @property
    def parts(self) -> dict[str, np.ndarray]:
        """Return by name the arrays that determine the future of a match, as views of the rows in use."""
        sensed = {name: getattr(self, name)[:, self._sensing] for name in ("percepts", "sensor_states", "pending")}
        names = ("beliefs", "tracks", "memories", "messages", "particles")
        return {**sensed, **{name: getattr(self, name)[:, self._believing] for name in names}}

    def start(self, m: int) -> None:
        """Clear the records of match m; from now on its robots use their sensors."""
        for array in self.parts.values():
            array[m] = np.zeros((), array.dtype)
        self.world.robots["senses"][m, self.rows] = 1
        self.asleep[m] = False

    def vary(self, m: int, league: League) -> None:
        """Give the robots of match m the sensors of a variation of the league."""
        self.sensors[m + 1] = league.sensors.record()[0]

    def step(self, first: int, last: int) -> None:
        """Update the percepts and beliefs of a slice of matches."""
        self.sense(first, last)
        self.tell(first, last)
        self.believe(first, last)

    def sense(self, first: int, last: int) -> None:
        """Compute the percepts of a slice of matches from the truth."""
        numbers = self._sensor_numbers
        self.kind.sense(self._truth, self._perception, numbers, self.asleep, self.sensing, first, last)

    def tell(self, first: int, last: int) -> None:
        """Write phase, score and clock into the beliefs of the robots, for a slice of matches."""
        if len(self.rows):
            tell_match_state(self._truth, self.beliefs, self.asleep, self.rows, first, last)

    def believe(self, first: int, last: int) -> None:
        """Update the beliefs of a slice of matches from the percepts, without reading the truth."""
        if len(self.rows):
            numbers = self._memory_numbers
            self.kind.believe(self.percepts, self._minds, numbers, self.asleep, self.rows, first, last)

    def observe_percepts(self, out: np.ndarray, rows: np.ndarray, first: int, last: int) -> None:
        """Write observations of percepts into out (M, R, n), for the robots of `rows` that use their sensors."""
        self.kind.observe(
            self.percepts, self.beliefs, self.world.robots, out, self.constants, self.sensors,
            self.settings.half_length, rows[self.senses[rows]], first, last,
        )  # fmt: skip


def rows_of_sides(sides: tuple[int, ...], sizes: tuple[int, int]) -> slice:
    """Return the rows of the robots of some sides; `sizes` are the numbers of rows of home and of away."""
    if not sides:
        return slice(0, 0)
    return slice(0 if HOME in sides else sizes[HOME], sum(sizes) if AWAY in sides else sizes[HOME])
