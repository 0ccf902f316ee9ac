"""Show the fields of every dataclass, enumeration and record of numpy as a table, from the source itself.

An extension of griffe, which mkdocstrings reads the packages with. A field's meaning is the text below it, the help of
its `declare_setting(...)` or the comment behind it, whose [unit] gets a column of its own. A function under
`takes_fields_of(KIND)` or `init_takes_fields_of(KIND)` is shown as it is called: with the fields of KIND.
"""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import griffe

UNIT = re.compile(r"\[([^\]]+)\] ?(.*)", re.DOTALL)  # not of a range such as [0, 100]
RANGE = re.compile(r"^-?[\d.]+, ")
ENUMS = ("IntEnum", "Enum", "IntFlag")
RECORDS = ("TypedDict", "NamedTuple")


class Row(NamedTuple):
    """A field."""

    name: str
    kind: str  # what it may hold, or a record's dtype
    default: str  # "" without one
    meaning: str


@cache
def comments(file: Path) -> dict[int, tuple[str, bool]]:
    """Return the comment on each line of a file that has one, and whether nothing else stands there."""
    found = {}
    for token in tokenize.generate_tokens(io.StringIO(file.read_text(encoding="utf-8")).readline):
        if token.type == tokenize.COMMENT:
            found[token.start[0]] = (token.string.lstrip("# "), not token.line[: token.start[1]].strip())
    return found


def comment_at(file: Path, line: int) -> str:
    """Return the comment behind a line, with its continuation on the lines below."""
    found = comments(file)
    parts = [found[line][0]] if line in found and not found[line][1] else []
    while parts and found.get(line + len(parts), ("", False))[1]:
        parts.append(found[line + len(parts)][0])
    return " ".join(parts)


def cell(text: str) -> str:
    """Return a text as a cell of a table."""
    return " ".join(text.replace("|", "\\|").split()).replace("](", "] (")


def code(text: str) -> str:
    """Return code as a cell of a table."""
    return f"`{' '.join(text.split())}`" if text else ""


def split_unit(meaning: str) -> tuple[str, str]:
    """Return the unit that a comment begins with, "" for none, and the rest."""
    found = UNIT.match(meaning)
    return (found[1], found[2]) if found and not RANGE.match(found[1]) else ("", meaning)


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    """Return a table of Markdown, without columns that are empty in every row."""
    kept = [index for index in range(len(head)) if index == 0 or any(row[index] for row in rows)]
    lines = [head, tuple("---" for _ in head), *rows]
    return "\n".join("| " + " | ".join(line[index] for index in kept) + " |" for line in lines)


# Dataclasses and enumerations


def default_and_text(value: str, module: griffe.Module) -> tuple[str, str]:
    """Return the default and the help in the value of a field."""
    tree = ast.parse(value, mode="eval").body
    if not (
        isinstance(tree, ast.Call) and isinstance(tree.func, ast.Name) and tree.func.id in ("field", "declare_setting")
    ):
        return value, ""
    named = {word.arg: word.value for word in tree.keywords}
    if tree.func.id == "declare_setting":
        text = ast.unparse(tree.args[1])  # the help itself, or a name of it
        return ast.unparse(tree.args[0]), ast.literal_eval(value_in(module, text) or text)
    default = ast.unparse(named["default"]) if "default" in named else ""
    if "default_factory" in named:
        default = f"{ast.unparse(named['default_factory'])}()"
    metadata = named.get("metadata")
    said = dict(zip(metadata.keys, metadata.values)) if isinstance(metadata, ast.Dict) else {}
    texts = [ast.literal_eval(said[key]) for key in said if isinstance(key, ast.Constant) and key.value == "text"]
    return default, "".join(texts)


def value_in(module: griffe.Module, name: str) -> str:
    """Return the value of a name in a module, "" if it has none."""
    found = module.members.get(name)
    return str(found.value) if isinstance(found, griffe.Attribute) and found.value is not None else ""


