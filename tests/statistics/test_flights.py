"""Staged goals of every kind, shots, saves and passes, for both teams; where a ball rolls as it is said to."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.statistics.flights import predict_aim
from soccer_env.statistics.records import Aim, GoalKind
from soccer_env.types import NO_TEAM
from tests.scenes.staging import LEGGED, MIDDLE, boarded, each_league, put_ball, stage, stand, steady
from tests.statistics.staged_play import CASES, Scene

each_case = pytest.mark.parametrize(("team", "half"), CASES)
APART = {LEGGED: (0.25, 0.5), MIDDLE: (0.9, 2.0)}  # [m] from where the ball is played to where it is touched


def passes(scene, opponents=False):
    return [scene.of(name, opponents) for name in ("passes_tried", "passes", "interceptions")]


def played_across(name, team, half, apart, opponent):
    """Return a scene in which a robot kicked across the pitch to another whose front is so far [m] away."""
    scene = Scene(name, team, half, players=2)
    body = scene.match.league.body
    start = -0.5 * apart - body.front
    scene.feed(scene.row(1), 0.0, start, np.pi / 2)
    ball_at = start + body.front + 2.0 * scene.match.league.ball.radius + 0.005
    receiver = scene.row(0, opponent=True) if opponent else scene.row(0)
    scene.put(receiver, 0.0, ball_at + apart + body.front, -np.pi / 2)
    scene.begin()
    scene.kick(scene.row(1), strength=0.6, seconds=1.5 if name == LEGGED else 0.6)
    return scene


@each_league
@each_case
@pytest.mark.parametrize(("far", "opponent", "ours", "theirs"), [
    (1, False, [1, 1, 0], [0, 0, 0]), (1, True, [1, 0, 0], [0, 0, 1]), (0, False, [0, 0, 0], [0, 0, 0]),
])  # fmt: skip
def test_a_ball_kicked_to_a_mate_is_a_pass_to_an_opponent_intercepted_and_handed_over_from_near_neither(
    name, team, half, far, opponent, ours, theirs
):
    scene = played_across(name, team, half, APART[name][far], opponent)
    assert (passes(scene), passes(scene, opponents=True), scene.of("shots")) == (ours, theirs, 0)


@each_league
def test_a_ball_goes_in_just_where_it_is_on_target(name):
    """400 balls, sliding or rolling, from anywhere, against the physics; those that only just do or do not are left."""
    matches, rng = 400, np.random.default_rng(7)
    league = steady(boarded(name))
    pitch, k = league.pitch, constants_of(league)[0]
    match = stage(league, matches)
    x, y = rng.uniform(-0.4, 0.4, matches) * pitch.length, rng.uniform(-0.3, 0.3, matches) * pitch.width
    v = rng.uniform(0.1, 1.0, matches) * league.kicker.fastest
    angle = np.arctan2(rng.uniform(-0.6, 0.6, matches) * pitch.goal_width - y, pitch.length / 2 - x)
    rolls = rng.random(matches) < 0.5
    put_ball(match, x, y, v * np.cos(angle), v * np.sin(angle))
    for way in ("x", "y"):
        match.balls[f"roll_{way}"] = np.where(rolls, match.balls[f"v{way}"], 0.0)
    aims = {scale: [predict_aim(scaled(ball, scale), 1.0, k) for ball in match.balls] for scale in (0.99, 1.0, 1.01)}
    wide = np.abs(y + (pitch.length / 2 - x) * np.tan(angle))
    sure = (np.array(aims[0.99]) == aims[1.01]) & (np.abs(wide - pitch.goal_width / 2) > 2.0 * league.ball.radius)
    match.rebuild()
    scored = np.zeros(matches, bool)
    for _ in range(round(15.0 * league.control_rate)):
        match.step(stand(match))
        scored |= match.events["goal"] != NO_TEAM
        if not (np.abs(match.balls["vx"]) > 0.0).any():
            break
    first = scored & (match.matches["score"][:, 0] > 0)
    assert first[sure].tolist() == (np.array(aims[1.0]) == Aim.ON_TARGET)[sure].tolist()
    assert 40 < first[sure].sum() < sure.sum() - 40


def scaled(ball, scale):
    """Return a ball with other velocities."""
    other = ball.copy()
    for field in ("vx", "vy", "roll_x", "roll_y"):
        other[field] *= scale
    return other


def test_the_aim_is_the_same_for_both_directions_and_sides():
    league = find_league(LEGGED)
    k = constants_of(league)[0]
    match = stage(LEGGED)
    rng = np.random.default_rng(3)
    seen = set()
    for x, y, vx, vy in rng.uniform(-1.0, 1.0, (1000, 4)):
        aims = set()
        for sign_x, sign_y in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            put_ball(match, sign_x * x, sign_y * y, sign_x * vx, sign_y * vy)
            aims.add(predict_aim(match.balls[0], float(sign_x), k))
        assert len(aims) == 1
        seen |= aims
    assert seen == set(Aim)


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
@pytest.mark.parametrize(("before", "other", "seconds", "kind"), [
    (0.35, 0.30, 5.0, GoalKind.PUSHED_IN), (1.0, 1.05, 12.0, GoalKind.CLEAN_DRIBBLE),  # the push was long before
])  # fmt: skip
def test_a_ball_walked_in_along_an_opponent_is_pushed_in(team, half, before, other, seconds, kind):
    scene = Scene(LEGGED, team, half)
    scene.feed(scene.row(), scene.line - before, 0.0)
    scene.put(scene.row(opponent=True), scene.line - other, 0.155)
    scene.begin()
    scene.walk(scene.row(), 1.0, seconds)
    assert_only(scene, kind)
