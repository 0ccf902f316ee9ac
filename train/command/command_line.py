"""The command line of `soccer`, which imports heavy packages only once the command is known.

Every flag is a field of a dataclass that Python code can use as well. A user's mistake ends with one line on stderr
and exit code 2; SOCCER_ENV_TRACEBACK=1 shows the traceback.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, get_args

from soccer_env.guards.names import unknown
from soccer_env.train.command import match_commands
from soccer_env.train.command.exit_codes import BELOW, STOPPED, WRONG
from soccer_env.train.command.interrupts import repeat_swallowed_interrupts
from soccer_env.train.command.parsing import COMPLETION, completion, read_settings, reason_of, take_out_flag
from soccer_env.train.command.printing import console, print_json, print_kept_replays, print_written_files

if TYPE_CHECKING:
    from types import ModuleType

    from soccer_env.train.ppo.settings import TrainSettings
    from soccer_env.train.ppo.training import TrainResult

SUMMARIES = {
    "evaluate": "play one team against another, with intervals and a verdict",
    "list": "print the leagues, teams, settings, scenes, observations, sensors, rules, actions, rewards, statistics, "
    "claims or variations",
    "bench": "measure the speed against the bare physics",
    "export": "make a film, a browser page, pictures or tables from a replay file",
    "play": "play in a match yourself, by keyboard or gamepad",
    "record": "play a match or a drill into a replay file",
    "replay": "play a replay file again and check every step",
    "tournament": "rank teams: a cross table, ratings with intervals, who is above whom",
    "train": "train a policy",
    "reproduce": "measure the claims of the two papers",
    "warm-up": "compile everything ahead of time",
    "watch": "show a match or a replay file in a window",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line with these arguments, by default those of the process; return the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    name, rest = (words[0], words[1:]) if words else ("--help", [])
    if name in ("-h", "--help"):
        print(help_text())
        return 0 if words else WRONG
    if name == "--version":
        from soccer_env import __version__

        print(f"soccer_env {__version__}")
        return 0
    if name.partition("=")[0] in COMPLETION:
        return run_guarded(run_completion, words)
    if name not in COMMANDS:
        return print_error(unknown("command", name, COMMANDS))
    return run_guarded(COMMANDS[name], rest)


def help_text() -> str:
    """Return the help text of `soccer` without a command."""
    return "\n".join(
        [
            "usage: soccer COMMAND [OPTIONS]",
            "",
            *(f"  {name:12}{text}" for name, text in SUMMARIES.items()),
            "",
            "`soccer COMMAND --help` explains the options of one; `soccer --version` prints the version.",
            "`soccer --print-completion bash` (or zsh, fish) prints a completion script for the shell.",
        ]
    )


def run_guarded(command: Callable[[list[str]], int], words: list[str]) -> int:
    """Run a command and return its exit code; a user's mistake is reported in one line on stderr."""
    try:
        with repeat_swallowed_interrupts():
            return command(words)
    except KeyboardInterrupt:
        print("stopped; finished matches are kept in --out, if it was given", file=sys.stderr)
        return STOPPED
    except BrokenPipeError:  # `soccer list teams | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except (ValueError, OSError, ImportError) as error:
        own_bug = isinstance(error, ImportError) and (error.name or "").startswith("soccer_env")
        if own_bug or os.environ.get("SOCCER_ENV_TRACEBACK"):
            raise
        return print_error(reason_of(error))


def print_error(message: str) -> int:
    """Print one line on stderr, and return the exit code for a command that cannot run."""
    print(f"soccer: {' '.join(message.split())}", file=sys.stderr)
    return WRONG


def kinds_of_settings() -> dict[str, type]:
    """Return the settings class of each command by the command's name."""
    from soccer_env.train.bench.settings import BenchSettings
    from soccer_env.train.command.listing import ListSettings
    from soccer_env.train.command.playing.settings import PersonSettings
    from soccer_env.train.command.warm_up import WarmUpSettings
    from soccer_env.train.command.watching.settings import WatchSettings
    from soccer_env.train.evaluate.play_settings import ExportSettings, RecordSettings, ReplaySettings
    from soccer_env.train.evaluate.settings import EvaluateSettings
    from soccer_env.train.papers.settings import ReproduceSettings
    from soccer_env.train.ppo.settings import TrainSettings
    from soccer_env.train.tournament.settings import TournamentSettings

    return {
        "evaluate": EvaluateSettings, "list": ListSettings, "bench": BenchSettings, "export": ExportSettings,
        "play": PersonSettings, "record": RecordSettings, "replay": ReplaySettings, "reproduce": ReproduceSettings,
        "tournament": TournamentSettings, "train": TrainSettings, "warm-up": WarmUpSettings, "watch": WatchSettings,
    }  # fmt: skip


def run_completion(words: list[str]) -> int:
    """Run `soccer --print-completion SHELL`; tyro's own flag for completion works as well."""
    shell = "".join([*words[0].split("=", 1), *words[1:]][1:2])
    print(completion(shell, kinds_of_settings(), SUMMARIES))
    return 0


