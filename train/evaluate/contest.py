"""The matches of one team against another: pairs of matches from one seed with sides swapped, many at once.

Every match follows from its own seed alone, so no result depends on the threads, on the other matches of its batch, or
on where a stopped run went on.
The seed decides which side kicks off first: in a pair each team does so once. A team against itself would play the same
match twice: its matches have a seed each.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from threading import Event

import numpy as np

from soccer_env.agents.policy import Policy
from soccer_env.agents.trained_with import training_differences
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.random_numbers import seeds_for
from soccer_env.scenes import find_scene
from soccer_env.statistics.maps import maps_of_team
from soccer_env.teams import CompiledTeam, ObservingTeam, Team, is_module_team, make_team, registered_teams
from soccer_env.teams.function_teams import FunctionTeam
from soccer_env.train.cluster import Workers
from soccer_env.train.evaluate.results import MatchLine
from soccer_env.train.evaluate.settings import ALL, SIDES, Conditions, EvaluateSettings
from soccer_env.train.evaluate.statistics import match_statistics
from soccer_env.train.written_settings import split_variation

BATCH = 32  # matches side by side for each thread; more gain little, and a run that is killed loses the batch
REPORT_EVERY = 50  # steps between two updates of the progress bar


@dataclass(frozen=True)
class Contest:
    """Two teams, their league, and the conditions of their matches."""

    conditions: Conditions
    league: League
    first: str | Team
    second: str | Team

    @property
    def seeds(self) -> list[int]:
        """Return the seed of each match: the two matches of a pair share one, except in self-play."""
        one, matches = self.conditions.seed, self.conditions.matches
        seeds = seeds_for(one, matches) if self.conditions.self_play else np.repeat(seeds_for(one, matches // 2), 2)
        return seeds.tolist()  # type: ignore[no-any-return]

    def start(self, side: str, seeds: Sequence[int], threads: int = 1) -> Match:
        """Start one match for each seed; the first team plays on `side`, "home" or "away"."""
        conditions, turn = self.conditions, 1 if side == "home" else -1
        teams, sizes, senses = (self.first, self.second)[::turn], conditions.players[::turn], conditions.senses[::turn]
        return Match(
            self.league, home=sizes[0], away=sizes[1], matches=len(seeds), threads=threads,
            seeds=np.array(seeds, np.uint64), senses=dict(zip(SIDES, senses, strict=True)), pose=conditions.pose,
            controllers=dict(zip(SIDES, teams, strict=True)), scene=conditions.scene, rules=conditions.rules,
            placement=conditions.placement, minutes=conditions.minutes,
            variation=split_variation(conditions.variation),
        )  # fmt: skip


def contest_of(conditions: Conditions, league: League, teams: Mapping[str, Team]) -> Contest:
    """Return the contest between the teams that the conditions name; ValueError for an unknown team or a drill."""
    if conditions.scene == ALL or find_scene(conditions.scene).success != "none":
        raise ValueError(
            f"scene {conditions.scene!r} is no start of a match: `soccer evaluate --scene {conditions.scene}` judges "
            "drills, in Python evaluate_drills(settings) of soccer_env.train.evaluate"
        )
    return Contest(conditions, league, *(team_or_name(name, teams) for name in (conditions.home, conditions.away)))


def check_training_conditions(contest: Contest, settings: EvaluateSettings) -> None:
    """Raise ValueError for a policy trained with other senses or pose, unless the settings choose these explicitly."""
    for side, policy, setting, trained, here in differing_settings(contest):
        if getattr(settings, setting) is None:
            flag = f"--{setting}"
            so = "" if policy.observe == "truth" else f", {flag} {here} tests it so"
            raise ValueError(
                f"{getattr(settings, side)!r} was trained with {setting}={trained!r}, evaluations have {here!r} by "
                f"default: {flag} {trained} plays it as it was trained{so}"
            )


def differing_settings(contest: Contest) -> Iterator[tuple[str, Policy, str, str, str]]:
    """Yield (side, policy, setting, value in training, value here) for each setting that differs from training."""
    conditions = contest.conditions
    for side, team, senses in zip(SIDES, (contest.first, contest.second), conditions.senses, strict=True):
        for difference in training_differences(team, senses, conditions.pose):
            yield side, *difference


def team_or_name(name: str, teams: Mapping[str, Team]) -> str | Team:
    """Return the user's team object of that name, or the name itself if the registry knows it."""
    if name in teams:
        return make_team(teams[name])
    try:
        made = make_team(name)
    except ModuleNotFoundError as error:
        raise ValueError(f"team {name!r} cannot be loaded ({error}); known: {', '.join(registered_teams())}") from error
    own = isinstance(made, (ObservingTeam, FunctionTeam)) or is_module_team(name)
    return made if own else name  # read a policy once: its file may change meanwhile


