"""Collect states of running matches into a file for scene="states:FILE"."""

from typing import Any

import numpy as np

from soccer_env.guards.checking import Range, check_finite_number, check_whole_number
from soccer_env.match.saving.saves import save_header
from soccer_env.records.save_file import join_save
from soccer_env.scenes.saved_states import RECORDS

Match = Any  # soccer_env.match.match.Match, which stands above this file
MOST = 1_000_000  # moments


def collect_states(match: Match, moments: int, every: float = 2.0) -> bytes:
    """Play on a match whose robots teams play, and return its states at some moments as a save.

    every: time between two moments [s]. The save holds moments x M states without beliefs and memories: it is for
    scene="states:FILE", not for `Match.load`. Matches that are over are left out when it is read.

        match = Match(matches=64, controllers={"home": "chaser", "away": "chaser"}, autoreset="same_step", seed=1)
        Path("play.states").write_bytes(collect_states(match, moments=50))
    """
    check_whole_number("moments", moments, 1, MOST)
    check_finite_number("every", every, Range(match.league.dt, 3600.0))
    found: dict[str, list[np.ndarray]] = {name: [] for name in RECORDS}
    for _ in range(moments):
        for _ in range(round(every * match.league.control_rate / match.settings.action_repeat)):
            match.step()
        for name, records in found.items():
            records.append(getattr(match, name).copy())
    arrays = {name: np.concatenate(records) for name, records in found.items()}
    header = {**save_header(match, arrays, memory=False), "told": match.described_settings}
    return join_save(header, arrays.values())
