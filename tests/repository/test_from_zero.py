"""The tutorial: its blocks, pasted one after the other into one plain prompt, run in a shortened form."""

import re
import sys
from code import InteractiveConsole
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from soccer_env.train.command.command_line import main
from tests.repository.test_readme import TEXTS, blocks, commands

pytest.importorskip("torch")
pytest.importorskip("pygame")

PAGE = "train/FROM_ZERO.md"
SHORTER = {
    "range(7)": "range(1)",
    "286_720": "1",
    "matches=20": "matches=2",
    "minutes=4": "minutes=0.1",
    "range(500)": "range(50)",
}
SHORTER_COMMANDS = {"--matches": "2", "--minutes": "0.1", "--start": "0.5"}


class Prompt(InteractiveConsole):
    """Python's prompt, into which lines are pasted: an error is raised."""

    def showtraceback(self) -> None:
        raise  # called where it is handled

    def showsyntaxerror(self, filename: str | None = None, **_: Any) -> None:
        raise  # the same

    def paste(self, text: str) -> None:
        for line in [*text.splitlines(), ""]:
            self.push(line)


@pytest.mark.slow
def test_the_tutorial_runs_from_its_first_block_to_its_last(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    session = ModuleType("from_zero")
    monkeypatch.setitem(sys.modules, "from_zero", session)
    echoed: list[object] = []
    monkeypatch.setattr(sys, "displayhook", lambda value: None if value is None else echoed.append(value))
    prompt = Prompt(session.__dict__, PAGE)
    parts = [(block.line, "python", block.text) for block in blocks(TEXTS[PAGE], "python")]
    parts += [(block.line, "bash", block.text) for block in blocks(TEXTS[PAGE], "bash")]
    for line, language, text in sorted(parts):
        if language == "python":
            for long, short in SHORTER.items():
                text = text.replace(long, short)
            prompt.paste(text)
            assert echoed == [], f"the block at {PAGE} line {line} fills the prompt"
        for words in commands(text) if language == "bash" else ():
            if words[0] == "soccer" and words[1] != "warm-up":
                assert main(shortened(words[1:])) == 0, f"{PAGE} line {line}"
    assert {file.name for file in tmp_path.glob("*.*")} >= {"first.html", "mine.safetensors", "mine.html", "mine.png"}
    assert (tmp_path / "runs/mine/report.html").is_file()


@pytest.mark.parametrize("text", ["for _ in range(3):\n    pass\nx = 1\n", "1 / 0\n"])
def test_what_a_prompt_refuses_is_raised(text: str) -> None:
    with pytest.raises((SyntaxError, ZeroDivisionError)):
        Prompt({}).paste(text)


def shortened(words: list[str]) -> list[str]:
    """Return the words of a command with less to play."""
    return [SHORTER_COMMANDS.get(before, word) for before, word in zip(["", *words], words)]


def test_what_the_tutorial_is_shortened_by_stands_in_it() -> None:
    text = TEXTS[PAGE]
    assert [long for long in SHORTER if long not in text] == []
    assert re.search(r"^## 1\. Install", text, re.MULTILINE)
