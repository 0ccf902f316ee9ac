"""The sizes of the pictures, and the moments of the gallery."""

from pathlib import Path
from typing import Any, NamedTuple

FOLDER = Path(__file__).resolve().parents[3] / "soccer_env" / "pictures"
STILL_WIDTH = 1280  # [px] of the pictures that are not films
RULING_WIDTH = 360  # [px] of one rule's frame in the sheets of rules


class Moment(NamedTuple):
    """A picture or film of the gallery."""

    name: str  # of its file
    recorded: dict[str, Any]  # settings of `soccer record`
    shown: dict[str, Any]  # settings of `soccer export`


def drill_moment(scene: str, home: str, seed: int, start: float, league: str = "legged-2001", **shown: Any) -> Moment:
    """Return the gallery's entry for a picture of a drill at a time [s], with the trail of the ball."""
    recorded = {"league": league, "scene": scene, "home": home, "seed": seed}
    return Moment(f"{scene}.png", recorded, {"start": start, "width": WIDTH, "trail": True, "robot": "home_0", **shown})


WIDTH = 640  # [px] of the pictures in the gallery of the README, which shows two in a row
MIDDLE_SIZE = "middle-size-2006"
HEINEMANN: dict[str, Any] = {"league": MIDDLE_SIZE, "path": True}
MOMENTS = (
    Moment(
        "match.gif",
        {"league": MIDDLE_SIZE, "home": "learned-2006", "away": "chaser", "players": 2, "seed": 1, "minutes": 1.5},
        {"start": 6.5, "seconds": 9.0, "width": 600, "speed": 2.0, "fps": 10.0},
    ),
    Moment(
        "middle-size.gif",
        {"league": MIDDLE_SIZE, "home": "heinemann-2006", "away": "weigel-2001", "minutes": 1.0, "seed": 3},
        {"start": 14.0, "seconds": 12.0, "speed": 2.0, "width": 480, "path": True, "trail": True},
    ),
    Moment(
        "legged.png",
        {"home": "sacks-2001", "away": "chaser", "minutes": 4.0, "seed": 5},
        {"start": 12.0, "width": WIDTH, "sight": True, "robot": "home_1"},
    ),
    Moment(
        "unequal.png",
        {"league": MIDDLE_SIZE, "home": "heinemann-2006", "away": "chaser", "players": "5v2", "minutes": 0.5},
        {"start": 6.0, "width": WIDTH, "trail": True},
    ),
    Moment(
        "field.png",
        {"scene": "dribble-past-two", "home": "sacks-2001", "seed": 1},
        {"start": 3.0, "width": WIDTH, "robot": "home_0", "field": True, "path": True},
    ),
    drill_moment("empty-goal", "chaser", 1, 2.5),
    drill_moment("shot-at-keeper", "chaser", 1, 0.6),
    drill_moment("dribble-past-three", "sacks-2001", 3, 13.5, path=True),
    drill_moment("head-on-push", "sacks-2001", 4, 2.0),
    drill_moment("ball-in-corner", "sacks-2001", 1, 8.0),
    drill_moment("receive-pass", "heinemann-2006", 1, 0.8, **HEINEMANN),
    drill_moment("three-v-one", "heinemann-2006", 1, 0.6, **HEINEMANN),
    drill_moment("challenge-2003", "heinemann-2006", 1, 3.0, **HEINEMANN),
)
