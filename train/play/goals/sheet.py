"""The last seconds before a goal as a sheet of frames, the last second in small steps, so that it can be looked at."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.render import Label, Picture, Polyline, contact_sheet, save_png
from soccer_env.render.canvas import Canvas, new_surface
from soccer_env.render.colours import BALL_SHINE, PANEL, TEAM_NAMES, TEAMS_LIGHT, WHITE
from soccer_env.train.play.goals.settings import GoalSettings
from soccer_env.train.play.goals.watching import SIDES, SeenGoal, SeenGoals

AGO = (10.0, 8.0, 6.5, 5.0, 4.0, 3.2, 2.6, 2.0, 1.6, 1.2, 0.9, 0.6, 0.4, 0.2, 0.1, 0.0)  # [s] of the frames
COLUMNS = 4
GAP = 4  # [px] between frames
ACROSS = 14.0  # reaches of a robot that a frame around the ball shows: 2.2 m in the legged league, 4 m in middle size
WIDTH, HEIGHT = 420, 300  # [px] of a frame
MOST = 2560  # [px] that a picture of the whole pitch may be wide
LETTERS, LINE = 18.0, 26  # [px] of words, from one line of them to the next
PATH = 2.0  # [s] of the ball's way that a frame shows


def draw_sheets(seen: SeenGoals, settings: GoalSettings) -> list[Path]:
    """Write the sheets of the first goals into the folder, in place of those of an earlier look; return their files.

    A sheet is called goal-NN-match-MMM-at-SSSs-home-KIND.png, by the goal's match, its time and who scored how.
    """
    picture = Picture(seen.league, width_of(seen.league))
    for old in settings.out.glob("goal-*-match-*-at-*s-*.png"):
        old.unlink()
    files = []
    for number, goal in enumerate(seen.goals[: settings.sheets], start=1):
        name = f"goal-{number:02d}-match-{goal.match:03d}-at-{goal.seconds:03.0f}s-{SIDES[goal.team]}"
        files.append(settings.out / f"{name}-{goal.kind.name.lower().replace('_', '-')}.png")
        save_png(sheet_of(picture, goal, (settings.home, settings.away)), files[-1])
    return files


def sheet_of(picture: Picture, goal: SeenGoal, teams: tuple[str, str]) -> np.ndarray:
    """Return the sheet of a goal, (H, W, 3) uint8, below what the statistics say of it."""
    rate = picture.league.control_rate
    places = sorted({max(len(goal.moments) - 1 - round(ago * rate), 0) for ago in AGO})
    frames = [frame_of(picture, goal, place) for place in places]
    sheet = contact_sheet(frames, COLUMNS, gap=GAP)
    return np.concatenate([words_over(sheet.shape[1], headlines(goal, teams)), sheet])


def frame_of(picture: Picture, goal: SeenGoal, place: int) -> np.ndarray:
    """Return a frame around the ball, (HEIGHT, WIDTH, 3) at most, with the time before the goal and the ball's way."""
    league, (match, ball, robots) = picture.league, goal.moments[place]
    left, top = corner_of(picture, ball)
    first = max(place - round(PATH * league.control_rate), 0)
    way = [(float(one["x"]), float(one["y"])) for _, one, _ in goal.moments[first : place + 1]]
    ago = (len(goal.moments) - 1 - place) * league.dt
    x, y = picture.pixel(way[-1][0], way[-1][1])
    words = Label(way[-1], f"{-ago:.2f} s" if ago else "goal", WHITE, LETTERS, (left + 8.0 - x, top + 14.0 - y), "left")
    frame = picture.draw(match, ball, robots, overlays=[Polyline(way, BALL_SHINE, under=True), words])
    return frame[top : top + HEIGHT, left : left + WIDTH]


def corner_of(picture: Picture, ball: np.void) -> tuple[int, int]:
    """Return column and row of the upper left corner of the part around the ball."""
    column, row = picture.pixel(float(ball["x"]), float(ball["y"]))
    left = int(np.clip(column - WIDTH // 2, 0, max(0, picture.width - WIDTH)))
    lowest = max(picture.header_height, picture.height - HEIGHT)
    return left, int(np.clip(row - HEIGHT // 2, picture.header_height, lowest))


def headlines(goal: SeenGoal, teams: tuple[str, str]) -> list[str]:
    """Return what the statistics say of a goal, in three lines."""
    whose = f"{TEAM_NAMES[goal.team]} ({SIDES[goal.team]}, {teams[goal.team]}) scores to the "
    before = [name.removeprefix("goals_").replace("_", " ") for name, counts in goal.before.items() if counts]
    calls = [f"{ago:.1f} s {words}" for ago, words in goal.calls]
    return [
        f"{goal.kind.name.replace('_', ' ')}: {whose}{'right' if goal.direction > 0 else 'left'}, "
        f"match {goal.match}, {goal.seconds:.1f} s",
        f"counted as: {', '.join(before) or '-'}",
        f"called before: {'; '.join(calls) or '-'}",
    ]


def words_over(width: int, lines: Sequence[str]) -> np.ndarray:
    """Return a strip of words, (H, W, 3) uint8; the first line is in the colour of home (red) or away."""
    import pygame

    height = LINE * len(lines) + GAP
    surface = new_surface(width, height)
    canvas = Canvas(surface)
    canvas.fill(PANEL)
    for row, line in enumerate(lines):
        colour = TEAMS_LIGHT[0 if f": {TEAM_NAMES[0]} " in line else 1] if row == 0 else WHITE
        canvas.text(line, (2.0 * GAP, GAP + LINE * (row + 0.5)), LETTERS, colour, "left", width - 4.0 * GAP)
    canvas.shrink()
    return np.frombuffer(pygame.image.tobytes(surface, "RGB"), np.uint8).reshape(height, width, 3)


def width_of(league: League) -> int:
    """Return how wide [px] a picture of the whole pitch is if WIDTH pixels of it show ACROSS reaches."""
    pitch = league.pitch
    length = pitch.length + 2.0 * max(pitch.goal_depth, pitch.band_end)
    return min(MOST, round(WIDTH * length / (ACROSS * league.body.reach)))
