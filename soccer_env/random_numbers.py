"""The small-state generator that lives in match and robot records.

SplitMix64 [Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators"]: a 64-bit counter that advances
by an odd constant, and a mixing function over it. One counter for each named stream, so that a new noise source takes
a stream of its own and never shifts the others; each robot has its own streams, so that it draws the same numbers in a
match of any size. Seeds come from `numpy.random.SeedSequence`.
"""

from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.types import NOISE_STREAMS

GOLDEN = np.uint64(0x9E3779B97F4A7C15)  # the counter's step
MIX_1 = np.uint64(0xBF58476D1CE4E5B9)
MIX_2 = np.uint64(0x94D049BB133111EB)
TO_UNIT = 1.0 / 9007199254740992.0  # 2**-53
BYTES = np.uint64(0x00FF00FF00FF00FF)  # every other byte
ONES = np.uint64(0x0001000100010001)  # a multiplication by it puts the sum of all four into the top 16 bits
MIDDLE = 8.0 * 127.5 + 0.5  # mean of the sum of eight bytes, and of a share of one
UNIT = (12.0 / (8.0 * 65535.0)) ** 0.5  # one over the deviation of that sum
LINEAR, CUBIC = 0.9784677909, 0.0075083429  # for a deviation of 1 and a fourth moment of 3


@compiled
def mix_bits(value):
    """Return 64 pseudorandom bits: the mixing function of SplitMix64 on a 64-bit counter."""
    value = (value ^ (value >> np.uint64(30))) * MIX_1
    value = (value ^ (value >> np.uint64(27))) * MIX_2
    return value ^ (value >> np.uint64(31))


@compiled
def bits_to_unit_interval(bits):
    """Convert 64 random bits to a number in [0, 1)."""
    return np.float64(bits >> np.uint64(11)) * TO_UNIT


@compiled
def draw_uniform(noise, stream):
    """Draw a number from [0, 1) with stream `stream` of the states `noise` (NOISE_STREAMS,)."""
    noise[stream] = noise[stream] + GOLDEN
    return np.float64(mix_bits(noise[stream]) >> np.uint64(11)) * TO_UNIT


@compiled
def draw_normal(noise, stream):
    """Draw an approximately normal number of mean 0 and deviation 1: the sum of the eight bytes of one random draw.

    A cubic makes the first five moments those of the normal distribution. Ten times cheaper than a logarithm and a
    cosine; no value lies beyond 5.6.
    """
    noise[stream] = noise[stream] + GOLDEN
    bits = mix_bits(noise[stream])
    pairs = (bits & BYTES) + ((bits >> np.uint64(8)) & BYTES)  # four sums of two, each in 16 bits
    share = np.float64(bits >> np.uint64(11)) * TO_UNIT  # between two sums: no two draws are equal
    x = (np.float64((pairs * ONES) >> np.uint64(48)) + share - MIDDLE) * UNIT
    return x * (LINEAR + CUBIC * x * x)


@compiled
def start_streams(noise, seed, episode, owner):
    """Start all streams of a record from a seed, the episode's number and the record's owner.

    The owner is 0 for the match and 1 + 2 number + team for a robot, independent of the size of teams.
    """
    key = mix_bits(np.uint64(seed) + GOLDEN * np.uint64(episode + 1))
    key = mix_bits(key ^ (GOLDEN * np.uint64(owner + 1)))
    for stream in range(NOISE_STREAMS):
        noise[stream] = mix_bits(key + MIX_1 * np.uint64(stream + 1))


def check_seeds(seeds: Any, matches: int) -> np.ndarray:
    """Check the seeds of M matches and return them as (M,) uint64; ValueError for anything else."""
    given = np.asarray(seeds, object)  # Python's own: numpy makes floats of a list of large and small ones
    whole = all(isinstance(seed, (int, np.integer)) and not isinstance(seed, bool) for seed in given.ravel())
    if given.shape != (matches,) or not whole or not all(0 <= seed < 1 << 64 for seed in given):
        raise ValueError(f"seeds must be {matches} whole numbers of 0 or more below 2**64, got {seeds!r}")
    return given.astype(np.uint64)


def seeds_for(seed: int | None, matches: int) -> np.ndarray:
    """Return the (matches,) uint64 seeds that follow from one seed; the first n do not depend on `matches`.

    `seed` None: take entropy from the system. ValueError if the seed is not a whole number of 0 or more.
    """
    if seed is not None and (isinstance(seed, bool) or not isinstance(seed, (int, np.integer)) or seed < 0):
        raise ValueError(f"seed must be a whole number of 0 or more, got {seed!r}")
    return np.random.SeedSequence(seed).generate_state(matches, np.uint64)
