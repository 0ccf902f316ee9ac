"""What the pictures of the pages show."""

from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[3] / "soccer_env" / "pictures"


@dataclass(frozen=True)
class PictureSettings:
    """Draw the pictures of the pages anew: what a robot believes, the frames, the rules, and recorded moments."""

    out: Path = FOLDER
    """Folder to write belief.png, frames.png, the sheets of rules and the recorded moments into."""
    league: str = "legged-2001"
    """League of all pictures."""
    home: str = "chaser"
    """Team that plays home where a robot's belief is drawn."""
    away: str = "sacks-2001"
    """Team that plays away there."""
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
