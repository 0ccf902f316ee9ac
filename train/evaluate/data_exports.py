"""`soccer export` of data: tidy tables, the Common Data Format and XML of one replay or of a folder of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from soccer_env.data_out.collect import Collected, collect
from soccer_env.data_out.sportec import write_sportec
from soccer_env.data_out.standard import FILES, write_standard
from soccer_env.data_out.table_files import paths_of, require, write_tables
from soccer_env.data_out.tables import tables_of
from soccer_env.replay import Replay
from soccer_env.train.evaluate.play_settings import ExportSettings
from soccer_env.train.progress import Progress

TABLES = (".csv", ".parquet")
OF_ONE = (".xml", ".cdf")  # a file, or a folder of files, holds one match
KINDS = (*TABLES, *OF_ONE)


def export_data(settings: ExportSettings) -> list[Path]:
    """Write what `out` asks for of a replay, or of all below a folder; return the files and folders written.

    ValueError for what exists already (unless `anew`), for a folder without replays and for the first that is none.
    """
    kind = settings.out.suffix.lower()
    require(kind)
    sources = replays_of(settings.file)
    if kind in TABLES:
        targets = list(paths_of(settings.out).values())
    elif settings.file.is_dir():
        targets = targets_of(settings.out, sources)
    else:
        targets = [settings.out]
    check_free(targets, settings.anew)
    with Progress(settings.out.name, len(sources)) as bar:
        matches = collected(sources, bar)
        if kind in TABLES:
            write_tables((tables_of(match) for match in matches), settings.out)
        else:
            for match, target in zip(matches, targets, strict=True):
                (write_sportec if kind == ".xml" else write_standard)(match, target)
    return targets


def replays_of(path: Path) -> dict[str, Path]:
    """Return the replays of a file or of a folder, by the names of their matches, in order."""
    if not path.is_dir():
        return {path.stem: path}
    found = {file.relative_to(path).with_suffix("").as_posix(): file for file in sorted(path.rglob("*.replay"))}
    if not found:
        raise ValueError(f"there are no replays (*.replay) in {path}")
    return found


def targets_of(out: Path, sources: Iterable[str]) -> list[Path]:
    """Return a file beside `out` for each match of a folder, NAME_MATCH; ValueError where two would be one."""
    found: dict[Path, str] = {}
    for name in sources:
        target = out.with_name(f"{out.stem}_{name.replace('/', '_')}{out.suffix}")
        if target in found:
            raise ValueError(f"{found[target]} and {name} would both be written to {target}; export them one by one")
        found[target] = name
    return list(found)


def collected(sources: dict[str, Path], bar: Progress) -> Iterator[Collected]:
    """Yield what happened in each match, played when it is asked for."""
    for name, path in sources.items():
        yield collect(Replay.read(path), name)
        bar.advance(1)


def check_free(targets: list[Path], anew: bool) -> None:
    """Raise ValueError if something stands where a file is to be written; with `anew` only what is not of its kind."""
    for target in targets:
        folder = target.suffix.lower() == ".cdf"
        if target.is_symlink() or (target.exists() and (target.is_dir() != folder)):
            raise ValueError(f"{target} is in the way")
        if folder and target.is_dir() and {file.name for file in target.iterdir()} - set(FILES):
            raise ValueError(f"{target} is a folder with other files than {', '.join(FILES)}")
        if target.exists() and not anew:
            raise ValueError(f"{target} exists already; give another --out, or --anew to write over it")


def size_of(path: Path) -> int:
    """Return the bytes of a file or of a folder's files."""
    return sum(file.stat().st_size for file in path.iterdir()) if path.is_dir() else path.stat().st_size
