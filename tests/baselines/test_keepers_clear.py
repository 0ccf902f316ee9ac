"""Scripted goalkeepers clear the ball; field players of chaser and sacks-2001 keep the rules of the legged league."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.chaser import team as chaser_team
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills.approaching import choose_inner_side
from soccer_env.skills.attacking import DEFENDED, choose_aim
from soccer_env.skills.goalkeeping import bisect_shot_angle, may_clear
from soccer_env.skills.keeping_rules import is_in_own_area, out_of_own_area
from soccer_env.skills.sight import SIGHT
from soccer_env.teams import make_team
from soccer_env.types import Foul, Phase
from tests.scenes.staging import LEGGED, MIDDLE, place, put, put_ball, record_each_step, set_phase, stage, steps_in

MATCHES = 64


def keeper_at_goal(league: str, team: str, home: int = 2) -> Match:
    """Return matches with home's goalkeeper alone on the field, played by a scripted team with ideal senses."""
    return stage(league, MATCHES, home, 1, seed=4, senses="ideal", controllers={"home": team, "away": "still"})


def ever(match: Match, seconds: float, what: Callable[[], np.ndarray]) -> float:
    """Return the share of matches in which something was so after a step of some seconds of play."""
    return float(record_each_step(match, what, seconds).any(axis=0).mean())


def with_the_ball(team: str, widest: float) -> Match:
    """Return matches in which a legged goalkeeper has the ball before its goal, turned up to `widest` [rad] aside."""
    match, rng = keeper_at_goal(LEGGED, team), np.random.default_rng(2)
    body, ball, pitch = match.league.body, match.league.ball, match.league.pitch
    heading, touch = rng.uniform(-widest, widest, MATCHES), body.front + ball.radius
    x, y = -pitch.length / 2 + rng.uniform(0.2, 0.6, MATCHES), rng.uniform(-0.35, 0.35, MATCHES)
    place(match, ball=(x + touch * np.cos(heading), y + touch * np.sin(heading)), robots={0: (x, y, heading)})
    return match


@pytest.mark.parametrize("widest", [0.6, 1.2])
@pytest.mark.parametrize("team", ["chaser", "sacks-2001", "sacks-2001-tuned", "sacks-2001-future"])
def test_a_legged_keeper_kicks_the_ball_in_its_pocket_away_from_its_goal(team: str, widest: float) -> None:
    """One that has to turn with the ball first may lose it, out of its goal, before it kicks."""
    match = with_the_ball(team, widest)
    league, kicked = match.league, np.zeros(MATCHES, bool)
    behind = league.pitch.length / 2 + league.pitch.goal_width / 2
    for _ in range(steps_in(match, 8.0)):
        where, heading = match.balls.copy(), match.robots["heading"][:, 0].copy()
        match.step()
        kicks = match.robot_events["kick"][:, 0] == 1
        clear = np.arctan2(where["y"], where["x"] + behind)
        ahead = kicks & (match.robots["kick_side"][:, 0] == 0.0)
        assert (np.cos(heading - clear)[ahead] > np.cos(np.radians(50.0))).all(), "40 degrees, and what it turns since"
        assert (match.balls["vx"][kicks] > -0.1).all(), "nearly along the goal line at worst, with a kick that strays"
        kicked |= kicks
    assert kicked.mean() > (0.95 if widest < 0.7 else 0.6)
    assert not match.matches["score"][:, 1].any(), "no own goals"
    match.close()


def test_a_legged_keeper_kicks_at_no_board_that_it_faces_in_the_corner_of_its_own_half() -> None:
    match = keeper_at_goal(LEGGED, "chaser")
    x, y = 0.25 - match.league.pitch.length / 2, match.league.pitch.width / 2 - 0.25
    touch = match.league.body.front + match.league.ball.radius
    place(match, ball=(x, y), robots={0: (x, y - touch, 0.5 * np.pi)})
    held, kicks = record_each_step(
        match, lambda: [match.robots["has_ball"][:, 0], match.robot_events["kick"][:, 0]], 1.2
    ).swapaxes(0, 1)
    assert held[:5].all() and not kicks.any()
    match.close()


