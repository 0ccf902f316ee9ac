"""Find a piece of Python in a file by its syntax and put another in its place: layout and comments do not matter."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from textwrap import dedent, indent
from typing import Any


def replace(source: str, original: str, replacement: str, where: str = "") -> str:
    """Return the source of a file with a piece of it replaced, the rest as it was; ValueError if it is not there once.

    Both pieces are expressions, or both are statements; a keyword argument `name=value` counts as a statement. An
    empty replacement leaves nothing. `where` names the one function or class to look in.
    """
    nodes = [*ast.walk(ast.parse(source))]
    named = [node for node in nodes if isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name == where]
    roots = named if where else nodes[:1]
    found = [run for root in roots for piece in readings(original, replacement) for run in runs(root, piece)]
    if len(found) != 1:
        raise ValueError(f"{original!r} stands {len(found)} times in {where or 'the file'}")
    return put(source, found[0], replacement)


def put(source: str, run: list[Any], replacement: str) -> str:
    """Return the source of a file with something else from the beginning of a run of nodes to its end."""
    first, last = run[0], run[-1]
    lines = source.encode().splitlines(keepends=True)
    head = b"".join(lines[: first.lineno - 1]) + lines[first.lineno - 1][: first.col_offset]
    tail = lines[last.end_lineno - 1][last.end_col_offset :] + b"".join(lines[last.end_lineno :])
    new = indent(dedent(replacement).strip() or "pass", " " * first.col_offset).strip()
    return (head + (f"({new})" if isinstance(first, ast.expr) else new).encode() + tail).decode()


def readings(original: str, replacement: str) -> Iterator[list[ast.AST]]:
    """Yield what a piece of source can be: an expression, else statements or a keyword argument."""
    try:
        yield [ast.parse(piece.strip(), mode="eval").body for piece in (original, replacement)][:1]
    except SyntaxError:
        statements = ast.parse(dedent(original)).body
        yield [*statements]
        match statements:
            case [ast.Assign(targets=[ast.Name(id=name)], value=value)]:
                yield [ast.keyword(name, value)]


def runs(root: ast.AST, piece: list[ast.AST]) -> Iterator[list[Any]]:
    """Yield where a piece of source stands: a node, or statements of a block that follow each other."""
    for node in ast.walk(root):
        blocks = [block for _, block in ast.iter_fields(node) if isinstance(block, list)]
        for block in [[node]] if len(piece) == 1 else blocks:
            for start in range(len(block) - len(piece) + 1):
                run = block[start : start + len(piece)]
                if all(type(one) is type(other) and ast.dump(one) == ast.dump(other) for one, other in zip(run, piece)):
                    yield run
