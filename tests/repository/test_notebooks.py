"""The notebooks: each is what its page makes, holds plain outputs, and runs from its first cell to its last."""

import re
from code import InteractiveConsole
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from tests.repository.test_readme import blocks

nbformat: Any = pytest.importorskip("nbformat")
nbclient: Any = pytest.importorskip("nbclient")
pytest.importorskip("ipykernel")
notebooks: Any = import_module("soccer_env.train.pages.notebooks")

LARGEST = 200_000  # [bytes] of a file
OF_A_MACHINE = re.compile(r"(?:^|[\s'\"(])(?:/\w+/|[A-Z]:\\)|\x1b", re.MULTILINE)  # absolute paths, colours
SHORTENED = {  # what a test plays less of
    "FROM_ZERO.md": {
        "range(7)": "range(1)",
        "286_720": "1",
        "matches=20": "matches=2",
        "minutes=4": "minutes=0.1",
        "range(500)": "range(50)",
        "--matches 20": "--matches 2",
        "--minutes 4": "--minutes 0.1",
        "--start 5": "--start 0.5",
    },
    "WATCH_AND_PLOT.md": {
        "range(960)": "range(96)",
        "replay, 12.0": "replay, 2.0",
        "--matches 40": "--matches 2",
        "--minutes 2 ": "--minutes 0.1 ",
        "0:40:5": "0:40:2",
    },
    "TRAIN_AND_RANK.md": {
        "--steps 500000": "--steps 16384",
        "--evaluate-every 125000": "--evaluate-every 8192 --evaluate-matches 2",
        "--evaluate-minutes 1 ": "--evaluate-minutes 0.1 ",
        "matches=20": "matches=2",
        "minutes=2": "minutes=0.1",
    },
}
PAGE = """# One

```bash
pip install torch
```

Text.

```bash
soccer list leagues
```

```python
x = 1
print(x)
```

```text
no cell
```
"""


def text_of(page: str) -> str:
    return (notebooks.FOLDER / page).read_text(encoding="utf-8")


def kinds_of(cell: Any) -> set[str]:
    """Return the kinds of outputs of a cell: stream, image/png, text/plain."""
    return {kind for output in cell.outputs for kind in output.get("data", [output.output_type])}


@pytest.mark.parametrize("page", notebooks.PAGES)
def test_a_notebook_is_what_its_page_makes(page: str) -> None:
    stored, made = notebooks.read(page), notebooks.notebook_of(text_of(page))
    notebooks.keep_outputs(made, stored)
    again = f"python -m {notebooks.__name__} write, or {page} if its code has changed"
    assert nbformat.writes(made) == nbformat.writes(stored), again


@pytest.mark.parametrize("page", notebooks.PAGES)
def test_stored_outputs_are_small_plain_and_of_no_machine(page: str) -> None:
    file = notebooks.file_of(page)
    assert file.stat().st_size < LARGEST
    stored = notebooks.read(page)
    nbformat.validate(stored)
    assert {*stored.metadata} == {"kernelspec", "language_info"}
    for cell in stored.cells:
        assert cell.metadata == {}
    for cell in notebooks.code_cells(stored):
        assert kinds_of(cell) <= {"stream", "image/png", "text/plain"}
        texts = [one.get("text") or one.data.get("text/plain", "") for one in cell.outputs]
        assert [text for text in texts if OF_A_MACHINE.search(text)] == []


@pytest.mark.slow
@pytest.mark.parametrize("page", notebooks.PAGES)
def test_a_notebook_runs_from_its_first_cell_to_its_last(page: str, tmp_path: Path) -> None:
    for package in ("torch", "pygame", "matplotlib"):
        pytest.importorskip(package)
    text = text_of(page)
    for long, short in SHORTENED[page].items():
        assert long in text
        text = text.replace(long, short)
    notebook = notebooks.notebook_of(text)
    notebooks.run(notebook, tmp_path)
    ran, stored = map(notebooks.code_cells, (notebook, notebooks.read(page)))
    if any(cell.outputs for cell in stored):  # not after `write` with other code
        assert [kinds_of(cell) for cell in ran] == [kinds_of(cell) for cell in stored]
    if page == "FROM_ZERO.md":
        made = ("first.html", "mine.safetensors", "mine.html", "mine.png", "runs/mine/report.html")
        assert all((tmp_path / name).is_file() for name in made)


class Prompt(InteractiveConsole):
    """Python's prompt, into which lines are pasted; nothing is run, and what it cannot read is raised."""

    def runcode(self, code: Any) -> None:
        pass

    def showsyntaxerror(self, filename: str | None = None, **_: Any) -> None:
        raise  # called where it is handled

    def paste(self, text: str) -> None:
        for line in [*text.splitlines(), ""]:
            self.push(line)


def test_the_tutorial_can_be_pasted_into_a_prompt_which_refuses_what_lacks_an_empty_line() -> None:
    for block in blocks(text_of("FROM_ZERO.md"), "python"):
        Prompt().paste(block.text)
    with pytest.raises(SyntaxError):
        Prompt().paste("for _ in range(3):\n    pass\nx = 1\n")


def test_blocks_become_cells_but_for_those_that_install() -> None:
    notebook = notebooks.notebook_of(PAGE)
    nbformat.validate(notebook)
    assert [cell.source for cell in notebook.cells] == [
        "# One\n\n```bash\npip install torch\n```\n\nText.",
        "%%bash -e\nsoccer list leagues",
        "x = 1\nprint(x)",
        "```text\nno cell\n```",
    ]
    assert [cell.id for cell in notebook.cells] == ["cell-1", "cell-2", "cell-3", "cell-4"]


@pytest.mark.slow
def test_outputs_are_texts_and_pictures_and_stay_while_the_code_does(tmp_path: Path) -> None:
    page = PAGE.replace("soccer list leagues", "printf '\\033[1mout\\033[0m\\n'; echo err >&2").replace(
        "print(x)", "print(x)\nx"
    )
    notebook = notebooks.notebook_of(page)
    notebooks.run(notebook, tmp_path)
    shell, python = notebooks.code_cells(notebook)
    assert [dict(one) for one in shell.outputs] == [{"output_type": "stream", "name": "stdout", "text": "out\n"}]
    assert [one.output_type for one in python.outputs] == ["stream", "display_data"]
    assert python.outputs[1].data == {"text/plain": "1"}
    for old, new, stay in (("Text.", "Other text.", True), ("x = 1", "x = 2", False)):
        changed = notebooks.notebook_of(page.replace(old, new))
        notebooks.keep_outputs(changed, notebook)
        assert [bool(cell.outputs) for cell in notebooks.code_cells(changed)] == [stay, stay]
