"""Every file whose kernels use one-letter records says at its head what they are: nobody has to guess k, s and w."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ("soccer_env", "baselines", "agents", "train")
LETTERS = ("k", "s", "w", "play")  # constants, sensors, memory; how a team plays


def files() -> list[Path]:
    """Return the files of the product."""
    return [file for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*.py"))]


def is_kernel(node: ast.AST) -> bool:
    """Return whether a function is compiled."""
    if not isinstance(node, ast.FunctionDef):
        return False
    return any(isinstance(mark, ast.Name) and mark.id in ("compiled", "inlined") for mark in node.decorator_list)


def letters_of(tree: ast.Module) -> set[str]:
    """Return those of LETTERS that the kernels of a file take or set."""
    found = set()
    for kernel in filter(is_kernel, ast.walk(tree)):
        for node in ast.walk(kernel):
            if isinstance(node, ast.arg):
                found.add(node.arg)
            elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                found.add(node.id)
    return found & set(LETTERS)


def explained(tree: ast.Module) -> set[str]:
    """Return those of LETTERS that the docstring of a file explains, as `k`: ..."""
    text = ast.get_docstring(tree) or ""
    return {letter for letter in LETTERS if f"`{letter}`: " in text}


@pytest.mark.parametrize("file", files(), ids=lambda file: str(file.relative_to(ROOT)))
def test_a_file_explains_the_letters_that_it_uses_and_no_others(file: Path) -> None:
    tree = ast.parse(file.read_text(encoding="utf-8"))
    assert explained(tree) == letters_of(tree)


def test_letters_are_found_where_kernels_use_them() -> None:
    source = '"""`k`: x."""\n@inlined\ndef f(robot, k):\n    s = 1\n\ndef g(w):\n    play = w\n'
    assert letters_of(ast.parse(source)) == letters_of(ast.parse(source.replace("inlined", "compiled")))
    assert letters_of(ast.parse(source)) == {"k", "s"}
    assert explained(ast.parse(source)) == {"k"}
