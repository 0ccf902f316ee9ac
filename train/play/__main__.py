"""Measure how matches are played: see the package's docstring."""

from __future__ import annotations

import sys

import tyro

from soccer_env.render.canvas import require_pygame
from soccer_env.train.command_line import console, guarded
from soccer_env.train.play.goals.settings import GoalSettings
from soccer_env.train.play.goals.table import goals_table
from soccer_env.train.play.goals.table import write as write_goals
from soccer_env.train.play.goals.watching import watch
from soccer_env.train.play.measures import measure
from soccer_env.train.play.report import read, screen_table, write
from soccer_env.train.play.settings import MeasureSettings


def run(words: list[str]) -> int:
    """Measure play, or look at goals if that is the first word."""
    return run_goals(words[1:]) if words[:1] == ["goals"] else run_measure(words)


def run_goals(words: list[str]) -> int:
    """Look at the goals that the words ask for, print the table, write the lines and the sheets."""
    settings = tyro.cli(GoalSettings, args=words, prog="python -m soccer_env.train.play goals")
    if settings.sheets > 0:
        require_pygame()  # before matches are played in vain
    seen = watch(settings)
    console().print(goals_table(seen, settings))
    write_goals(seen, settings.out)
    if settings.sheets > 0:
        from soccer_env.train.play.goals.sheet import draw_sheets

        draw_sheets(seen, settings)
    print(f"written: {settings.out}")
    return 0


def run_measure(words: list[str]) -> int:
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
