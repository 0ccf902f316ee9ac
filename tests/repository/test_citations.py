"""Whatever a docstring, a comment or a page names as a file is there, and nobody is sent to what only some can read."""

import ast
import io
import re
import subprocess
import tokenize
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
CITED = re.compile(r"(?<![\w/*<{.-])((?:\.\./)*[A-Za-z_][\w/-]*\.(?:py|md))\b(?!\()")
ELSEWHERE = re.compile(r"\bissues? #?\d|\b(?:DESIGN|TRUST|ENGINE|FOUND|STYLE|CLAIMS)\b(?:\.md|, S\d)", re.IGNORECASE)

# Names of files that a reader is to make himself, or that other programs make.
EXAMPLES = {"train.py", "report.md", "tests/test_file.py", "beside.py", "lower.py", "upper.py"}


def tracked() -> list[str]:
    """Return the paths of all files of the repository, new ones included."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    return [name for name in listed if (ROOT / name).exists()]


def prose(source: str) -> str:
    """Return the comments and docstrings of Python source."""
    tokens = tokenize.generate_tokens(io.StringIO(source).readline)
    texts = [token.string for token in tokens if token.type == tokenize.COMMENT]
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            texts.append(ast.get_docstring(node) or "")
    return "\n".join(texts)


@cache
def text_of(name: str) -> str:
    """Return what a file says to its readers."""
    text = (ROOT / name).read_text(encoding="utf-8")
    return prose(text) if name.endswith(".py") else text


def readable(names: list[str]) -> list[str]:
    """Return the files that are written for readers; the changelog may speak of what is gone."""
    return [name for name in names if name.endswith((".py", ".md", ".toml", "Makefile")) and name != "CHANGELOG.md"]


def is_there(cited: str, names: list[str]) -> bool:
    """Return whether some file of the repository has this path or this end of a path."""
    path = cited.replace("../", "")
    return any(name == path or name.endswith(f"/{path}") for name in names)


def test_every_file_that_is_named_exists() -> None:
    names = tracked()
    missing = {
        f"{name}: {cited}"
        for name in readable(names)
        for cited in CITED.findall(text_of(name))
        if cited not in EXAMPLES and "NAME" not in cited and not is_there(cited, names)
    }
    assert sorted(missing) == []


def test_nothing_refers_to_documents_that_are_not_in_the_repository() -> None:
    found = {f"{name}: {match}" for name in readable(tracked()) for match in ELSEWHERE.findall(text_of(name))}
    assert sorted(found) == []


def test_a_missing_document_is_noticed() -> None:
    assert CITED.findall("see soccer_env/match/match.py, ../gone.md and robots.x.py()") == [
        "soccer_env/match/match.py",
        "../gone.md",
    ]
    assert not is_there("gone.md", tracked()) and is_there("match.py", tracked())
    assert (
        ELSEWHERE.search("[DESIGN.md]") and ELSEWHERE.search("all below: issue 2") and ELSEWHERE.search("CLAIMS, S26")
    )
