"""Processes that share the claims of a run: each measures one claim after another, on one core.

    python -m soccer_env.train.papers.workers     the program of a worker, which reads requests line by line

A worker reads JSON lines: first the settings of the run, then the id and cap of each claim to examine. It answers each
claim with one line, the result. No result depends on the process that measured it.
"""

import json
import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import Any

from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.examination import examine
from soccer_env.train.papers.results import ClaimResult
from soccer_env.train.papers.settings import ReproduceSettings

DONE = None  # in the queue of results: a worker has ended


def examine_in_processes(
    caps: Mapping[str, int], settings: ReproduceSettings, settings_hash: str,
    finished: Callable[[str], None] = lambda claim: None,
) -> Iterator[ClaimResult]:  # fmt: skip
    """Yield results as they come, from settings.threads processes; `caps`: the cap of each claim, in the order of work.

    `finished` is called with each id. Raises RuntimeError if a process fails; its own message is on the screen.
    """
    waiting: queue.SimpleQueue[tuple[str, int]] = queue.SimpleQueue()
    for claim in caps.items():
        waiting.put(claim)
    answers: queue.SimpleQueue[Any] = queue.SimpleQueue()
    head = json.dumps({"settings": as_json(settings), "hash": settings_hash})
    workers = [start_worker() for _ in range(min(settings.threads, len(caps)))]
    threads = [
        threading.Thread(target=feed_worker, args=(worker, head, waiting, answers), daemon=True) for worker in workers
    ]
    try:
        for thread in threads:
            thread.start()
        running = len(workers)
        while running:
            answer = answers.get()
            running -= answer is DONE
            if isinstance(answer, Exception):
                raise answer
            if answer is not DONE:
                finished(answer["id"])
                yield ClaimResult(**answer)
    finally:
        for worker, thread in zip(workers, threads, strict=True):
            kill_worker(worker, thread)


def start_worker() -> subprocess.Popen[str]:
    """Start a worker process that examines claims."""
    command = [sys.executable, "-m", "soccer_env.train.papers.workers"]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def kill_worker(worker: subprocess.Popen[str], thread: threading.Thread) -> None:
    """Kill a worker, and join the thread that talks to it."""
    worker.kill()
    if thread.is_alive():
        thread.join()
    with worker:  # closes its pipes
        pass


def feed_worker(
    worker: subprocess.Popen[str], head: str, waiting: queue.SimpleQueue[tuple[str, int]],
    answers: queue.SimpleQueue[Any],
) -> None:  # fmt: skip
    """Send a worker one claim after another until none is left, and put its answers into the queue `answers`."""
    assert worker.stdin is not None and worker.stdout is not None
    claim = ""
    try:
        write_line(worker, head)
        while True:
            try:
                claim, cap = waiting.get_nowait()
            except queue.Empty:
                break
            write_line(worker, json.dumps([claim, cap]))
            answers.put(json.loads(worker.stdout.readline()))
    except (OSError, ValueError):
        answers.put(RuntimeError(f"the process that measured claim {claim} ended with code {worker.wait()}"))
    answers.put(DONE)


def write_line(worker: subprocess.Popen[str], line: str) -> None:
    """Write a line to the standard input of a worker."""
    assert worker.stdin is not None
    worker.stdin.write(line + "\n")
    worker.stdin.flush()


def as_json(settings: ReproduceSettings) -> dict[str, Any]:
    """Return the settings that decide the results of a run, as plain data for JSON; a worker has one core."""
    left_out = {"out", "anew", "threads"}
    return {name: value for name, value in asdict(settings).items() if name not in left_out}


def answer_requests(lines: Sequence[str] | Iterator[str], say: Any) -> None:
    """Examine the claims that the lines request, and print each result as a line of JSON to `say`."""
    claims = all_claims()
    rest = iter(lines)
    head = json.loads(next(rest, "{}"))
    if not head:  # the parent process was killed
        return
    settings = ReproduceSettings(**head["settings"])
    for line in rest:
        claim, cap = json.loads(line)
        result = examine(claims[claim], settings, cap, head["hash"])
        print(json.dumps(asdict(result)), file=say, flush=True)


def main() -> None:
    """Run a worker: answer the parent process's requests until there are no more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent ends this process
    answers, sys.stdout = sys.stdout, sys.stderr  # so that a claim's own output is not read as an answer
    try:
        answer_requests(sys.stdin, answers)
    except BrokenPipeError:  # the parent was killed: nobody waits for the answer
        os.dup2(os.open(os.devnull, os.O_WRONLY), answers.fileno())


if __name__ == "__main__":
    main()
