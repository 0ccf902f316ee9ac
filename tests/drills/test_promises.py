"""Every drill keeps on its first frame what its docstring promises: who stands where, and faces what."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.scenes import SCENES
from soccer_env.scenes.drills_alone import AT_BOARD, IN_CORNER
from soccer_env.scenes.drills_legged import DRILLS_LEGGED, GAP, KEEPER_OUT
from soccer_env.scenes.judging import PAST
from soccer_env.types import HOME, Phase
from tests.scenes.staging import LEGGED, MIDDLE, each_league, play

MATCHES = 60
DRIBBLES = [scene.name for scene in DRILLS_LEGGED if scene.success == "home gets past"]
HOLDS = 0.06  # [m] aside of a way at which a robot stands on it: less than half of its width


def drill(scene: str, league: str = LEGGED, home: int = 1) -> Match:
    """Return a drill with as many opponents as it needs."""
    away = max(len(SCENES[scene].opponents), 1)
    return Match(league, home=home, away=away, matches=MATCHES, scene=scene, seed=7, episode="drill")


def seen_from(match: Match, r: int, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return a point's distance [m] and bearing [rad] from robot r."""
    robot = match.robots[:, r]
    dx, dy = x - robot["x"], y - robot["y"]
    return np.hypot(dx, dy), np.angle(np.exp(1j * (np.arctan2(dy, dx) - robot["heading"])))