def choices(module: griffe.Module, name: str) -> str:
    """Return the choices that a name stands for, the name itself if it stands for none."""
    value = value_in(module, name)
    return value if value.startswith("Literal[") else name


def row_of(attribute: griffe.Attribute) -> Row:
    """Return a field in the body of a class."""
    module = attribute.module
    default, text = default_and_text(str(attribute.value), module) if attribute.value is not None else ("", "")
    if attribute.docstring is not None:
        text = attribute.docstring.value
    file, line = attribute.filepath, attribute.endlineno or attribute.lineno
    text = text or (comment_at(file, line) if isinstance(file, Path) and line else "")
    kind = re.sub(r"\b[A-Z]\w+\b", lambda found: choices(module, found[0]), str(attribute.annotation or ""))
    return Row(attribute.name, kind, default, text)


def is_record(found: griffe.Class) -> bool:
    """Tell whether the annotated names of a class are fields."""
    return "dataclass" in found.labels or any(str(base).split("[")[0] in RECORDS for base in found.bases)


def classes_above(found: griffe.Class) -> list[griffe.Class]:
    """Return a class and those of the package that it inherits from, the last first."""
    try:
        above = found.mro()
    except ValueError:
        above = []
    return [*reversed([one for one in above if isinstance(one, griffe.Class)]), found]


def rows_of(found: griffe.Class) -> list[Row]:
    """Return the fields of a class, inherited ones first; a missing help is taken from the parent."""
    rows: dict[str, Row] = {}
    for one in classes_above(found):
        if not is_record(one):
            continue
        for attribute in one.attributes.values():
            name, annotation = attribute.name, str(attribute.annotation or "")
            if not annotation or name[0] == "_" or name.isupper() or "property" in attribute.labels:
                continue  # names in capitals belong to the class
            row = row_of(attribute)
            rows[name] = row if row.meaning or name not in rows else row._replace(meaning=rows[name].meaning)
    return list(rows.values())


def fields_table(rows: list[Row]) -> str:
    """Return the table of a class's fields."""
    cells = []
    for row in rows:
        unit, meaning = split_unit(row.meaning)
        cells.append((code(row.name), code(row.kind), code(row.default), cell(unit), cell(meaning)))
    return table(("field", "type", "default", "unit", "meaning"), cells)


def enum_table(found: griffe.Class) -> str:
    """Return the table of an enumeration's codes."""
    rows = [row_of(attribute) for attribute in found.attributes.values() if attribute.value is not None]
    return table(("name", "value", "meaning"), [(code(x.name), cell(x.default), cell(x.meaning)) for x in rows])


# Records of numpy


def record_rows(value: ast.expr, file: Path) -> Iterator[tuple[str, str, str, str, str, str]]:
    """Yield field, type, range, shape, unit and meaning of each entry of `ranged_record([...])`."""
    for item in value.elts if isinstance(value, ast.List) else ():
        if not (isinstance(item, ast.Tuple) and isinstance(item.elts[0], ast.Constant)):
            continue
        name, kind, *more = item.elts
        within = more.pop(0) if isinstance(kind, ast.Constant) else None  # a nested record has no range
        unit, meaning = split_unit(comment_at(file, item.end_lineno or item.lineno))
        text = kind.value if isinstance(kind, ast.Constant) else ast.unparse(kind)
        said, shape = (code(ast.unparse(part)) if part else "" for part in (within, more[0] if more else None))
        yield code(name.value), code(text), said, shape, cell(unit), cell(meaning)


