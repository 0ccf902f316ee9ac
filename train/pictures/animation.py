"""A match as a GIF: from kick-off to the first goal, and a moment after it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from soccer_env.match import Match
from soccer_env.render import Picture
from soccer_env.train.pictures.settings import PictureSettings

AFTER_GOAL = 14  # frames for which the goal is shown
COLOURS = 128  # of the GIF, the same for all its frames


def frames_of(settings: PictureSettings) -> list[np.ndarray]:
    """Play the match and return its frames (H, W, 3) uint8, the last of them after the goal."""
    controllers = {"home": settings.home, "away": settings.away}
    match = Match(settings.league, controllers=controllers, pose="particles", seed=settings.seed)
    picture = Picture(match.league, settings.width)
    frames: list[np.ndarray] = []
    left = AFTER_GOAL
    while match.matches["step"][0] <= settings.longest * match.league.control_rate and left and not match.terminated[0]:
        left -= bool(match.matches["score"][0].any())
        records = match.matches[0], match.balls[0], match.robots[0]
        frames.append(picture.draw(*records, title=(settings.home, settings.away)))
        for _ in range(settings.every):
            match.step()
    return frames


def write_gif(frames: list[np.ndarray], path: Path, frame_time: float) -> None:
    """Write frames as a GIF that repeats for ever, all in the colours of one palette."""
    from PIL import Image

    images = [Image.fromarray(frame) for frame in frames]
    samples = frames[:: max(1, len(frames) // 6)]
    palette = Image.fromarray(np.concatenate(samples)).quantize(COLOURS)
    first, *others = (image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images)
    first.save(path, save_all=True, append_images=others, duration=round(1000 * frame_time), loop=0, optimize=True)
