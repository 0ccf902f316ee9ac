import subprocess
import sys
from math import cos, hypot, pi, sin

import numpy as np
import pytest

pytest.importorskip("pygame")

from soccer_env import types
from soccer_env.leagues import find_league
from soccer_env.render import Arrows, Picture, Points, Polyline, colours

LEAGUES = ("legged-2001", "middle-size-2006")


def make_records(home=2, away=2):
    """Return a match in play, a ball at rest at the centre, and robots in two columns on their own sides."""
    match, ball, robots = np.zeros((), types.MATCH), np.zeros((), types.BALL), np.zeros(home + away, types.ROBOT)
    match["half_length"], match["home_direction"] = 600.0, 1.0
    match["restart_team"] = match["last_touch_team"] = match["last_touch_robot"] = -1
    for row, robot in enumerate(robots):
        robot["team"] = int(row >= home)
        robot["number"] = row - home * (row >= home)
        robot["active"] = 1
        side = 2 * robot["team"] - 1
        robot["x"], robot["y"] = 0.7 * side, -0.6 + 0.4 * robot["number"]
        robot["heading"] = pi if robot["team"] else 0.0
    return match, ball, robots


def near(frame, colour, tolerance=24):
    """Return where a frame shows a colour."""
    return (np.abs(frame.astype(int) - colour).max(axis=2) <= tolerance).astype(bool)


def around(picture, mask, x, y, radius):
    """Return the points of a mask (rows, columns) within a radius [m] of a place, as metres in the field frame."""
    rows, columns = np.nonzero(mask)
    xs = (columns + 0.5 - picture.view.centre_x) / picture.view.scale
    ys = -(rows + 0.5 - picture.header_height - picture.view.centre_y) / picture.view.scale
    points = np.column_stack([xs, ys])
    return points[np.hypot(xs - x, ys - y) < radius]


def centre_of(picture, mask, x, y, radius):
    points = around(picture, mask, x, y, radius)
    assert len(points), "the colour is not there"
    return points.mean(axis=0)


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("width", (240, 333, 480, 960))
def test_a_frame_is_8_bit_rgb_of_the_picture_s_size(league, width):
    picture = Picture(league, width)
    frame = picture.draw(*make_records())
    assert frame.dtype == np.uint8 and frame.shape == (picture.height, width, 3)
    assert picture.height % 2 == 0
    assert frame.flags.writeable and frame.flags.c_contiguous


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("place", ((0.0, 0.0), (1.2, 0.8), (-1.2, -0.8), (0.4, -0.9)))
def test_the_ball_is_orange_where_the_record_says(league, place):
    picture = Picture(league)
    match, ball, robots = make_records(1, 1)
    ball["x"], ball["y"] = place
    frame = picture.draw(match, ball, robots)
    column, row = picture.pixel(*place)
    assert near(frame, colours.BALL)[int(row), int(column)]
    radius = picture.league.ball.radius
    assert centre_of(picture, near(frame, colours.BALL), *place, 2 * radius) == pytest.approx(place, abs=0.2 * radius)


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("width", (480, 960))
def test_robots_show_their_team_s_colour_at_their_places(league, width):
    picture = Picture(league, width)
    match, ball, robots = make_records(3, 3)
    frame = picture.draw(match, ball, robots)
    for robot in robots:
        place, reach = (robot["x"], robot["y"]), picture.league.body.reach
        own = len(around(picture, near(frame, colours.TEAMS[robot["team"]]), *place, reach))
        other = len(around(picture, near(frame, colours.TEAMS[1 - robot["team"]]), *place, reach))
        area = pi * reach**2 * picture.view.scale**2
        assert own > 0.15 * area and other == 0


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("heading", (0.0, 0.8, pi / 2, 2.5, -2.0))
def test_paws_or_guide_lie_ahead_of_the_trunk(league, heading):
    picture = Picture(league)
    match, ball, robots = make_records(1, 0)
    robots["x"], robots["y"], robots["heading"], ball["x"] = 0.5, 0.5, heading, -1.0
    frame = picture.draw(match, ball, robots)
    arms = near(frame, colours.PAW, 8) if league == "legged-2001" else near(frame, colours.STEEL, 8)
    reach = picture.league.body.reach
    trunk = centre_of(picture, near(frame, colours.TEAMS[0]), 0.5, 0.5, reach)
    front = centre_of(picture, arms, 0.5, 0.5, 1.05 * reach)
    ahead = front - trunk
    assert hypot(*ahead) > 0.5 * reach
    assert ahead @ (cos(heading), sin(heading)) > 0.95 * hypot(*ahead)


