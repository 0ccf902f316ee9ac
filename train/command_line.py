"""The command `soccer`. Heavy packages are imported only once the command is known.

Every flag is a field of a dataclass that Python code can use as well. What a user can get wrong ends with one line on
stderr and exit code 2; SOCCER_ENV_TRACEBACK=1 shows where it came from.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar, cast, get_args

from soccer_env.names import unknown

if TYPE_CHECKING:
    from rich.console import Console

T = TypeVar("T")
WRONG = 2  # exit code: the command cannot be carried out as given
BELOW = 1  # exit code: a result is below what was asked for
STOPPED = 130  # exit code: interrupted from the keyboard
WIDTH = 120  # columns of a table that does not go to a terminal

SUMMARIES = {
    "evaluate": "play one team against another and say how sure the result is",
    "list": "print the leagues, teams, settings, scenes, observations, sensors, rules, actions, rewards, statistics or "
    "claims",
    "bench": "measure the speed against the bare physics",
    "record": "play a match into a replay file",
    "replay": "play a replay file again and check every step",
    "train": "train a policy",
    "reproduce": "measure what the two papers claim and say whether it holds",
    "watch": "show a match in a window",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line (sys.argv without its first word by default) and return the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    name, rest = (words[0], words[1:]) if words else ("--help", [])
    if name in ("-h", "--help"):
        print(help_text())
        return 0 if words else WRONG
    if name == "--version":
        from soccer_env import __version__

        print(f"soccer_env {__version__}")
        return 0
    if name not in COMMANDS:
        return complain(unknown("command", name, COMMANDS))
    return guarded(COMMANDS[name], rest)


def help_text() -> str:
    """Return the help of `soccer` itself."""
    return "\n".join(
        [
            "usage: soccer COMMAND [OPTIONS]",
            "",
            *(f"  {name:12}{text}" for name, text in SUMMARIES.items()),
            "",
            "`soccer COMMAND --help` explains the options of one; `soccer --version` prints the version.",
        ]
    )


def guarded(command: Callable[[list[str]], int], words: list[str]) -> int:
    """Run a command; turn what a user can get wrong into one line and an exit code."""
    try:
        return command(words)
    except KeyboardInterrupt:
        print("stopped; what was finished is kept where --out was given", file=sys.stderr)
        return STOPPED
    except BrokenPipeError:  # `soccer list teams | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except (ValueError, OSError, ImportError) as error:
        own_bug = isinstance(error, ImportError) and (error.name or "").startswith("soccer_env")
        if own_bug or os.environ.get("SOCCER_ENV_TRACEBACK"):
            raise
        return complain(str(error))


def complain(message: str) -> int:
    """Print one line on stderr; return the exit code for a command that cannot be carried out."""
    print(f"soccer: {' '.join(message.split())}", file=sys.stderr)
    return WRONG


def read_settings(kind: type[T], words: list[str], name: str, default: T | None = None) -> T:
    """Return the settings dataclass that the words of a command describe; ValueError in one line for a wrong one.

    With a `default`, which may come from a file, a yes-or-no setting has both flags: --mirror and --no-mirror.
    """
    import tyro

    errors = io.StringIO()
    try:
        with contextlib.redirect_stderr(errors):
            if default is None:
                return tyro.cli(kind, args=words, prog=f"soccer {name}", config=(tyro.conf.FlagCreatePairsOff,))
            return tyro.cli(kind, args=words, prog=f"soccer {name}", default=default)
    except SystemExit as end:
        if not end.code:  # --help
            raise
    raise ValueError(f"{unboxed(errors.getvalue())} (see soccer {name} --help)")


def unboxed(text: str) -> str:
    """Return what a box of tyro's says, in one line: its first paragraph without the frame and the title."""
    lines = [re.sub(r"\x1b\[[0-9;]*m", "", line).strip(" │|") for line in text.splitlines()]
    lines = [line for line in lines if line and not line.startswith(("╭", "╰"))]
    end = next((at for at, line in enumerate(lines) if line.startswith(("─", "Got errors"))), len(lines))
    return re.sub(r"^Error parsing \w+Settings: ", "", " ".join(lines[:end]))


def console() -> Console:
    """Return where tables are printed: the terminal, or plain text of a fixed width."""
    from rich.console import Console

    return Console(width=None if sys.stdout.isatty() else WIDTH)


def run_evaluate(words: list[str]) -> int:
    """Run `soccer evaluate`."""
    from soccer_env.train.evaluate.settings import EvaluateSettings

    settings = read_settings(EvaluateSettings, words, "evaluate")
    from soccer_env.train.evaluate.evaluation import evaluate
    from soccer_env.train.evaluate.report import screen_tables

    result = evaluate(settings)
    for table in screen_tables(result):
        console().print(table)
    if settings.out is not None:
        files = [settings.out / name for name in ("result.json", "report.md", "match.png")]
        print(f"written: {', '.join(str(file) for file in files if file.exists())}")
    if settings.at_least is not None and result.points.mean < settings.at_least:
        print(f"points {result.points.mean:.3f} are below {settings.at_least:g}", file=sys.stderr)
        return BELOW
    return 0


