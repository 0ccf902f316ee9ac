"""Keep machine code on disk: one file for each compiled version of a function, named by a hash of its dependencies.

This cache replaces numba's, with two differences. The key holds a hash of every file that the function's file imports,
so that stale code never runs and an edit recompiles only dependent functions. And there is no index file: two
processes that write numba's index at once can store code under a wrong key. Here a file is written aside, moved into
place, and holds its full key, which is compared on reading.

Code from the cache is executed. So each file begins with a hash of the rest, since flipped bits would end the process,
and a folder that everybody may write to is not used; the owner's group is trusted.
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

from soccer_env.compiling.announcing import COMPILED, announce
from soccer_env.compiling.inner import INNER, InnerTarget, is_inner, is_inner_compile
from soccer_env.compiling.numba_parts import Cache as Base
from soccer_env.compiling.numba_parts import CachedResult as BaseResult
from soccer_env.compiling.numba_parts import Dispatcher, dumps
from soccer_env.compiling.sources import PACKAGE, source_stamp
from soccer_env.compiling.stops import stop_here

DIGEST = hashlib.sha256().digest_size  # [bytes]
STALE_AFTER = 30 * 24 * 3600.0  # [s] assumed; code of older sources is deleted at this age
VERSIONS = (numba.__version__, llvmlite.__version__, np.__version__, sys.implementation.cache_tag)
SETTINGS = ("OPT", "BOUNDSCHECK", "DEBUGINFO_DEFAULT")  # settings of numba.config that change the code

config: Any = numba.config


def is_cached(function: Any) -> bool:
    """Tell whether a compiled version of a function's present source is on disk, for any types of arguments.

    Also True if the function cannot be stored, because a source file has changed since this process read it.
    """
    identity = _function_hashes(function.py_func)
    pattern = "" if identity is None else f"{function._cache.name}.{identity[0][:16]}.*"
    return not pattern or any(next(folder.glob(pattern), None) for folder in cache_folders() if _is_private(folder))


class _ResultFormat(BaseResult):  # type: ignore[misc]
    """The conversion of compile results to picklable objects and back, as in numba, without a cache folder."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self._lineno = function.__code__.co_firstlineno
        self._locator = SimpleNamespace(_py_file=function.__code__.co_filename)  # where warnings point

    def rebuild(self, target_context: Any, payload: Any) -> Any:
        """Return the compile result from a stored payload."""
        if payload[0][1] != INNER:
            return super().rebuild(target_context, payload)
        return super().rebuild(InnerTarget(target_context), payload)._replace(target_context=target_context)


class SourceCache(Base):  # type: ignore[misc]
    """The disk cache of one compiled function, with the methods that numba's Dispatcher calls."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self._function = function
        self._result = _ResultFormat(function)
        self._enabled = True
        code = function.__code__
        name = f"{Path(code.co_filename).stem}.{function.__qualname__.replace('<', '').replace('>', '')}"
        self.name = f"{name[:100]}-{code.co_firstlineno}.{sys.implementation.cache_tag}"

    @property
    def cache_path(self) -> str:
        """Return the cache's first folder."""
        return str(cache_folders()[0])

    def enable(self) -> None:
        """Use the cache on disk from now on."""
        self._enabled = True

    def disable(self) -> None:
        """Ignore the cache on disk from now on."""
        self._enabled = False

    def flush(self) -> None:
        """Delete the cached files of all compiled versions of this function."""
        for folder in cache_folders():
            _delete(folder.glob(f"{self.name}.*"))

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the stored compile result for these argument types, or None."""
        stop_here()
        target_context.refresh()
        for inner in (True, False) if is_inner_compile() else (False,):
            stamp, key = self._key(sig, target_context.codegen(), inner)
            if key is None:
                return None
            for folder in filter(_is_private, cache_folders()):
                payload = _load(folder / self._file_name(stamp, key), key)
                if payload is not None:
                    return self._result.rebuild(target_context, payload)
        announce(cache_folders())
        COMPILED.expect(self._function)
        return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Store a compile result, unless a source file has changed since this process read it."""
        COMPILED.count()
        stamp, key = self._key(sig, data.codegen, is_inner(data))
        if key is None or not self._result.check_cachable(data):
            return
        content = dumps((key, self._result.reduce(data)))
        for folder in cache_folders():
            with contextlib.suppress(OSError):
                folder.parent.mkdir(parents=True, exist_ok=True)
                folder.mkdir(mode=0o700, exist_ok=True)
                if _is_private(folder):
                    _delete(self._outdated(folder, stamp))
                    _write(folder / self._file_name(stamp, key), content)
                    return

    def _key(self, sig: Any, codegen: Any, inner: bool) -> tuple[str, Any]:
        """Return the source hash and the full cache key; a key of None means that the result must not be stored."""
        if not self._enabled or " at 0x" in str(sig):  # a function as an argument: its address changes
            return "", None
        identity = _function_hashes(self._function)
        if identity is None:
            return "", None
        settings = str([getattr(config, name) for name in SETTINGS])
        return identity[0], (identity, sig, codegen.magic_tuple(), VERSIONS, settings, inner)

    def _file_name(self, stamp: str, key: Any) -> str:
        return f"{self.name}.{stamp[:16]}.{_sha(str(key).encode())[:16]}.nbc"

    def _outdated(self, folder: Path, stamp: str) -> Iterator[Path]:
        for name in _older_files(folder).get(self.name, ()):
            if stamp[:16] not in name and time.time() - (folder / name).stat().st_mtime > STALE_AFTER:
                yield folder / name


