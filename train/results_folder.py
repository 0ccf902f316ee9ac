"""The folder of a run's results: its kind and settings, its finished parts, and files written whole.

    settings.json    conditions: settings that decide the results; made_with: versions and hashes; about: the rest
    NAME.jsonl       a line for each finished part, on disk before the next one begins (`files.py`)
    other files      written whole or not at all

A stopped run resumes in its folder, and some kinds of runs can be made larger. Other settings are refused, with each
difference named, and so is a folder with other contents: only files of a run of this kind are ever removed (`anew`) or
overwritten.
"""

import json
import shutil
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any, TypeVar, get_origin, get_type_hints

from soccer_env.guards.checking import short_repr
from soccer_env.guards.whole_files import read_regular_file, write_atomically
from soccer_env.train.files import LARGEST, append_lines, read_lines
from soccer_env.train.provenance import settings_hash

T = TypeVar("T")
Self = TypeVar("Self", bound="ResultsFolder")
SETTINGS, LOCK = "settings.json", ".lock"
GROWN = "grown_from"  # in `about`: the earlier sizes of a run that has grown
NAMED = {int: "a whole number", str: "a text", dict: "a table"}  # kinds of fields
ELSE = "give another folder, or --anew (anew=True)"  # advice for a folder with another run
PARTS = ("conditions", "made_with", "about")  # of settings.json


@dataclass(frozen=True)
class RunKind:
    """The files of one kind of run in its folder."""

    what: str  # in messages: "an evaluation"
    marks: tuple[str, ...]  # conditions that all runs of this kind have, and no other kind
    files: tuple[str, ...]  # beside settings.json, the lines of finished parts first
    more: Callable[[dict[str, Any]], list[str]] = lambda conditions: []  # patterns of further ones, by its conditions
    grows: tuple[str, ...] = ()  # conditions, numbers or lists, that may be larger when a run is resumed: its parts
    # follow from their seeds alone
    alone: bool = False  # one process at a time; else two may share the work, as each part follows from its seed alone


