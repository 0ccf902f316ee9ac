"""Variation: factors of a league's numbers, drawn for each episode from the match's own seed."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match, soccer_v0
from soccer_env.replay import Recorder, Replay

KICK = {"kicker.fastest": (0.6, 1.4)}
MANY = {
    "ball.mass": (0.5, 2.0), "materials.ball_robot.elasticity": (0.5, 1.5), "drive.forward": (0.7, 1.3),
    "drive.delay": (0.0, 2.0), "sensors.ball_miss": (0.0, 5.0), **KICK,
}  # fmt: skip


def make(league: str = "middle-size-2006", **settings: Any) -> Match:
    return Match(league, home=2, away=2, controllers={"home": "chaser", "away": "chaser"}, **{"seed": 3} | settings)


def play(match: Match, steps: int = 150) -> str:
    for _ in range(steps):
        match.step(None)
    return match.state_hash()


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_each_match_draws_its_own_factors_from_its_seed(league: str) -> None:
    match, again = (make(league, matches=6, variation=MANY) for _ in range(2))
    for name, (low, high) in MANY.items():
        factors = match.variation[name]
        assert low <= factors.min() < factors.max() <= high
        assert (factors == again.variation[name]).all()
    before = {name: factors.copy() for name, factors in match.variation.items()}
    match.reset()
    assert all((before[name] != factors).all() for name, factors in match.variation.items())


def test_distributions_of_a_range() -> None:
    """Of 4000 episodes: a log range has its median at the geometric mean, a bell most in the middle half."""
    ranges = {"kicker.fastest": (0.5, 2.0, "even"), "drive.delay": (0.5, 2.0, "log"), "ball.mass": (0.5, 2.0, "bell")}
    variation = make(variation=ranges).settings.variation
    assert variation is not None and variation.plain["kicker.fastest"] == [0.5, 2.0]
    drawn = np.array([list(variation.factors({"seed": 3, "episode": e}).values()) for e in range(4000)])
    assert drawn.min() >= 0.5 and drawn.max() <= 2.0
    assert np.median(drawn, axis=0) == pytest.approx([1.25, 1.0, 1.25], abs=0.05)
    middle = ((drawn > 0.875) & (drawn < 1.625)).mean(axis=0)
    assert middle == pytest.approx([0.5, np.log2(1.625 / 0.875) / 2.0, 0.6827 / 0.9545], abs=0.03)


def test_light_is_drawn_itself() -> None:
    match = make(matches=20, senses="sensors", variation={"sensors.light_drift": (0.2, 0.4)})
    assert 0.2 <= match.variation["sensors.light_drift"].min() < match.variation["sensors.light_drift"].max() <= 0.4
    for _ in range(200):
        match.step(None)
    assert match.percepts["light"].std() > 0.05, "each match has a phase of its own"


def test_factor_one_is_the_league_itself() -> None:
    ones = dict.fromkeys(MANY, (1.0, 1.0))
    assert make(variation={"ball.mass": 2}).settings.variation.plain == {"ball.mass": [2.0, 2.0]}
    assert play(make(matches=3, variation=ones)) == play(make(matches=3))
    assert play(make(matches=3, variation={})) == play(make(matches=3))


@pytest.mark.parametrize("name", MANY)
def test_each_number_changes_play(name: str) -> None:
    high = {name: (MANY[name][1],) * 2}
    assert play(make(matches=2, variation=high), 400) != play(make(matches=2), 400)


def test_threads_backends_and_row_of_the_match_change_nothing() -> None:
    seeds = np.arange(4, dtype=np.uint64)
    hashes = {
        play(make(matches=4, seed=None, seeds=seeds, variation=MANY, **settings))
        for settings in ({}, {"threads": 2}, {"backend": "batch"})
    }
    assert len(hashes) == 1
    alone = make(matches=1, seed=None, seeds=seeds[2:3], variation=MANY)
    together = make(matches=4, seed=None, seeds=seeds, variation=MANY)
    play(alone), play(together)
    assert alone.balls[0].tobytes() == together.balls[2].tobytes()


def test_a_save_goes_on_with_the_numbers_of_its_episode() -> None:
    match, other = make(matches=3, variation=MANY), make(matches=3, variation=MANY)
    play(match)
    other.reset(seed=99)
    other.load(match.save())
    assert all((other.variation[name] == factors).all() for name, factors in match.variation.items())
    assert play(other) == play(match)
    with pytest.raises(ValueError, match="variation"):
        make(matches=3).load(match.save())


def test_a_replay_repeats_the_variation(tmp_path: Any) -> None:
    match = make(matches=2, variation=MANY)
    recorder = Recorder(match)
    play(match, 100)
    path = recorder.stop().write(tmp_path / "varied.replay")
    assert Replay.read(path).check() == 100


def standing_share(rates: dict[str, float], seconds: float) -> np.ndarray:
    """Return for each robot of 40 matches and each moment whether random actions do not move it."""
    ranges = {f"faults.{name}": (rate, rate) for name, rate in rates.items()}
    match = Match("middle-size-2006", home=2, away=2, matches=40, seed=7, rules="none", variation=ranges)
    wheel = np.tile([0.0, 0.0, 1.0, 0.0], (40, 4, 1))
    stands = []
    for _ in range(round(seconds / match.league.dt)):
        match.step(wheel)
        stands.append(np.abs(match.robots["omega"]) < 1e-3)
    return np.array(stands)[10:]  # once they turn


@pytest.mark.slow
def test_robots_drop_out_as_often_as_said_and_come_back() -> None:
    stands = standing_share({"dropouts": 3.0}, 60.0)
    assert stands.mean() == pytest.approx(3.0 * 5.0 / 60.0, abs=0.03)
    starts = (np.diff(stands.astype(int), axis=0) == 1).sum(axis=0)
    assert starts.max() >= 2 and starts.min() < starts.max(), "each robot by its own time"
    assert not stands.all(axis=0).any()


@pytest.mark.slow
def test_robots_that_broke_down_stand_to_the_end_of_the_episode() -> None:
    stands = standing_share({"breakdowns": 2.0}, 30.0)
    assert stands[-1].mean() == pytest.approx(1.0 - np.exp(-1.0), abs=0.12)
    assert (np.diff(stands.astype(int), axis=0) >= 0).all(), "none comes back"
    assert standing_share({"dropouts": 0.0}, 2.0).sum() == 0


def test_a_failed_taker_does_not_hold_up_a_restart() -> None:
    match = make(variation={"faults.breakdowns": (1000.0, 1000.0)}, placement="drive", minutes=1.0)
    while not match.terminated.all():
        match.step()
    assert match.matches["over"].all() and (match.robots["vx"] == 0.0).all()


def test_infos_tell_the_factors() -> None:
    env = soccer_v0.parallel_env(league="middle-size-2006", home=1, away=1, variation=KICK)
    _, infos = env.reset(seed=5)
    factor = infos["home_0"]["variation_kicker.fastest"]
    assert 0.6 <= factor <= 1.4
    assert factor == env.unwrapped.match.variation["kicker.fastest"][0]


def test_observations_do_not_show_the_factors() -> None:
    fast = make(observe="truth", variation={"drive.forward": (1.0, 1.0)})
    slow = make(observe="truth", variation={"drive.forward": (0.5, 0.5)})
    assert (fast.batch.observations == slow.batch.observations).all()


@pytest.mark.parametrize(
    ("variation", "words"),
    [
        ({"ball.mas": (0.5, 1.0)}, "did you mean 'ball.mass'"),
        ({"pitch.length": (0.5, 1.0)}, "unknown variation"),
        ({"faults.dropouts": (0.0, 13.0)}, "out of the league's ranges"),
        ({"ball.mass": "2"}, "two factors, low and high"),
        ({"ball.mass": (2.0, 1.0)}, "the lower first"),
        ({"ball.mass": (float("nan"), 1.0)}, "the lower first"),
        ({"ball.mass": (0.0, 1.0)}, "out of the league's ranges"),
        ({"sensors.ball_miss": (0.0, 500.0)}, "out of the league's ranges"),
        ("ball.mass", "a mapping of names"),
        ({"ball.mass": (0.5, 2.0, "lgo")}, "one of even, log, bell"),
        ({"sensors.ball_miss": (0.0, 2.0, "log")}, "above 0, as their distribution is log"),
        ({"sensors.light_drift": (0.0, 1.5)}, "out of the league's ranges"),
    ],
)
def test_wrong_variations_say_what_exists(variation: Any, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        make(variation=variation)
