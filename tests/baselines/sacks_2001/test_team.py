"""What the players of sacks-2001 do with the ball and without it, and what the team was before, as switches."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.sacks_2001.actuators import SWEEP, SWEEP_SHARE, look_around
from soccer_env.baselines.sacks_2001.ball_notes import AFTER_KICK
from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, DRIBBLE, MEMORY, ORBIT, PASS, SEARCH, SHOOT
from soccer_env.leagues.constants import constants_of
from soccer_env.types import COMMAND
from tests.scenes.sacks_mind import FORWARD, KICK, LEAGUE, LEFT, TURN, Mind
from tests.scenes.staging import play

TOUCH = LEAGUE.body.front + LEAGUE.ball.radius  # [m] from a robot's middle to a ball between its paws
OLD = {"avoidance": False}  # orbit and shoot


def believe_player(mind: Mind, slot: int, x: float, y: float, teammate: int = 0) -> None:
    """Let a player be remembered there [m], robot frame."""
    track = mind.tracks[0, 0, slot]
    track["present"], track["teammate"], track["number"], track["age"] = 1, teammate, -1, 0.0
    track["x"], track["y"] = x, y
    track["distance"], track["bearing"] = np.hypot(x, y), np.arctan2(y, x)


def holding(heading: float, x: float = 0.3, **settings: Any) -> Mind:
    """Return a mind that has the ball between its paws, turned by `heading` [rad] off the goal."""
    mind = Mind(**settings)
    mind.stand_at(x, 0.0, heading)
    mind.see_ball(TOUCH, held=1)
    return mind


def test_ms26_it_goes_to_the_ball_orbits_it_to_face_the_goal_and_shoots() -> None:
    mind = Mind(**OLD)
    mind.stand_at(-0.5, 0.0)
    mind.see_ball(0.8, 0.2)
    command = mind.think()[-1]
    assert mind.memory["behaviour"] == APPROACH and command[FORWARD] > 0.8 and command[TURN] > 0.0 == command[KICK]
    mind.stand_at(0.3, 0.0, np.pi / 2)
    mind.see_ball(TOUCH, held=1)
    command = mind.think()[-1]
    assert mind.memory["behaviour"] == ORBIT
    assert command[TURN] < 0.0 < command[LEFT] and command[KICK] == 0.0  # round the ball, the goal lies to the right
    mind.stand_at(-0.9, 0.0, 0.05)  # from anywhere, whoever stands in the way
    believe_player(mind, 2, 0.9, 0.05)
    command = mind.think()[-1]
    assert mind.memory["behaviour"] == SHOOT and command[KICK] == 1.0


def test_ms26_it_dribbles_round_who_is_in_the_way_and_shoots_where_nobody_is() -> None:
    """Somebody 95 cm before its camera, or straight behind, repels; beyond a metre and behind nobody does."""
    for x, expected in ((0.142 + 0.95 + 0.105, DRIBBLE), (0.142 + 1.01 + 0.105, SHOOT), (-0.5, SHOOT)):
        mind = holding(0.0, -0.9)
        believe_player(mind, 2, x, 0.0)
        assert mind.does() == expected
    for heading, expected in ((0.5, ORBIT), (0.2, SHOOT)):  # it faces the goal first
        mind = holding(heading, -0.5)
        assert mind.does() == expected


@pytest.mark.parametrize("heading", [0.0, 0.5])
def test_ms26_a_team_that_shoots_not_at_all_dribbles_to_the_goal(heading: float) -> None:
    mind = holding(heading, shoots=False)
    assert mind.think(1.0)[:, KICK].max() == 0.0 and mind.memory["behaviour"] == DRIBBLE


@pytest.mark.parametrize(("heading", "x", "kicks"), [(0.9, 0.3, False), (0.0, -1.0, False), (0.0, 0.3, True)])
def test_ms26_who_chooses_shots_does_not_shoot_while_it_faces_away_from_the_goal_or_is_far_from_it(heading, x, kicks):
    mind = holding(heading, x, choose_shots=True)
    assert (mind.think(0.0 if kicks else 1.0)[:, KICK].max() == 1.0) == (mind.memory["behaviour"] == SHOOT) == kicks


def test_ms26_a_kick_that_the_leg_winds_up_for_is_seen_through() -> None:
    """It cannot be called back: though the goal closes meanwhile, the player knows afterwards that it has kicked."""
    mind = holding(0.0)
    assert mind.does() == SHOOT
    mind.stand_at(0.3, 0.0, 0.9)
    assert (mind.think(LEAGUE.kicker.wind_up)[:, KICK] == 1.0).all()
    mind.see_ball(0.6)
    assert mind.does(0.3) == APPROACH and mind.memory["kicked"] > 0.0


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_search_begins_on_the_side_where_the_ball_was_last(side: float) -> None:
    mind = Mind()
    mind.see_ball(0.8, side)
    mind.think()
    mind.memory["side"] = -side  # of an orbit before
    mind.belief["ball"]["age"] = 3.0
    command = mind.think(3.0)[-1]
    assert mind.memory["behaviour"] == SEARCH and command[TURN] * side > 0.0


def blocked(**settings: Any) -> Mind:
    """Return a mind 0.9 m before the ball, an opponent a little to the left of the way to it."""
    mind = Mind(**settings)
    mind.stand_at(-0.5, 0.0)
    mind.see_ball(0.9)
    believe_player(mind, 2, 0.5, 0.05)
    return mind


def test_ms27_others_are_avoided_with_the_ball_alone() -> None:
    chaser = blocked()
    command = chaser.think()[-1]
    assert chaser.memory["behaviour"] == APPROACH and command[LEFT] == 0.0 and command[FORWARD] > 0.9
    dribbler = blocked()
    dribbler.see_ball(TOUCH, held=1)
    command = dribbler.think()[-1]
    assert dribbler.memory["behaviour"] == DRIBBLE and command[LEFT] < -0.1
    assert blocked(avoid_chasing=True).think()[-1, LEFT] < -0.1


def test_ms27_a_ball_that_was_between_the_paws_counts_as_there_for_a_while() -> None:
    mind = holding(0.0, -1.2, glance_time=0.0, shoots=False)
    assert mind.does() == DRIBBLE
    mind.see_ball(0.6)
    assert mind.does(0.5) == DRIBBLE
    assert mind.does(2.0) == APPROACH


@pytest.mark.parametrize("avoidance", [True, False])
def test_ms52_without_avoidance_the_ball_is_orbited_instead_of_dribbled(avoidance: bool) -> None:
    mind = holding(0.7, -0.5, avoidance=avoidance)
    believe_player(mind, 2, 0.6, 0.1)
    assert mind.does() == (DRIBBLE if avoidance else ORBIT)


@pytest.mark.parametrize("two", [True, False])
def test_ms52_with_one_counter_a_robot_near_the_ball_thinks_itself_stuck(two: bool) -> None:
    mind = Mind(two_counters=two)
    mind.see_ball(0.3)
    assert mind.does(4.0) == (APPROACH if two else BACK)


@pytest.mark.parametrize("clamp", [True, False])
def test_ms52_without_the_clamp_a_player_ahead_pushes_the_robot_back(clamp: bool) -> None:
    mind = holding(0.0, -0.5, clamp=clamp, body_clamp=clamp, contested_range=0.0)
    believe_player(mind, 2, 0.25, 0.0)
    command = mind.think()[-1]
    assert mind.memory["behaviour"] == DRIBBLE and (command[FORWARD] > 0.0 if clamp else command[FORWARD] < 0.0)


def played(memory: dict[str, Any]) -> np.ndarray:
    """Return where everybody is after a while of play by sensors with a memory (M, R)."""
    teams = {"home": "sacks-2001", "away": "sacks-2001"}
    match = Match("legged-2001", matches=4, seed=3, controllers=teams, memory=memory)
    play(match, steps=20 * LEAGUE.control_rate)
    return match.robots["x"].copy()  # type: ignore[no-any-return]


@pytest.mark.slow
@pytest.mark.parametrize("memory", [{"odometry": "rotation"}, {"slots": "nearest"}, {"ball_range": "infrared"}])
def test_ms52_what_robots_knew_before_is_a_switch_that_changes_play(memory: dict[str, Any]) -> None:
    assert (played({}) != played(memory)).any(axis=1).mean() > 0.5


def supporting(ball: tuple[float, float], x: float, y: float) -> Mind:
    """Return a mind that stands somewhere [m], team frame, faces the ball and hears that a mate attacks."""
    mind = Mind(keeps_out=False)
    ahead = np.array(ball) - (x, y)
    mind.stand_at(x, y, np.arctan2(ahead[1], ahead[0]))
    mind.see_ball(np.hypot(*ahead))
    mind.belief["heard"]["distance"], mind.belief["heard"]["age"] = 0.05, 0.0
    mind.belief["situation"]["number"], mind.belief["situation"]["teammates"] = 2, 1
    mind.think(1.5)
    return mind


@pytest.mark.parametrize(("ball", "place"), [
    ((0.0, -0.4), (-0.8, 0.05)),  # 0.8 m behind the ball, 0.45 m aside of it towards the middle
    ((0.5, 0.9), (-0.3, 0.45)),
    ((-1.2, 0.3), (-1.5 + 3.0 * LEAGUE.body.reach, -0.15)),  # off the goal line
    ((0.0, 0.15), (-0.8, -0.3)), ((0.5, 1.5), (-0.3, 1.0 - LEAGUE.body.reach)),
    ((0.5, -1.5), (-0.3, -1.0 + LEAGUE.body.reach)),  # of a ball that is believed outside, not beyond the board
])  # fmt: skip
def test_a_supporter_stands_behind_the_ball_and_aside_of_it_and_off_lines_and_boards(ball, place) -> None:
    for dx, dy in [(0.0, 0.0), (0.2, 0.0), (0.0, 0.2), (-0.15, 0.0), (0.0, -0.15)]:
        mind = supporting(ball, place[0] + dx, place[1] + dy)
        walk = mind.think()[-1][[FORWARD, LEFT]]
        if dx == dy == 0.0:
            assert np.abs(walk).max() < 0.05
        else:
            heading = mind.belief["own"]["heading"]
            across = walk[0] * np.array([np.cos(heading), np.sin(heading)])
            across += walk[1] * np.array([-np.sin(heading), np.cos(heading)])
            assert across @ (dx, dy) / np.hypot(dx, dy) < -0.2, (dx, dy)


def before_a_wall(**settings: Any) -> Mind:
    """Return a mind that has the ball, three opponents before the goal, a team-mate on the left."""
    mind = holding(0.0, 0.4, **settings)
    for slot, y in ((2, 0.13), (3, -0.13), (4, 0.0)):
        believe_player(mind, slot, 0.55, y)
    believe_player(mind, 0, 0.4, 0.55, teammate=1)
    return mind


def turn_to_mate(mind: Mind) -> None:
    """Let the body turn towards the team-mate: it sees the same players elsewhere."""
    mind.stand_at(0.4, 0.0, 0.9)
    for slot in range(5):
        seen = complex(mind.tracks[0, 0, slot]["x"], mind.tracks[0, 0, slot]["y"]) * np.exp(-0.9j)
        believe_player(mind, slot, seen.real, seen.imag, teammate=int(slot < 2))
    mind.tracks[0, 0, 1]["present"] = 0


def test_ms26_a_ball_that_still_lies_there_after_a_kick_foils_the_next_shots() -> None:
    mind = holding(0.0)
    mind.memory["kicked"] = 0.5 * AFTER_KICK
    mind.think()
    assert mind.memory["foiled"] == pytest.approx(float(mind.team.settings["foiled_time"][0]))  # type: ignore[attr-defined]
    mind.memory["kicked"], mind.memory["foiled"] = AFTER_KICK, 0.0  # it has only just kicked
    mind.think()
    assert mind.memory["foiled"] == 0.0


@pytest.mark.parametrize("passes", [True, False])
def test_ms53_a_remembered_team_mate_is_passed_to_when_the_goal_is_blocked(passes: bool) -> None:
    """Not where a kick was stopped at once; the pass stays soft while the leg winds up for it."""
    mind, foiled = before_a_wall(passes=passes), before_a_wall(passes=True)
    mind.think()
    assert (mind.memory["behaviour"] == PASS) == passes
    turn_to_mate(mind)
    assert (mind.think()[-1, KICK] > 0.0) == passes
    foiled.memory["foiled"] = 1.0
    assert foiled.does(0.5) == DRIBBLE
    assert foiled.does(1.0) == PASS
    turn_to_mate(foiled)
    kicks = foiled.think(LEAGUE.kicker.wind_up)[:, KICK]
    assert (kicks == LEAGUE.kicker.least).all(), "a mate at half a metre gets the softest kick that there is"


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_head_sweeps_four_fifths_of_its_pan_to_both_sides_first_to_the_balls(side: float) -> None:
    k = constants_of(LEAGUE)[0]
    command, memory, pans = np.zeros(1, COMMAND)[0], np.zeros(1, MEMORY)[0], []
    for _ in range(int(2.0 * SWEEP / 0.01)):
        look_around(command, memory, k, side * 0.4, 0.01)
        pans.append(float(command["pan"]))
    assert min(pans) == pytest.approx(-SWEEP_SHARE, abs=0.02) and max(pans) == pytest.approx(SWEEP_SHARE, abs=0.02)
    quarter = len(pans) // 4
    assert side * (pans[quarter] - pans[0]) > 0.5 * SWEEP_SHARE  # it goes to the ball's side first