def run_list(words: list[str]) -> int:
    """Run `soccer list`."""
    from soccer_env.train.listing import ListSettings, What, list_tables

    kinds: tuple[Any, ...] = get_args(What)
    if words and words[0] not in ("-h", "--help"):
        if words[0] not in kinds:
            raise ValueError(unknown("list", words[0], kinds))
        settings = read_settings(ListSettings, words[1:], f"list {words[0]}")
        out = console()
        for drawn in list_tables(cast(What, words[0]), settings):
            out.print(drawn)
        return 0
    print(f"usage: soccer list {'|'.join(kinds)} [--league LEAGUE]")
    return 0 if words else WRONG


def run_bench(words: list[str]) -> int:
    """Run `soccer bench`."""
    from soccer_env.train.bench.settings import BenchSettings

    settings = read_settings(BenchSettings, words, "bench")
    from soccer_env.train.bench import against, benchmark

    chosen = benchmark if settings.against is None else against
    console().print(chosen.screen_table(chosen.run(settings)))
    return 0


def run_record(words: list[str]) -> int:
    """Run `soccer record`."""
    from soccer_env.train.evaluate.play_settings import RecordSettings

    settings = read_settings(RecordSettings, words, "record")
    from soccer_env.train.evaluate.recording import record

    replay = record(settings)
    print(f"written: {settings.out}, {len(replay)} control steps")
    return 0


def run_replay(words: list[str]) -> int:
    """Run `soccer replay`."""
    if len(words) != 1 or words[0] in ("-h", "--help"):
        print("usage: soccer replay FILE: play a replay file again and check every step")
        return 0 if words[:1] in (["-h"], ["--help"]) else WRONG
    from pathlib import Path

    from soccer_env.train.evaluate.recording import play_again

    print(f"{words[0]}: {play_again(Path(words[0]))} control steps agree")
    return 0


def run_reproduce(words: list[str]) -> int:
    """Run `soccer reproduce`."""
    from soccer_env.train.reproduce.settings import ReproduceSettings

    settings = read_settings(ReproduceSettings, words, "reproduce")
    from soccer_env.train.reproduce.report import screen_table
    from soccer_env.train.reproduce.reproduction import reproduce

    console().print(screen_table(reproduce(settings)))
    if settings.out is not None:
        print(f"written: {settings.out / 'report.md'}, {settings.out / 'results.json'}")
    return 0


def run_train(words: list[str]) -> int:
    """Run `soccer train`."""
    from pathlib import Path

    from soccer_env.train.ppo.settings import TrainSettings
    from soccer_env.train.ppo.toml_file import settings_of

    config, rest = taken_out(words, "--config")
    settings = read_settings(TrainSettings, rest, "train", settings_of(Path(config) if config else None))
    from soccer_env.train.ppo import train

    try:
        import soccer_env.train.ppo.training  # noqa: F401  # torch and all that a training needs comes with it
        from soccer_env.train.ppo.reports import best_line, screen_table
    except ImportError as error:
        if (error.name or "").startswith("soccer_env"):
            raise
        raise ValueError(f'training needs more packages: pip install "soccer_env[train]" ({error})') from error
    try:
        result = train(settings)
    except KeyboardInterrupt:
        print(f"stopped; the same command goes on with the run in {settings.out}", file=sys.stderr)
        return STOPPED
    except OSError as error:
        if not (settings.out / "latest.json").exists():
            raise
        raise ValueError(
            f"{error}; the same command goes on with the run in {settings.out} once that is mended"
        ) from error
    console().print(screen_table(result))
    print(best_line(result))
    files = [settings.out / name for name in ("best.safetensors", "learning_curve.png")]
    print(f"written: {', '.join(str(file) for file in files if file.exists())}")
    return 0


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


def run_watch(words: list[str]) -> int:
    """Run `soccer watch`."""
    from soccer_env.train.evaluate.play_settings import WatchSettings

    settings = read_settings(WatchSettings, words, "watch")
    from soccer_env.train.evaluate.recording import watch

    watch(settings)
    return 0


COMMANDS: dict[str, Callable[[list[str]], int]] = {
    "evaluate": run_evaluate,
    "list": run_list,
    "bench": run_bench,
    "record": run_record,
    "replay": run_replay,
    "reproduce": run_reproduce,
    "train": run_train,
    "watch": run_watch,
}


if __name__ == "__main__":
    sys.exit(main())
