"""`soccer export`: a replay file as a film, a picture, a page for the browser, as data, or its maps as a picture."""

from __future__ import annotations

from dataclasses import fields, replace

from soccer_env.render import save_png
from soccer_env.render.overlays.flags import OverlayFlags, part_of_flags
from soccer_env.replay import Replay
from soccer_env.replay.browser import write_page
from soccer_env.replay.film import FilmSettings, drawn_steps, make_film
from soccer_env.train.evaluate import data_exports
from soccer_env.train.evaluate.map_pictures import KINDS as MAPS
from soccer_env.train.evaluate.map_pictures import export_maps
from soccer_env.train.evaluate.play_settings import ExportSettings
from soccer_env.train.evaluate.recording import check_target
from soccer_env.train.progress import Progress

KINDS = (".html", ".mp4", ".gif", ".png", *data_exports.KINDS)


def export(settings: ExportSettings) -> str:
    """Write what `out` asks for by its ending; return its name and size in words. See `Replay.video` for errors."""
    kind = settings.out.suffix.lower()
    if kind not in (MAPS if settings.maps else KINDS):
        with_maps = f"--out with --maps must end with {', '.join(MAPS)}"
        must = with_maps if settings.maps else f"--out must end with {', '.join(KINDS)}"
        asked = f"; {kind} needs --maps: heat maps, pass networks, shot maps" if kind in MAPS else ""
        raise ValueError(f"{must}, got {str(settings.out)!r}{asked}")
    if kind in data_exports.KINDS:
        check_target(settings.out.with_suffix(".tmp"))  # its folder: NAME.cdf is one itself, see `check_free`
        targets = data_exports.export_data(settings)
        total = sum(data_exports.size_of(path) for path in targets)
        return f"{', '.join(str(path) for path in targets)}, {total / 1e6:.2f} MB"
    if settings.file.is_dir():
        return export_each(settings)
    check_target(settings.out)
    if settings.out.exists() and not settings.anew:
        raise ValueError(f"{settings.out} exists already; give another --out, or --anew to write over it")
    return export_one(settings, kind)


def export_each(settings: ExportSettings) -> str:
    """Write a film, page or picture of every replay below a folder; return how many there are, in words."""
    sources = data_exports.replays_of(settings.file)
    targets = data_exports.targets_of(settings.out, sources)
    check_target(targets[0])
    data_exports.check_free(targets, settings.anew)
    for source, target in zip(sources.values(), targets, strict=True):
        export_one(replace(settings, file=source, out=target), settings.out.suffix.lower())
    total = sum(target.stat().st_size for target in targets)
    return f"{', '.join(str(path) for path in targets)}, {total / 1e6:.2f} MB"


def export_one(settings: ExportSettings, kind: str) -> str:
    """Write a film, page or picture of one replay; return its name and size in words."""
    if settings.maps:
        return str(export_maps(settings.file, settings.out))
    replay = Replay.read(settings.file)
    rate = replay.make_match().league.control_rate  # its settings are sound, too
    if kind == ".html":
        with Progress(settings.out.name, len(replay)) as bar:
            write_page(replay, settings.out, settings.anew, bar.advance, part_of_flags(settings))
    elif kind == ".png":
        return write_picture(replay, settings)
    else:
        write_film(replay, settings, rate)
    shown = len(replay) / rate - (settings.start if kind != ".html" else 0.0)
    minutes = (shown if kind == ".html" or settings.seconds is None else min(shown, settings.seconds)) / 60.0
    size = settings.out.stat().st_size
    return f"{settings.out}, {size / 1e6:.2f} MB, {size / 1e3 / max(minutes, 1e-9):.0f} kB a minute of play"


def write_picture(replay: Replay, settings: ExportSettings) -> str:
    """Write one frame; return its name and size in words."""
    overlays = {item.name: getattr(settings, item.name) for item in fields(OverlayFlags)}
    save_png(replay.frame(settings.start, width=settings.width, **overlays), settings.out)
    return f"{settings.out}, {settings.out.stat().st_size / 1e3:.0f} kB"


def write_film(replay: Replay, settings: ExportSettings, rate: int) -> None:
    """Write a film, with a bar that says how far it is."""
    film = FilmSettings(**{item.name: getattr(settings, item.name) for item in fields(FilmSettings)})
    count = len(drawn_steps(film, settings.out.suffix.lower(), rate, len(replay))[0])
    with Progress(settings.out.name, count) as bar:
        make_film(replay, settings.out, film, settings.anew, bar.advance)