def run_evaluate(words: list[str]) -> int:
    """Run `soccer evaluate`."""
    from soccer_env.train.evaluate.settings import EvaluateSettings

    settings = read_settings(EvaluateSettings, words, "evaluate")
    if settings.recheck is not None:
        return match_commands.recheck_sample(
            settings, {word[2:].partition("=")[0] for word in words if word.startswith("--")}
        )
    if settings.sweep:
        return match_commands.run_sweep(settings)
    from soccer_env.train.command.compiling_beside import compile_step_beside
    from soccer_env.train.evaluate.drills import chosen_drills, evaluate_drills
    from soccer_env.train.evaluate.evaluation import evaluate
    from soccer_env.train.evaluate.report import screen_tables, table_of_drills

    if chosen_drills(settings.scene, settings.league):
        with compile_step_beside():
            results = evaluate_drills(settings)
        print_json([row.as_dict() for row in results]) if settings.json else console().print(table_of_drills(results))
        return 0
    with compile_step_beside():
        result = evaluate(settings)
    if settings.json:
        print_json(result.as_dict())
    else:
        for table in screen_tables(result):
            console().print(table)
        print_written_files(settings.out, "result.json", "report.md", "report.html", "match.png")
        print_kept_replays(settings.out)
    if settings.at_least is not None and result.points.mean < settings.at_least:
        print(f"points {result.points.mean:.3f} are below {settings.at_least:g}", file=sys.stderr)
        return BELOW
    return 0


def run_list(words: list[str]) -> int:
    """Run `soccer list`."""
    from soccer_env.train.command.listing import ListSettings, What, list_tables

    if not words:
        print(f"usage: soccer list {'|'.join(get_args(What))} [OPTIONS]; see soccer list --help")
        return WRONG
    if not words[0].startswith("-") and words[0] not in get_args(What):
        raise ValueError(unknown("list", words[0], get_args(What)))
    settings = read_settings(ListSettings, words, "list")
    if settings.json:
        print_json([table.as_dict() for table in list_tables(settings)])
        return 0
    for table in list_tables(settings):
        console().print(table.drawn())
    return 0


def run_bench(words: list[str]) -> int:
    """Run `soccer bench`."""
    from soccer_env.train.bench.settings import BenchSettings

    settings = read_settings(BenchSettings, words, "bench")
    from soccer_env.train.bench import measure_speed

    report, draw = measure_speed(settings)
    if settings.json:
        print_json(report)
    else:
        console().print(draw(report))
    return 0


def run_reproduce(words: list[str]) -> int:
    """Run `soccer reproduce`."""
    from soccer_env.train.papers.settings import ReproduceSettings

    settings = read_settings(ReproduceSettings, words, "reproduce")
    from soccer_env.train.papers.report import screen_parts
    from soccer_env.train.papers.reproduction import reproduce

    results = reproduce(settings)
    if settings.json:
        print_json([result.as_dict() for result in results])
        return 0
    console().print(*screen_parts(results, in_full=not settings.all), sep="\n")
    print_written_files(settings.out, "report.md", "report.html", "results.json")
    return 0


def run_train(words: list[str]) -> int:
    """Run `soccer train`."""
    from pathlib import Path

    from soccer_env.train.ppo.settings import TrainSettings
    from soccer_env.train.ppo.toml_file import settings_of

    config, rest = take_out_flag(words, "--config")
    settings = read_settings(TrainSettings, rest, "train", settings_of(Path(config) if config else None))
    from soccer_env.train.command.compiling_beside import compile_step_beside

    train, reports = import_training()
    try:
        with compile_step_beside():
            result = train(settings)
    except KeyboardInterrupt:
        command = "the same command without --anew" if settings.anew else "the same command"
        print(f"stopped; {command} continues the run in {settings.out}", file=sys.stderr)
        return STOPPED
    except OSError as error:
        if not (settings.out / "latest.json").exists():
            raise
        advice = f"once this is fixed, the same command continues the run in {settings.out}"
        raise ValueError(f"{error}; {advice}") from error
    console().print(reports.screen_table(result))
    print(reports.best_evaluation_sentence(result))
    print_written_files(settings.out, "best.safetensors", "learning_curve.png", "report.html")
    print_kept_replays(settings.out)
    return 0


def import_training() -> tuple[Callable[[TrainSettings], TrainResult], ModuleType]:
    """Import and return the function `train` and the module `reports`; ValueError names packages to install."""
    try:
        import soccer_env.train.ppo.training  # noqa: F401  # imports torch and everything else that training needs
        from soccer_env.train.ppo import reports, train
    except ImportError as error:
        if (error.name or "").startswith("soccer_env"):
            raise
        raise ValueError(f'training needs more packages: pip install "soccer_env[train]" ({error})') from error
    return train, reports


def run_warm_up(words: list[str]) -> int:
    """Run `soccer warm-up`."""
    from soccer_env.train.command.warm_up import WarmUpSettings, warm_up

    print(warm_up(read_settings(WarmUpSettings, words, "warm-up")))
    return 0


COMMANDS: dict[str, Callable[[list[str]], int]] = {
    "evaluate": run_evaluate,
    "list": run_list,
    "bench": run_bench,
    "export": match_commands.run_export,
    "play": match_commands.run_play,
    "record": match_commands.run_record,
    "replay": match_commands.run_replay,
    "reproduce": run_reproduce,
    "tournament": match_commands.run_tournament,
    "train": run_train,
    "warm-up": run_warm_up,
    "watch": match_commands.run_watch,
}


if __name__ == "__main__":
    sys.exit(main())
