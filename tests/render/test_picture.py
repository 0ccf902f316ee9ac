"""Pictures, sheets and windows: what is drawn depends on the records alone, bad input is refused, pygame is needed."""

import subprocess
import sys

import numpy as np
import pytest

pytest.importorskip("pygame")

import time

import pygame
import pytest

from soccer_env import types
from soccer_env.render import Picture, Window, check_display, png_of_frame, save_png
from tests.render.staged_frames import make_records, stage_picture
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
            frames = (picture.draw(match, ball, robots) for picture in (used[league], Picture(league, 480)))
            assert np.array_equal(*frames)


def test_drawing_leaves_the_records_alone_and_takes_read_only_ones():
    records = make_records()
    before = [record.tobytes() for record in records]
    for record in records:
        record.flags.writeable = False
    Picture("legged-2001").draw(*records)
    assert [record.tobytes() for record in records] == before


@pytest.mark.parametrize("width", (0, -5, 239, 100_000, 480.0, float("nan"), "960", None, True))
def test_a_bad_width_is_a_value_error_that_names_it(width):
    with pytest.raises(ValueError, match=f"width must be .*got {width!r}"):
        Picture("legged-2001", width)


def test_a_pose_that_is_not_finite_is_a_value_error_that_names_it():
    picture, match, ball, robots = stage_picture("legged-2001", width=480)
    robots[2]["heading"] = np.nan
    with pytest.raises(ValueError, match="robot 2 has heading = nan"):
        picture.draw(match, ball, robots)
    robots[2]["heading"], ball["vx"] = 0.0, np.inf
    with pytest.raises(ValueError, match="ball has vx = inf"):
        picture.draw(match, ball, robots)
    with pytest.raises(ValueError, match="unknown league 'cricket'"):
        Picture("cricket")


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


pytest.importorskip("pygame")


def test_a_png_holds_the_frame_and_its_path_ends_so(tmp_path):
    frame = np.random.default_rng(1).integers(0, 256, (30, 41, 3), dtype=np.uint8)
    save_png(frame[:, ::-1], tmp_path / "frame.png")
    read = pygame.surfarray.array3d(pygame.image.load(tmp_path / "frame.png")).swapaxes(0, 1)
    assert np.array_equal(read, frame[:, ::-1])
    with pytest.raises(ValueError, match=r"must end with \.png, got '.*frame\.jpg'"):
        save_png(np.zeros((2, 2, 3), np.uint8), tmp_path / "frame.jpg")
    with pytest.raises(ValueError, match="a frame must be uint8"):
        save_png(np.zeros((2, 2, 3)), tmp_path / "frame.png")


pytest.importorskip("pygame")


@pytest.fixture(autouse=True)
def dummy_driver(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    yield
    pygame.quit()


def make_frame(league="legged-2001", width=320):
    robots = np.zeros(2, types.ROBOT)
    robots["active"] = 1
    return Picture(league, width).draw(np.zeros((), types.MATCH), np.zeros((), types.BALL), robots)


def test_a_window_opens_at_the_first_frame_and_closes():
    window = Window()
    assert not window.is_open
    assert window.show(make_frame()) and window.is_open
    window.close()
    window.close()
    assert not window.is_open and not window.closed_by_user
    assert window.show(make_frame()) and window.is_open
    pygame.quit()
    assert window.show(make_frame()) and window.is_open, "it comes back"
    pygame.quit()
    window.close()


def test_a_window_shows_the_frame():
    window, frame = Window(), make_frame()
    window.show(frame)
    shown = pygame.surfarray.array3d(window._window.get_surface()).swapaxes(0, 1)
    assert np.array_equal(shown, frame)
    window.show(make_frame("middle-size-2006", 400))
    assert window._window.size[0] == 400
    window.close()


def test_a_window_knows_which_keys_are_held_down():
    window = Window()

    def post(kind, **key):
        pygame.event.post(pygame.event.Event(kind, window=window._window, **key))
        window.show(make_frame())

    window.show(make_frame())
    post(pygame.KEYDOWN, key=pygame.K_w)
    post(pygame.KEYDOWN, key=pygame.K_SPACE)
    assert window.held == {"w", "space"} and window.pressed() == ["w", "space"]
    post(pygame.KEYUP, key=pygame.K_w)
    assert window.held == {"space"} and window.pressed() == []
    post(pygame.WINDOWFOCUSLOST)
    assert window.held == set()
    post(pygame.KEYDOWN, key=pygame.K_w)
    window.close()
    assert window.held == set()


def test_frames_keep_real_time():
    window, frame = Window(fps=50.0), make_frame()
    window.show(frame)
    start = time.perf_counter()
    for _ in range(10):
        window.show(frame)
    assert 0.19 < time.perf_counter() - start < 3.0
    window.close()


def test_a_bad_rate_is_a_value_error_that_names_it_and_a_window_takes_frames_only():
    for fps in (0.0, -1.0, float("nan"), 1e9):
        with pytest.raises(ValueError, match=f"fps must be .*got {fps}"):
            Window(fps=fps)
    with pytest.raises(ValueError, match=r"a frame must be uint8 of shape \(H, W, 3\), got float64 of shape \(2, 2\)"):
        Window().show(np.zeros((2, 2)))
