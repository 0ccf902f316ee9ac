"""A sheet of pictures for each goal: the ball in the goal comes last, as many sheets as are asked for."""

from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("pygame")

import pygame

from soccer_env import Match, staging
from soccer_env.leagues import find_league
from soccer_env.render import Picture
from soccer_env.render.colours import BALL
from soccer_env.train.play.settings import MeasureSettings
from soccer_env.train.play.sheets import COLUMNS, GAP, HEIGHT, WIDTH, GoalSheets, close_up, width_of
from soccer_env.types import Phase


def shoot(folder: Path, goals: int) -> list[Path]:
    """Return the sheets of two matches in each of which the ball rolls into a goal after half a second."""
    settings = MeasureSettings(home="still", away="still", goals=goals)
    match = Match(
        "legged-2001", home=1, away=1, matches=2, keeper=0, seed=1, controllers={"home": "still", "away": "still"}
    )
    staging.set_phase(match, Phase.PLAY)
    staging.put(match, 0, 0.0, 0.8)
    staging.put(match, 1, 0.0, -0.8)
    staging.put_ball(match, 1.1, 0.0, 1.0, 0.0)
    staging.begin(match)
    sheets = GoalSheets(settings, folder)
    for _ in range(16):
        match.step(None)
        sheets.look(match)
    return sorted(folder.iterdir())


def test_a_sheet_is_written_for_each_goal_and_no_more_than_asked_for(tmp_path: Path) -> None:
    both = shoot(tmp_path / "two", 2)
    assert [path.name[:16] for path in both] == ["goal-01-match-00", "goal-02-match-01"]
    assert all(path.name.endswith("-home.png") for path in both)
    assert len(shoot(tmp_path / "one", 1)) == 1
    assert shoot(tmp_path / "none", 0) == []


def test_the_last_frame_of_a_sheet_shows_the_ball_in_the_goal(tmp_path: Path) -> None:
    (sheet, _) = shoot(tmp_path, 2)
    pixels = pygame.surfarray.array3d(pygame.image.load(str(sheet))).transpose(1, 0, 2)
    frames = [pixels[GAP:-GAP, left : left + WIDTH] for left in range(GAP, pixels.shape[1] - WIDTH, WIDTH + GAP)]
    assert 2 <= len(frames) <= COLUMNS
    columns = np.flatnonzero((frames[-1] == BALL).all(axis=-1).any(axis=0))
    picture = Picture("legged-2001", width_of(find_league("legged-2001")))
    line, _ = picture.pixel(1.5, 0.0)
    assert columns.min() > line - (picture.width - WIDTH)  # the frame is the right end of the picture


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.0), (-1.4, 0.9), (1.6, 0.0)])
def test_a_close_up_holds_the_ball_and_is_of_one_size(x: float, y: float) -> None:
    match = Match("legged-2001", home=1, away=1, seed=1)
    staging.put_ball(match, x, y)
    picture = Picture(match.league, width_of(match.league))
    frame = close_up(picture, picture.draw(match.matches[0], match.balls[0], match.robots[0]), match.balls[0])
    assert frame.shape == (HEIGHT, WIDTH, 3)
    assert (frame == BALL).all(axis=-1).any()
