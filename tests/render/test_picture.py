"""A picture: what it draws depends on the records alone, bad input is refused, and it needs pygame but no display."""

import subprocess
import sys

import numpy as np
import pytest

pytest.importorskip("pygame")

from soccer_env.leagues import find_league
from soccer_env.render import Picture, Window, check_display, png_of_frame
from tests.render.staged_frames import make_records
from tests.scenes.staging import LEAGUES

PIXEL = np.zeros((1, 1, 3), np.uint8)


def test_a_frame_depends_on_its_records_alone():
    rng = np.random.default_rng(3)
    used = {league: Picture(league, 480) for league in LEAGUES}
    for turn in range(6):
        match, ball, robots = make_records(3, 3)
        robots["x"], robots["y"] = rng.uniform(-1.4, 1.4, 6), rng.uniform(-1, 1, 6)
        robots["heading"], robots["has_ball"] = rng.uniform(-3, 3, 6), rng.integers(0, 2, 6)
        match["home_direction"], match["clock"], match["phase"] = (-1) ** turn, turn * 61.0, turn
        ball["x"], ball["vy"] = rng.uniform(-1, 1), rng.uniform(-2, 2)
        for league in LEAGUES:
            assert np.array_equal(
                used[league].draw(match, ball, robots), Picture(league, 480).draw(match, ball, robots)
            )


def test_drawing_leaves_the_records_alone_and_takes_read_only_ones():
    records = make_records()
    before = [record.tobytes() for record in records]
    for record in records:
        record.flags.writeable = False
    Picture("legged-2001").draw(*records)
    assert [record.tobytes() for record in records] == before


def test_records_of_a_batch_are_drawn_one_match_at_a_time():
    match, ball, robots = make_records()
    matches, balls, teams = np.stack([match] * 3), np.stack([ball] * 3), np.stack([robots] * 3)
    balls["x"] = (0.1, 0.2, 0.3)
    picture = Picture("legged-2001", 480)
    ball["x"] = 0.2
    assert np.array_equal(picture.draw(matches[1], balls[1], teams[1]), picture.draw(match, ball, robots))
    with pytest.raises(ValueError, match=r"match must be one record, got shape \(3,\)"):
        picture.draw(matches, balls[0], teams[0])
    with pytest.raises(ValueError, match=r"robots must be records of shape \(R,\), got shape \(3, 4\)"):
        picture.draw(matches[0], balls[0], teams)


@pytest.mark.parametrize("width", (0, -5, 239, 100_000, 480.0, float("nan"), "960", None, True))
def test_a_bad_width_is_a_value_error_that_names_it(width):
    with pytest.raises(ValueError, match=f"width must be .*got {width!r}"):
        Picture("legged-2001", width)


def test_a_pose_that_is_not_finite_is_a_value_error_that_names_it():
    picture = Picture("legged-2001", 480)
    match, ball, robots = make_records()
    robots[2]["heading"] = np.nan
    with pytest.raises(ValueError, match="robot 2 has heading = nan"):
        picture.draw(match, ball, robots)
    robots[2]["heading"], ball["vx"] = 0.0, np.inf
    with pytest.raises(ValueError, match="ball has vx = inf"):
        picture.draw(match, ball, robots)
    with pytest.raises(ValueError, match="unknown league 'cricket'"):
        Picture("cricket")


def test_names_of_any_kind_fit_the_plates():
    picture = Picture(find_league("legged-2001"), 240)
    for title in (("", "x" * 500), ("two\nlines\0", "möwen 2001"), ("\ud800", 7)):
        assert picture.draw(*make_records(), title=title).shape == (picture.height, 240, 3)


def test_pictures_outlive_pygame_quit():
    import pygame

    picture, records = Picture("legged-2001", 480), make_records()
    before = picture.draw(*records)
    pygame.quit()
    records[0]["clock"] = 83.0  # a new word for the header
    assert not np.array_equal(picture.draw(*records), before)


def test_importing_the_package_leaves_pygame_alone_and_a_picture_needs_no_display():
    program = """
import sys, numpy as np
import soccer_env.render
assert "pygame" not in sys.modules
from soccer_env import types
from soccer_env.render import Picture
frame = Picture("legged-2001").draw(np.zeros((), types.MATCH), np.zeros((), types.BALL), np.zeros(2, types.ROBOT))
import pygame
assert not pygame.display.get_init() and frame.any()
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and done.stdout == "", done.stderr


@pytest.mark.parametrize("use", (lambda: Picture("legged-2001"), Window, check_display, lambda: png_of_frame(PIXEL)))
def test_without_pygame_the_error_says_what_to_install(monkeypatch, use):
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(ImportError, match=r'pip install "soccer_env\[render\]"'):
        use()
    monkeypatch.setitem(sys.modules, "pygame", sys)  # stands for the older pygame: no IS_CE
    with pytest.raises(ImportError, match=r"older pygame"):
        use()
