"""Whatever a docstring, a comment or a page names as a file is there, and so are the tests of SECURITY.md."""

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

PROMISE = re.compile(r"\| (\d+) \| [^|]+ \| `([^`]+)` \|")

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
    found = CITED.findall("see soccer_env/match/match.py, ../gone.md and robots.x.py()")
    assert found == ["soccer_env/match/match.py", "../gone.md"]
    assert not is_there("gone.md", tracked()) and is_there("match.py", tracked())
    assert all(map(ELSEWHERE.search, ("[DESIGN.md]", "all below: issue 2", "CLAIMS, S26")))


def test_every_promise_names_a_test_that_is_there() -> None:
    rows = PROMISE.findall((ROOT / "SECURITY.md").read_text(encoding="utf-8"))
    assert [int(number) for number, _ in rows] == list(range(1, 15))
    for _, test in rows:
        path, _, name = test.partition("::")
        assert (ROOT / path).exists(), test
        assert not name or f"def {name}(" in (ROOT / path).read_text(encoding="utf-8"), test
