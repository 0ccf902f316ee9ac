"""A match as a GIF: from kick-off to the first goal, the ball behind the line."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from soccer_env.match import Match
from soccer_env.render import Picture
from soccer_env.train.pictures.settings import PictureSettings
from soccer_env.types import NO_TEAM

COLOURS = 128  # of the GIF, the same for all its frames


def frames_of(settings: PictureSettings) -> list[np.ndarray]:
    """Play the match and return its frames (H, W, 3) uint8; the first goal is the last of them."""
    controllers = {"home": settings.home, "away": settings.away}
    title = (settings.home, settings.away)
    match = Match(settings.league, controllers=controllers, pose="particles", seed=settings.seed)
    picture = Picture(match.league, settings.width)
    frames: list[np.ndarray] = []
    while match.matches["step"][0] <= settings.longest * match.league.control_rate and not match.terminated[0]:
        frames.append(picture.draw(match.matches[0], match.balls[0], match.robots[0], title=title))
        for _ in range(settings.every):
            before = match.robots[0].copy()
            match.step()
            if match.events["goal"][0] != NO_TEAM:
                # The step of a goal places everybody for the kick-off: robots are drawn a step earlier.
                return [*frames, picture.draw(match.matches[0], scoring_ball(match), before, title=title)]
    return frames


def scoring_ball(match: Match) -> np.void:
    """Return the ball of a single match where it lay when the goal was given."""
    ball: np.void = match.balls[0].copy()
    ball["x"], ball["y"] = match.events["ball_x"][0], match.events["ball_y"][0]
    return ball


def write_gif(frames: list[np.ndarray], path: Path, frame_time: float, last_time: float) -> None:
    """Write frames as a GIF that repeats for ever, all in the colours of one palette; times in seconds."""
    from PIL import Image

    images = [Image.fromarray(frame) for frame in frames]
    samples = frames[:: max(1, len(frames) // 6)]
    palette = Image.fromarray(np.concatenate(samples)).quantize(COLOURS)
    first, *others = (image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images)
    times = [*(round(1000 * frame_time) for _ in others), round(1000 * last_time)]
    first.save(path, save_all=True, append_images=others, duration=times, loop=0, optimize=True)
