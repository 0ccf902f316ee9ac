"""Evaluate one team against another by pairs of matches from one seed, with sides swapped, many at once.

result = evaluate(EvaluateSettings(home="chaser", away="random@0.5", matches=20))
"""

import json
import sys
from collections.abc import Mapping
from dataclasses import asdict, replace
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.scenes import scene_names
from soccer_env.teams import Team
from soccer_env.train.cluster import Workers, open_workers
from soccer_env.train.evaluate.contest import (
    Contest,
    check_training_conditions,
    contest_of,
    differing_settings,
    play_matches,
)
from soccer_env.train.evaluate.line_checks import check_line
from soccer_env.train.evaluate.page import page_of
from soccer_env.train.evaluate.replays import Keep, keep_replays
from soccer_env.train.evaluate.report import markdown
from soccer_env.train.evaluate.results import EVALUATION, MATCHES, EvaluationResult, MatchLine, summarise
from soccer_env.train.evaluate.settings import EvaluateSettings, command_of, conditions_of
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import check_team_hashes, date_and_commit, made_with, module_hashes
from soccer_env.train.results_folder import ResultsFolder
from soccer_env.types import NO_TEAM

MOMENTS = 12  # of a match in its sheet of pictures, evenly spread, besides the moment before each goal
GOALS = 8  # shown at most
COLUMNS, WIDTH = 4, 480  # of the sheet; [px] of a picture


def evaluate(
    settings: EvaluateSettings, *, league: League | None = None, teams: Mapping[str, Team] | None = None
) -> EvaluationResult:
    """Play the matches still missing in settings.out, and return the result of all matches.

    `league` replaces the named league by a user's own; `teams` gives names to team objects, which settings.home and
    settings.away may then use. Raises ValueError for settings that cannot be played and for a folder with another
    evaluation.
    """
    contest, folder = open_evaluation(settings, league, teams or {})
    conditions = contest.conditions
    title, steps = f"{conditions.home} against {conditions.away}", conditions.matches * steps_of_match(contest)
    with Progress(title, steps) as bar, open_workers(settings.threads, settings.ray) as workers:
        result = play_evaluation(contest, folder, workers, bar)
    write_reports(contest, folder, result, Keep(settings.keep, settings.keep_pages))
    if settings.picture:
        draw_first_match(contest, folder, result)
    return result


def prepare_evaluation(
    settings: EvaluateSettings, league: League | None, teams: Mapping[str, Team]
) -> tuple[Contest, dict[str, str]]:
    """Return the contest and what its result depends on; every error that it could have is raised here."""
    if settings.recheck is not None:
        raise ValueError("recheck is a flag of the command; in Python recheck(folder) of soccer_env.train.evaluate")
    if settings.sweep:
        raise ValueError(
            "a sweep is several evaluations: sweep(settings) of soccer_env.train.tournament.sweeping plays it"
        )
    league = league or find_league(settings.league)
    contest = contest_of(conditions_of(settings, league), league, teams)
    check_training_conditions(contest, settings)
    made = {
        **made_with(league, contest.first, contest.second),
        **module_hashes([settings.league, *scene_names(settings.scene)]),
    }
    contest.start("home", [0])  # raises an error before the folder is made if the contest cannot be played
    if settings.out is not None:
        check_team_hashes(made)
    return contest, made


def open_evaluation(
    settings: EvaluateSettings, league: League | None, teams: Mapping[str, Team]
) -> tuple[Contest, ResultsFolder]:
    """Return the contest and folder of an evaluation; ValueError if it cannot be played, or for another's folder."""
    contest, made = prepare_evaluation(settings, league, teams)
    about = {"command": command_of(settings), **date_and_commit()}
    return contest, ResultsFolder(settings.out, EVALUATION, asdict(contest.conditions), made, about, settings.anew)


def play_evaluation(contest: Contest, folder: ResultsFolder, workers: Workers, progress: Progress) -> EvaluationResult:
    """Play the matches that are missing in the folder; return the result of all matches."""
    lines = play_missing_matches(contest, folder, workers, progress)
    result = summarise(contest.conditions, folder.made_with, lines, contest.league.pitch)
    notes: dict[str, str] = {}
    for _, policy, setting, trained, _ in differing_settings(contest):
        notes[policy.name] = ", ".join(filter(None, (notes.get(policy.name), f"{setting} {trained}")))
    return replace(result, trained=notes)


def write_reports(contest: Contest, folder: ResultsFolder, result: EvaluationResult, keep: Keep) -> None:
    """Write the reports of a result and the replays to keep, and last result.json, which says that all is there."""
    folder.write("report.md", markdown(result, folder.about))
    if folder.path is not None:
        kept = keep_replays(contest, result.lines, keep, folder.path)
        folder.write("report.html", page_of(result, folder.about, kept))
    folder.write("result.json", result_text(result))


def result_text(result: EvaluationResult) -> str:
    """Return the contents of result.json."""
    return json.dumps(result.as_dict(), indent=2) + "\n"


def play_missing_matches(
    contest: Contest, folder: ResultsFolder, workers: Workers, progress: Progress
) -> list[MatchLine]:
    """Play every match that is missing in the folder; return the result lines of all matches."""
    conditions = contest.conditions
    lines = list(folder.results(MATCHES, MatchLine, "match").values())
    for line in lines:
        check_line(line, conditions.players)
    done = {line.match for line in lines}
    progress.skip(len(done) * steps_of_match(contest))

    def take(batch: list[MatchLine]) -> None:
        folder.add(MATCHES, batch)
        lines.extend(batch)
        progress.note(f"{len(lines)} of {conditions.matches} matches")

    play_matches(contest, done, folder.settings, workers, take, progress.advance)
    return lines


def steps_of_match(contest: Contest) -> float:
    """Return the number of control steps of a match without extra time."""
    return contest.conditions.minutes * 60.0 * contest.league.control_rate


def draw_first_match(contest: Contest, folder: ResultsFolder, result: EvaluationResult) -> None:
    """Play the first match again and draw pictures of it; RuntimeError if it ends in another state than before."""
    from soccer_env.render import Picture, contact_sheet, save_png
    from soccer_env.render.canvas import require_pygame

    assert folder.path is not None
    try:
        require_pygame()
    except ImportError as error:
        print(f"no picture: {error}", file=sys.stderr)
        return
    line = result.lines[0]
    match = contest.start(line.side, [line.seed])
    picture, title = Picture(match.league, WIDTH), (result.conditions.home, result.conditions.away)
    frames = [picture.draw(*moment, title=title) for moment in collect_moments(match, line.steps)]
    if match.state_hash(0) != line.state:
        raise RuntimeError(f"match 0 (seed {line.seed}) did not end as it did among others: a bug of soccer_env")
    save_png(contact_sheet(frames, COLUMNS), folder.path / "match.png")


def collect_moments(match: Match, steps: int) -> list[tuple[Any, Any, Any]]:
    """Play a single match to its end; return moments to draw: match record, ball and robots."""
    wanted = set(np.linspace(0, steps - 1, MOMENTS).astype(int).tolist())
    moments: list[tuple[Any, Any, Any]] = []
    goals = 0
    for step in range(steps):
        now = match.matches[0].copy(), match.balls[0].copy(), match.robots[0].copy()
        match.step(None)
        scored = match.events["goal"][0] != NO_TEAM and goals < GOALS
        goals += scored
        if step in wanted or scored:
            moments.append(now)
    return moments
