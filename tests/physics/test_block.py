"""A goalkeeper's block: when it begins, how long it takes, what its spread legs stop, and that only goalkeepers can."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env.leagues import Block, find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.physics.block import foreleg_spread, most_reach
from soccer_env.physics.contacts import TOUCH_GAP, ball_gap, paws_gap
from soccer_env.physics.solver.posts import nearest_between_segments
from soccer_env.render.robots import figures_of
from tests.scenes.staging import (
    LEGGED,
    endless,
    energy,
    place,
    play,
    put_ball,
    robot_actions,
    stage,
    stand,
    steady,
    steps_in,
)
from tests.scenes.symmetry import MIRROR, Records, assert_same_records, mirrored

LEAGUE = endless(steady("legged-2001-block"))
BLOCK, BODY, BALL = LEAGUE.block, LEAGUE.body, LEAGUE.ball
OUTSIDE = BLOCK.paw_y + BODY.tip_radius + BALL.radius  # [m] aside, where a ball just passes a spread paw
UP = 9  # control steps until the legs are spread: one to begin, 7.7 of them at the joints' speed


def keeper(matches=1, league=LEAGUE, **settings):
    """Return matches with home's goalkeeper at the origin, looking along x, the ball far off."""
    match = stage(league, matches, **settings)
    match.robots["keeper"][:, 0] = 1
    place(match, ball=(5.0, 0.0), robots={0: (0.0, 0.0, 0.0)})
    return match


def spread(match):
    """Return how far each goalkeeper's forelegs are spread (M,)."""
    k = constants_of(match.league)[0]
    return np.array([foreleg_spread(robot, k, 0.0) for robot in match.robots[:, 0]])


def rolled(offsets, v=1.0, blocks=True, **settings):
    """Return matches in which a ball has rolled at a goalkeeper at several places aside of it, legs spread or not."""
    offsets = np.asarray(offsets)
    match = keeper(len(offsets), **settings)
    play(match, actions=robot_actions(match, kick=1.0 if blocks else 0.0), steps=UP)
    place(match, ball=(0.4, offsets, -v, 0.0))
    play(match, 0.4)
    return match


def test_ms53_a_block_takes_the_time_of_its_joints_and_stands_for_as_long_as_the_league_says():
    """MS53: out at a constant speed, held, and in again; what is asked for meanwhile changes nothing."""
    match, found = keeper(), []
    for step in range(30):
        match.step(robot_actions(match, kick=1.0 if step == 0 else 0.0, forward=1.0))
        found.append(spread(match)[0])
    t = np.arange(30) * LEAGUE.dt
    end = BLOCK.raise_time + BLOCK.hold_time + BLOCK.recover_time
    expected = np.clip(np.minimum(t / BLOCK.raise_time, (end - t) / BLOCK.recover_time), 0.0, 1.0)
    assert found == pytest.approx(expected, abs=1e-9) and max(found) == 1.0 and found[-1] == 0.0


def test_while_it_blocks_a_robot_stands_still_and_in_a_league_without_a_block_nothing_happens():
    match = keeper()
    for _ in range(steps_in(match, 1.3)):
        match.step(robot_actions(match, kick=1.0, forward=1.0, left=0.5))
        assert match.robots["walk"][0, 0].tolist() == (0.0, 0.0, 0.0)
    assert np.hypot(match.robots["x"][0, 0], match.robots["y"][0, 0]) < 1e-9
    play(match, 2.0, robot_actions(match, forward=1.0))
    assert match.robots["x"][0, 0] > 0.05
    match = keeper(league=steady(LEGGED))
    match.step(robot_actions(match, kick=1.0))
    assert match.robots["kick_clock"][0, 0] == 0.0 and most_reach(constants_of(match.league)[0]) == BODY.reach


def test_ms53_only_a_goalkeeper_blocks_and_only_a_ball_out_of_its_kickers_reach():
    match = keeper(3)
    match.robots["keeper"][1, 0] = 0
    put_ball(match, 5.0 * np.ones(3), 0.0)
    match.balls["x"][2] = BODY.front + BALL.radius + 0.003
    match.robots["has_ball"][2, 0] = 1
    match.rebuild()
    play(match, actions=robot_actions(match, kick=1.0), steps=UP)
    assert spread(match).tolist() == [1.0, 0.0, 0.0]
    assert match.robots["kick_strength"][:, 0].tolist() == [0.0, 0.0, 1.0]


