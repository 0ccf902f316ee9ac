"""The hyperbolic mirror: the distance on the ground of each pixel.  [Heinemann et al. 2006, 2]  MH02

    F1, h above the ground   inner focus of the hyperbola, behind the mirror: a ray from the ground towards it ...
    mirror                   ... meets the hyperboloid, which reflects it into ...
    F2, below it             ... the outer focus, where the perspective camera stands and looks up

So there is a single viewpoint, F1 [Baker, Nayar 1999]. Seen from above, with the hyperbola's eccentricity e [Geyer,
Daniilidis 2000], directions are kept and

    radius in the image [px] = scale * d / (h + bend * sqrt(d^2 + h^2)),    bend = 2 e / (1 + e^2)    (1)

where h is `camera_height`, and scale [px], the camera's focal length times (e^2 - 1) / (e^2 + 1), is such that the
image's edge shows the ground at `mirror_edge`. The sensor draws its pictures with this curve, and the robot, whose
mirror was measured once, reads them with it.

`s`: settings of the sensors; `mirror`: the result of `mirror_parameters`.
"""

from math import sqrt
from typing import Any

from soccer_env.compiled import compiled

HORIZON = 0.98  # [1] of the radius of the ground's horizon; readings are limited to it, assumed


@compiled
def mirror_parameters(s: Any) -> Any:
    """Return scale [px], bend [1] and height of the viewpoint [m] of the mirror in the settings."""
    return s.mirror_scale, s.mirror_bend, s.camera_height


@compiled
def image_radius(mirror: Any, distance: Any) -> Any:
    """Return the distance from the image's centre [px] of a point that lies `distance` [m] away on the ground.  MH02"""
    scale, bend, height = mirror
    return scale * distance / (height + bend * sqrt(distance * distance + height * height))  # (1)


@compiled
def ground_distance(mirror: Any, radius: Any) -> Any:
    """Return the distance on the ground [m] of a point at `radius` [px] in the image: (1) solved for d.  MH02"""
    scale, bend, height = mirror
    share = min(radius / scale, HORIZON / bend)  # the horizon lies at scale / bend
    root = sqrt(1.0 + (1.0 - bend * bend) * share * share)
    return height * share * (bend + root) / (root - bend * share * share)


@compiled
def metres_per_pixel(mirror: Any, distance: Any) -> Any:
    """Return the metres on the ground per pixel, along and across the line of sight [m/px], at a distance [m].

    Along the line the span is 1 / the derivative of (1) and grows with the squared distance; across it, d / radius.
    """
    scale, bend, height = mirror
    ray = sqrt(distance * distance + height * height)  # [m] from the viewpoint
    away = height + bend * ray
    return ray * away * away / (scale * height * (ray + bend * height)), away / scale
