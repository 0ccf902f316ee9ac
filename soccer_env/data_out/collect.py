"""Play a replay and collect places and events of its first match, for the data formats.

Frame 0 is the start of the recording, frame n comes after control step n. Places are in the field frame: origin at
the centre spot, x along the pitch, y to the left of it; home attacks +x where `direction` is +1.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.data_out.belief_errors import BeliefErrors, errors_in
from soccer_env.data_out.events import Event, Listener
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.thoughts.thoughts import Notes
from soccer_env.types import AWAY, HOME, Phase

if TYPE_CHECKING:
    from soccer_env.thoughts.thoughts import RecordedMatch

SHOOT_OUT = 5  # period, as kloppy and the Common Data Format number it
SIDES = {HOME: "home", AWAY: "away"}
PHASES = {int(phase): phase.name.lower() for phase in Phase}
ROBOT_FIELDS = ("x", "y", "heading", "vx", "vy", "active", "has_ball")
MATCH_FIELDS = ("half", "clock", "phase", "placing", "home_direction", "shoot_out")


@dataclass(frozen=True)
class Player:
    """A robot: its row, its name such as `home_0`, its side, its number in the team, and whether it is goalkeeper."""

    row: int
    name: str
    side: str
    number: int
    keeper: bool


@dataclass(frozen=True)
class MatchRecording:
    """The first match of a replay; arrays have a row for each of T frames."""

    name: str  # of the match: the file's
    league: League
    teams: tuple[str, str]  # who played home and away
    players: tuple[Player, ...]
    robots: dict[str, np.ndarray]  # (T, R) of ROBOT_FIELDS
    ball: np.ndarray  # (T, 4): x, y [m], vx, vy [m/s]
    match: dict[str, np.ndarray]  # (T,) of MATCH_FIELDS
    score: np.ndarray  # (T, 2)
    events: list[Event]
    noted: np.ndarray  # (N,) frames whose beliefs are known, a few a second
    beliefs: BeliefErrors | None = None  # of these frames, N in place of M; if asked for

    def __len__(self) -> int:
        return len(self.ball)

    @property
    def time(self) -> np.ndarray:
        """Return the time of each frame [s since the recording began]."""
        return np.arange(len(self)) / self.league.control_rate

    @property
    def periods(self) -> np.ndarray:
        """Return the period of each frame: 1 and 2 are the halves, 5 is a shoot-out."""
        return np.where(self.match["shoot_out"] > 0, SHOOT_OUT, self.match["half"] + 1)

    @property
    def in_play(self) -> np.ndarray:
        """Return whether the ball is in play in each frame (T,)."""
        return np.asarray((self.match["phase"] == Phase.PLAY) & (self.match["placing"] == 0))

    def owners(self) -> np.ndarray:
        """Return the only team that has the ball in each frame (T,): HOME, AWAY, or -1 for neither or both."""
        home = np.array([player.side == "home" for player in self.players])
        has = self.robots["has_ball"] == 1
        ours, theirs = has[:, home].any(axis=1), has[:, ~home].any(axis=1)
        return np.where(ours & ~theirs, HOME, np.where(theirs & ~ours, AWAY, -1))


def collect_match(
    replay: RecordedMatch, name: str = "match", note: Callable[[int], None] | None = None, beliefs: bool = False
) -> MatchRecording:
    """Play the first match of a replay and collect its data; `note` is called after each control step.

    `beliefs`: take them from the replay's notes, too. ValueError names the first step that differs from the recording.
    """
    notes = replay.notes() if beliefs else None
    if beliefs and notes is None:
        raise ValueError(f"{name} holds no beliefs: a Recorder keeps them with thoughts=Thoughts(match)")
    playing = replay.play()
    match = next(playing)
    teams, players = replay.teams, players_of(match)
    listener = Listener(match)
    frames = [copy_records(match)]
    for step, played in enumerate(playing, 1):
        listener.listen(played, step)
        frames.append(copy_records(played))
        if note is not None:
            note(1)
    robots, balls, matches, scores = (np.stack(column) for column in zip(*frames, strict=True))
    robots_by_field = {field: robots[field] for field in ROBOT_FIELDS}
    match_by_field = {field: matches[field] for field in MATCH_FIELDS}
    events = listener.sorted_events()
    noted, believed = (np.zeros(0, np.int64), None) if notes is None else noted_beliefs(notes, robots, balls, matches)
    return MatchRecording(
        name, match.league, teams, players, robots_by_field, balls, match_by_field, scores, events, noted, believed
    )


def noted_beliefs(
    notes: Notes, robots: np.ndarray, balls: np.ndarray, matches: np.ndarray
) -> tuple[np.ndarray, BeliefErrors]:
    """Return the frames of notes, and the beliefs noted there beside the truth (T, R), (T, 4), (T,)."""
    noted = notes.steps
    if not ((noted >= 0) & (noted < len(robots))).all():
        raise ValueError("the thoughts of this replay are damaged: they are of other steps than it has")
    ball = {"x": balls[noted, 0], "y": balls[noted, 1]}
    return noted, errors_in(notes, robots[noted], ball, matches["home_direction"][noted])


def copy_records(match: Match) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return copies of the present robots (R,), ball (4,), match and score (2,)."""
    ball, record = match.balls[0], match.matches[0]
    state = np.array([ball["x"], ball["y"], ball["vx"], ball["vy"]])
    return (
        match.robots[[*ROBOT_FIELDS, "team"]][0].copy(),
        state,
        record[list(MATCH_FIELDS)].copy(),
        record["score"].copy(),
    )


def players_of(match: Match) -> tuple[Player, ...]:
    """Return the robots of the first match, in the order of their rows."""
    return tuple(
        Player(row, name, SIDES[int(robot["team"])], int(robot["number"]), bool(robot["keeper"]))
        for row, (name, robot) in enumerate(zip(match.agents, match.robots[0], strict=True))
    )
