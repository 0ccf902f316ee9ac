"""`soccer export`, as command_line.py runs it."""

from __future__ import annotations


def run_export(words: list[str]) -> int:
    """Run `soccer export`."""
    from soccer_env.train.evaluate.export_settings import ExportSettings
    from soccer_env.train.parsing import read_settings

    settings = read_settings(ExportSettings, words, "export")
    from soccer_env.train.evaluate.exporting import export

    print(f"written: {export(settings)}")
    return 0
