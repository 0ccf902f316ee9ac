"""Left and right are equal, and so are home and away, in whole steps until the first contact and in whole matches.

Left-right to 1e-12 with noise draws mirrored too, under a half-turn with the teams swapped to 1e-9.
"""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.types import AWAY, HOME, Phase
from tests.scenes import staging
from tests.scenes.staging import MIDDLE, each_league, put_ball, scatter, set_phase, stand, steps_in
from tests.scenes.symmetry import (
    HALF_TURN,
    MIRROR,
    Records,
    assert_close,
    assert_same,
    assert_same_records,
    mirrored,
    mirrored_actions,
    swapped_rows,
    turned,
)

SIZE = 3  # robots a side


def whole_steps(name, image, change_actions, tolerance, seed, **settings):
    """Play a match and its image until the first contact; return how many match steps were compared."""
    league = staging.league_without_calls(name)
    settings |= {"home": SIZE, "away": SIZE, "matches": 40, "seed": seed, "actions": "full"}
    one, other = Match(league, **settings), Match(league, **settings)
    rng = np.random.default_rng(seed)
    set_phase(one, Phase.PLAY)
    scatter(one, rng, 0.8)
    angle, v = rng.uniform(-np.pi, np.pi, 40), rng.uniform(0.0, 0.3, 40) * league.ball.top_speed
    put_ball(one, one.balls["x"], one.balls["y"], v * np.cos(angle), v * np.sin(angle))
    one.rebuild()
    image(Records.of(one)).put_into(other)
    free, compared = np.ones(40, bool), 0
    for step in range(steps_in(one, 6.0)):
        if step % 10 == 0:
            actions = rng.uniform(-1.0, 1.0, (40, 2 * SIZE, 7))
        one.step(actions)
        other.step(change_actions(actions))
        free &= ~(one.robot_events["collision"].any(axis=1) | one.robot_events["touch"].any(axis=1))
        free &= near_boards(one) == 0
        expected = image(Records.of(one))
        for name in ("matches", "balls", "robots"):
            assert_same(getattr(other, name)[free], getattr(expected, name)[free], tolerance, f"step {step}: {name}")
        mirror = image is mirrored
        rewards = one.rewards if mirror else swapped_rows(one.rewards)
        assert_close(other.rewards[free], rewards[free], 10.0 * tolerance, f"step {step}: rewards")
        compared += free.sum()
    return compared


def near_boards(match):
    """Count, for each match, the robots and balls that may touch a board."""
    pitch, reach = match.league.pitch, match.league.body.reach + 0.02
    x, y = pitch.length / 2 + min(pitch.band_end, 0.0), pitch.width / 2 + pitch.band_side
    robots = (abs(match.robots["x"]) > x - reach) | (abs(match.robots["y"]) > y - reach)
    ball = (abs(match.balls["x"]) > x - reach) | (abs(match.balls["y"]) > y - reach)
    return robots.sum(axis=1) + ball


@pytest.mark.slow
@pytest.mark.parametrize("placement", ["instant", "drive"])
@pytest.mark.parametrize(
    ("image", "change_actions", "tolerance", "seed"),
    [(mirrored, mirrored_actions, MIRROR, 8), (turned, swapped_rows, HALF_TURN, 9)],
    ids=["mirrored", "sides swapped"],
)
@each_league
def test_an_image_of_a_match_is_played_as_its_image_until_the_first_contact(
    name, image, change_actions, tolerance, seed, placement
):
    assert whole_steps(name, image, change_actions, tolerance, seed, placement=placement) > 1000


@each_league
def test_a_mirrored_scrum_stays_a_mirror_while_robots_push_and_hold_each_other(name):
    """Chasers run at the ball from all sides, through blows, held legs and kicks.

    Sums in another order differ in the last digit, and a throng of wheels multiplies that: after 5 s a few of its
    matches show it.
    """
    one, other = (
        Match(staging.league_without_calls(name), home=SIZE, away=SIZE, matches=40, seed=12) for _ in range(2)
    )
    set_phase(one, Phase.PLAY)
    scatter(one, np.random.default_rng(12), 0.5)
    one.rebuild()
    mirrored(Records.of(one)).put_into(other)
    blows, held = 0, 0
    for _ in range(steps_in(one, 5.0 if name == MIDDLE else 10.0)):
        for match in (one, other):
            match.step(chase(match))
        blows += one.robot_events["collision"].sum()
        held += (one.robots["caught_by"] > 0).sum()
    expected = mirrored(Records.of(one))
    off = np.zeros(40)
    for axis in ("x", "y"):
        off = np.maximum(off, abs(other.balls[axis] - expected.balls[axis]))
        off = np.maximum(off, abs(other.robots[axis] - expected.robots[axis]).max(axis=1))
    assert (off <= MIRROR).mean() > 0.7 and off.max() < 1e-5
    assert blows > 100 and (held > 100 or name == MIDDLE)


