"""Play matches until enough goals have fallen, and keep what came before each."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.random_numbers import seeds_for
from soccer_env.statistics.records import GoalKind
from soccer_env.train.play.goals.settings import GoalSettings
from soccer_env.train.play.recording import running, start
from soccer_env.train.play.settings import conditions_of
from soccer_env.train.progress import Progress
from soccer_env.types import AWAY, HOME, NO_TEAM, Foul, Phase

BLOCK = 16  # matches side by side
BEFORE = 10.0  # [s] before a goal that are kept
SIDES = ("home", "away")

Moment = tuple[np.ndarray, np.ndarray, np.ndarray]  # of matches (M,), their balls (M,) and robots (M, R)
MatchMoment = tuple[np.void, np.void, np.ndarray]  # of one of them


class Call(NamedTuple):
    """Something that the referee called."""

    step: int
    name: str  # as statistics name it: fouls_pushing, restarts_throw_in, separations, drops, annulled
    team: int  # whose foul or restart it is, or NO_TEAM


@dataclass(frozen=True, eq=False)
class SeenGoal:
    """A goal, how the statistics of play class it, and the seconds before it."""

    match: int  # of all that are played, in the order of their seeds
    seconds: float  # since the beginning of the match
    team: int  # that scores: HOME or AWAY
    direction: int  # of x, +1 or -1, in which it attacks
    kind: GoalKind
    before: dict[str, bool]  # names of statistics of goals, and whether this one counts there
    calls: tuple[tuple[float, str], ...]  # [s] before the goal, and what the referee called, in words
    moments: list[MatchMoment]  # of the match alone, one each control step, the last with the ball in the goal

    def as_dict(self) -> dict[str, object]:
        """Return what goals.jsonl holds."""
        return {
            "match": self.match,
            "seconds": round(self.seconds, 3),
            "team": SIDES[self.team],
            "kind": self.kind.name.lower(),
            "before": [name for name, counts in self.before.items() if counts],
            "calls": [[round(ago, 3), words] for ago, words in self.calls],
        }


@dataclass(frozen=True)
class SeenGoals:
    """The goals of a look at matches."""

    league: League
    goals: list[SeenGoal]  # as many as were asked for, or all
    fallen: int  # in all matches
    matches: int  # that were played


class Watcher:
    """Looks at matches after every step and keeps their goals."""

    def __init__(self, match: Match, first: int) -> None:
        self.goals: list[SeenGoal] = []
        self._match, self._first = match, first
        length = round(BEFORE * match.league.control_rate)
        self._past: deque[Moment] = deque([self._moment()], maxlen=length + 1)
        self._calls: list[deque[Call]] = [deque(maxlen=50) for _ in range(match.count)]
        self._counted = match.statistics.copy()

    def look(self) -> None:
        """Note the goals and calls of the step that the matches have just made."""
        match = self._match
        for m in np.flatnonzero(match.events["goal"] != NO_TEAM).tolist():
            self.goals.append(self._goal(m))
        for m in np.flatnonzero(has_calls(match)).tolist():
            self._calls[m].extend(calls_of(match, m))
        self._past.append(self._moment())
        self._counted[:] = match.statistics

    def _moment(self) -> Moment:
        match = self._match
        return match.matches.copy(), match.balls.copy(), match.robots.copy()

    def _goal(self, m: int) -> SeenGoal:
        """Return the goal that has just fallen in match m; its step has put everybody elsewhere."""
        match, event, team = self._match, self._match.events[m], int(self._match.events["goal"][m])
        moments = [(matches[m], balls[m], robots[m]) for matches, balls, robots in self._past]
        last, ball, robots = moments[-1]
        ball = ball.copy()
        ball["x"], ball["y"] = event["ball_x"], event["ball_y"]
        rate, step = match.league.control_rate, int(match.matches["step"][m])
        calls = tuple(
            ((step - call.step) / rate, in_words(call)) for call in self._calls[m] if step - call.step <= BEFORE * rate
        )
        now, counted = match.statistics[m], self._counted[m]
        return SeenGoal(
            match=self._first + m,
            seconds=step / rate,
            team=team,
            direction=1 if event["ball_x"] > 0.0 else -1,
            kind=GoalKind(int((now["goals"][team] - counted["goals"][team]).argmax())),
            before=before_of(now, counted, team),
            calls=calls,
            moments=[*moments, (last, ball, robots)],
        )


def before_of(now: np.void, counted: np.void, team: int) -> dict[str, bool]:
    """Return which statistics of what came before a goal count the last one."""
    names = {
        "goals_solo": "solo",
        "goals_after_separation": "after_separation",
        "goals_after_pushed_keeper": "after_pushed_keeper",
    }
    found = {name: bool(now[field][team] > counted[field][team]) for name, field in names.items()}
    for phase in (p for p in Phase if p not in (Phase.PLAY, Phase.OVER)):
        more = now["after_restart"][team, phase] > counted["after_restart"][team, phase]
        found[f"goals_after_{phase.name.lower()}"] = bool(more)
    return found


def has_calls(match: Match) -> np.ndarray:
    """Tell in which matches (M,) the referee called something in the last step."""
    events = match.events
    found: np.ndarray = (
        (events["foul"] != 0) | (events["restart"] != 0) | (events["separated"] == 1) | (events["annulled"] == 1)
    )
    return found


def calls_of(match: Match, m: int) -> Iterator[Call]:
    """Yield what the referee called in match m in the last step."""
    event, step = match.events[m], int(match.matches["step"][m])
    fouls, teams = match.robot_events["foul"][m], match.robots["team"][m]
    if not fouls.any() and event["foul"] != 0:
        yield Call(step, f"fouls_{Foul(int(event['foul'])).name.lower()}", int(event["foul_team"]))
    for row in np.flatnonzero(fouls).tolist():
        yield Call(step, f"fouls_{Foul(int(fouls[row])).name.lower()}", int(teams[row]))
    if event["annulled"] == 1:
        yield Call(step, "annulled", NO_TEAM)
    if event["separated"] == 1:
        yield Call(step, "separations", NO_TEAM)
    if event["restart"] != 0:
        dropped = event["restart_team"] == NO_TEAM
        phase = Phase(int(event["restart"])).name.lower()
        yield Call(step, "drops" if dropped else f"restarts_{phase}", int(event["restart_team"]))


def in_words(call: Call) -> str:
    """Return a call as a few words."""
    whose = {HOME: "home: ", AWAY: "away: "}.get(call.team, "")
    known = {"separations": "separation", "drops": "dropped ball", "annulled": "goal annulled"}
    return whose + known.get(call.name, call.name.partition("_")[2].replace("_", " "))


def watch(settings: GoalSettings) -> SeenGoals:
    """Play blocks of matches to their ends until enough goals have fallen, or all matches are played."""
    conditions = conditions_of(settings)
    seeds = seeds_for(settings.seed, settings.matches).tolist()
    found: list[SeenGoal] = []
    played = 0
    with Progress(f"goals of {settings.home} against {settings.away}", settings.goals) as bar:
        while played < settings.matches and len(found) < settings.goals:
            match = start(conditions, seeds[played : played + BLOCK])
            watcher = Watcher(match, played)
            for _ in running(match):
                watcher.look()
            found += sorted(watcher.goals, key=lambda goal: (goal.match, goal.seconds))
            played += match.count
            bar.advance(len(watcher.goals))
            match.close()
    return SeenGoals(conditions.league, found[: settings.goals], len(found), played)
