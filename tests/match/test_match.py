"""Match: its attributes, team sizes and padding, how episodes start and end, what a step pays, state and memory."""

import gc
import re
import tracemalloc
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, Rewards
from tests.scenes.staging import LEAGUES, play


def draw(match: Match, rng: np.random.Generator) -> np.ndarray:
    return rng.uniform(-1.0, 1.0, (match.count, len(match.agents), match.settings.actions.size))


def test_number_0_keeps_goal_when_a_team_has_two() -> None:
    assert Match(home=2, away=1, seed=1).robots["keeper"].tolist() == [[1, 0, 0]]
    assert Match(home=3, away=3, keeper=2, seed=1).robots["keeper"].tolist() == [[0, 0, 1, 0, 0, 1]]


@pytest.mark.parametrize("league", LEAGUES)
def test_padding_is_inactive_and_changes_nothing(league: str) -> None:
    small, padded = Match(league, home=2, away=1, seed=4), Match(league, home=2, away=1, max_players=4, seed=4)
    assert padded.robots["active"].tolist() == [[1, 1, 0, 0, 1, 0, 0, 0]]
    rng = np.random.default_rng(0)
    for _ in range(200):
        actions = rng.uniform(-1.0, 1.0, (1, 3, 4))
        wide = np.zeros((1, 8, 4))
        wide[:, [0, 1, 4]] = actions
        small.step(actions)
        padded.step(wide)
    np.testing.assert_array_equal(small.observations[0], padded.observations[0, [0, 1, 4]])


@pytest.mark.parametrize("mode", ["off", "next_step", "same_step"])
def test_matches_end_by_the_clock_and_start_again_as_told(mode: str) -> None:
    match = Match(home=1, away=1, matches=2, seed=1, minutes=0.1, autoreset=mode)
    ends = []
    for step in range(1, 201):
        _, _, terminated, truncated = match.step(np.zeros((2, 2, 4)))
        assert not truncated.any()
        if terminated.any():
            ends.append(step)
    expected = {"off": list(range(96, 201)), "next_step": [96, 193], "same_step": [96, 192]}  # 96 take 0.1 minutes
    assert ends == expected[mode]


def test_a_robot_is_taken_from_its_team_and_given_back() -> None:
    def played(taken: range) -> tuple[Match, list[float]]:
        match = Match(home=2, away=1, seed=1, senses="ideal", controllers={"home": "chaser", "away": "chaser"})
        forward = []
        for step in range(40):
            match.learns[1] = step in taken
            match.step(np.full((1, 3, 4), -0.5))
            forward.append(float(match.robots["command"]["forward"][0, 1]))
        return match, forward

    match, forward = played(range(10, 20))
    free, alone = played(range(0))
    assert forward[:10] == alone[:10] and forward[10:20] == [-0.5] * 10 and -0.5 not in forward[20:]
    assert match.squads[0].memory["kick"].shape == free.squads[0].memory["kick"].shape
    assert played(range(10, 20))[0].state_hash() == match.state_hash() != free.state_hash()


def test_action_repeat_adds_up_what_single_steps_pay() -> None:
    once = Match("middle-size-2006", home=2, away=2, seed=2)
    four = Match("middle-size-2006", home=2, away=2, seed=2, action_repeat=4)
    rng = np.random.default_rng(0)
    for _ in range(50):
        actions = draw(once, rng)
        paid = sum(once.step(actions, last=step == 3)[1].copy() for step in range(4))
        np.testing.assert_allclose(four.step(actions)[1], paid, atol=1e-12)
    assert once.state_hash() == four.state_hash()


def test_an_episode_of_one_goal_ends_at_the_goal() -> None:
    match = Match("middle-size-2006", home=1, away=1, seed=1, episode="goal")
    match.balls["x"], match.balls["vx"] = 5.9, 4.0
    match.balls["y"] = 0.3
    match.rebuild()
    for _ in range(10):
        _, rewards, terminated, _ = match.step(np.zeros((1, 2, 4)))
        if terminated[0]:
            break
    assert terminated[0] and match.matches["score"][0].tolist() == [1, 0]
    assert match.terms[0, 0, 0] == 1.0 and match.terms[0, 1, 0] == -1.0
    before = match.state_hash()
    match.step(np.ones((1, 2, 4)))
    assert not match.rewards.any(), "a match that is over pays nothing"
    assert before == match.state_hash() or not match.events["goal"][0] >= 0


def test_memory_stays_flat_over_thousands_of_resets() -> None:
    match = Match(home=1, away=1, seed=1)
    for _ in range(200):
        match.reset()
    gc.collect()
    tracemalloc.start()
    for _ in range(2000):
        match.reset()
    gc.collect()
    grown = tracemalloc.get_traced_memory()[0]
    tracemalloc.stop()
    assert grown < 200_000  # [bytes]


def test_a_ball_that_is_held_is_not_touched_and_steering_costs_nothing() -> None:
    match = Match("middle-size-2006", home=2, away=2, seed=1, placement="drive", minutes=1, rewards=Rewards(effort=1.0),
                  controllers={"home": "chaser", "away": "chaser"})  # fmt: skip
    placed = 0
    while not match.terminated[0]:
        match.step()
        if match.matches["placing"][0]:
            placed += 1
            assert not match.robot_events["touch"].any() or match.events["restart"][0]
            assert not match.terms[..., 3].any()
    assert placed > 0


SHAPES = {"M": 3, "R": 4, "(M,)": (3,), "(M, R)": (3, 4), "(R,)": (4,)}


@pytest.fixture(scope="module")
def match() -> Match:
    made = Match(home=2, away=2, matches=3, seed=1, autoreset="same_step", max_cycles=2, observe="belief")
    play(made, steps=2)
    return made


def told() -> dict[str, str]:
    """Return the attributes in the table of the docstring with the shape of each."""
    rows = re.findall(r"^ *\| (`.*?`) \| (.*?) ?\| ", Match.__doc__ or "", re.MULTILINE)
    found: dict[str, str] = {}
    for names, shapes in rows:
        found |= dict(zip(re.findall(r"`(\w+)`", names), re.split(r"(?<=\)), ", shapes), strict=False))
    return found


def test_every_attribute_in_the_table_is_there_in_its_shape(match: Match) -> None:
    found: dict[str, Any] = {name: getattr(match, name) for name in told()}
    assert {"final", "ended", "learns", "statistics", "observations", "settings"} <= set(found)
    wrong = [x for x, shape in told().items() if shape in SHAPES and np.shape(found[x]) != SHAPES[shape]]
    assert wrong == []
    assert match.observations.shape == (3, 4, len(match.observation_names))
    assert match.terms.shape == (3, 4, len(match.term_names))
    assert len(match.agents) == 4 and match.settings.rewards.gamma == 0.99
