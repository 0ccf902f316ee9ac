"""How matches are shared out among team sizes, senses and blocks."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccer_env.match.match import BLOCK

pytest.importorskip("stable_baselines3")

from soccer_env.train.ppo.match_blocks import parts, shares

IDEAL = {"senses": "ideal"}


def test_every_size_has_as_many_matches_in_blocks_of_up_to_64() -> None:
    assert BLOCK == 64
    assert shares([(3, 3)], 64, 0.0) == [((3, 3), 64, {})]
    assert shares([(3, 3)], 129, 0.0) == [((3, 3), 43, {})] * 3
    assert shares([(1, 1), (3, 3)], 9, 0.0) == [((1, 1), 4, {}), ((3, 3), 5, {})]
    assert shares([(1, 1), (2, 2)], 200, 0.25) == [
        ((1, 1), 37, {}), ((1, 1), 38, {}), ((1, 1), 25, IDEAL), ((2, 2), 37, {}), ((2, 2), 38, {}), ((2, 2), 25, IDEAL)
    ]  # fmt: skip


@given(sizes=st.integers(1, 4), matches=st.integers(0, 2000), share=st.sampled_from([0.0, 0.1, 0.25, 0.5, 0.99, 1.0]))
def test_matches_add_up_and_no_block_is_empty_or_too_large(sizes: int, matches: int, share: float) -> None:
    players = [(size, size) for size in range(1, sizes + 1)]
    try:
        blocks = shares(players, matches, share)
    except ValueError as error:
        assert "at least one for each" in str(error)
        return
    assert sum(count for _, count, _ in blocks) == matches
    assert all(1 <= count <= BLOCK for _, count, _ in blocks)
    for player in players:
        ideal = sum(count for size, count, told in blocks if size == player and told == IDEAL)
        whole = sum(count for size, count, _ in blocks if size == player)
        assert abs(ideal - share * whole) <= 0.5 and abs(whole - matches / sizes) < 1.0


@given(whole=st.integers(0, 10_000), count=st.integers(1, 50))
def test_parts_are_nearly_equal(whole: int, count: int) -> None:
    found = parts(whole, count)
    assert len(found) == count and sum(found) == whole and max(found) - min(found) <= 1
