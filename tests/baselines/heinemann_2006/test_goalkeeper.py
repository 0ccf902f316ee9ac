"""Goalkeeper and passes in closed form: where it stands and moves, who is passed to, how hard, who takes the ball.

MH19 passive, on the line d; MH20 active, by the perpendicular into the trajectory; MH21 its reaction and acceleration;
MH22 interception of a rolling ball.
"""

from math import hypot, inf, sqrt
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.heinemann_2006.goalkeeper import interception, is_shot, keep_goal, passive_place, spare_time
from soccer_env.baselines.heinemann_2006.intercepting import STEP, meeting_time, moving_time, rolling_time
from soccer_env.baselines.heinemann_2006.memory import MEMORY, SCRATCH
from soccer_env.baselines.heinemann_2006.passing import choose_pass, open_place, own_team_is_nearer, pass_strength
from soccer_env.baselines.heinemann_2006.roles import right_rank, way_there
from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings, settings_records
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills.sight import SIGHT
from soccer_env.types import COMMAND, Phase
from tests.scenes.staging import MIDDLE

LEAGUE = find_league(MIDDLE)
K = constants_of(LEAGUE)[0]
HALF, OMNI = 6.0, 1  # [m] to the goal line, row of the omnidirectional base
REACH = 0.2 + 0.11  # [m] keeper_reach and the ball's radius


def settings(**changes: Any) -> np.void:
    return settings_records(HeinemannSettings(**changes))[OMNI]


def seen(x: float, y: float, ball: tuple[float, float], velocity: tuple[float, float]) -> np.void:
    """Return what a goalkeeper at a place sees of a ball [m, m/s]."""
    sight = np.zeros(1, SIGHT)[0]
    sight["x"], sight["y"] = x, y
    sight["ball_x"], sight["ball_y"] = ball
    sight["ball_vx"], sight["ball_vy"] = velocity
    return sight


@pytest.mark.parametrize("ball", [(-3.0, 2.0), (-3.0, -2.0), (0.0, 0.0), (4.0, 3.5)])
def test_mh19_on_the_half_circle_it_stands_on_the_line_from_ball_to_goal(ball: tuple[float, float]) -> None:
    x, y = passive_place(*ball, K, settings(stance="circle", keeper_radius=0.7))
    assert hypot(x + HALF, y) == pytest.approx(0.7)
    assert (x + HALF) * ball[1] == pytest.approx(y * (ball[0] + HALF))


@pytest.mark.parametrize("ball", [(-3.0, 2.0), (-3.0, -2.0), (0.0, 0.0), (4.0, 3.5)])
def test_mh19_on_the_goal_line_it_stands_where_the_line_from_ball_to_goal_meets_it(ball: tuple[float, float]) -> None:
    x, y = passive_place(*ball, K, settings(stance="line", keeper_out=0.35))
    assert (x, y) == pytest.approx((0.35 - HALF, 0.35 * ball[1] / (ball[0] + HALF)))


@pytest.mark.parametrize("stance", ["circle", "line"])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_mh19_a_ball_at_the_goal_line_leaves_it_between_the_posts(stance: str, side: float) -> None:
    x, y = passive_place(-HALF, side * 3.0, K, settings(stance=stance, keeper_radius=1.5))
    assert (x, y) == pytest.approx((0.35 - HALF, side * 1.0))


@pytest.mark.parametrize(("ball", "velocity", "shot"), [
    ((-3.0, 0.0), (-4.0, 0.0), True),
    ((-3.0, 0.0), (4.0, 0.0), False),  # away from the goal
    ((-3.0, 0.0), (0.0, 4.0), False),  # along it
    ((-3.0, 0.0), (-0.4, 0.0), False),  # slower than a shot
    ((-3.0, 0.0), (-1.6, 0.0), True),  # v^2 / 2a = 3.2 m: rolls in
    ((-3.0, 0.0), (-1.5, 0.0), False),  # 2.8 m: stops before the line
    ((-3.0, 0.0), (-3.0, 1.2), True),  # crosses at 1.2 m
    ((-3.0, 0.0), (-3.0, 1.3), False),  # at 1.3 m, beside the post and what may be believed
])  # fmt: skip
def test_mh20_a_shot_is_a_ball_that_rolls_over_the_line_between_the_posts(ball, velocity, shot) -> None:
    for side in (1.0, -1.0):
        sight = seen(-5.5, 0.0, ball, (velocity[0], side * velocity[1]))
        assert bool(is_shot(sight, K, settings())) == shot


