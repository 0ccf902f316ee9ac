"""Measure how matches are played: see the package's docstring."""

from __future__ import annotations

import sys

import tyro

from soccer_env.train.command_line import console, guarded
from soccer_env.train.play.measures import measure
from soccer_env.train.play.report import read, screen_table, write
from soccer_env.train.play.settings import MeasureSettings


def run(words: list[str]) -> int:
    """Measure what the words ask for, print the table and write the file."""
    settings = tyro.cli(MeasureSettings, args=words, prog="python -m soccer_env.train.play")
    before = read(settings.before) if settings.before else None
    play = measure(settings)
    console().print(screen_table(play, before))
    if settings.out is not None:
        write(play, settings.out)
        print(f"written: {settings.out}")
    return 0


if __name__ == "__main__":
    sys.exit(guarded(run, sys.argv[1:]))
