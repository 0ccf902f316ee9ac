"""An actor with a memory in training: its files decide as it does, rewards teach it to remember."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.policy_file import load
from soccer_env.leagues import find_league
from soccer_env.observations import layout

pytest.importorskip("stable_baselines3")

import torch

from soccer_env.train.ppo.checks import check_start, make_curriculum, make_matches
from soccer_env.train.ppo.learner import Learner
from soccer_env.train.ppo.networks import SoccerPolicy, blank_policy, export_policy
from soccer_env.train.ppo.settings import TrainSettings, command_of
from soccer_env.train.ppo.updating.rollout import Start, collect
from soccer_env.train.ppo.updating.update import as_sequences, make_optimizer, update
from tests.agents.staged_policies import decide
from tests.train.ppo.staged_training import ROLLOUT, outcome, tiny_settings, train_plainly, whole_run

torch.set_num_threads(1)
LEAGUE = find_league("legged-2001")
ENTRIES = layout(LEAGUE, "belief")
NAMES = [entry.name for entry in ENTRIES]
BALL, ACTIVE = NAMES.index("ball_x"), NAMES.index("active")
REMEMBERING: dict[str, Any] = {"memory": 4}
mirrors = pytest.mark.parametrize("mirror", [False, True])


def network(units: int = 8, seed: int = 1, **settings: Any) -> Any:
    """Return an actor for beliefs of the legged league."""
    torch.manual_seed(seed)
    shape: dict[str, Any] = {"hidden": (16,), "critic": (16,), "memory": units, **settings}
    return SoccerPolicy(ENTRIES, len(NAMES), **shape)


def episodes(steps: int, rows: int, seed: int = 3) -> np.ndarray:
    """Return observations (steps, rows, n) of robots that play."""
    seen = np.random.default_rng(seed).uniform(-1.0, 1.0, (steps, rows, len(NAMES))).astype(np.float32)
    seen[..., ACTIVE] = 1.0
    return seen


@mirrors
def test_a_file_decides_as_the_network_in_episodes_that_begin_and_robots_that_are_sent_off(mirror: bool) -> None:
    made = network(mirror=mirror)
    with torch.no_grad():
        for parameter in made.actor_parameters():
            parameter.normal_(0.0, 1.3 / parameter.shape[-1] ** 0.5)
    policy = export_policy(made, name="t", league=LEAGUE, observe="belief", action_repeat=1, made={})
    seen, begins = episodes(20, 3), np.zeros((20, 3), bool)
    seen[12:14, 0, ACTIVE] = -1.0
    begins[8, 1] = True
    with torch.no_grad():
        played, _ = made.outputs(torch.as_tensor(seen), begins=torch.as_tensor(begins))
    actions = played.numpy().clip(-1.0, 1.0)
    expected = [
        decide(policy, seen[:, 0]), np.concatenate([decide(policy, seen[:8, 1]), decide(policy, seen[8:, 1])]),
        decide(policy, seen[:, 2]),
    ]  # fmt: skip
    np.testing.assert_allclose(actions, np.stack(expected, axis=1), rtol=0.0, atol=3e-6)
    assert np.std(actions) > 0.1


def learner(folder: Path, **changes: Any) -> Learner:
    settings = tiny_settings(folder, **REMEMBERING | changes)
    return Learner(settings, make_matches(settings, make_curriculum(settings), settings.sizes))


@mirrors
def test_a_rollout_is_evaluated_with_the_states_in_which_it_was_played(tmp_path: Path, mirror: bool) -> None:
    """Before an update all decisions have the mean actions of which they were drawn."""
    made = learner(tmp_path / "run", mirror=mirror)
    made.begin_matches()
    for _ in range(3):
        made.collect_rollout(lambda: None)
        rollout = made._rollout
        assert rollout is not None
        seen, begins, means, *_ = as_sequences(rollout, made.network)
        with torch.no_grad():
            found, _ = made.network.outputs(seen, rollout.states, begins)
        torch.testing.assert_close(found, means, rtol=0.0, atol=1e-6)
        assert seen.shape[:2] == (12, ROLLOUT // 12) and (made._start.states != 0.0).any()
    assert (rollout.states != 0.0).any() and begins[1:].any(), "an episode began within the last rollout"
    assert made.network.memory is not None
    before = [parameter.detach().clone() for parameter in made.network.memory.tensors()]
    made.update()
    after = made.network.memory.tensors()
    assert all((one != other).any() for one, other in zip(before, after, strict=True))
    made.close()


def test_a_run_with_a_memory_resumes(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    whole = whole_run(tmp_path_factory, **REMEMBERING)
    assert len(load(whole / "last.safetensors").memory[1]) == 12
    for steps in (3 * ROLLOUT, tiny_settings(tmp_path).steps):
        train_plainly(tiny_settings(tmp_path / "cut", **REMEMBERING, steps=steps))
    cut, uncut = outcome(tmp_path / "cut"), outcome(whole)
    assert cut["last"] == uncut["last"] and cut["checkpoint"] == uncut["checkpoint"]


def test_an_actor_with_a_memory_begins_with_a_file_of_the_same_memory(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    file = str(whole_run(tmp_path_factory, **REMEMBERING) / "last.safetensors")
    settings = tiny_settings(tmp_path, start=file, memory=4)
    check_start(settings, blank_policy(settings, LEAGUE))
    other = tiny_settings(tmp_path, start=file, memory=5)
    with pytest.raises(ValueError, match="has a memory of 4, the run 5"):
        check_start(other, blank_policy(other, LEAGUE))


def test_the_settings_of_a_memory() -> None:
    assert TrainSettings().memory == 0 and "--memory 8" in command_of(TrainSettings(memory=8))
    with pytest.raises(ValueError, match="memory must be 0 to 128, got 129"):
        TrainSettings(memory=129)


class BallSeenOnce:
    """Episodes of 6 decisions: the ball is seen at the first, left or right; paid is to walk towards it at the last."""

    LENGTH, num_envs = 6, 64

    def __init__(self) -> None:
        self.rng, self.step_count = np.random.default_rng(1), np.arange(self.num_envs) % self.LENGTH
        self.side = self.rng.choice([-1.0, 1.0], self.num_envs)
        self.size_of_row = np.zeros(self.num_envs, int)
        self.paid: list[float] = []  # mean of an episode, at each step

    def seen(self) -> np.ndarray:
        seen = np.zeros((self.num_envs, len(NAMES)), np.float32)
        seen[:, ACTIVE] = 1.0
        seen[:, BALL] = np.where(self.step_count == 0, self.side, 0.0)
        return seen

    def step_async(self, actions: np.ndarray) -> None:
        self.actions = actions

    def step_wait(self) -> Any:
        actions = self.actions
        dones = self.step_count == self.LENGTH - 1
        rewards = np.where(dones, self.side * actions[:, 0].clip(-1.0, 1.0), 0.0).astype(np.float32)
        self.paid.append(float(rewards[dones].mean()))
        self.step_count = np.where(dones, 0, self.step_count + 1)
        self.side = np.where(dones, self.rng.choice([-1.0, 1.0], self.num_envs), self.side)
        return self.seen(), rewards, dones, [{"TimeLimit.truncated": False}] * self.num_envs


@pytest.mark.parametrize(("units", "least", "most"), [(8, 0.6, 1.0), (0, -0.2, 0.2)])
def test_ppo_learns_to_remember_and_a_plain_actor_does_not(units: int, least: float, most: float) -> None:
    settings = TrainSettings(memory=units, batch=480, epochs=6, target_kl=0.02)
    made, matches = network(units, 2, noise=0.5), BallSeenOnce()
    optimizer, start = make_optimizer(made, 0.003), Start(matches.seen(), made.no_states(matches.num_envs))
    for _ in range(20):
        rollout, start = collect(made, matches, start, 30, 0.99, 0.95, lambda: None)  # type: ignore[arg-type]
        update(made, optimizer, rollout, settings, actor=True)
    assert least < np.mean(matches.paid[-30:]) <= most, "with noise; by chance 0, at best 1"