@pytest.mark.parametrize("keeper", [(-5.3, 0.3), (-5.3, -0.5), (-5.5, 0.0)])
def test_mh20_it_moves_perpendicular_into_the_trajectory(keeper: tuple[float, float]) -> None:
    ball, velocity = (-2.0, 1.0), (-4.0, -0.9)
    x, y = interception(seen(*keeper, ball, velocity), K, settings(keeper_waits=False))
    ux, uy = np.array(velocity) / hypot(*velocity)
    assert (x - keeper[0]) * ux + (y - keeper[1]) * uy == pytest.approx(0.0, abs=1e-12)
    assert (x - ball[0]) * uy == pytest.approx((y - ball[1]) * ux)
    goes = hypot(x - keeper[0], y - keeper[1])
    crossing = ball[1] + velocity[1] * (-HALF - ball[0]) / velocity[0]
    assert goes < hypot(-HALF - keeper[0], crossing - keeper[1])  # H21: the shortest way


def test_mh20_a_trajectory_that_is_nearest_behind_the_line_is_met_before_it() -> None:
    x, _ = interception(seen(-5.9, 0.9, (-2.0, -3.0), (-4.0, 4.0)), K, settings(keeper_waits=False))
    assert x == pytest.approx(0.35 - HALF)


def driven(velocity: tuple[float, float], **changes: Any) -> tuple[float, float]:
    """Return whither (unit vector) a goalkeeper drives that sees a ball at (-2, 1) from (-5, 0.5), facing up field."""
    scratch, memory, command = (np.zeros(1, dtype)[0] for dtype in (SCRATCH, MEMORY, COMMAND))
    sight = scratch["sight"]
    for name in ("x", "y", "ball_x", "ball_y", "ball_vx", "ball_vy"):
        sight[name] = seen(-5.0, 0.5, (-2.0, 1.0), velocity)[name]
    sight["cosine"] = sight["pace"] = 1.0
    sight["elapsed"], sight["distance"] = 0.02, 3.0
    keep_goal(command, memory, K, settings(**changes), scratch)
    size = hypot(command["forward"], command["left"])
    return float(command["forward"]) / size, float(command["left"]) / size


def test_mh20_it_moves_into_a_shot_only_and_the_passive_one_stays_on_the_line_from_ball_to_goal() -> None:
    shot, none = (-4.0, -0.4), (0.0, 0.0)
    x, y = interception(seen(-5.0, 0.5, (-2.0, 1.0), shot), K, settings())
    into = hypot(x + 5.0, y - 0.5)
    assert driven(shot) == pytest.approx(((x + 5.0) / into, (y - 0.5) / into))
    x, y = passive_place(-2.0, 1.0, K, settings())
    back = hypot(x + 5.0, y - 0.5)
    for found in (driven(none), driven(shot, keeper="passive"), driven(none, keeper="passive")):
        assert found == pytest.approx(((x + 5.0) / back, (y - 0.5) / back))


def test_mh21_reaction_and_acceleration_tell_how_long_a_move_takes() -> None:
    assert moving_time(0.0, 0.0, 0.1, K) == 0.0
    assert moving_time(0.5, 0.0, 0.1, K) == pytest.approx(0.1 + sqrt(2.0 * 0.5 / 4.0))
    assert moving_time(2.845, 0.0, 0.0, K) == pytest.approx(0.65 + 2.0 / 2.6)  # 0.845 m in 0.65 s, then 2 m
    assert moving_time(2.0, 2.6, 0.0, K) == pytest.approx(2.0 / 2.6)
    for speed in (1.0, -1.0):  # s = v t + a t^2 / 2
        t = moving_time(0.5, speed, 0.0, K)
        assert speed * t + 2.0 * t * t == pytest.approx(0.5)
    assert rolling_time(3.0, 2.0, K) == pytest.approx((3.0 - sqrt(9.0 - 1.6)) / 0.4)
    assert rolling_time(1.0, 1.3, K) == inf  # it stops after 1.25 m


