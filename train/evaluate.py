"""Evaluate one team against another: pairs of matches from the same seeds, sides swapped, many at once.

    result = evaluate(EvaluateSettings(home="chaser", away="random@0.5", matches=20))

Every match follows from its own seed alone, so the result does not depend on threads, on how many matches run side
by side, or on where a stopped run went on.
"""

from __future__ import annotations

import datetime
import json
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.random_numbers import seeds_for
from soccer_env.scenes import find_scene
from soccer_env.teams import ObservingTeam, Team, make_team, registered
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import commit, made_with
from soccer_env.train.report import markdown
from soccer_env.train.results import EvaluationResult, Folder, MatchLine, remove_files, summarise
from soccer_env.train.settings import Conditions, EvaluateSettings, command_of, conditions_of

BATCH = 32  # matches side by side for each thread; more gain little, and a run that is killed loses the batch
REPORT_EVERY = 50  # steps between two movements of the progress bar

__all__ = ["EvaluateSettings", "EvaluationResult", "evaluate"]


@dataclass(frozen=True)
class Contest:
    """Who plays whom, where and how."""

    conditions: Conditions
    league: League
    first: str | Team
    second: str | Team

    def start(self, side: str, seeds: Sequence[int], threads: int = 1) -> Match:
        """Return matches (one for each seed) in which the first team plays on that side, "home" or "away"."""
        asked = self.conditions
        teams, sizes, senses = (self.first, self.second), asked.players, asked.senses
        if side == "away":
            teams, sizes, senses = teams[::-1], sizes[::-1], senses[::-1]
        sides = ("home", "away")
        return Match(
            self.league,
            home=sizes[0],
            away=sizes[1],
            matches=len(seeds),
            threads=threads,
            seeds=np.array(seeds, np.uint64),
            senses=dict(zip(sides, senses, strict=True)),
            pose=asked.pose,
            controllers=dict(zip(sides, teams, strict=True)),
            scene=asked.scene,
            placement=asked.placement,
            minutes=asked.minutes,
        )


def evaluate(
    settings: EvaluateSettings, *, league: League | None = None, teams: Mapping[str, Team] | None = None
) -> EvaluationResult:
    """Play the matches that settings.out does not hold yet and return the result of all.

    `league` is a league of one's own instead of a named one; `teams` gives names to team objects, which settings.home
    and settings.away may then use. Raises ValueError for settings that cannot be played and for a folder that holds
    another evaluation.
    """
    league = league or find_league(settings.league)
    contest = contest_of(conditions_of(settings, league), league, teams or {})
    made = made_with(league, contest.first, contest.second)
    today = datetime.datetime.now(datetime.timezone.utc).date().isoformat()
    contest.start("home", [0])  # whatever cannot be played is found before a folder is made
    if settings.anew:
        remove_files(settings.out)
    about = {"command": command_of(settings), "date": today, "commit": commit()}
    folder = Folder(settings.out, contest.conditions, made, about)
    play_missing(contest, folder, settings.threads)
    result = summarise(contest.conditions, made, folder.lines)
    folder.write("result.json", json.dumps(result.as_dict(), indent=2) + "\n")
    folder.write("report.md", markdown(result, folder.about))
    if settings.picture:
        draw_first_match(contest, folder, result)
    return result


def contest_of(conditions: Conditions, league: League, teams: Mapping[str, Team]) -> Contest:
    """Find the teams; ValueError for an unknown one and for a drill."""
    scene = find_scene(conditions.scene)
    if scene.success != "none":
        raise ValueError(f"scene {scene.name!r} is a drill: evaluating drills is not built yet, only matches are")
    return Contest(conditions, league, *(find_team(name, teams) for name in (conditions.home, conditions.away)))


