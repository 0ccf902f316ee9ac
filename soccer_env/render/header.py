"""The bar above the field: names, score, clock, phase, possession."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.render import colours
from soccer_env.render.canvas import Canvas
from soccer_env.render.captions import clock_words, goal_team, half_words, phase_words, possession_words
from soccer_env.render.colours import Colour
from soccer_env.types import NO_TEAM, Phase

SCORE_ROW = 0.56  # of the bar's height; the rest names phase and possession
SIDE = 0.17  # of the width, for the clock on the left and the league on the right
SCORE = 0.15  # of the width


class HeaderContents(NamedTuple):
    """The contents of the bar; an equal story needs no new drawing."""

    title: tuple[str, str]
    score: tuple[int, int]
    clock: str
    half: str
    phase: str
    phase_colour: Colour
    possession: str
    possession_team: int
    goal: int


def bar_height(width: int) -> int:
    """Return the height of the bar for a picture's width [px]; even, and legible in small pictures too."""
    return 2 * round(22.0 + 0.0225 * width)


def header_contents(match: np.void, robots: np.ndarray, title: tuple[str, str], league: League) -> HeaderContents:
    """Return the contents of the bar for the records of a match and its robots."""
    score, (possession, team) = (int(match["score"][0]), int(match["score"][1])), possession_words(match, robots)
    phase, colour = phase_words(match, league.rules), phase_colour(match)
    clock, half, goal = clock_words(match), half_words(match), goal_team(match)
    return HeaderContents(title, score, clock, half, phase, colour, possession, team, goal)


def phase_colour(match: np.void) -> Colour:
    """Return the colour of the lamp beside the phase: of the restarting team, green for play, white after the end."""
    phase, team = int(match["phase"]), int(match["restart_team"])
    if phase == Phase.OVER or int(match["over"]):
        return colours.WHITE
    if phase == Phase.PLAY:
        return colours.PLAY
    return colours.DIM if team == NO_TEAM or phase == Phase.DROP_BALL else colours.TEAMS[team]


class Header:
    """Draw a story onto a canvas, only when it has changed."""

    def __init__(self, canvas: Canvas, league: League) -> None:
        self.canvas, self.league = canvas, league
        self._shown: HeaderContents | None = None

    def draw(self, story: HeaderContents) -> None:
        """Draw the bar unless it already shows this story."""
        if story == self._shown:
            return
        self.canvas.fill(colours.PANEL)
        self._draw_sides(story)
        self._draw_score(story)
        self._draw_chips(story)
        self.canvas.shrink()
        self._shown = story

    def _draw_sides(self, story: HeaderContents) -> None:
        width, row = self.canvas.width, self.canvas.height * SCORE_ROW
        pad, room = 0.014 * width, (SIDE - 0.025) * width
        self.canvas.text(story.clock, (pad, 0.40 * row), 0.66 * row, colours.WHITE, "left", room)
        self.canvas.text(story.half, (pad, 0.80 * row), 0.32 * row, colours.DIM, "left", room)
        family = f"{self.league.family} league"
        self.canvas.text(family, (width - pad, 0.36 * row), 0.34 * row, colours.DIM, "right", room)
        self.canvas.text(self.league.name, (width - pad, 0.72 * row), 0.30 * row, colours.DIM, "right", room)

    def _draw_score(self, story: HeaderContents) -> None:
        width, row = self.canvas.width, self.canvas.height * SCORE_ROW
        plate = (1.0 - 2.0 * SIDE - SCORE) / 2 * width
        top, high = 0.14 * row, 0.80 * row
        for team, left in ((0, SIDE * width), (1, (0.5 + SCORE / 2) * width)):
            if story.goal == team:
                self.canvas.box(left - 3, top - 3, plate + 6, high + 6, colours.KEEPER, 8.0)
            self.canvas.box(left, top, plate, high, colours.TEAMS[team], 6.0)
            middle = (left + plate / 2, top + high / 2)
            self.canvas.text(story.title[team], middle, 0.60 * row, colours.WHITE, room=0.92 * plate)
        middle = (0.5 * width, top + high / 2)
        score = f"{story.score[0]} : {story.score[1]}"
        self.canvas.text(score, middle, 1.08 * row, colours.WHITE, room=0.92 * SCORE * width)

    def _draw_chips(self, story: HeaderContents) -> None:
        width, top = self.canvas.width, self.canvas.height * SCORE_ROW
        high, pad = self.canvas.height - top, 0.014 * width
        phase = f"goal {colours.TEAM_NAMES[story.goal]}!  {story.phase}" if story.goal != NO_TEAM else story.phase
        held = colours.CHIP if story.possession_team == NO_TEAM else colours.TEAMS[story.possession_team]
        lamps = ((phase, story.phase_colour, colours.CHIP), (story.possession, colours.BALL, held))
        for index, (words, lamp, ground) in enumerate(lamps):
            left, wide = pad + index * 0.5 * width, 0.5 * width - 2 * pad
            self.canvas.box(left, top + 0.12 * high, wide, 0.74 * high, ground, 0.37 * high)
            middle = top + 0.49 * high
            if lamp == colours.BALL:
                self.canvas.disc((left + 0.45 * high, middle), 0.25 * high, colours.INK)
            self.canvas.disc((left + 0.45 * high, middle), 0.21 * high, lamp)
            self.canvas.text(words, (left + 0.85 * high, middle), 0.62 * high, colours.WHITE, "left", wide - 1.2 * high)
