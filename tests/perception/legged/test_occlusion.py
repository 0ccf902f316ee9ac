"""Bodies hide what stands behind them, in part too: held against ray-cast images at four times the resolution."""

import numpy as np
import pytest

from soccer_env.perception.legged.sketch import BALL, OPPONENT_GOAL, OPPONENTS
from tests.perception.legged.staged_picture import Scene, cast_ball, cast_jersey

FINER = 4  # times the camera's resolution
APART = 0.36  # [m] between robots, so that no head is inside another body
SIDES = (("left", np.max), ("right", np.min), ("high", np.max), ("low", np.min))
MEAN, WORST = 0.02, 0.12  # [1] error of the hidden share, on average and where an edge runs along a pixel


def crowd(scenes: int, seed: int, target: int | None = None) -> Scene:
    """Return scenes with three robots: one whose edge is about before the target, others anywhere.

    The target is the ball, or a robot, that one of them then is.
    """
    rng, kept = np.random.default_rng(seed), 0
    scene = Scene(scenes, robots=4)
    places = np.zeros((scenes, 4, 2))
    while kept < scenes:
        away, bearing = rng.uniform(0.5, 2.2), rng.uniform(-0.3, 0.3)
        reach, angle = rng.uniform(0.3, 1.3, 3) * away, bearing + rng.normal(0.0, 0.5, 3)
        reach[0] = rng.uniform(0.35, 0.9) * away
        angle[0] = bearing + rng.choice([-1.0, 1.0]) * rng.uniform(0.06, 0.2) / reach[0]
        if target is not None:
            reach[1:2], angle[1:2] = away, bearing
        others = np.stack([reach * np.cos(angle), reach * np.sin(angle)], axis=1)
        ball = away * np.array([np.cos(bearing), np.sin(bearing)]) if target is None else np.array([50.0, 0.0])
        among = np.hypot(*(others[:, None] - others[None]).T)[np.triu_indices(3, 1)]
        if among.min() > APART and reach.min() > APART and np.hypot(*(others - ball).T).min() > 0.24:
            places[kept] = [ball, *(others if target is None else others[[1, 0, 2]])]
            kept += 1
    scene.put_ball(*places[:, 0].T)
    for r in (1, 2, 3):
        turns = (rng.uniform(-limit, limit, scenes) for limit in (np.pi, 1.5))
        scene.put(r, *places[:, r].T, *turns, rng.uniform(-1.4, 0.6, scenes))
    scene.robots["tilt"][:, 0], scene.robots["pan"][:, 0] = rng.uniform(-0.35, 0.1, scenes), rng.normal(0, 0.15, scenes)
    return scene


def compare_shares(seen: np.ndarray, whole: np.ndarray, cast: np.ndarray, cast_whole: np.ndarray) -> None:
    """Compare what is hidden of things (N,) [px] with a ray-cast image."""
    shown = cast_whole > 6.0
    hidden = 1.0 - seen[shown] / whole[shown]
    cast_hidden = 1.0 - cast[shown] / cast_whole[shown]
    assert shown.sum() >= 30 and ((cast_hidden > 0.1) & (cast_hidden < 0.9)).sum() >= 20, "too few scenes to judge by"
    errors = abs(hidden - cast_hidden)
    assert errors.mean() <= MEAN and errors.max() <= WORST


def boxes_of(scene: Scene, kind: int) -> list[tuple[float, ...] | None]:
    """Return the box (left, right, high, low) [px] round the pieces of a kind in each scene, or None."""
    pieces, found = scene.draw()
    boxes: list[tuple[float, ...] | None] = []
    for row, count in zip(pieces[:, kind], found[:, kind], strict=True):
        sides = [(row[name][:count], pick) for name, pick in SIDES]
        boxes.append(tuple(float(pick(values)) for values, pick in sides) if count else None)
    return boxes


def without_others(scene: Scene, keep: int = 0) -> Scene:
    """Return the scenes with robot 0 and robot `keep` alone."""
    bare = Scene(len(scene.matches), scene.robots.shape[1])
    bare.balls[:], bare.robots[:] = scene.balls, scene.robots
    bare.robots["active"] = np.isin(np.arange(scene.robots.shape[1]), [0, keep])
    return bare


def test_the_hidden_share_of_the_ball_agrees_with_a_ray_cast_image() -> None:
    scene = crowd(150, seed=1)
    bare = without_others(scene)
    boxes = boxes_of(bare, BALL)
    cast = [[mask.sum() for mask in cast_ball(scene, m, FINER, box)] if box else [0, 0] for m, box in enumerate(boxes)]
    compare_shares(scene.seen_area(BALL), bare.seen_area(BALL), *np.transpose(cast) / FINER**2)


