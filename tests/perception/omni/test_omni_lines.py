"""White lines, other robots and goals in the picture of the mirror camera."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env.belief.omni.lines import COLUMNS, ROWS, TABLES, line_tables, nearest_line
from soccer_env.belief.particles import OUTLIER, bounded_cost
from soccer_env.leagues import find_league
from soccer_env.optics.mirror_camera import metres_per_pixel, mirror_parameters
from soccer_env.records.percepts import OTHERS
from tests.perception.omni.staged_omni import NOW, SHARP, SURE, angle_difference, gather, look, watching_matches
from tests.scenes.staging import MIDDLE, put

LEAGUE = find_league(MIDDLE)
PITCH = LEAGUE.pitch
S = LEAGUE.sensors.record().view(np.recarray)[0]


@pytest.mark.parametrize(("x", "y", "distance"), [
    (0.3, 3.0, 0.3),  # halfway line
    (0.0, 0.0, 0.0),  # the halfway line runs through the centre spot
    (0.7, 0.0, 0.3),  # centre circle
    (3.0, 3.8, 0.2),  # touchline
    (-5.9, 3.5, 0.1),  # goal line
    (-6.5, -4.5, np.hypot(0.5, 0.5)),  # beyond the corner
    (4.4, 1.0, 0.1),  # penalty area, 1.5 x 5 m
    (-5.2, 2.6, 0.1),  # its side
    (5.6, -1.0, 0.1),  # goal area, 0.5 x 3 m
    (5.75, 1.52, 0.02),  # its side
])  # fmt: skip
def test_the_lines_run_where_the_rules_of_2006_draw_them(x: float, y: float, distance: float) -> None:
    for sign_x, sign_y in ((1, 1), (-1, 1), (1, -1), (-1, -1)):
        found = nearest_line(PITCH, np.array(sign_x * x), np.array(sign_y * y))
        assert found == pytest.approx(distance, abs=1e-9)


@pytest.mark.parametrize("size", [(12.0, 8.0), (18.0, 12.0), (8.0, 5.0)])
def test_the_table_of_line_costs_covers_any_pitch_and_a_metre_round_it(size: tuple[float, float]) -> None:
    pitch = replace(PITCH, length=size[0], width=size[1])
    table = line_tables(replace(LEAGUE, pitch=pitch))
    assert table.dtype == TABLES and table is line_tables(replace(LEAGUE, pitch=pitch))
    cell, costs = float(table["cell"][0]), table["line_cost"][0].reshape(COLUMNS, ROWS)
    assert COLUMNS * cell >= 0.5 * size[0] + 1.0 - 1e-9 and ROWS * cell >= 0.5 * size[1] + 1.0 - 1e-9
    rng = np.random.default_rng(0)
    x, y = rng.uniform(0.0, 0.5, (2, 500)) * (np.array(size)[:, None] + 2.0)
    known = costs[(x / cell).astype(int), (y / cell).astype(int)]
    for reach in (-1.0, 1.0):  # of the middle of a cell from the point
        off = np.maximum(nearest_line(pitch, x, y) + reach * cell * np.sqrt(0.5), 0.0)
        cost = bounded_cost((off / LEAGUE.memory.pose_line_noise) ** 2, OUTLIER)
        assert (reach * (cost - known) >= -1e-6).all()
    assert size != (12.0, 8.0) or cell == 0.1


def march(x: float, y: float, angle: float) -> float:
    """Return the distance of the first line along a ray [m], found in small steps; 0 if there is none in range."""
    t = np.arange(S.hidden_radius, S.line_range, 0.002)
    off = nearest_line(PITCH, x + t * np.cos(angle), y + t * np.sin(angle))
    near = np.flatnonzero(off <= 0.0011)
    if not len(near):
        return 0.0
    block = near[near - near[0] == np.arange(len(near))]  # a flat ray comes near before it crosses
    return float(t[block[np.argmin(off[block])]])


def test_mh02_the_first_line_in_each_direction_is_seen_to_a_pixel() -> None:
    match = watching_matches(40, sensors={**SURE, **SHARP})
    rng = np.random.default_rng(1)
    x, y, heading = rng.uniform(-6.3, 6.3, 40), rng.uniform(-4.3, 4.3, 40), rng.uniform(-np.pi, np.pi, 40)
    put(match, 0, x, y, heading)
    lines, count = look(match)["lines"], LEAGUE.sensors.lines
    wrong = 0  # a ray may just graze the end of a line or the circle, or a line lie where the body ends
    for m in range(40):
        for i in range(count):
            true = march(x[m], y[m], heading[m] + 2.0 * np.pi * i / count)
            wrong += abs(lines[m, i] - true) > 0.6 * metres_per_pixel(mirror_parameters(S), true)[0] + 0.004
    assert wrong < 0.01 * 40 * count and (lines[:, :count] > 0.0).mean() > 0.4
    assert not lines[:, count:].any()


def test_lines_are_missed_and_misjudged_like_all_things_and_none_is_seen_through_a_robot() -> None:
    match = watching_matches(20, sensors=NOW)
    put(match, 0, 2.0, 2.0, 0.0)
    found = gather(match, 200)["lines"][..., 6]  # the touchline to the left
    seen = found > 0.0
    assert seen.mean() == pytest.approx(1.0 - S.line_miss, abs=0.02)
    error = found[seen] - 2.0
    pixels = np.sqrt(S.pixel_noise**2 + 1 / 12)
    assert error.std() == pytest.approx(pixels * metres_per_pixel(mirror_parameters(S), 2.0)[0], rel=0.1)
    assert abs(error.mean()) < 0.2 * error.std()
    match = watching_matches(sensors={**SURE, **SHARP})
    put(match, 0, 2.0, 2.0, 0.0)
    assert look(match)["lines"][0, 6] == pytest.approx(2.0, abs=0.03)
    put(match, 1, 2.0, 3.2)
    assert look(match)["lines"][0, 6] == 0.0
    put(match, 1, 2.0, 4.5)
    assert look(match)["lines"][0, 6] == pytest.approx(2.0, abs=0.03)
    put(match, 1, 2.5, 3.2)  # beside the ray
    assert look(match)["lines"][0, 6] == pytest.approx(2.0, abs=0.03)


def test_players_are_told_apart_by_their_markers_and_listed_nearest_first() -> None:
    match = watching_matches(200, 2, 3, sensors=SURE)
    for r, (x, y) in {1: (2.0, 1.0), 2: (-1.0, 0.5), 3: (0.5, -3.0), 4: (-4.0, -1.0)}.items():
        put(match, r, x, y)
    for turned, heading in ((1.0, 0.0), (-1.0, 2.0)):
        match.matches["home_direction"] = turned  # the jersey is the same in both halves
        put(match, 0, 0.0, 0.0, heading)
        players = look(match)["players"]
        assert players["seen"].sum(axis=1).tolist() == [4] * 200 and players.shape[1] == OTHERS
        assert (np.diff(players["distance"][:, :4], axis=1) >= 0.0).all()
        assert players["teammate"][:, :4].tolist() == [[0, 1, 0, 0]] * 200
        expected = [np.arctan2(0.5, -1.0), np.arctan2(1.0, 2.0), np.arctan2(-3.0, 0.5), np.arctan2(-1.0, -4.0)]
        assert abs(angle_difference(players["bearing"][:, :4], np.array(expected) - heading)).max() < 0.03


def test_a_robot_behind_a_robot_is_not_seen_and_robots_that_are_off_neither_see_nor_are_seen() -> None:
    match = watching_matches(50, 2, 1, sensors=SURE)
    put(match, 1, 2.0, 0.0)
    put(match, 2, 4.0, 0.0)
    players = look(match)["players"]
    assert players["seen"].sum(axis=1).max() == 1 and (players["teammate"][:, 0] == 1).all()
    put(match, 2, 4.0, 1.0)
    assert look(match)["players"]["seen"].sum() == 100
    match = watching_matches(20, 1, 1, sensors={**SURE, "false_balls": 1.0})
    assert look(match)["players"]["seen"].sum() == 0
    match.robots["active"][:, 0] = 0
    percepts = look(match)
    assert percepts["ball"]["seen"].sum() == percepts["own_goal"]["seen"].sum() == 0 and not percepts["lines"].any()


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_goals_are_named_from_the_own_side(direction: float) -> None:
    match = watching_matches(100, sensors=SURE)
    match.matches["home_direction"] = direction
    put(match, 0, 1.0, 2.0, 0.5)
    percepts = look(match)
    for name, end in (("own_goal", -6.0 * direction), ("opponent_goal", 6.0 * direction)):
        goal = percepts[name]
        assert (goal["seen"] == 1).all()
        assert goal["distance"].mean() == pytest.approx(np.hypot(end - 1.0, -2.0), rel=0.01)
        posts = [np.arctan2(y - 2.0, end - 1.0) - 0.5 for y in (-1.0, 1.0)]
        middle = posts[0] + 0.5 * angle_difference(posts[1], posts[0])  # of what is seen
        assert abs(angle_difference(goal["bearing"], middle)).max() < 0.02


def test_a_goal_is_seen_over_robots_unless_they_are_near() -> None:
    match = watching_matches(200, 1, 1, sensors=SURE)
    goal = look(match)["opponent_goal"]
    assert goal["seen"].all() and abs(goal["bearing"].mean()) < 0.002
    put(match, 1, 3.0, 0.0)
    goal = look(match)["opponent_goal"]
    assert goal["seen"].all()
    put(match, 1, 0.5, 0.0)  # heads of 0.8 m at 0.5 m: the view from 0.75 m passes over a goal of 1 m at 6 m
    assert not look(match)["opponent_goal"]["seen"].any()
    put(match, 1, 0.8, 0.15)  # its left is hidden: the middle of the rest lies to the right
    goal = look(match)["opponent_goal"]
    assert (goal["bearing"][goal["seen"] == 1] < -0.03).all() and goal["seen"].any()


def test_goals_and_lines_are_searched_every_few_frames_by_turns_and_kept_between() -> None:
    match = watching_matches(home=2, sensors={**SURE, "search_every": 5}, robots={1: (1.0, 1.0)}, pose="particles")
    searched = []
    for step in range(20):
        match.matches["step"] = step
        match.batch.senses.sense(0, 1)
        searched.append(match.percepts["searched"][0, :2].tolist())
        assert step < 5 or (match.percepts["lines"][0, :2] > 0.0).any(axis=1).all()
    assert [row[0] for row in searched] == [int(step % 5 == 0) for step in range(20)]
    assert [row[1] for row in searched] == [int(step % 5 == 4) for step in range(20)]
    match.robots["placed"] = 1  # a robot that is put somewhere looks at once
    match.matches["step"] = 1
    match.batch.senses.sense(0, 1)
    assert match.percepts["searched"][0, :2].all()
