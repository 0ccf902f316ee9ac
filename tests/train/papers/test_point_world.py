"""The simulation with points: it goes by the team's own forces, and counts what its runs do.  MS54"""

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.forces import goal_force, player_force, wall_force
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.baselines.sacks_2001.steering import limited
from soccer_env.train.papers.claims.field.point_world import PointWorld, players


def test_ms54_points_go_as_the_teams_own_forces_say() -> None:
    """Straight on where nobody is; past somebody each step is that of forces and limit, and it keeps clear of him."""
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
    with_rule, without = (
        PointWorld(SacksSettings(keep_side=keep)).run([[-1.2, 0.01]], players([[0.0, 0.25], [0.0, -0.25]]))
        for keep in (True, False)
    )
    assert with_rule.flips[0] == 0 and without.flips[0] >= 10
    assert with_rule.retreats[0] == without.retreats[0] == 0
