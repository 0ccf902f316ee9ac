"""Parts of Markdown that several pages use."""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table; `|` and line ends in its cells are taken care of."""
    lines = [head, ["---"] * len(head), *([cell(text) for text in row] for row in rows)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def cell(text: str) -> str:
    """Return a text as a cell; one that is code keeps its `|`."""
    text = text.replace("\n", "<br>")
    return text if text.startswith("`") and text.endswith("`") else text.replace("|", "\\|")


def code(text: str) -> str:
    """Return a text as code, "" for none."""
    return f"`{text}`" if text else ""
