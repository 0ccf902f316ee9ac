"""Every place where a developer could have slipped, and what would stand there: one replaced node of a syntax tree.

Whatever only words, types or pictures of it depend on is left alone: docstrings, annotations, imports, texts, messages
of errors, `__repr__`, `if TYPE_CHECKING`. Boundaries (< for <=) are moved where whole numbers are compared; for others,
where equality hardly happens, the comparison is turned round.
"""

from __future__ import annotations

import ast
import hashlib
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from tests.mutation.syntax import put

FOLDERS = ("soccer_env", "baselines", "agents", "train/evaluate")
LINKS = ("soccer_env/baselines/", "soccer_env/agents/", "soccer_env/train/")  # soft links, where a checkout has them
WORDING = ("print", "warn", "warning", "info", "debug", "one_line", "ValueError", "TypeError", "RuntimeError")
ARITHMETIC = {"Add": "Sub", "Sub": "Add", "Mult": "Div", "Div": "Mult", "Mod": "Mult", "Pow": "Mult"}
BOUNDARY = {"Lt": "LtE", "LtE": "Lt", "Gt": "GtE", "GtE": "Gt", "Eq": "NotEq", "NotEq": "Eq"}
TURNED = {"Lt": "Gt", "LtE": "GtE", "Gt": "Lt", "GtE": "LtE"}
TURNED |= {"Is": "IsNot", "IsNot": "Is", "In": "NotIn", "NotIn": "In"}
WORDS = ("sin cos", "sine cosine", "min max", "minimum maximum", "floor ceil", "HOME AWAY", "home away", "left right")
WORDS += ("length width", "forward sideways", "first last", "before after", "LEFT RIGHT")
PARTNERS = {word: other for pair in map(str.split, WORDS) for word, other in (pair, pair[::-1])}
DROPPED_CALLS = ("wrap", "radians", "degrees", "abs", "fabs", "sqrt", "floor", "ceil")
DRAWS = ("normal", "uniform")
ANGLES = ("angle", "bearing", "heading", "turn", "spin", "twist")


class Site(NamedTuple):
    """A place in a file, what stands there, and what could stand there by a slip."""

    file: str
    function: str
    kind: str
    number: int  # how many equal ones stand before it in the file
    original: str
    options: tuple[str, ...]
    node: Any

    def rank(self, seed: int) -> str:
        """Return a random text for a seed; it stays the same when other places in the source change."""
        words = f"{seed} {self.file} {self.function} {self.kind} {self.original} {self.number}"
        return hashlib.sha256(words.encode()).hexdigest()

    def replacement(self, seed: int) -> str:
        """Return one of the options, by the seed."""
        return self.options[int(self.rank(seed), 16) // 7 % len(self.options)]


def draw(root: Path, seed: int, only: str = "") -> Iterator[Site]:
    """Yield all sites of the checkout, each once, uniformly at random, those first that a seed draws first."""
    files = [file for folder in FOLDERS for file in sorted((root / folder).rglob("*.py"))]
    names = [file.relative_to(root).as_posix() for file in files]
    wanted = [name for name in names if name.startswith(only) and not name.startswith(LINKS)]
    sites = [site for name in wanted for site in sites_of(name, (root / name).read_text(encoding="utf-8"))]
    yield from sorted(sites, key=lambda site: site.rank(seed))


def changed(source: str, site: Site, replacement: str) -> str:
    """Return the source of a file with the slip in it; SyntaxError if there is none, ValueError if it is the same."""
    text = put(source, [site.node], replacement)
    if ast.dump(ast.parse(text)) == ast.dump(ast.parse(source)):
        raise ValueError("nothing changes")
    compile(text, site.file, "exec")
    return text


def sites_of(file: str, source: str) -> Iterator[Site]:
    """Yield the sites of a file in the order of its text."""
    tree = ast.parse(source)
    names = {"min", "max", *(node.id for node in ast.walk(tree) if isinstance(node, ast.Name))}
    imports = (node.names for node in ast.walk(tree) if isinstance(node, ast.ImportFrom))
    names |= {alias.asname or alias.name for aliases in imports for alias in aliases}
    seen: Counter[tuple[str, str, str]] = Counter()
    for node, function in walk(tree, ""):
        for kind, options in slips(node, names):
            spot = node.test if kind == "condition" else node  # type: ignore[attr-defined]  # of If and IfExp
            original = ast.unparse(spot)
            key = function, kind, original
            if others := tuple(option for option in options if option != original):
                yield Site(file, function, kind, seen[key], original, others, spot)
                seen[key] += 1


def walk(node: ast.AST, function: str) -> Iterator[tuple[ast.AST, str]]:
    """Yield the nodes in which slips are made, each with the function or class around it."""
    for field, value in ast.iter_fields(node):
        if field in ("annotation", "returns", "decorator_list", "type_params", "msg", "format_spec"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if not isinstance(child, ast.AST) or is_wording(child):
                continue
            yield child, function
            inner = child.name if isinstance(child, ast.FunctionDef | ast.ClassDef) else ""
            yield from walk(child, f"{function}.{inner}".strip(".") if inner else function)


def is_wording(node: ast.AST) -> bool:
    """Tell whether a node only says something: texts, errors, annotations, imports."""
    if isinstance(node, ast.FunctionDef) and node.name in ("__repr__", "__str__"):
        return True
    if isinstance(node, ast.If) and ast.unparse(node.test) in ("TYPE_CHECKING", "__name__ == '__main__'"):
        return True
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        return name_of(node.value.func) in WORDING
    if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]).startswith("__"):
        return True
    return isinstance(node, ast.Raise | ast.Assert | ast.JoinedStr | ast.Import | ast.ImportFrom | ast.match_case)


