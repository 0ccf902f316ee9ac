"""The notebooks, made from the pages of the same names and run for their outputs: `make notebooks`.

    python -m soccer_env.train.pages.notebooks [PAGE ...]    make all notebooks, or some, and run them
    python -m soccer_env.train.pages.notebooks write         make them again without running: outputs stay where no code
                                                             of the page has changed

Text of a page is a text cell, a block of Python or of commands a code cell. Commands that install stay text, as they
come before the kernel. The site shows a page with the outputs of its notebook.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import nbformat
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output

from soccer_env.guards.whole_files import write_atomically

FOLDER = Path(__file__).resolve().parents[1]
PAGES = ("FROM_ZERO.md", "WATCH_AND_PLOT.md", "TRAIN_AND_RANK.md")
BLOCK = re.compile(r"^```(python|bash)\n(.*?)\n```\n", re.MULTILINE | re.DOTALL)
INSTALLS = "pip install"
BASH = "%%bash -e\n"  # -e: a command that fails ends the cell, and is an error
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
COLOURS = re.compile(r"\x1b\[[0-9;]*m")  # of a terminal: the kernel asks commands for them
SHOWN = ("image/png", "text/plain")  # forms of an output; the first of them that an output has is stored

Notebook = Any  # nbformat's node: a dict whose keys are attributes, too


def notebook_of(page: str) -> Notebook:
    """Return the notebook of a page, a text of Markdown, without outputs."""
    cells = list(cells_of(page))
    for number, cell in enumerate(cells, 1):
        cell.id = f"cell-{number}"  # nbformat draws others each time
    return new_notebook(cells=cells, metadata={"kernelspec": KERNEL, "language_info": {"name": "python"}})


def cells_of(page: str) -> Iterator[Notebook]:
    """Yield the cells of a page in order."""
    end = 0
    for block in BLOCK.finditer(page):
        language, code = block.groups()
        if INSTALLS not in code:
            yield from text_cells(page[end : block.start()])
            yield new_code_cell(code if language == "python" else BASH + code)
            end = block.end()
    yield from text_cells(page[end:])


def text_cells(text: str) -> list[Notebook]:
    """Return a cell with a text, none between two blocks of code."""
    return [new_markdown_cell(text.strip())] if text.strip() else []


def code_cells(notebook: Notebook) -> list[Notebook]:
    """Return the code cells of a notebook."""
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def run(notebook: Notebook, folder: Path) -> None:
    """Run a notebook in a folder by this Python, and give its cells plain outputs; an error of a cell is raised."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ.get('PATH', '')}"  # `soccer` lies beside Python
    metadata = dict(notebook.metadata)
    client = NotebookClient(
        notebook,
        timeout=None,
        record_timing=False,
        coalesce_streams=True,
        resources={"metadata": {"path": str(folder)}},
    )
    client.execute(env={**os.environ, "PATH": path, "SOCCER_ENV_QUIET": "1"})
    notebook.metadata = nbformat.from_dict(metadata)  # without the versions of this machine
    for cell in code_cells(notebook):
        cell.outputs = [plain_output(one) for one in cell.outputs if one.get("name") != "stderr"]  # progress


def plain_output(output: Notebook) -> Notebook:
    """Return an output as text or as a PNG alone."""
    if output.output_type == "stream":
        return new_output("stream", name=output.name, text=COLOURS.sub("", output.text))
    kind = next(kind for kind in SHOWN if kind in output.data)
    return new_output("display_data", data={kind: output.data[kind].rstrip("\n")})


def keep_outputs(notebook: Notebook, stored: Notebook) -> None:
    """Give the code cells the outputs of the stored ones if no code has changed: a cell depends on those above it."""
    cells, before = code_cells(notebook), code_cells(stored)
    if [cell.source for cell in cells] == [cell.source for cell in before]:
        for cell, old in zip(cells, before):
            cell.outputs, cell.execution_count = old.outputs, old.execution_count


def file_of(page: str) -> Path:
    """Return the file of the notebook of a page, which lies beside it."""
    return (FOLDER / page).with_suffix(".ipynb")


def read(page: str) -> Notebook:
    """Return the stored notebook of a page."""
    return nbformat.read(file_of(page), as_version=4)


def main(words: list[str]) -> None:
    """Make the notebooks of the pages that are named, or of all; "write": without running them."""
    only_write = words == ["write"]
    for page in PAGES if only_write else words or PAGES:
        notebook = notebook_of((FOLDER / page).read_text(encoding="utf-8"))
        if not only_write:
            with TemporaryDirectory() as folder:
                run(notebook, Path(folder))
        elif file_of(page).exists():
            keep_outputs(notebook, read(page))
        write_atomically(file_of(page), nbformat.writes(notebook) + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])
