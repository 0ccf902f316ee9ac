"""Group the blobs of one jersey colour into players.  [Sacks 2001, 4.1.1, 4.1.2]  MS29, MS34

A jersey has several stickers, so two red blobs may be one player or two. A blob belongs to the player of a larger blob
if the two are closer than `grouping` times the size of the larger one:

        +---+                  +-----+
        | B |  - - gap - - -   |  A  |      B is part of A's player if gap < 3 x mean(width, height) of A
        +---+                  +-----+

The factor of three errs on the side of one player: it is better to miss a player that stands behind another than to
see a ghost, which may take the memory slot of a player that is really there.

The gap counts from middle to middle: vision delivers each blob's "size and position" (section 2), and the distance
between two positions is the literal reading. Counted from edge to edge, more blobs would join at the same factor.

`w`: settings of the memory.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.leagues.legged_sensors import PLAYER_BLOBS
from soccer_env.records.percepts import BLOBS

COMBINED = PLAYER_BLOBS["combined"]
SMALLEST = 1.0  # [px] a blob has a pixel at least, whatever its box says


@compiled
def blob_size(blob):
    """Return the size of a blob [px]: the mean of its width and height, linear in its dimensions.  MS29, footnote 6

    A blob's area falls with the square of its distance, but the gaps between a player's blobs do not.
    """
    width, height = int(blob.left) - int(blob.right), int(blob.high) - int(blob.low)
    return max(0.5 * (width + height), SMALLEST)


@compiled
def is_larger(blobs, i, j):
    """Tell whether blob i ranks before blob j: by size, then by area, then by index."""
    one, other = blob_size(blobs[i]), blob_size(blobs[j])
    if one != other:
        return one > other
    if blobs[i].area != blobs[j].area:
        return blobs[i].area > blobs[j].area
    return i < j


@compiled
def distance_between_blobs(one, other):
    """Return the distance between the centres of two blobs [px]."""
    aside = 0.5 * (int(one.left) + int(one.right) - int(other.left) - int(other.right))
    above = 0.5 * (int(one.high) + int(one.low) - int(other.high) - int(other.low))
    return length(aside, above)


@compiled
def largest_ungrouped_blob(blobs, done):
    """Return the index of the largest blob not yet grouped (its bit in `done` is 0), -1 if there is none."""
    largest = -1
    for i in range(BLOBS):
        if blobs[i].area > 0 and done & (1 << i) == 0 and (largest < 0 or is_larger(blobs, i, largest)):
            largest = i
    return largest


@compiled
def largest_blob_of_player(blobs, i, grouping):
    """Return the index of the largest blob of the player that blob i belongs to, perhaps i.  MS29

    A blob near another blob of a player belongs to that player.
    """
    larger = larger_blob_nearby(blobs, i, grouping)
    while larger >= 0:
        i = larger
        larger = larger_blob_nearby(blobs, i, grouping)
    return i


@compiled
def larger_blob_nearby(blobs, i, grouping):
    """Return the index of the largest blob that is near blob i and larger than blob i, -1 if there is none.  MS29"""
    largest = -1
    for j in range(BLOBS):
        if blobs[j].area <= 0 or not is_larger(blobs, j, i):
            continue
        if largest >= 0 and not is_larger(blobs, j, largest):
            continue
        if distance_between_blobs(blobs[i], blobs[j]) < grouping * blob_size(blobs[j]):
            largest = j
    return largest


@compiled
def box_of_player(blobs, i, w):
    """Return the bounding box [px] of the player whose largest blob is i: left, right, high, low.  MS34

    The default is that blob's box alone: when a player walks away, its head stickers vanish, and a box round all its
    blobs would suddenly be half as high. With `player_blob` "combined" the box encloses all the player's blobs.
    """
    left, right, high, low = int(blobs[i].left), int(blobs[i].right), int(blobs[i].high), int(blobs[i].low)
    if w.player_blob == COMBINED:
        for j in range(BLOBS):
            if j != i and blobs[j].area > 0 and largest_blob_of_player(blobs, j, w.grouping) == i:
                left, right = max(left, int(blobs[j].left)), min(right, int(blobs[j].right))
                high, low = max(high, int(blobs[j].high)), min(low, int(blobs[j].low))
    return left, right, high, low
