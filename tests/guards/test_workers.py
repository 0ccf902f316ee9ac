"""Threads that share out a task: none runs on when it has failed, and a forked process has its own."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import pytest

from soccer_env.guards.workers import Workers


def test_results_come_in_order_and_from_several_threads() -> None:
    workers, meeting = Workers(2), threading.Barrier(2, timeout=20.0)

    def meet(first: int, last: int) -> int:
        meeting.wait()
        return 10 * first + last

    assert workers.map(meet, [1, 2], [3, 4]) == [13, 24]
    workers.shutdown()
    assert workers.map(meet, [1, 2], [3, 4]) == [13, 24], "it begins anew after its end"


def test_one_thread_is_the_callers_own() -> None:
    assert Workers(1).map(lambda _: threading.get_ident(), [0, 1]) == [threading.get_ident()] * 2


def test_an_error_comes_when_the_other_parts_are_done() -> None:
    done = []

    def part(number: int) -> None:
        if number == 0:
            raise KeyError("the first part")
        time.sleep(0.2)
        done.append(number)

    with pytest.raises(KeyError, match="the first part"):
        Workers(2).map(part, [0, 1])
    assert done == [1]


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="timers are Unix's")
def test_an_interrupt_comes_when_all_parts_are_done() -> None:
    running: list[int] = []

    def part(number: int) -> None:
        running.append(number)
        time.sleep(0.3)
        running.remove(number)

    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.1)
        with pytest.raises(KeyboardInterrupt):
            Workers(2).map(part, [1, 2])
        assert running == []
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


FORK = """
    import os
    from soccer_env import Match
    match = Match(home=1, away=1, matches=8, threads=2, seed=1, controllers={"home": "chaser", "away": "chaser"})
    match.step()
    child = os.fork()
    match.step()
    os.write(1, f"{match.state_hash()}\\n".encode())  # in one piece, as both write at once
    if child:
        os.waitpid(child, 0)
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="Windows does not fork")
def test_a_match_with_two_threads_steps_on_in_a_forked_process_as_in_its_parent() -> None:
    command = [sys.executable, "-W", "ignore", "-c", textwrap.dedent(FORK)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    hashes = done.stdout.split()
    assert len(hashes) == 2 and len(set(hashes)) == 1, done.stderr
