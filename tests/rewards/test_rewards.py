"""Rewards: goals once and for the right team; shaping that cannot be farmed and leaks over nothing."""

import json
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, Rewards
from soccer_env.rewards import (
    KINDS,
    NAMES,
    POTENTIALS,
    PRESETS,
    TERMS,
    Term,
    earnings,
    find_rewards,
    make_reward_kernel,
)
from soccer_env.types import AWAY, HOME
from tests.scenes.staging import LEAGUES, endless, place, play, put, put_ball, scatter, set_phase, stage, stand

GOAL, PROGRESS, APPROACH, EFFORT = (NAMES.index(name) for name in ("goal", "progress", "approach", "effort"))
EVENTS = [column for column, term in enumerate(TERMS) if term.kind == "event"]
SHAPED = Rewards.only(progress=1.0, approach=1.0, gamma=1.0)


@pytest.mark.parametrize("league", LEAGUES)
def test_a_goal_pays_one_to_every_robot_of_the_team_and_costs_the_others_one_once(league: str) -> None:
    match = Match(league, home=2, away=3, seed=1, rewards="sparse")
    goal = match.league.pitch.length / 2
    put_ball(match, goal - 0.02, 0.0, 1.0)
    set_phase(match, 0)
    match.robots["y"] = 0.8 * match.league.pitch.width / 2
    match.robots["x"] = -goal + 0.5 + 0.6 * np.arange(5) * match.league.body.reach * 2
    match.rebuild()
    paid = np.zeros(5)
    for _ in range(match.league.control_rate):
        paid += match.step(stand(match))[1][0]
    assert paid.tolist() == [1.0, 1.0, -1.0, -1.0, -1.0]
    assert match.matches["score"][0].tolist() == [1, 0]


@pytest.mark.parametrize("league", LEAGUES)
def test_shaping_sums_to_zero_over_a_loop(league: str) -> None:
    """Whatever happens in between, only the first and the last state count: shuttling the ball farms nothing."""
    match = Match(league, home=3, away=3, matches=8, seed=2, rewards=SHAPED, controllers={"home": "random"})
    start = potentials(match)
    rng = np.random.default_rng(0)
    total = np.zeros((8, 6))
    for _ in range(600):  # restarts and goals included
        total += match.step(rng.uniform(-1.0, 1.0, (8, 6, 4)))[1]
    np.testing.assert_allclose(total, potentials(match) - start, atol=1e-9)


def potentials(match: Match) -> np.ndarray:
    """Return progress plus approach for each robot (M, R), worked out from the records by other means."""
    pitch, ball, robots = match.league.pitch, match.balls, match.robots
    found = np.zeros(robots.shape)
    for m in range(match.count):
        for r, robot in enumerate(robots[m]):
            side = match.matches["home_direction"][m] * (1 if robot["team"] == 0 else -1)
            ahead = np.hypot(ball["x"][m] - side * pitch.length / 2, ball["y"][m])
            behind = np.hypot(ball["x"][m] + side * pitch.length / 2, ball["y"][m])
            mates = [other for other in robots[m] if other["team"] == robot["team"] and other["active"]]
            nearest = min(np.hypot(other["x"] - ball["x"][m], other["y"] - ball["y"][m]) for other in mates)
            found[m, r] = (behind - ahead) / (2 * pitch.length) - nearest / np.hypot(pitch.length, pitch.width)
    return found


def test_shaping_does_not_leak_over_a_reset() -> None:
    fresh, used = Match(home=1, away=1, seed=3, rewards=SHAPED), Match(home=1, away=1, seed=1, rewards=SHAPED)
    play(used, steps=50, actions=np.ones((1, 2, 4)))
    used.reset(seed=3)
    np.testing.assert_array_equal(fresh.step(np.ones((1, 2, 4)))[1], used.step(np.ones((1, 2, 4)))[1])


@pytest.mark.parametrize("mode", ["same_step", "next_step"])
def test_shaping_does_not_leak_over_an_autoreset(mode: str) -> None:
    match = Match(home=1, away=1, seed=3, rewards=SHAPED, max_cycles=7, autoreset=mode)
    rng = np.random.default_rng(0)
    for _ in range(40):
        step, before = match.matches["step"][0], potentials(match)
        match.step(rng.uniform(-1.0, 1.0, (1, 2, 4)))
        if match.matches["step"][0] > step:
            np.testing.assert_allclose(match.rewards, potentials(match) - before, atol=1e-12)


