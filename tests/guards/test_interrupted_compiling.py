"""A signal ends compiling between two steps of the compiler, soon, and leaves neither numba nor a match in between."""

import json
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from types import FrameType
from typing import Any

import pytest
from numba.core.registry import cpu_target

from soccer_env.compiled import compiled, config
from soccer_env.compiling import stops
from soccer_env.guards.interrupts import SignalsHeld

pytestmark = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")


class StopError(Exception):
    """What the handler raises: an error that numba would take for one of its own."""


@pytest.fixture
def stop() -> Iterator[None]:
    def raised(number: int, frame: FrameType | None) -> None:
        raise StopError

    before = signal.signal(signal.SIGINT, raised)
    yield
    signal.signal(signal.SIGINT, before)


def fresh() -> tuple[Any, Any]:
    """Return a function that calls another one, both yet to be compiled."""

    @compiled
    def half(x):  # type: ignore[no-untyped-def]
        return 0.5 * x

    @compiled
    def halves(x):  # type: ignore[no-untyped-def]
        total = 0.0
        for n in range(3):
            total += half(x) * n
        return total

    half._cache.disable()
    halves._cache.disable()
    return half, halves


def at_stop(monkeypatch: pytest.MonkeyPatch, wanted: int) -> list[int]:
    """Let a signal come at the stop of that number, counted from 1; return a list that grows by each stop."""
    seen: list[int] = []
    come = stops.deliver_waiting_signals

    def counted() -> None:
        seen.append(len(seen) + 1)
        if len(seen) == wanted:
            signal.raise_signal(signal.SIGINT)
        come()

    monkeypatch.setattr(stops, "deliver_waiting_signals", counted)
    return seen


def test_a_signal_at_any_stop_ends_compiling_and_numba_goes_on(monkeypatch: pytest.MonkeyPatch, stop: None) -> None:
    with monkeypatch.context() as patch:
        stops_there = at_stop(patch, 0)
        assert fresh()[1](2.0) == 3.0
    assert len(stops_there) > 40
    for wanted in range(1, len(stops_there), 7):
        kernels = fresh()
        with monkeypatch.context() as patch, pytest.raises(StopError) as error:
            at_stop(patch, wanted)
            kernels[1](2.0)
        assert error.value.__context__ is None
        assert not cpu_target.typing_context.callstack._stack
        assert not any(kernel._compiling_counter.counter for kernel in kernels)
        assert (stops.compiling.depth, stops.compiling.stoppable) == (0, False)
        assert kernels[1](2.0) == 3.0


def test_a_handler_that_returns_may_compile_and_the_compiling_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    found = []
    before = signal.signal(signal.SIGINT, lambda number, frame: found.append(fresh()[1](4.0)))
    try:
        at_stop(monkeypatch, 9)
        assert fresh()[1](2.0) == 3.0
    finally:
        signal.signal(signal.SIGINT, before)
    assert found == [6.0]


def test_a_signal_does_not_wait_for_llvm(stop: None) -> None:
    go_on, ended = threading.Event(), []

    def work() -> None:
        go_on.wait(10.0)
        ended.append(True)

    with pytest.raises(StopError), SignalsHeld(), stops.stoppable():
        signal.raise_signal(signal.SIGINT)
        stops.run_stoppably(work)
    assert not ended
    go_on.set()
    stops._join_lock_holders()
    assert ended


def test_a_signal_does_not_wait_for_another_thread_that_compiles(stop: None) -> None:
    begun, go_on = threading.Event(), threading.Event()

    def compile_for_long() -> None:
        with stops.stoppable():
            begun.set()
            go_on.wait(10.0)

    other = threading.Thread(target=compile_for_long)
    other.start()
    begun.wait()
    at = time.monotonic()
    with pytest.raises(StopError), SignalsHeld():
        signal.raise_signal(signal.SIGINT)
        fresh()[0].compile((cpu_target.typing_context.resolve_value_type(1.0),))
    assert time.monotonic() - at < 5.0
    go_on.set()
    other.join()


def test_what_llvm_raises_comes(stop: None) -> None:
    def fail() -> None:
        raise ArithmeticError

    with pytest.raises(ArithmeticError), SignalsHeld(), stops.stoppable():
        stops.run_stoppably(fail)