def test_ms53_spread_legs_stop_a_ball_as_far_aside_as_they_reach_and_none_a_centimetre_farther():
    inside = np.linspace(0.0, OUTSIDE - 0.01, 20)
    for side in (1.0, -1.0):
        assert (rolled(side * inside).balls["x"] > 0.0).all(), "between trunk and paw there is a leg"
        assert (rolled([side * (OUTSIDE + 0.01)]).balls["x"] < BLOCK.paw_x).all()
    passes = rolled([OUTSIDE + 0.01])
    assert passes.balls["vy"][0] == 0.0 and passes.robots["y"][0, 0] == 0.0


def test_legs_that_spread_push_a_ball_that_lies_beside_them_away_and_without_a_block_balls_pass():
    aside = np.linspace(BODY.tip_y + BODY.tip_radius + BALL.radius + 0.01, OUTSIDE, 5)
    assert (rolled(aside, blocks=False).balls["vx"] < -0.3).all()
    assert (rolled(aside, blocks=False).balls["vy"] == 0.0).all()
    match = keeper()
    place(match, ball=(BODY.tip_x, BODY.tip_y + BODY.tip_radius + BALL.radius + 0.01))
    play(match, actions=robot_actions(match, kick=1.0), steps=UP + 2)
    k = constants_of(LEAGUE)[0]
    assert match.balls["y"][0] > OUTSIDE - 0.002
    assert paws_gap(match.robots[0, 0], k, match.balls["x"][0], match.balls["y"][0], 1.0) > -0.002
    assert match.matches["last_touch_robot"][0] == 0 and energy(match)[0] < 0.5 * BALL.mass * 0.5**2


@pytest.mark.parametrize("share", [0.5, 0.7, 0.9])
def test_a_ball_bounces_off_a_leg_as_off_a_slanting_wall(share):
    """A leg is a straight line from shoulder to paw: a ball leaves it by the law of reflection."""
    along = np.array([BLOCK.paw_x - BLOCK.shoulder_x, BLOCK.paw_y - BLOCK.shoulder_y])
    nx, ny = np.array([along[1], -along[0]]) / np.hypot(*along)
    aside = BLOCK.shoulder_y + share * along[1] + ny * (BODY.tip_radius + BALL.radius)
    league = replace(LEAGUE, body=replace(BODY, mass=1e6), ball=replace(BALL, rolling=0.0, sliding=1e-9))
    pair = replace(league.materials.ball_robot, friction=0.0)
    league = replace(league, materials=replace(league.materials, ball_robot=pair))
    match = keeper(league=league)
    play(match, actions=robot_actions(match, kick=1.0), steps=UP)
    place(match, ball=(0.4, aside, -1.0, 0.0))
    play(match, steps=6)
    bounce = (1.0 + pair.elasticity) * nx
    assert match.balls["vx"][0] == pytest.approx(-1.0 + bounce * nx, abs=1e-3)
    assert match.balls["vy"][0] == pytest.approx(bounce * ny, abs=1e-3)


def test_ms53_a_blocked_ball_is_touched_and_lies_off_the_leg():
    match = keeper()
    play(match, actions=robot_actions(match, kick=1.0), steps=UP)
    robot, k = match.robots[0, 0], constants_of(LEAGUE)[0]
    for gap in (paws_gap(robot, k, BLOCK.paw_x, OUTSIDE, 1.0), ball_gap(robot, k, BLOCK.paw_x, -OUTSIDE)):
        assert gap == pytest.approx(0.0, abs=1e-12)
    middle = 0.5 * (BLOCK.paw_x + BLOCK.shoulder_x), 0.5 * (BLOCK.paw_y + BLOCK.shoulder_y)
    assert paws_gap(robot, k, *middle, 1.0) == pytest.approx(-BODY.tip_radius - BALL.radius)
    assert paws_gap(robot, k, BODY.tip_x + 0.02, 0.09, 1.0) > TOUCH_GAP - BALL.radius
    assert most_reach(k) == pytest.approx(np.hypot(BLOCK.paw_x, BLOCK.paw_y) + BODY.tip_radius)
    touched = rolled([OUTSIDE - 0.01, OUTSIDE + 0.01])
    assert touched.matches["last_touch_robot"].tolist() == [0, -1]


