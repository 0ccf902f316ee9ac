"""Who is passed to, how hard, and who takes a ball that rolls."""

from math import inf, sqrt
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.heinemann_2006.memory import MEMORY
from soccer_env.baselines.heinemann_2006.passing import choose_pass, open_place, own_ball, pass_strength
from soccer_env.baselines.heinemann_2006.roles import right_rank, way_there
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills.sight import SIGHT
from soccer_env.types import Phase
from tests.baselines.heinemann_2006.test_goalkeeper import settings
from tests.scenes.staging import MIDDLE

LEAGUE = find_league(MIDDLE)
K = constants_of(LEAGUE)[0]
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
    found: tuple[float, float, float, float] = choose_pass(sight, K, settings(**{"pass_gain": 1.0, **changes}), pressed)
    return found


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
    assert own_ball(sight_of([])) and not own_ball(sight_of([(-2.0, 0.0)], [(0.1, 0.0)]))


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