def chase(match):
    """Return actions with which every robot runs at the ball, as a mirror shows them in a mirrored match."""
    x, y = match.balls["x"][:, None] - match.robots["x"], match.balls["y"][:, None] - match.robots["y"]
    cosine, sine = np.cos(match.robots["heading"]), np.sin(match.robots["heading"])
    ahead, left = cosine * x + sine * y, cosine * y - sine * x
    away = np.hypot(ahead, left)
    actions = stand(match)
    actions[..., 0], actions[..., 2] = ahead / away, np.clip(2.0 * left / away, -1.0, 1.0)
    actions[..., 3] = 0.5
    return actions


@pytest.mark.parametrize("phase", ["kick-off", "throw-in", "goal kick", "corner"])
def test_a_restart_in_a_whole_step_is_symmetric(phase):
    league = find_league(MIDDLE)
    one, left_right, half_turn = (Match(league, home=SIZE, away=SIZE, matches=8, seed=10) for _ in range(3))
    set_phase(one, Phase.PLAY)
    over, wide = league.pitch.length / 2 + 0.13, league.pitch.width / 2 + 0.13
    x, y = {"kick-off": (over, 0.3), "throw-in": (2.0, wide), "goal kick": (over, 2.0), "corner": (over, -2.0)}[phase]
    one.matches["last_touch_team"] = AWAY if phase == "corner" else HOME
    put_ball(one, x, y)
    one.rebuild()
    mirrored(Records.of(one)).put_into(left_right)
    turned(Records.of(one)).put_into(half_turn)
    for match in (one, left_right, half_turn):
        match.step(stand(match))
    assert (one.events["restart"] != 0).all()
    assert_same_records(Records.of(left_right), mirrored(Records.of(one)), MIRROR)
    assert_same_records(Records.of(half_turn), turned(Records.of(one)), HALF_TURN)


def test_the_noise_of_a_mirrored_kick_is_mirrored():
    """What handedness is for: the same draw strays to the left in one world and to the right in the other."""
    league = replace(find_league(MIDDLE))
    one, other = (Match(league, home=1, away=1, matches=20, seed=11, rules="simple") for _ in range(2))
    gap = league.body.front + league.ball.radius + 0.005
    one.robots["x"][:, 0], one.robots["y"][:, 0], one.robots["heading"][:, 0] = -1.0, 0.0, 0.0
    put_ball(one, -1.0 + gap, 0.0)
    one.robots["has_ball"][:, 0] = 1
    one.rebuild()
    mirrored(Records.of(one)).put_into(other)
    actions = stand(one)
    actions[:, 0, 3] = 1.0
    one.step(actions)
    other.step(actions)
    assert (abs(one.balls["vy"]) > 0.0).all()
    np.testing.assert_array_equal(one.balls["vy"], -other.balls["vy"])
    np.testing.assert_array_equal(one.balls["vx"], other.balls["vx"])


@pytest.mark.slow
@pytest.mark.whole
@each_league
@pytest.mark.parametrize("senses", ["ideal", "sensors"])
def test_a_team_against_itself_is_as_good_at_home_as_away(name, senses):
    minutes = 0.5 if name == MIDDLE else 2.0
    both = {"home": "chaser", "away": "chaser"}
    match = Match(
        name, home=2, away=2, matches=400, seed=3, threads=2, minutes=minutes, controllers=both, senses=senses,
        rules="simple",
    )  # fmt: skip
    while not match.terminated.all():
        match.step()
    gap = match.matches["score"][:, 0] - match.matches["score"][:, 1]
    assert np.abs(gap).sum() > len(gap) / 20, "too few goals to tell"
    assert abs(gap.mean()) < 2.6 * gap.std() / np.sqrt(len(gap))  # 99 %
