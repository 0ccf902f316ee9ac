"""The README's tables of the learned team: which evaluations they are made of, and the time that training takes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from soccer_env.train.settings import EvaluateSettings
from soccer_env.train.tables_teams import measured, row_settings

TEAM, MATCHES, MINUTES = "learned", 200, 4.0
SIZES = (1, 2, 3)
OPPONENTS = ("random", "chaser", "sacks-2001@0.25", "sacks-2001@0.5", "sacks-2001@0.75", "sacks-2001")
SENSES = ("sensors", "ideal")
LONG = 10.0  # [min] of the match in which the share of points against the chaser is asked for


def learned_rows() -> Iterator[EvaluateSettings]:
    """Yield the evaluations of the learned team, the long one against the chaser first."""
    yield row_settings("legged-2001", TEAM, "chaser", "sensors", MATCHES, LONG, 3)
    for senses in SENSES:
        for players in reversed(SIZES):
            for away in OPPONENTS:
                yield row_settings("legged-2001", TEAM, away, senses, MATCHES, MINUTES, players)


def learned_table(table: dict[str, Any]) -> str:
    """Return the table of the learned team in Markdown."""
    lines = [
        "| players | senses | against | minutes | points | goal difference a match | goals a minute | settings |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in table["rows"]:
        players = f"{row['players']} v {row['players']}"
        lines.append(f"| {players} | {row['senses']} | {row['away']} | {row['minutes']:g} | {measured(row)} |")
    command = f"Command of a row: `{table['rows'][0]['command']}`"
    return "\n".join([*lines, "", f"{MATCHES} matches a row. {command}"])
