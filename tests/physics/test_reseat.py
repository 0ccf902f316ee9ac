"""A Space that is put back has the same future as a new one, to the last bit; fetching ahead changes no number."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.physics.engine import prefetch
from soccer_env.physics.engine.pools import layout_fits as structs_known
from soccer_env.physics.engine.prefetch import LINE, SPANS, add_span
from tests.scenes.staging import LEAGUES, play

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
    ours, others = scrums(league, home=5, away=5, minutes=1.0), scrums(league, home=5, away=5, minutes=1.0)
    others.batch.physics.seats = None
    close, rebuilt, actions = 0, 0, np.zeros((50, 10, 4))
    for _ in range(8):
        for match in (ours, others):
            play(match, actions=actions, steps=31)
        assert ours.state_hash() == others.state_hash()
        close += jammed(ours)
        ours.rebuild()
        others.rebuild()
        rebuilt += ours.count
        assert np.array_equal(ours.batch.physics.bodies, others.batch.physics.bodies)
    for match in (ours, others):
        play(match, actions=actions, steps=100)
    assert ours.state_hash() == others.state_hash()
    assert rebuilt == 400 and close > 100, close


def test_a_reset_puts_the_space_back_and_makes_none() -> None:
    assert structs_known(), "the counter of shapes is found in this pymunk"
    match, fresh = (Match(home=2, away=2, matches=2, seed=seed) for seed in (1, 5))
    spaces = list(match.batch.physics.spaces)
    match.reset(seed=5)
    match.load(match.save())
    assert all(one is other for one, other in zip(spaces, match.batch.physics.spaces, strict=True))
    for one in (match, fresh):
        play(one, actions=np.full((2, 4, 4), 0.7), steps=40)
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
        play(match, actions=np.full((1, 4, 4), 0.5), steps=20)
    assert other.batch.physics.spaces[0] is not first
    assert known.state_hash() == other.state_hash()


PLAYERS = 3  # a side


@pytest.fixture(autouse=True)
def _useful_for_two(monkeypatch):
    monkeypatch.setattr(prefetch, "FEWEST_MATCHES", 2)


def played(league, steps, fetches=True):
    match = Match(league, home=PLAYERS, away=PLAYERS, matches=2, seed=3)
    if not fetches:
        match.batch.physics.links["spans"] = 0
    draws = np.random.default_rng(0).uniform(-1.0, 1.0, (steps // 8 + 1, 2, 2 * PLAYERS, 4))
    for step in range(steps):
        match.step(draws[step // 8])
    return match


@pytest.mark.parametrize("league", LEAGUES)
def test_fetching_ahead_changes_no_bit(league):
    assert structs_known(), "the structs of this pymunk are known"
    ahead, plain = played(league, 400), played(league, 400, fetches=False)
    assert ahead.batch.physics.spans["count"].all()
    assert not plain.batch.physics.spans["count"].any()
    assert ahead.state_hash() == plain.state_hash()


def test_a_span_holds_whole_lines_and_grows_while_memory_goes_on_and_those_beyond_the_room_are_left_out():
    spans, many = np.zeros(1, SPANS), np.zeros(1, SPANS)
    add_span(spans[0], 10 * LINE + 60, 8)  # over the end of a line
    assert spans["span"][0, :1].tolist() == [(10 * LINE, 2)]
    add_span(spans[0], 12 * LINE, 1)  # begins where that ends
    assert spans["span"][0, :1].tolist() == [(10 * LINE, 3)]
    add_span(spans[0], 14 * LINE, 64)
    add_span(spans[0], 0, 64)  # no address
    add_span(spans[0], 20 * LINE, 0)  # nothing there
    assert spans["count"][0] == 2 and spans["span"][0, 1].tolist() == (14 * LINE, 1)
    for i in range(prefetch.MOST_SPANS + 5):
        add_span(many[0], 3 * i * LINE + LINE, LINE)
    assert many["count"][0] == prefetch.MOST_SPANS
