"""The mirror camera sees ball, players and goals all round, where they are not hidden."""

from typing import Any

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.optics.mirror_camera import metres_per_pixel, mirror_parameters
from tests.perception.omni import staged_omni
from tests.perception.omni.staged_omni import NOW, SHARP, SURE, angle_difference, gather, look, watching_matches
from tests.scenes.staging import MIDDLE, play, put, put_ball, scatter, set_phase

LEAGUE = find_league(MIDDLE)
S = LEAGUE.sensors.record().view(np.recarray)[0]
DISC, BALL = LEAGUE.body.disc_radius, LEAGUE.ball.radius


def ball_around(match: Any, distance: Any) -> np.ndarray:
    """Put the ball of match m at bearing m of a full circle; return the bearings."""
    bearings = staged_omni.bearings_all_round(match.count)
    put_ball(match, distance * np.cos(bearings), distance * np.sin(bearings))
    return bearings


@pytest.mark.parametrize("distance", [0.6, 2.0, 4.0, 7.0])
def test_mh02_bearings_are_good_to_a_pixel_and_ranges_fail_with_the_mirrors_curve(distance: float) -> None:
    """MH02: errors are about one pixel of the picture, in every direction; along the line of sight they grow."""
    match = watching_matches(100, sensors=SURE)
    bearings = ball_around(match, distance)
    ball = gather(match, 20)["ball"]
    assert (ball["seen"] == 1).all()
    pixels = np.sqrt(S.pixel_noise**2 + 1.0 / 12.0)
    along, across = ball["distance"] - distance, distance * angle_difference(ball["bearing"], bearings)
    per_pixel_along, per_pixel_across = metres_per_pixel(mirror_parameters(S), distance)
    assert along.std() == pytest.approx(pixels * per_pixel_along, rel=0.08)
    assert across.std() == pytest.approx(pixels * per_pixel_across, rel=0.08)
    assert abs(along.mean()) < 0.2 * along.std() and abs(across.mean()) < 0.2 * across.std()


def test_mh02_half_the_pixels_make_twice_the_error() -> None:
    errors = []
    for image in (580, 290):
        match = watching_matches(300, sensors={**SURE, **SHARP, "image": image})
        ball_around(match, np.linspace(3.0, 5.0, 300))
        errors.append((look(match)["ball"]["distance"] - np.linspace(3.0, 5.0, 300)).std())
    assert errors[1] == pytest.approx(2.0 * errors[0], rel=0.2)


def test_what_lies_beyond_the_pictures_edge_or_under_the_body_is_not_seen() -> None:
    match = watching_matches(200, sensors={**SURE, **SHARP})
    distance = np.linspace(0.2, 14.0, 200)
    ball_around(match, distance)
    seen = look(match)["ball"]["seen"] == 1
    clear = abs(distance - S.mirror_edge) > metres_per_pixel(mirror_parameters(S), S.mirror_edge)[0]
    assert (seen == ((distance >= S.hidden_radius) & (distance < S.mirror_edge)))[clear].all()
    front = LEAGUE.body.front + BALL
    put_ball(match, front, 0.0)
    assert (look(match)["ball"]["seen"] == 0).all()
    put_ball(match, 0.0, DISC + BALL + 1e-3)
    assert (look(match)["ball"]["seen"] == 1).all()


@pytest.mark.parametrize(("thing", "reach"), [("ball", S.ball_range), ("players", S.player_range)])
def test_things_are_missed_more_often_the_farther_they_are(thing: str, reach: float) -> None:
    match = watching_matches(100, sensors={"false_balls": 0.0, "mirror_edge": 20.0})
    shares = []
    for distance in (2.0, reach, reach + 4.0):
        bearings = ball_around(match, distance if thing == "ball" else 1.0)
        if thing == "players":
            put(match, 1, distance * np.cos(bearings), distance * np.sin(bearings))
            put_ball(match, 0.0, 0.0)
        seen = gather(match, 40)[thing]["seen"]
        shares.append((seen.reshape(4000, -1).sum(axis=1) > 0).mean())
    miss = S.ball_miss if thing == "ball" else S.player_miss
    assert shares[0] == pytest.approx(1.0 - miss, abs=0.02)
    assert shares[1] == pytest.approx(0.5 * (1.0 - miss), abs=0.03) and shares[2] < 0.04


def free_rays(match: Any, m: int) -> np.ndarray:
    """Return which of many rays to a ball, across its whole width, pass no nearer robot."""
    x, y = match.balls["x"][m] - match.robots["x"][m, 0], match.balls["y"][m] - match.robots["y"][m, 0]
    distance = np.hypot(x, y)
    rays = np.arctan2(y, x) + np.linspace(-1.0, 1.0, 201) * np.arcsin(min(BALL / distance, 1.0))
    free = np.ones(201, bool)
    for other in range(1, match.robots.shape[1]):
        ox = match.robots["x"][m, other] - match.robots["x"][m, 0]
        oy = match.robots["y"][m, other] - match.robots["y"][m, 0]
        if match.robots["active"][m, other] and np.hypot(ox, oy) < distance:
            ahead, beside = ox * np.cos(rays) + oy * np.sin(rays), oy * np.cos(rays) - ox * np.sin(rays)
            free &= ~((ahead > 0.0) & (abs(beside) < DISC))
    return free