@pytest.mark.parametrize("heading", [0.0, 0.5 * np.pi, np.pi])
def test_a_legged_keeper_gets_a_ball_on_its_own_line_out_of_its_goal(heading: float) -> None:
    """The ball lies between the keeper and its goal: it steps beside the ball and kicks it aside, upfield.

    Of keepers that go round the ball 0.65 to 0.85 get it out.
    """
    match, rng = keeper_at_goal(LEGGED, "chaser"), np.random.default_rng(5)
    length = match.league.pitch.length / 2
    put(match, 0, rng.uniform(0.25, 0.45, MATCHES) - length, rng.uniform(-0.2, 0.2, MATCHES), heading)
    place(match, ball=(rng.uniform(0.02, 0.06, MATCHES) - length, rng.uniform(-0.2, 0.2, MATCHES)))
    x, y = record_each_step(match, lambda: [match.balls["x"], match.balls["y"]], 12.0).swapaxes(0, 1)
    out = (x > 0.2 - length) | (np.abs(y) > match.league.pitch.goal_width / 2)
    assert match.matches["score"][:, 1].mean() < 0.2
    assert out.any(axis=0).mean() > 0.9
    match.close()


@pytest.mark.parametrize("mirrored", [1.0, -1.0])
@pytest.mark.parametrize("turned", [0.0, 0.5 * np.pi, np.pi, -0.5 * np.pi])
def test_the_way_round_a_ball_never_comes_between_it_and_the_board(turned: float, mirrored: float) -> None:
    """The board lies behind the ball, the player before it; its back is to be reached on the side where it is."""
    inner = np.cos(turned), np.sin(turned)
    for now in np.radians([-150.0, -60.0, -10.0, 10.0, 60.0, 150.0]):
        for back in np.radians([-170.0, -135.0, -90.0, 90.0, 135.0, 170.0]):
            where, to = mirrored * now + turned, mirrored * back + turned
            side = choose_inner_side(np.cos(where), np.sin(where), -np.cos(to), -np.sin(to), *inner)
            assert side == mirrored * np.sign(back - now) or back == now


@pytest.mark.parametrize("team", ["chaser", "sacks-2001"])
def test_a_legged_keeper_that_faces_its_goal_does_not_kick(team: str) -> None:
    match = keeper_at_goal(LEGGED, team)
    body, ball = match.league.body, match.league.ball
    heading = np.linspace(0.6, 1.4, MATCHES) * np.pi
    touch = body.front + ball.radius
    place(match, ball=(-0.9 + touch * np.cos(heading), touch * np.sin(heading)), robots={0: (-0.9, 0.0, heading)})
    for _ in range(4):
        match.step()
        assert not match.robot_events["kick"].any() and not (match.robots["kick_clock"][:, 0] > 0.0).any()
    match.close()


def test_mh04_the_middle_size_keeper_clears_a_resting_ball_by_driving_into_it() -> None:
    match = keeper_at_goal(MIDDLE, "chaser")
    rng, pitch = np.random.default_rng(3), match.league.pitch
    put(match, 0, -pitch.length / 2 + 0.35, 0.0, 0.0)
    place(match, ball=(-pitch.length / 2 + rng.uniform(0.8, 1.3, MATCHES), rng.uniform(-0.8, 0.8, MATCHES)))
    cleared = np.zeros(MATCHES, bool)
    for _ in range(steps_in(match, 12.0)):
        match.step()
        x, y = match.events["ball_x"], match.events["ball_y"]
        cleared |= (x > -pitch.length / 2 + pitch.penalty_depth) | (abs(y) > pitch.penalty_width / 2)
        assert not match.robot_events["kick"].any()
    assert cleared.all()
    assert not match.matches["score"].any()
    match.close()


WHEELS = constants_of(find_league(MIDDLE))[0]


def with_ball_at(x: float, y: float) -> np.void:
    """Return what a player at the middle sees of a ball on the middle-size pitch."""
    sight = np.zeros(1, SIGHT)[0]
    sight["ball_x"], sight["ball_y"], sight["cosine"] = x, y, 1.0
    return sight


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.0), (-4.0, 2.8), (-5.0, -2.0), (3.0, -1.0)])
def test_a_keeper_on_wheels_parts_the_angle_between_the_posts(x: float, y: float) -> None:
    stand = -5.66
    way = np.arctan2(bisect_shot_angle(with_ball_at(x, y), WHEELS, stand) - y, x - stand)
    left, right = (np.arctan2(post - y, x + 6.0) for post in (1.0, -1.0))
    assert way == pytest.approx((left + right) / 2.0)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_field_player_on_wheels_plays_a_ball_near_its_goal_clear_of_it(side: float) -> None:
    play = chaser_team().settings[1]
    ux, uy = choose_aim(with_ball_at(-5.9, 1.2 * side), WHEELS, play)
    assert ux > 0.0 and uy * side > 0.0, "out, and away from its mouth"
    ux, uy = choose_aim(with_ball_at(DEFENDED - 6.0 + 0.01, 0.0), WHEELS, play)
    assert (ux, uy) == pytest.approx((1.0, 0.0)), "from farther out at the opponents' goal, if nobody is in the way"


