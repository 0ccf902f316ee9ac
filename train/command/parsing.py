"""Parse command-line arguments into settings, with any error as a ValueError of one line.

tyro passes each error to a hook as a record (`tyro._errors`, private to the version that pyproject.toml bounds); its
own printed text is not used.
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

from soccer_env.guards.checking import short_repr
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
    """Parse the arguments of a command into settings; ValueError in one line for a wrong argument.

    With a `default`, such as the settings of a file, a yes-or-no setting has both flags: --mirror and --no-mirror.
    """
    import tyro
    from tyro import _errors

    from soccer_env.train.command.left_out import REGISTRY

    words = fill_flag(words, "--ray", "local")

    def raise_parse_error(event: Any) -> None:
        raise ValueError(f"{describe_error(event, kind, words, default is not None)} (see soccer {name} --help)")

    more: dict[str, Any] = {"config": (tyro.conf.FlagCreatePairsOff,)} if default is None else {"default": default}
    read: Any = partial(tyro.cli, kind, args=["--help"], prog=f"soccer {name}", registry=REGISTRY, **more)
    if {"-h", "--help"} & {*words}:
        print(cut_help_text(capture_printed_text(read), getattr(kind, "BASIC", ""), name))
        raise SystemExit(0)
    with _errors.on_parse_error(raise_parse_error):
        settings: T = read(args=["--help"] if ALL_OPTIONS in words else words)
        return settings


def capture_printed_text(show: Callable[[], Any]) -> str:
    """Run a function that prints and then exits with SystemExit; return the printed text."""
    content = io.BytesIO()
    text = io.TextIOWrapper(content, encoding=getattr(sys.stdout, "encoding", None) or "utf-8")  # decides on boxes
    with contextlib.suppress(SystemExit), contextlib.redirect_stdout(text):
        show()
    text.flush()
    return content.getvalue().decode(text.encoding).rstrip("\n")


def cut_help_text(text: str, last: str, name: str) -> str:
    """Cut a help text after the option `last` and append the number of options cut off; last "": cut nothing."""
    lines = text.splitlines()
    options = [at for at, line in enumerate(lines) if re.match("[│ ] -", line)]
    at = next((at for at, row in enumerate(options) if re.match(rf". --{last}\b", lines[row])), len(options)) + 1
    if not last or at >= len(options):
        return text
    more = f"`soccer {name} {ALL_OPTIONS}` explains {len(options) - at} more options."
    return "\n".join([*lines[: options[at]], lines[-1], more])


def describe_error(event: Any, kind: type, words: list[str], pairs: bool) -> str:
    """Return an error message for tyro's error record `event`; for an unknown record type, with the type's name."""
    record = type(event).__name__
    if record == "UnrecognizedArgs":
        word, flags = event.tokens[0], flags_of(kind, pairs)
        if word.startswith("-"):
            return unknown("option", word.partition("=")[0], flags)
        return f"unexpected argument {word!r}; options: {', '.join(flags)}"
    if record == "MissingArgs":
        missing = [argument_name(item.arg) for item in event.missing_arguments]
        return f"{', '.join(missing)} must be given"
    argument = getattr(event, "argument", None)
    flag = "" if argument is None else argument_name(argument)
    if record == "InvalidChoice":
        return unknown(flag, event.value, event.choices)
    if record == "BadValue":
        return f"{flag} needs a value" if event.offending_value is None else f"{flag} takes no value"
    if record == "InstantiationFailure":
        return wrong_value_message(flag, kind, words) or f"{flag}: {event.message}".removeprefix(": ")
    return f"the words of this command cannot be read ({record})"


def argument_name(argument: Any) -> str:
    """Return the name of an argument as the help shows it: its longest flag, or its positional name."""
    flags: tuple[str, ...] = argument.lowered.name_or_flags
    name = max(flags, key=len, default="")
    return name if name.startswith("-") else str(argument.field.intern_name).upper()


def flags_of(kind: Any, pairs: bool) -> list[str]:
    """Return the flags of a settings class; `pairs`: yes-or-no settings have both --mirror and --no-mirror."""
    flags = []
    for field in fields(kind):
        if "Positional" in str(field.type):
            continue
        name = field.name.replace("_", "-")
        flags += [f"--{name}", f"--no-{name}"] if pairs and field.type in (bool, "bool") else [f"--{name}"]
    return flags


def wrong_value_message(flag: str, kind: Any, words: list[str]) -> str:
    """Return the settings' error message for the value of a flag, "" if they accept the value."""
    at = [index for index, word in enumerate(words) if word.partition("=")[0] == flag]
    if not flag or not at:
        return ""
    value = words[at[-1]].partition("=")[2] or "".join(words[at[-1] + 1 : at[-1] + 2])
    name = flag.removeprefix("--").replace("-", "_")
    defaults = {field.name: (field.default, field.default_factory) for field in fields(kind)}
    placeholders = {field: Path() for field, default in defaults.items() if default == (MISSING, MISSING)}
    try:
        kind(**{**placeholders, name: value})
    except ValueError as error:
        return (
            f"{error}".replace(name, flag, 1) if f"{error}".startswith(name) else f"{flag} {short_repr(value)}: {error}"
        )
    except TypeError:  # settings that cannot be made from one value alone
        pass
    return ""


