"""Processes, or tasks on a cluster, that share the claims of a run: each measures one claim after another, on one core.

    python -m soccer_env.train.papers.workers     the program of a worker, which reads requests line by line

A request is a line of JSON: the settings of the run, the hash of them, and the id and cap of a claim to examine. The
answer is one line, the result. No result depends on the process that measured it.
"""

import json
import os
import queue
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import asdict
from typing import Any

from soccer_env.match import Match
from soccer_env.train.cluster import Tasks
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.examination import examine
from soccer_env.train.papers.results import ClaimResult
from soccer_env.train.papers.settings import ReproduceSettings

COMMAND = (sys.executable, "-m", "soccer_env.train.papers.workers")
Workers = queue.SimpleQueue[subprocess.Popen[str]]  # that wait for a request


def examine_in_processes(
    caps: Mapping[str, int], settings: ReproduceSettings, settings_hash: str,
    finished: Callable[[str], None] = lambda claim: None,
) -> Iterator[ClaimResult]:  # fmt: skip
    """Yield results as they come, from settings.threads processes; `caps`: the cap of each claim, in the order of work.

    `finished` is called with each id. Raises RuntimeError if a process fails; its own message is on the screen.
    """
    run, pipe = {"settings": as_json(settings), "hash": settings_hash}, subprocess.PIPE
    count = min(settings.threads, len(caps))
    workers = [subprocess.Popen(COMMAND, stdin=pipe, stdout=pipe, text=True) for _ in range(count)]
    waiting, pool = Workers(), ThreadPoolExecutor(count)
    for worker in workers:
        waiting.put(worker)
    try:
        requests = [{**run, "claim": claim, "cap": cap} for claim, cap in caps.items()]
        for answer in as_completed([pool.submit(ask_worker, waiting, request) for request in requests]):
            result = answer.result()
            finished(result.id)
            yield result
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for worker in workers:
            worker.kill()
        pool.shutdown()
        for worker in workers:
            with worker:  # closes its pipes
                pass


def examine_in_tasks(
    tasks: Tasks, caps: Mapping[str, int], settings: ReproduceSettings, settings_hash: str,
    finished: Callable[[str], None],
) -> Iterator[ClaimResult]:  # fmt: skip
    """Yield results in the order of `caps`, as `examine_in_processes` does, but from tasks on a cluster."""
    calls = [(as_json(settings), settings_hash, claim, cap) for claim, cap in caps.items()]
    for result in tasks.submit(examine_by_id, calls, prepare=(compile_matches, ())):
        finished(result.id)
        yield result


def compile_matches() -> None:
    """Play one step of a match of each league, which compiles most of what claims need."""
    for league, team in (("legged-2001", "sacks-2001"), ("middle-size-2006", "heinemann-2006")):
        Match(league, home=2, away=2, seed=0, controllers={"home": team, "away": "chaser"}).step(None)


def examine_by_id(settings: dict[str, Any], settings_hash: str, claim: str, cap: int) -> ClaimResult:
    """Examine a claim of the package; `settings`: those of the run, as plain data."""
    return examine(all_claims()[claim], ReproduceSettings(**settings), cap, settings_hash)


def ask_worker(waiting: Workers, request: dict[str, Any]) -> ClaimResult:
    """Send a request to a worker that waits, and return the result; RuntimeError if the process has ended."""
    worker = waiting.get()
    assert worker.stdin is not None and worker.stdout is not None
    try:
        worker.stdin.write(json.dumps(request) + "\n")
        worker.stdin.flush()
        return ClaimResult(**json.loads(worker.stdout.readline()))
    except (OSError, ValueError) as error:
        ended = f"the process that measured claim {request['claim']} ended with code {worker.wait()}"
        raise RuntimeError(ended) from error
    finally:
        waiting.put(worker)


def as_json(settings: ReproduceSettings) -> dict[str, Any]:
    """Return the settings that decide the results of a run, as plain data for JSON; a worker has one core."""
    left_out = {"out", "anew", "threads", "ray"}
    return {name: value for name, value in asdict(settings).items() if name not in left_out}


def answer_requests(lines: Sequence[str] | Iterator[str], say: Any) -> None:
    """Examine the claims that the lines request, and print each result as a line of JSON to `say`."""
    for request in map(json.loads, lines):
        result = examine_by_id(request["settings"], request["hash"], request["claim"], request["cap"])
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
