"""The picture of the camera on a legged robot's head, down to the blobs that its vision delivers."""

from __future__ import annotations

from soccer_env.compiled import compiled


@compiled
def take_picture(match, ball, robots, percept, k, s, r):
    """Fill in the blobs that robot r sees."""
