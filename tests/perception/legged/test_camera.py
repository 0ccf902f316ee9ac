"""Where things are in the picture: pinhole, pose of the camera, ball, goals and landmarks."""

from math import pi

import numpy as np
import pytest

from soccer_env.optics.head_camera import camera_place, direction_of_pixel, focal_x, focal_y, image_height, image_width
from soccer_env.perception.legged.sketch import BALL, OPPONENT_GOAL, OWN_GOAL
from soccer_env.types import AWAY
from tests.perception.legged.staged_picture import Scene

RADIUS = 0.042  # [m] of the ball
SIDES = ("left", "right", "high", "low")


def ball_anywhere(scenes: int, seed: int = 1) -> Scene:
    """Return scenes with the ball somewhere in the picture, whatever the pose and the head."""
    rng = np.random.default_rng(seed)
    scene = Scene(scenes)
    place, turns = rng.uniform(-1.0, 1.0, (2, scenes)), rng.uniform(-1.5, 1.5, (2, scenes))
    scene.put(0, *place, rng.uniform(-pi, pi, scenes), turns[0], rng.uniform(-1.2, 0.2, scenes))
    away, bearing = rng.uniform(0.25, 2.0, scenes), rng.uniform(-0.4, 0.4, scenes)
    heading = scene.robots["heading"][:, 0] + scene.robots["pan"][:, 0] + bearing
    scene.put_ball(place[0] + away * np.cos(heading), place[1] + away * np.sin(heading))
    return scene


def silhouette(scene: Scene, m: int) -> list[float]:
    """Return left, right, high and low [px] of the circle in which lines of sight touch the ball, point by point."""
    s = scene.sensors.view(np.recarray)[0]
    eye, ahead, left, up = scene.camera(m).reshape(4, 3)
    to = np.array([scene.balls["x"][m], scene.balls["y"][m], RADIUS]) - eye
    away = np.sqrt(to @ to)
    aside = np.cross(to, [0.3, 0.5, 0.8]) / np.linalg.norm(np.cross(to, [0.3, 0.5, 0.8]))
    other = np.cross(to, aside) / away
    angle = np.linspace(0.0, 2.0 * pi, 20001)[:, None]
    middle, reach = (1.0 - (RADIUS / away) ** 2) * to, RADIUS * np.sqrt(1.0 - (RADIUS / away) ** 2)
    rim = middle + reach * (np.cos(angle) * aside + np.sin(angle) * other)
    u, v = focal_x(s) * (rim @ left) / (rim @ ahead), focal_y(s) * (rim @ up) / (rim @ ahead)
    return [u.max(), u.min(), v.max(), v.min()]


def test_box_and_area_of_the_ball_are_those_of_its_silhouette() -> None:
    scene, compared = ball_anywhere(200), 0
    pieces, found = scene.draw()
    for m in np.flatnonzero(found[:, BALL] == 1):
        box = silhouette(scene, m)
        if max(box[0], -box[1]) < 44 and max(box[2], -box[3]) < 36:
            piece = pieces[m, BALL, 0]
            assert [piece[side] for side in SIDES] == pytest.approx(box, abs=1e-4)
            area = 0.25 * pi * (piece["left"] - piece["right"]) * (piece["high"] - piece["low"])
            assert piece["area"] == pytest.approx(area, rel=0.02)  # ellipses that lie askew are less
            compared += 1
    assert compared >= 40


def test_ms08_head_angles_and_pixel_give_the_bearing() -> None:
    scene = ball_anywhere(200, seed=2)
    percepts, s = scene.look(), scene.sensors.view(np.recarray)[0]
    compared = 0
    for m, robot in enumerate(scene.robots[:, 0]):
        blob = percepts["ball"][m, 0, 0]
        if blob["area"] == 0 or 44 in (blob["left"], -blob["right"]) or 36 in (blob["high"], -blob["low"]):
            continue
        u, v = 0.5 * (int(blob["left"]) + int(blob["right"])), 0.5 * (int(blob["high"]) + int(blob["low"]))
        pan, tilt = robot["pan"], robot["tilt"]
        low, bearing, high = (direction_of_pixel(u + off, v, pan, tilt, s)[0] for off in (-1.5, 0, 1.5))
        ahead, left, _ = camera_place(robot["pan"], robot["tilt"], s)
        x, y = scene.balls["x"][m] - robot["x"], scene.balls["y"][m] - robot["y"]
        cosine, sine = np.cos(robot["heading"]), np.sin(robot["heading"])
        true = np.arctan2(cosine * y - sine * x - left, cosine * x + sine * y - ahead)
        assert abs((bearing - true + pi) % (2 * pi) - pi) < 0.5 * ((high - low) % (2 * pi))
        compared += 1
    assert compared >= 40


