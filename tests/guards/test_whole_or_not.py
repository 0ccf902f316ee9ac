"""Whatever a signal interrupts is done or not done: resets, steps, saves, loads and branches, through every API."""

import signal
from collections.abc import Iterable
from contextlib import suppress
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.replay import Recorder
from tests.guards.cases import CASES
from tests.guards.interrupted import StopError, at_every_line, by_timers, interrupted, stop

pytestmark = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="timers are Unix's")
TRIALS = 15  # of each case; `python -m tests.guards.interrupted` makes thousands


def dear(names: Iterable[str], which: tuple[str, ...]) -> list[Any]:
    """Return names of cases as parameters, those that take seconds left to `make test-all`."""
    return [pytest.param(name, marks=pytest.mark.whole if name in which else ()) for name in names]


@pytest.mark.parametrize("name", dear(CASES, ("SoccerVecEnv",)))
def test_what_a_timer_interrupts_is_done_or_not_done(name: str) -> None:
    assert by_timers(name, TRIALS, seed=1)["torn"] == 0


LINES = ("same_step", "save, load, branch, rebuild", "parallel env")


@pytest.mark.parametrize("name", dear(LINES, ("save, load, branch, rebuild",)))
def test_what_a_signal_at_any_line_interrupts_is_done_or_not_done(name: str) -> None:
    lines: set[object] = set()
    known = [-1]

    def enough() -> bool:
        known.append(len(lines))
        return len(known) > 40 and known[-1] == known[-30]

    found = interrupted(CASES[name], at_every_line(lines), 2000, enough)
    assert found["torn"] == 0 and len(lines) > 80, (found, len(lines))


def test_handlers_are_back_after_a_step() -> None:
    before = signal.signal(signal.SIGALRM, stop)
    try:
        match = Match(home=1, away=1, seed=1)
        match.step(np.zeros((1, 2, 4)))
        assert signal.getsignal(signal.SIGALRM) is stop
    finally:
        signal.signal(signal.SIGALRM, before)


# An error that is no signal may come anywhere: no step goes on from what it left


def cut_short(match: Match, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let an error raise in the middle of a step."""
    match.step(np.zeros((1, 2, 4)))
    with monkeypatch.context() as patched, pytest.raises(MemoryError):
        patched.setattr(match.batch, "observe", lambda *rows: (_ for _ in ()).throw(MemoryError))
        match.step(np.zeros((1, 2, 4)))


@pytest.mark.parametrize("name", ["step", "save", "rebuild", "branch"])
def test_a_match_that_an_error_has_cut_short_asks_for_a_reset(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    match = Match(home=1, away=1, seed=1)
    saved = match.save()
    cut_short(match, monkeypatch)
    arguments = {"step": (np.zeros((1, 2, 4)),), "branch": ([0],)}.get(name, ())
    with pytest.raises(RuntimeError, match="call reset"):
        getattr(match, name)(*arguments)
    match.load(saved)
    match.step(np.zeros((1, 2, 4)))
    cut_short(match, monkeypatch)
    assert np.isfinite(match.reset(seed=2)).all()
    match.step(np.zeros((1, 2, 4)))


def test_a_recording_goes_on_after_a_step_that_was_undone() -> None:
    match = Match(home=1, away=1, seed=1)
    recorder = Recorder(match)
    before = signal.signal(signal.SIGALRM, stop)
    try:
        for n in range(30):
            with suppress(StopError):  # it may come after the step as well
                try:
                    signal.setitimer(signal.ITIMER_REAL, 1e-5 * (n + 1))
                    match.step(np.zeros((1, 2, 4)))
                finally:
                    signal.setitimer(signal.ITIMER_REAL, 0.0)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert recorder.stop().check() <= 30