def test_a_head_turned_left_is_seen_on_the_left():
    picture = Picture("legged-2001")
    match, ball, robots = make_records(1, 0)
    ball["x"] = 1.0
    sides = []
    for pan in (-1.5, 0.0, 1.5):
        robots["pan"], robots["x"], robots["y"] = pan, 0.0, 0.5
        head = near(picture.draw(match, ball, robots), colours.TEAMS_PALE[0], 10)
        sides.append(centre_of(picture, head, 0.0, 0.5, 0.2)[1] - 0.5)
    assert sides[0] < -0.02 < sides[1] < 0.02 < sides[2]
    assert sides[0] == pytest.approx(-sides[2], abs=0.005)


@pytest.mark.parametrize("league", LEAGUES)
def test_the_empty_pitch_is_symmetric(league):
    picture = Picture(league)
    match, ball, robots = make_records(0, 0)
    ball["x"] = 1e6
    field = picture.league.pitch
    left, top = picture.pixel(-0.45 * field.length, field.width / 2)
    right, bottom = picture.pixel(0.45 * field.length, -field.width / 2)
    carpet = picture.draw(match, ball, robots)[round(top) : round(bottom), round(left) : round(right)].astype(int)
    for mirrored in (carpet[::-1], carpet[:, ::-1]):
        assert (np.abs(carpet - mirrored).max(axis=2) > 60).mean() < 0.005


@pytest.mark.parametrize("league", LEAGUES)
def test_a_mirrored_pose_gives_a_mirrored_picture(league):
    picture = Picture(league)
    match, ball, robots = make_records(1, 0)
    x, y, reach = 0.22 * picture.league.pitch.length, 0.3 * picture.league.pitch.width, picture.league.body.reach
    ball["x"] = -1.0
    shapes = []
    for side in (1.0, -1.0):
        robots["x"], robots["y"], robots["heading"], robots["pan"] = x, side * y, side * 0.6, side * 0.4
        frame = picture.draw(match, ball, robots)
        trunk = near(frame, colours.TEAMS[0]) | near(frame, colours.WHITE, 60)  # with its number, which is not mirrored
        points = around(picture, trunk, x, side * y, reach) * (1.0, side)
        shapes.append({tuple(point) for point in np.round(points * picture.view.scale).astype(int).tolist()})
    assert len(shapes[0] & shapes[1]) > 0.85 * len(shapes[0] | shapes[1]) > 100


def test_goals_keep_their_colours_when_teams_change_ends():
    picture = Picture("legged-2001")
    match, ball, robots = make_records()
    left, right = (tuple(round(n) for n in picture.pixel(side * 1.815, 0.0)) for side in (-1, 1))
    for direction in (1.0, -1.0):
        match["home_direction"] = direction
        frame = picture.draw(match, ball, robots)
        assert near(frame, colours.GOALS[0])[left[1], left[0]] and near(frame, colours.GOALS[1])[right[1], right[0]]


@pytest.mark.parametrize("league", LEAGUES)
def test_the_direction_of_attack_changes_ends_with_the_teams(league):
    picture = Picture(league)
    match, ball, robots = make_records()
    strip = slice(picture.header_height, picture.header_height + int(picture.view.margin))
    for direction, left, right in ((1.0, 0, 1), (-1.0, 1, 0)):
        match["home_direction"] = direction
        frame = picture.draw(match, ball, robots)[strip]
        half = picture.width // 2
        for team, side in ((left, frame[:, :half]), (right, frame[:, half:])):
            assert near(side, colours.TEAMS_LIGHT[team]).any()
            assert not near(side, colours.TEAMS_LIGHT[1 - team]).any()


@pytest.mark.parametrize("league", LEAGUES)
def test_a_ring_marks_the_robot_that_has_the_ball(league):
    picture = Picture(league)
    match, ball, robots = make_records()
    ball["x"] = -0.2
    robots[3]["has_ball"] = 1
    frame = picture.draw(match, ball, robots)
    reach = picture.league.body.reach
    for row, robot in enumerate(robots):
        ring = around(picture, near(frame, colours.BALL, 40), robot["x"], robot["y"], 1.6 * reach)
        distance = np.hypot(ring[:, 0] - robot["x"], ring[:, 1] - robot["y"])
        angles = np.arctan2(ring[:, 1] - robot["y"], ring[:, 0] - robot["x"])[distance > 1.25 * reach]
        assert (len(np.unique(np.round(angles))) == 7) == (row == 3)  # all round


