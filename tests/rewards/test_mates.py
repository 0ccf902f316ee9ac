"""Rewards in which mates matter: covering, not crowding, keeping everybody on the pitch; and what a foul costs."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.rewards import NAMES, PRESETS
from soccer_env.rewards.terms import cover, crowding, foul, guard, nearest_robot_to_ball, shot, strength
from soccer_env.types import AWAY, HOME, Foul, Phase
from tests.scenes.staging import put, put_ball, stage

MATES = ("cover", "crowding", "guard", "strength", "foul")


def scene(places: dict[int, tuple[float, float]], home: int = 3, away: int = 1) -> Match:
    """Return a legged match with the ball at (0.5, 0.2) and these robots; the others are off the pitch."""
    match = stage("legged-2001", home=home, away=away, ball=(0.5, 0.2))
    for r, (x, y) in places.items():
        put(match, r, x, y)
    return match


def phi(function: Any, match: Match, team: int = HOME) -> float:
    records = match.matches[0], match.balls[0], match.robots[0]
    return float(function(*records, match.settings.constants()[0], team))


def test_a_mate_halfway_to_its_goal_covers_best_not_one_at_the_ball_nor_in_its_penalty_area() -> None:
    assert phi(cover, scene({0: (0.3, 0.2), 1: (-0.5, 0.1), 2: (-1.0, -0.5)})) == pytest.approx(0.0)
    beside = scene({0: (0.3, 0.2), 1: (-0.5, 0.5), 2: (-1.4, -0.9)})
    assert phi(cover, beside) == pytest.approx(-0.4 / np.hypot(3.0, 2.0))
    assert phi(cover, scene({0: (-0.5, 0.1)})) == -1.0, "its mates are out"
    assert phi(cover, scene({0: (-0.5, 0.1)}, home=1)) == 0.0, "it has none"
    match = scene({0: (-1.2, -0.6), 1: (-1.3, 0.0), 2: (1.0, 0.8)})
    put_ball(match, -1.3, -0.6)
    league = match.league
    edge = -(league.pitch.length / 2 - league.pitch.penalty_depth - league.body.reach)
    assert edge > -1.4, "halfway to the goal line"
    match.robots["x"][0, 1], match.robots["y"][0, 1] = edge, -0.3
    assert phi(cover, match) == pytest.approx(0.0)


def test_a_goalkeeper_guards_the_angle_that_it_takes_from_a_shot() -> None:
    """In closed form: seen from a ball straight ahead a disc of radius r at distance d hides 2 asin(r / d)."""
    league = find_league("legged-2001")
    reach, half = league.body.reach, 0.5 * league.pitch.goal_width

    def open_angle(out: float, ahead: float = 1.0, aside: float = 0.0) -> float:
        match = scene({0: (out - 1.5, 0.0)})
        put_ball(match, ahead - 1.5, aside)
        return -np.pi * phi(guard, match)

    whole = 2.0 * np.arctan2(half, 1.0)
    assert open_angle(0.2) == pytest.approx(max(whole - 2.0 * np.arcsin(reach / 0.8), 0.0))
    assert open_angle(-reach) == pytest.approx(whole), "it stands in its goal"
    assert open_angle(-0.5 * reach) == pytest.approx(whole - np.arcsin(reach / (1.0 + 0.5 * reach)))
    assert open_angle(1.6) == pytest.approx(whole), "the ball lies between it and its goal"
    from_aside = np.arctan2(half - 0.9, 0.2) - np.arctan2(-half - 0.9, 0.2)
    assert open_angle(0.8, 0.2, 0.9) == pytest.approx(from_aside), "it stands aside of the way"
    assert open_angle(0.2, -0.01) == pytest.approx(np.pi), "it is past the line"
    gone = scene({1: (-1.3, 0.0)})
    assert phi(guard, gone) < phi(guard, scene({0: (-1.3, 0.0)})), "a field player is no goalkeeper"


def test_a_second_robot_at_the_ball_crowds_and_one_far_off_does_not() -> None:
    far = 3.0 * find_league("legged-2001").body.reach
    assert phi(crowding, scene({0: (0.3, 0.2), 1: (0.5 - 1.01 * far, 0.2)})) == 0.0
    assert phi(crowding, scene({0: (0.3, 0.2), 1: (0.5, 0.2 - 0.5 * far)})) == pytest.approx(-0.5)
    assert phi(crowding, scene({0: (0.3, 0.2)})) == 0.0
    assert phi(crowding, scene({0: (0.3, 0.2), 3: (0.5, 0.4)})) == 0.0, "an opponent is no mate"
    nobody = scene({})
    assert nearest_robot_to_ball(nobody.balls[0], nobody.robots[0], HOME) == -1 and phi(crowding, nobody) == 0.0


def test_strength_counts_those_who_serve_a_penalty_and_who_is_whistled_pays_alone() -> None:
    match = scene({0: (0.0, 0.0)})
    assert phi(strength, match) == 0.0
    match.robots["penalty"][0, 1] = 30.0
    match.robots["banned"][0, 2] = 1
    assert phi(strength, match) == pytest.approx(-2.0 / 3.0) and phi(strength, match, AWAY) == 0.0
    match = scene({0: (0.0, 0.0), 1: (-1.0, 0.0)})
    match.robot_events["foul"][0, 1] = Foul.PUSHING
    records = match.matches[0], match.balls[0], match.robots[0], match.events[0], match.robot_events[0]
    paid = [foul(*records, match.settings.constants()[0], r, 0.3) for r in range(3)]
    assert paid == [0.0, 0.3, 0.0]


@pytest.mark.parametrize(
    ("aside", "speed", "paid"), [(0.0, 1.0, 0.4), (0.9, 1.0, 0.0), (0.0, 0.05, 0.0), (0.0, -1.0, 0.0)]
)
@pytest.mark.parametrize("side", [HOME, AWAY])
def test_a_kick_between_the_posts_is_a_shot(side: int, aside: float, speed: float, paid: float) -> None:
    match = scene({0: (0.0, 0.0)}, home=1)
    put_ball(match, 0.0, aside)
    match.balls["vx"], match.balls["roll_x"] = (speed if side == HOME else -speed,) * 2
    match.robot_events["kick"][0, side] = 1
    records = match.matches[0], match.balls[0], match.robots[0], match.events[0], match.robot_events[0]
    constants = match.settings.constants()[0]
    assert [shot(*records, constants, r, 0.4) for r in (side, 1 - side)] == [paid, 0.0], "whose kick it was"
    match.events["restart"] = Phase.KICK_OFF
    assert shot(*records, constants, side, 0.4) == 0.0, "the ball lies there again"


def test_they_weigh_in_training_alone() -> None:
    assert all(getattr(PRESETS["default"], name) == 0.0 < getattr(PRESETS["training"], name) for name in MATES)
    assert set(MATES) <= set(NAMES)
