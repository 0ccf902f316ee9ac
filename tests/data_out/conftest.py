"""Short recordings, one for each league, with goals, shots and a half-time in them."""

from pathlib import Path
from typing import Any

import pytest

from soccer_env import Match
from soccer_env.data_out.collect import Collected, collect
from soccer_env.replay import Recorder, Replay

MINUTES = {"legged-2001": 1.0, "middle-size-2006": 0.6}


def record(name: str, **given: Any) -> Replay:
    """Return a recording of the chaser against a random team, two a side."""
    settings = {"home": 2, "away": 2, "seed": 4, "senses": "ideal", "minutes": MINUTES[name]}
    match = Match(name, controllers={"home": "chaser", "away": "random"}, **{**settings, **given})
    recorder = Recorder(match)
    while not match.terminated.all():
        match.step()
    return recorder.stop()


@pytest.fixture(scope="session", params=[*MINUTES])
def replay(request: pytest.FixtureRequest) -> Replay:
    return record(request.param)


@pytest.fixture(scope="session")
def found(replay: Replay) -> Collected:
    return collect(replay, "a match")


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with two replays, one of them in a folder of its own."""
    place = tmp_path_factory.mktemp("replays")
    (place / "deep").mkdir()
    for name, seed in (("one", 1), ("deep/two", 2)):
        record("middle-size-2006", seed=seed, minutes=0.1, home=1, away=1).write(place / f"{name}.replay")
    return place
