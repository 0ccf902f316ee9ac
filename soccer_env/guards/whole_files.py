"""Write files and folders completely or not at all, and read untrusted files up to a size limit."""

import os
import shutil
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from secrets import token_hex

from soccer_env.guards.interrupts import SignalsHeld


def write_atomically(path: Path, content: str | bytes) -> None:
    """Write a file atomically: readers see the old or the new content, even after a power failure; OSError names it."""
    data = content.encode() if isinstance(content, str) else content
    with atomic_file(path) as aside, aside.open("xb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    _sync_folder(path.parent)


@contextmanager
def atomic_file(path: Path, ending: str = ".tmp") -> Iterator[Path]:
    """Yield a temporary path; at the end of the `with` the file replaces `path`, after an error it is removed.

    The name is random: nobody can place a link there, and each thread has its own file.
    """
    aside = path.with_name(f".{path.name}.{token_hex(8)}{ending}")
    try:
        yield aside
        os.replace(aside, path)
    except OSError as error:
        if error.errno is None or error.filename not in (None, str(aside)):
            raise
        raise OSError(error.errno, os.strerror(error.errno), str(path)) from error
    finally:
        aside.unlink(missing_ok=True)


@contextmanager
def atomic_folder(folder: Path) -> Iterator[Path]:
    """Yield a new folder, which replaces `folder` at the end of the `with`; an error removes the new folder.

    A killed process leaves the old folder or the new folder, or neither if it is killed between two renames.
    """
    aside, old = (folder.with_name(f".{folder.name}.{token_hex(8)}.{end}") for end in ("tmp", "old"))
    aside.mkdir(parents=True)
    try:
        yield aside
        with SignalsHeld():
            if folder.exists():
                os.rename(folder, old)
            try:
                os.rename(aside, folder)
            except OSError:
                if old.exists():
                    os.rename(old, folder)
                raise
    finally:
        shutil.rmtree(aside, ignore_errors=True)
        shutil.rmtree(old, ignore_errors=True)


def _sync_folder(folder: Path) -> None:
    """Flush a rename in a folder to the disk; do nothing on Windows, which cannot open folders."""
    if os.name != "posix":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def read_regular_file(path: str | os.PathLike[str], limit: int) -> bytes:
    """Return the content of a regular file of at most `limit` bytes; otherwise raise ValueError or OSError.

    Folders, pipes, sockets and devices are refused before and after opening, in case the path changed in between.
    """
    path = os.fspath(path)  # refuses numbers, which `open` takes for open files
    check_regular_file(os.stat(path), limit)
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)
    with open(os.open(path, flags), "rb") as file:
        check_regular_file(os.fstat(file.fileno()), limit)
        data = file.read(limit + 1)
    if len(data) > limit:  # the file grew, or lies in /proc
        raise ValueError(f"has more than {limit} bytes")
    return data


def check_regular_file(status: os.stat_result, limit: int) -> None:
    """Raise ValueError unless a file is regular and has at most `limit` bytes."""
    if stat.S_ISDIR(status.st_mode):
        raise ValueError("is a folder, not a file")
    if not stat.S_ISREG(status.st_mode):
        raise ValueError("is not a regular file")
    if status.st_size > limit:
        raise ValueError(f"has {status.st_size} bytes, more than the limit of {limit}")
