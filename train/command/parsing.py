"""Read the words of a command into its settings; what is wrong with them is a ValueError of one line.

tyro tells a hook what is wrong, as records (`tyro._errors`, private to the version that pyproject.toml bounds); what it
would print itself is never looked at.
"""

import contextlib
import io
import os
import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import MISSING, fields
from functools import partial
from pathlib import Path
from typing import Annotated, Any, TypeVar, Union

from soccer_env.guards.checking import brief
from soccer_env.guards.names import unknown

T = TypeVar("T")
SHELLS = ("bash", "zsh", "fish")
AUTOLOADED_OR_SOURCED = r"""if [[ $zsh_eval_context[-1] == (loadautofunc|shfunc) ]]; then
  \1 "$@"
else
  compdef \1 soccer
fi"""
ALL_OPTIONS = "--help-all"  # of a command that shows its basic options first
COMPLETION = ("--print-completion", "--tyro-print-completion")  # flags of `soccer` itself; the second is tyro's own


def read_settings(kind: type[T], words: list[str], name: str, default: T | None = None) -> T:
    """Return the settings dataclass that the words of a command describe; ValueError in one line for a wrong one.

    With a `default`, which may come from a file, a yes-or-no setting has both flags: --mirror and --no-mirror.
    """
    import tyro
    from tyro import _errors

    from soccer_env.train.command.left_out import REGISTRY

    def refuse(event: Any) -> None:
        raise ValueError(f"{in_words(event, kind, words, default is not None)} (see soccer {name} --help)")

    more: dict[str, Any] = {"config": (tyro.conf.FlagCreatePairsOff,)} if default is None else {"default": default}
    help_of = partial(tyro.cli, kind, args=["--help"], prog=f"soccer {name}", registry=REGISTRY, **more)
    if {"-h", "--help"} & {*words}:
        print(first_options(printed(help_of), getattr(kind, "BASIC", ""), name))
        raise SystemExit(0)
    with _errors.on_parse_error(refuse):
        return help_of(args=["--help"] if ALL_OPTIONS in words else words)


def printed(show: Callable[[], Any]) -> str:
    """Return what a function prints before it ends the program."""
    content = io.BytesIO()
    text = io.TextIOWrapper(content, encoding=getattr(sys.stdout, "encoding", None) or "utf-8")  # decides on boxes
    with contextlib.suppress(SystemExit), contextlib.redirect_stdout(text):
        show()
    text.flush()
    return content.getvalue().decode(text.encoding).rstrip("\n")


def first_options(text: str, last: str, name: str) -> str:
    """Return the help of a command up to the option `last`, and how many more there are; "": the whole help."""
    lines = text.splitlines()
    options = [at for at, line in enumerate(lines) if re.match("[│ ] -", line)]
    at = next((at for at, row in enumerate(options) if re.match(rf". --{last}\b", lines[row])), len(options)) + 1
    if not last or at >= len(options):
        return text
    more = f"`soccer {name} {ALL_OPTIONS}` explains {len(options) - at} more options."
    return "\n".join([*lines[: options[at]], lines[-1], more])


def in_words(event: Any, kind: type, words: list[str], pairs: bool) -> str:
    """Return what is wrong with the words of a command, as tyro's record of it says; of a kind not known, its name."""
    what = type(event).__name__
    if what == "UnrecognizedArgs":
        return unknown_word(event.tokens[0], kind, pairs)
    if what == "MissingArgs":
        missing = [name_of(found.arg) for found in event.missing_arguments]
        return f"{', '.join(missing)} must be given"
    argument = getattr(event, "argument", None)
    flag = "" if argument is None else name_of(argument)
    if what == "InvalidChoice":
        return unknown(flag, event.value, event.choices)
    if what == "BadValue":
        return f"{flag} needs a value" if event.offending_value is None else f"{flag} takes no value"
    if what == "InstantiationFailure":
        return wrong_value(flag, kind, words) or f"{flag}: {event.message}".removeprefix(": ")
    return f"the words of this command cannot be read ({what})"


def name_of(argument: Any) -> str:
    """Return what a command's help calls an argument: its longest flag, or the name of one that has no flag."""
    flags: tuple[str, ...] = argument.lowered.name_or_flags
    name = max(flags, key=len, default="")
    return name if name.startswith("-") else str(argument.field.intern_name).upper()


