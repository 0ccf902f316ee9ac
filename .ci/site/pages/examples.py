"""Pages of the examples of `train/examples/`, each with its code."""

from __future__ import annotations

import ast
from pathlib import Path

from pages.reference import ROOT, first_line
from soccer_env.train.examples.__main__ import PAGES

FOLDER = ROOT / "train" / "examples"


def examples() -> list[Path]:
    """Return the files of the examples."""
    return sorted(file for file in FOLDER.glob("*.py") if not file.stem.startswith("__"))


def page(file: Path) -> str:
    """Return the page of an example: its docstring and its code."""
    source = file.read_text(encoding="utf-8")
    text = ast.get_docstring(ast.parse(source)) or ""
    run = (
        f"`python -m soccer_env.train.examples {file.stem}` runs it from any folder.\n\n" if file.stem in PAGES else ""
    )
    told = text.replace("\nNeeds: ", "\nNeeds: `", 1).replace("\nReached: ", "`\n\nReached: ", 1)
    body = source.split('"""', 2)[2].strip()
    return f"# {file.stem}\n\n{told}\n\n{run}```python\n{body}\n```\n"


def pages() -> dict[str, str]:
    """Return every page of an example, and the one that names them, by path."""
    lines = ["# Examples", "", "Copy one and go on from there. [How they are run](../train/README.md#examples).", ""]
    lines += ["| example | what it is |", "|---|---|"]
    lines += [f"| [`{file.stem}`]({file.stem}.md) | {first_line(file)} |" for file in examples()]
    found = {"examples/index.md": "\n".join(lines) + "\n"}
    return found | {f"examples/{file.stem}.md": page(file) for file in examples()}


def navigation() -> list[object]:
    """Return the section of the examples."""
    return [{"Examples": ["examples/index.md", *({x.stem: f"examples/{x.stem}.md"} for x in examples())]}]
