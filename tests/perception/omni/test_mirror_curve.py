"""What the mirror camera's picture depends on: the curve of its mirror, and light, which the colour table follows."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.optics.mirror_camera import ground_distance, image_radius, metres_per_pixel, mirror_parameters
from tests.perception.omni.staged_omni import NOW, SURE, bearings_all_round, look, watching_matches
from tests.scenes.staging import MIDDLE, play, put, put_ball

SENSORS = find_league(MIDDLE).sensors
S = SENSORS.record().view(np.recarray)[0]
MIRROR = mirror_parameters(S)
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
    changed = SENSORS.changed({"mirror_eccentricity": eccentricity, "camera_height": height})
    mirror = mirror_parameters(changed.record().view(np.recarray)[0])
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


def test_far_off_a_pixel_spans_as_much_as_the_distances_square_and_no_radius_is_read_beyond_the_horizon() -> None:
    """Twice as far, four times as coarse; the limit is d^2 (1 + ...) / (radius of the horizon * h / bend)."""
    scale, bend, height = MIRROR
    near, far = metres_per_pixel(MIRROR, 1e4)[0], metres_per_pixel(MIRROR, 2e4)[0]
    assert far == pytest.approx(4.0 * near, rel=1e-3)
    assert near == pytest.approx(1e8 * bend * bend / (scale * height), rel=1e-3)
    scale, bend, height = MIRROR
    assert image_radius(MIRROR, 1e9) == pytest.approx(scale / bend)
    farthest = ground_distance(MIRROR, 1e6)
    assert ground_distance(MIRROR, scale / bend) == farthest and S.mirror_edge < farthest < 100.0
    assert image_radius(MIRROR, farthest) == pytest.approx(0.98 * scale / bend)


def test_an_eccentricity_of_one_is_the_paraboloid() -> None:
    """Seen from very far below: the radius is the tangent of half the angle to the axis."""
    mirror = mirror_parameters(SENSORS.changed({"mirror_eccentricity": 1.0}).record().view(np.recarray)[0])
    for distance in (0.5, 3.0):
        half = 0.5 * np.arctan2(distance, S.camera_height)
        assert image_radius(mirror, distance) == pytest.approx(mirror[0] * np.tan(half))


CHANGING = {"light_drift": 0.5, **SURE, **NOW}


def seeing(match: Match, seconds: float) -> dict[str, np.ndarray]:
    """Let light go by, robots and ball where they are; return robot 0's light, table, ball and players (T, M)."""
    found: dict[str, list[np.ndarray]] = {name: [] for name in ("light", "table", "ball", "players", "lines")}
    for step in range(round(seconds * 50)):
        match.matches["step"], match.matches["clock"] = step, step * 0.02
        match.batch.senses.sense(0, match.count)
        for name, kept in found.items():
            records = match.batch.senses.sensor_states if name == "table" else match.percepts
            kept.append(records[name][:, 0].copy())
    return {name: np.stack(kept) for name, kept in found.items()}


def ball_at(match: Match, distance: float) -> None:
    """Put the ball round about robot 0."""
    bearings = bearings_all_round(match.count)
    put_ball(match, distance * np.cos(bearings), distance * np.sin(bearings))


def test_mh07_light_swings_as_told_and_differs_from_match_to_match() -> None:
    """MH07: the same for all robots of a match, a swing of `light_drift` in `light_period`."""
    match = watching_matches(20, sensors={**CHANGING, "light_period": 10.0}, seed=5)
    put(match, 1, 3.0, 0.0)
    light = seeing(match, 10.0)["light"]
    assert light.max(axis=0) == pytest.approx(0.5, abs=0.05) and light.min(axis=0) == pytest.approx(-0.5, abs=0.05)
    assert abs(light[-1] - light[0]).max() < 0.08  # a period has passed
    assert len(np.unique(light[0].round(1))) > 5
    assert match.percepts["light"][:, 0] == pytest.approx(match.percepts["light"][:, 1], abs=0.08)


def test_mh07_the_adaptive_table_follows_the_light_and_the_fixed_one_does_not() -> None:
    shares, errors = {}, {}
    for table in ("adaptive", "fixed"):
        match = watching_matches(40, sensors={**CHANGING, "light_period": 60.0, "colour_table": table}, seed=6)
        ball_at(match, 2.0)
        seen = seeing(match, 6.0)
        ball = seen["ball"]
        shares[table] = (ball["seen"] == 1).mean()
        errors[table] = (ball["distance"][ball["seen"] == 1] - 2.0).mean()
        lag = seen["light"] - seen["table"]
        assert abs(lag).max() < 0.2 if table == "adaptive" else (seen["table"] == 0.0).all()
    assert shares["adaptive"] > 0.9 and shares["fixed"] < 0.7
    assert errors["fixed"] > 0.01 > abs(errors["adaptive"])  # a blob that lost its rim seems farther


