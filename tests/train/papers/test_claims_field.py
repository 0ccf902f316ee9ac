"""The scenes of the potential field stand as they say, with points and with robots, and what is counted is right."""

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.forces import goal_force, player_force, repulsion, wall_force
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.baselines.sacks_2001.steering import limited
from soccer_env.train.papers.claim import Batch, as_plain
from soccer_env.train.papers.claims.field import constants, forces, minima, points
from soccer_env.train.papers.claims.field.point_world import PointWorld, players
from soccer_env.train.papers.claims.field.points import RobotRuns
from soccer_env.train.papers.dribble_runs import DribbleRecord
from soccer_env.train.papers.report import figure_table
from soccer_env.train.report import draw_curves

BATCH = Batch("test", 0, 0)


def test_a_field_is_drawn_with_its_arrows() -> None:
    figure = as_plain(forces.S47.figures({})[0])
    assert set(figure["arrows"]) == {"x", "y", "along_x", "along_y"}
    assert draw_curves(figure)[:4] == b"\x89PNG" and draw_curves(figure) == draw_curves(figure)
    assert figure_table(figure) == "Forces with the cosine factor: a picture of the field, which needs matplotlib"


def runs_of(x: list[float], off: list[float], touches: list[int], goal: list[int] | None = None) -> RobotRuns:
    column = np.array(x)[:, None]
    none, flags = np.zeros_like(column), np.array(touches, bool)[:, None]
    scored = np.zeros_like(flags) if goal is None else np.array(goal, bool)[:, None]
    way = DribbleRecord(column, none, none, ~flags, ~flags, flags, none, none, scored)
    return RobotRuns(way, np.array(off)[:, None])


def test_what_became_of_robots_is_counted_until_they_have_passed() -> None:
    runs = runs_of([0.0, 0.2, 0.1, 0.6, 0.2], [1.0, -1.0, 0.1, 1.0, -1.0], [0, 0, 0, 0, 1])
    assert runs.arrived[0] and not runs.collided[0] and runs.is_clean[0]
    assert runs.flips[0] == 1 and runs.retreat[0] == pytest.approx(0.1)
    hit = runs_of([0.0, 0.2, 0.3], [np.nan, np.nan, np.nan], [0, 1, 0])
    assert hit.collided[0] and not hit.arrived[0] and not hit.is_clean[0] and hit.flips[0] == 0
    assert runs_of([0.0, 0.2], [0.0, 0.0], [0, 0], [0, 1]).arrived[0]
    assert runs.deviation[0] == 0.0  # straight on


def test_a_force_without_cut_off_is_matched_where_the_papers_is_one() -> None:
    for changes in ({}, points.NO_CUT_OFF):
        play = SacksSettings(**changes).record()[0]
        assert repulsion(points.UNIT, play["player_gain"], play["player_range"], play) == pytest.approx(1.0)
        assert repulsion(points.WALL_UNIT, play["wall_gain"], play["wall_range"], play) == pytest.approx(1.0)


def test_the_least_value_that_suffices_is_near_the_best() -> None:
    samples = {}
    for kind, found in (("standing", (0.2, 0.93, 1.0, 1.0, 1.0, 1.0)), ("moving", (0.0, 0.0, 0.2, 0.5, 0.58, 0.6))):
        for axis, values in constants.AXES.items():
            for value, one in zip(values, found, strict=True):
                samples[f"points {kind} {axis} {value:g}"] = np.array([one])
    assert constants.least_sufficient_value(samples, "points", "standing", "k2") == pytest.approx(0.2, rel=0.15)
    assert constants.least_sufficient_value(samples, "points", "moving", "k2") == pytest.approx(0.8, rel=0.4)
    assert constants.moving_over_standing_value(samples, "points", "x0") > 1.0


