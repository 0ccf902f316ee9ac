"""Tasks in forked children, whose ends are watched: a wild pointer or an endless loop ends the child alone."""

from __future__ import annotations

import faulthandler
import os
import resource
import signal
import traceback
import warnings
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

Task = Callable[[], str]  # returns "" or what is wrong; ValueError: it refused
AT_ONCE = 2
SECONDS = 20  # until a child counts as hung
MEMORY = 1 << 30  # [bytes] that it may take beyond what its parent has
PLAYED, REFUSED, WRONG = 0, 3, 4  # exit codes
WORDS = {PLAYED: "played", REFUSED: "refused"}


def outcomes(tasks: Iterable[tuple[Any, Task]]) -> Iterator[tuple[Any, str]]:
    """Yield each task's name and its outcome: "played", "refused", or what is wrong. Each has a process of its own."""
    running: deque[tuple[Any, int, int]] = deque()
    for name, task in tasks:
        if len(running) == AT_ONCE:
            yield outcome(*running.popleft())
        running.append((name, *begin(task)))
    while running:
        yield outcome(*running.popleft())


def begin(task: Task) -> tuple[int, int]:
    """Start a child; return its process id and where it says what is wrong."""
    ours, theirs = os.pipe()
    child = os.fork()
    if child == 0:
        code = WRONG
        try:
            os.close(ours)
            shut_in()
            said = task()
            code = WRONG if said else PLAYED
        except ValueError:
            code = REFUSED
        except BaseException:
            said = traceback.format_exc()
        finally:
            if code == WRONG:
                os.write(theirs, said.encode(errors="replace")[-4000:])
            os._exit(code)
    os.close(theirs)
    return child, ours


def shut_in() -> None:
    """Let a child end by itself when it hangs, take little memory, and say nothing on the terminal."""
    faulthandler.disable()
    warnings.simplefilter("ignore")
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.alarm(SECONDS)
    pages = int(Path("/proc/self/statm").read_text().split()[0]) if Path("/proc/self/statm").exists() else 1 << 22
    most = pages * resource.getpagesize() + MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (most, resource.getrlimit(resource.RLIMIT_AS)[1]))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.dup2(nowhere, 2)


def outcome(name: Any, child: int, ours: int) -> tuple[Any, str]:
    """Wait for a child; return its task's name and how it ended."""
    with os.fdopen(ours, "rb") as said:
        words = said.read().decode(errors="replace")
    status = os.waitpid(child, 0)[1]
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        return name, "hung" if number == signal.SIGALRM else f"died by {signal.Signals(number).name}"
    code = os.WEXITSTATUS(status)
    return name, WORDS.get(code, words.strip() or f"exit code {code}")