def play_matches(
    contest: Contest, done: set[int], settings: str, workers: Workers,
    take: Callable[[list[MatchLine]], None], advance: Callable[[float], None],
) -> None:  # fmt: skip
    """Play all matches whose numbers are not in `done`; `take` is called with the lines of each batch, in order.

    Each thread, or task on a cluster, plays its own batch. In threads, batches of Python teams run one after another,
    because two threads may not call a team at once. `advance` is called with the number of control steps played, over
    all matches: by every thread, or for each batch that a task has finished.
    """
    matches = contest.conditions.matches
    if isinstance(workers, int):
        play_batches(contest, batches(matches, done, workers), settings, workers, take, advance)
        return
    calls = [(contest, block, settings) for block in split_batches([*batches(matches, done, 1)], workers.cores)]
    for lines in workers.submit(play_alone, calls, prepare=(compile_contest, (contest,))):
        take(lines)
        advance(sum(line.steps for line in lines))


def play_alone(contest: Contest, batch: Sequence[int], settings: str) -> list[MatchLine]:
    """Play a batch of matches to the end on one core, and return their lines."""
    return play(contest, batch, settings, 1, lambda steps: None, Event())


def compile_contest(contest: Contest) -> None:
    """Play one step of a contest's first match, which compiles everything that its matches need."""
    match = contest.start("home", contest.seeds[:1])
    match.step(None)
    match.close()


def play_batches(
    contest: Contest, batches: Iterable[list[int]], settings: str, threads: int,
    take: Callable[[list[MatchLine]], None], advance: Callable[[float], None],
) -> None:  # fmt: skip
    """Play batches of matches; `take` is called with the result lines of each batch, in order."""
    compiled = all(isinstance(make_team(team), CompiledTeam) for team in (contest.first, contest.second))
    at_once = threads if compiled else 1
    stopped = Event()
    with ThreadPoolExecutor(at_once) as pool:
        jobs = [pool.submit(play, contest, batch, settings, threads // at_once, advance, stopped) for batch in batches]
        try:
            for job in jobs:
                take(job.result())
        finally:
            stopped.set()
            pool.shutdown(cancel_futures=True)


def batches(matches: int, done: set[int], threads: int) -> Iterator[list[int]]:
    """Yield the remaining matches in batches of at most BATCH; the first team plays each batch on one side only."""
    pairs = matches // 2
    size = -(-pairs // max(-(-pairs // BATCH), (threads + 1) // 2))  # equal batches, at least one for each thread
    for first in range(0, matches, 2 * size):
        for side in (0, 1):
            batch = [match for match in range(first + side, min(first + 2 * size, matches), 2) if match not in done]
            if batch:
                yield batch


def split_batches(batches: Sequence[list[int]], count: int) -> Iterator[list[int]]:
    """Yield the batches, split evenly where they are fewer than `count`; no match changes its place in their order."""
    parts = -(-count // max(len(batches), 1))
    for batch in batches:
        size = -(-len(batch) // parts)
        yield from (batch[first : first + size] for first in range(0, len(batch), size))


def play(
    contest: Contest, batch: Sequence[int], settings: str, threads: int, advance: Callable[[float], None],
    stopped: Event,
) -> list[MatchLine]:  # fmt: skip
    """Play a batch of matches to the end, or until `stopped` is set; `advance` gets the control steps played."""
    side, seeds = contest.conditions.first_team_side(batch[0]), contest.seeds
    match = contest.start(side, [seeds[number] for number in batch], threads)
    lines: dict[int, MatchLine] = {}
    steps = 0
    try:
        while len(lines) < len(batch) and not stopped.is_set():
            _, _, terminated, truncated = match.step(None)
            steps += 1
            if steps % REPORT_EVERY == 0:
                advance(REPORT_EVERY * len(batch))
            for m in np.flatnonzero(terminated | truncated).tolist():
                if m not in lines:  # read it now: a finished match plays on until its whole batch ends
                    lines[m] = line_of_match(match, m, batch[m], side, settings)
        advance((steps % REPORT_EVERY) * len(batch))
    finally:
        match.close()
    return [lines[m] for m in sorted(lines)]


def line_of_match(match: Match, m: int, number: int, side: str, settings: str) -> MatchLine:
    """Return the result line of match m of a batch at its end: match `number`, the first team on `side`."""
    record = match.matches[m]
    scored = record["score"].tolist()
    ours = SIDES.index(side)  # the score's column
    return MatchLine(
        match=number,
        pair=number // 2,
        seed=int(match.seeds[m]),
        side=side,
        goals_for=scored[ours],
        goals_against=scored[1 - ours],
        steps=int(record["step"]),
        state=match.state_hash(m),
        settings=settings,
        statistics=match_statistics(match.statistics[m], ours),
        maps=maps_of_team(match.statistics[m], ours, match.settings.rows),
    )
