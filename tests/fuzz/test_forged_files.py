"""No file of a stranger ends the process, hangs it, or gives NaN without an error: a slice of `make fuzz`."""

import io
import os
import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.match import saving
from soccer_env.replay import Recorder
from tests.fuzz.children import outcomes
from tests.fuzz.fuzz import Forger, found_by
from tests.fuzz.replays import use
from tests.fuzz.targets import load_and_play
from tests.scenes.staging import play

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="children are forked")

FILES = 300
CORPUS = [  # numbers of the second robot of four that have ended a process
    {"caught_by": 10**6}, {"caught_by": 5}, {"caught_by": 10**11}, {"caught_by": -1}, {"caught_by": 2},
    {"caught_by": 1, "caught_leg": 2_000_000}, {"caught_by": 1, "caught_gap": 2**62}, {"caught_by": -(2**63)},
]  # fmt: skip


def test_forged_files_are_played_or_refused(tmp_path: Path) -> None:
    forger = Forger(1, tmp_path, ("sacks", "learners", "omni"), ("legged",))
    counts, findings = found_by(forger, list(range(FILES)))
    assert findings == []
    assert min(counts["played"], counts["refused"]) > FILES // 10, counts


@pytest.fixture(scope="module")
def lively() -> Match:
    match = Match(home=2, away=2, seed=1, senses="ideal", controllers={"home": "chaser", "away": "chaser"})
    play(match, steps=10)
    return match


@pytest.mark.parametrize("fields", CORPUS, ids=str)
def test_what_once_ended_a_process_is_refused(fields: dict[str, int], lively: Match, tmp_path: Path) -> None:
    lively.rebuild()
    recorder = Recorder(lively)
    play(lively, steps=3)
    replay = recorder.stop()
    forged = replay.make_match()
    for name, value in fields.items():
        forged.robots[name][0, 1] = value
    replay.start = saving.dump(forged, memory=False)
    with np.load(io.BytesIO(replay.write(tmp_path / "caught.replay").read_bytes())) as file:
        parts = {name: file[name] for name in file.files}
    was = lively.robots.copy()
    for name, value in fields.items():
        lively.robots[name][0, 1] = value
    saved = saving.dump(lively)
    lively.robots[:] = was
    tasks: list[tuple[str, Any]] = [("save", lambda: load_and_play(lively, saved))]
    tasks += [(how, lambda how=how: use(parts, tmp_path / "a.replay", how)) for how in ("play", "page", "csv")]
    assert dict(outcomes(tasks)) == dict.fromkeys(("save", "play", "page", "csv"), "refused")


def test_the_watch_sees_how_children_end() -> None:
    def refuse() -> str:
        raise ValueError("no")

    def err() -> str:
        raise KeyError("none")

    def die() -> str:
        os.kill(os.getpid(), signal.SIGSEGV)
        return ""

    def hang() -> str:
        os.kill(os.getpid(), signal.SIGALRM)
        return ""

    def swell() -> str:
        return str(len(bytearray(8 << 30)))

    tasks = {
        "": lambda: "", "refuse": refuse, "err": err, "die": die, "hang": hang, "say": lambda: "NaN", "swell": swell,
    }  # fmt: skip
    found = dict(outcomes(tasks.items()))
    assert [found[name] for name in ("", "refuse", "die", "hang", "say")] == [
        "played", "refused", "died by SIGSEGV", "hung", "NaN",
    ]  # fmt: skip
    assert "KeyError" in found["err"] and "MemoryError" in found["swell"]
