"""Interrupt what matches and envs do, at random times or at every line, and tell whether it was done, undone or torn.

Two of a kind (`cases.py`) play side by side; one of them is interrupted, and has to stand as the other one did before
or does after, bit for bit, and to go on like it.

    python -m tests.guards.interrupted 10000    so many signals over all cases, and a table of what became of them
"""

from __future__ import annotations

import signal
import sys
from collections import Counter
from collections.abc import Callable
from time import perf_counter
from types import FrameType
from typing import Any

import numpy as np

from tests.guards.cases import CASES, Case, Do, look, seen


class StopError(Exception):
    """What the handler raises."""


def stop(number: int, frame: FrameType | None) -> None:
    raise StopError


Attack = Callable[[Do, int], Any]  # does it with the number of the trial, and raises StopError if it was interrupted


def at_a_time(rng: np.random.Generator, lasts: list[float]) -> Attack:
    """Return an attack by a timer, at a random time within what the same took before."""

    def attack(do: Do, n: int) -> Any:
        begun = perf_counter()
        try:
            signal.setitimer(signal.ITIMER_REAL, max(1e-6, rng.uniform(0.0, 1.2) * lasts[0]))
            return do(n)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            lasts[0] = 0.9 * lasts[0] + 0.1 * min(perf_counter() - begun, 4.0 * lasts[0])

    return attack


def at_every_line(lines: set[Any]) -> Attack:
    """Return an attack by a signal at the first line of ours that was not yet interrupted."""

    def attack(do: Do, n: int) -> Any:
        waiting = True

        def follow(frame: FrameType, event: str, argument: Any) -> Any:
            nonlocal waiting
            name = frame.f_code.co_filename
            if "soccer_env" not in name and "/train/" not in name:
                return None
            place = frame.f_code, frame.f_lineno
            if waiting and event == "line" and place not in lines:
                lines.add(place)
                waiting = False
                signal.raise_signal(signal.SIGALRM)
            return follow

        sys.settrace(follow)
        try:
            return do(n)
        finally:
            sys.settrace(None)

    return attack


def interrupted(make: Callable[[], Case], attack: Attack, trials: int, enough: Callable[[], bool]) -> Counter[str]:
    """Interrupt one of two cases of a kind again and again; return how often it was done, undone, torn or missed."""
    before = signal.signal(signal.SIGALRM, stop)
    found: Counter[str] = Counter()
    try:
        case, other = make(), make()
        for n in range(4 * len(case.does)):
            assert seen(case.does[n % len(case.does)](n)) == seen(other.does[n % len(case.does)](n))
        for n in range(trials):
            place = n % len(case.does)
            found[became(case, other, place, attack, n)] += 1
            if found["torn"] or enough():
                break
    finally:
        signal.signal(signal.SIGALRM, before)
    return found


def became(case: Case, other: Case, place: int, attack: Attack, n: int) -> str:
    """Interrupt what is done with a case, do it with the other one undisturbed, and return how the first stands."""
    stood = look(case)
    assert stood == look(other)
    try:
        made: Any = attack(case.does[place], n)
    except StopError:
        stands = look(case)
        if stands == stood:
            if not calls_back(case):
                for match in (*case.matches(), *other.matches()):
                    match.rebuild()
            made = case.does[place](n)
            verdict = "undone"
        else:
            made, verdict = None, "done"
    else:
        verdict = "missed"
    expected = other.does[place](n)
    if look(case) != look(other) or (made is not None and seen(made) != seen(expected)):
        return "torn"
    return verdict


def calls_back(case: Case) -> bool:
    """Tell whether signals wait for the end of what is done, so that a step that is undone has not begun."""
    return all(not match._turn.undoes for match in case.matches())


def by_timers(name: str, trials: int, seed: int) -> Counter[str]:
    return interrupted(CASES[name], at_a_time(np.random.default_rng(seed), [2e-4]), trials, lambda: False)


def main() -> None:
    """Spread signals over all cases, and print what became of them."""
    wanted = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    total: Counter[str] = Counter()
    for index, name in enumerate(CASES):
        found: Counter[str] = Counter()
        while sum(found.values()) - found["missed"] < wanted / len(CASES) and not found["torn"]:
            found += by_timers(name, 200, 1000 * index + sum(found.values()))
        print(f"{name:32} {dict(found)}", flush=True)
        total += found
    print(f"{'in all':32} {dict(total)}")
    sys.exit(1 if total["torn"] else 0)


if __name__ == "__main__":
    main()
