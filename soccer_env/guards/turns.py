"""Guard methods: only one thread at a time runs them, and a method that fails leaves the object unchanged."""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable, Iterable
from threading import get_ident
from typing import Any, TypeVar, cast

from soccer_env.guards.interrupts import hold_signals, hold_signals_again, release_signals, resume_signals

T = TypeVar("T")
F = TypeVar("F", bound=Callable[..., Any])
GoBack = Callable[[], None]
MENDS = ("reset", "load")  # methods that repair an object which an error has left half changed


def guard_methods(
    kind: type[T], names: Iterable[str], undone: Callable[[T], bool], note: Callable[[T, str], GoBack | None]
) -> type[T]:
    """Guard some methods of a class; calling one while another thread is inside one raises RuntimeError.

    Signals wait until a method ends. In methods that may take long, signals are delivered at once, and a method that
    raises is undone. If undone(object) is true (asked once), all calls may take long, else the first call of each
    method, which may compile. note(object, name of the method) is called before, and returns a function that undoes
    the method, or None. A guarded method may call another in the same thread: the outermost is undone. After any other
    error `started` is False, and only the methods in MENDS may be called.
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
            turn = self._turn = ObjectLock(undone(self))
        if turn.owner == get_ident():
            return method(self, *args, **kwargs)
        began = hold_signals()
        try:
            if not turn.acquire(False):
                whose = type(self).__name__
                raise RuntimeError(f"{name}: another thread is using this {whose}; give each thread one of its own")
            try:
                turn.owner = get_ident()
                if not (self.started or name in MENDS):
                    raise RuntimeError(f"{name}: an error has cut short what was done before: call reset")
                if name in turn.sure:
                    return method(self, *args, **kwargs)
                result = _call_or_undo(method, note(self, name), self, *args, **kwargs)
                if not turn.undoes:
                    turn.sure.add(name)
                return result
            finally:
                turn.owner = 0
                turn.release()
        finally:
            if began:
                release_signals()

    return guarded


def _call_or_undo(method: Callable[..., Any], go_back: GoBack | None, *args: Any, **kwargs: Any) -> Any:
    """Call a method that signals may interrupt; on an error, undo the changes of the method."""
    try:
        resume_signals()
        result = method(*args, **kwargs)
        hold_signals()
    except BaseException:
        hold_signals_again()
        if go_back is not None:
            go_back()
        raise
    return result


def with_signals_held(method: F) -> F:
    """Return a method that holds back signals until its end, unless a function that it calls delivers them."""

    @functools.wraps(method)
    def waiting(*args: Any, **kwargs: Any) -> Any:
        began = hold_signals()
        try:
            return method(*args, **kwargs)
        finally:
            if began:
                release_signals()

    return cast(F, waiting)


class ObjectLock:
    """The lock of a guarded object, its present thread, and the methods that signals cannot interrupt."""

    __slots__ = "acquire", "owner", "release", "sure", "undoes"

    def __init__(self, undoes: bool) -> None:
        lock = threading.Lock()
        self.acquire, self.release = lock.acquire, lock.release
        self.owner = 0  # id of the thread that is in a method
        self.undoes = undoes
        self.sure: set[str] = set()

    def expect_code(self, undoes: bool) -> None:
        """Let the next call of each method compile; undoes: all calls may take long from now on."""
        self.undoes = undoes
        self.sure.clear()
