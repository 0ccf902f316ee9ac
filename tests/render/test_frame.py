"""A frame shows ball, robots, goals and marks where the records say."""

from math import pi

import numpy as np
import pytest

pytest.importorskip("pygame")

from soccer_env.render import colours
from tests.render.staged_frames import centre_of, coloured_pixels, points_around, stage_picture
from tests.scenes.staging import LEAGUES


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("width", (480, 960))
def test_robots_show_their_team_s_colour_at_their_places(league, width):
    picture, match, ball, robots = stage_picture(league, 3, 3, width=width)
    frame = picture.draw(match, ball, robots)
    for robot in robots:
        place, reach = (robot["x"], robot["y"]), picture.league.body.reach
        own = len(points_around(picture, coloured_pixels(frame, colours.TEAMS[robot["team"]]), *place, reach))
        other = len(points_around(picture, coloured_pixels(frame, colours.TEAMS[1 - robot["team"]]), *place, reach))
        area = pi * reach**2 * picture.view.scale**2
        assert own > 0.12 * area and other == 0  # its trunk, but for head and number


def test_a_head_turned_left_is_seen_on_the_left():
    picture, match, ball, robots = stage_picture("legged-2001", 1, 0)
    ball["x"] = 1.0
    sides = []
    for pan in (-1.5, 0.0, 1.5):
        robots["pan"], robots["x"], robots["y"] = pan, 0.0, 0.5
        head = coloured_pixels(picture.draw(match, ball, robots), colours.TEAMS_PALE[0], 10)
        sides.append(centre_of(picture, head, 0.0, 0.5, 0.2)[1] - 0.5)
    assert sides[0] < -0.02 < sides[1] < 0.02 < sides[2]
    assert sides[0] == pytest.approx(-sides[2], abs=0.005)


@pytest.mark.parametrize("league", LEAGUES)
def test_a_mirrored_pose_gives_a_mirrored_picture(league):
    picture, match, ball, robots = stage_picture(league, 1, 0)
    x, y, reach = 0.22 * picture.league.pitch.length, 0.3 * picture.league.pitch.width, picture.league.body.reach
    ball["x"] = -1.0
    shapes = []
    for side in (1.0, -1.0):
        robots["x"], robots["y"], robots["heading"], robots["pan"] = x, side * y, side * 0.6, side * 0.4
        frame = picture.draw(match, ball, robots)
        trunk = coloured_pixels(frame, colours.TEAMS[0])
        trunk |= coloured_pixels(frame, colours.WHITE, 60)  # with its number, which is not mirrored
        points = points_around(picture, trunk, x, side * y, reach) * (1.0, side)
        shapes.append({tuple(point) for point in np.round(points * picture.view.scale).astype(int).tolist()})
    assert len(shapes[0] & shapes[1]) > 0.85 * len(shapes[0] | shapes[1]) > 100