LIMIT = 1.0  # [s] of processor time, from an interrupt until it has ended what it fell in
MATCH: dict[str, Any] = {"home": 1, "away": 1, "seed": 1, "senses": "ideal", "opponents": "chaser"}

INTERRUPTED = """
    import json, os, random, signal, sys, threading, time, traceback
    import numpy as np
    from numba.core.registry import cpu_target
    from soccer_env import Match
    from soccer_env.compiling.inner import Kernel
    from soccer_env.compiling.stops import compiling

    settings, seed, most = json.loads(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    draw = random.Random(seed)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    unraisable = []
    sys.unraisablehook = unraisable.append
    kernels = []
    begun = Kernel.__init__
    Kernel.__init__ = lambda self, *a, **k: (kernels.append(self), begun(self, *a, **k))[1]
    slow = 0.9  # [s] from which on it is said where the main thread was
    at = []  # where the main thread was
    ended = []  # [s] of processor time that each interrupt took

    def clean():
        assert not cpu_target.typing_context.callstack._stack, "numba believes that it compiles"
        assert not any(kernel._compiling_counter.counter for kernel in kernels), "a kernel counts itself"
        assert compiling.depth == 0 and not compiling.stoppable, "depth"
        assert not unraisable, unraisable

    def until_done(do):
        for _ in range(most):
            sent = []
            def press():
                at.append("".join(traceback.format_stack(sys._current_frames()[threading.main_thread().ident])[-7:]))
                sent.append(time.process_time())
                os.kill(os.getpid(), signal.SIGINT)
            timer, made = threading.Timer(10.0 ** draw.uniform(-2.0, 1.2), press), []
            try:
                timer.start()
                made.append(do())
                timer.cancel()
                timer.join()
                time.sleep(0.001)  # one that was just sent comes
            except KeyboardInterrupt:
                if not made:
                    ended.append(time.process_time() - sent[0])
                    if ended[-1] > slow:
                        print(f"{ended[-1]:.2f} s after", at[-1], file=sys.stderr)
            timer.join()
            clean()
            if made:
                return made[0]
        return do()

    def unchanged(do):
        def done():
            before = match.state_hash()
            try:
                return do()
            except KeyboardInterrupt:
                assert match.state_hash() == before, "it has changed"
                raise
        return done

    hashes = []
    match = until_done(lambda: Match(**settings))
    actions = np.random.default_rng(1).uniform(-1.0, 1.0, (1, settings["home"] + settings["away"], 4))
    for name, do in [
        ("step", unchanged(lambda: match.step(actions))),
        ("reset", lambda: match.reset(seed=2)),
        ("step", unchanged(lambda: match.step(actions))),
    ]:
        until_done(do)
        hashes.append(match.state_hash())
    for _ in range(20):
        match.step(actions)
    print(json.dumps([ended, [*hashes, match.state_hash()]]))
"""


def played(cache: Path, most: int) -> tuple[list[float], Any]:
    """Play in a process with at most so many interrupts of each thing; return what they took [s], and hashes."""
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(INTERRUPTED), json.dumps(MATCH), "1", str(most)],
        env={**os.environ, "SOCCER_ENV_CACHE": str(cache), "TMPDIR": str(cache), "SOCCER_ENV_QUIET": "1"},
        capture_output=True, text=True, timeout=1800, check=False,
    )  # fmt: skip
    assert done.returncode == 0, (done.returncode, done.stderr)
    print(done.stderr, end="", file=sys.stderr)
    ended, hashes = json.loads(done.stdout)
    return ended, hashes


@pytest.mark.whole
@pytest.mark.skipif(os.name != "posix", reason="sends itself a signal as a terminal does")
def test_an_interrupt_ends_compiling_soon_and_the_match_plays_on(tmp_path: Path) -> None:
    """The process begins with an empty cache and sends itself Ctrl-C while it makes a match, steps, resets."""
    ended, hashes = played(tmp_path, most=8)
    assert len(ended) > 4, "hardly anything was interrupted"
    assert max(ended) < LIMIT, ended
    assert played(tmp_path, most=0) == ([], hashes)
