"""Senses: what the robots of M matches perceive and believe, and the chain of sensors and memory that fills it.

    match, ball, robots -> sense -> percepts -> believe -> beliefs, tracks, gazes

The belief half gets percepts and its own memory alone; a test that poisons the truth between the two holds it to that.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.leagues.legged_sensors import LeggedSensors
from soccer_env.observations.percepts import observe_kernel
from soccer_env.settings import Settings
from soccer_env.types import AWAY, BELIEF, HOME, TRACK

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
        watched = settings.observe != "truth" and any(learns[r] == 1 for r in rows)
        if (settings.senses[side] == "sensors" and (played or watched)) or (watched and settings.observe == "percepts"):
            found.append(side)
    return tuple(found)


@dataclass(frozen=True)
class Chain:
    """The sensors and the memory of a kind of robot."""

    percept: np.dtype
    sensor_state: np.dtype
    memory: np.dtype
    message: np.dtype
    particle: np.dtype
    sense: Callable[..., None]
    believe: Callable[..., None]
    tables: Callable[[League], np.ndarray]
    late: int  # frames by which the camera delivers late


def chain_of(league: League) -> Chain:
    """Return the chain of a league's sensors."""
    if isinstance(league.sensors, LeggedSensors):
        return legged_chain()
    return omni_chain(league.sensors.camera_delay)


@lru_cache(maxsize=1)
def legged_chain() -> Chain:
    """Return the chain of the legged robots."""
    from soccer_env.belief.legged import believe as belief
    from soccer_env.belief.legged.talk import SOUND_MESSAGE
    from soccer_env.belief.particles import PARTICLE
    from soccer_env.percept_types import LEGGED_PERCEPT
    from soccer_env.perception.legged.calibration import calibrate
    from soccer_env.perception.legged.sense import LEGGED_SENSOR_STATE, sense_slice

    return Chain(
        LEGGED_PERCEPT, LEGGED_SENSOR_STATE, belief.LEGGED_MEMORY, SOUND_MESSAGE, PARTICLE,
        sense_slice, belief.believe_slice, calibrate, 0,
    )  # fmt: skip


@lru_cache(maxsize=4)
def omni_chain(late: int) -> Chain:
    """Return the chain of the middle-size robots."""
    from soccer_env.belief.omni import believe as belief
    from soccer_env.belief.omni.radio import RADIO_MESSAGE
    from soccer_env.belief.particles import PARTICLE
    from soccer_env.percept_types import OMNI_PERCEPT
    from soccer_env.perception.omni.sense import OMNI_SENSOR_STATE, line_tables, sense_slice

    return Chain(
        OMNI_PERCEPT, OMNI_SENSOR_STATE, belief.OMNI_MEMORY, RADIO_MESSAGE, PARTICLE,
        sense_slice, belief.believe_slice, line_tables, late,
    )  # fmt: skip


class Senses:
    """Percepts (M, R), beliefs (M, R), tracks (M, R, slots) and the memory behind them, of the robots in `rows`.

    `sides` are the teams (HOME, AWAY) whose robots use their sensors; nothing is computed for the others.
    """

    def __init__(self, settings: Settings, matches: int, sides: tuple[int, ...]) -> None:
        league, (home, away) = settings.league, settings.rows
        self.settings, self.sides, self.home = settings, sides, home
        self.chain = chain = chain_of(league)
        robots, slots = home + away, league.slots.teammates + league.slots.opponents
        sensing = {HOME: range(home), AWAY: range(home, robots)}
        self.rows = np.array([r for side in sides for r in sensing[side]], np.int64)
        self.used = np.isin(np.arange(robots), self.rows)
        self.percepts = np.zeros((matches, robots), chain.percept)
        self.sensor_states = np.zeros((matches, robots), chain.sensor_state)
        self.pending = np.zeros((matches, robots, chain.late), chain.percept)
        self.beliefs, self.tracks = np.zeros((matches, robots), BELIEF), np.zeros((matches, robots, slots), TRACK)
        self.memories, self.messages = (
            np.zeros((matches, robots), chain.memory),
            np.zeros((matches, robots), chain.message),
        )
        count = league.memory.particles if settings.pose == "particles" else 0
        self.particles = np.zeros((matches, robots, count), chain.particle)
        self.sensors, self.memory_settings = league.sensors.record(), league.memory.record()
        self.tables = chain.tables(league)
        self.observer = observe_kernel(chain.percept)
        self.asleep = np.zeros(matches, bool)  # over before this step: a match that stands still draws no noise
        self.pose_sensed = int(settings.pose == "percept")

    @property
    def parts(self) -> dict[str, np.ndarray]:
        """Return the arrays that the future of a match depends on, by name."""
        names = ("percepts", "sensor_states", "pending", "beliefs", "tracks", "memories", "messages", "particles")
        return {name: getattr(self, name) for name in names}

    def start(self, m: int, robots: np.ndarray) -> None:
        """Forget everything about match m; its robots look for themselves from now on."""
        for array in self.parts.values():
            array[m] = np.zeros((), array.dtype)
        robots["senses"][m, self.rows] = 1
        self.asleep[m] = False

    def step(self, batch: Any, first: int, last: int) -> None:
        """Sense and believe in a slice of matches of a MatchBatch."""
        self.sense(batch, first, last)
        self.believe(batch, first, last)

    def sense(self, batch: Any, first: int, last: int) -> None:
        """Fill the percepts from the truth."""
        self.chain.sense(
            batch.matches, batch.balls, batch.robots, batch.robot_events, self.percepts, self.sensor_states, self.pending,
            self.beliefs, batch.constants, self.sensors, self.pose_sensed, self.asleep, self.rows, first, last,
        )  # fmt: skip

    def believe(self, batch: Any, first: int, last: int) -> None:
        """Bring the beliefs up to the percepts; of the batch it gets the robots' noise and gazes alone."""
        self.chain.believe(
            self.percepts, self.beliefs, self.tracks, self.memories, self.particles, self.messages,
            batch.robots["noise"], batch.robots["gaze"], batch.constants, self.sensors, self.memory_settings,
            self.tables, self.home, self.asleep, self.rows, first, last,
        )  # fmt: skip

    def observe_percepts(self, batch: Any, out: np.ndarray, rows: np.ndarray, first: int, last: int) -> None:
        """Write what those of `rows` that use their sensors observe of their percepts into out (M, R, n)."""
        self.observer(
            self.percepts, self.beliefs, batch.robots, out, batch.constants, self.sensors,
            self.settings.half_length, rows[self.used[rows]], first, last,
        )  # fmt: skip
