"""Tasks in forked children, whose ends are watched: a wild pointer or an endless loop ends the child alone."""

from __future__ import annotations

import faulthandler
import json
import os
import resource
import signal
import traceback
import warnings
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

Task = Callable[[], str]  # returns "" or what is wrong; ValueError: it refused
AT_ONCE = 2
SECONDS = 20  # [s] until a task counts as hung
MEMORY = 1 << 30  # [bytes] that it may take beyond what its parent has


def outcomes(tasks: Iterable[tuple[Any, Task]], group: int = 1) -> Iterator[tuple[Any, str]]:
    """Yield each task's name and its outcome: "played", "refused", or what is wrong.

    A process of its own does `group` tasks; if it dies or hangs, each of them is done again in one of its own.
    """
    running: deque[Child] = deque()
    for some in groups(tasks, group):
        if len(running) == AT_ONCE:
            yield from finished(running.popleft())
        running.append(begin(some))
    while running:
        yield from finished(running.popleft())


def groups(tasks: Iterable[tuple[Any, Task]], size: int) -> Iterator[list[tuple[Any, Task]]]:
    several = iter(tasks)
    while some := list(islice(several, size)):
        yield some


class Child(NamedTuple):
    number: int
    tasks: list[tuple[Any, Task]]
    tells: int  # where it writes a line for each task


def begin(tasks: list[tuple[Any, Task]]) -> Child:
    ours, theirs = os.pipe()
    number = os.fork()
    if number == 0:
        code = 1
        try:
            os.close(ours)
            shut_in()
            with os.fdopen(theirs, "w") as tell:
                for _, task in tasks:
                    signal.alarm(SECONDS)
                    tell.write(json.dumps(done(task)) + "\n")
            code = 0
        finally:
            os._exit(code)
    os.close(theirs)
    return Child(number, tasks, ours)


def done(task: Task) -> str:
    """Do a task in this process; return its outcome."""
    try:
        return task()[-4000:] or "played"
    except ValueError:
        return "refused"
    except BaseException:
        return traceback.format_exc()[-4000:]


def finished(child: Child) -> Iterator[tuple[Any, str]]:
    with os.fdopen(child.tells) as told:
        said = [json.loads(line) for line in told if line.endswith("\n")]
    status = os.waitpid(child.number, 0)[1]
    if status == 0:
        yield from ((name, words) for (name, _), words in zip(child.tasks, said, strict=True))
    elif len(child.tasks) > 1:
        for task in child.tasks:
            yield from finished(begin([task]))
    else:
        yield child.tasks[0][0], ending(status)


def ending(status: int) -> str:
    """Return how a child ended that did not end well."""
    if not os.WIFSIGNALED(status):
        return f"exit code {os.WEXITSTATUS(status)}"
    number = os.WTERMSIG(status)
    return "hung" if number == signal.SIGALRM else f"died by {signal.Signals(number).name}"


def shut_in() -> None:
    """Let a child end by itself when it hangs, take little memory, and say nothing on the terminal."""
    faulthandler.disable()
    warnings.simplefilter("ignore")
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    pages = int(Path("/proc/self/statm").read_text().split()[0]) if Path("/proc/self/statm").exists() else 1 << 22
    most = pages * resource.getpagesize() + MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (most, resource.getrlimit(resource.RLIMIT_AS)[1]))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.dup2(nowhere, 2)
