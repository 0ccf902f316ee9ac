"""SplitMix64 in a record: the published sequence, independent streams, sound moments."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.random_numbers import GOLDEN, draw_normal, draw_uniform, mix_bits, seeds_for, start_streams
from soccer_env.types import NOISE_STREAMS, RobotStream

MASK = (1 << 64) - 1


def reference(state: int) -> int:
    """Return the next output of SplitMix64 in plain whole numbers, as published."""
    z = (state + 0x9E3779B97F4A7C15) & MASK
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


def test_the_sequence_is_the_published_one() -> None:
    published = [
        6457827717110365317, 3203168211198807973, 9817491932198370423, 4593380528125082431, 16408922859458223821,
    ]  # fmt: skip
    state, found = 1234567, []
    for _ in published:
        found.append(int(mix_bits(np.uint64((state + int(GOLDEN)) & MASK))))
        assert found[-1] == reference(state)
        state = (state + int(GOLDEN)) & MASK
    assert found == published


def test_uniform_and_normal_have_their_moments() -> None:
    noise = np.zeros(NOISE_STREAMS, np.uint64)
    start_streams(noise, np.uint64(7), 0, 0)
    flat = np.array([draw_uniform(noise, 0) for _ in range(100_000)])
    bell = np.array([draw_normal(noise, 1) for _ in range(100_000)])
    assert flat.min() >= 0.0 and flat.max() < 1.0
    assert abs(flat.mean() - 0.5) < 0.004 and abs(flat.var() - 1 / 12) < 0.001
    assert abs(bell.mean()) < 0.013 and abs(bell.std() - 1.0) < 0.01
    assert abs((bell**3).mean()) < 0.05 and abs((bell**4).mean() - 3.0) < 0.15
    for limit, share in ((1.0, 0.3173), (2.0, 0.0455), (3.0, 0.0027)):
        assert (abs(bell) > limit).mean() == pytest.approx(share, rel=0.05, abs=0.0006)
    assert abs(np.corrcoef(flat[:-1], flat[1:])[0, 1]) < 0.01


def test_streams_do_not_shift_each_other() -> None:
    one, two = np.zeros((2, NOISE_STREAMS), np.uint64)
    for noise in (one, two):
        start_streams(noise, np.uint64(1), 3, 2)
    for _ in range(10):
        draw_uniform(two, 5)
    assert [draw_uniform(one, 4) for _ in range(5)] == [draw_uniform(two, 4) for _ in range(5)]
    assert len({int(state) for state in one}) == NOISE_STREAMS


def test_all_streams_of_all_owners_differ() -> None:
    states = set()
    for seed, episode, owner in np.ndindex(4, 4, 23):
        noise = np.zeros(NOISE_STREAMS, np.uint64)
        start_streams(noise, np.uint64(seed), episode, owner)
        states |= {int(state) for state in noise}
    assert len(states) == 4 * 4 * 23 * NOISE_STREAMS


def test_no_two_robots_share_noise_nor_do_matches_or_episodes() -> None:
    match, states = Match(home=3, away=3, matches=3, seed=9), []
    for _ in range(2):
        states += [match.robots["noise"].ravel().copy(), match.matches["noise"].ravel().copy()]
        match.reset()
    everyone = np.concatenate(states)
    assert len(everyone) == 2 * 3 * (6 + 1) * NOISE_STREAMS == len(set(everyone.tolist()))


@pytest.mark.parametrize(
    ("one", "other"),
    [((0, 0), (0, 3)), ((0, 0), (0, 1)), ((0, 1), (0, 3)), ((0, 0), (1, 0))],
    ids=["home_0 and away_0", "home_0 and home_1", "home_1 and away_0", "home_0 of two matches"],
)
def test_streams_of_two_robots_are_unrelated(one: tuple[int, int], other: tuple[int, int]) -> None:
    noise = Match(home=3, away=3, matches=2, seed=9).robots["noise"]
    first, second = (np.array([draw_uniform(noise[m, r], 0) for _ in range(4000)]) for m, r in (one, other))
    assert not set(first) & set(second)
    assert abs(np.corrcoef(first, second)[0, 1]) < 4.0 / np.sqrt(4000)


def test_a_robot_draws_the_same_in_teams_of_any_size() -> None:
    small, large = Match(home=1, away=1, seed=9), Match(home=1, away=11, seed=9)
    np.testing.assert_array_equal(small.robots["noise"][0, 1], large.robots["noise"][0, 1])


def test_the_first_seeds_do_not_depend_on_how_many_there_are() -> None:
    assert seeds_for(3, 4).tolist() == seeds_for(3, 100)[:4].tolist()
    assert seeds_for(3, 4).tolist() == np.random.SeedSequence(3).generate_state(4, np.uint64).tolist()


@pytest.mark.parametrize("seed", [-1, 1.5, "7", True])
def test_a_seed_that_is_none_is_refused(seed: object) -> None:
    with pytest.raises(ValueError, match="seed must be a whole number of 0 or more"):
        seeds_for(seed, 2)  # type: ignore[arg-type]


def test_each_robot_draws_its_slip_from_a_stream_of_its_own() -> None:
    match = Match(home=3, away=3, seed=1)
    before = match.robots["noise"].copy()
    match.step(np.ones((1, 6, 4)))
    assert len(set(match.robots["slip"]["forward"][0].tolist())) == 6
    changed = np.flatnonzero((match.robots["noise"] != before).any(axis=(0, 1)))
    assert changed.tolist() == [int(RobotStream.SLIP)]
