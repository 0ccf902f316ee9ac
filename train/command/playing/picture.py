"""What the person sees: the truth with a ring round the robot, or only what the robot believes, in a fog."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from soccer_env.leagues.league import Pitch
from soccer_env.render import Area, Picture
from soccer_env.render.colours import INK
from soccer_env.render.overlays.cast import Cast, Snapshot
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.render.overlays.layers import LayerInput, make_overlays
from soccer_env.render.overlays.roles import selection_ring
from soccer_env.render.overlays.shapes import Overlay

FOG = 130  # of 255, for the eye
RING = 2.0  # [1] width of the ring round the person's robot, of that of other rings
OUT_OF_SIGHT = 1e3  # [m] where nothing is drawn


def draw_truth(
    picture: Picture, cast: Cast, shot: Snapshot, agent: str, teams: tuple[str, str], panels: Sequence[Overlay]
) -> np.ndarray:
    """Return a frame (H, W, 3) uint8 of the true state, with a ring round the person's robot."""
    row = cast.agents.index(agent)
    ring = selection_ring(LayerInput(cast, shot, (), row, None, RING * picture.width / 960.0))
    return picture.draw(*shot[:3], title=teams, overlays=[ring, *panels])


def draw_belief(
    picture: Picture, cast: Cast, shot: Snapshot, agent: str, teams: tuple[str, str], panels: Sequence[Overlay]
) -> np.ndarray:
    """Return a frame (H, W, 3) uint8 of what the person's robot believes and sees, and of nothing else."""
    row = cast.agents.index(agent)
    thought = cast.thought(shot, row)
    assert thought is not None, "robots of a person have beliefs"
    ball, robots = shot.ball.copy(), shot.robots.copy()
    others = np.arange(len(robots)) != row
    robots["x"][others], robots["has_ball"][others] = OUT_OF_SIGHT, 0
    robots["x"][row], robots["y"][row], robots["heading"][row] = thought.pose
    ball["x"], ball["y"] = (OUT_OF_SIGHT, 0.0) if thought.ball is None else thought.ball
    ball["vx"] = ball["vy"] = 0.0
    believed = Snapshot(shot.match, ball, robots, shot.note)
    overlays = make_overlays(OverlayFlags(belief=True, sight=True, robot=agent), cast, believed, (), picture.width)
    return picture.draw(*believed[:3], title=teams, overlays=[fog(cast.league.pitch), *overlays, *panels])


def fog(pitch: Pitch) -> Overlay:
    """Return a fog over a pitch."""
    x, y = 0.5 * pitch.length + pitch.band_end, 0.5 * pitch.width + pitch.band_side
    return Area([(-x, -y), (x, -y), (x, y), (-x, y)], INK, FOG)