def record_table(attribute: griffe.Attribute) -> str:
    """Return the table of a record's fields, "" for an attribute that is none."""
    file, first = attribute.filepath, attribute.lineno
    if not (isinstance(file, Path) and first and str(attribute.value).startswith("ranged_record(")):
        return ""
    for node in ast.parse(file.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and node.lineno == first and isinstance(node.value, ast.Call):
            rows = list(record_rows(node.value.args[0], file))
            said = comments(file).get(node.value.args[0].lineno, ("", True))  # behind the bracket: what it is about
            head = said[0] if rows and not said[1] else ""
            return f"{head}\n\n{table(('field', 'type', 'range', 'shape', 'unit', 'meaning'), rows)}" if rows else ""
    return ""


# Functions that take a declaration's fields


def declared(function: griffe.Function) -> str:
    """Return the name of the class that `takes_fields_of` names above a function, "" for none."""
    marks = [str(mark.value) for mark in function.decorators]
    found = [re.fullmatch(r"(?:init_)?takes_fields_of\((\w+)\)", mark) for mark in marks]
    return next((match[1] for match in found if match), "")


def spell_out(function: griffe.Function, kind: griffe.Class) -> None:
    """Give a function the parameters of its call, and their table."""
    declaring = {attribute.name: attribute for one in classes_above(kind) for attribute in one.attributes.values()}
    first = [one for one in function.parameters if one.name == "self"]
    positional, named = griffe.ParameterKind.positional_or_keyword, griffe.ParameterKind.keyword_only
    found = []
    for row in rows_of(kind):
        order = positional if "kw_only=False" in str(declaring[row.name].value) else named
        found.append(griffe.Parameter(row.name, annotation=row.kind, default=row.default, kind=order))
    found.sort(key=lambda one: one.kind is named)
    function.parameters = griffe.Parameters(*first, *found)
    append(function, fields_table(rows_of(kind)))


def append(thing: Any, text: str) -> None:
    """Put a table behind the docstring of something."""
    if text:
        before = thing.docstring.value if thing.docstring is not None else ""
        thing.docstring = griffe.Docstring(f"{before}\n\n{text}".strip(), parent=thing, parser=None)


class FieldTables(griffe.Extension):
    """Put tables of fields into the docstrings of a package, once all of it is read."""

    def __init__(self) -> None:
        self.told: list[griffe.Attribute] = []  # attributes shown in a table
        self.done: set[str] = set()  # modules; griffe comes by again for packages that are soft links

    def on_package(self, *, pkg: griffe.Module, **_: Any) -> None:
        """Go through all modules of a package; fields in a table have no entries of their own."""
        self.module(pkg)
        for attribute in self.told:
            attribute.docstring = None

    def module(self, module: griffe.Module) -> None:
        """Go through a module and those in it."""
        done = module.path in self.done
        self.done.add(module.path)
        for member in module.members.values():
            if isinstance(member, griffe.Module):
                self.module(member)
            elif done:
                continue
            elif isinstance(member, griffe.Class):
                self.of_class(member)
            elif isinstance(member, griffe.Function):
                self.of_function(member)
            elif isinstance(member, griffe.Attribute):
                self.of_attribute(member, module.name.endswith("types"))

    def of_class(self, found: griffe.Class) -> None:
        """Give a class the table of its fields."""
        for function in found.functions.values():
            self.of_function(function)
        if any(str(base).split(".")[-1] in ENUMS for base in found.bases):
            append(found, enum_table(found))
            self.told += found.attributes.values()
        elif is_record(found) and (rows := rows_of(found)):
            append(found, fields_table(rows))
            self.told += [found.attributes[row.name] for row in rows if row.name in found.attributes]
            defaults = {row.name: row.default for row in rows}
            for parameter in found.parameters:
                if str(parameter.default).startswith(("declare_setting(", "field(")):
                    parameter.default = defaults.get(parameter.name)

    def of_function(self, function: griffe.Function) -> None:
        """Show a function with the settings that it takes."""
        name = declared(function)
        if name:
            kind = function.module.members.get(name)
            kind = kind.final_target if kind is not None and kind.is_alias else kind
            if isinstance(kind, griffe.Class):
                spell_out(function, kind)

    def of_attribute(self, attribute: griffe.Attribute, comment_tells: bool) -> None:
        """Give a record the table of its fields, and a constant among records its comment."""
        found = record_table(attribute)
        if found:
            append(attribute, found)
            attribute.value = None  # the table says it
        elif comment_tells and attribute.docstring is None and isinstance(attribute.filepath, Path):
            append(attribute, comment_at(attribute.filepath, attribute.lineno or 0))