def test_the_potential_of_a_finished_episode_is_zero() -> None:
    match = Match(home=1, away=1, seed=3, rewards=SHAPED, minutes=0.01)
    total = np.zeros((1, 2))
    start = potentials(match)
    while not match.terminated[0]:
        total += match.step(np.ones((1, 2, 4)))[1]
    np.testing.assert_allclose(total, -start, atol=1e-12)


def test_the_terms_add_up_and_weights_scale_them() -> None:
    scale = 2.0 + np.arange(len(NAMES))
    heavy = Rewards(**{term.name: factor * term.weight for term, factor in zip(TERMS, scale, strict=True)})
    one, two = Match(seed=1), Match(seed=1, rewards=heavy)
    rng = np.random.default_rng(0)
    for _ in range(100):
        actions = rng.uniform(-1.0, 1.0, (1, 6, 4))
        one.step(actions)
        two.step(actions)
        np.testing.assert_allclose(one.terms.sum(axis=-1), one.rewards, atol=1e-12)
        np.testing.assert_allclose(one.terms * scale, two.terms, atol=1e-12)


def test_effort_is_the_mean_square_of_the_clipped_command_and_sparse_rewards_are_events_alone() -> None:
    match = Match(home=1, away=1, seed=1)
    match.step(np.array([[[9.0, -0.5, 0.5, 1.0], [0.0, 0.0, 0.0, 1.0]]]))
    assert match.terms[0, 0, EFFORT] == pytest.approx(-0.0005 / 16 * (1.0 + 0.25 + 0.25) / 3)
    assert match.terms[0, 1, EFFORT] == 0.0
    match = Match(seed=1, rewards="sparse", matches=4)
    scatter(match, np.random.default_rng(0))
    match.rebuild()
    for _ in range(20):
        match.step(np.ones((4, 6, 4)))
        assert not np.delete(match.terms, EVENTS, axis=-1).any()
        assert (match.terms[:, :, EVENTS].sum(axis=-1) == match.rewards).all()
    assert find_rewards("sparse").goal == 1.0


@pytest.mark.parametrize("league", LEAGUES)
def test_effort_costs_its_weight_a_second_at_every_control_rate(league: str) -> None:
    match = Match(league, home=1, away=1, seed=1, rewards=Rewards.only(effort=0.6))
    actions = np.array([[[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0]]])
    paid = sum(match.step(actions)[1][0].copy() for _ in range(match.league.control_rate))
    assert paid == pytest.approx([-0.6 / 3.0, 0.0])


def test_a_minute_of_walking_pays_as_listed_and_a_tenth_of_a_goal_outweighs_it(soccer: Any) -> None:
    match = Match("middle-size-2006", home=1, away=1, seed=1, rules="none", rewards=Rewards.only(effort=0.0005))
    actions = np.array([[[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0]]])
    paid = sum(match.step(actions)[1][0, 0] for _ in range(60 * match.league.control_rate))
    assert paid == pytest.approx(earnings(PRESETS["default"], "walks")["effort"]) == pytest.approx(-0.01)
    for name in ("default", "training"):
        assert not any(earnings(PRESETS[name], "stands").values())
        walks, wins = (earnings(PRESETS[name], player) for player in ("walks", "wins"))
        assert -walks["sum"] < 0.1 * PRESETS[name].goal and wins["sum"] > 0.9 * wins["goal"] > 0.0
    (table,) = [table for table in json.loads(soccer("list", "rewards", "--json")) if "Earnings" in table["title"]]
    effort, total = table["rows"][1], table["rows"][-1]
    assert effort["term"], total["term"] == ("effort", "sum")
    assert [effort[f"default: {player}"] for player in ("stands", "walks", "wins")] == ["0", "-0.01", "-0.01"]
    assert [total[f"default: {player}"] for player in ("stands", "walks", "wins")] == ["0", "-0.01", "0.19"]