K = constants_of(find_league(LEGGED))[0]
MANY = 32
EDGE = -1.0  # [m] x of the front edge of home's penalty area
TEAMS = ["chaser", "sacks-2001"]


def staged(team: str, **settings: Any) -> Match:
    """Return matches in play: home's goalkeeper on its line, its field players in midfield, the ball ahead of them."""
    match = Match(
        LEGGED, home=3, away=3, matches=MANY, threads=2, seed=5, controllers={"home": team, "away": "still"},
        senses="ideal", **settings,
    )  # fmt: skip
    set_phase(match, Phase.PLAY)
    spots = [(-1.3, 0.0, 0.0), (0.0, 0.4, 0.0), (0.0, -0.4, 0.0), (1.3, 0.0, np.pi), (0.9, 0.8, 0.0), (0.9, -0.8, 0.0)]
    for r, (x, y, heading) in enumerate(spots):
        put(match, r, x, y, heading)
    put_ball(match, 0.6, 0.0)
    return match


@pytest.mark.parametrize("team", TEAMS)
def test_a_field_player_in_its_own_area_walks_out_before_the_whistle(team: str) -> None:
    match, rng = staged(team), np.random.default_rng(1)
    put(match, 1, rng.uniform(-1.1, -1.0, MANY), rng.uniform(-0.3, 0.3, MANY), rng.uniform(-0.5, 0.5, MANY))
    match.robots["trespass"][:, 1] = -3.0  # as for whoever did not walk in
    match.rebuild()
    whistled = ever(match, 5.0, lambda: match.robot_events["foul"][:, 1] == Foul.ILLEGAL_DEFENDER)
    assert whistled < 0.1 and (match.robots["x"][:, 1] > EDGE).mean() > 0.9


@pytest.mark.parametrize("team", TEAMS)
def test_a_ball_in_the_own_area_is_left_to_the_goalkeeper(team: str) -> None:
    match, rng = staged(team), np.random.default_rng(2)
    put(match, 1, -0.6, 0.3, np.pi)
    place(match, ball=(rng.uniform(-1.3, -1.1, MANY), rng.uniform(-0.4, 0.4, MANY)))
    events = record_each_step(match, lambda: match.robot_events, 12.0)
    defended = (events["foul"][:, :, :3] == Foul.ILLEGAL_DEFENDER).any(axis=(0, 2))
    assert defended.mean() < 0.1 and (events["touch"][:, :, 0] == 1).any(axis=0).mean() > 0.8


def test_it_goes_to_a_ball_in_its_area_where_no_rule_forbids_it() -> None:
    match = staged("chaser", rules="simple")
    place(match, ball=(-1.0, 0.4), robots={1: (-0.6, 0.3, np.pi), 0: (-1.3, -0.3, 0.0)})
    assert ever(match, 12.0, lambda: match.robot_events["touch"][:, 1] == 1) > 0.5


def test_the_shortest_way_out_of_the_area_goes_through_its_front() -> None:
    room = float(K["body_reach"])
    for y in (0.0, 0.3, -0.3):
        x, aside = out_of_own_area(-1.1, y, K, room)
        assert x == pytest.approx(EDGE + room) and aside == y
    assert out_of_own_area(0.3, 0.2, K, room) == (0.3, 0.2)
    assert is_in_own_area(-1.2, 0.4, K, 0.0) and not is_in_own_area(-1.2, 0.6, K, 0.0)
    assert out_of_own_area(-1.3, 0.45, K, room)[1] == pytest.approx(0.5 + room)


def test_an_attacker_before_a_goalkeeper_in_its_area_is_whistled_less_than_one_that_shoves() -> None:
    match = staged("chaser")
    place(match, ball=(1.1, 0.0), robots={3: (1.25, 0.0, np.pi), 1: (0.95, 0.0, 0.0)})
    assert ever(match, 6.0, lambda: match.robot_events["foul"][:, 1] == Foul.KEEPER_PUSHING) < 0.5


@pytest.mark.parametrize(("x", "y", "fetched"), [(-0.9, 0.6, True), (-1.35, 0.85, False), (0.2, 0.0, False)])
def test_a_legged_keeper_fetches_a_lone_ball_in_its_third_but_not_out_of_a_corner(x, y, fetched):
    sight, team = np.zeros(1, SIGHT)[0], make_team("chaser")
    sight["x"], sight["ball_x"], sight["ball_y"], sight["distance"] = -1.2, x, y, 0.9
    assert may_clear(sight, constants_of(find_league(LEGGED))[0], team.settings[0]) == fetched