def test_a_goalkeeper_wears_yellow():
    for league in LEAGUES:
        picture = Picture(league)
        match, ball, robots = make_records()
        robots[0]["keeper"] = robots[2]["keeper"] = 1
        robots["y"][1::2] += 0.5
        frame = picture.draw(match, ball, robots)
        for robot in robots:
            yellow = around(picture, near(frame, colours.KEEPER), robot["x"], robot["y"], picture.league.body.reach)
            assert (len(yellow) > 50) == bool(robot["keeper"])


def test_a_robot_that_is_off_stands_grey_beside_the_field():
    picture = Picture("legged-2001")
    match, ball, robots = make_records()
    robots[1]["active"], robots[1]["penalty"], robots[1]["has_ball"] = 0, 12.0, 1
    frame = picture.draw(match, ball, robots)
    assert not len(around(picture, near(frame, colours.TEAMS[0]), robots[1]["x"], robots[1]["y"], 0.15))
    corner = frame[-int(picture.view.margin) :, : picture.width // 4]
    assert near(corner, colours.GREY).any() and near(corner, colours.TEAMS_LIGHT[0]).any()


def test_a_fallen_robot_is_marked():
    picture = Picture("legged-2001")
    match, ball, robots = make_records()
    robots[0]["fallen"] = 2.0
    frame = picture.draw(match, ball, robots)
    for row, robot in enumerate(robots):
        amber = around(picture, near(frame, colours.AMBER, 8), robot["x"], robot["y"], 0.3)
        assert (len(amber) > 100) == (row == 0)


def test_a_fast_ball_leaves_a_trail_behind_it():
    picture = Picture("middle-size-2006")
    match, ball, robots = make_records(0, 0)
    ball["x"], ball["y"] = 1.0, 2.0
    still = picture.draw(match, ball, robots)
    ball["vx"] = 4.0
    fast = picture.draw(match, ball, robots)
    changed = around(picture, (still != fast).any(axis=2), 1.0, 2.0, 3.0)
    assert len(changed) and changed[:, 0].max() <= 1.0 + 0.11 and -0.1 < changed[:, 0].min() < 0.3


@pytest.mark.parametrize("league", LEAGUES)
def test_eleven_against_eleven_and_a_robot_far_outside_are_drawn(league):
    match, ball, robots = make_records(11, 11)
    robots["y"] *= 0.2
    robots[3]["x"], robots[4]["y"], ball["x"] = 1e12, -1e300, -1e200
    frame = Picture(league).draw(match, ball, robots)
    assert near(frame, colours.TEAMS[0]).any() and near(frame, colours.TEAMS[1]).any()


def test_a_frame_depends_on_its_records_alone():
    rng = np.random.default_rng(3)
    used = {league: Picture(league, 480) for league in LEAGUES}
    for turn in range(6):
        match, ball, robots = make_records(3, 3)
        robots["x"], robots["y"] = rng.uniform(-1.4, 1.4, 6), rng.uniform(-1, 1, 6)
        robots["heading"], robots["has_ball"] = rng.uniform(-3, 3, 6), rng.integers(0, 2, 6)
        match["home_direction"], match["clock"], match["phase"] = (-1) ** turn, turn * 61.0, turn
        ball["x"], ball["vy"] = rng.uniform(-1, 1), rng.uniform(-2, 2)
        for league in LEAGUES:
            assert np.array_equal(
                used[league].draw(match, ball, robots), Picture(league, 480).draw(match, ball, robots)
            )


def test_drawing_leaves_the_records_alone_and_takes_read_only_ones():
    records = make_records()
    before = [record.tobytes() for record in records]
    for record in records:
        record.flags.writeable = False
    Picture("legged-2001").draw(*records)
    assert [record.tobytes() for record in records] == before


def test_records_of_a_batch_are_drawn_one_match_at_a_time():
    match, ball, robots = make_records()
    matches, balls, teams = np.stack([match] * 3), np.stack([ball] * 3), np.stack([robots] * 3)
    balls["x"] = (0.1, 0.2, 0.3)
    picture = Picture("legged-2001", 480)
    ball["x"] = 0.2
    assert np.array_equal(picture.draw(matches[1], balls[1], teams[1]), picture.draw(match, ball, robots))
    with pytest.raises(ValueError, match=r"match must be one record, got shape \(3,\)"):
        picture.draw(matches, balls[0], teams[0])
    with pytest.raises(ValueError, match=r"robots must be records of shape \(R,\), got shape \(3, 4\)"):
        picture.draw(matches[0], balls[0], teams)


def test_overlays_show_at_their_places_under_or_over_the_robots():
    picture = Picture("middle-size-2006")
    match, ball, robots = make_records(1, 0)
    robots["x"], robots["y"], ball["x"] = 2.0, 2.0, -3.0
    pink = (250, 20, 220)
    dots = Points([(2.0, 2.0), (-2.0, 2.0)], pink, radius=5.0)
    frame = picture.draw(match, ball, robots, overlays=[dots])
    for place in ((2.0, 2.0), (-2.0, 2.0)):
        assert centre_of(picture, near(frame, pink), *place, 0.5) == pytest.approx(place, abs=0.02)
    beneath = Points([(1.96, 2.0)], pink, radius=5.0, under=True)
    assert not near(picture.draw(match, ball, robots, overlays=[beneath]), pink).any()
    path = Polyline([(0.0, -1.0), (4.0, -1.0)], pink)
    assert len(around(picture, near(picture.draw(match, ball, robots, overlays=[path]), pink), 3.0, -1.0, 0.1))
    arrow = Arrows([(0.0, 3.0)], [(1.0, 0.0)], pink, width=3.0)
    tip = around(picture, near(picture.draw(match, ball, robots, overlays=[arrow]), pink), 0.5, 3.0, 1.0)
    assert tip[:, 0].max() == pytest.approx(1.0, abs=0.03)
    assert np.ptp(tip[tip[:, 0] > 0.85, 1]) > 2 * np.ptp(tip[tip[:, 0] < 0.5, 1])


def test_bad_overlays_name_the_value_and_leave_no_trace():
    picture = Picture("legged-2001", 480)
    records = make_records()
    clean = picture.draw(*records)
    bad = {
        r"Points.xy must have shape \(N, 2\), got \(3,\)": Points([1.0, 2.0, 3.0], colours.WHITE),
        r"Points.xy must be finite, got \[0.5, nan\]": Points([(0.5, np.nan)], colours.WHITE),
        "a vector for each tail, got 2 for 1 tails": Arrows([(0, 0)], [(1, 1), (2, 2)], colours.WHITE),
    }
    for message, overlay in bad.items():
        with pytest.raises(ValueError, match=message):
            picture.draw(*records, overlays=[Polyline([(0, 0), (1, 1)], colours.WHITE), overlay])
        assert np.array_equal(picture.draw(*records), clean)


@pytest.mark.parametrize("width", (0, -5, 239, 100_000, 480.0, float("nan"), "960", None, True))
def test_a_bad_width_is_a_value_error_that_names_it(width):
    with pytest.raises(ValueError, match=f"width must be .*got {width!r}"):
        Picture("legged-2001", width)


def test_a_pose_that_is_not_finite_is_a_value_error_that_names_it():
    picture = Picture("legged-2001", 480)
    match, ball, robots = make_records()
    robots[2]["heading"] = np.nan
    with pytest.raises(ValueError, match="robot 2 has heading = nan"):
        picture.draw(match, ball, robots)
    robots[2]["heading"], ball["vx"] = 0.0, np.inf
    with pytest.raises(ValueError, match="ball has vx = inf"):
        picture.draw(match, ball, robots)
    with pytest.raises(ValueError, match="unknown league 'cricket'"):
        Picture("cricket")


def test_names_of_any_kind_fit_the_plates():
    picture = Picture(find_league("legged-2001"), 240)
    for title in (("", "x" * 500), ("two\nlines\0", "möwen 2001"), ("\ud800", 7)):
        assert picture.draw(*make_records(), title=title).shape == (picture.height, 240, 3)


def test_pictures_outlive_pygame_quit():
    import pygame

    picture, records = Picture("legged-2001", 480), make_records()
    before = picture.draw(*records)
    pygame.quit()
    records[0]["clock"] = 83.0  # a new word for the header
    assert not np.array_equal(picture.draw(*records), before)


def test_importing_the_package_leaves_pygame_alone_and_a_picture_needs_no_display():
    program = """
import sys, numpy as np
import soccer_env.render
assert "pygame" not in sys.modules
from soccer_env import types
from soccer_env.render import Picture
frame = Picture("legged-2001").draw(np.zeros((), types.MATCH), np.zeros((), types.BALL), np.zeros(2, types.ROBOT))
import pygame
assert not pygame.display.get_init() and frame.any()
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and done.stdout == "", done.stderr


def test_without_pygame_the_error_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(ImportError, match=r'pip install "soccer_env\[render\]"'):
        Picture("legged-2001")
    monkeypatch.setitem(sys.modules, "pygame", sys)  # stands for the older pygame: no IS_CE
    with pytest.raises(ImportError, match=r"older pygame"):
        Picture("legged-2001")
