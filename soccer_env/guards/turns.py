"""Methods that one thread may be in at a time, and that happen whole or not at all."""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

T = TypeVar("T")
GoBack = Callable[[], None]


def in_turn(
    kind: type[T], names: Iterable[str], undone: Callable[[T], bool], note: Callable[[T, str], GoBack | None]
) -> type[T]:
    """Guard some methods of a class; RuntimeError if another thread is in one of them, which goes on undisturbed.

    undone(object), asked once, says whether methods that raise are undone: note(object, method's name), asked before
    each runs, returns what undoes it, or None. A method may call another, of the same thread: the outermost is undone.
    """
    for name in names:
        setattr(kind, name, _guarded(getattr(kind, name), name, undone, note))
    return kind


def _guarded(
    method: Callable[..., Any], name: str, undone: Callable[[Any], bool], note: Callable[[Any, str], GoBack | None]
) -> Callable[..., Any]:
    @functools.wraps(method)
    def guarded(self: Any, *args: Any, **kwargs: Any) -> Any:
        try:
            turn = self._turn
        except AttributeError:
            turn = self._turn = Turn(undone(self))
        if not turn.acquire(False):
            whose = type(self).__name__
            raise RuntimeError(f"{name}: another thread is using this {whose}; give each thread one of its own")
        try:
            if not turn.undoes:
                return method(self, *args, **kwargs)
            turn.undoes = False
            try:
                return _undone_on_error(method, note(self, name), self, *args, **kwargs)
            finally:
                turn.undoes = True
        finally:
            turn.release()

    return guarded


def _undone_on_error(method: Callable[..., Any], go_back: GoBack | None, *args: Any, **kwargs: Any) -> Any:
    try:
        return method(*args, **kwargs)
    except BaseException:
        if go_back is not None:
            go_back()
        raise


class Turn:
    """Whose turn it is with an object: a lock that its own thread may take again."""

    __slots__ = "acquire", "release", "undoes"

    def __init__(self, undoes: bool) -> None:
        lock = threading.RLock()
        self.acquire, self.release = lock.acquire, lock.release
        self.undoes = undoes  # what the next method does, if that raises