def test_trouble_is_a_stall_or_a_retreat() -> None:
    found = {"stalls": [0, 1, 0.0], "retreats": [0, 0, 1.0]}
    samples = {f"points gap, limit off: {what}": np.array(values) for what, values in found.items()}
    assert minima.has_trouble(samples, "points", "gap", "off").tolist() == [0.0, 1.0, 1.0]
    assert minima.trouble_share(samples, "points", "off", ("gap",)) == pytest.approx(200.0 / 3.0)


def test_ms54_points_go_as_the_teams_own_forces_say() -> None:
    alone = PointWorld().run([[-1.0, 0.5]], players([[0.0, -0.9]]))
    assert alone.arrived[0] and alone.deviation[0] < 1e-9
    runs = PointWorld().run([[-1.0, 0.0]], players([[0.0, 0.05]]))
    assert runs.arrived[0] and 0.3 < runs.clearance[0] < 0.6 and runs.deviation[0] > 0.3
    play = SacksSettings().record()[0]
    for t in range(runs.steps[0]):
        x, y = runs.path[t, 0]
        pull = goal_force(1.6 - x, -y, play)
        push = player_force(0.0 - x, 0.05 - y, 1.6 - x, -y, play)
        off = limited(*pull, push[0], push[1] + wall_force(y, 1.0, play), 0.0, play)
        assert runs.off[t, 0] == pytest.approx(off, abs=1e-9)


def test_ms54_players_move_straight_on_or_come_for_the_dribbler() -> None:
    crowd = players([[0.5, 0.3], [0.8, 0.0]], [[0.0, -0.1], [0.0, 0.0]], [0.0, 0.06])
    runs = PointWorld().run([[-1.0, 0.0]], crowd, seconds=4.0)
    assert runs.others[8, 0, 0] == pytest.approx([0.5, -0.1])
    gap = np.linalg.norm(runs.others[:, 0, 1] - runs.path[:, 0], axis=-1)
    assert np.diff(gap).max() < -0.05
    met = PointWorld().run([[0.0, 0.0]], players([[0.1, 0.0]], [[-0.8, 0.0]]), seconds=0.5)
    assert met.clearance[0] < 0.05  # passed between two decisions


def test_ms54_noise_and_false_blobs_are_what_the_robot_sees_not_what_is_there() -> None:
    start, crowd = np.tile([-1.0, 0.0], (200, 1)), players(np.tile([[0.0, 0.2]], (200, 1, 1)))
    clean = PointWorld().run(start, crowd)
    noisy = PointWorld(range_noise=0.1).run(start, crowd, rng=np.random.default_rng(1))
    blobs = PointWorld(false_blobs=0.3).run(start, crowd, rng=np.random.default_rng(1))
    assert np.ptp(clean.clearance) == 0.0
    for runs in (noisy, blobs):
        assert np.ptp(runs.clearance) > 0.01
        assert np.nanstd(runs.turns) > 1.5 * np.nanstd(clean.turns)
        assert (runs.others[0] == clean.others[0]).all()


def test_ms54_a_body_that_faces_the_goal_keeps_its_steps_within_the_bodys_limit() -> None:
    crowd = players([[0.0, 0.25], [0.0, -0.25]])
    point, body = (PointWorld(body=body).run([[-1.0, 0.01]], crowd) for body in (False, True))
    assert np.degrees(np.nanmax(np.abs(point.off))) == pytest.approx(70.0)
    assert np.degrees(np.nanmax(np.abs(body.off))) == pytest.approx(55.0)


def test_changes_of_side_are_counted_and_small_ones_are_not() -> None:
    crowd = players([[0.0, 0.25], [0.0, -0.25]])
    worlds = (PointWorld(SacksSettings(keep_side=keep)) for keep in (True, False))
    with_rule, without = (world.run([[-1.2, 0.01]], crowd) for world in worlds)
    assert with_rule.flips[0] == 0 and without.flips[0] >= 10
    assert with_rule.retreats[0] == without.retreats[0] == 0
