"""Keep machine code on disk: one file for each compiled version of a function, named by all that it depends on.

It stands in for numba's cache, from which it differs in two ways. The key holds a hash of every file that the
function's file imports, so that nothing stale runs and an edit recompiles only what it could have changed. And there
is no index file: two processes that write numba's at once can leave one version's code under another's key. Here a
file is written aside, moved into place, and holds its full key, which is compared when it is read.

What lies in it is executed. So each file begins with a hash of the rest, as flipped bits would end the process, and a
folder that anybody may write to is not used; its owner's group is trusted.
"""

import contextlib
import functools
import hashlib
import os
import pickle
import stat
import sys
import tempfile
import time
import uuid
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import llvmlite
import numba
import numpy as np

from soccer_env.compiling.inner import INNER, InnerTarget, for_another, is_inner
from soccer_env.compiling.numba_parts import Cache as Base
from soccer_env.compiling.numba_parts import CachedResult as BaseResult
from soccer_env.compiling.numba_parts import Dispatcher, dumps
from soccer_env.compiling.sources import PACKAGE, source_stamp
from soccer_env.compiling.stops import stop_here

DIGEST = hashlib.sha256().digest_size  # [bytes]
STALE_AFTER = 30 * 24 * 3600.0  # [s] assumed; code of other versions is deleted at this age
EVERY = 20.0  # [s] between two lines that say how far compiling is, at least
VERSIONS = (numba.__version__, llvmlite.__version__, np.__version__, sys.implementation.cache_tag)
SETTINGS = ("OPT", "BOUNDSCHECK", "DEBUGINFO_DEFAULT")  # of numba.config, those that change the code

config: Any = numba.config


def is_kept(function: Any) -> bool:
    """Tell whether a compiled function, as its sources are now, is on disk for any types of arguments.

    True as well where it cannot be kept, as a source file has changed since this process read it.
    """
    identity = _identity(function.py_func)
    pattern = "" if identity is None else f"{function._cache.name}.{identity[0][:16]}.*"
    return not pattern or any(next(folder.glob(pattern), None) for folder in folders() if _is_private(folder))


class _Result(BaseResult):  # type: ignore[misc]
    """Turn compile results into picklable objects and back, as numba does it, without a search for a cache folder."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self._lineno = function.__code__.co_firstlineno
        self._locator = SimpleNamespace(_py_file=function.__code__.co_filename)  # where warnings point

    def rebuild(self, target_context: Any, payload: Any) -> Any:
        """Return the compile result of what was kept."""
        if payload[0][1] != INNER:
            return super().rebuild(target_context, payload)
        return super().rebuild(InnerTarget(target_context), payload)._replace(target_context=target_context)


class SourceCache(Base):  # type: ignore[misc]
    """The cache of one function; its methods are those that numba's Dispatcher calls."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self._function = function
        self._result = _Result(function)
        self._enabled = True
        code = function.__code__
        name = f"{Path(code.co_filename).stem}.{function.__qualname__.replace('<', '').replace('>', '')}"
        self.name = f"{name[:100]}-{code.co_firstlineno}.{sys.implementation.cache_tag}"

    @property
    def cache_path(self) -> str:
        """The first folder."""
        return str(folders()[0])

    def enable(self) -> None:
        """Read and write files from now on."""
        self._enabled = True

    def disable(self) -> None:
        """Leave the files alone from now on."""
        self._enabled = False

    def flush(self) -> None:
        """Delete all versions of this function."""
        for folder in folders():
            _delete(folder.glob(f"{self.name}.*"))

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the compile result for these argument types, or None if there is none yet."""
        stop_here()
        target_context.refresh()
        for inner in (True, False) if for_another() else (False,):
            stamp, key = self._key(sig, target_context.codegen(), inner)
            if key is None:
                return None
            for folder in filter(_is_private, folders()):
                payload = _load(folder / self._file_name(stamp, key), key)
                if payload is not None:
                    return self._result.rebuild(target_context, payload)
        _announce()
        return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep a compile result, unless a source file has changed since this process read it."""
        _count()
        stamp, key = self._key(sig, data.codegen, is_inner(data))
        if key is None or not self._result.check_cachable(data):
            return
        content = dumps((key, self._result.reduce(data)))
        for folder in folders():
            with contextlib.suppress(OSError):
                folder.parent.mkdir(parents=True, exist_ok=True)
                folder.mkdir(mode=0o700, exist_ok=True)
                if _is_private(folder):
                    _delete(self._outdated(folder, stamp))
                    _write(folder / self._file_name(stamp, key), content)
                    return

    def _key(self, sig: Any, codegen: Any, inner: bool) -> tuple[str, Any]:
        """Return the source hash and the full key, which is None where there is nothing to tell versions apart by."""
        if not self._enabled or " at 0x" in str(sig):  # a function as an argument is another one in each process
            return "", None
        identity = _identity(self._function)
        if identity is None:
            return "", None
        settings = str([getattr(config, name) for name in SETTINGS])
        return identity[0], (identity, sig, codegen.magic_tuple(), VERSIONS, settings, inner)

    def _file_name(self, stamp: str, key: Any) -> str:
        return f"{self.name}.{stamp[:16]}.{_sha(str(key).encode())[:16]}.nbc"

    def _outdated(self, folder: Path, stamp: str) -> Iterator[Path]:
        for file in folder.glob(f"{self.name}.*"):
            if stamp[:16] not in file.name and time.time() - file.stat().st_mtime > STALE_AFTER:
                yield file


