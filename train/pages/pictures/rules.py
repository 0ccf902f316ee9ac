"""A sheet with one frame for each rule: a staged situation at the moment of the referee's decision."""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.match import Match, staging
from soccer_env.render import Label, Picture, contact_sheet
from soccer_env.render.colours import WHITE
from soccer_env.types import Foul, Phase

COLUMNS = 3
LETTERS = 0.042  # of a frame's width
TITLE_X, TITLE_Y, WORDS_Y = 0.96, 0.88, -0.88  # [1] of half the pitch: where the words stand

Pose = tuple[float, float, float]  # [m, m, rad]
Staged = tuple[Match, np.ndarray]  # one match, and the actions (1, R, 4) of its robots


class Ruling(NamedTuple):
    """A situation staged to break one rule, and the referee's decision expected in it."""

    rule: str  # its name on the picture
    switches: tuple[str, ...]  # the rules of `soccer list rules` that it shows
    words: str  # the decision in one line
    stage: Callable[[], Staged]
    row: int = -1  # of the robot that is whistled or returns; -1: the decision is an event of the match
    foul: Foul = Foul.NONE  # of that robot; NONE: it returns
    event: str = "annulled"  # the expected field of the match's events
    after: bool = False  # draw the state after the decision, not before
    longest: float = 15.0  # [s] until the decision, at most


def stage_rule(
    league: League, places: Sequence[Pose], ball: tuple[float, ...], robots: Mapping[int, Pose],
    ahead: Mapping[int, float], running: bool = False, rules: str = "league",
    red_2: Mapping[str, float] | None = None, **records: float,
) -> Staged:  # fmt: skip
    """Return a match in play, half of its robots in each team, and the actions to step it with.

    `ball`: place [m, m] and, if it rolls, velocity [m/s, m/s]; `robots`: pose by row, the others at their `places`;
    `ahead`: forward action in -1 to 1 by row, `running`: robots with an action start at that speed; `records`: values
    of fields of the match record, `red_2`: of the record of the robot in row 2.
    """
    match = Match(league, home=len(places) // 2, away=len(places) // 2, seed=1, rules=rules)
    staging.set_phase(match, Phase.PLAY)
    for row, place in enumerate(places):
        speed = ahead.get(row, 0.0) * league.drive.forward if running else 0.0
        staging.put(match, row, *robots.get(row, place), forward=speed)
    x, y, vx, vy = (*ball, 0.0, 0.0)[:4]
    staging.put_ball(match, x, y, vx, vy)
    for name, value in records.items():
        match.matches[name] = value
    for name, value in (red_2 or {}).items():
        match.robots[name][0, 2] = value
    staging.begin_scene(match)
    actions = np.zeros((1, len(places), 4))
    for row, share in ahead.items():
        actions[0, row, 0] = share
    return match, actions


def play_to_whistle(ruling: Ruling) -> tuple[Match, tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Play a staged situation until the whistle; return the match after the whistle, and its records just before.

    ValueError if nobody whistles.
    """
    match, actions = ruling.stage()
    for _ in range(round(ruling.longest * match.league.control_rate)):
        before = match.matches.copy(), match.balls.copy(), match.robots.copy()
        match.step(actions)
        if has_made_decision(ruling, match):
            return match, before
    raise ValueError(f"nobody whistled for {ruling.rule} in {ruling.longest:g} s")


def has_made_decision(ruling: Ruling, match: Match) -> bool:
    """Tell whether the referee made the expected decision in the last step."""
    if ruling.row < 0:
        return bool(match.events[ruling.event][0] > 0)
    events = match.robot_events[0, ruling.row]
    return bool(events["foul"] == ruling.foul if ruling.foul else events["returned"] == 1)


def ruling_frame(ruling: Ruling, width: int) -> np.ndarray:
    """Return the drawing of a ruling, (H, W, 3) uint8, with the rule's name and the decision; no score, no clock."""
    match, before = play_to_whistle(ruling)
    matches, balls, robots = (match.matches, match.balls, match.robots) if ruling.after else before
    wide, high, size = match.league.pitch.length / 2, match.league.pitch.width / 2, LETTERS * width
    title = Label((-TITLE_X * wide, TITLE_Y * high), ruling.rule, WHITE, 1.2 * size, align="left")
    words = Label((0.0, WORDS_Y * high), ruling.words, WHITE, size)
    picture = Picture(match.league, width)
    return picture.draw(matches[0], balls[0], robots[0], overlays=[title, words])[picture.header_height :]


def rules_sheet(rulings: Sequence[Ruling], width: int) -> np.ndarray:
    """Return a sheet, (H, W, 3) uint8, with a frame of the given width for each ruling."""
    return contact_sheet([ruling_frame(ruling, width) for ruling in rulings], COLUMNS)
