"""All measures, and measuring them: blocks of matches are played, looked at and forgotten."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from soccer_env.random_numbers import seeds_for
from soccer_env.train.play import ball, possession, referee, scrums, stuck
from soccer_env.train.play.figures import Found, Samples, work_out
from soccer_env.train.play.recording import Recording, record
from soccer_env.train.play.settings import Conditions, MeasureSettings, conditions_of
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import made_now, made_with

BLOCK = 16  # matches side by side; their recording has to fit into memory
MEASURES = (*ball.MEASURES, *possession.MEASURES, *stuck.MEASURES, *scrums.MEASURES, *referee.MEASURES)


@dataclass(frozen=True)
class Play:
    """How matches were played."""

    settings: MeasureSettings
    conditions: Conditions
    made_with: dict[str, str]
    figures: tuple[Found, ...]
    goals: int


def measure(settings: MeasureSettings) -> Play:
    """Play the matches and return every figure."""
    conditions = conditions_of(settings)
    about = {**made_now(), **made_with(conditions.league, settings.home, settings.away)}
    seeds = seeds_for(settings.seed, settings.matches).tolist()
    steps = settings.matches * settings.minutes * 60.0 * conditions.league.control_rate
    blocks: list[Samples] = []
    with Progress(f"{settings.home} against {settings.away}", steps) as bar:
        for first in range(0, settings.matches, BLOCK):
            recording = record(conditions, seeds[first : first + BLOCK], bar.advance)
            blocks.append(samples_of(recording))
    samples = {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]}
    figures = tuple(work_out(figure, samples) for one in MEASURES for figure in one.figures)
    return Play(settings, conditions, about, figures, int(samples["goals"].sum()))


def samples_of(recording: Recording) -> Samples:
    """Return what all measures take from a recording."""
    found: Samples = {}
    for one in MEASURES:
        found |= one.samples(recording)
    return found
