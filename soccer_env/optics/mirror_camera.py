"""The curve of the hyperbolic mirror: which pixel shows which distance on the ground.  [Heinemann et al. 2006, 2]

Robot and camera share it: the sensor draws its pictures by it, and the robot, whose mirror was measured once, reads
them by it. Seen from above, directions are kept and distances shrink:

    radius in the image [px] = image / 2 * (d / (d + curve)) / (edge / (edge + curve))

`s`: settings of the sensors.
"""

from __future__ import annotations

from typing import Any

from soccer_env.compiled import compiled

HORIZON = 0.98  # [1] of the radius at which the ground's horizon would lie; no reading is farther, assumed


@compiled
def horizon_radius(s: Any) -> Any:
    """Return the radius [px] at which a point without end would lie; it lies outside the picture."""
    return 0.5 * s.image * (s.mirror_edge + s.mirror_curve) / s.mirror_edge


@compiled
def image_radius(s: Any, distance: Any) -> Any:
    """Return the distance from the image's centre [px] of a point at a distance [m] on the ground.  MH02"""
    return horizon_radius(s) * distance / (distance + s.mirror_curve)


@compiled
def ground_distance(s: Any, radius: Any) -> Any:
    """Return the distance on the ground [m] that a radius in the image [px] shows.  MH02"""
    share = min(radius / horizon_radius(s), HORIZON)
    return s.mirror_curve * share / (1.0 - share)


@compiled
def metres_across(s: Any, distance: Any) -> Any:
    """Return how many metres a pixel spans across the line of sight [m/px] at a distance [m]."""
    return (distance + s.mirror_curve) / horizon_radius(s)


@compiled
def metres_along(s: Any, distance: Any) -> Any:
    """Return how many metres a pixel spans along the line of sight [m/px]: it grows with the distance's square."""
    away = distance + s.mirror_curve
    return away * away / (s.mirror_curve * horizon_radius(s))