def name_of(node: ast.AST) -> str:
    """Return the last part of a name, or nothing."""
    return node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ""


def partner(name: str) -> str:
    """Return the name that is easily taken for another: y for x, cos for sin, AWAY for HOME; or nothing."""
    if name in PARTNERS:
        return PARTNERS[name]
    start, end = name[:-1], name[-1:]
    if end in ("x", "y") and (start in ("", "v", "d", "u", "f", "n") or start.endswith("_")):
        return start + ("y" if end == "x" else "x")
    start, _, end = name.rpartition("_")
    return f"{start}_{PARTNERS[end]}" if start and end in PARTNERS else ""


def with_fields(node: ast.AST, **fields: object) -> str:
    """Return the text of a node with some of its fields changed."""
    return ast.unparse(type(node)(**{**vars(node), **fields}))


def slips(node: ast.AST, names: set[str]) -> Iterator[tuple[str, list[str]]]:
    """Yield each kind of slip that can be made in a node, with what could stand there."""
    match node:
        case ast.BinOp(left=one, right=other) | ast.AugAssign(target=one, value=other):
            operation = ARITHMETIC.get(type(node.op).__name__)
            if operation and not any(map(is_text, (one, other))):
                yield "arithmetic", [with_fields(node, op=getattr(ast, operation)())]
        case ast.Compare():
            yield "comparison", comparisons(node)
        case ast.BoolOp(op=operator, values=parts):
            less = [with_fields(node, values=[*parts[:i], *parts[i + 1 :]]) for i in range(len(parts))]
            yield "logic", [with_fields(node, op=ast.Or() if isinstance(operator, ast.And) else ast.And()), *less]
        case ast.UnaryOp(op=operator, operand=inner):
            yield "sign" if isinstance(operator, ast.USub) else "logic", [ast.unparse(inner)]
        case ast.Constant(value=bool(value)):
            yield "number", [str(not value)]
        case ast.Constant(value=int(value)):
            yield "number", [str(value + 1), str(value - 1)]
        case ast.Constant(value=float(value)) if value:
            yield "number", [repr(1.5 * value), repr(0.5 * value), "0.0"]
        case ast.Name(id=name, ctx=ast.Load()) if partner(name) in names:
            yield "side", [partner(name)]
        case ast.Attribute(attr=name) if partner(name):
            yield "side", [with_fields(node, attr=partner(name))]
        case ast.Call():
            yield from calls(node, names)
        case ast.Subscript(value=whole, slice=ast.Name(id=name), ctx=ast.Load()) if len(name) <= 2:
            yield "off by one", [f"{ast.unparse(whole)}[{name} - 1]"]
        case ast.Assign(targets=[ast.Attribute() | ast.Subscript(), *_]) | ast.Expr(value=ast.Call()):
            yield "lost statement", ["pass"]
        case ast.Return(value=ast.Compare() | ast.BoolOp()):
            yield "constant", ["return True", "return False"]
        case ast.Return(value=ast.BinOp()):
            yield "constant", ["return 0.0"]
        case ast.If(test=test) | ast.IfExp(test=test):
            yield "condition", ["True", "False", f"not ({ast.unparse(test)})"]
    if isinstance(node, ast.AugAssign):
        yield "lost statement", ["pass"]


