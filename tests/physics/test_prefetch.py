"""Fetching ahead changes no number, and the spans that are fetched are those that a step touches."""

import numpy as np
import pytest
from pymunk._chipmunk_cffi import ffi

from soccer_env.match import Match
from soccer_env.physics.engine import prefetch
from soccer_env.physics.engine.memory import address_of
from soccer_env.physics.engine.pools import BUFFER_SIZE, SPACE_DYNAMIC, layout_fits
from soccer_env.physics.engine.prefetch import LINE, SPANS, add

LEAGUES = ["legged-2001", "middle-size-2006"]
PLAYERS = 3  # a side
UNUSED_PAIR, NEXT_PAIR, PAIR_SIZE = 64, 16, 56  # the first of the pool of pairs in Chipmunk's tree, the next


@pytest.fixture(autouse=True)
def _useful_for_two(monkeypatch):
    monkeypatch.setattr(prefetch, "FEWEST_MATCHES", 2)


def play(league, steps, fetches=True):
    """Let two matches play at random; return them."""
    match = Match(league, home=PLAYERS, away=PLAYERS, matches=2, seed=3)
    if not fetches:
        match.batch.physics.links["spans"] = 0
    draws = np.random.default_rng(0).uniform(-1.0, 1.0, (steps // 8 + 1, 2, 2 * PLAYERS, 4))
    for step in range(steps):
        match.step(draws[step // 8])
    return match


def lines_of(spans):
    """Return the numbers of all cache lines in a record of spans."""
    noted = spans["span"][: spans["count"]]
    return {int(at) // LINE + i for at, lines in noted for i in range(int(lines))}


def test_the_structs_of_this_pymunk_are_known():
    assert layout_fits()


@pytest.mark.parametrize("league", LEAGUES)
def test_fetching_ahead_changes_no_bit(league):
    ahead, plain = play(league, 400), play(league, 400, fetches=False)
    assert ahead.batch.physics.spans["count"].all()
    assert not plain.batch.physics.spans["count"].any()
    assert ahead.state_hash() == plain.state_hash()


@pytest.mark.parametrize("league", LEAGUES)
def test_spans_hold_bodies_shapes_constraint_and_contacts_and_little_else(league):
    physics = play(league, 4).batch.physics
    for m, space in enumerate(physics.spaces):
        noted = lines_of(physics.spans[m])
        shapes = [shape for body in space.bodies for shape in body.shapes]
        for thing in (space, *space.bodies, *shapes, *space.constraints):
            assert address_of(thing) // LINE in noted
        assert physics.solvers[m : m + 1].ctypes.data // LINE in noted
        assert 150 < len(noted) < 500  # lines, of 5,700 that a Space holds


def test_spans_are_noted_after_steps_that_are_powers_of_two():
    match = play("legged-2001", 4)
    spans = match.batch.physics.spans
    spans["count"] = 0
    for steps in range(5, 9):
        assert not spans["count"].any()
        match.step(np.zeros((2, 2 * PLAYERS, 4)))
        assert spans["steps"].tolist() == [steps, steps]
    assert spans["count"].all()
    match.rebuild([0])
    assert spans["steps"].tolist() == [0, 8] and spans["count"][0] == 0


def test_a_small_batch_fetches_nothing(monkeypatch):
    monkeypatch.setattr(prefetch, "FEWEST_MATCHES", 3)
    assert not play("legged-2001", 4).batch.physics.links["spans"].any()


def test_a_span_holds_whole_lines_and_grows_while_memory_goes_on():
    spans = np.zeros(1, SPANS)
    add(spans[0], 10 * LINE + 60, 8)  # over the end of a line
    assert spans["span"][0, :1].tolist() == [(10 * LINE, 2)]
    add(spans[0], 12 * LINE, 1)  # begins where that ends
    assert spans["span"][0, :1].tolist() == [(10 * LINE, 3)]
    add(spans[0], 14 * LINE, 64)
    add(spans[0], 0, 64)  # no address
    add(spans[0], 20 * LINE, 0)  # nothing there
    assert spans["count"][0] == 2 and spans["span"][0, 1].tolist() == (14 * LINE, 1)


def test_spans_beyond_the_room_are_left_out():
    spans = np.zeros(1, SPANS)
    for i in range(prefetch.MOST_SPANS + 5):
        add(spans[0], 3 * i * LINE + LINE, LINE)
    assert spans["count"][0] == prefetch.MOST_SPANS


def test_shapes_of_a_fresh_space_are_neighbours_only_where_they_stand():
    physics = play("middle-size-2006", 0).batch.physics
    unused, place = 0, word_at(word_at(address_of(physics.spaces[0]) + SPACE_DYNAMIC) + UNUSED_PAIR)
    while place != 0:
        unused, place = unused + 1, word_at(place + NEXT_PAIR)
    used = 0 if unused == 0 else BUFFER_SIZE // PAIR_SIZE - unused  # without any pair there is no pool yet
    assert used < 7  # of seven shapes that are added in one place there would be 21


def word_at(address):
    return int(ffi.cast("uintptr_t *", address)[0])
