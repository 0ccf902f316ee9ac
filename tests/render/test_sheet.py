import numpy as np
import pytest

pytest.importorskip("pygame")

import pygame

from soccer_env.render import contact_sheet, save_png


def test_a_png_holds_the_frame(tmp_path):
    frame = np.random.default_rng(1).integers(0, 256, (30, 41, 3), dtype=np.uint8)
    save_png(frame[:, ::-1], tmp_path / "frame.png")
    read = pygame.surfarray.array3d(pygame.image.load(tmp_path / "frame.png")).swapaxes(0, 1)
    assert np.array_equal(read, frame[:, ::-1])


def test_a_picture_s_path_ends_with_png(tmp_path):
    with pytest.raises(ValueError, match=r"must end with \.png, got '.*frame\.jpg'"):
        save_png(np.zeros((2, 2, 3), np.uint8), tmp_path / "frame.jpg")
    with pytest.raises(ValueError, match="a frame must be uint8"):
        save_png(np.zeros((2, 2, 3)), tmp_path / "frame.png")


def test_a_contact_sheet_shows_frames_row_by_row():
    frames = [np.full((10, 20, 3), 40 * index, np.uint8) for index in range(5)]
    sheet = contact_sheet(frames, columns=3, gap=4)
    assert sheet.shape == (2 * 14 + 4, 3 * 24 + 4, 3)
    for index, frame in enumerate(frames):
        top, left = 4 + 14 * (index // 3), 4 + 24 * (index % 3)
        assert np.array_equal(sheet[top : top + 10, left : left + 20], frame)
    assert contact_sheet(frames[:2], columns=3, gap=0).shape == (10, 40, 3)


def test_bad_sheets_are_value_errors():
    frame = np.zeros((10, 20, 3), np.uint8)
    with pytest.raises(ValueError, match="at least one frame"):
        contact_sheet([])
    with pytest.raises(ValueError, match="columns must be at least 1"):
        contact_sheet([frame], columns=0)
    with pytest.raises(ValueError, match="must have one size"):
        contact_sheet([frame, frame[:5]])