def ball_from(match: Match, r: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return the ball's distance [m] and bearing [rad] from robot r."""
    return seen_from(match, r, match.balls["x"], match.balls["y"])


def off_the_way(match: Match, r: int) -> tuple[np.ndarray, np.ndarray]:
    """Return how far robot r is along and aside [m] of the dribbler's straight way to the middle of the goal."""
    dribbler, other = match.robots[:, 0], match.robots[:, r]
    way = np.arctan2(-match.balls["y"], match.league.pitch.length / 2 - match.balls["x"])
    dx, dy = other["x"] - dribbler["x"], other["y"] - dribbler["y"]
    return np.cos(way) * dx + np.sin(way) * dy, -np.sin(way) * dx + np.cos(way) * dy


def meets_way(match: Match, r: int) -> np.ndarray:
    """Return where [m] along the dribbler's way robot r crosses it if it walks straight ahead, NaN: never."""
    along, aside = off_the_way(match, r)
    way = np.arctan2(-match.balls["y"], match.league.pitch.length / 2 - match.balls["x"])
    angle = match.robots["heading"][:, r] - way
    until = -aside / np.sin(angle)
    return np.where(until > 0.0, along + until * np.cos(angle), np.nan)


@pytest.mark.parametrize("name", [LEGGED, "legged-2001-smooth"])
def test_facing_wall_a_paw_touches_the_foot_of_the_board_and_the_ball_is_behind(name: str) -> None:
    match = drill("facing-wall", name)
    robot, league = match.robots[:, 0], find_league(name)
    side, sine, cosine = np.sign(robot["y"]), np.sin(robot["heading"]), np.cos(robot["heading"])
    paws = [robot["y"] + sine * league.body.tip_x + left * cosine * league.body.tip_y for left in (1.0, -1.0)]
    reach = np.max([side * paw for paw in paws], axis=0) + league.body.tip_radius
    np.testing.assert_allclose(reach, league.pitch.width / 2 - league.foot, atol=1e-9)
    assert (np.abs(ball_from(match)[1]) > np.pi / 2).all() and (side * sine > 0.9).all()


def test_ball_behind_robot_lies_ahead_of_both_and_in_a_head_on_push_between_their_paws() -> None:
    match = drill("ball-behind-robot")
    far, bearing = ball_from(match)
    near, aside = seen_from(match, 0, match.robots["x"][:, 1], match.robots["y"][:, 1])
    assert (np.abs(bearing) < 0.3).all() and (near < far).all()
    assert (np.abs(near * np.sin(aside - bearing)) < HOLDS).all()
    match = drill("head-on-push")
    for r in range(2):
        far, bearing = ball_from(match, r)
        other = match.robots[:, 1 - r]
        assert (far < match.league.body.tip_x + match.league.ball.radius).all() and (np.abs(bearing) < 0.03).all()
        assert (np.abs(seen_from(match, r, other["x"], other["y"])[1]) < 0.03).all()
    assert (match.robots["has_ball"] == 1).all()


@pytest.mark.parametrize("scene", DRIBBLES)
def test_a_dribbler_begins_with_the_ball_3_mm_from_its_chest_and_the_others_between_it_and_the_goal(scene: str) -> None:
    match = drill(scene)
    assert (match.robots["has_ball"][:, 0] == 1).all()
    assert (match.robots["x"][:, 1:] > match.balls["x"][:, None] + 0.05).all()
    assert (match.robots["x"][:, 1:].max(axis=1) + PAST < 1.5).all()
    away, bearing = ball_from(match)
    gap = away * np.cos(bearing) - match.league.body.front - match.league.ball.radius
    assert gap == pytest.approx(0.003, abs=1e-9)


@pytest.mark.parametrize(("scene", "near", "far", "aside", "meets"), [
    ("dribble-past-mover-near", 0.5, 0.7, 0.7, (0.2, 0.4)), ("dribble-past-mover-far", 1.1, 1.5, 0.4, (0.3, 0.6)),
    ("dribble-past-mover-head-on", 0.7, 1.3, 0.05, (-1e-6, 1e-5)),
])  # fmt: skip
def test_a_mover_stands_where_its_drill_says_and_heads_for_the_way(scene, near, far, aside, meets) -> None:
    match = drill(scene)
    along, off = off_the_way(match, 1)
    distance = np.hypot(along, off)
    assert (distance > near - 1e-9).all() and (distance < far + 1e-9).all()
    assert (np.abs(np.arctan2(off, along)) < aside + 1e-9).all()
    crossing = meets_way(match, 1)
    assert (crossing > meets[0] - 1e-9).all() and (crossing < meets[1] + 1e-6).all()


def test_mover_and_still_stand_on_either_side_and_in_gap_500_half_a_metre_apart() -> None:
    match = drill("mover-and-still")
    (_, still), (_, mover) = off_the_way(match, 1), off_the_way(match, 2)
    assert (still * mover < 0.0).all()
    crossing = meets_way(match, 2)
    assert (crossing > 0.25 - 1e-9).all() and (crossing < 0.5 + 1e-9).all()
    match = drill("gap-500")
    (first, left), (second, right) = off_the_way(match, 1), off_the_way(match, 2)
    np.testing.assert_allclose(np.hypot(first - second, left - right), GAP)
    np.testing.assert_allclose(first, second, atol=1e-9)
    assert (left * right < 0.0).all()


def test_far_post_shots_go_inside_the_other_post_past_a_goalkeeper_on_the_line_to_the_ball() -> None:
    match = drill("far-post-shots")
    pitch, ball, keeper = match.league.pitch, match.balls, match.robots[:, 1]
    at_goal = ball["y"] + (pitch.length / 2 - ball["x"]) * ball["vy"] / ball["vx"]
    inside = pitch.goal_width / 2 - match.league.ball.radius - np.abs(at_goal)
    assert (inside >= -1e-9).all() and (inside < 0.07).all() and (at_goal * ball["y"] < 0.0).all()
    out = np.hypot(pitch.length / 2 - keeper["x"], keeper["y"])
    np.testing.assert_allclose(out, KEEPER_OUT)
    assert (np.abs(ball_from(match, 1)[1]) < 1e-9).all()


@pytest.mark.parametrize("senses", ["sensors", "ideal"])
def test_lost_ball_behind_a_robot_that_saw_it_ahead(senses: str) -> None:
    """By sensors the memory is wrong, as far ahead as the ball lies behind; ideal senses are not deceived."""
    match = Match(
        LEGGED, home=1, away=1, matches=MATCHES, scene="lost-ball-behind", seed=7, episode="drill",
        controllers={"home": "chaser", "away": "still"}, senses=senses,
    )  # fmt: skip
    far, bearing = ball_from(match)
    assert (far > 0.5 - 1e-9).all() and (far < 0.7 + 1e-9).all() and (np.abs(bearing) > np.pi - 0.36).all()
    assert (np.abs(match.balls["y"]) < match.league.pitch.width / 2 - match.league.ball.radius).all()
    believed = match.beliefs["ball"][:, 0]
    told = np.cos(believed["bearing"] - bearing)
    if senses == "ideal":
        assert (told > 0.999).all()
    else:
        seen = believed["age"] == 0.0
        assert seen.mean() > 0.9 and (told[seen] < -0.99).all()


def test_ball_at_board_lies_within_reach_of_it_and_ball_in_corner_within_25_cm_of_one_beside_aways_goal() -> None:
    match = drill("ball-at-board")
    gap = match.league.pitch.width / 2 - match.league.ball.radius - np.abs(match.balls["y"])
    assert (gap > -1e-9).all() and (gap < AT_BOARD).all() and gap.min() < 0.2 * AT_BOARD
    assert (np.abs(match.balls["x"]) < 1.1).all() and {-1.0, 1.0} == set(np.sign(match.balls["y"]))
    assert (np.abs(ball_from(match)[1]) < 0.31).all() and (ball_from(match)[0] < 0.81).all()
    match = drill("ball-in-corner")
    pitch, ball = match.league.pitch, match.balls
    aside, ahead = pitch.width / 2 - np.abs(ball["y"]), pitch.length / 2 - ball["x"]
    for gap in (aside - match.league.ball.radius, ahead - match.league.ball.radius):
        assert (gap > -1e-9).all() and (gap < IN_CORNER).all()
    assert (np.hypot(aside, ahead) < 0.25).all() and {-1.0, 1.0} == set(np.sign(ball["y"]))
    assert (np.abs(ball_from(match)[1]) < 0.31).all() and (ball_from(match)[0] < 0.81).all()


@each_league
def test_empty_goal_the_robot_is_behind_the_ball_and_nobody_before_it(name: str) -> None:
    match = drill("empty-goal", name)
    half = match.league.pitch.length / 2
    assert (match.robots["x"][:, 0] < match.balls["x"]).all() and (np.abs(ball_from(match)[1]) < 0.51).all()
    assert (match.balls["x"] > 0.3 * half).all() and (match.robots["x"][:, 1] < 0.0).all()


@each_league
def test_shot_at_keeper_is_on_target_from_4_m_or_a_third_of_the_pitch(name: str) -> None:
    match = drill("shot-at-keeper", name)
    league, ball = match.league, match.balls
    half = league.pitch.length / 2
    away = np.hypot(half - ball["x"], ball["y"])
    np.testing.assert_allclose(away, min(4.0, league.pitch.length / 3))
    at_goal = ball["y"] + (half - ball["x"]) * ball["vy"] / ball["vx"]
    assert (np.abs(at_goal) < league.pitch.goal_width / 2 - league.ball.radius).all()
    np.testing.assert_allclose(np.hypot(ball["vx"], ball["vy"]), min(4.0, 0.8 * league.kicker.fastest))
    assert (np.abs(match.robots["y"][:, 1]) < 1e-9).all() and (match.robots["x"][:, 1] > 0.8 * half).all()


@each_league
def test_far_before_the_empty_goal_and_in_a_run_to_score_the_robot_has_the_goal_before_it_and_all_others_behind(
    name: str,
) -> None:
    for scene in ("empty-goal-far", "run-to-score"):
        match = drill(scene, name)
        half, robots = match.league.pitch.length / 2, match.robots["x"]
        assert (match.balls["x"] < 0.6 * half).all() and (match.balls["x"] > 0.0).all()
        assert (robots[:, 0] < match.balls["x"]).all() and (robots[:, 1] < robots[:, 0]).all()
        assert (np.abs(ball_from(match)[1]) < 0.51).all()
    assert (robots[:, 1] > robots[:, 0] - 0.131 * 2 * half).all(), "the chaser is near"


@each_league
def test_a_contested_ball_is_as_near_to_both_and_a_ball_to_win_is_at_the_opponents_kicker(name: str) -> None:
    match = drill("contested-ball", name)
    (ours, ahead), (theirs, across) = ball_from(match, 0), ball_from(match, 1)
    np.testing.assert_allclose(ours, theirs)
    assert (np.abs(ahead) < 0.31).all() and (np.abs(across) < 0.31).all() and not match.robots["has_ball"].any()
    match = drill("win-the-ball", name)
    assert (match.robots["has_ball"] == [0, 1]).all()
    assert (match.robots["x"][:, 0] < match.balls["x"]).all() and (match.balls["x"] < match.robots["x"][:, 1]).all()


@each_league
def test_attackers_have_the_ball_defenders_and_their_goalkeeper_are_before_them(name: str) -> None:
    for scene, attackers, defenders in (
        ("pass-and-shoot", 2, 2), ("two-v-two", 2, 3), ("keep-away", 2, 2), ("one-v-keeper", 1, 1)
    ):  # fmt: skip
        home = SCENES[scene].players
        match = drill(scene, name, home)
        robots, last = match.robots, home - 1
        assert (robots["has_ball"][:, last] == 1).all() and (robots["has_ball"].sum(axis=1) == 1).all()
        ahead = robots["x"] > 0.0
        assert (ahead[:, :home].sum(axis=1) == attackers).all() and (ahead[:, home:].sum(axis=1) == defenders).all()
        assert (robots["x"][:, home] > 0.8 * match.league.pitch.length / 2).all() and (robots["keeper"][:, home]).all()
    match = drill("pass-and-shoot", name, 3)
    assert (np.sign(match.robots["y"][:, 1]) != np.sign(match.robots["y"][:, 4])).all(), "the mate is free"


@pytest.mark.parametrize(("scene", "phase", "name"), [
    ("kick-off-goal", Phase.KICK_OFF, LEGGED), ("kick-off-goal", Phase.KICK_OFF, MIDDLE),
    ("corner-kick", Phase.CORNER_KICK, MIDDLE), ("free-kick", Phase.FREE_KICK, MIDDLE),
])  # fmt: skip
def test_home_takes_a_restart_and_opponents_keep_their_distance(scene: str, phase: Phase, name: str) -> None:
    match = drill(scene, name, 3)
    away = np.hypot(*(match.robots[axis] - match.balls[axis][:, None] for axis in "xy"))
    assert (match.matches["phase"] == phase).all() and (match.matches["restart_team"] == HOME).all()
    assert (away.argmin(axis=1) == 2).all() and (away[:, 2] < 0.2 * match.league.pitch.length).all()
    assert (away[:, 3:] > match.league.rules.restart_distance).all()
    play(match, seconds=0.2)
    assert (match.matches["phase"] == phase).all() and not match.events["drill"].any()


def test_who_keeps_the_ball_until_time_is_up_succeeds_and_who_lets_others_have_it_fails() -> None:
    match = drill("keep-away", LEGGED, 3)
    match.robots["has_ball"][:30] = [0, 0, 1, 0, 1]
    play(match, steps=1)
    assert (match.events["drill"][:30] == -1).all() and not match.events["drill"][30:].any()
    play(match, steps=round(SCENES["keep-away"].time_limit * match.league.control_rate) - 1)
    assert (match.events["drill"][30:] == 1).all() and match.terminated[30:].all()