def _identity(function: Callable[..., Any], outer: tuple[Any, ...] = ()) -> tuple[str, ...] | None:
    """Return hashes of the sources, the byte code and the closure of a function, or None if one is not known."""
    stamp = source_stamp(function.__module__, Path(function.__code__.co_filename).resolve())
    cells = tuple(_cell_identity(cell.cell_contents, (*outer, function)) for cell in function.__closure__ or ())
    if stamp is None or None in cells:
        return None
    return stamp, function.__qualname__, _code_identity(function.__code__), _sha(str(cells).encode())


def _code_identity(code: Any) -> str:
    """Return a hash of what a code object does: byte code, constants and names, those of inner functions included."""
    constants = [_code_identity(one) if hasattr(one, "co_code") else repr(one) for one in code.co_consts]
    return _sha(repr((code.co_code, constants, code.co_names, code.co_varnames)).encode())


def _cell_identity(value: Any, outer: tuple[Any, ...]) -> Any:
    if isinstance(value, Dispatcher):  # its pickle differs from process to process
        if value.py_func in outer:
            return outer.index(value.py_func)
        return _identity(value.py_func, outer)
    if isinstance(value, tuple):
        parts = tuple(_cell_identity(part, outer) for part in value)
        return None if None in parts else parts
    return _sha(dumps(value))


def _sha(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


@functools.cache
def folders() -> tuple[Path, ...]:
    """Return the folders of the cache: all are read, and the first that can be written to is written to."""
    chosen = os.environ.get("SOCCER_ENV_CACHE")
    return (Path(chosen) if chosen else _user_folder(), *_temporary_folder())


def _user_folder() -> Path:
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or os.path.expanduser("~\\AppData\\Local"), PACKAGE, "Cache")
    if sys.platform == "darwin":
        return Path(os.path.expanduser("~/Library/Caches"), PACKAGE)
    return Path(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"), PACKAGE)


def _temporary_folder() -> Iterator[Path]:
    """Yield the folder in the temporary one, unless somebody has put a link in its place."""
    path = Path(tempfile.gettempdir()) / f"{PACKAGE}-{os.getuid() if hasattr(os, 'getuid') else 0}"
    if not path.is_symlink():
        yield path


def _is_private(folder: Path) -> bool:
    """Tell whether a folder is there that is the user's or the system's, and that not everybody can write to."""
    try:
        status = folder.stat()
    except OSError:
        return False
    if os.name == "nt":
        return True
    if status.st_uid in (os.getuid(), 0) and not status.st_mode & 0o002 and _cannot_be_swapped(folder):
        return True
    _warn(folder)
    return False


@functools.cache
def _cannot_be_swapped(folder: Path) -> bool:
    """Tell whether not anybody can put another folder in its place: where all may write, names are their owners'."""
    for above in {*folder.absolute().parents, *folder.resolve().parents}:
        status = above.stat()
        kept = status.st_mode & stat.S_ISVTX and status.st_uid in (os.getuid(), 0)
        if status.st_mode & 0o002 and not kept:
            return False
    return True


@functools.cache
def _warn(folder: Path) -> None:
    """Say once that a folder is not used."""
    if os.environ.get("SOCCER_ENV_QUIET", "0") in ("", "0"):
        why = "it is another user's, or anybody can write to it or above it, and compiled code in it would be executed"
        print(f"{PACKAGE}: the cache {folder} is not used: {why}", file=sys.stderr, flush=True)


def _load(path: Path, key: Any) -> Any:
    try:
        content = path.read_bytes()
        if hashlib.sha256(content[DIGEST:]).digest() != content[:DIGEST]:
            return None
        stored_key, payload = pickle.loads(content[DIGEST:])
    except Exception:  # missing, unreadable or of another kind: it is compiled again and overwritten
        return None
    return payload if stored_key == key else None


def _write(path: Path, content: bytes) -> None:
    """Write a file that other processes see whole or not at all."""
    aside = path.with_name(f"{path.name}.{uuid.uuid4().hex}")
    try:
        aside.write_bytes(hashlib.sha256(content).digest() + content)
        os.replace(aside, path)
    except OSError:
        _delete([aside])
        raise


def _delete(files: Iterable[Path]) -> None:
    with contextlib.suppress(OSError):
        for file in files:
            file.unlink(missing_ok=True)


@functools.cache
def _announce() -> None:
    """Say once per process that compiling takes a while."""
    if os.environ.get("SOCCER_ENV_QUIET", "0") not in ("", "0"):
        return
    filled = any(folder.is_dir() and any(folder.iterdir()) for folder in folders())
    what = "what is new" if filled else "kernels (once, about a minute)"
    COMPILED.said = COMPILED.began = time.monotonic()
    print(f"{PACKAGE}: compiling {what} ...", file=sys.stderr, flush=True)


class Compiled:
    """What this process has compiled so far."""

    functions = 0  # versions of functions, found on disk ones not among them
    began = said = float("inf")  # [s] when compiling was announced, and when a line last said how far it is


COMPILED = Compiled()


def _count() -> None:
    """Count a function that was compiled, and say now and then how many they are."""
    COMPILED.functions += 1
    now = time.monotonic()
    if now - COMPILED.said >= EVERY:
        COMPILED.said = now
        words = f"{COMPILED.functions} functions in {now - COMPILED.began:.0f} s"
        print(f"{PACKAGE}: compiling ... {words}", file=sys.stderr, flush=True)