@pytest.mark.parametrize("reaction", [0.1, 0.15, 0.2])
def test_mh21_what_it_can_spare_is_the_balls_time_less_its_own(reaction: float) -> None:
    sight = seen(-5.5, 0.8, (-2.0, 0.0), (-5.0, 0.0))
    spare = spare_time(sight, -1.0, 0.0, 5.0, 3.5, K, settings(reaction=reaction))
    ball, own = (5.0 - sqrt(25.0 - 0.8 * 3.5)) / 0.4, sqrt(2.0 * (0.8 - REACH) / 4.0)
    assert spare == pytest.approx(ball - own - (reaction - 0.1))  # the league's delay is in what it sees


def test_mh21_too_late_for_the_nearest_point_it_goes_where_it_is_least_late() -> None:
    near, late = (-4.0, 0.0), (-9.0, -2.2)
    sight = seen(-4.8, 0.7, near, late)
    ux, uy = np.array(late) / hypot(*late)
    places = [interception(sight, K, settings(keeper_waits=waits)) for waits in (False, True)]
    first, then = ((x - near[0]) * ux + (y - near[1]) * uy for x, y in places)
    spare = [spare_time(sight, ux, uy, hypot(*late), along, K, settings()) for along in (first, then)]
    assert spare[0] < 0.0 and then > first and spare[1] > spare[0]


def first_at(sight: np.void, most: float) -> float:
    """Return when [s] a player at rest can first be at the ball that it sees."""
    return float(meeting_time(sight, sight["x"], sight["y"], 0.0, 0.0, most, K))


def test_mh22_a_rolling_ball_is_met_at_the_first_moment_at_which_the_robot_can_be_there() -> None:
    still = seen(-3.0, 0.0, (0.0, 0.0), (0.0, 0.0))
    assert first_at(still, 3.0) == pytest.approx(3.0 / 2.6 + 0.325, abs=STEP)
    for side in (1.0, -1.0):
        sight = seen(-3.0, 0.0, (0.0, side * 2.0), (-1.0, -side * 1.0))
        t = first_at(sight, 5.0)
        rolled = sqrt(2.0) * t - 0.2 * t * t
        away = hypot(3.0 - rolled / sqrt(2.0), 2.0 - rolled / sqrt(2.0))
        assert moving_time(away, 0.0, 0.0, K) == pytest.approx(t, abs=STEP)
    assert first_at(seen(-6.0, 0.0, (0.0, 0.0), (3.0, 0.0)), 2.0) == 2.0  # not in that time


Place = tuple[float, float]


def sight_of(mates: list[Place], opponents: list[Place] = [], ball: Place = (0.0, 0.0)) -> np.void:  # noqa: B006
    """Return what a field player right behind the ball sees, all others at rest."""
    sight = np.zeros(1, SIGHT)[0]
    sight["ball_x"], sight["ball_y"] = ball
    sight["x"], sight["y"], sight["cosine"] = ball[0] - 0.3, ball[1], 1.0
    sight["distance"], sight["touch"] = 0.3, 0.29
    sight["others"] = len(mates) + len(opponents)
    for i, (x, y) in enumerate([*mates, *opponents]):
        sight["other_x"][i], sight["other_y"][i], sight["field"][i] = x, y, 1
        sight["mate"][i] = int(i < len(mates))
    return sight


def passed(sight: np.void, pressed: bool = False, **changes: Any) -> tuple[float, float, float, float]:
    return choose_pass(sight, K, settings(**{"pass_gain": 1.0, **changes}), pressed)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_mh04_a_pass_goes_to_the_mate_that_is_nearest_to_the_goal(side: float) -> None:
    ux, uy, far, worth = passed(sight_of([(4.0, side * 3.0), (3.0, -side * 3.0), (-2.0, 0.0)]))
    assert (ux, uy, far) == (pytest.approx(0.8), pytest.approx(side * 0.6), pytest.approx(5.0)) and worth > 0.0


