"""Whom a learner meets: even opponents most often, past selves in turn, rated; how matches are shared among blocks."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccer_env.agents.perceptron import pack_policy
from soccer_env.leagues import find_league
from soccer_env.match.match import BLOCK
from soccer_env.train.ppo.curriculum import LEARNER, LEAST, Curriculum
from soccer_env.train.ppo.match_blocks import Result, split_matches
from soccer_env.train.ppo.networks import blank_policy
from soccer_env.train.ppo.settings import TrainSettings

SETTINGS = TrainSettings(hidden="8")
BLANK = blank_policy(SETTINGS, find_league("legged-2001"))
NAMES = ("still", "random", "chaser")


def curriculum(past: int = 0, names: tuple[str, ...] = NAMES) -> Curriculum:
    return Curriculum(names, past, BLANK)


def results(opponent: str, points: list[float]) -> list[Result]:
    return [Result((1, 1), opponent, int(share == 1.0), int(share == 0.0)) for share in points]


def policy_with(number: float) -> Any:
    return replace(BLANK, biases=tuple(np.full_like(bias, number) for bias in BLANK.biases))


def test_an_opponent_is_met_the_oftener_the_more_even_it_is() -> None:
    """Always beaten: p = 1, the least share alone is left. Even: p (1 - p) is largest. At first all are met alike."""
    made = curriculum()
    assert made.lineup.weights == pytest.approx([1 / 3] * 3)
    made.take(results("still", [1.0] * 500) + results("random", [1.0, 1.0, 0.0, 1.0] * 100))
    still, random, chaser = made.lineup.weights
    p = made.standings["random"].points
    assert 0.6 < p < 0.9
    assert still == pytest.approx(LEAST, rel=1e-4) == 0.1
    assert (random - LEAST) / (chaser - LEAST) == pytest.approx(4 * p * (1 - p), rel=1e-4)
    assert sum(made.lineup.weights) == pytest.approx(1.0)


def test_a_stage_meets_its_own_opponents_and_past_selves_none_less_than_a_tenth() -> None:
    made = curriculum(past=1)
    made.begin_stage(("random", "chaser"))
    made.take(results("random", [1.0] * 500))
    assert made.lineup.weights == pytest.approx([0.0, 0.1, 0.9, 0.0], abs=1e-3)
    made.add_past(BLANK, 48)
    assert made.lineup.weights == pytest.approx([0.0, 0.1, 0.45, 0.45], abs=1e-3)
    many = Curriculum([f"chaser@0.{number:02}" for number in range(20)], 0, BLANK)
    assert many.lineup.weights == pytest.approx([1 / 20] * 20)


def test_points_are_those_of_late() -> None:
    made = curriculum()
    made.take(results("still", [0.0] * 200))
    assert made.standings["still"].points < 0.01
    made.take(results("still", [1.0] * 60))
    assert made.standings["still"].points > 0.9
    assert made.standings["still"].episodes == 260 == made.standings[LEARNER].episodes


def test_a_past_self_that_does_not_exist_yet_is_never_met_and_without_any_none_is_kept() -> None:
    made = curriculum(past=2)
    assert made.lineup.weights[3:].tolist() == [0.0, 0.0]
    assert {made.lineup.choose(seed, 0) for seed in range(300)} == {0, 1, 2}
    made.add_past(BLANK, 48)
    assert made.lineup.weights[3] > 0.0 and made.lineup.weights[4] == 0.0
    assert {made.lineup.choose(seed, 0) for seed in range(300)} == {0, 1, 2, 3}
    alone = curriculum()
    alone.add_past(BLANK, 48)
    assert alone.names == list(NAMES)


def test_past_selves_together_weigh_as_much_as_one_opponent() -> None:
    made = curriculum(past=3)
    for step in (1, 2, 3):
        made.add_past(BLANK, step)
        assert made.lineup.weights[3:].sum() == pytest.approx(made.lineup.weights[0])


def test_the_oldest_past_self_gives_way() -> None:
    made = curriculum(past=2)
    for step, number in ((10, 1.0), (20, 2.0), (30, 3.0)):
        made.add_past(policy_with(number), step)
    assert made.filled == [30, 20]
    for team, number in zip(made.lineup.teams[3:], (3.0, 2.0)):
        assert team.settings.tobytes() == pack_policy(policy_with(number)).tobytes()
    made.add_past(policy_with(4.0), 40)
    assert made.filled == [30, 40]


def test_ratings_order_the_strong_above_the_weak() -> None:
    rng, made = np.random.default_rng(1), curriculum()
    chances = {"still": 0.95, "random": 0.5, "chaser": 0.05}
    for _ in range(300):
        name = str(rng.choice(NAMES))
        made.take(results(name, [float(rng.random() < chances[name])]))
    rating = {name: standing.mu for name, standing in made.standings.items()}
    assert rating["still"] < rating["random"] < rating["chaser"]
    assert rating["still"] < rating[LEARNER] < rating["chaser"]
    assert abs(rating["random"] - rating[LEARNER]) < 0.3 * (rating["chaser"] - rating["still"])


def test_a_draw_brings_ratings_together() -> None:
    made = curriculum()
    made.take(results("chaser", [0.0] * 10))
    before = made.standings["chaser"].mu - made.standings[LEARNER].mu
    made.take(results("chaser", [0.5] * 10))
    assert 0.0 < made.standings["chaser"].mu - made.standings[LEARNER].mu < before


def test_standings_survive_a_checkpoint() -> None:
    made, other = curriculum(past=2), curriculum(past=2)
    made.take(results("still", [1.0, 0.0, 1.0]) + results("chaser", [0.5]))
    made.add_past(policy_with(1.0), 48)
    state = made.state()
    made.take(results("random", [1.0] * 5))  # what was saved does not change with it
    made.add_past(policy_with(2.0), 96)
    other.restore(state)
    again = curriculum(past=2)
    again.take(results("still", [1.0, 0.0, 1.0]) + results("chaser", [0.5]))
    again.add_past(policy_with(1.0), 48)
    assert other.standings == again.standings and other.filled == again.filled
    assert other.lineup.weights.tobytes() == again.lineup.weights.tobytes()
    for own, theirs in zip(other.lineup.teams, again.lineup.teams):
        assert own.settings.tobytes() == theirs.settings.tobytes()


def test_every_size_has_as_many_robots_in_blocks_of_up_to_64_matches() -> None:
    assert BLOCK == 64
    assert split_matches([(3, 3)], 64) == [((3, 3), 64)]
    assert split_matches([(3, 3)], 129) == [((3, 3), 43)] * 3
    assert split_matches([(1, 1), (3, 1)], 8) == [((1, 1), 6), ((3, 1), 2)]
    assert split_matches([(1, 1), (2, 2)], 150) == [((1, 1), 50), ((1, 1), 50), ((2, 2), 50)]


@given(sizes=st.integers(1, 4), matches=st.integers(0, 2000))
def test_matches_add_up_and_no_block_is_empty_or_too_large(sizes: int, matches: int) -> None:
    players = [(size, size) for size in range(1, sizes + 1)]
    try:
        blocks = split_matches(players, matches)
    except ValueError as error:
        assert "at least one for each" in str(error)
        return
    assert sum(count for _, count in blocks) == matches
    assert all(1 <= count <= BLOCK for _, count in blocks)
    whole_share = sum(1.0 / home for home, _ in players)
    for player in players:
        whole = sum(count for size, count in blocks if size == player)
        assert abs(whole - matches / player[0] / whole_share) <= 1.0
