"""A table of evaluations in Markdown, with a row for each setting and a column for each opponent, or transposed."""

from collections.abc import Mapping
from typing import Any

Cells = Mapping[tuple[str, str], str]  # by the names of row and column


def crosstable(corner: str, cells: Cells) -> str:
    """Return the table of `cells`, by (row, column): both in order of first appearance, with "-" for missing cells."""
    rows = dict.fromkeys(row for row, _ in cells)
    columns = dict.fromkeys(column for _, column in cells)
    lines = [f"| {corner} | {' | '.join(columns)} |", "|" + "---|" * (len(columns) + 1)]
    for row in rows:
        lines.append(f"| {row} | {' | '.join(cells.get((row, column), '-') for column in columns)} |")
    return "\n".join(lines)


def goals_of(row: Mapping[str, Any]) -> str:
    """Return the goal difference a match of an evaluation, with its interval, in words."""
    goals = row["goal_difference"]
    return f"{goals['mean']:+.2f} ({goals['low']:+.2f} to {goals['high']:+.2f})"
