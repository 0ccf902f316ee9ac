"""A sheet with one frame a rule: a staged situation at the moment at which it is judged."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from soccer_env.match import Match
from soccer_env.render import Label, Picture, contact_sheet
from soccer_env.render.colours import WHITE
from soccer_env.types import Foul

COLUMNS = 3
LETTERS = 0.042  # of a frame's width
TITLE_X, TITLE_Y, WORDS_Y = 0.96, 0.88, -0.88  # [1] of half the pitch: where the words stand


class Ruling(NamedTuple):
    """A rule's situation: how it is staged, and what is to happen."""

    rule: str  # its name on the picture
    switches: tuple[str, ...]  # what it shows of `soccer list rules`
    words: str  # what happens, a line
    stage: Callable[[], tuple[Match, np.ndarray]]  # one match and the actions (1, R, 4) of its robots
    row: int = -1  # of the robot that is whistled; -1: it is the match to which something happens
    foul: Foul = Foul.NONE  # what that robot is whistled for; NONE: it comes back
    event: str = "annulled"  # the field of the match's events that says so
    after: bool = False  # draw what the referee made of it, not what it was
    longest: float = 15.0  # [s] within which it has to happen


def play_to_whistle(ruling: Ruling) -> tuple[Match, tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Play a staged situation until the whistle; return the match after it and its records just before.

    ValueError if nobody whistles.
    """
    match, actions = ruling.stage()
    for _ in range(round(ruling.longest * match.league.control_rate)):
        before = match.matches.copy(), match.balls.copy(), match.robots.copy()
        match.step(actions)
        if has_happened(ruling, match):
            return match, before
    raise ValueError(f"nobody whistled for {ruling.rule} in {ruling.longest:g} s")


def has_happened(ruling: Ruling, match: Match) -> bool:
    """Tell whether the last step brought what a ruling waits for."""
    if ruling.row < 0:
        return bool(match.events[ruling.event][0] > 0)
    events = match.robot_events[0, ruling.row]
    return bool(events["foul"] == ruling.foul if ruling.foul else events["returned"] == 1)


def ruling_frame(ruling: Ruling, width: int) -> np.ndarray:
    """Return the frame of a ruling, (H, W, 3) uint8, with its name and what happens, but without score and clock."""
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
