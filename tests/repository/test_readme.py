"""Every Python example of the README runs, and every command in it can be typed."""

import re
import sys
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
EXECUTABLES = {"make", "soccer", "pip", "python"}


class Block(NamedTuple):
    """A fenced block of Markdown and the line on which its first line stands."""

    text: str
    line: int


def blocks(markdown: str, language: str) -> list[Block]:
    """Return the fenced blocks of one language, those of a list item without their indentation."""
    found = []
    for match in re.finditer(r"^([ ]*)(`{3,})([^`\n]*)\n(.*?)^\1\2[ ]*$", markdown, re.MULTILINE | re.DOTALL):
        indent, _, info, text = match.groups()
        if info.split()[:1] == [language]:
            lines = [line.removeprefix(indent) for line in text.splitlines()]
            found.append(Block("\n".join(lines) + "\n", markdown[: match.start(4)].count("\n") + 1))
    return found


def commands(shell: str) -> list[list[str]]:
    """Return the words of each command of a shell block, without comments, prompts and variable settings."""
    found = []
    for line in shell.replace("\\\n", " ").splitlines():
        for part in re.split(r"&&|\|\||[;|]", re.sub(r"(^|\s)#.*", "", line)):
            words = part.removeprefix("$ ").split()
            while words and re.fullmatch(r"\w+=\S*", words[0]):
                words.pop(0)
            if words:
                found.append(words)
    return found


def run_block(block: Block, name: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Execute a block as a module of its own, in a file whose line numbers are the README's."""
    module = ModuleType(name)
    file = folder / f"{name}.py"
    source = "\n" * (block.line - 1) + block.text
    file.write_text(source, encoding="utf-8")
    module.__file__ = str(file)
    monkeypatch.setitem(sys.modules, name, module)  # dataclasses and protocols look their module up
    monkeypatch.chdir(folder)
    exec(compile(source, str(file), "exec"), module.__dict__)


@pytest.mark.parametrize("block", [pytest.param(block, id=f"line {block.line}") for block in blocks(README, "python")])
def test_python_example_runs(block: Block, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run_block(block, f"readme_line_{block.line}", tmp_path, monkeypatch)


def test_commands_can_be_typed() -> None:
    typed = [words for block in blocks(README, "bash") for words in commands(block.text)]
    assert [words for words in typed if words[0] not in EXECUTABLES] == []
    targets = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    assert [words for words in typed if words[0] == "make" and not set(words[1:]) <= targets] == []


def test_the_two_first_commands_are_there_and_ci_runs_the_test_command() -> None:
    typed = [words for block in blocks(README, "bash") for words in commands(block.text)]
    assert ["make", "match"] in typed
    assert ["make", "test"] in typed
    assert "part make test\n" in (ROOT / ".ci/run").read_text(encoding="utf-8")


EXAMPLE = """
```bash
$ make match   # plays
SEED=1 soccer evaluate \\
    --out runs/x && rm -rf runs/x
```
```text
not python
```
* item
  ```python
  from dataclasses import dataclass

  @dataclass
  class A:
      x: "int"
  assert A(1).x == 2, "wrong"
  ```
"""


def test_blocks_and_commands_are_found() -> None:
    (shell,) = blocks(EXAMPLE, "bash")
    assert commands(shell.text) == [
        ["make", "match"],
        ["soccer", "evaluate", "--out", "runs/x"],
        ["rm", "-rf", "runs/x"],
    ]
    (example,) = blocks(EXAMPLE, "python")
    assert example.line == 12
    assert example.text.startswith("from dataclasses")


def test_a_failing_example_fails_at_its_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (example,) = blocks(EXAMPLE, "python")
    with pytest.raises(AssertionError, match="wrong") as failure:
        run_block(example, "readme_example", tmp_path, monkeypatch)
    assert failure.traceback[-1].lineno == 16  # counted from 0: line 17 of the text above
