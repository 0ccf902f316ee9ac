"""Tables of an evaluation's report: shots, thirds of the pitch, mean positions, passes."""

from typing import Any

import numpy as np

from soccer_env.statistics.maps import OUTCOMES

SIDES = ("for", "against")
THIRDS = ("in its own third", "in the middle third", "in the opponents' third")
MOST_PASSES = 5  # shown for each player
MOST_PAIRS = 12  # of players, shown for both teams


def map_rows(maps: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return rows (name, first team, second team): shots by outcome, and the ball's and robots' time in each third."""
    rows: list[tuple[str, str, str]] = []
    for outcome in sorted(OUTCOMES, key=("goal", "saved", "blocked", "off_target").index):
        ours, theirs = (sum(shot[2] == outcome for shot in maps[f"shots_{side}"]) for side in SIDES)
        rows.append((f"shots: {outcome.replace('_', ' ')}", f"{ours}", f"{theirs}"))
    ball = np.array(maps["heat_ball"])
    layers = [(ball, ball[::-1, ::-1]), tuple(np.array(maps[f"heat_{side}"]) for side in SIDES)]
    for what, (first, second) in zip(("ball", "robots"), layers, strict=True):
        shares = zip(THIRDS, share_by_third(first), share_by_third(second), strict=True)
        rows += [(f"{what} {where}", f"{one:.0f} %", f"{other:.0f} %") for where, one, other in shares]
    return rows


def share_by_third(heat: np.ndarray) -> list[float]:
    """Return the share [%] of a heat map (16, 24) in each third of the pitch, starting at the own goal."""
    total = max(int(heat.sum()), 1)
    return [100.0 * float(part.sum()) / total for part in np.split(heat, 3, axis=1)]


def player_rows(maps: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return a row for each player number: that player's mean position and passes, in the first and second team."""
    teams = [(np.array(maps[f"players_{side}"]), np.array(maps[f"passes_{side}"])) for side in SIDES]
    rows = []
    for number in range(max(len(players) for players, _ in teams)):
        ours, theirs = (player_words(players, passes, number) for players, passes in teams)
        rows.append((f"{number}", ours, theirs))
    return rows


def pass_rows(maps: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return rows (pair of players, passes in both teams) for the most frequent pairs, and for the total."""
    teams = [np.array(maps[f"passes_{side}"]) for side in SIDES]
    counts = {(a, b): [int(one[a, b]) if max(a, b) < len(one) else 0 for one in teams]
              for a, b in np.ndindex(*np.max([one.shape for one in teams], axis=0).tolist())}  # fmt: skip
    shown = sorted((pair for pair in counts if any(counts[pair])), key=lambda pair: (-sum(counts[pair]), pair))
    rows = [(f"{a} to {b}", *map(str, counts[a, b])) for a, b in shown[:MOST_PAIRS]]
    return [*rows, ("all", *(f"{one.sum()}" for one in teams))]  # type: ignore[list-item]


def player_words(players: np.ndarray, passes: np.ndarray, number: int) -> str:
    """Return a player's mean position [m] and its passes in words; "-" if the team has no such player."""
    if number >= len(players) or players[number, 2] <= 0.0:
        return "-"
    x, y = players[number, :2] / players[number, 2]
    best = np.argsort(-passes[number], kind="stable")[:MOST_PASSES]
    receivers = ", ".join(f"{passes[number, mate]} to {mate}" for mate in best if passes[number, mate] > 0)
    return f"({x:+.2f}, {y:+.2f})" + (f"; {receivers}" if receivers else "")
