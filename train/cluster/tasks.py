"""Calls as tasks on a Ray cluster: a task that dies with its worker or its node runs again elsewhere.

Results do not depend on the cluster, because every call follows from its arguments alone; they come in order of the
calls. Code and arguments are sent by content, so a node needs no copy of either, only the libraries.
"""

from __future__ import annotations

import logging
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any, TypeVar

from soccer_env.train.cluster import unpacking
from soccer_env.train.cluster.held import Held
from soccer_env.train.cluster.packing import pack_code
from soccer_env.train.provenance import play_facts

T = TypeVar("T")
LOCAL, JOIN = "local", "auto"  # addresses: start a cluster on this machine; join the one that runs on it
TRIES = 5  # of a task whose worker or node dies
STORE = 256 << 20  # [bytes] of a local cluster's object store; results are small
MISSING = "a cluster needs Ray: pip install 'soccer_env[ray]'"


class Tasks:
    """Tasks on the Ray cluster at an address: "local", "auto" or HOST:PORT. Leaving the context cancels the rest.

    ValueError without Ray, and while this process belongs to another cluster; ConnectionError for no cluster there.
    """

    def __init__(self, address: str) -> None:
        self._ray = connect(address)
        self._digest, code = pack_code()
        self._code = self._ray.put(code)
        self._ray.cloudpickle.register_pickle_by_value(unpacking)
        self._task = self._ray.remote(unpacking.run_call)
        self._waiting = set[Any]()

    def __enter__(self) -> Tasks:
        return self

    def __exit__(self, *error: object) -> None:
        self.cancel()

    def cancel(self) -> None:
        """Cancel all tasks that have not ended; those who wait for their results get ConnectionError."""
        for task in list(self._waiting):
            self._ray.cancel(task, force=True)

    @property
    def cores(self) -> int:
        """Return the number of tasks that run at once."""
        return max(int(self._ray.cluster_resources().get("CPU", 1)), 1)

    def submit(self, function: Callable[..., T], calls: Sequence[tuple[Any, ...]], prepare: Any = None) -> Iterator[T]:
        """Submit a call of the function for each tuple of arguments; the iterator gives their results in order.

        `prepare`: (function, arguments) that each node calls once before, to compile. If the work is stopped (Ctrl-C)
        or a task is given up, the iterator first gives all finished results.
        """
        task = self._task.options(num_cpus=1, max_retries=TRIES, **self._environment)
        tasks = [task.remote(*call) for call in self._packed(function, calls, prepare)]
        self._waiting.update(tasks)
        return self._results(tasks)

    def side_by_side(self, work: Callable[[Any], T], items: Sequence[Any]) -> list[T]:
        """Call a function that submits tasks for all items at once, in threads; an error cancels the tasks of all."""
        with ThreadPoolExecutor(len(items)) as pool:
            jobs = [pool.submit(work, item) for item in items]
            try:
                return [job.result() for job in jobs]
            except BaseException:
                self.cancel()
                raise

    def hold(self, function: Callable[..., Any], calls: Sequence[tuple[Any, ...]], prepare: Any) -> list[Held]:
        """Hold what the function returns for each tuple of arguments on a worker of its own, a core for each.

        The workers leave their cores to tasks, so that tasks play while nobody calls what they hold.
        """
        alive = [(node["NodeID"], int(node["Resources"].get("CPU", 0))) for node in self._ray.nodes() if node["Alive"]]
        nodes = [node for node, cores in alive for _ in range(cores)] or [alive[0][0]]
        packed = self._packed(function, calls, prepare)
        return [Held(self, nodes[index % len(nodes)], making) for index, making in enumerate(packed)]

    def actor(self, kind: type, node: str) -> Any:
        """Start an actor on a node, or elsewhere if that has died."""
        from ray.util.scheduling_strategies import NodeAffinitySchedulingStrategy

        there = NodeAffinitySchedulingStrategy(node, soft=True)
        return self._ray.remote(kind).options(num_cpus=0, scheduling_strategy=there, **self._environment).remote()

    def kill(self, actor: Any) -> None:
        """End an actor."""
        self._ray.kill(actor)

    def get(self, answer: Any) -> Any:
        """Return the result of a task or call; raise the error that its function raised, or one of `deaths`."""
        try:
            return self._ray.get(answer)
        except self._ray.exceptions.RayTaskError as error:
            raise (error.cause or RuntimeError(str(error))) from error

    @property
    def deaths(self) -> type[Exception]:
        """Return the kind of error that tells the death of a worker."""
        kind: type[Exception] = self._ray.exceptions.RayError
        return kind

    def _packed(self, function: Any, calls: Sequence[tuple[Any, ...]], prepare: Any) -> list[tuple[Any, ...]]:
        """Return for each call the arguments of `unpacking.run_call`."""
        first, facts = b"" if prepare is None else self._ray.cloudpickle.dumps(prepare), play_facts()
        pickled = [self._ray.cloudpickle.dumps((function, call)) for call in calls]
        return [(self._code, self._digest, facts, first, call) for call in pickled]

    @property
    def _environment(self) -> dict[str, Any]:
        """Return the environment of the workers, which no other code shares."""
        return {"runtime_env": {"env_vars": {"SOCCER_ENV_CODE": self._digest, "SOCCER_ENV_QUIET": "1"}}}

    def _results(self, tasks: list[Any]) -> Iterator[Any]:
        """Yield the results of tasks in order."""
        waiting, finished = list(tasks), dict[Any, Any]()
        try:
            for task in tasks:
                while task not in finished:
                    ready, waiting = self._ray.wait(waiting)
                    finished.update((one, self._result(one)) for one in ready)
                yield finished.pop(task)
        except (KeyboardInterrupt, ConnectionError):
            yield from finished.values()
            raise

    def _result(self, task: Any) -> Any:
        """Return the result of a finished task; raise the error that its function raised."""
        self._waiting.discard(task)
        try:
            return self.get(task)
        except self.deaths as error:
            tried = f"a task was given up after {TRIES + 1} tries: {error}"
            raise ConnectionError(f"{tried}; finished results are kept, and the same command goes on") from error


Workers = int | Tasks  # threads of this process, or tasks on a cluster


@contextmanager
def open_workers(threads: int, address: str | None) -> Iterator[Workers]:
    """Give the number of threads, or tasks on the cluster at an address."""
    if address is None:
        yield threads
        return
    with Tasks(address) as tasks:
        yield tasks


def connect(address: str) -> Any:
    """Join a cluster, or start one on this machine ("local"), unless this process has joined one; return `ray`."""
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    os.environ.setdefault("RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO", "0")  # a warning that concerns GPUs
    try:
        import ray
    except ImportError as error:
        raise ValueError(f"{MISSING} ({error})") from error
    if ray.is_initialized():
        joined = ray.get_runtime_context().gcs_address
        if address not in (LOCAL, JOIN, joined):
            raise ValueError(f"this process belongs to the cluster at {joined}, not to {address}")
        return ray
    local: dict[str, Any] = {"include_dashboard": False, "object_store_memory": STORE} if address == LOCAL else {}
    ray.init(address=address, log_to_driver=False, logging_level=logging.ERROR, **local)
    return ray
