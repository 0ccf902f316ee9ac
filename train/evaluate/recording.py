"""`soccer record` and `soccer replay`: a match into a file, and out of it again."""

from __future__ import annotations

import os
from pathlib import Path

from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.train.evaluate.play_settings import PlaySettings, RecordSettings
from soccer_env.train.progress import Progress
from soccer_env.train.written_settings import split_players

NOTE_EVERY = 50  # control steps between two movements of the progress bar


def start(settings: PlaySettings) -> Match:
    """Return the match at its kick-off."""
    home, away = split_players(settings.players, find_league(settings.league).team_size)
    return Match(
        settings.league,
        home=home,
        away=away,
        controllers={"home": settings.home, "away": settings.away},
        minutes=settings.minutes,
        seed=settings.seed,
        rules=settings.rules,
        placement=settings.placement,
        senses=settings.senses,
        pose=settings.pose,
    )


def record(settings: RecordSettings) -> Replay:
    """Play a match, write its replay file and return it; a path that cannot be written is refused before the match."""
    check_target(settings.out)
    match = start(settings)
    recorder = Recorder(match, Thoughts(match, shown_of_memory()))
    with Progress(
        f"{settings.home} against {settings.away}", 60.0 * settings.minutes * match.league.control_rate
    ) as bar:
        while not match.terminated.all():
            match.step()
            if match.matches["step"][0] % NOTE_EVERY == 0:
                bar.advance(NOTE_EVERY)
    replay = recorder.stop()
    replay.write(settings.out)
    return replay


def shown_of_memory() -> dict[str, tuple[str, ...]]:
    """Return which fields of teams' memories a recording keeps for people, with the words for their values."""
    from soccer_env.baselines.heinemann_2006.memory import ROLES
    from soccer_env.baselines.sacks_2001.memory import BEHAVIOURS

    numbers = ("rank", "stuck", "tries", "left", "wriggle", "back_off", "detour")
    words = {"behaviour": BEHAVIOURS, "role": ROLES, "attacks": ("supporter", "attacker")}
    return words | dict.fromkeys(numbers, ())


def check_target(path: Path) -> None:
    """Make the folder of a file to write; ValueError if no file can be written there."""
    if path.is_dir():
        raise ValueError(f"--out is the file to write, but {path} is a folder")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ValueError(f"--out {path}: its folder cannot be made: {error.strerror}") from error
    if not os.access(path.parent, os.W_OK):
        raise ValueError(f"--out {path}: nothing can be written in its folder")


def play_again(path: Path) -> int:
    """Play a replay file again and return how many steps agreed; ValueError names the first that differs."""
    replay = Replay.read(path)
    with Progress(path.name, len(replay)) as bar:
        for _ in replay.play():
            bar.advance(1)
    return len(replay)