def reason_of(error: Exception) -> str:
    """Return the reason why a command failed; for an OSError, the file and the reason without the error number."""
    if isinstance(error, OSError) and error.strerror and error.filename is not None:
        return f"{os.fsdecode(error.filename)}: {error.strerror[0].lower()}{error.strerror[1:]}"
    return str(error)


def completion(shell: str, kinds: Mapping[str, type], summaries: Mapping[str, str]) -> str:
    """Return the shell completion script for all commands and options; ValueError for an unknown shell."""
    import tyro

    from soccer_env.train.command.left_out import REGISTRY

    if shell not in SHELLS:
        raise ValueError(f"{COMPLETION[0]}: {unknown('shell', shell, SHELLS)}")
    commands = [
        Annotated[kind, tyro.conf.subcommand(name=name, description=summaries[name])] for name, kind in kinds.items()
    ]
    every: Any = Union[tuple(commands)]  # noqa: UP007  # from a tuple
    config = (tyro.conf.FlagCreatePairsOff, tyro.conf.OmitSubcommandPrefixes)
    script = io.StringIO()
    with contextlib.suppress(SystemExit), contextlib.redirect_stdout(script):
        tyro.cli(every, args=[COMPLETION[1], shell], prog="soccer", config=config, registry=REGISTRY)
    lines = script.getvalue().splitlines()
    for at, line in enumerate(lines):
        if "COMPLETION_SPEC = {" in line:  # a shell reads each line of a description as a completion
            lines[at] = line.replace("\\\\n", " ").replace("\\n", " ")
    text = "\n".join(lines)
    if shell == "zsh":  # so that it can be sourced, not only placed in $fpath
        text = re.sub(r'^(_tyro_soccer) "\$@"$', AUTOLOADED_OR_SOURCED, text, flags=re.MULTILINE)
    return text


def fill_flag(words: list[str], flag: str, value: str) -> list[str]:
    """Return the words with a value after a flag that stands at the end or before another option."""
    for at in reversed(range(len(words))):
        if words[at] == flag and (at + 1 == len(words) or words[at + 1].startswith("-")):
            words = [*words[: at + 1], value, *words[at + 1 :]]
    return words


def take_out_flag(words: list[str], flag: str) -> tuple[str, list[str]]:
    """Remove a flag from the words; return its value ("" if absent) and the rest; ValueError without a value."""
    for at, word in enumerate(words):
        if word.startswith(flag + "="):
            return word.partition("=")[2], words[:at] + words[at + 1 :]
        if word == flag:
            if at + 1 == len(words):
                raise ValueError(f"{flag} needs a file")
            return words[at + 1], words[:at] + words[at + 2 :]
    return "", words