def test_the_hidden_share_of_a_jersey_agrees_with_a_ray_cast_image() -> None:
    scene = crowd(150, seed=2, target=1)
    scene.robots["tilt"][:, 1] = np.maximum(scene.robots["tilt"][:, 1], -0.5)  # what its own head hides: MS50
    bare = without_others(scene, keep=1)
    boxes = boxes_of(bare, OPPONENTS)
    cast = [cast_jersey(scene, m, 1, FINER, box) if box else (0, 0) for m, box in enumerate(boxes)]
    compare_shares(scene.seen_area(OPPONENTS), bare.seen_area(OPPONENTS), *np.transpose(cast) / FINER**2)


def test_what_is_left_of_a_ball_has_the_box_of_the_ray_cast_image() -> None:
    scene, compared = crowd(60, seed=3), 0
    pieces, found = scene.draw()
    for m in np.flatnonzero(found[:, BALL] == 1):
        piece, (mask, _) = pieces[m, BALL, 0], cast_ball(scene, m, FINER)
        rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
        box = [columns[-1] + 1, columns[0], rows[-1] + 1, rows[0]]
        middle = [mask.shape[1] / 2] * 2 + [mask.shape[0] / 2] * 2
        cast = (np.array(box) - middle) / FINER
        assert [piece[name] for name in ("left", "right", "high", "low")] == pytest.approx(cast, abs=1.0)
        compared += 1
    assert compared >= 20


def hiding(scenes: int, seed: int, **sensors: float) -> tuple[Scene, np.ndarray]:
    """Return scenes with a robot right before the ball, and which of them hide all of it from the camera."""
    rng = np.random.default_rng(seed)
    scene = Scene(scenes, robots=3, **sensors)
    away, gap = rng.uniform(0.4, 1.6, scenes), rng.uniform(0.17, 0.6, scenes)
    scene.put(1, away, rng.normal(0.0, 0.04, scenes), rng.uniform(-np.pi, np.pi, scenes), tilt=-0.2)
    scene.put(2, rng.uniform(0.3, 2.5, scenes), rng.choice([-0.5, 0.5], scenes), rng.uniform(-np.pi, np.pi, scenes))
    scene.put_ball(away + gap, rng.normal(0.0, 0.05, scenes))
    scene.look_at(0, scene.balls["x"], scene.balls["y"], 0.05)
    hidden = [not cast_ball(scene, m, 2)[0].any() for m in range(scenes)]
    return scene, np.array(hidden)


def test_a_hidden_ball_is_never_seen_whatever_the_noise() -> None:
    scene, hidden = hiding(150, seed=4, dither=2.0, scale_error=0.5, sticker_miss=0.5)
    assert 30 <= hidden.sum() <= 145
    shown = np.zeros(150, bool)
    for _ in range(200):
        shown |= scene.look()["ball"]["area"][:, 0].max(axis=1) > 0
    assert not shown[hidden].any() and shown[~hidden].any()


def test_a_robot_behind_the_ball_hides_nothing_of_it_and_a_head_over_it_hides_it_from_behind_alone() -> None:
    scene, head, rng = Scene(40), Scene(2), np.random.default_rng(5)
    scene.put_ball(0.6, 0.0)
    scene.put(1, rng.uniform(0.8, 2.0, 40), rng.uniform(-0.2, 0.2, 40), np.pi)  # heads do not reach over the ball
    scene.look_at(0, 0.6, 0.0)
    assert scene.seen_area(BALL) == pytest.approx(without_others(scene).seen_area(BALL), rel=1e-12)
    head.put(1, 1.0, 0.0, [np.pi, 0.0], tilt=-1.0)  # its ball lies between its paws
    head.put_ball(1.0 + np.array([-0.15, 0.15]), 0.0)
    head.look_at(0, 1.0, 0.0, 0.1)
    towards, away = head.seen_area(BALL)
    assert away < 0.05 * towards


def test_a_robot_before_a_goal_cuts_it_into_two_blobs_and_a_camera_inside_a_body_sees_nothing_beyond_it() -> None:
    scene = Scene(2)
    scene.put(1, [0.75, 50.0], 0.0, 0.0)
    scene.put(0, 0.3, 0.0)
    pieces, found = scene.draw()
    assert list(found[:, OPPONENT_GOAL]) == [2, 1]
    left, right = sorted(pieces[0, OPPONENT_GOAL, :2], key=lambda piece: -piece["left"])
    whole = pieces[1, OPPONENT_GOAL, 0]
    assert (left["left"], right["right"]) == pytest.approx((whole["left"], whole["right"]))
    assert left["right"] == pytest.approx(-right["left"], abs=0.5) and left["right"] > 3.0
    blobs = scene.look()["opponent_goal"][:, 0]
    assert (blobs["area"] > 0).sum(axis=1).tolist() == [2, 1]
    scene = Scene(1)
    scene.put(1, 0.14, 0.0, 0.5 * np.pi)
    scene.robots["tilt"][0, 0] = -0.9  # the lens is lower than the other's back
    scene.put_ball(0.9, 0.0)
    assert scene.seen_area(BALL) == 0.0 and scene.seen_area(OPPONENT_GOAL) == 0.0
