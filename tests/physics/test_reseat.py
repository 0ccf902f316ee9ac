"""A Space that is put back in place of a new one: the same future to the last bit, in scrums too, and no new Space."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.physics.engine import pools
from tests.scenes.staging import LEAGUES

TOUCH = {"legged-2001": 0.3, "middle-size-2006": 0.6}  # [m] between the centres of robots that may touch


def scrums(league: str, **settings: Any) -> Match:
    """Return matches in which all robots run at one ball."""
    both = {"home": "chaser", "away": "chaser"}
    return Match(league, matches=50, controllers=both, senses="ideal", seed=3, autoreset="same_step", **settings)


def jammed(match: Match) -> int:
    """Return in how many matches two robots are so near that they may touch."""
    places = match.robots["x"] + 1j * match.robots["y"]
    apart = np.abs(places[:, :, None] - places[:, None, :]) + 9.0 * np.eye(len(match.agents))
    return int((apart.min(axis=(1, 2)) < TOUCH[match.league.name]).sum())


@pytest.mark.slow
@pytest.mark.parametrize("league", LEAGUES)
def test_400_branches_in_scrums_go_on_as_with_new_spaces(league: str) -> None:
    """The Spaces of one Match are put back, those of the other are made anew, 8 times in the midst of play."""
    ours, others = scrums(league, home=4, away=4, minutes=1.0), scrums(league, home=4, away=4, minutes=1.0)
    others.batch.physics.seats = None
    close, rebuilt, actions = 0, 0, np.zeros((50, 8, 4))
    for _ in range(8):
        for _ in range(31):
            ours.step(actions)
            others.step(actions)
        assert ours.state_hash() == others.state_hash()
        close += jammed(ours)
        ours.rebuild()
        others.rebuild()
        rebuilt += ours.count
        assert np.array_equal(ours.batch.physics.bodies, others.batch.physics.bodies)
    for _ in range(100):
        ours.step(actions)
        others.step(actions)
    assert ours.state_hash() == others.state_hash()
    assert rebuilt == 400 and close > 100, close


def test_a_reset_puts_the_space_back_and_makes_none() -> None:
    match = Match(home=2, away=2, matches=2, seed=1)
    spaces = list(match.batch.physics.spaces)
    match.reset(seed=5)
    match.load(match.save())
    assert all(one is other for one, other in zip(spaces, match.batch.physics.spaces, strict=True))
    fresh = Match(home=2, away=2, matches=2, seed=5)
    for _ in range(40):
        match.step(np.full((2, 4, 4), 0.7))
        fresh.step(np.full((2, 4, 4), 0.7))
    assert match.state_hash() == fresh.state_hash()


@pytest.mark.parametrize("way", ["unknown pymunk", "batch"])
def test_where_it_cannot_be_put_back_a_space_is_made(way: str, monkeypatch: pytest.MonkeyPatch) -> None:
    known = Match(home=2, away=2, seed=1)
    if way == "unknown pymunk":
        monkeypatch.setattr("soccer_env.physics.engine.space_batch.layout_fits", lambda: False)
    other = Match(home=2, away=2, seed=1, backend="batch" if way == "batch" else None)
    first = other.batch.physics.spaces[0]
    for match in (known, other):
        match.reset(seed=2)
        for _ in range(20):
            match.step(np.full((1, 4, 4), 0.5))
    assert other.batch.physics.spaces[0] is not first
    assert known.state_hash() == other.state_hash()


def test_the_counter_of_shapes_is_found_in_this_pymunk() -> None:
    assert pools.layout_fits()