@pytest.mark.parametrize(("layer", "factor"), [("44x36", 0.5), ("176x144", 2.0)])
def test_a_finer_layer_shows_everything_larger(layer: str, factor: float) -> None:
    plain, other = Scene(1), Scene(1, resolution=layer)
    s = other.sensors.view(np.recarray)[0]
    assert (image_width(s), image_height(s)) == (88 * factor, 72 * factor)
    for scene in (plain, other):
        scene.put_ball(0.7, 0.05)
        scene.look_at(0, 0.7, 0.0)
    boxes = [[scene.draw()[0][0, BALL, 0][side] for side in SIDES] for scene in (plain, other)]
    assert boxes[1] == pytest.approx(factor * np.array(boxes[0]))


def test_blobs_end_at_the_edge_of_the_picture_and_what_reaches_over_it_stays_there() -> None:
    scene, goal = Scene(40, dither=3.0), Scene(1, dither=1.0)
    scene.put_ball(0.5, np.linspace(-0.4, 0.4, 40))
    for _ in range(30):
        percepts = scene.look()
        for name in ("ball", "own_goal", "opponent_goal", "landmarks"):
            blobs = percepts[name][:, 0]
            shown = blobs["area"] > 0
            assert (abs(np.stack([blobs["left"], blobs["right"]])) <= 44).all()
            assert (abs(np.stack([blobs["high"], blobs["low"]])) <= 36).all()
            assert (blobs["left"] > blobs["right"])[shown].all() and (blobs["high"] > blobs["low"])[shown].all()
    goal.put(0, 0.3, 0.0, -0.33)  # it reaches over the left edge
    for _ in range(50):
        blob = goal.look()["opponent_goal"][0, 0, 0]
        assert blob["left"] == 44 and blob["right"] > -44


@pytest.mark.parametrize("direction", [1.0, -1.0])
@pytest.mark.parametrize("team", [0, AWAY])
def test_goals_and_landmarks_are_named_from_the_own_side(direction: float, team: int) -> None:
    scene = Scene(1)
    scene.matches["home_direction"] = direction
    scene.robots["team"][0, 0] = team
    towards = direction * (1.0 if team == 0 else -1.0)  # the end of the field that the team attacks
    scene.put(0, 0.0, 0.0, 0.0 if towards > 0.0 else pi)
    pieces, found = scene.draw()
    assert found[0, OPPONENT_GOAL] == 1 and found[0, OWN_GOAL] == 0
    goal = pieces[0, OPPONENT_GOAL, 0]
    assert goal["left"] == pytest.approx(-goal["right"])
    for pan, left, right in ((0.0, 4, 5), (0.5 * pi, 2, 2), (-0.5 * pi, 3, 3)):
        for turn, index in ((0.4, left), (-0.4, right)) if pan == 0.0 else ((0.0, left),):
            scene.robots["pan"][0, 0] = pan + turn
            shown = np.flatnonzero(scene.look()["landmarks"]["area"][0, 0])
            assert index in shown and set(shown) <= {index, left, right}
    scene.robots["heading"][0, 0] += pi
    scene.robots["pan"][0, 0] = 0.45
    assert 1 in np.flatnonzero(scene.look()["landmarks"]["area"][0, 0])  # behind its left shoulder was its own right
    scene.robots["pan"][0, 0] = -0.45
    assert 0 in np.flatnonzero(scene.look()["landmarks"]["area"][0, 0])
    assert scene.look()["own_goal"]["area"][0, 0, 0] > 0


def test_a_goal_has_the_size_of_its_mouth_and_robots_that_are_down_or_sent_off_see_nothing() -> None:
    scene = Scene(1)
    s = scene.sensors.view(np.recarray)[0]
    ahead, _, height = camera_place(0.0, 0.0, s)
    goal = scene.draw()[0][0, OPPONENT_GOAL, 0]
    wide, high = focal_x(s) / (1.5 - ahead), focal_y(s) / (1.5 - ahead)  # [px] of a metre
    mouth = [0.3 * wide, -0.3 * wide, (0.3 - height) * high, -height * high]
    assert [goal[side] for side in SIDES] == pytest.approx(mouth)
    scene = Scene(3)
    scene.put_ball(0.7, 0.0)
    assert (scene.look()["ball"]["area"][:, 0, 0] > 0).all()
    scene.robots["fallen"][1, 0] = 2.0
    scene.robots["active"][2, 0] = 0
    percepts = scene.look()[:, 0]
    for name in ("ball", "opponent_goal"):
        assert (percepts[name]["area"] > 0).any(axis=1).tolist() == [True, False, False]