@functools.cache
def _older_files(folder: Path) -> dict[str, list[str]]:
    """Return {name of a function: its files} of a folder, as it is when this process first stores code."""
    files: dict[str, list[str]] = {}
    for name in os.listdir(folder):
        files.setdefault(name.rsplit(".", 3)[0], []).append(name)
    return files


def _function_hashes(function: Callable[..., Any], outer: tuple[Any, ...] = ()) -> tuple[str, ...] | None:
    """Return the hashes of a function's sources, byte code and closure; None if one of them cannot be computed."""
    stamp = source_stamp(function.__module__, Path(function.__code__.co_filename).resolve())
    cells = tuple(_cell_hash(cell.cell_contents, (*outer, function)) for cell in function.__closure__ or ())
    if stamp is None or None in cells:
        return None
    return stamp, function.__qualname__, _code_hash(function.__code__), _sha(str(cells).encode())


def _code_hash(code: Any) -> str:
    """Return a hash of byte code, constants and names of a code object and its inner functions."""
    constants = [_code_hash(one) if hasattr(one, "co_code") else repr(one) for one in code.co_consts]
    return _sha(repr((code.co_code, constants, code.co_names, code.co_varnames)).encode())


def _cell_hash(value: Any, outer: tuple[Any, ...]) -> Any:
    if isinstance(value, Dispatcher):  # its pickle differs from process to process
        if value.py_func in outer:
            return outer.index(value.py_func)
        return _function_hashes(value.py_func, outer)
    if isinstance(value, tuple):
        parts = tuple(_cell_hash(part, outer) for part in value)
        return None if None in parts else parts
    return _sha(dumps(value))


def _sha(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


@functools.cache
def cache_folders() -> tuple[Path, ...]:
    """Return the cache's folders: all are searched, and the first writable folder gets new files."""
    chosen = os.environ.get("SOCCER_ENV_CACHE")
    return (Path(chosen) if chosen else _user_folder(), *_temporary_folder())


def _user_folder() -> Path:
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or os.path.expanduser("~\\AppData\\Local"), PACKAGE, "Cache")
    if sys.platform == "darwin":
        return Path(os.path.expanduser("~/Library/Caches"), PACKAGE)
    return Path(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"), PACKAGE)


def _temporary_folder() -> Iterator[Path]:
    """Yield a folder inside the system's temporary folder, unless the name is already taken by a link."""
    path = Path(tempfile.gettempdir()) / f"{PACKAGE}-{os.getuid() if hasattr(os, 'getuid') else 0}"
    if not path.is_symlink():
        yield path


def _is_private(folder: Path) -> bool:
    """Tell whether a folder exists, belongs to the user or the system, and is not writable by everybody."""
    try:
        status = folder.stat()
    except OSError:
        return False
    if os.name == "nt":
        return True
    if status.st_uid in (os.getuid(), 0) and not status.st_mode & 0o002 and _is_safe_from_swaps(folder):
        return True
    _warn_of_unused_folder(folder)
    return False


@functools.cache
def _is_safe_from_swaps(folder: Path) -> bool:
    """Tell whether other users cannot replace the folder: parents writable by everybody must be sticky."""
    for above in {*folder.absolute().parents, *folder.resolve().parents}:
        status = above.stat()
        kept = status.st_mode & stat.S_ISVTX and status.st_uid in (os.getuid(), 0)
        if status.st_mode & 0o002 and not kept:
            return False
    return True


@functools.cache
def _warn_of_unused_folder(folder: Path) -> None:
    """Print once that a folder is not used as a cache, and the reason."""
    if os.environ.get("SOCCER_ENV_QUIET", "0") in ("", "0"):
        why = "it is another user's, or anybody can write to it or above it, and compiled code in it would be executed"
        print(f"{PACKAGE}: the cache {folder} is not used: {why}", file=sys.stderr, flush=True)


def _load(path: Path, key: Any) -> Any:
    try:
        content = path.read_bytes()
        if hashlib.sha256(content[DIGEST:]).digest() != content[:DIGEST]:
            return None
        stored_key, payload = pickle.loads(content[DIGEST:])
    except Exception:  # missing, unreadable or foreign: the function is compiled again and the file overwritten
        return None
    return payload if stored_key == key else None


def _write(path: Path, content: bytes) -> None:
    """Write a file atomically: other processes see either the whole file or none."""
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
