"""A function of observations plays as a team: what it is given, when it is asked, and what it remembers."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, soccer_v0, team_of_function
from soccer_env.agents.learned import team_from_policy
from soccer_env.replay import Recorder
from tests.agents.staged_policies import random_policy
from tests.scenes.staging import play, record_each_step


def by_numbers(policy: Any) -> Any:
    """Return a policy's network as a function of observations (..., n), in numpy."""

    def play(observations: np.ndarray) -> np.ndarray:
        values = observations.astype(np.float64)
        for weight, bias in zip(policy.weights[:-1], policy.biases[:-1], strict=True):
            values = np.tanh(values @ weight.T.astype(np.float64) + bias)
        return values @ policy.weights[-1].T.astype(np.float64) + policy.biases[-1]

    return play


def ahead(observations: np.ndarray) -> np.ndarray:
    actions = np.zeros((*observations.shape[:-1], 4), np.float32)
    actions[..., 0] = 1.0
    return actions


def counting(observations: np.ndarray, memory: np.ndarray) -> np.ndarray:
    """Count the decisions, and walk to the left from the third one on."""
    memory += 1.0
    actions = np.zeros((*observations.shape[:-1], 4))
    actions[..., 1] = memory[..., 0] >= 3.0
    return actions


COUNTS = {"memory": ("f4", (1,)), "name": "counting"}


@pytest.mark.parametrize("side", ["home", "away"])
@pytest.mark.parametrize(
    ("league", "observe", "senses"),
    [
        ("legged-2001", "belief", "sensors"), ("legged-2001", "percepts", "sensors"), ("legged-2001", "truth", "ideal"),
        ("middle-size-2006", "belief", "ideal"), ("middle-size-2006", "percepts", "sensors"),
    ],
)  # fmt: skip
def test_it_plays_what_the_same_policy_plays_from_a_file(league: str, observe: str, senses: str, side: str) -> None:
    policy = random_policy(8, league=league, observe=observe, action_repeat=4, mirror=False)
    other = "away" if side == "home" else "home"
    mine = team_of_function(by_numbers(policy), observe=observe, action_repeat=4)
    settings: dict[str, Any] = {"home": 2, "away": 2, "matches": 3, "seed": 1, "senses": senses}
    ours = Match(league, controllers={side: team_from_policy(policy, at_once=True), other: "chaser"}, **settings)
    match = Match(league, controllers={side: mine, other: "chaser"}, **settings)
    for _ in range(60):
        ours.step()
        match.step()
    assert np.abs(match.robots["command"]["forward"] - ours.robots["command"]["forward"]).max() < 1e-9
    assert np.abs(match.balls["x"] - ours.balls["x"]).max() < 1e-9
    assert len(np.unique(match.robots["command"]["forward"])) > 4


def test_it_is_asked_once_for_each_repeat_with_the_matches_that_are_due() -> None:
    seen: list[tuple[int, ...]] = []

    def note(observations: np.ndarray) -> np.ndarray:
        seen.append(observations.shape)
        return ahead(observations)

    match = Match(home=2, away=3, matches=5, controllers={"away": team_of_function(note, action_repeat=8)}, seed=1)
    play(match, steps=17)
    assert [shape[:2] for shape in seen] == [(5, 3)] * 3
    assert (match.robots["command"]["forward"][:, 2:] == 1.0).all()


def test_decisions_in_the_rhythm_of_soccer_vec_env_come_a_delay_early() -> None:
    match = Match(home=1, away=1, opponents=team_of_function(ahead, action_repeat=8, at_once=False), seed=1)
    forward = record_each_step(match, lambda: match.robots["command"]["forward"][0, 1], steps=12)
    first = -match.league.delay_steps % 8
    assert forward.tolist() == [0.0] * first + [1.0] * (12 - first)


def test_flat_functions_get_a_row_for_each_player() -> None:
    seen: list[tuple[int, ...]] = []

    def note(observations: np.ndarray, memory: np.ndarray) -> np.ndarray:
        seen.append((*observations.shape[:1], *memory.shape))
        return counting(observations, memory)

    team = team_of_function(note, flat=True, **COUNTS)
    square = team_of_function(counting, **COUNTS)
    matches = [Match(home=3, away=1, matches=2, opponents="still", teammates=one, seed=1) for one in (team, square)]
    for match in matches:
        play(match, steps=5)
    assert set(seen) == {(4, 4, 1)}
    assert (matches[0].robots["command"]["left"] == matches[1].robots["command"]["left"]).all()
    assert (matches[0].robots["command"]["left"][:, :2] == 1.0).all()


