"""How the matches of a SoccerVecEnv are shared out among team sizes, senses and blocks, and how they begin.

A block is a Match of up to `BLOCK` matches that one thread plays by itself for a whole decision.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from soccer_env.match import BLOCK, Match


def shared_out(
    players: Sequence[tuple[int, int]], matches: int, ideal_share: float
) -> list[tuple[tuple[int, int], int, dict[str, str]]]:
    """Return blocks (team size, matches, settings): every size has as many, of which a share has ideal senses."""
    if not 0.0 <= ideal_share <= 1.0:
        raise ValueError(f"ideal_share must be a number from 0 to 1, got {ideal_share!r}")
    blocks: list[tuple[tuple[int, int], int, dict[str, str]]] = []
    for sizes, count in zip(players, parts(matches, len(players)), strict=True):
        ideal = round(ideal_share * count)
        if count < 1 or (ideal_share > 0.0 and ideal < 1) or (ideal_share < 1.0 and ideal == count):
            kinds = f"{len(players)} team sizes" + (", by either senses" if 0.0 < ideal_share < 1.0 else "")
            raise ValueError(f"matches must be at least one for each of {kinds}, got {matches}")
        for number, senses in ((count - ideal, {}), (ideal, {"senses": "ideal"})):
            blocks += [(sizes, part, senses) for part in parts(number, -(-number // BLOCK))]
    return blocks


def parts(whole: int, count: int) -> list[int]:
    """Return so many nearly equal numbers that add up to the whole."""
    return [whole * (i + 1) // count - whole * i // count for i in range(count)]


def stagger_clocks(match: Match, repeat: int) -> None:
    """Let the first episodes of M matches begin at different times of their first half, a whole number of steps on."""
    half = match.settings.half_length
    if np.isfinite(half):
        strides = int(half / (match.league.dt * repeat))
        match.matches["clock"] = np.arange(match.count) * strides // match.count * repeat * match.league.dt


def playing(match: Match) -> list[str]:
    """Return the name of the team that plays the last away robot now, for each match."""
    names = [""] * match.count
    for squad in match.squads:
        if squad.players[-1] == len(match.agents) - 1:
            for m in range(match.count) if squad.plays is None else np.flatnonzero(squad.plays):
                names[m] = squad.name
    return names