def unknown_word(word: str, kind: type, pairs: bool) -> str:
    """Return what is wrong with a word that no option takes."""
    flags = flags_of(kind, pairs)
    if word.startswith("-"):
        return unknown("option", word.partition("=")[0], flags)
    return f"unexpected argument {word!r}; options: {', '.join(flags)}"


def flags_of(kind: Any, pairs: bool) -> list[str]:
    """Return the flags of a settings dataclass; `pairs`: of yes-or-no settings both."""
    found = []
    for field in fields(kind):
        if "Positional" in str(field.type):
            continue
        name = field.name.replace("_", "-")
        found += [f"--{name}", f"--no-{name}"] if pairs and field.type in (bool, "bool") else [f"--{name}"]
    return found


def wrong_value(flag: str, kind: Callable[..., Any], words: list[str]) -> str:
    """Return what the settings themselves say of the value of a flag, "" if they take it or say nothing of it."""
    at = [index for index, word in enumerate(words) if word.partition("=")[0] == flag]
    if not flag or not at:
        return ""
    value = words[at[-1]].partition("=")[2] or "".join(words[at[-1] + 1 : at[-1] + 2])
    name = flag.removeprefix("--").replace("-", "_")
    try:
        kind(**{**required(kind), name: value})
    except ValueError as error:
        return f"{error}".replace(name, flag, 1) if f"{error}".startswith(name) else f"{flag} {brief(value)}: {error}"
    except TypeError:  # settings that cannot be made from one alone
        pass
    return ""


def required(kind: Any) -> dict[str, Path]:
    """Return a value for each field of a settings dataclass that has to be given: they are all paths."""
    defaults = {field.name: (field.default, field.default_factory) for field in fields(kind)}
    return {name: Path() for name, default in defaults.items() if default == (MISSING, MISSING)}


def reason_of(error: Exception) -> str:
    """Return why a command cannot be carried out; of the system's errors the file and the reason, without a number."""
    if isinstance(error, OSError) and error.strerror and error.filename is not None:
        return f"{os.fsdecode(error.filename)}: {error.strerror[0].lower()}{error.strerror[1:]}"
    return str(error)


def completion(shell: str, kinds: Mapping[str, type], summaries: Mapping[str, str]) -> str:
    """Return the completion script of a shell, for all commands with their settings; ValueError for another shell."""
    import tyro

    from soccer_env.train.command.left_out import REGISTRY

    if shell not in SHELLS:
        raise ValueError(f"{COMPLETION[0]}: {unknown('shell', shell, SHELLS)}")
    commands = [
        Annotated[kind, tyro.conf.subcommand(name=name, description=summaries[name])] for name, kind in kinds.items()
    ]
    every: Any = Union[tuple(commands)]  # noqa: UP007  # made of a tuple
    config = (tyro.conf.FlagCreatePairsOff, tyro.conf.OmitSubcommandPrefixes)
    script = io.StringIO()
    with contextlib.suppress(SystemExit), contextlib.redirect_stdout(script):
        tyro.cli(every, args=[COMPLETION[1], shell], prog="soccer", config=config, registry=REGISTRY)
    text = on_one_line(script.getvalue())
    return ready_to_source(text) if shell == "zsh" else text


def ready_to_source(script: str) -> str:
    """Return tyro's script of zsh so that it may be sourced as well: as it is, it has to be a file of $fpath."""
    return re.sub(r'^(_tyro_soccer) "\$@"$', AUTOLOADED_OR_SOURCED, script, flags=re.MULTILINE)


def on_one_line(script: str) -> str:
    """Return a completion script with descriptions of one line each: shells take each line for a completion."""
    lines = script.splitlines()
    for at, line in enumerate(lines):
        if "COMPLETION_SPEC = {" in line:
            lines[at] = line.replace("\\\\n", " ").replace("\\n", " ")
    return "\n".join(lines)


def taken_out(words: list[str], flag: str) -> tuple[str, list[str]]:
    """Return the value of a flag, "" without it, and the words without both; ValueError if the value is missing."""
    for at, word in enumerate(words):
        if word.startswith(flag + "="):
            return word.partition("=")[2], words[:at] + words[at + 1 :]
        if word == flag:
            if at + 1 == len(words):
                raise ValueError(f"{flag} needs a file")
            return words[at + 1], words[:at] + words[at + 2 :]
    return "", words
