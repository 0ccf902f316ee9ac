"""Judge teams by drills: the share of runs that succeed, from starts that training never draws.

`evaluate_drills(EvaluateSettings(scene="all", home="chaser,still", matches=100))`, or `soccer evaluate --scene all`.
"""

from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, fields, replace
from itertools import starmap
from math import isfinite
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.scenes import SCENES, Scene, find_scene
from soccer_env.teams import Team
from soccer_env.train.casting import SAVES, STILL, controllers_of, sizes_of
from soccer_env.train.cluster import open_workers
from soccer_env.train.evaluate.contest import Contest, check_training_conditions, team_or_name
from soccer_env.train.evaluate.settings import ALL, EvaluateSettings, conditions_of
from soccer_env.train.progress import Progress
from soccer_env.train.statistics import Interval, wilson_interval
from soccer_env.train.written_settings import split_distinct_names, split_variation

SEED = 1
USED = {  # options of drills
    "league", "scene", "home", "matches", "seed", "threads", "ray", "senses", "pose", "rules", "variation", "json",
}  # fmt: skip


@dataclass(frozen=True)
class DrillResult:
    """The result of a team in a drill."""

    league: str
    drill: str
    rules: str
    team: str
    runs: int
    successes: int

    @property
    def share(self) -> Interval:
        """Return the share of successes with low and high end of its 95 % interval (Wilson)."""
        return wilson_interval(self.successes, self.runs)

    def as_dict(self) -> dict[str, Any]:
        """Return the result as plain values, with the share and the ends of its interval."""
        return {**asdict(self), **dict(zip(("share", "low", "high"), self.share, strict=True))}


def drills_of(league: League | str) -> Iterator[Scene]:
    """Yield the drills of a league."""
    family = find_league(league).family
    for scene in SCENES.values():
        if scene.success != "none" and (not scene.families or family in scene.families):
            yield scene


def chosen_drills(scene: str, league: League | str) -> list[Scene]:
    """Return the drills that an option --scene means: one, or "all" of the league; none if it means matches."""
    if scene == ALL:
        return list(drills_of(league))
    return [found for found in [find_scene(scene)] if found.success != "none"]


def run_drill(
    league: League | str, scene: str | Scene, team: Any, runs: int, seed: int = SEED, threads: int = 2,
    starts: Any = "held-out", senses: tuple[str, str] = ("sensors", "sensors"), **settings: Any,
) -> int:  # fmt: skip
    """Play a drill `runs` times; return the number of successes. `senses`: of the team, of the others."""
    scene = find_scene(scene)
    if not isfinite(scene.time_limit):
        raise ValueError(f"drill {scene.name!r} might never end: give it a time_limit")
    home, away = sizes_of(scene)
    match = Match(
        league, home=home, away=away, matches=runs, seed=seed, threads=threads, scene=scene, episode="drill",
        controllers=controllers_of(scene, team), senses=senses[::-1] if scene.success == SAVES else senses,
        starts=starts, **settings,
    )  # fmt: skip
    succeeded = np.zeros(runs, bool)
    while not (match.terminated | match.truncated).all():
        match.step()
        succeeded |= match.events["drill"] == 1
    match.close()
    return int(succeeded.sum())


def evaluate_drills(
    settings: EvaluateSettings, *, league: League | None = None, teams: Mapping[str, Team] | None = None
) -> list[DrillResult]:
    """Let each team of settings.home play each drill of settings.scene `matches` times, from held-out starts.

    A drill keeps its rules, its opponents and its time limit. `league` and `teams` as in `evaluate`. ValueError for
    settings that no drill uses.
    """
    for field in fields(settings):
        if field.name not in USED and getattr(settings, field.name) != field.default:
            text = "goes with matches alone: a drill has its own opponents, rules and ends, and writes no files"
            raise ValueError(f"{field.name} {text}")
    league = league or find_league(settings.league)
    scenes = chosen_drills(settings.scene, league)
    names = split_distinct_names("home", settings.home)
    contests = [contest_for_drills(replace(settings, home=name), league, teams or {}) for name in names]
    runs = [(scene, contest, settings) for scene in scenes for contest in contests]
    results = []
    with Progress(f"{len(scenes)} drills", len(runs)) as bar, open_workers(settings.threads, settings.ray) as workers:
        counts = starmap(play_drill, runs) if isinstance(workers, int) else workers.submit(play_drill, runs)
        for (scene, contest, _), successes in zip(runs, counts, strict=True):
            told = {"rules": scene.rules, **rules_of(settings)}["rules"]
            team = contest.conditions.home
            results.append(DrillResult(league.name, scene.name, told, team, settings.matches, successes))
            bar.advance(1)
    return results


def play_drill(scene: Scene, contest: Contest, settings: EvaluateSettings) -> int:
    """Return the number of successes of a contest's first team in a drill."""
    conditions = contest.conditions
    return run_drill(
        contest.league, scene, contest.first, settings.matches, settings.seed, settings.threads,
        senses=conditions.senses, pose=conditions.pose, variation=split_variation(settings.variation),
        **rules_of(settings),
    )  # fmt: skip


def rules_of(settings: EvaluateSettings) -> dict[str, str]:
    """Return the rules that the settings choose for a drill; {} leaves the drill its own."""
    return {} if settings.rules == EvaluateSettings.rules else {"rules": settings.rules}


def contest_for_drills(settings: EvaluateSettings, league: League, teams: Mapping[str, Team]) -> Contest:
    """Return the team and its conditions, checked; ValueError for a policy that was trained with other senses."""
    contest = Contest(conditions_of(settings, league), league, team_or_name(settings.home, teams), STILL)
    check_training_conditions(contest, settings)
    return contest
