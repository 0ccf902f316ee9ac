"""Which blobs are stickers of one player, and which box stands for it.

+--+                +-----+
|B |- - - gap - - - |  A  |       one player if the gap is less than three times the size of A
+--+                +-----+
"""

import itertools

import numpy as np
import pytest

from soccer_env.belief.legged.grouping import box_of_player, is_larger, largest_left, player_of, size_of
from soccer_env.percept_types import BLOB, BLOBS
from tests.belief.legged.staged_players import LEAGUE, Blob, player

NONE = (0, 0, 0, 0, 0)


def picture(*blobs: Blob) -> np.ndarray:
    """Return the blobs of one colour."""
    found = np.zeros(BLOBS, BLOB)
    for i, blob in enumerate(blobs):
        found[i] = blob
    return found


def players(blobs: np.ndarray, grouping: float = 3.0) -> list[int]:
    """Return the player, by its largest blob, that each blob belongs to."""
    return [int(player_of(blobs, i, grouping)) for i in range(BLOBS) if blobs["area"][i]]


def box(blobs: np.ndarray, i: int, **settings: str) -> tuple[int, ...]:
    """Return left, right, high, low of the box that stands for a player."""
    return tuple(box_of_player(blobs, i, LEAGUE.memory.changed(settings).record()[0]))


def test_ms29_blobs_nearer_than_three_sizes_of_the_larger_are_one_player() -> None:
    """MS29: the gap has to be less than 3 x 10 px."""
    large = player(0.0, 0.0, 10)
    assert players(picture(large, player(29.0, 0.0, 4))) == [0, 0]
    assert players(picture(large, player(30.0, 0.0, 4))) == [0, 1]
    assert players(picture(large, player(0.0, -29.0, 4))) == [0, 0]
    assert players(picture(large, player(-18.0, 24.0, 4))) == [0, 1]  # 30 px along the diagonal


def test_ms29_the_factor_is_a_setting() -> None:
    """MS29: factor 0 makes a player of every blob, ghosts; 1 misses what 3 joins."""
    blobs = picture(player(0.0, 0.0, 10), player(18.0, 0.0, 4))
    assert players(blobs, 0.0) == players(blobs, 1.0) == [0, 1]
    assert players(blobs, 2.0) == players(blobs, 6.0) == [0, 0]


def test_ms29_size_is_the_mean_of_width_and_height() -> None:
    """MS29, footnote 6: twice as near, everything is twice as large, gaps too, and the players are the same."""
    assert size_of(picture(player(height=8, width=4))[0]) == 6.0
    near, far = (picture(player(0, 0, 4 * n), player(11 * n, 0, 2 * n), player(-13 * n, 0, 2 * n)) for n in (4, 1))
    assert players(near) == players(far) == [0, 0, 2]  # by area the near one would be all one player


def test_ms29_the_larger_blob_counts_whatever_their_areas() -> None:
    """MS29: a long thin blob is larger than a square one with more pixels."""
    thin, square = player(0.0, 0.0, 4, 40), player(60.0, 0.0, 14)
    assert thin[4] < square[4]
    assert players(picture(square, thin)) == [1, 1]  # 60 < 3 x 22


def test_ms29_a_blob_joins_the_player_of_any_larger_blob() -> None:
    """MS29: each is near the next larger one alone."""
    chain = [player(0.0, 0.0, 10), player(25.0, 0.0, 8), player(45.0, 0.0, 6), player(60.0, 0.0, 4)]
    for order in itertools.permutations(range(4)):
        blobs = picture(*(chain[i] for i in order))
        assert players(blobs) == [order.index(0)] * 4
    assert players(picture(chain[0], chain[2])) == [0, 1]  # without the link


def test_ms29_a_player_behind_another_is_taken_for_part_of_it() -> None:
    """MS29: the factor errs on the side of missing the farther one, never the nearer."""
    near, behind = player(0.0, 0.0, 12), player(20.0, 3.0, 5)
    assert players(picture(near, behind)) == [0, 0]
    assert players(picture(behind, near)) == [1, 1]


def test_players_come_largest_first_with_ties_in_the_order_of_the_vision() -> None:
    blobs = picture(player(0, 0, 5), player(40, 0, 9), player(-40, 0, 5, 5), player(-10, 0, 6))
    order, done = [], 0
    while (i := largest_left(blobs, done)) >= 0:
        order.append(i)
        done |= 1 << i
    assert order == [1, 3, 0, 2]
    assert is_larger(blobs, 0, 2) and not is_larger(blobs, 2, 0) and not is_larger(blobs, 0, 0)
    blobs["area"][2] += 1
    assert is_larger(blobs, 2, 0)


def test_blobs_of_no_size_belong_to_somebody() -> None:
    blobs = picture(player(0, 0, 0), player(0, 0, 0), player(2, 0, 0), player(20, 0, 0))
    blobs["area"] = 1
    assert players(blobs) == [0, 0, 0, 3]
    assert largest_left(picture(), 0) == -1


def test_ms34_the_largest_blob_alone_stands_for_a_player() -> None:
    """MS34: "combined" takes the box round all blobs of the player, and none of another's."""
    chest, head, other = player(0.0, 0.0, 10), player(12.0, 14.0, 4), player(-40.0, 0.0, 6)
    blobs = picture(chest, other, head)
    assert box(blobs, 0) == chest[:4]
    assert box(blobs, 0, player_blob="combined") == (head[0], chest[1], head[2], chest[3])
    assert box(blobs, 1) == box(blobs, 1, player_blob="combined") == other[:4]


@pytest.mark.parametrize("mode", ["largest", "combined"])
def test_a_mirrored_picture_has_mirrored_players(mode: str) -> None:
    rng = np.random.default_rng(2)
    for _ in range(200):
        blobs = picture(*(player(*rng.uniform(-40, 40, 2), *rng.integers(0, 9, 2)) for _ in range(4)))
        image = blobs.copy()
        image["left"], image["right"] = -blobs["right"], -blobs["left"]
        assert players(blobs) == players(image)
        for i in set(players(blobs)):
            left, right, high, low = box(blobs, i, player_blob=mode)
            assert box(image, i, player_blob=mode) == (-right, -left, high, low)
