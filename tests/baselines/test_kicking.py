"""Players kick past what stands ahead and clear the ball when they are pressed, but not towards their own goal."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills.kicking import (
    FOILED,
    aim_kick,
    choose_kick_side,
    is_blocked_ahead,
    is_foiled,
    shot_side,
    time_kick,
    wants_to_clear,
)
from soccer_env.skills.sight import SIGHT
from soccer_env.teams import make_team
from soccer_env.types import COMMAND
from tests.scenes.staging import LEGGED, MIDDLE, place, record_each_step, stage

K = {name: constants_of(find_league(name))[0] for name in (LEGGED, MIDDLE)}
PLAY = {name: make_team("chaser").settings[kind] for kind, name in enumerate((LEGGED, MIDDLE))}


def sight_at(league: str, x: float, y: float, heading: float, *opponents: tuple[float, float]) -> np.record:
    """Return the sight of a player at x, y [m] with the ball at its front, and opponents at places [m]."""
    sight, k = np.zeros(1, SIGHT)[0], K[league]
    touch = k["body_front"] + k["ball_radius"]
    sight["x"], sight["y"], sight["heading"], sight["touch"] = x, y, heading, touch
    sight["cosine"] = sight["now_cosine"] = np.cos(heading)
    sight["sine"] = sight["now_sine"] = np.sin(heading)
    sight["ball_x"], sight["ball_y"] = x + touch * np.cos(heading), y + touch * np.sin(heading)
    sight["now_ahead"], sight["held"], sight["others"] = touch, 1, len(opponents)
    for i, (other_x, other_y) in enumerate(opponents):
        sight["other_x"][i], sight["other_y"][i] = other_x, other_y
    return sight


@pytest.mark.parametrize(("x", "y", "heading", "opponents", "blocked"), [
    (0.0, 0.0, 0.0, (), False), (0.0, 0.0, 0.0, ((0.4, 0.0),), True), (0.0, 0.0, 0.0, ((0.4, 0.3),), False),
    (0.0, 0.0, 0.0, ((-0.4, 0.0),), False), (0.0, 0.6, 0.5 * np.pi, ((0.4, 0.6),), True),
    (0.0, 0.6, 0.5 * np.pi, (), False), (0.0, 0.6, 0.0, (), False),
])  # fmt: skip
def test_an_opponent_right_ahead_blocks_a_kick_and_a_board_if_somebody_presses(x, y, heading, opponents, blocked):
    assert is_blocked_ahead(sight_at(LEGGED, x, y, heading, *opponents), K[LEGGED]) == blocked


@pytest.mark.parametrize(("x", "y", "heading", "opponents", "side"), [
    (0.3, 0.7, 0.25 * np.pi, (), -1.0),  # at the left board: the right kick leads along it
    (0.3, -0.7, -0.25 * np.pi, (), 1.0),
    (0.3, 0.7, 0.5 * np.pi, (), 0.0),  # square to it, both kicks meet it
    (0.0, 0.0, 0.0, ((0.4, 0.0), (0.45, 0.35)), -1.0),  # the left is covered
    (0.0, 0.0, 0.0, ((0.45, 0.35), (0.45, -0.35)), 0.0),
    (-0.8, 0.3, -2.3, (), 1.0),  # the right kick would go at the own goal
])  # fmt: skip
def test_the_kick_aside_goes_where_it_is_free_ahead_rather_than_back_and_never_at_the_own_goal(
    x, y, heading, opponents, side
):
    assert choose_kick_side(sight_at(LEGGED, x, y, heading, *opponents), K[LEGGED]) == side


def test_a_ball_that_still_lies_at_the_feet_after_a_kick_says_that_the_kick_was_foiled():
    sight, memory, k = sight_at(LEGGED, 0.0, 0.0, 0.0), np.zeros(1, make_team("chaser").memory_dtype)[0], K[LEGGED]
    sight["elapsed"], memory["kick"] = k["dt"], 1.0
    steps = int((k["kicker_wind_up"] + FOILED) / k["dt"])
    assert not any(foiled_after(n, sight, memory) for n in (0, *[1] * (steps - 1)))
    assert foiled_after(2, sight, memory) and foiled_after(0, sight, memory)  # asking changes nothing
    sight["held"] = 0
    assert not foiled_after(2 * steps, sight, memory) and memory["kicking"] == 0.0


def foiled_after(decisions: int, sight: np.record, memory: np.record) -> bool:
    """Tell whether a kick counts as foiled after further decisions with the same sight."""
    for _ in range(decisions):
        time_kick(sight, memory)
    return bool(is_foiled(sight, memory, K[LEGGED]))


@pytest.mark.parametrize(("x", "y", "heading", "opponents", "held", "side"), [
    (0.9, 0.0, -0.87, (), 1, 1.0), (0.9, 0.0, 0.87, (), 1, -1.0),  # 50 degrees aside of the heading lies the goal
    (0.9, 0.0, -0.87, (), 0, 0.0), (-0.9, 0.0, -0.87, (), 1, 0.0),  # it must hold the ball, near the goal
    (0.9, 0.0, -0.87, ((1.3, 0.0),), 1, 0.0),  # a keeper is in the way
    (0.9, 0.0, 3.1, (), 1, 0.0),
])  # fmt: skip
def test_a_player_beside_whose_heading_the_goal_lies_open_shoots_with_one_foreleg(x, y, heading, opponents, held, side):
    sight = sight_at(LEGGED, x, y, heading, *opponents)
    sight["held"] = held
    assert shot_side(sight, K[LEGGED], PLAY[LEGGED]) == side


@pytest.mark.parametrize(("kick", "side", "head", "pan"), [
    (1.0, 1.0, 1.0, 50.0), (1.0, -1.0, 1.0, -50.0), (0.0, 1.0, -1.0, 0.0), (1.0, 0.0, -1.0, 0.0),
])  # fmt: skip
def test_the_head_turns_to_the_side_of_the_kick(kick, side, head, pan):
    command = np.zeros(1, COMMAND)[0]
    command["kick"], command["head"] = kick, -1.0
    aim_kick(command, K[LEGGED], side)
    assert command["head"] == head and command["pan"] * K[LEGGED]["head_pan_limit"] == pytest.approx(np.radians(pan))


def test_a_head_that_looks_round_is_brought_ahead_for_a_kick_ahead():
    command = np.zeros(1, COMMAND)[0]
    command["kick"], command["head"], command["pan"] = 1.0, 1.0, -0.9
    aim_kick(command, K[LEGGED], 0.0)
    assert abs(command["pan"]) * K[LEGGED]["head_pan_limit"] < 0.5 * K[LEGGED]["kicker_aside"]


@pytest.mark.parametrize(("x", "heading", "opponents", "clears"), [
    (-3.0, 0.3, ((-2.9, 0.55),), True), (-3.0, 0.3, (), False), (3.0, 0.3, ((3.1, 0.55),), False),
    (-3.0, np.pi, ((-3.1, 0.5),), False), (-3.0, 0.0, ((-2.9, 0.55), (-1.6, 0.0)), False),
])  # fmt: skip
def test_a_player_on_wheels_clears_when_pressed_in_its_own_half_with_a_free_way_upfield(x, heading, opponents, clears):
    assert wants_to_clear(sight_at(MIDDLE, x, 0.0, heading, *opponents), K[MIDDLE], PLAY[MIDDLE]) == clears


def distance_off_board(team: str) -> float:
    """Return how far from the board [m] the ball gets in 20 s, in the mean; a robot has it there, 45 degrees off."""
    match = stage(LEGGED, 32, seed=5, senses="ideal", controllers={"home": team, "away": "still"})
    touch = match.league.body.front + match.league.ball.radius
    x, y = 0.3, 0.87
    place(match, ball=(x, y), robots={0: (x - touch * np.sqrt(0.5), y - touch * np.sqrt(0.5), 0.25 * np.pi)})
    match.robots["keeper"][:, 0] = 0
    return float((1.0 - np.abs(record_each_step(match, lambda: match.balls["y"], 20.0)).min(axis=0)).mean())


def test_a_player_brings_a_ball_off_the_board_that_it_faces():
    assert distance_off_board("chaser") > 0.25
