"""Robots that only talk, for tests: beliefs are set, frames pass, and what arrives is looked at."""

from math import inf
from typing import Any

import numpy as np

from soccer_env.belief.legged.talk import SOUND_MESSAGE, exchange_words
from soccer_env.belief.omni.radio import RADIO_MESSAGE, exchange_radio
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.records.beliefs import BELIEF, TRACK
from soccer_env.records.percepts import LEGGED_PERCEPT, OMNI_PERCEPT
from soccer_env.types import NOISE_STREAMS
from tests.scenes.staging import LEGGED, MIDDLE


@compiled
def talk(percepts, beliefs, tracks, messages, noise, constants, sensors, settings, home, rows):  # type: ignore[no-untyped-def]
    exchange_words(percepts, beliefs, tracks, messages, noise, constants[0], sensors[0], settings[0], home, rows)


@compiled
def talk_by_radio(percepts, beliefs, tracks, messages, noise, constants, sensors, settings, home, rows):  # type: ignore[no-untyped-def]
    exchange_radio(percepts, beliefs, tracks, messages, noise, constants[0], sensors[0], settings[0], home, rows)


class Talkers:
    """Robots of one match that only talk: rows below `home` are one team; nothing is lost unless the test says so."""

    def __init__(self, league: str = LEGGED, home: int = 3, away: int = 3, **sensors: float) -> None:
        robots, self.league, self.home = home + away, find_league(league), home
        self.radio = league == MIDDLE
        self.percepts = np.zeros(robots, OMNI_PERCEPT if self.radio else LEGGED_PERCEPT)
        self.beliefs = np.zeros(robots, BELIEF)
        self.messages = np.zeros(robots, RADIO_MESSAGE if self.radio else SOUND_MESSAGE)
        slots = self.league.slots
        self.tracks = np.zeros((robots, slots.teammates + slots.opponents), TRACK)
        self.noise = np.random.default_rng(5).integers(0, 1 << 63, (robots, NOISE_STREAMS), np.uint64)
        loss = {"radio_loss": 0.0} if self.radio else {"audio_loss": 0.0}
        self.sensors = self.league.sensors.changed(loss | sensors).record()
        self.settings, self.constants = self.league.memory.record(), constants_of(self.league)
        self.rows = np.arange(robots)
        body = self.percepts["body"]
        body["active"] = body["upright"] = body["handedness"] = 1
        body["frame"] = -1
        self.beliefs["own"]["confidence"] = 100.0
        self.beliefs["ball"]["age"] = inf

    def see(self, r: int, distance: float) -> None:
        """Let a robot see the ball at a distance [m], straight ahead."""
        ball = self.beliefs["ball"][r : r + 1]
        ball["distance"] = ball["filtered_distance"] = ball["x"] = distance
        ball["confidence"], ball["age"] = 100.0, 0.0

    def lose(self, r: int) -> None:
        """Let a robot not have seen the ball for long."""
        self.beliefs["ball"]["confidence"][r], self.beliefs["ball"]["age"][r] = 0.0, 20.0

    def step(self, frames: int = 1) -> None:
        for _ in range(frames):
            self.percepts["body"]["frame"] += 1
            common = self.percepts, self.beliefs, self.tracks, self.messages, self.noise, self.constants, self.sensors
            (talk_by_radio if self.radio else talk)(*common, self.settings, self.home, self.rows)

    def heard(self, name: str = "word") -> list[Any]:
        return self.beliefs["heard"][name].tolist()
