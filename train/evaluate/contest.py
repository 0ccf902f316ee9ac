"""The matches of one team against another: pairs from the same seeds with sides swapped, many at once.

Every match follows from its own seed alone, so that no result depends on threads or on who else is played beside it.
The seed says which side kicks off first: in a pair each team does so once.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from threading import Event

import numpy as np

from soccer_env.agents.policy import Policy
from soccer_env.agents.trained_with import differences
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.random_numbers import seeds_for
from soccer_env.scenes import find_scene
from soccer_env.statistics.maps import maps_of
from soccer_env.teams import CompiledTeam, ObservingTeam, Team, in_module, make_team, registered
from soccer_env.teams.function_teams import FunctionTeam
from soccer_env.train.evaluate.results import MatchLine
from soccer_env.train.evaluate.settings import Conditions, EvaluateSettings
from soccer_env.train.evaluate.statistics import line_of_statistics

BATCH = 32  # matches side by side for each thread; more gain little, and a run that is killed loses the batch
REPORT_EVERY = 50  # steps between two movements of the progress bar


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
        teams = (self.first, self.second)
        sizes = asked.players
        senses = asked.senses
        if side == "away":
            teams = teams[::-1]
            sizes = sizes[::-1]
            senses = senses[::-1]
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
            rules=asked.rules,
            placement=asked.placement,
            minutes=asked.minutes,
        )


def contest_of(conditions: Conditions, league: League, teams: Mapping[str, Team]) -> Contest:
    """Find the teams; ValueError for an unknown one and for a drill."""
    scene = find_scene(conditions.scene)
    if scene.success != "none":
        how = f"run_drill({league.name!r}, {scene.name!r}, {conditions.home!r}, runs=100)"
        raise ValueError(
            f"scene {scene.name!r} is a drill, evaluations play matches: `soccer record --scene {scene.name}` plays it "
            f"once, in Python {how} of soccer_env.train.evaluate.drills says how many of a hundred runs succeed"
        )
    return Contest(conditions, league, *(find_team(name, teams) for name in (conditions.home, conditions.away)))


def check_trained(contest: Contest, settings: EvaluateSettings) -> None:
    """Raise ValueError, with the flag, for a policy that learned by other senses if nobody asked for any."""
    for side, policy, setting, trained, here in trained_otherwise(contest):
        if getattr(settings, setting) is None:
            flag = f"--{setting}"
            so = "" if policy.observe == "truth" else f", {flag} {here} tests it so"
            raise ValueError(
                f"{getattr(settings, side)!r} was trained with {setting}={trained!r}, evaluations have {here!r} by "
                f"default: {flag} {trained} plays it as it was trained{so}"
            )


def trained_otherwise(contest: Contest) -> Iterator[tuple[str, Policy, str, str, str]]:
    """Yield side, policy, setting, its value in training and here, wherever a policy was trained with another."""
    asked = contest.conditions
    for side, team, senses in zip(("home", "away"), (contest.first, contest.second), asked.senses, strict=True):
        for found in differences(team, senses, asked.pose):
            yield side, *found


def find_team(name: str, teams: Mapping[str, Team]) -> str | Team:
    """Return the team object of that name, or the name itself if the registry knows it."""
    if name in teams:
        return make_team(teams[name])
    try:
        made = make_team(name)
    except ModuleNotFoundError as error:
        raise ValueError(f"team {name!r} cannot be loaded ({error}); known: {', '.join(registered())}") from error
    own = isinstance(made, (ObservingTeam, FunctionTeam)) or in_module(name)
    return made if own else name  # a policy is read once: its file may change meanwhile


def play_matches(
    contest: Contest, done: set[int], settings: str, threads: int,
    take: Callable[[list[MatchLine]], None], advance: Callable[[float], None],
) -> None:  # fmt: skip
    """Play all matches that are not `done` yet; `take` gets the lines of each batch, in order.

    A thread plays a batch by itself. Teams in Python are played batch by batch, as two threads may not call them at
    once. `advance` is called from all threads, with the control steps that were done, over all matches.
    """
    conditions = contest.conditions
    play_batches(contest, batches(conditions.matches, done, threads), settings, threads, take, advance)


def play_batches(
    contest: Contest, batches: Iterable[list[int]], settings: str, threads: int,
    take: Callable[[list[MatchLine]], None], advance: Callable[[float], None],
) -> None:  # fmt: skip
    """Play batches of matches, the first team on the same side in all of one; `take` gets their lines in order."""
    compiled = all(isinstance(make_team(team), CompiledTeam) for team in (contest.first, contest.second))
    at_once = threads if compiled else 1
    seeds = seeds_for(contest.conditions.seed, contest.conditions.matches // 2).tolist()
    stopped = Event()
    with ThreadPoolExecutor(at_once) as pool:
        jobs = [
            pool.submit(play, contest, batch, seeds, settings, threads // at_once, advance, stopped)
            for batch in batches
        ]
        try:
            for job in jobs:
                take(job.result())
        finally:
            stopped.set()
            pool.shutdown(cancel_futures=True)


def batches(matches: int, done: set[int], threads: int) -> Iterator[list[int]]:
    """Yield the matches still to play, `BATCH` at once or fewer, the first team on the same side in all of a batch."""
    pairs = matches // 2
    size = -(-pairs // max(-(-pairs // BATCH), (threads + 1) // 2))  # of equal batches, one for each thread at least
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
    stopped: Event,
) -> list[MatchLine]:
    """Play a batch to the end, unless that is `stopped`; `advance` gets the control steps of all its matches."""
    side = side_of(batch[0])
    match = contest.start(side, [seeds[number // 2] for number in batch], threads)
    lines: dict[int, MatchLine] = {}
    steps = 0
    try:
        while len(lines) < len(batch) and not stopped.is_set():
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
    return [lines[m] for m in sorted(lines)]


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
        statistics=line_of_statistics(match.statistics[m], ours),
        maps=maps_of(match.statistics[m], ours, match.settings.rows),
    )
