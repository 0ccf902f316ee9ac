"""`soccer export`: turn a replay into a film, a picture, a browser page, data, or a picture of maps or of errors."""

from collections.abc import Iterable, Iterator
from dataclasses import asdict, replace
from pathlib import Path

from soccer_env.data_out.collect import MatchRecording, collect_match
from soccer_env.data_out.standard import FILES, write_standard
from soccer_env.data_out.table_files import require_writer, table_paths, write_tables
from soccer_env.data_out.tables import match_tables
from soccer_env.guards.whole_files import write_atomically
from soccer_env.render import save_png
from soccer_env.render.overlays.flags import select_flags
from soccer_env.replay import Replay
from soccer_env.shows import frame
from soccer_env.shows.browser import write_page
from soccer_env.shows.film import drawn_steps, make_film
from soccer_env.train.evaluate.belief_pictures import KINDS as BELIEF_PICTURES
from soccer_env.train.evaluate.belief_pictures import draw_beliefs
from soccer_env.train.evaluate.map_pictures import KINDS as MAPS
from soccer_env.train.evaluate.map_pictures import export_maps
from soccer_env.train.evaluate.play_settings import ExportSettings
from soccer_env.train.evaluate.recording import check_target
from soccer_env.train.progress import Progress

TABLES = (".csv", ".parquet")
DATA = (*TABLES, ".cdf")  # the last is a folder of files, of one match
KINDS = (".html", ".mp4", ".gif", ".png", *DATA)


def export(settings: ExportSettings) -> str:
    """Export a replay to the format of the file's ending; return name and size of the new file in words."""
    kind = settings.target.suffix.lower()
    option = "maps" if settings.maps else "beliefs" if settings.beliefs else ""
    kinds = {"maps": MAPS, "beliefs": (*TABLES, *BELIEF_PICTURES)}.get(option, KINDS)
    if kind not in kinds:
        must = f"--out{f' with --{option}' if option else ''} must end with {', '.join(kinds)}"
        advice = f"; {kind} needs --maps: heat maps, pass networks, shot maps" if kind in MAPS and not option else ""
        raise ValueError(f"{must}, got {str(settings.target)!r}{advice}")
    if kind in DATA or settings.beliefs:
        # only the folder above: `check_targets_free` checks NAME.cdf itself
        check_target(settings.target.with_suffix(".tmp"))
        return names_and_size(export_data(settings))
    if settings.file.is_dir():
        sources = find_replay_files(settings.file)
        targets = targets_of(settings.target, sources)
        check_target(targets[0])
        check_targets_free(targets, settings.anew)
        for source, target in zip(sources.values(), targets, strict=True):
            export_one(replace(settings, file=source, out=target), settings.target.suffix.lower())
        return names_and_size(targets)
    check_target(settings.target)
    if settings.target.exists() and not settings.anew:
        raise ValueError(f"{settings.target} exists already; give another --out, or --anew to write over it")
    return export_one(settings, kind)


def export_one(settings: ExportSettings, kind: str) -> str:
    """Export one replay to a film, page or picture; return name and size of the file in words."""
    if settings.maps:
        return str(export_maps(settings.file, settings.target))
    replay = Replay.read(settings.file)
    rate = replay.make_match().league.control_rate  # this checks its settings, too
    if kind == ".html":
        with Progress(settings.target.name, len(replay)) as bar:
            write_page(replay, settings.target, settings.anew, bar.advance, select_flags(settings))
    elif kind == ".png":
        overlays = asdict(select_flags(settings))
        still = frame(replay, settings.start, width=settings.width, height=settings.height, **overlays)
        save_png(still, settings.target)
        return f"{settings.target}, {settings.target.stat().st_size / 1e3:.0f} kB"
    else:
        with Progress(settings.target.name, len(drawn_steps(settings, kind, rate, len(replay))[0])) as bar:
            make_film(replay, settings.target, settings, settings.anew, bar.advance)
    shown = len(replay) / rate - (settings.start if kind != ".html" else 0.0)
    minutes = (shown if kind == ".html" or settings.seconds is None else min(shown, settings.seconds)) / 60.0
    size = settings.target.stat().st_size
    return f"{settings.target}, {size / 1e6:.2f} MB, {size / 1e3 / max(minutes, 1e-9):.0f} kB a minute of play"


def export_data(settings: ExportSettings) -> list[Path]:
    """Write the data of one replay, or of all replays below a folder; return the files and folders written.

    ValueError for a target that exists (unless `anew`), for a folder without replays, for a file that is no replay.
    """
    kind = settings.target.suffix.lower()
    require_writer(kind)
    sources = find_replay_files(settings.file)
    if kind in TABLES:
        targets = list(table_paths(settings.target, settings.beliefs).values())
    elif settings.beliefs:
        targets = [settings.target]
    elif settings.file.is_dir():
        targets = targets_of(settings.target, sources)
    else:
        targets = [settings.target]
    check_targets_free(targets, settings.anew)
    with Progress(settings.target.name, len(sources)) as bar:
        matches = collect_matches(sources, bar, settings.beliefs)
        if kind in TABLES:
            write_tables((match_tables(match) for match in matches), settings.target, settings.beliefs)
        elif settings.beliefs:
            write_atomically(settings.target, draw_beliefs(matches, kind[1:]))
        else:
            for match, target in zip(matches, targets, strict=True):
                write_standard(match, target)
    return targets


def find_replay_files(path: Path) -> dict[str, Path]:
    """Return the replay files below a folder, or the single file at a path, by the names of their matches."""
    if not path.is_dir():
        return {path.stem: path}
    replays = {file.relative_to(path).with_suffix("").as_posix(): file for file in sorted(path.rglob("*.replay"))}
    if not replays:
        raise ValueError(f"there are no replays (*.replay) in {path}")
    return replays


def targets_of(out: Path, sources: Iterable[str]) -> list[Path]:
    """Return the target file for each match, NAME_MATCH beside `out`; ValueError if two matches share a file."""
    targets: dict[Path, str] = {}
    for name in sources:
        target = out.with_name(f"{out.stem}_{name.replace('/', '_')}{out.suffix}")
        if target in targets:
            raise ValueError(f"{targets[target]} and {name} would both be written to {target}; export them one by one")
        targets[target] = name
    return list(targets)


def collect_matches(sources: dict[str, Path], bar: Progress, beliefs: bool) -> Iterator[MatchRecording]:
    """Yield the events and frames of each match; each match is played only when the iterator reaches it."""
    for name, path in sources.items():
        yield collect_match(Replay.read(path), name, beliefs=beliefs)
        bar.advance(1)


def check_targets_free(targets: list[Path], anew: bool) -> None:
    """Raise ValueError if a target exists; with `anew`, only if its kind (file or folder) differs."""
    for target in targets:
        folder = target.suffix.lower() == ".cdf"
        if target.is_symlink() or (target.exists() and (target.is_dir() != folder)):
            raise ValueError(f"{target} is in the way")
        if folder and target.is_dir() and {file.name for file in target.iterdir()} - set(FILES):
            raise ValueError(f"{target} is a folder with other files than {', '.join(FILES)}")
        if target.exists() and not anew:
            raise ValueError(f"{target} exists already; give another --out, or --anew to write over it")


def names_and_size(paths: list[Path]) -> str:
    """Return the names of files and folders, and their total size, in words."""
    files = [file for path in paths for file in (path.iterdir() if path.is_dir() else (path,))]
    return f"{', '.join(map(str, paths))}, {sum(file.stat().st_size for file in files) / 1e6:.2f} MB"
