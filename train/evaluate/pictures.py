"""A sheet of pictures of one match: moments spread evenly over it, and the moment before each goal."""

from __future__ import annotations

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.types import NO_TEAM

MOMENTS = 12
GOALS = 8  # shown at most
COLUMNS = 4
WIDTH = 480  # [px] of a picture

Moment = tuple[Any, Any, Any]  # copies of the match record, the ball and the robots (R,)


def require_pictures() -> None:
    """Raise ImportError, which says what to install, unless pictures can be drawn."""
    from soccer_env.render.canvas import require_pygame

    require_pygame()


def draw_match(match: Match, steps: int, title: tuple[str, str]) -> np.ndarray:
    """Play a single match of so many steps to its end and return its sheet (H, W, 3) uint8; `title`: home, away."""
    from soccer_env.render import Picture, contact_sheet

    picture = Picture(match.league, WIDTH)
    frames = [picture.draw(*moment, title=title) for moment in play_moments(match, steps)]
    return contact_sheet(frames, COLUMNS)


def play_moments(match: Match, steps: int) -> list[Moment]:
    """Play a single match to its end and return the moments worth a picture, in order."""
    wanted = set(np.linspace(0, steps - 1, MOMENTS).astype(int).tolist())
    moments: list[Moment] = []
    goals = 0
    for step in range(steps):
        now = match.matches[0].copy(), match.balls[0].copy(), match.robots[0].copy()
        match.step(None)
        scored = match.events["goal"][0] != NO_TEAM and goals < GOALS
        goals += scored
        if step in wanted or scored:
            moments.append(now)
    return moments