def test_a_robot_that_walks_into_a_spread_leg_is_held_up_by_it_and_turns_the_goalkeeper():
    """One that would walk past beside the goalkeeper; the other match shows it without the block.

    Its thrust at a leg so far aside turns the goalkeeper, whose paws give way.
    """
    match = stage(LEAGUE, 2, ball=(5.0, 0.0), robots={0: (0.0, 0.0, 0.0), 1: (0.26, 0.2, np.pi)})
    match.robots["keeper"][:, 0] = 1
    match.rebuild()
    for _ in range(steps_in(match, 1.0)):
        actions = robot_actions(match, r=1, forward=1.0)
        actions[0, 0, 3] = 1.0
        match.step(actions)
    assert match.robot_events["collision"].tolist() == [[1, 1], [0, 0]]
    (held, free), (turned, alone) = match.robots["x"][:, 1], match.robots["heading"][:, 0]
    assert held > free + 0.005 and free == pytest.approx(0.26 - 0.034, abs=0.002)
    assert turned > 0.1 and alone == 0.0


def test_ms53_a_mirrored_block_is_the_mirror_of_a_block():
    one, other = keeper(), keeper()
    for match in (one, other):
        place(match, ball=(0.45, 0.2, -0.5, 0.0), robots={1: (0.5, 0.14, np.pi)})
    mirrored(Records.of(one)).put_into(other)
    for step in range(40):
        actions = robot_actions(one, kick=float(step == 2), left=0.3)
        actions[:, 1, 0] = 1.0
        one.step(actions)
        actions[..., 1:3] *= -1.0
        other.step(actions)
    assert one.robots["kick_clock"][0, 0] == other.robots["kick_clock"][0, 0]
    assert_same_records(mirrored(Records.of(one)), Records.of(other), MIRROR)


def test_both_backends_block_to_the_bit_and_a_block_is_saved_with_the_match_and_shown():
    found = [rolled(np.linspace(-0.25, 0.25, 11), backend=backend) for backend in ("c", "batch")]
    assert found[0].state_hash() == found[1].state_hash()
    match = keeper()
    play(match, actions=robot_actions(match, kick=1.0), steps=6)
    saved = match.save()
    assert 0.0 < spread(match)[0] < 1.0
    paws = figures_of(match.robots[0], match.league, 1.0)[0].paws
    assert paws[0][1] == pytest.approx(spread(match)[0] * (BLOCK.paw_y - BODY.tip_y)) and paws[1][1] == -paws[0][1]
    match.step(stand(match))
    after = match.state_hash()
    match.load(saved)
    match.step(stand(match))
    assert match.state_hash() == after


@pytest.mark.parametrize(("a", "b", "c", "d", "at", "away"), [
    ((0.0, 0.0), (2.0, 0.0), (1.0, 1.0), (1.0, 3.0), (1.0, 0.0), (0.0, 1.0)),
    ((0.0, 0.0), (2.0, 0.0), (3.0, 0.0), (4.0, 5.0), (2.0, 0.0), (1.0, 0.0)),
    ((0.0, 0.0), (0.0, 0.0), (-1.0, 2.0), (1.0, 2.0), (0.0, 0.0), (0.0, 2.0)),
    ((0.0, 0.0), (2.0, 0.0), (1.0, 5.0), (1.0, 2.0), (1.0, 0.0), (0.0, 2.0)),
    ((1.0, 5.0), (1.0, 2.0), (0.0, 0.0), (2.0, 0.0), (1.0, 2.0), (0.0, -2.0)),
])  # fmt: skip
def test_two_lines_are_nearest_where_geometry_says(a, b, c, d, at, away):
    assert nearest_between_segments(*a, *b, *c, *d) == pytest.approx((*at, *away))


def test_a_block_needs_legs_a_way_back_and_a_reach():
    with pytest.raises(ValueError, match="Block needs a recover_time above zero and a paw_y above shoulder_y"):
        Block(raise_time=0.5, paw_y=0.2)
    with pytest.raises(ValueError, match="Block needs a recover_time"):
        replace(BLOCK, paw_y=0.05)
    with pytest.raises(ValueError, match=r"Block\.raise_time must be 0 for a body without legs"):
        replace(find_league("legged-2001-smooth"), block=BLOCK)