@pytest.mark.parametrize("index", [0, 7, 10])
def test_whole_numbers_are_discrete_actions(index: int) -> None:
    team = team_of_function(lambda seen: np.full(seen.shape[:2], index))
    match = Match(home=1, away=1, opponents=team, actions="discrete", seed=1)
    match.step(np.full((1, 2), index))
    assert match.robots["command"][0, 0].tobytes() == match.robots["command"][0, 1].tobytes()


def test_seven_numbers_move_the_head_and_all_are_clipped() -> None:
    team = team_of_function(lambda seen: np.full((*seen.shape[:2], 7), 3.0))
    match = Match(home=1, away=1, opponents=team, seed=1)
    match.step(np.zeros((1, 2, 4)))
    assert all(value == 1.0 for value in match.robots["command"][0, 1].item())


def test_tensors_of_torch_are_taken_off_their_graph() -> None:
    torch = pytest.importorskip("torch")
    network = torch.nn.Linear(100, 4)
    team = team_of_function(lambda seen: torch.tanh(network(torch.as_tensor(seen))))
    match = Match(home=1, away=1, controllers={"home": team, "away": team}, seed=1)
    match.step()
    assert match.robots["command"]["turn"].all()


def test_memory_is_saved_hashed_and_empty_when_an_episode_begins() -> None:
    team = team_of_function(counting, **COUNTS)
    match = Match(home=1, away=1, matches=2, controllers={"home": team, "away": "chaser"}, seed=1)
    for _ in range(2):
        match.step()
    saved = match.save()
    future = [(match.step(), match.state_hash())[1] for _ in range(5)]
    assert match.squads[0].memory["own"].tolist() == [[[7.0]], [[7.0]]]
    match.load(saved)
    assert [(match.step(), match.state_hash())[1] for _ in range(5)] == future
    match.reset()
    assert not match.squads[0].memory["own"].any()
    rarer = team_of_function(counting, action_repeat=2, **COUNTS)
    other = Match(home=1, away=1, matches=2, seed=1, controllers={"home": rarer, "away": "chaser"})
    with pytest.raises(ValueError, match="teams differ: of other settings"):
        other.load(saved)


def test_a_match_with_it_pickles_copies_and_is_replayed() -> None:
    team = team_of_function(counting, **COUNTS)
    match = Match(home=2, away=2, controllers={"home": team, "away": "chaser"}, seed=1)
    recorder = Recorder(match)
    for _ in range(4):
        match.step()
    copies = [pickle.loads(pickle.dumps(match)), copy.deepcopy(match)]
    for _ in range(6):
        for one in (match, *copies):
            one.step()
    assert {one.state_hash() for one in copies} == {match.state_hash()}
    assert recorder.stop().check() == 10


def test_an_observation_of_ones_own_is_what_the_function_gets() -> None:
    class Ball:
        names = ("x", "y")

        def __call__(self, match: Any) -> np.ndarray:
            return 100.0 * np.stack([match.beliefs["ball"]["x"], match.beliefs["ball"]["y"]], axis=-1)

    seen: list[np.ndarray] = []
    team = team_of_function(lambda found: (seen.append(found), ahead(found))[1], observe=Ball())
    match = Match(home=1, away=2, opponents=team, senses="ideal", seed=1)
    believed = 100.0 * match.beliefs["ball"]["x"][0, 1:]
    match.step(np.zeros((1, 3, 4)))
    np.testing.assert_allclose(seen[0][0, :, 0], believed, rtol=1e-5)


def test_envs_take_it_as_opponent_and_it_is_no_agent() -> None:
    env = soccer_v0.parallel_env(home=1, away=2, opponents=team_of_function(ahead), max_cycles=3)
    env.reset(seed=1)
    assert env.agents == ["home_0"]
    env.step({"home_0": np.zeros(4)})
    assert (env.unwrapped.match.robots["command"]["forward"][0, 1:] == 1.0).all()