def test_mh04_nobody_is_passed_to_who_is_marked_behind_an_opponent_near_far_or_behind() -> None:
    mate = (4.0, 3.0)
    assert passed(sight_of([mate], [(4.0, 2.0)]))[3] == -inf  # marked: 1 m is less than pass_free
    assert passed(sight_of([mate], [(2.0, 1.5)]))[3] == -inf  # in the lane
    assert passed(sight_of([mate], [(2.0, 3.5)]))[3] > 0.0  # beside it
    assert passed(sight_of([(1.0, 0.0)]))[3] == passed(sight_of([(5.5, 3.0)]))[3] == -inf
    assert passed(sight_of([(0.5, 3.0)]))[3] == -inf  # no gain
    assert passed(sight_of([(0.5, 3.0)]), pressed=True)[3] == -inf and passed(sight_of([(2.0, 1.5)]), True)[3] > 0.0
    assert passed(sight_of([mate]), passes=False)[3] == -inf


@pytest.mark.parametrize("far", [1.5, 3.0, 6.0])
def test_mh04_a_pass_arrives_at_the_speed_that_is_asked_for(far: float) -> None:
    """Without the way on which it slides: v^2 = a^2 + 2 r s, of the speed that rolls."""
    strength = pass_strength(K, settings(pass_arrival=1.2), far)
    rolls = strength * LEAGUE.kicker.fastest / (1.0 + LEAGUE.ball.shell)
    assert sqrt(rolls**2 - 2.0 * LEAGUE.ball.rolling * far) == pytest.approx(1.2)
    assert pass_strength(K, settings(pass_strength=False), far) == 1.0


def test_mh22_the_player_takes_a_rolling_ball_that_can_be_there_first_not_the_nearest_one() -> None:
    sight = sight_of([(4.0, 0.0)])  # the ball rolls away from me to the mate
    sight["ball_vx"] = 3.0
    play = settings(intercepts=True)
    mine, his = (way_there(sight, K, play, x, 0.0, 0.0, 0.0) for x in (-0.3, 4.0))
    assert his < mine and right_rank(sight, np.zeros(1, MEMORY)[0], K, play) == 1
    assert right_rank(sight, np.zeros(1, MEMORY)[0], K, settings(intercepts=False)) == 0
    sight["ball_vx"] = 0.0
    assert right_rank(sight, np.zeros(1, MEMORY)[0], K, play) == 0


def test_a_supporter_stands_open_ahead_of_the_ball_on_its_side_where_nobody_stands_between() -> None:
    skill = np.zeros(1, MEMORY)[0]["skill"]
    skill["rank"], skill["side"] = 2, 1.0
    assert open_place(sight_of([]), skill, K) == (2.5, 1.5)
    assert open_place(sight_of([], [(1.25, 0.75)]), skill, K) != (2.5, 1.5)
    skill["rank"] = 3
    assert open_place(sight_of([]), skill, K) == (2.5, -1.5)
    assert own_team_is_nearer(sight_of([])) and not own_team_is_nearer(sight_of([(-2.0, 0.0)], [(0.1, 0.0)]))


def passes_by(team: str) -> tuple[float, float]:
    """Return the share of matches in which a still mate aside is passed to by who has the ball, and its top speed."""
    match = Match(MIDDLE, home=3, away=1, matches=12, seed=5, rules="none", senses="ideal",
                  controllers={"home_1": team, "home_2": "still", "away": "still", "home_0": "still"})  # fmt: skip
    match.matches["phase"] = int(Phase.PLAY)
    match.robots["x"][:], match.robots["y"][:] = (-5.5, -2.0, 0.2, 5.5), (0.0, 0.0, 2.2, 3.0)
    match.robots["heading"][:] = 0.0
    match.balls["x"], match.balls["y"] = -1.71, 0.0
    match.rebuild()
    near, top = np.full(12, 9.0), np.zeros(12)
    for _ in range(160):
        match.step()
        mate = match.robots[:, 2]
        near = np.minimum(near, np.hypot(match.balls["x"] - mate["x"], match.balls["y"] - mate["y"]))
        top = np.maximum(top, np.hypot(match.balls["vx"], match.balls["vy"]))
    match.close()
    return float((near < 0.6).mean()), float(top.max())


def test_mh04_who_has_the_ball_passes_with_the_strength_that_a_mate_can_take() -> None:
    share, top = passes_by("heinemann-2006:pass_gain=0.5")
    alone, _ = passes_by("heinemann-2006:passes=False")
    assert share > 0.6 and alone == 0.0
    assert 2.0 < top < 6.0  # not the kicker's 10 m/s
