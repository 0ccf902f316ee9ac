"""Senses: what the robots of M matches perceive and believe by the chain of sensors and memory of their kind.

    world -> sense -> percepts -> believe -> beliefs, tracks, gazes
    world -> tell  -> the situation in beliefs: how the match stands

The belief half gets percepts and its own memory alone, nothing true and nothing that the sensors remember; a test that
poisons both between the halves holds it to that.
"""

from typing import Any

import numpy as np

from soccer_env.belief.believing import MemoryNumbers, Minds
from soccer_env.leagues.robot_kind import kind_of
from soccer_env.match.settings import Settings
from soccer_env.perception.ideal import tell_slice
from soccer_env.perception.sensing import Sensing, SensorNumbers
from soccer_env.records.world import World
from soccer_env.types import AWAY, HOME

UNUSED = (
    "nobody in this match uses its sensors: robots are played from outside and observe the truth; "
    "give observe='belief' or 'percepts', a team, or senses='ideal'"
)


def sensing_sides(settings: Settings, squads: list[tuple[Any, np.ndarray]], learns: np.ndarray) -> tuple[int, ...]:
    """Return the teams (HOME, AWAY) whose sensors somebody uses: a team that plays them, or what learners observe.

    `squads` are teams with the rows (P,) that each plays; `learns` (R,) marks the rows played from outside.
    """
    home, found = settings.rows[HOME], []
    for side, rows in ((HOME, range(home)), (AWAY, range(home, len(learns)))):
        teams = [team for team, players in squads if players[0] in rows]
        played = not all(getattr(team, "blind", False) for team in teams)
        observe = settings.observes[side]
        tells = (
            observe if isinstance(observe, str) else "belief" if getattr(observe, "needs_beliefs", True) else "truth"
        )
        watched = tells != "truth" and any(learns[r] == 1 for r in rows)
        if (settings.senses[side] == "sensors" and (played or watched)) or (watched and tells == "percepts"):
            found.append(side)
    return tuple(found)


class Senses:
    """The provider of beliefs by sensors: percepts (M, R), what lies behind them, and the memory that makes beliefs.

    `sides` are the teams (HOME, AWAY) whose sensors somebody uses. Their robots sense; those whose senses are not ideal
    also believe what they sense, in their rows of beliefs (M, R) and tracks (M, R, slots). Nothing is computed for the
    others.
    """

    def __init__(
        self,
        settings: Settings,
        world: World,
        constants: np.ndarray,
        beliefs: np.ndarray,
        tracks: np.ndarray,
        sides: tuple[int, ...],
    ) -> None:
        league, (matches, robots) = settings.league, beliefs.shape
        self.settings = settings
        self.world = world
        self.constants = constants
        self.sides = sides
        self.kind = kind_of(league.sensors)
        self._sensing = rows_of(sides, settings.rows)
        believing = tuple(side for side in sides if settings.senses[side] == "sensors")
        self._believing = rows_of(believing, settings.rows)
        everyone = np.arange(robots)
        self.sensing, self.rows = everyone[self._sensing], everyone[self._believing]
        self.senses, self.believes = (np.isin(everyone, rows) for rows in (self.sensing, self.rows))
        self.asleep = np.zeros(matches, bool)  # over before this step: a match that stands still draws no noise
        self._make_arrays(beliefs, tracks)
        self.sensors, self.memory_settings = league.sensors.record(), league.memory.record()
        self.tables = self.kind.tables(league)
        pose_sensed = int(settings.pose == "percept")
        home = settings.rows[HOME]
        self._sensor_numbers = tuple(SensorNumbers(constants, self.sensors, pose_sensed))
        self._memory_numbers = tuple(MemoryNumbers(constants, self.sensors, self.memory_settings, self.tables, home))

    def _make_arrays(self, beliefs: np.ndarray, tracks: np.ndarray) -> None:
        """Make the records of sensors and memory, zeroed."""
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
        self._perception = tuple(Sensing(self.percepts, self.sensor_states, self.pending))
        self._minds = tuple(Minds(beliefs, tracks, self.memories, self.particles, self.messages, noise, gazes))

    @property
    def parts(self) -> dict[str, np.ndarray]:
        """Return the arrays that the future of a match depends on, by name: views of the rows that are filled."""
        sensed = {name: getattr(self, name)[:, self._sensing] for name in ("percepts", "sensor_states", "pending")}
        names = ("beliefs", "tracks", "memories", "messages", "particles")
        return {**sensed, **{name: getattr(self, name)[:, self._believing] for name in names}}

    def start(self, m: int) -> None:
        """Forget everything about match m; from now on its robots go by their sensors."""
        for array in self.parts.values():
            array[m] = np.zeros((), array.dtype)
        self.world.robots["senses"][m, self.rows] = 1
        self.asleep[m] = False

    def step(self, first: int, last: int) -> None:
        """Sense and believe in a slice of matches."""
        self.sense(first, last)
        self.tell(first, last)
        self.believe(first, last)

    def sense(self, first: int, last: int) -> None:
        """Fill the percepts from the truth."""
        numbers = self._sensor_numbers
        self.kind.sense(self._truth, self._perception, numbers, self.asleep, self.sensing, first, last)

    def tell(self, first: int, last: int) -> None:
        """Tell robots how the match stands."""
        if len(self.rows):
            tell_slice(self._truth, self.beliefs, self.asleep, self.rows, first, last)

    def believe(self, first: int, last: int) -> None:
        """Bring the beliefs up to the percepts; of the world belief gets the robots' noise and gazes alone."""
        if len(self.rows):
            numbers = self._memory_numbers
            self.kind.believe(self.percepts, self._minds, numbers, self.asleep, self.rows, first, last)

    def observe_percepts(self, out: np.ndarray, rows: np.ndarray, first: int, last: int) -> None:
        """Write what those of `rows` that use their sensors observe of their percepts into out (M, R, n)."""
        self.kind.observe(
            self.percepts, self.beliefs, self.world.robots, out, self.constants, self.sensors,
            self.settings.half_length, rows[self.senses[rows]], first, last,
        )  # fmt: skip


def rows_of(sides: tuple[int, ...], sizes: tuple[int, int]) -> slice:
    """Return the rows of some teams, which stand one after the other."""
    if not sides:
        return slice(0, 0)
    return slice(0 if HOME in sides else sizes[HOME], sum(sizes) if AWAY in sides else sizes[HOME])
