"""Actions as indices: what the choices of "multi" command, and masks that say which choices have an effect."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.actions import DISCRETE, FULL, KICKS, LEVELS, PARTS, ActionKind, action_masks
from soccer_env.leagues import find_league
from tests.scenes.staging import LEAGUES, LEGGED, MIDDLE, put, put_ball, set_phase, stage

MULTI = ActionKind("multi")
NONE, SOFT, STRONG, LEFT, RIGHT = range(len(KICKS))
STILL = MULTI.still(1, 1)[0, 0]


def test_the_choices_of_multi_are_levels_and_a_kick() -> None:
    assert MULTI.parts == (5, 5, 5, 5) and STILL.tolist() == [2, 2, 2, 0]
    told = dict(zip(FULL, MULTI.numbers([4, 3, 0, SOFT], "home_0").tolist(), strict=True))
    assert told == {"forward": 1.0, "left": 0.5, "turn": -1.0, "kick": 0.4, "head": -1.0, "pan": 0.0, "tilt": 0.0}
    assert MULTI.numbers(STILL, "home_0").tolist() == [0, 0, 0, 0, -1, 0, 0]
    every = np.stack(np.meshgrid(*map(range, MULTI.parts), indexing="ij"), axis=-1).reshape(-1, 4)
    expanded = MULTI.expand(every)
    assert len(np.unique(expanded, axis=0)) == 5**4, "no two choices command the same"
    assert set(expanded[:, :3].ravel()) == set(LEVELS)


def kicked(league: str, kick: int, matches: int = 40) -> tuple[np.ndarray, np.ndarray]:
    """Return speed [m/s] and direction [rad] of a ball in the pocket of robots that choose this kick, in each match."""
    match = stage(league, matches=matches, robots={0: (0.0, 0.0)}, actions="multi")
    set_phase(match, 0)
    body, ball = match.league.body, match.league.ball
    put(match, 0, 0.0, 0.0)
    put_ball(match, body.front + ball.radius + 0.2 * match.league.kicker.reach, 0.0)
    match.rebuild()
    action = np.broadcast_to(STILL, (matches, 2, 4)).copy()
    action[:, 0, 3] = kick
    velocity, done = np.zeros((matches, 2)), np.zeros(matches, bool)
    for _ in range(2 * match.league.control_rate):
        match.step(action)
        hit = (match.robot_events["kick"][:, 0] == 1) & ~done
        velocity[hit] = np.stack([match.balls["vx"], match.balls["vy"]], axis=-1)[hit]
        done |= hit
    return np.hypot(*velocity[done].T), np.arctan2(velocity[done, 1], velocity[done, 0])


@pytest.mark.parametrize("league", [LEGGED, MIDDLE])
def test_a_soft_kick_is_slower_than_a_full_one_and_both_go_ahead(league: str) -> None:
    (soft, ahead), (full, also) = kicked(league, SOFT), kicked(league, STRONG)
    assert len(soft) > 20 and len(full) > 20
    assert np.median(soft) < 0.8 * np.median(full)
    assert abs(np.median(ahead)) < 0.1 and abs(np.median(also)) < 0.1


def test_a_kick_aside_goes_to_its_side_as_the_leagues_kick_does() -> None:
    aside = find_league(LEGGED).kicker.aside
    for kick, side in ((LEFT, 1.0), (RIGHT, -1.0)):
        speeds, directions = kicked(LEGGED, kick)
        assert len(speeds) > 20 and np.median(directions) == pytest.approx(side * aside, abs=0.15)
    _, directions = kicked(MIDDLE, LEFT)
    assert abs(np.median(directions)) < 0.1, "where no kick goes aside it goes ahead"


def masks(match: Match) -> np.ndarray:
    return match.action_masks()[0]


@pytest.mark.parametrize("kind", PARTS)
@pytest.mark.parametrize("league", LEAGUES)
def test_a_robot_that_may_not_act_can_only_stand(league: str, kind: str) -> None:
    match = Match(league, home=2, away=2, seed=1, actions=kind)
    robots = match.robots[0]
    robots["active"][1], robots["fallen"][2] = 0, 2.0
    told, parts = masks(match), ActionKind(kind).parts
    assert told.shape == (4, sum(parts)) and told.dtype == np.int8
    assert (told[1:3].sum(axis=1) == len(parts)).all() and told[3].sum() > len(parts)
    for chosen in told[1:3]:
        indices = np.array([part.argmax() for part in np.split(chosen, np.cumsum(parts)[:-1])])
        numbers = ActionKind(kind).expand(indices.reshape(ActionKind(kind).shape))
        assert not numbers[:4].any()
    match.matches["placing"] = 1
    assert (masks(match).sum(axis=1) == len(parts)).all()


def test_kicks_are_masked_while_the_kicker_is_not_ready_and_where_there_is_none() -> None:
    walk = [1] * 15
    match = Match(LEGGED, home=2, away=2, seed=1, actions="multi")
    match.robots["kick_clock"][0] = [0.0, 0.3, -0.2, 0.0]
    assert masks(match).tolist() == [[*walk, 1, 1, 1, 1, 1], *[[*walk, 1, 0, 0, 0, 0]] * 2, [*walk, 1, 1, 1, 1, 1]]
    match = Match(MIDDLE, home=2, away=2, seed=1, actions="multi")
    keeper, player = [*walk, 1, 0, 0, 0, 0], [*walk, 1, 1, 1, 0, 0]
    assert masks(match).tolist() == [keeper, player, keeper, player], "goalkeepers have no kicker, no kick goes aside"
    match = Match(LEGGED, home=2, away=1, seed=1, actions="discrete")
    match.robots["kick_clock"][0, 1] = 0.2
    names = [name for name, allowed in zip(DISCRETE, masks(match)[1], strict=True) if not allowed]
    assert names == ["kick", "pass"] and masks(match)[0].all()


@pytest.mark.parametrize("league", [LEGGED, MIDDLE])
def test_a_masked_kick_changes_nothing(league: str) -> None:
    """In random play: the state after a step is that after the same step without the kick."""
    one = Match(league, home=3, away=3, matches=16, seed=3, actions="multi")
    other, rng = Match(league, home=3, away=3, matches=16, seed=3, actions="multi"), np.random.default_rng(1)
    masked = 0
    for _ in range(60):
        told = one.action_masks()
        actions = rng.integers(0, 5, (16, 6, 4))
        spared = actions.copy()
        never = np.take_along_axis(told[..., 15:], actions[..., 3:], axis=-1)[..., 0] == 0
        if league == MIDDLE:
            never &= told[..., 15 + STRONG] == 0  # else a kick "aside" goes ahead
        spared[never, 3] = NONE
        masked += int(never.sum())
        one.step(actions)
        other.step(spared)
        for name in ("x", "y", "vx", "vy", "kick_clock"):
            assert (one.robots[name] == other.robots[name]).all()
        assert (one.balls["vx"] == other.balls["vx"]).all()
        if league == LEGGED:
            one.robots["pan"], one.robots["tilt"] = other.robots["pan"], other.robots["tilt"]
    assert masked > 50


def test_numbers_have_no_masks() -> None:
    match = Match(home=1, away=1, seed=1)
    with pytest.raises(ValueError, match="no masks: give actions='discrete', 'multi' or 'skills', not"):
        match.action_masks()
    with pytest.raises(ValueError, match="not 'full'"):
        action_masks(ActionKind("full"), match.matches, match.robots, match.league)
