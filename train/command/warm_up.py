"""`soccer warm-up`: compile ahead of time, so that a container image or a cluster job starts at once.

Machine code is kept in the folder that SOCCER_ENV_CACHE names, by the content of the source files, the versions of
numba and numpy, and the kind of processor: warm up on the kind of machine that will play.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from soccer_env import Match, make_team
from soccer_env.compiling.announcing import COMPILED
from soccer_env.compiling.cache import cache_folders
from soccer_env.leagues import LEAGUES, find_league
from soccer_env.scenes import SCENES
from soccer_env.teams import NAMES
from soccer_env.train.command.playing.person import Person
from soccer_env.train.progress import Progress
from soccer_env.train.written_settings import CommandSettings

Part = Callable[[], object]
BASE_LEAGUES = ("legged-2001", "middle-size-2006")  # their variants run the same code
WAYS: tuple[dict[str, Any], ...] = (  # to sense, observe and act; together they compile everything
    {"senses": "sensors", "observe": "belief", "pose": "particles"},
    {"senses": "sensors", "observe": "percepts", "actions": "full"},
    {"senses": "ideal", "observe": "belief", "actions": "discrete", "action_repeat": 2},
    {"senses": "ideal", "observe": "truth", "placement": "drive"},
)


@dataclass(frozen=True)
class WarmUpSettings(CommandSettings):
    """Compile everything ahead of time and keep it in the cache.

    By default: both leagues with every shipped team, some minutes on one core; a second if all is compiled already.
    """

    NAMES = {"league": ("all", *LEAGUES)}

    league: str = "all"
    """League to compile for, or "all"."""
    team: str = "all"
    """Team to compile beside learners and the chaser, or "all" shipped teams."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.team != "all":
            make_team(self.team)


def warm_up(settings: WarmUpSettings) -> str:
    """Compile everything by playing each part of `warm_up_parts` once; return a summary."""
    started, before = time.monotonic(), COMPILED.functions
    parts = list(warm_up_parts(settings))
    with Progress("soccer_env: compiling", len(parts)) as progress:
        for name, part in parts:
            progress.note(name)
            part()
            progress.advance(1)
    count, seconds = COMPILED.functions - before, time.monotonic() - started
    summary = f"{count} functions compiled in {seconds:.0f} s" if count else "nothing was left to compile"
    return f"{summary}; the cache is in {cache_folders()[0]}"


def warm_up_parts(settings: WarmUpSettings) -> Iterator[tuple[str, Part]]:
    """Yield name and function of each part that compiles code not compiled by other parts."""
    for league in BASE_LEAGUES if settings.league == "all" else (settings.league,):
        for way in WAYS:
            yield f"{league}, {' '.join(map(str, way.values()))}", partial(play, league, "chaser", **way)
        family = find_league(league).family
        drills = [
            scene for scene in SCENES.values() if scene.success != "none" and family in (scene.families or (family,))
        ]
        alone = {"home": 1, "away": 1, "episode": "drill", "scene": drills[0].name}
        yield f"{league}, a drill", partial(play, league, "chaser", **alone)
        yield f"{league}, skills of a person's robot", partial(compile_skills_of_person, league)
        for team in NAMES if settings.team == "all" else (settings.team,):
            if family in (getattr(make_team(team), "families", ()) or (family,)):
                yield f"{league}, {team}", partial(play, league, team)


def compile_skills_of_person(league: str) -> None:
    """Compile the skills that `soccer play` offers."""
    teams = {"home": "chaser", "away": "still"}
    Person(Match(league, home=1, away=1, seed=0, controllers=teams, actions="full"), "home").compile_skills()


def play(league: str, team: str, **settings: Any) -> None:
    """Play one step of a match between a team and learners, then save and load the match."""
    match = Match(league, **{"home": 2, "away": 2, "seed": 0, "opponents": team, **settings})
    kind = match.settings.actions
    shape = (1, len(match.agents), *kind.shape)
    match.step(np.zeros(shape, np.int64))
    match.load(match.save())
    match.state()
