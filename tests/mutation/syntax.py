"""Find a piece of Python in a file by its syntax and put another in its place: layout and comments do not matter."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from textwrap import dedent, indent
from typing import NamedTuple


class Place(NamedTuple):
    """Where a piece of source stands, in lines from 1 and bytes from 0, and whether it is an expression."""

    first_line: int
    first_byte: int
    last_line: int
    last_byte: int
    is_expression: bool


def replace(source: str, original: str, replacement: str, where: str = "") -> str:
    """Return the source of a file with a piece of it replaced, the rest as it was; ValueError if it is not there once.

    Both pieces are expressions, or both are statements; a keyword argument `name=value` counts as a statement. An
    empty replacement leaves nothing. `where` names the one function or class to look in.
    """
    found = list(places(ast.parse(source), original, replacement, where))
    if len(found) != 1:
        raise ValueError(f"{original!r} stands {len(found)} times in {where or 'the file'}")
    return put(source, found[0], replacement)


def put(source: str, place: Place, replacement: str) -> str:
    """Return the source of a file with something else at a place."""
    lines = source.encode().splitlines(keepends=True)
    head = b"".join(lines[: place.first_line - 1]) + lines[place.first_line - 1][: place.first_byte]
    tail = lines[place.last_line - 1][place.last_byte :] + b"".join(lines[place.last_line :])
    if place.is_expression:
        new = f"({replacement.strip()})"
    else:
        new = indent(dedent(replacement).strip() or "pass", " " * place.first_byte).strip()
    return (head + new.encode() + tail).decode()


def places(tree: ast.AST, original: str, replacement: str, where: str) -> Iterator[Place]:
    """Yield where a piece of source stands in a tree, or in the functions and classes of one name."""
    expressions = [expression_of(piece) for piece in (original, replacement)]
    for root in roots(tree, where):
        if None not in expressions:
            yield from (place_of(node, node) for node in ast.walk(root) if same(node, expressions[0]))
            continue
        wanted = ast.parse(dedent(original)).body
        for body in bodies(root):
            for start in range(len(body) - len(wanted) + 1):
                if all(map(same, body[start : start + len(wanted)], wanted)):
                    yield place_of(body[start], body[start + len(wanted) - 1])
        keyword = keyword_of(original)
        yield from (place_of(node, node) for node in ast.walk(root) if same(node, keyword))


def roots(tree: ast.AST, where: str) -> Iterator[ast.AST]:
    """Yield what to look in: the whole tree, or the functions and classes of a name."""
    if not where:
        yield tree
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name == where:
            yield node


def bodies(tree: ast.AST) -> Iterator[list[ast.stmt]]:
    """Yield every block of statements."""
    for node in ast.walk(tree):
        for _, value in ast.iter_fields(node):
            if isinstance(value, list) and value and isinstance(value[0], ast.stmt):
                yield value


def expression_of(piece: str) -> ast.AST | None:
    """Return the tree of an expression, or None if the piece is none."""
    try:
        return ast.parse(piece.strip(), mode="eval").body
    except SyntaxError:
        return None


def keyword_of(piece: str) -> ast.AST | None:
    """Return the tree of a keyword argument, or None if the piece is none."""
    call = expression_of(f"call({piece.strip()})")
    return call.keywords[0] if isinstance(call, ast.Call) and len(call.keywords) == 1 and not call.args else None


def same(one: ast.AST, other: ast.AST | None) -> bool:
    """Say whether two trees are the same, wherever they stand."""
    return type(one) is type(other) and ast.dump(one) == ast.dump(other)


def place_of(first: ast.AST, last: ast.AST) -> Place:
    """Return the place from the beginning of one node to the end of another."""
    begins = first.lineno, first.col_offset  # type: ignore[attr-defined]  # expressions, statements, keywords have them
    return Place(*begins, last.end_lineno, last.end_col_offset, isinstance(first, ast.expr))  # type: ignore[attr-defined]
