"""The page of the command line: every command with its options, from the dataclasses of their settings."""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Iterator
from dataclasses import MISSING, Field, fields
from typing import Annotated, Any, get_args, get_origin

from pages.markdown import code, table
from soccer_env.train.command.command_line import kinds_of_settings

CONFIG = "TOML file with settings, or the name of a bundled one, such as first-win; other options override it."
MORE = {"train": [("`--config FILE`", "", "", CONFIG)]}  # what is read before the settings are


def texts(kind: type) -> dict[str, str]:
    """Return the text below each field of a dataclass, and of those that it inherits from."""
    found: dict[str, str] = {}
    for one in reversed(kind.__mro__):
        if "__dataclass_fields__" not in vars(one):
            continue
        kinds = {field.name: field.type for field in fields(one)}
        found |= {name: x.__metadata__[0].help for name, x in kinds.items() if get_origin(x) is Annotated}
        if one.__name__ == "Weights":  # has no source: made from the table of rewards
            continue
        body = ast.parse(textwrap.dedent(inspect.getsource(one))).body[0]
        inside = body.body if isinstance(body, ast.ClassDef) else []
        for line, below in zip(inside, inside[1:]):
            if isinstance(line, ast.AnnAssign) and isinstance(line.target, ast.Name) and isinstance(below, ast.Expr):
                found[line.target.id] = inspect.cleandoc(ast.literal_eval(below.value))
    return found


def options(name: str, kind: Any) -> Iterator[tuple[str, str, str, str]]:
    """Yield flag, value, default and meaning of each option of a command."""
    yield from MORE.get(name, [])
    meanings = texts(kind)
    for field in fields(kind):
        positional = "Positional" in str(field.type)
        flag = field.name.upper() if positional else f"--{field.name.replace('_', '-')}"
        yield (
            code(flag),
            code(takes(field.type)),
            code(default_of(field)),
            meanings.get(field.name, "").replace("\n", " "),
        )


def takes(kind: Any) -> str:
    """Return the kind of value of an option, "" for a switch."""
    kind = get_args(kind)[0].__name__ if get_origin(kind) is Annotated else str(kind).replace(" | None", "")
    return (
        "" if kind == "bool" else kind.removeprefix("tyro.conf.Positional[").removesuffix("]" * ("Positional" in kind))
    )


def default_of(field: Field[Any]) -> str:
    """Return the default of an option as it is typed, "" for none."""
    if field.default is not MISSING:
        value = field.default
    elif field.default_factory is not MISSING:
        value = field.default_factory()
    else:
        return ""
    return "" if value is None or value is False or value == "" else str(value)


def command(name: str, kind: Any) -> str:
    """Return the section of a command."""
    paragraphs = inspect.cleandoc(kind.__doc__ or "").split("\n\n")
    about = "\n\n".join(f"```text\n{x}\n```" if "   " in x else x for x in paragraphs)  # columns stay columns
    rows = table(("option", "takes", "default", "meaning"), options(name, kind))
    return f"## soccer {name}\n\n{about}\n\n{rows}"


def page() -> str:
    """Return the page of all commands."""
    head = (
        "# The command line\n\nAn option without a type is a switch. `soccer COMMAND --help` prints the same. What a "
        "user can get wrong ends with one line and exit code 2; exit code 1 is a result below what was asked for.\n"
    )
    return "\n".join([head, *(command(name, kind) for name, kind in kinds_of_settings().items())])
