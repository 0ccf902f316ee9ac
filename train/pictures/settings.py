"""What the pictures of the pages show."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "soccer_env" / "pictures"


@dataclass(frozen=True)
class PictureSettings:
    """Draw the pictures of the pages anew: an animation, what a robot believes, the frames, and the rules."""

    out: Path = FOLDER
    """Folder to write match.gif, belief.png, frames.png and the sheets of rules into."""
    league: str = "legged-2001"
    """League of all pictures."""
    home: str = "chaser"
    """Team that plays home in the animation."""
    away: str = "sacks-2001"
    """Team that plays away in the animation."""
    seed: int = 78
    """Seed of the animation's match."""
    longest: float = 60.0
    """[s] of play after which the animation ends if no goal has fallen."""
    every: int = 5
    """Control steps from one frame of the animation to the next."""
    frame_time: float = 0.08
    """[s] for which a frame of the animation is shown."""
    last_time: float = 1.5
    """[s] for which its last frame, the goal, is shown."""
    width: int = 720
    """[px] width of the animation."""
    belief_seed: int = 6
    """Seed of the match in which a robot's belief is drawn."""
    belief_time: float = 20.0
    """[s] of play after which it is drawn."""
    belief_robot: int = 1
    """Row of the robot whose belief is drawn."""
    ruling_width: int = 360
    """[px] width of a frame in the sheets of rules."""
    still_width: int = 1280
    """[px] width of the pictures that do not move."""
