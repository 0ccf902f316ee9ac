"""The last seconds before each goal as a sheet of pictures, so that many goals can be looked at."""

from __future__ import annotations

from collections import deque
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.train.play.settings import MeasureSettings
from soccer_env.types import HOME, NO_TEAM

if TYPE_CHECKING:
    from soccer_env.render import Picture

FRAMES = 20  # on a sheet, the goal last
EVERY = 0.25  # [s] from one frame to the next
COLUMNS = 4
GAP = 4  # [px] between frames
ACROSS = 14.0  # reaches of a robot that a frame around the ball shows: 2.2 m in the legged league, 4 m in middle size
WIDTH, HEIGHT = 480, 344  # [px] of a frame
MOST = 2560  # [px] that a picture of the whole pitch may be wide

Records = tuple[np.ndarray, np.ndarray, np.ndarray]  # of matches (M,), their balls (M,) and robots (M, R)


class GoalSheets:
    """Looks at matches after every step and writes a sheet for each goal, up to the number that is asked for.

    A sheet is called goal-NN-match-MM-at-SSSs-home.png: the match by its row in its block of the measurement, the time
    since its beginning, and who scored.
    """

    def __init__(self, settings: MeasureSettings, folder: Path) -> None:
        from soccer_env.render.canvas import require_pygame

        require_pygame()
        folder.mkdir(parents=True, exist_ok=True)
        self.folder, self.wanted, self.drawn = folder, settings.goals, 0
        self._title = (settings.home, settings.away)
        self._match: Match | None = None
        self._past: deque[Records] = deque(maxlen=FRAMES - 1)
        self._before: Records | None = None  # a step ago

    def look(self, match: Match) -> None:
        """Draw the goals of the step that matches have just made, and remember how they stand."""
        if self.drawn >= self.wanted:
            return
        if match is not self._match:
            self._match, self._before = match, None
            self._past.clear()
        for m in np.flatnonzero(match.events["goal"] != NO_TEAM).tolist():
            if self._before is not None and self.drawn < self.wanted:
                self._draw(match, m, self._before)
        self._before = (match.matches.copy(), match.balls.copy(), match.robots.copy())
        if int(match.matches["step"].max()) % max(1, round(EVERY * match.league.control_rate)) == 0:
            self._past.append(self._before)

    def _draw(self, match: Match, m: int, before: Records) -> None:
        """Write the sheet of a goal that has just fallen in match m."""
        from soccer_env.render import Picture, contact_sheet, save_png

        moments = [tuple(records[m] for records in one) for one in (*self._past, before)]
        last, ball = moments[-1][0], moments[-1][1].copy()
        event = match.events[m]
        ball["x"], ball["y"] = event["ball_x"], event["ball_y"]  # the step of a goal puts all elsewhere
        moments[-1] = (last, ball, moments[-1][2])
        picture = Picture(match.league, width_of(match.league))
        frames = [close_up(picture, picture.draw(*one, title=self._title), one[1]) for one in moments]
        self.drawn += 1
        side = "home" if event["goal"] == HOME else "away"
        seconds = round(int(last["step"]) / match.league.control_rate)
        name = f"goal-{self.drawn:02d}-match-{m:02d}-at-{seconds:03d}s-{side}.png"
        save_png(contact_sheet(frames, COLUMNS, gap=GAP), self.folder / name)


def close_up(picture: Picture, frame: np.ndarray, ball: np.void) -> np.ndarray:
    """Return the part of a frame around the ball, at most HEIGHT by WIDTH pixels."""
    column, row = picture.pixel(float(ball["x"]), float(ball["y"]))
    left = int(np.clip(column - WIDTH // 2, 0, max(0, picture.width - WIDTH)))
    top = int(np.clip(row - HEIGHT // 2, 0, max(0, picture.height - HEIGHT)))
    return frame[top : top + HEIGHT, left : left + WIDTH]


def width_of(league: League) -> int:
    """Return how wide [px] a picture of the whole pitch is if WIDTH pixels of it show ACROSS reaches."""
    pitch = league.pitch
    length = pitch.length + 2.0 * max(pitch.goal_depth, pitch.band_end)
    return min(MOST, round(WIDTH * length / (ACROSS * league.body.reach)))
