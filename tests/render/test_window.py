import time

import numpy as np
import pytest

pytest.importorskip("pygame")

import pygame

from soccer_env import types
from soccer_env.render import Picture, Window


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
    window.close()


def test_a_window_shows_the_frame():
    window, frame = Window(), make_frame()
    window.show(frame)
    shown = pygame.surfarray.array3d(window._window.get_surface()).swapaxes(0, 1)
    assert np.array_equal(shown, frame)
    window.show(make_frame("middle-size-2006", 400))
    assert window._window.size[0] == 400
    window.close()


def test_two_windows_stand_side_by_side_and_the_user_closes_one():
    left, right = Window("left"), Window("right")
    assert left.show(make_frame()) and right.show(make_frame("middle-size-2006"))
    pygame.event.post(pygame.event.Event(pygame.WINDOWCLOSE, window=right._window))
    assert left.show(make_frame()) and left.is_open
    assert not right.show(make_frame()) and right.closed_by_user and not right.is_open
    assert not right.show(make_frame()) and not right.is_open
    assert left.show(make_frame())
    left.close()


def test_escape_closes_the_window_it_was_pressed_in():
    window = Window()
    window.show(make_frame())
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_ESCAPE, window=window._window))
    assert not window.show(make_frame()) and window.closed_by_user


def test_a_window_comes_back_after_pygame_quit():
    window = Window()
    window.show(make_frame())
    pygame.quit()
    assert window.show(make_frame()) and window.is_open
    pygame.quit()
    window.close()


def test_frames_keep_real_time():
    window, frame = Window(fps=50.0), make_frame()
    window.show(frame)
    start = time.perf_counter()
    for _ in range(10):
        window.show(frame)
    assert 0.19 < time.perf_counter() - start < 3.0
    window.close()


@pytest.mark.parametrize("fps", (0.0, -1.0, float("nan"), 1e9))
def test_a_bad_rate_is_a_value_error_that_names_it(fps):
    with pytest.raises(ValueError, match=f"fps must be .*got {fps}"):
        Window(fps=fps)


def test_a_window_takes_frames_only():
    with pytest.raises(ValueError, match=r"a frame must be uint8 of shape \(H, W, 3\), got float64 of shape \(2, 2\)"):
        Window().show(np.zeros((2, 2)))
