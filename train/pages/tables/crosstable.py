"""A table of evaluations in Markdown with a row for each setting and a column for each opponent, or the other way."""

from collections.abc import Mapping
from typing import Any

Cells = Mapping[tuple[str, str], str]  # by the names of row and column


def crosstable(corner: str, cells: Cells) -> str:
    """Return cells as a table, rows and columns in the order in which they first appear; missing ones as "-"."""
    rows = dict.fromkeys(row for row, _ in cells)
    columns = dict.fromkeys(column for _, column in cells)
    lines = [f"| {corner} | {' | '.join(columns)} |", "|" + "---|" * (len(columns) + 1)]
    for row in rows:
        lines.append(f"| {row} | {' | '.join(cells.get((row, column), '-') for column in columns)} |")
    return "\n".join(lines)


def goals_of(row: Mapping[str, Any]) -> str:
    """Return the goal difference a match of an evaluation, with its interval."""
    found = row["goal_difference"]
    return f"{found['mean']:+.2f} ({found['low']:+.2f} to {found['high']:+.2f})"
