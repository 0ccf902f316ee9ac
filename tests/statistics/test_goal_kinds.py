"""How goals fall: staged goals of every kind, for both teams, in both halves."""

import numpy as np
import pytest

from soccer_env.statistics.records import GoalKind
from tests.scenes.staging import LEGGED, each_league
from tests.statistics.staged_play import CASES, Scene

each_case = pytest.mark.parametrize(("team", "half"), CASES)


def assert_only(scene, kind, opponents=False):
    """Tell that one goal fell, for one team, of one kind."""
    expected = np.zeros((2, len(GoalKind)), int)
    expected[1 - scene.team if opponents else scene.team, kind] = 1
    assert scene.match.statistics["goals"][0].tolist() == expected.tolist()


@each_league
@each_case
def test_a_kick_into_an_empty_goal_is_a_clean_kick_and_a_shot_on_target(name, team, half):
    scene = Scene(name, team, half)
    scene.feed(scene.row(), scene.line - 0.7, 0.05)
    scene.begin()
    scene.kick(scene.row())
    assert_only(scene, GoalKind.CLEAN_KICK)
    assert [scene.of(what) for what in ("kicks", "shots", "on_target", "solo")] == [1, 1, 1, 1]
    assert [scene.of(what, opponents=True) for what in ("kicks", "shots", "on_target", "solo", "saves")] == [0] * 5


@each_league
@each_case
def test_a_kick_into_the_own_goal_is_an_own_goal_and_no_shot(name, team, half):
    scene = Scene(name, team, half)
    scene.feed(scene.row(), 0.7 - scene.line, 0.05, np.pi)
    scene.begin()
    scene.kick(scene.row())
    assert_only(scene, GoalKind.OWN_GOAL, opponents=True)
    assert scene.of("kicks") == 1 and scene.of("shots") == 0


@each_league
@each_case
def test_a_ball_walked_into_an_empty_goal_is_a_clean_dribble(name, team, half):
    scene = Scene(name, team, half)
    scene.feed(scene.row(), scene.line - 0.5, 0.0)
    scene.begin()
    scene.actions[:, scene.row(), 0] = 0.7
    for _ in range(round(6.0 * scene.match.league.control_rate)):
        if scene.of("goals").sum() == 0:  # it would walk on after the kick-off
            scene.play(1)
    assert_only(scene, GoalKind.CLEAN_DRIBBLE)
    assert scene.of("shots") == 0 and scene.of("after_pushed_keeper") == 0


@each_case
def test_a_ball_walked_in_along_an_opponent_is_pushed_in(team, half):
    scene = Scene(LEGGED, team, half)
    scene.feed(scene.row(), scene.line - 0.35, 0.0)
    scene.put(scene.row(opponent=True), scene.line - 0.30, 0.155)
    scene.begin()
    scene.actions[:, scene.row(), 0] = 1.0
    scene.play(round(5.0 * scene.match.league.control_rate))
    assert_only(scene, GoalKind.PUSHED_IN)


@each_case
def test_a_push_long_before_does_not_make_a_dribble_a_push(team, half):
    scene = Scene(LEGGED, team, half)
    scene.feed(scene.row(), scene.line - 1.0, 0.0)
    scene.put(scene.row(opponent=True), scene.line - 1.05, 0.155)
    scene.begin()
    scene.actions[:, scene.row(), 0] = 1.0
    scene.play(round(12.0 * scene.match.league.control_rate))
    assert_only(scene, GoalKind.CLEAN_DRIBBLE)


@each_case
def test_a_ball_bumped_in_among_three_robots_is_a_scrum(team, half):
    scene = Scene(LEGGED, team, half, players=2)
    scene.feed(scene.row(1), scene.line - 0.15, 0.0)
    scene.put(scene.row(0), scene.line - 0.1, 0.26)
    scene.put(scene.row(1, opponent=True), scene.line - 0.1, -0.26)
    scene.ball(scene.line + 0.035, 0.0)
    scene.match.rebuild()
    scene.actions[:, scene.row(1), 0] = 1.0
    scene.play(round(1.5 * scene.match.league.control_rate))
    assert_only(scene, GoalKind.SCRUM)


@each_case
def test_a_kick_that_grazes_a_defender_is_deflected(team, half):
    scene = Scene(LEGGED, team, half)
    body, ball = scene.match.league.body, scene.match.league.ball
    scene.feed(scene.row(), scene.line - 0.9, 0.0)
    scene.put(scene.row(opponent=True), scene.line - 0.3, body.tip_y + body.tip_radius + ball.radius + 0.002)
    scene.begin()
    scene.kick(scene.row())
    assert_only(scene, GoalKind.DEFLECTED_KICK)
    assert scene.of("on_target") == 1


def test_what_came_before_a_goal_is_noted_within_its_time_and_not_after_it() -> None:
    for seconds, counted in ((5.0, 1), (7.0, 0)):
        scene = Scene(LEGGED, 0, 0)
        scene.feed(scene.row(), scene.line - 0.7, 0.0)
        scene.begin()
        step = int(scene.match.matches["step"][0])
        trail = scene.match.statistics["trail"]
        trail["separated"] = step + 10 - round(seconds * scene.match.league.control_rate)
        trail["in_play"], trail["kind"] = trail["separated"], 1
        scene.kick(scene.row())
        assert_only(scene, GoalKind.CLEAN_KICK)
        assert scene.of("after_separation") == counted
        assert scene.of("after_restart")[1] == 1  # within 10 s in both


@each_case
def test_a_goal_after_a_pushed_keeper_says_so(team, half):
    scene = Scene(LEGGED, team, half, players=2)
    scene.feed(scene.row(1), scene.line - 0.8, 0.1)
    scene.put(scene.row(0, opponent=True), scene.line - 0.15, -0.15)
    scene.put(scene.row(0), scene.line - 0.42, -0.15)
    scene.begin()
    scene.actions[:, scene.row(0), 0] = 1.0
    scene.play(round(3.0 * scene.match.league.control_rate))
    assert scene.of("goals").sum() == 0
    scene.kick(scene.row(1))
    assert scene.of("goals").sum() == 1 and scene.of("after_pushed_keeper") == 1
