"""The belief of one robot, drawn over the true state."""

import numpy as np

from soccer_env.match import Match
from soccer_env.render import Picture
from soccer_env.render.colours import BALL_SHINE, KEEPER, TEAMS_LIGHT, WHITE
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.render.overlays.onlooker import Onlooker
from soccer_env.render.overlays.sight import SIGHT
from soccer_env.train.pages.pictures.legend import Entry, add_legend
from soccer_env.train.pages.pictures.settings import STILL_WIDTH

TEAMS, SEED, SECONDS, ROW = ("chaser", "sacks-2001"), 4, 12.0, 1  # of the match, [s] of play, of the robot

ENTRIES = (
    Entry(WHITE, "where red 1 believes it stands"),
    Entry(KEEPER, "two deviations of its particles"),
    Entry(BALL_SHINE, "where it believes the ball is"),
    Entry(SIGHT, "what its camera has in view"),
    Entry(TEAMS_LIGHT[0], "a team-mate as it believes"),
    Entry(TEAMS_LIGHT[1], "an opponent, and how long ago it saw it"),
)


def belief_picture(width: int = STILL_WIDTH, seconds: float = SECONDS) -> np.ndarray:
    """Play a match for some time and return the picture of a robot's belief, (H, W, 3) uint8."""
    match = Match(controllers=dict(zip(("home", "away"), TEAMS, strict=True)), pose="particles", seed=SEED)
    for _ in range(round(seconds * match.league.control_rate)):
        match.step()
    flags = OverlayFlags(belief=True, sight=True, robot=match.agents[ROW])
    overlays, picture = Onlooker(match, flags).see(match, width), Picture(match.league, width)
    frame = picture.draw(match.matches[0], match.balls[0], match.robots[0], title=TEAMS, overlays=overlays)
    return add_legend(frame, ENTRIES)
