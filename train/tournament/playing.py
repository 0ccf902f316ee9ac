"""Play a tournament: each pairing is an evaluation, with its own folder below that of the tournament.

result = tournament(TournamentSettings(teams="chaser,random,walker", matches=20))
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from pathlib import Path

from soccer_env.guards.checking import short_repr
from soccer_env.guards.names import MODULE_PATH
from soccer_env.guards.whole_files import read_regular_file
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.teams import Team, is_module_team
from soccer_env.train.cluster import Workers, open_workers
from soccer_env.train.evaluate.contest import Contest, team_or_name
from soccer_env.train.evaluate.evaluation import (
    open_evaluation,
    play_evaluation,
    prepare_evaluation,
    result_text,
    steps_of_match,
    write_reports,
)
from soccer_env.train.evaluate.replays import Keep, kept_in
from soccer_env.train.files import LARGEST
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import date_and_commit
from soccer_env.train.results_folder import SETTINGS, ResultsFolder, settings_before
from soccer_env.train.tournament.report import page_of
from soccer_env.train.tournament.results import KIND, Pairing, TournamentResult, summarise
from soccer_env.train.tournament.settings import TournamentSettings, command_of, conditions_of, pairing_folder
from soccer_env.train.tournament.systems import Score, count_pairings, next_round
from soccer_env.train.written_settings import split_names

Opened = tuple[Contest, ResultsFolder]


def tournament(
    settings: TournamentSettings, *, league: League | None = None, teams: Mapping[str, Team] | None = None
) -> TournamentResult:
    """Play the pairings still missing in settings.out, and return the result of all.

    `league` replaces the named league by a user's own; `teams` gives names to team objects, which settings.teams may
    then use. Raises ValueError for settings that cannot be played and for a folder with another tournament.
    """
    settings = with_stored_settings(settings)
    league = league or find_league(settings.league)
    found = {name: team_or_name(name, teams or {}) for name in settings.names}
    objects = {name: team for name, team in found.items() if not isinstance(team, str)}  # a policy is read once
    contest, made = check_teams(settings, league, objects)
    conditions = conditions_of(settings, contest.conditions)
    about = {"command": command_of(settings), **date_and_commit()}
    with ResultsFolder(settings.out, KIND, conditions, made, about, settings.anew) as folder:
        total = count_matches(settings) * steps_of_match(contest)
        with Progress("tournament", total) as bar, open_workers(settings.threads, settings.ray) as workers:
            rounds, opened = play_rounds(settings, league, objects, workers, bar)
        for at, played in enumerate(rounds):
            rounds[at] = [report_pairing(pairing, *opened[pairing.folder], settings) for pairing in played]
        result = summarise(conditions, made, rounds, settings.half_width)
        folder.write("result.json", json.dumps(result.as_dict(), indent=2) + "\n")
        if settings.out is not None:
            folder.write("report.html", page_of(result, folder.about))
    return result


def with_stored_settings(settings: TournamentSettings) -> TournamentSettings:
    """Return the settings of the tournament in settings.out, with the teams of `add`, if no teams are given."""
    if settings.teams or settings.out is None:
        return settings
    before = settings_before(settings.out, KIND)
    if before is None:
        raise ValueError(f"{settings.out} holds no tournament: give teams to begin one")
    stored = before["conditions"]
    added = split_names(settings.add, "add") if settings.add else ()
    code = [*filter(is_module_team, map(str, stored["teams"])), *filter(MODULE_PATH.fullmatch, [str(stored["league"])])]
    if code:
        advice = "if you trust it, give all options but --add again, and name a team to add last in --teams"
        raise ValueError(f"{short_repr(code[0])} is code, which is not run because {settings.out} names it: {advice}")
    try:
        known = {x.name: stored[x.name] for x in fields(settings) if x.name in stored}
        known["teams"] = ",".join(dict.fromkeys([*stored["teams"], *added]))
        if settings.matches != TournamentSettings.matches:
            known["matches"] = settings.matches
        return replace(settings, **known, add="")
    except (TypeError, ValueError) as error:
        raise ValueError(f"{settings.out / SETTINGS}: {error}") from error


def check_teams(
    settings: TournamentSettings, league: League, teams: Mapping[str, Team]
) -> tuple[Contest, dict[str, str]]:
    """Return the first contest and the versions; ValueError for a team that cannot play, before anything is played."""
    checked = [
        prepare_evaluation(settings.pairing(first, second), league, teams)
        for first, second in ((0, 1), *((0, team) for team in range(2, len(settings.names))))
    ]
    contest, made = checked[0]
    return contest, {name: value for name, value in made.items() if name not in ("home_team", "away_team")}


def count_matches(settings: TournamentSettings) -> int:
    """Return the number of matches of the whole tournament."""
    return settings.matches * count_pairings(settings.system, len(settings.names), settings.swiss_rounds)


def play_rounds(
    settings: TournamentSettings, league: League, teams: Mapping[str, Team], workers: Workers, bar: Progress
) -> tuple[list[list[Pairing]], dict[str, Opened]]:
    """Play all rounds; return their pairings, and the contest and folder of each pairing by its name."""
    rounds: list[list[Pairing]] = []
    opened: dict[str, Opened] = {}
    names, pairings = settings.names, count_matches(settings) // settings.matches

    def play_pair(pair: tuple[int, int]) -> Pairing:
        first, second = pair
        contest, folder = open_evaluation(settings.pairing(first, second), league, teams)
        name = pairing_folder(first, second, names[first], names[second])
        opened[name] = contest, folder
        bar.rename(f"pairing {len(opened)} of {pairings}, {names[first]} against {names[second]}")
        result = play_evaluation(contest, folder, workers, bar)
        return Pairing(len(rounds) + 1, first, second, result, name)

    while pairs := next_round(settings.system, len(names), settings.swiss_rounds, scores_of(rounds)):
        if isinstance(workers, int):
            rounds.append([*map(play_pair, pairs)])
        else:  # a round's pairings at once, so that none waits for the last block of another
            rounds.append(workers.side_by_side(play_pair, pairs))
    return rounds, opened


def scores_of(rounds: Sequence[Sequence[Pairing]]) -> list[list[Score]]:
    """Return the scores of finished rounds."""
    return [[pairing.score for pairing in played] for played in rounds]


def report_pairing(pairing: Pairing, contest: Contest, folder: ResultsFolder, settings: TournamentSettings) -> Pairing:
    """Write the reports and replays of a pairing, unless they are there; return the pairing with its replays."""
    if folder.path is None:
        return pairing
    if settings.keep or settings.keep_pages or not is_written(folder.path / "result.json", result_text(pairing.result)):
        write_reports(contest, folder, pairing.result, Keep(settings.keep, settings.keep_pages))
    return replace(pairing, kept=tuple(kept_in(folder.path)))


def is_written(path: Path, text: str) -> bool:
    """Tell whether a file holds this text."""
    try:
        return read_regular_file(path, LARGEST) == text.encode()
    except (OSError, ValueError):
        return False