def test_progress_is_lost_by_the_other_team_and_approach_rewards_the_nearest_robot() -> None:
    match = stage(endless("middle-size-2006"), rewards=Rewards(gamma=1.0))
    place(match, ball=(0.0, 0.0, 3.0), robots={0: (-3.0, 3.0), 1: (3.0, -3.0)})
    match.step(stand(match))
    ours, theirs = match.terms[0, :, PROGRESS]
    assert ours == pytest.approx(-theirs) and ours > 0.0
    match = stage("middle-size-2006", home=2, away=1, rewards=Rewards(gamma=1.0))
    for r, x in enumerate((-3.0, -1.0, 2.0)):
        put(match, r, x, 0.5, forward=1.0 if r == 1 else 0.0)
    match.rebuild()
    match.step(np.array([[[0.0] * 4, [0.4, 0, 0, 0], [0.0] * 4]]))
    assert match.terms[0, 0, APPROACH] == match.terms[0, 1, APPROACH] > 0.0 == match.terms[0, 2, APPROACH]


@pytest.mark.parametrize(("bad", "message"), [
    ({"goal": np.nan}, r"Rewards\.goal"), ({"progress": "much"}, r"Rewards\.progress"),
    ({"gamma": 1.5}, r"Rewards\.gamma"), ({"extra": {"goal": len}}, r"Rewards\.extra"),
    ({"effort": 1.7e308}, r"Rewards\.effort must be -1000000000 to 1000000000, got 1.7e\+308"),
    ({"goals": 1.0}, f"'goals'.*known: {', '.join(NAMES)}, gamma, extra"),
])  # fmt: skip
def test_bad_weights_are_refused_by_name(bad: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Rewards(**bad)


@pytest.mark.parametrize("repeat", [1, 8])
def test_shaping_of_a_kept_action_discounts_once(repeat: int) -> None:
    rewards = Rewards.only(progress=1.0, gamma=0.9)
    match = Match("legged-2001", home=1, away=1, seed=1, action_repeat=repeat, rewards=rewards)
    match.balls["x"], match.balls["y"] = -1.0, 0.0
    match.robots["x"], match.robots["y"] = [[0.0, 0.5]], [[0.8, 0.8]]
    match.rebuild()
    half, length = 0.5 * match.league.pitch.length, match.league.pitch.length
    potential = ((half - 1.0) - (half + 1.0)) / (2.0 * length)
    _, paid, _, _ = match.step(np.zeros((1, 2, 4)))
    assert paid[0, 0] == pytest.approx((0.9 - 1.0) * potential)
    assert paid[0, 1] == pytest.approx((0.9 - 1.0) * -potential)


def test_weights_infos_presets_and_lists_follow_from_the_table(soccer: Any) -> None:
    assert {term.kind for term in TERMS} <= set(KINDS)
    assert sum(term.kind == "potential" for term in TERMS) == POTENTIALS[1]
    for term in TERMS:
        assert getattr(Rewards(), term.name) == term.weight
        assert getattr(PRESETS["sparse"], term.name) == (term.weight if term.kind == "event" else 0.0)
    assert Match(home=1, away=1, seed=1).term_names == [term.name for term in TERMS]
    printed = soccer("list", "rewards")
    assert all(term.name in printed for term in TERMS) and all(name in printed for name in PRESETS)


def test_a_kernel_follows_from_any_table() -> None:
    another = Term("another", "one more potential", TERMS[PROGRESS].function, "potential", 1.0)
    pay = make_reward_kernel((TERMS[EFFORT], TERMS[PROGRESS], another, TERMS[GOAL]))
    match = stage("legged-2001", home=1, away=1)
    match.robots["command"]["forward"] = 0.5
    match.events["goal"] = 1
    weights = np.array([((3.0, 2.0, 5.0, 7.0), 0.5)], [("term", "f8", (4,)), ("gamma", "f8")])
    before, after = np.array([[1.0, 4.0], [2.0, 8.0]]), np.array([[3.0, 6.0], [8.0, 6.0]])
    records = (match.matches[0], match.balls[0], match.robots[0], match.events[0], match.robot_events[0])
    paid = np.zeros((2, 4))
    pay(*records, match.settings.constants()[0], before, after, weights[0], paid)
    cost = -3.0 * 0.25 / 3.0 * match.league.dt
    assert paid[HOME].tolist() == [cost, 2.0 * (1.5 - 1.0), 5.0 * (3.0 - 4.0), -7.0]
    assert paid[AWAY].tolist() == [cost, 2.0 * (4.0 - 2.0), 5.0 * (3.0 - 8.0), 7.0]
