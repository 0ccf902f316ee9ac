"""`soccer record`, `replay`, `export` and `watch`, as command_line.py runs them."""

from __future__ import annotations

from soccer_env.train.parsing import read_settings


def run_record(words: list[str]) -> int:
    """Run `soccer record`."""
    from soccer_env.train.evaluate.play_settings import RecordSettings

    settings = read_settings(RecordSettings, words, "record")
    from soccer_env.train.evaluate.recording import record

    replay = record(settings)
    rate = settings.out.stat().st_size / 1e3 / max(settings.minutes, 1e-9)
    print(f"written: {settings.out}, {len(replay)} control steps, {rate:.0f} kB a minute")
    return 0


def run_replay(words: list[str]) -> int:
    """Run `soccer replay`."""
    from soccer_env.train.evaluate.play_settings import ReplaySettings

    settings = read_settings(ReplaySettings, words, "replay")
    from soccer_env.train.evaluate.recording import play_again

    print(f"{settings.file}: {play_again(settings.file)} control steps agree")
    return 0


def run_export(words: list[str]) -> int:
    """Run `soccer export`."""
    from soccer_env.train.evaluate.export_settings import ExportSettings

    settings = read_settings(ExportSettings, words, "export")
    from soccer_env.train.evaluate.exporting import export

    print(f"written: {export(settings)}")
    return 0


def run_watch(words: list[str]) -> int:
    """Run `soccer watch`."""
    from soccer_env.train.watching.settings import WatchSettings

    settings = read_settings(WatchSettings, words, "watch")
    from soccer_env.train.watching.watching import watch

    watch(settings)
    return 0