def test_mh02_a_hidden_ball_is_never_seen() -> None:
    """MH02: the camera stands 0.75 m high, robots are 0.8 m tall; what is behind them is not in the picture."""
    match = watching_matches(300, 6, 6, sensors=SURE)
    set_phase(match, 0)
    match.robots["active"] = 1
    rng, hidden, visible = np.random.default_rng(3), 0, 0
    for _ in range(4):
        scatter(match, rng, 0.7)
        seen = look(match)["ball"]["seen"]
        for m in range(match.count):
            free = free_rays(match, m)
            if not free.any():
                hidden += 1
                assert seen[m] == 0
            elif free.all() and np.hypot(match.balls["x"][m] - match.robots["x"][m, 0],
                                         match.balls["y"][m] - match.robots["y"][m, 0]) < 8.0:  # fmt: skip
                visible += 1
                assert seen[m] == 1
    assert hidden > 50 and visible > 300


def test_mh02_of_a_ball_half_hidden_the_other_half_is_seen() -> None:
    match = watching_matches(400, sensors={**SURE, **NOW})
    put_ball(match, 4.0, 0.0)
    shown = {}
    for y in (0.22, -0.22):  # a robot of 0.22 m at 2 m reaches to the middle of the ball
        put(match, 1, 2.0, y)
        ball = look(match)["ball"]
        assert 0.2 < ball["seen"].mean() < 0.8  # the less there is of it, the more often it is missed
        shown[y] = ball["bearing"][ball["seen"] == 1].mean()
    assert shown[0.22] == pytest.approx(-shown[-0.22], abs=0.003)
    assert -BALL / 4.0 < shown[0.22] < -0.3 * BALL / 4.0


def test_a_ball_in_front_of_a_robot_is_seen_and_by_a_camera_above_the_heads_the_ground_far_behind_it() -> None:
    match = watching_matches(sensors=SURE, ball=(2.0, 0.0), robots={1: (2.4, 0.0)})
    assert look(match)["ball"]["seen"][0] == 1
    match = watching_matches(sensors={**SURE, "camera_height": 1.0})
    put(match, 1, 1.0, 0.0)
    put_ball(match, 4.0, 0.0)  # over a head of 0.8 m at 1 m one sees the ground from 5 m on
    assert look(match)["ball"]["seen"][0] == 0
    put_ball(match, 5.5, 0.0)
    assert look(match)["ball"]["seen"][0] == 1


def test_false_balls_appear_in_all_directions_at_their_rate_and_count_only_if_they_look_larger() -> None:
    match = watching_matches(50, sensors={"false_balls": 0.2, "ball_miss": 1.0})
    ball = gather(match, 80)["ball"]
    false = ball[ball["seen"] == 1]
    assert len(false) / 4000 == pytest.approx(0.2, abs=0.02)
    quarters = np.histogram(false["bearing"], [-np.pi, -np.pi / 2, 0.0, np.pi / 2, np.pi])[0]
    assert quarters.min() > 0.2 * len(false)
    assert S.hidden_radius * 0.99 < false["distance"].min() and false["distance"].max() < 10.01
    match = watching_matches(50, sensors={**SURE, "false_balls": 1.0})
    ball_around(match, 0.5)
    near = gather(match, 40)["ball"]["distance"]
    assert (near < 0.6).all() and (abs(near - 0.5) < 0.05).mean() > 0.8
    ball_around(match, 6.0)
    assert (gather(match, 40)["ball"]["distance"] < 5.0).mean() > 0.5


def test_mh24_a_ball_without_colour_is_found_less_often_and_mistaken_more_often() -> None:
    """MH24: the ball of the technical challenge; light does not matter to what is found by its shape."""
    found = {}
    for coloured in (True, False):
        match = watching_matches(50, sensors={"ball_miss": 0.0, "false_balls": 0.0, "ball_coloured": coloured})
        bearings = ball_around(match, 2.0)
        ball = gather(match, 80)["ball"]
        right = (ball["seen"] == 1) & (abs(angle_difference(ball["bearing"], bearings)) < 0.1)
        found[coloured] = right.mean(), ((ball["seen"] == 1) & ~right).mean()
    assert found[True] == (pytest.approx(1.0, abs=0.01), 0.0)
    assert found[False][0] == pytest.approx(0.5, abs=0.03) and 0.01 < found[False][1] < 0.08


def test_mh02_a_picture_arrives_some_frames_after_its_exposure() -> None:
    """MH02: 50 pictures a second, each some frames late; what is felt is current."""
    for late in (1, 2, 3):
        match = watching_matches(sensors={**SURE, **SHARP, "camera_delay": late})
        match.rebuild()
        for m in range(1):
            match.batch.senses.start(m)
        shown = []
        for step in range(8):
            match.matches["step"] = step
            put_ball(match, 1.0 + 0.2 * step, 0.0)
            match.batch.senses.sense(0, 1)
            percept = match.percepts[0, 0]
            shown.append(round((percept["ball"]["distance"] - 1.0) / 0.2))
            assert percept["age"] == pytest.approx(0.0 if step < late else late * 0.02)
            assert percept["body"]["frame"] == step
        assert shown == [*range(late), *range(8 - late)]  # the first frames are shown at once, then as they arrive


def test_a_robot_that_was_moved_sees_its_new_place_at_once() -> None:
    match = watching_matches(sensors={**SURE, **SHARP, "camera_delay": 3})
    match.rebuild()
    play(match, steps=10)
    assert match.percepts["age"][0, 0] == pytest.approx(0.06)
    put(match, 0, 3.0, 0.0)
    put_ball(match, 4.0, 0.0)
    match.robots["placed"][0, 0] = 1
    match.matches["step"] += 1
    match.batch.senses.sense(0, 1)
    assert match.percepts["age"][0, 0] == 0.0
    assert match.percepts["ball"]["distance"][0, 0] == pytest.approx(1.0, abs=0.02)
