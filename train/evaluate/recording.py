"""`soccer record` and `soccer replay`: record a match into a file, and check a file by playing it again."""

import os
from math import isfinite
from pathlib import Path
from typing import Literal

from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.scenes import find_scene
from soccer_env.train.casting import Cast, cast_of, sizes_of
from soccer_env.train.evaluate.play_settings import PlaySettings, RecordSettings
from soccer_env.train.progress import Progress
from soccer_env.train.written_settings import split_players

MINUTES = 1.0  # of a match without --minutes
OUTCOMES = {1: "success", -1: "failure", 0: "out of time"}  # of a drill
NOTE_EVERY = 50  # control steps between two updates of the progress bar


def start_match(settings: PlaySettings, actions: Literal["box", "full"] = "box") -> tuple[Match, Cast]:
    """Start the match of the settings; return it with its cast (the team of each robot); ValueError if impossible.

    actions: of robots that are taken from their teams, see `Match.learns`.
    """
    scene, league = find_scene(settings.scene), find_league(settings.league)
    is_drill = scene.success != "none"
    episode = settings.episode or ("drill" if is_drill else "match")
    if episode == "drill" and is_drill and not isfinite(scene.time_limit):
        raise ValueError(f"drill {scene.name!r} might never end: give it a time_limit, or --episode match")
    sizes = sizes_of(scene) if is_drill else (league.team_size, league.team_size)
    if settings.players is not None:
        sizes = split_players(settings.players, 1)
    scene.check(league, *sizes)
    cast = cast_of(scene, sizes, settings.home, settings.away)
    minutes = MINUTES if settings.minutes is None and episode != "drill" else settings.minutes
    match = Match(
        league, home=sizes[0], away=sizes[1], controllers=cast.controllers, minutes=minutes, seed=settings.seed,
        rules=settings.rules, placement=settings.placement, senses=settings.senses, pose=settings.pose, scene=scene,
        episode=episode, actions=actions,
    )  # fmt: skip
    return match, cast


def record(settings: RecordSettings) -> Replay:
    """Play a match and write its replay; return the Replay; ValueError at once if the file cannot be written."""
    return record_with_outcome(settings)[0]


def record_with_outcome(settings: RecordSettings) -> tuple[Replay, str]:
    """Record a match; return the Replay and a drill's outcome (success, failure, out of time), "" for a match."""
    check_target(settings.out)
    match, cast = start_match(settings)
    recorder = Recorder(match, Thoughts(match, shown_memory_fields()))
    with Progress(" against ".join(cast.names), match.settings.episode_limit or 0) as bar:
        while not (match.terminated | match.truncated).all():
            match.step()
            if match.matches["step"][0] % NOTE_EVERY == 0:
                bar.advance(NOTE_EVERY)
    replay = recorder.stop()
    replay.write(settings.out)
    outcome = OUTCOMES[int(match.events["drill"][0])] if match.settings.episode == "drill" else ""
    match.close()
    return replay, outcome


def shown_memory_fields() -> dict[str, tuple[str, ...]]:
    """Return the fields of teams' memories that recordings keep for display, with the words for their values."""
    from soccer_env.baselines.heinemann_2006.memory import ROLES
    from soccer_env.baselines.sacks_2001.memory import BEHAVIOURS

    numbers = ("rank", "stuck", "tries", "left", "wriggle", "back_off", "detour")
    words = {"behaviour": BEHAVIOURS, "role": ROLES, "attacks": ("supporter", "attacker")}
    return words | dict.fromkeys(numbers, ())


def check_target(path: Path) -> None:
    """Create the folder of an output file; ValueError if the file cannot be written there."""
    if path.is_dir():
        raise ValueError(f"--out is the file to write, but {path} is a folder")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ValueError(f"--out {path}: its folder cannot be made: {error.strerror}") from error
    if not os.access(path.parent, os.W_OK):
        raise ValueError(f"--out {path}: nothing can be written in its folder")


def check_replay(path: Path) -> int:
    """Play a replay file again and return the number of steps; ValueError names the first step that differs."""
    replay = Replay.read(path)
    with Progress(path.name, len(replay)) as bar:
        for _ in replay.play():
            bar.advance(1)
    return len(replay)