def test_mh07_a_table_that_is_off_by_its_width_misses_half() -> None:
    match = watching_matches(400, sensors={**CHANGING, "light_drift": 1.0, "colour_table": "fixed"}, seed=7)
    ball_at(match, 1.0)
    bearings = bearings_all_round(400) + 1.0
    put(match, 1, 2.0 * np.cos(bearings), 2.0 * np.sin(bearings))
    percepts = look(match)
    off = abs(percepts["light"])
    for near, share in ((abs(off - SENSORS.table_width) < 0.04, 0.5), (off < 0.06, 1.0), (off > 0.7, 0.0)):
        assert near.sum() > 5
        assert (percepts["ball"]["seen"][near] == 1).mean() == pytest.approx(share, abs=0.3 if share == 0.5 else 0.05)
        assert (percepts["players"]["seen"][near, 0] == 1).mean() == pytest.approx(share, abs=0.3)


def test_in_constant_light_the_table_does_not_matter_and_delayed_pictures_keep_one() -> None:
    """The table goes from picture to picture, not from delivery to delivery."""
    percepts = []
    for table in ("adaptive", "fixed"):
        match = Match(MIDDLE, home=2, away=2, seed=8, observe="percepts", sensors={"colour_table": table})
        play(match, steps=20)
        percepts.append(match.percepts.tobytes())
        assert not match.percepts["light"].any() and not match.batch.senses.sensor_states["table"].any()
    assert percepts[0] == percepts[1]
    lags = []
    for late in (0, 3):
        match = watching_matches(10, sensors={**CHANGING, "light_period": 20.0, "camera_delay": late}, seed=9)
        seen = seeing(match, 8.0)
        lags.append(abs(seen["light"] - seen["table"])[100:].mean())
    assert lags[1] == pytest.approx(lags[0], rel=0.1)


def table_after(off: float, seconds: float = 1.0, placed: bool = False, **settings: Any) -> float:
    """Put the table of a robot on the centre spot off the still light; return by how much it is off afterwards [1]."""
    sensors = {**CHANGING, "light_period": 1e6, "table_time": 1.0, **settings.pop("sensors", {})}
    match = watching_matches(sensors=sensors, pose="particles", **settings)
    seeing(match, 0.1)
    senses: Any = match.batch.senses
    light = float(senses.percepts["light"][0, 0])
    senses.sensor_states["table"][0, 0] = light + off
    match.robots["placed"][0, 0] = placed
    for step in range(round(seconds * 50)):
        match.matches["step"] = 5 + step
        senses.sense(0, 1)
    return float(senses.sensor_states["table"][0, 0]) - light


def test_mh07_light_that_jumps_leaves_the_table_behind() -> None:
    """MH07: colours beyond two deviations of their class are taken for others; `table_time` makes good 1 - 1/e."""
    reach = 2.0 * SENSORS.table_width / np.sqrt(2.0 * np.log(2.0))
    assert table_after(1.2 * reach, 4.0) == pytest.approx(1.2 * reach, abs=1e-6)
    assert abs(table_after(0.8 * reach, 4.0)) < 0.1 * reach
    assert table_after(0.2, 1.0) == pytest.approx(0.2 / np.e, abs=0.02)


def test_mh07_who_cannot_know_its_place_learns_no_colours() -> None:
    """MH07: which class a pixel must show follows from the own pose: by lines in the picture, or as it is sensed."""
    blind = {"line_miss": 1.0}
    assert table_after(0.2, sensors=blind) == pytest.approx(0.2, abs=1e-6)
    match = watching_matches(sensors={**CHANGING, **blind, "light_period": 60.0}, pose="percept", seed=6)
    seen = seeing(match, 6.0)
    assert abs(seen["light"] - seen["table"]).max() < 0.2 < np.ptp(seen["light"])


def test_mh07_who_is_told_its_place_trains_a_table_anew() -> None:
    assert abs(table_after(1.0, 0.1, placed=True)) < 0.05
    assert table_after(1.0, 0.1) == pytest.approx(1.0, abs=1e-6)
