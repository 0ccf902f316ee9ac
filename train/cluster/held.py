"""An object on a worker of a cluster that outlives the worker.

The calls since its last known state are kept here. If the worker dies, the object is made on another one, and the calls
are repeated there with the same results, because results depend on the state and the arguments alone.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from soccer_env.train.cluster import unpacking

if TYPE_CHECKING:
    from soccer_env.train.cluster.tasks import Tasks

TRIES = 5  # of a call whose workers die


class Held:
    """An object on a node of a cluster; call its methods by `begin`, then `result`."""

    def __init__(self, tasks: Tasks, node: str, making: tuple[Any, ...]) -> None:
        self._tasks, self._node, self._making = tasks, node, making
        self._calls: list[tuple[Any, ...]] = []
        self._make()

    def begin(self, method: str, *arguments: Any) -> None:
        """Call a method, without waiting for its result."""
        self._calls.append((method, *arguments))
        self._answer = self._send(self._calls[-1])

    def result(self) -> Any:
        """Return the result of the last call; ConnectionError if the workers die again and again."""
        for _ in range(TRIES):
            try:
                return self._tasks.get(self._answer)
            except self._tasks.deaths as error:
                died = error
                self.close()
                self._make()
        raise ConnectionError(f"workers died {TRIES} times: {died}; the same command goes on from its checkpoint")

    def begin_from(self, method: str, *arguments: Any) -> None:
        """Repeat only this call, which restores the present state, and later ones if the worker dies."""
        self._calls = [(method, *arguments)]

    def close(self) -> None:
        """End the worker."""
        self._tasks.kill(self._actor)

    def _make(self) -> None:
        """Make the object, and repeat the calls."""
        self._actor = self._tasks.actor(unpacking.Holder, self._node)
        self._made = self._actor.make.remote(*self._making)
        for call in self._calls:
            self._answer = self._send(call)

    def _send(self, call: tuple[Any, ...]) -> Any:
        """Send a call, which an error of the making answers."""
        return self._actor.call.remote(self._made, *call)
