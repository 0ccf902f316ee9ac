"""The mirror is a hyperboloid: rays that are reflected one by one meet the pixels that the closed form names."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.optics.mirror_camera import ground_distance, image_radius, metres_per_pixel, mirror_of
from tests.scenes.staging import MIDDLE

SENSORS = find_league(MIDDLE).sensors
S = SENSORS.record().view(np.recarray)[0]
MIRROR = mirror_of(S)
HALF_AXIS = 0.03  # [m] of the hyperbola; its size does not matter


def hyperbola(eccentricity: float) -> tuple[float, float, float]:
    """Return both half axes and half the distance of the foci [m]: a, b, c."""
    c = eccentricity * HALF_AXIS
    return HALF_AXIS, float(np.sqrt(c * c - HALF_AXIS * HALF_AXIS)), c


def height_of_mirror(x: float, eccentricity: float) -> float:
    """Return how high a point of the mirror is over its inner focus [m]: (z + c)^2 / a^2 - x^2 / b^2 = 1."""
    a, b, c = hyperbola(eccentricity)
    return -c + a * float(np.sqrt(1.0 + (x / b) ** 2))


def where_it_hits(distance: float, height: float, eccentricity: float) -> np.ndarray:
    """Return the point of the mirror (x, z) at which a ray from the ground towards the inner focus meets it."""
    inside, outside = 0.0, 1.0
    for _ in range(80):
        share = 0.5 * (inside + outside)
        if -share * height > height_of_mirror(share * distance, eccentricity):
            inside = share
        else:
            outside = share
    return 0.5 * (inside + outside) * np.array([distance, -height])


def slope_in_image(distance: float, height: float, eccentricity: float) -> float:
    """Return x / z of a ground point in the perspective camera: its ray, reflected, must meet the outer focus."""
    a, b, c = hyperbola(eccentricity)
    hit = where_it_hits(distance, height, eccentricity)
    normal = np.array([-2.0 * hit[0] / b**2, 2.0 * (hit[1] + c) / a**2])
    normal /= np.linalg.norm(normal)
    ray = -hit / np.linalg.norm(hit)  # from the ground to the inner focus
    ray = ray - 2.0 * (ray @ normal) * normal
    down = (np.array([0.0, -2.0 * c]) - hit) / np.linalg.norm(np.array([0.0, -2.0 * c]) - hit)
    assert ray == pytest.approx(down, abs=1e-9)
    return float(hit[0] / (hit[1] + 2.0 * c))


@pytest.mark.parametrize("eccentricity", [1.05, 1.3, 2.0])
@pytest.mark.parametrize("height", [0.5, 0.75])
def test_mh02_every_ray_is_reflected_into_the_pixel_that_the_curve_names(eccentricity: float, height: float) -> None:
    """MH02: through the inner focus, off the hyperboloid, into the outer focus, to a pixel."""
    mirror = mirror_of(
        SENSORS.changed({"mirror_eccentricity": eccentricity, "camera_height": height}).record().view(np.recarray)[0]
    )
    edge = slope_in_image(S.mirror_edge, height, eccentricity)
    for distance in (0.3, 0.75, 2.0, 5.0, 9.0):
        pixel = 0.5 * S.image * slope_in_image(distance, height, eccentricity) / edge
        assert image_radius(mirror, distance) == pytest.approx(pixel, rel=1e-9)
        assert ground_distance(mirror, pixel) == pytest.approx(distance, rel=1e-9)


def test_mh02_the_mirror_shows_ten_metres_in_290_pixels() -> None:
    """MH02: a 580 x 580 picture; what it shows of a metre shrinks with the distance."""
    assert S.image == 580
    assert image_radius(MIRROR, S.mirror_edge) == pytest.approx(290.0)
    assert image_radius(MIRROR, 0.0) == ground_distance(MIRROR, 0.0) == 0.0
    for distance in (0.5, 2.0, 9.9):
        along, across = metres_per_pixel(MIRROR, distance)
        step = image_radius(MIRROR, distance + 0.5e-3) - image_radius(MIRROR, distance - 0.5e-3)
        assert along == pytest.approx(1e-3 / step, rel=1e-3)
        assert across == pytest.approx(distance / image_radius(MIRROR, distance))


def test_far_off_a_pixel_spans_as_much_as_the_distances_square() -> None:
    """Twice as far, four times as coarse; the limit is d^2 (1 + ...) / (radius of the horizon * h / bend)."""
    scale, bend, height = MIRROR
    near, far = metres_per_pixel(MIRROR, 1e4)[0], metres_per_pixel(MIRROR, 2e4)[0]
    assert far == pytest.approx(4.0 * near, rel=1e-3)
    assert near == pytest.approx(1e8 * bend * bend / (scale * height), rel=1e-3)


def test_no_radius_is_read_beyond_the_horizon() -> None:
    scale, bend, height = MIRROR
    assert image_radius(MIRROR, 1e9) == pytest.approx(scale / bend)
    farthest = ground_distance(MIRROR, 1e6)
    assert ground_distance(MIRROR, scale / bend) == farthest and S.mirror_edge < farthest < 100.0
    assert image_radius(MIRROR, farthest) == pytest.approx(0.98 * scale / bend)


def test_an_eccentricity_of_one_is_the_paraboloid() -> None:
    """Seen from very far below: the radius is the tangent of half the angle to the axis."""
    mirror = mirror_of(SENSORS.changed({"mirror_eccentricity": 1.0}).record().view(np.recarray)[0])
    for distance in (0.5, 3.0):
        half = 0.5 * np.arctan2(distance, S.camera_height)
        assert image_radius(mirror, distance) == pytest.approx(mirror[0] * np.tan(half))
