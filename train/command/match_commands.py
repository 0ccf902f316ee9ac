"""The functions that run `soccer tournament`, `record`, `replay`, `export`, `watch`, `play`, `evaluate --recheck`."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from soccer_env.train.command.exit_codes import BELOW, STOPPED
from soccer_env.train.command.parsing import read_settings
from soccer_env.train.command.printing import console, print_json, print_written_files

if TYPE_CHECKING:
    from soccer_env.train.evaluate import EvaluateSettings, RecheckResult
    from soccer_env.train.evaluate.rechecking import Difference

SHOWN = 12  # differing fields of a pair, at most


def run_tournament(words: list[str]) -> int:
    """Run `soccer tournament`."""
    from soccer_env.train.tournament.settings import TournamentSettings

    settings = read_settings(TournamentSettings, words, "tournament")
    from soccer_env.train.command.compiling_beside import compile_step_beside
    from soccer_env.train.tournament.playing import tournament
    from soccer_env.train.tournament.report import screen_tables

    with compile_step_beside():
        result = tournament(settings)
    if settings.json:
        print_json(result.as_dict())
        return 0
    for table in screen_tables(result):
        console().print(table)
    print_written_files(settings.out, "result.json", "report.html")
    return 0


def run_sweep(settings: EvaluateSettings) -> int:
    """Run `soccer evaluate --sweep`."""
    from soccer_env.train.command.compiling_beside import compile_step_beside
    from soccer_env.train.command.listing import Table
    from soccer_env.train.tournament.sweeping import sweep, sweep_table

    with compile_step_beside():
        points = sweep(settings)
    if settings.json:
        print_json([point.as_dict() for point in points])
        return 0
    heads, rows = sweep_table(points)
    console().print(Table(f"{settings.sweep}, against {settings.away}", heads, rows).drawn())
    print_written_files(settings.out, "sweep.json", "sweep.png")
    return 0


def run_record(words: list[str]) -> int:
    """Run `soccer record`."""
    from soccer_env.train.evaluate.play_settings import RecordSettings

    settings = read_settings(RecordSettings, words, "record")
    from soccer_env.leagues import find_league
    from soccer_env.train.command.compiling_beside import compile_step_beside
    from soccer_env.train.evaluate.recording import record_with_outcome

    with compile_step_beside():
        replay, outcome = record_with_outcome(settings)
    minutes = len(replay) / find_league(settings.league).control_rate / 60.0
    rate = settings.out.stat().st_size / 1e3 / max(minutes, 1e-9)
    print(f"written: {settings.out}, {len(replay)} control steps, {rate:.0f} kB a minute")
    if outcome:
        print(f"drill {settings.scene}: {outcome}")
    return 0


def run_replay(words: list[str]) -> int:
    """Run `soccer replay`."""
    from soccer_env.train.evaluate.play_settings import ReplaySettings

    settings = read_settings(ReplaySettings, words, "replay")
    from soccer_env.train.evaluate.recording import check_replay

    print(f"{settings.file}: {check_replay(settings.file)} control steps agree")
    return 0


def recheck_sample(settings: EvaluateSettings, said: set[str]) -> int:
    """Run `soccer evaluate --recheck FOLDER`; `said`: the settings given on the command line."""
    from soccer_env.train.evaluate import recheck

    assert settings.recheck is not None
    try:
        result = recheck(
            settings.recheck,
            pairs=settings.pairs,
            seed=settings.seed if "seed" in said else None,
            threads=settings.threads,
            where={name: getattr(settings, name) for name in ("home", "away", "league", "scene") if name in said},
            tell=None if settings.json else print_pair,
        )
    except KeyboardInterrupt:
        print("stopped; no file was changed", file=sys.stderr)
        return STOPPED
    if settings.json:
        print_json(result.as_dict())
    else:
        print_recheck_result(result)
    return 0 if result.agrees else BELOW


def print_pair(pair: int, differences: list[Difference]) -> None:
    """Print whether a pair of matches, played again, agrees with its stored lines."""
    print(f"pair {pair}, matches {2 * pair} and {2 * pair + 1}: {'differs' if differences else 'agrees'}")
    for difference in differences[:SHOWN]:
        print(f"  {difference}")
    if len(differences) > SHOWN:
        print(f"  and {len(differences) - SHOWN} more fields: --json names them all")
    sys.stdout.flush()


def print_recheck_result(result: RecheckResult) -> None:
    """Print the result of all pairs played again, and the command that draws this sample again."""
    played, differing = len(result.pairs), len(result.differing)
    drawn = f" (drawn with --pairs {played} --seed {result.seed})" if played < result.finished else ""
    which = f"{played} of {result.finished} finished pairs played again{drawn}"
    print(f"{result.folder}: {which}, {played - differing} agree, {differing} differ")
    if result.finished < result.asked:
        print(f"{result.asked - result.finished} pairs of {result.asked} are not finished")
    if result.result:
        print(f"result.json: {', '.join(result.result)} does not follow from matches.jsonl")
    elif result.result is not None:
        print("result.json follows from matches.jsonl")
    for version in result.made_otherwise:
        print(f"made with other versions, so that lines may differ: {version}")


def run_export(words: list[str]) -> int:
    """Run `soccer export`."""
    from soccer_env.train.evaluate.play_settings import ExportSettings

    settings = read_settings(ExportSettings, words, "export")
    from soccer_env.train.evaluate.exporting import export

    print(f"written: {export(settings)}")
    return 0


def run_watch(words: list[str]) -> int:
    """Run `soccer watch`."""
    from soccer_env.train.command.watching.settings import WatchSettings

    settings = read_settings(WatchSettings, words, "watch")
    from soccer_env.train.command.compiling_beside import compile_step_beside
    from soccer_env.train.command.watching.watching import watch

    with compile_step_beside():
        watch(settings)
    return 0


def run_play(words: list[str]) -> int:
    """Run `soccer play`."""
    from soccer_env.train.command.playing.settings import PersonSettings

    settings = read_settings(PersonSettings, words, "play")
    from soccer_env.train.command.compiling_beside import compile_step_beside
    from soccer_env.train.command.playing.playing import play

    with compile_step_beside():
        print(play(settings))
    if settings.out is not None:
        print_written_files(settings.out.parent, settings.out.name)
    return 0
