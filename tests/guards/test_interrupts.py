"""Interrupts wait while a Space is made or dropped; no signal is lost, and none ends the process later."""

import gc
import signal
import subprocess
import sys
import textwrap
import threading
import time
import weakref
from types import FrameType

import pytest

from soccer_env import Match
from soccer_env.guards.interrupts import SignalsHeld


class StopError(Exception):
    """What the handlers here raise."""


@pytest.fixture(autouse=True)
def handlers(monkeypatch: pytest.MonkeyPatch) -> object:
    """Let two signals raise, and put back what was there."""

    def stop(number: int, frame: FrameType | None) -> None:
        raise StopError(number)

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    yield stop
    for number, handler in before.items():
        signal.signal(number, handler)


def test_a_signal_waits_for_the_end_of_the_outermost() -> None:
    done = []
    with pytest.raises(StopError), SignalsHeld():
        with SignalsHeld():
            signal.raise_signal(signal.SIGINT)
        done.append("the rest")
    assert done == ["the rest"]


def test_two_signals_both_come_and_the_handlers_are_back(handlers: object) -> None:
    with pytest.raises(StopError) as error, SignalsHeld():
        signal.raise_signal(signal.SIGTERM)
        signal.raise_signal(signal.SIGINT)
    assert {error.value.args[0], error.value.__context__.args[0]} == {signal.SIGINT, signal.SIGTERM}  # type: ignore[union-attr]
    assert signal.getsignal(signal.SIGINT) is signal.getsignal(signal.SIGTERM) is handlers


def test_without_a_signal_nothing_happens_and_the_handlers_are_back(handlers: object) -> None:
    with pytest.raises(ZeroDivisionError), SignalsHeld():
        _ = 1 // 0
    assert signal.getsignal(signal.SIGINT) is handlers


def test_a_destructor_sends_it_on_once_it_has_ended() -> None:
    done = []

    class Thing:
        def __del__(self) -> None:
            with SignalsHeld(later=True):
                signal.raise_signal(signal.SIGINT)
            time.sleep(0.1)  # in which it must not come
            done.append("the rest")

    with pytest.raises(StopError):
        Thing()
        for _ in range(2000):  # a signal that another thread sends ends no sleep of this one
            time.sleep(0.01)
    assert done == ["the rest"]


def test_other_threads_hold_nothing_back_and_may_ask(handlers: object) -> None:
    seen: list[object] = []

    def ask() -> None:
        with SignalsHeld():
            seen.append(signal.getsignal(signal.SIGINT))

    thread = threading.Thread(target=ask)
    thread.start()
    thread.join()
    assert seen == [handlers]


def reset_with_another_space(match: Match) -> None:
    """Reset a match so that it gets a new Space, which a reset else puts back as good as new."""
    match.batch.physics.forget()
    match.reset(seed=2)


def test_a_space_is_freed_with_its_bodies_and_shapes_when_its_match_gets_another() -> None:
    """Not when the garbage collector runs next, wherever that is."""
    match = Match(home=2, away=2, seed=1)
    space = match.batch.physics.spaces[0]
    assert space is not None
    parts = [space, *space.bodies, *space.shapes, *space.constraints, space.static_body]
    alive = [weakref.ref(part) for part in parts]
    del space, parts
    gc.disable()
    try:
        reset_with_another_space(match)
        assert [one() for one in alive if one() is not None] == []
    finally:
        gc.enable()


def test_a_space_that_somebody_keeps_lives_on() -> None:
    match = Match(home=1, away=1, seed=1)
    space = match.batch.physics.spaces[0]
    assert space is not None
    reset_with_another_space(match)
    assert match.batch.physics.spaces[0] is not space
    space.step(0.01)
    assert len(space.bodies) == 3


BEGIN = """
    import gc, signal, sys, numpy as np
    from soccer_env import Match
    match = Match("legged-2001", home=1, away=1, seed=1)
    renew = match.batch.physics.forget  # a known Space would be put back in place of making another
    def stop(*_):
        raise KeyboardInterrupt
    signal.signal(signal.SIGALRM, stop)
"""
SIGNALS = """
    match.reset(seed=0)  # compiled code is loaded
    for n in range(300):
        try:
            signal.setitimer(signal.ITIMER_REAL, 1e-5 + 8e-4 * np.random.default_rng(n).random(), 2.0)
            while True:
                renew()
                match.reset(seed=n)
        except KeyboardInterrupt:
            signal.setitimer(signal.ITIMER_REAL, 0)
        match.step(np.zeros((1, 2, 4)))
        assert np.isfinite(match.robots["x"]).all()
"""
LINES = """
    import pymunk.body, pymunk.constraints, pymunk.shapes, pymunk.space
    from soccer_env.match import batch as match_batch
    from soccer_env.physics.engine import space, space_batch
    from soccer_env.physics.solver import rounds
    modules = match_batch, space, space_batch, rounds, *(vars(pymunk)[name] for name in
        ("body", "constraints", "shapes", "space"))
    files, lines = {one.__file__ for one in modules}, set()
    def follow(frame, event, argument):
        place = frame.f_code, frame.f_lineno
        if frame.f_code.co_filename in files and event == "line" and place not in lines:
            lines.add(place)
            if SIGNALS_ALONE:
                signal.raise_signal(signal.SIGALRM)
            elif frame.f_code.co_name in ("set_space", "_link", "drop"):
                raise KeyboardInterrupt
        return follow
    before = -1
    while before < len(lines):
        before = len(lines)
        sys.settrace(follow)
        try:
            renew()
            match.reset(seed=len(lines))
        except KeyboardInterrupt:
            pass
        sys.settrace(None)
        if not match.started:  # an error may come where no signal does: then it asks for a reset
            assert not SIGNALS_ALONE
            match.reset(seed=1)
        for _ in range(20):
            match.step(np.zeros((1, 2, 4)))
    assert len(lines) > 200, len(lines)
"""
ATTACKS = {
    "signals at random": SIGNALS,
    "signals at random while Spaces are put back": SIGNALS.replace("renew()\n                match", "match"),
    "a signal at every line": LINES.replace("SIGNALS_ALONE", "True"),
    "an error at every line": LINES.replace("SIGNALS_ALONE", "False"),
}


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="timers are Unix's")
@pytest.mark.parametrize("attack", ATTACKS.values(), ids=ATTACKS.keys())
def test_an_interrupted_reset_never_ends_the_process(attack: str) -> None:
    done = subprocess.run([sys.executable, "-c", textwrap.dedent(BEGIN + attack)], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