class ResultsFolder:
    """The results of a run in the folder `path`; without a path nothing is read or written.

    ValueError if it holds something else, a run with other settings, or is in use. `anew` removes an earlier run first.
    `defaults`: values for conditions that older runs lack. `about`: the entry of that name in settings.json.
    """

    def __init__(
        self, path: Path | None, kind: RunKind, conditions: Mapping[str, Any], made_with: dict[str, str],
        about: dict[str, Any], anew: bool = False, defaults: Mapping[str, Any] | None = None,
    ) -> None:  # fmt: skip
        mine = json.loads(json.dumps({"conditions": dict(conditions), "made_with": made_with, "about": about}))
        self.path, self.kind = path, kind
        self.made_with, self.about = made_with, about
        self.settings = settings_hash(mine["conditions"], made_with)  # every line of a result carries it
        self._earlier = set[str]()  # hashes of this run when it was smaller
        self._lock: Any = None
        if path is None:
            return
        if path == Path():
            raise ValueError("out must be a folder of the run's own, not the current one")
        if path.exists() and not path.is_dir():
            raise ValueError(f"out: {path} is a file; give a folder")
        path.mkdir(parents=True, exist_ok=True)
        try:
            if kind.alone:
                self._lock = lock(path / LOCK)
            self._open(path, mine, anew, defaults or {})
        except BaseException:
            self.close()
            raise

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Release the lock of the folder."""
        if self._lock is not None:
            self._lock.release()

    def _open(self, path: Path, mine: dict[str, Any], anew: bool, defaults: Mapping[str, Any]) -> None:
        """Read the folder; begin a run in it or resume it."""
        before = settings_before(path, self.kind, anew)
        if self.kind.alone:  # others might be writing just now
            for name in (SETTINGS, *self.kind.files):
                for torn in path.glob(f".{name}.*.tmp"):  # half written when a run was killed
                    torn.unlink(missing_ok=True)
        if anew:
            remove_run(path, self.kind, before)
        elif before is not None:
            before = {**before, "conditions": {**defaults, **before["conditions"]}}
            sizes = self._accept_smaller_run(before, mine)
            check_same(path, self.kind.what, before, mine)
            sizes += [size for size in before["about"].get(GROWN) or () if isinstance(size, int)]
            asked = mine["conditions"]
            self._earlier = {settings_hash({**asked, self.kind.grows[0]: size}, self.made_with) for size in sizes}
            if GROWN not in mine["about"]:
                self.about = before["about"]
                return
            mine["about"][GROWN] = sizes
            self.about = mine["about"]
        write_atomically(path / SETTINGS, json.dumps(mine, indent=2) + "\n")

    def _accept_smaller_run(self, before: dict[str, Any], mine: dict[str, Any]) -> list[Any]:
        """Accept a folder whose run is smaller, if runs of this kind may grow: return [its sizes], else []."""
        sizes = []
        for name in self.kind.grows:
            was, now = before["conditions"].get(name), mine["conditions"].get(name)
            if is_smaller(was, now):
                before["conditions"][name] = now
                mine["about"][GROWN] = []
                sizes.append(was)
        return sizes

    def results(self, name: str, kind: type[T], key: str) -> dict[Any, T]:
        """Read the finished parts from a file of lines; return objects of the dataclass `kind`, by its field `key`.

        The field `settings` of each line must be the hash of this run's settings: ValueError for a line of another run.
        """
        if self.path is None:
            return {}
        parts: dict[Any, T] = {}
        path, names = self.path / name, sorted(field.name for field in fields(kind))  # type: ignore[arg-type]
        for record in read_lines(path):
            if sorted(record) != names:
                raise ValueError(f"{path}: a line has the fields {', '.join(names)}, got {', '.join(sorted(record))}")
            check_kinds(path, record, kind)
            if record["settings"] in self._earlier:
                record["settings"] = self.settings
            part = kind(**record)
            if record["settings"] != self.settings or parts.setdefault(record[key], part) != part:
                raise ValueError(f"{path}: {key} {record[key]} belongs to other settings; give another folder")
        return parts

    def add(self, name: str, parts: Iterable[Any]) -> None:
        """Add finished parts, dataclasses or dicts, to a file of lines; they are on the disk before this returns."""
        if self.path is not None:
            append_lines(self.path / name, (part if isinstance(part, dict) else asdict(part) for part in parts))

    def write(self, name: str, content: str | bytes) -> None:
        """Write a file of the folder, or of a folder in it, whole or not at all."""
        if self.path is not None:
            (self.path / name).parent.mkdir(exist_ok=True)
            write_atomically(self.path / name, content)


def is_smaller(was: Any, now: Any) -> bool:
    """Tell whether a number is smaller than another one, or a list the beginning of a longer one."""
    if isinstance(was, list) and isinstance(now, list):
        return len(was) < len(now) and was == now[: len(was)]
    return isinstance(was, int) and isinstance(now, int) and was < now


def check_kinds(path: Path, record: dict[str, Any], kind: type) -> None:
    """Raise ValueError for a line with a field of another type (int, str or dict) than in the dataclass `kind`."""
    hints = get_type_hints(kind)
    for name, value in record.items():
        wanted = get_origin(hints[name]) or hints[name]
        if wanted in (int, str, dict) and (not isinstance(value, wanted) or isinstance(value, bool)):
            raise ValueError(f"{path}: {name} of a line must be {NAMED[wanted]}, got {short_repr(value)}")


def settings_before(path: Path, kind: RunKind, anew: bool = False) -> dict[str, Any] | None:
    """Return the contents of settings.json in a folder; None if the folder holds no run.

    ValueError if the folder holds something else; also if settings.json cannot be read, except with `anew`.
    """
    if not (path / SETTINGS).exists():
        there = [name for name in kind.files if (path / name).exists()]
        if there:
            raise ValueError(f"{path} holds {there[0]}, but no {SETTINGS} of {kind.what}; give another folder")
        return None
    try:
        found = read_settings(path / SETTINGS)
    except ValueError:
        if anew and (path / kind.files[0]).exists():
            return None
        raise
    if not all(isinstance(found.get(part), dict) for part in PARTS) or not found["conditions"].keys() >= {*kind.marks}:
        raise ValueError(f"{path / SETTINGS} is of something else than {kind.what}; give another folder")
    return found


def read_settings(path: Path) -> dict[str, Any]:
    """Return the contents of a settings file; ValueError if it is damaged."""
    try:
        found = json.loads(read_regular_file(path, LARGEST))
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{path} cannot be read as JSON ({error}); {ELSE}") from error
    return found if isinstance(found, dict) else {}


def check_same(path: Path, what: str, theirs: dict[str, Any], mine: dict[str, Any]) -> None:
    """Raise ValueError that names each condition, version and hash in which a stored run differs from this one."""
    differences = [
        f"{name} {theirs[part].get(name)!r} there, {mine[part].get(name)!r} now"
        for part in ("conditions", "made_with")
        for name in dict.fromkeys([*theirs[part], *mine[part]])
        if theirs[part].get(name) != mine[part].get(name)
    ]
    if differences:
        which = "; ".join(differences)
        raise ValueError(f"{path} holds {what} with other settings ({which}); {ELSE}")


def remove_run(path: Path, kind: RunKind, before: dict[str, Any] | None) -> None:
    """Remove the files of a run, settings.json last, because a folder of results without it is refused."""
    patterns = kind.more(before["conditions"] if before else {})
    for found in (one for pattern in patterns for one in sorted(path.glob(pattern))):
        if found.is_dir():
            shutil.rmtree(found, ignore_errors=True)
        else:
            found.unlink(missing_ok=True)
    for name in (*kind.files, SETTINGS):
        (path / name).unlink(missing_ok=True)


def lock(path: Path) -> Any:
    """Lock a folder and return the lock; ValueError if another process holds it. The lock ends with the process."""
    from filelock import FileLock, Timeout

    held = FileLock(path)
    try:
        held.acquire(timeout=0)
    except Timeout as error:
        raise ValueError(f"another run uses {path.parent}; give another folder") from error
    return held
