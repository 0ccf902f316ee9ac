"""The tally of a rollout: what was paid, kicked and whistled in a block of matches, for the log."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.match import Match

COUNTS = ("kicks", "whistles", "whistles_against")  # whistles: fouls of the learners; of their opponents


class Tally:
    """Sums over the control steps of a block of matches, whose learners come first."""

    def __init__(self, match: Match, learners: int) -> None:
        self.learners, self.matches, self.dt = learners, match.count, match.league.dt
        self.names = match.term_names
        self.sizes = f"{match.settings.home}v{match.settings.away}"
        self.steps, self.terms, self.counts = 0, np.zeros(len(self.names)), np.zeros(len(COUNTS), np.int64)

    def add(self, match: Match) -> None:
        """Add the last control step of the block."""
        learners = self.learners
        events = match.robot_events
        self.steps += 1
        self.terms += match.terms[:, :learners].sum((0, 1))
        self.counts += [
            np.count_nonzero(events["kick"][:, :learners]), np.count_nonzero(events["foul"][:, :learners]),
            np.count_nonzero(events["foul"][:, learners:]),
        ]  # fmt: skip


def make_tallies(env: Any) -> list[Tally]:
    """Return a tally of each block of a `SoccerVecEnv`."""
    return [Tally(*pair) for pair in zip(env.matches, env.learners, strict=True)]


def size_numbers(sizes: Sequence[tuple[int, int]]) -> list[int]:
    """Return for each block, given its team size, the number of the size in the order in which sizes first come."""
    return [list(dict.fromkeys(sizes)).index(one) for one in sizes]


def per_minute(tallies: Sequence[Tally]) -> dict[str, dict[str, Any]]:
    """Return for each team size: reward terms a robot and minute, and COUNTS a match and minute."""
    found: dict[str, dict[str, Any]] = {}
    for sizes in dict.fromkeys(tally.sizes for tally in tallies):
        own = [tally for tally in tallies if tally.sizes == sizes]
        minutes = sum(tally.steps * tally.matches * tally.dt / 60.0 for tally in own)
        terms, counts = (sum(getattr(tally, name) for tally in own) for name in ("terms", "counts"))
        played = max(minutes, 1e-9)
        found[sizes] = {
            name: round(float(paid) / played / own[0].learners, 5)
            for name, paid in zip(own[0].names, terms, strict=True)
            if paid
        }
        found[sizes] |= {name: round(float(count) / played, 3) for name, count in zip(COUNTS, counts, strict=True)}
    return found