def find_team(name: str, teams: Mapping[str, Team]) -> str | Team:
    """Return the team object of that name, or the name itself if the registry knows it."""
    if name in teams:
        return make_team(teams[name])
    try:
        made = make_team(name)
    except ModuleNotFoundError as error:
        raise ValueError(f"team {name!r} cannot be loaded ({error}); known: {', '.join(registered())}") from error
    return made if isinstance(made, ObservingTeam) else name  # a policy is read once: its file may change meanwhile


def play_missing(contest: Contest, folder: Folder, threads: int) -> None:
    """Play every match that the folder lacks, batch by batch."""
    conditions = contest.conditions
    done = {line.match for line in folder.lines}
    seeds = seeds_for(conditions.seed, conditions.matches // 2).tolist()
    steps = conditions.minutes * 60.0 * contest.league.control_rate  # of a match
    with Progress(f"{conditions.home} against {conditions.away}", steps * (conditions.matches - len(done))) as progress:
        for batch in batches(conditions.matches, done, BATCH * threads):
            progress.note(f"{len(folder.lines)} of {conditions.matches} matches")
            folder.add(play(contest, batch, seeds, folder.settings, threads, progress.advance))


def batches(matches: int, done: set[int], size: int) -> Iterator[list[int]]:
    """Yield the matches still to play, at most `size` at once, the first team on the same side in all of a batch."""
    for first in range(0, matches, 2 * size):
        for side in (0, 1):
            batch = [match for match in range(first + side, min(first + 2 * size, matches), 2) if match not in done]
            if batch:
                yield batch


def play(
    contest: Contest,
    batch: Sequence[int],
    seeds: Sequence[int],
    settings: str,
    threads: int,
    advance: Callable[[float], None],
) -> list[MatchLine]:
    """Play a batch to the end; `advance` is told how many control steps were done, over all matches."""
    side = side_of(batch[0])
    match = contest.start(side, [seeds[number // 2] for number in batch], threads)
    lines: dict[int, MatchLine] = {}
    steps = 0
    try:
        while len(lines) < len(batch):
            _, _, terminated, truncated = match.step(None)
            steps += 1
            if steps % REPORT_EVERY == 0:
                advance(REPORT_EVERY * len(batch))
            for m in np.flatnonzero(terminated | truncated).tolist():
                if m not in lines:  # at once: what a match that is over does next depends on the others
                    lines[m] = line_of_match(match, m, batch[m], settings)
        advance((steps % REPORT_EVERY) * len(batch))
    finally:
        match.close()
    return [lines[m] for m in range(len(batch))]


def side_of(number: int) -> str:
    """Return the side on which the first team plays a match."""
    return ("home", "away")[number % 2]


def line_of_match(match: Match, m: int, number: int, settings: str) -> MatchLine:
    """Return the line of match m of a batch, which is match `number` of the evaluation, at its end."""
    record = match.matches[m]
    scored = record["score"].tolist()
    ours = number % 2  # the score's column
    return MatchLine(
        match=number,
        pair=number // 2,
        seed=int(match.seeds[m]),
        side=side_of(number),
        goals_for=scored[ours],
        goals_against=scored[1 - ours],
        steps=int(record["step"]),
        state=match.state_hash(m),
        settings=settings,
    )


def draw_first_match(contest: Contest, folder: Folder, result: EvaluationResult) -> None:
    """Play the first match again, by itself, and write its pictures; RuntimeError if it ends in another state."""
    from soccer_env.render import save_png
    from soccer_env.train.pictures import draw_match, require_pictures

    assert folder.path is not None
    try:
        require_pictures()
    except ImportError as error:
        print(f"no picture: {error}", file=sys.stderr)
        return
    line = result.lines[0]
    match = contest.start(line.side, [line.seed])
    sheet = draw_match(match, line.steps, (result.conditions.home, result.conditions.away))
    if match.state_hash(0) != line.state:
        raise RuntimeError(f"match 0 (seed {line.seed}) did not end as it did among others: a bug of soccer_env")
    save_png(sheet, folder.path / "match.png")
