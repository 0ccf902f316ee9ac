"""The chaser's field players, and those of sacks-2001, keep the rules of the legged league."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.obeying import is_in_own_area, out_of_own_area
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.teams import make_team
from soccer_env.types import Foul, Phase
from tests.scenes.staging import LEGGED, place, put, put_ball, set_phase, steps_in

K = constants_of(find_league(LEGGED))[0]
MATCHES = 32
EDGE = -1.0  # [m] x of the front edge of home's penalty area
TEAMS = ["chaser", "sacks-2001"]


def staged(team: str, **settings: Any) -> Match:
    """Return matches in play: home's goalkeeper on its line, its field players in midfield, the ball ahead of them."""
    match = Match(
        LEGGED, home=3, away=3, matches=MATCHES, threads=2, seed=5, controllers={"home": team, "away": "still"},
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
    put(match, 1, rng.uniform(-1.1, -1.0, MATCHES), rng.uniform(-0.3, 0.3, MATCHES), rng.uniform(-0.5, 0.5, MATCHES))
    match.robots["trespass"][:, 1] = -3.0  # as for whoever did not walk in
    match.rebuild()
    whistles = np.zeros(MATCHES, bool)
    for _ in range(steps_in(match, 5.0)):
        match.step()
        whistles |= match.robot_events["foul"][:, 1] == Foul.ILLEGAL_DEFENDER
    assert whistles.mean() < 0.1 and (match.robots["x"][:, 1] > EDGE).mean() > 0.9
    match.close()


@pytest.mark.parametrize("team", TEAMS)
def test_a_ball_in_the_own_area_is_left_to_the_goalkeeper(team: str) -> None:
    match, rng = staged(team), np.random.default_rng(2)
    put(match, 1, -0.6, 0.3, np.pi)
    place(match, ball=(rng.uniform(-1.3, -1.1, MATCHES), rng.uniform(-0.4, 0.4, MATCHES)))
    defended, kept = np.zeros(MATCHES, bool), np.zeros(MATCHES, bool)
    for _ in range(steps_in(match, 12.0)):
        match.step()
        defended |= (match.robot_events["foul"][:, :3] == Foul.ILLEGAL_DEFENDER).any(axis=1)
        kept |= match.robot_events["touch"][:, 0] == 1
    assert defended.mean() < 0.1 and kept.mean() > 0.8
    match.close()


def test_it_goes_to_a_ball_in_its_area_where_no_rule_forbids_it() -> None:
    match = staged("chaser", rules="simple")
    place(match, ball=(-1.0, 0.4), robots={1: (-0.6, 0.3, np.pi), 0: (-1.3, -0.3, 0.0)})
    touched = np.zeros(MATCHES, bool)
    for _ in range(steps_in(match, 12.0)):
        match.step()
        touched |= match.robot_events["touch"][:, 1] == 1
    assert touched.mean() > 0.5
    match.close()


def nearest_to_area(team: str) -> np.ndarray:
    """Return how near [m] a field player comes to its own area (M,) that it was near when the ball lay before it."""
    match = staged(team)
    put(match, 1, -0.7, 0.2, np.pi)
    put_ball(match, -0.9, 0.2)
    match.balls["vx"] = -0.3
    match.rebuild()
    nearest = np.full(MATCHES, np.inf)
    for _ in range(steps_in(match, 10.0)):
        match.step()
        nearest = np.minimum(nearest, match.robots["x"][:, 1] - EDGE)
    match.close()
    return nearest


def test_a_chaser_told_to_gives_its_area_a_wide_berth() -> None:
    wide, usual = nearest_to_area("chaser:berth=0.2"), nearest_to_area("chaser")
    assert np.median(wide) > np.median(usual) + 0.1


def test_settings_of_the_chaser_are_its_numbers_by_name() -> None:
    assert set(make_team("chaser:berth=0.2,room=0.05").settings["berth"]) == {0.2}
    with pytest.raises(ValueError, match="unknown setting of chaser 'bert', did you mean 'berth'"):
        make_team("chaser:bert=0.2")
    for value in ("far", "nan", "True"):
        with pytest.raises(ValueError, match=f"berth of chaser must be a number, got '?{value}"):
            make_team(f"chaser:berth={value}")


def test_the_shortest_way_out_of_the_area_goes_through_its_front() -> None:
    room = float(K["body_reach"])
    for y in (0.0, 0.3, -0.3):
        x, aside = out_of_own_area(-1.1, y, K, room)
        assert x == pytest.approx(EDGE + room) and aside == y
    assert out_of_own_area(0.3, 0.2, K, room) == (0.3, 0.2)
    assert is_in_own_area(-1.2, 0.4, K, 0.0) and not is_in_own_area(-1.2, 0.6, K, 0.0)
    assert out_of_own_area(-1.3, 0.45, K, room)[1] == pytest.approx(0.5 + room)


def test_an_attacker_before_a_goalkeeper_in_its_area_is_whistled_less_than_one_that_shoves() -> None:
    """Ball and goalkeeper right before it: it goes step by step, and shoots; nobody sees contacts."""
    match = staged("chaser")
    place(match, ball=(1.1, 0.0), robots={3: (1.25, 0.0, np.pi), 1: (0.95, 0.0, 0.0)})
    whistles = np.zeros(MATCHES, bool)
    for _ in range(steps_in(match, 6.0)):
        match.step()
        whistles |= match.robot_events["foul"][:, 1] == Foul.KEEPER_PUSHING
    assert whistles.mean() < 0.5
    match.close()
