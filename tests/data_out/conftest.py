"""Short recordings, one for each league, with goals, shots and a half-time in them."""

from pathlib import Path
from typing import Any

import pytest

from soccer_env import Match
from soccer_env.data_out.collect import MatchRecording, collect_match
from soccer_env.replay import Recorder, Replay

STAGED: dict[str, dict[str, Any]] = {  # goals in both halves; both teams keep the ball, pass and shoot
    "legged-2001": {"minutes": 1.5, "seeds": [26], "controllers": {"home": "chaser", "away": "random"}},
    "middle-size-2006": {"minutes": 0.6, "seeds": [27], "controllers": {"home": "random", "away": "chaser"}},
}


def record(name: str, **given: Any) -> Replay:
    match = Match(name, home=2, away=2, senses="ideal", **given)
    recorder = Recorder(match)
    while not match.terminated.all():
        match.step()
    return recorder.stop()


@pytest.fixture(scope="session", params=[*STAGED])
def replay(request: pytest.FixtureRequest) -> Replay:
    return record(request.param, **STAGED[request.param])


@pytest.fixture(scope="session")
def found(replay: Replay) -> MatchRecording:
    return collect_match(replay, "a match")


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with two replays, one of them in a folder of its own."""
    place = tmp_path_factory.mktemp("replays")
    (place / "deep").mkdir()
    for name, seed in (("one", 1), ("deep/two", 2)):
        short = {**STAGED["middle-size-2006"], "seeds": [seed], "minutes": 0.1}
        record("middle-size-2006", **short).write(place / f"{name}.replay")
    return place