def is_text(node: ast.AST) -> bool:
    """Tell whether a node is a text, or wraps one."""
    return isinstance(node, ast.JoinedStr) or isinstance(getattr(node, "value", 0), str)


def comparisons(node: ast.Compare) -> list[str]:
    """Return the comparison with another operator, for each of its operators."""
    text = ast.unparse(node)
    whole = not re.search(r"\d\.\d", text) and bool(re.search(r"\b\d|len\(|count|number|steps?\b|\b[mrijn]\b", text))
    others = [(BOUNDARY if whole else BOUNDARY | TURNED).get(type(operator).__name__) for operator in node.ops]
    return [
        with_fields(node, ops=[*node.ops[:i], getattr(ast, other)(), *node.ops[i + 1 :]])
        for i, other in enumerate(others) if other
    ]  # fmt: skip


def calls(node: ast.Call, names: set[str]) -> Iterator[tuple[str, list[str]]]:
    """Yield a call with two arguments exchanged, one negated, a lost noise, a fixed seed."""
    name, given = name_of(node.func), node.args
    if name in DROPPED_CALLS and len(given) == 1:
        yield "unit", [ast.unparse(given[0])]
    if name in DRAWS:
        streams = sorted(word for word in names if word.isupper() and len(word) > 2 and word not in PARTNERS)
        used = [name_of(arg) for arg in given if name_of(arg).isupper()]
        others = [word for word in streams if used and word not in used][:2]
        yield "noise", ["0.0", *(with_fields(node, args=[*given[:-1], ast.Name(word)]) for word in others)]
    if name == "range" and 1 <= len(given) <= 2:
        first, last = ("0", *map(ast.unparse, given)) if len(given) == 1 else map(ast.unparse, given)
        yield "off by one", [f"range({first} + 1, {last})", f"range({first}, {last} - 1)"]
    for i, (one, other) in enumerate(zip(given, given[1:])):
        if type(one) is type(other) and isinstance(one, ast.Name | ast.Attribute | ast.Subscript) and alike(one, other):
            yield "order", [with_fields(node, args=[*given[:i], other, one, *given[i + 2 :]])]
    for i, argument in enumerate(given):
        word = name_of(argument)
        if partner(word).endswith(("x", "y", "sine")) or word.split("_")[-1] in ANGLES:
            yield "sign", [with_fields(node, args=[*given[:i], ast.UnaryOp(ast.USub(), argument), *given[i + 1 :]])]
    for i, keyword in enumerate(node.keywords):
        if keyword.arg == "seed" and not isinstance(keyword.value, ast.Constant):
            fixed = ast.keyword("seed", ast.Constant(0))
            yield "seed", [with_fields(node, keywords=[*node.keywords[:i], fixed, *node.keywords[i + 1 :]])]


def alike(one: ast.AST, other: ast.AST) -> bool:
    """Tell whether two arguments are of one kind, by their names."""
    if isinstance(one, ast.Name):
        return partner(name_of(one)) == name_of(other) or len(name_of(one)) == len(name_of(other)) == 1
    return ast.dump(one.value) == ast.dump(other.value)  # type: ignore[attr-defined]
