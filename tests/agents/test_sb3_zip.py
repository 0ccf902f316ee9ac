"""Zips of stable-baselines3: real ones give the same actions, those that cannot are refused with the reason."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest

from soccer_env import make_team
from soccer_env.actions import DISCRETE_TABLE
from soccer_env.agents import convert_sb3
from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import dump, load, parse
from soccer_env.leagues import find_league
from tests.agents import staged_zips
from tests.agents.staged_files import without_key
from tests.agents.staged_policies import decide
from tests.agents.staged_zips import INPUTS, Noise, assert_zip_refused, data_of, pth_of, read, rewrite_zip, save_zip

torch = pytest.importorskip("torch")
sb3 = pytest.importorskip("stable_baselines3")


def actions_of(policy: Policy, observations: np.ndarray) -> np.ndarray:
    values = observations
    squeeze = {"tanh": np.tanh, "relu": lambda x: np.maximum(x, 0.0)}[policy.activation]
    for number, (weight, bias) in enumerate(zip(policy.weights, policy.biases)):
        values = (values if number == 0 else squeeze(values)) @ weight.T + bias
    return np.tanh(values) if policy.squash else values


DISCRETE = gymnasium.spaces.Discrete(12)
RELU = {"activation_fn": torch.nn.ReLU, "net_arch": {"pi": [12, 9, 7], "vf": [5]}}
REAL = {
    "PPO": (None, 4, {}, "tanh"),
    "A2C": (sb3.A2C, 4, {}, "tanh"),
    "relu, 7 actions": (None, 7, {"policy_kwargs": RELU}, "relu"),
    "tanh said": (None, 4, {"policy_kwargs": {"activation_fn": torch.nn.Tanh, "net_arch": [6]}}, "tanh"),
    "no hidden layer": (None, 4, {"policy_kwargs": {"net_arch": []}}, "tanh"),
    "state-dependent exploration": (None, 4, {"use_sde": True}, "tanh"),
    "features apart": (None, 4, {"policy_kwargs": {"share_features_extractor": False}}, "tanh"),
}


@pytest.mark.parametrize("kind", REAL)
def test_a_real_zip_gives_the_same_actions(kind: str, tmp_path: Path) -> None:
    algorithm, size, settings, activation = REAL[kind]
    model = save_zip(tmp_path, Noise(size), algorithm, **settings)
    policy = read(tmp_path / "model.zip", action_repeat=3)
    observations = np.random.default_rng(2).uniform(-1, 1, (200, INPUTS)).astype(np.float32)
    with torch.no_grad():
        means = model.policy.get_distribution(torch.as_tensor(observations)).distribution.mean.numpy()
    assert np.abs(actions_of(policy, observations) - means).max() < 1e-6
    assert policy.activation == activation and policy.actions == ("box" if size == 4 else "full")
    assert (policy.name, policy.league, policy.observe, policy.action_repeat) == ("model", "legged-2001", "truth", 3)
    assert policy.made["num_timesteps"] == "16" and policy.made["seed"] == "1"
    policy.check_plays(replace(find_league("legged-2001"), name="icy"))
    assert dump(parse(dump(policy), "here")) == dump(policy)


OTHERS: dict[str, tuple[Any, Any, dict[str, Any], tuple[str, str, bool]]] = {
    "SAC": (sb3.SAC, 4, {}, ("box", "relu", True)),
    "SAC, tanh, 7 actions": (sb3.SAC, 7, {"activation_fn": torch.nn.Tanh}, ("full", "tanh", True)),
    "TD3": (sb3.TD3, 4, {}, ("box", "relu", True)),
    "DDPG": (sb3.DDPG, 4, {}, ("box", "relu", True)),
    "DQN": (sb3.DQN, DISCRETE, {}, ("discrete", "relu", False)),
    "discrete PPO": (sb3.PPO, DISCRETE, {}, ("discrete", "tanh", False)),
    "discrete A2C": (sb3.A2C, DISCRETE, {"activation_fn": torch.nn.ReLU}, ("discrete", "relu", False)),
}


@pytest.mark.parametrize("kind", OTHERS)
def test_other_algorithms_play_what_they_predict(kind: str, tmp_path: Path) -> None:
    algorithm, space, settings, (actions, activation, squash) = OTHERS[kind]
    room = {} if kind.startswith("discrete") else {"buffer_size": 10}
    network = {"net_arch": [12, 9], **settings}
    model = algorithm("MlpPolicy", Noise(space), seed=1, device="cpu", policy_kwargs=network, **room)
    model.save(tmp_path / "model.zip")
    observations = np.random.default_rng(2).uniform(-1, 1, (200, INPUTS)).astype(np.float32)
    predicted = model.predict(observations, deterministic=True)[0]
    out = tmp_path / "out.safetensors"
    policy = convert_sb3(tmp_path / "model.zip", out, league="legged-2001", observe="truth", action_repeat=2)
    assert dump(load(out)) == dump(policy)
    assert (policy.actions, policy.activation, policy.squash, policy.at_once) == (actions, activation, squash, True)
    found = decide(policy, observations)
    if actions == "discrete":
        assert len(np.unique(predicted)) > 2
        assert (found[:, :4] == DISCRETE_TABLE[predicted]).all()
    else:
        assert np.abs(found - predicted).max() < 1e-5


def test_squashed_exploration_of_ppo_plays_what_it_predicts(tmp_path: Path) -> None:
    model = save_zip(tmp_path, Noise(), use_sde=True, policy_kwargs={"squash_output": True})
    observations = np.random.default_rng(2).uniform(-1, 1, (50, INPUTS)).astype(np.float32)
    predicted = model.predict(observations, deterministic=True)[0]
    assert np.abs(decide(read(tmp_path / "model.zip"), observations) - predicted).max() < 1e-5


def test_what_vec_normalize_did_is_done_again(tmp_path: Path) -> None:
    vec = sb3.common.vec_env
    envs = vec.VecNormalize(vec.DummyVecEnv([lambda: Noise()]), clip_obs=2.0)
    model = sb3.PPO("MlpPolicy", envs, n_steps=64, batch_size=64, seed=1, device="cpu")
    model.learn(256)
    model.save(tmp_path / "model.zip")
    observations = np.random.default_rng(2).uniform(-1, 1, (50, INPUTS)).astype(np.float32)
    predicted = model.predict(envs.normalize_obs(observations), deterministic=True)[0]
    assert np.abs(decide(read(tmp_path / "model.zip", normalise=envs), observations) - predicted).max() < 1e-5
    assert np.abs(decide(read(tmp_path / "model.zip"), observations) - predicted).max() > 1e-3


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return staged_zips.plain_zip(tmp_path_factory.mktemp("real"))


@pytest.mark.parametrize(
    ("space", "reason"),
    [
        (gymnasium.spaces.Discrete(4), "its discrete actions must be 12 from 0, got n '4'"),
        (gymnasium.spaces.Discrete(12, start=1), "its discrete actions must be 12 from 0, got start '1'"),
        (gymnasium.spaces.MultiDiscrete([3, 4]), "its action_space must be a Box or Discrete, got .*MultiDiscrete"),
        (gymnasium.spaces.Box(-2.0, 2.0, (4,), np.float32), r"actions must lie in \[-1, 1\], got low"),
        (gymnasium.spaces.Box(-1.0, 1.0, (5,), np.float32), "gives 5 numbers as actions, must be one of 4, 7"),
    ],
)
def test_other_actions_are_refused(space: gymnasium.Space, reason: str, tmp_path: Path) -> None:
    save_zip(tmp_path, Noise(space))
    assert_zip_refused(tmp_path / "model.zip", reason)


class Wide(torch.nn.Flatten):
    """A user's own features, without parameters."""

    def __init__(self, observation_space: gymnasium.Space) -> None:
        super().__init__()
        self.features_dim = INPUTS


def test_other_networks_are_refused(tmp_path: Path) -> None:
    save_zip(tmp_path, Noise(), policy_kwargs={"activation_fn": torch.nn.ELU})
    assert_zip_refused(tmp_path / "model.zip", "activation_fn must be Tanh or ReLU, got .*ELU")
    save_zip(tmp_path, Noise(), policy_kwargs={"features_extractor_class": Wide})
    assert_zip_refused(tmp_path / "model.zip", "features are made by .*Wide")


def test_other_policies_are_refused(tmp_path: Path) -> None:
    noisy = sb3.SAC("MlpPolicy", Noise(), buffer_size=10, use_sde=True, policy_kwargs={"net_arch": [4]})
    noisy.save(tmp_path / "sac.zip")
    assert_zip_refused(tmp_path / "sac.zip", "has the parameter 'actor.log_std': only MlpPolicy of PPO, A2C, SAC")
    images = Noise()
    images.observation_space = gymnasium.spaces.Box(0, 255, (3, 36, 36), np.uint8)
    sb3.PPO("CnnPolicy", images, n_steps=16, batch_size=16).save(tmp_path / "cnn.zip")
    supported = "only MlpPolicy of PPO, A2C, SAC, TD3, DDPG and DQN is supported"
    assert_zip_refused(tmp_path / "cnn.zip", f"'.*features_extractor.* {supported}")


def test_other_widths_and_wrong_arguments_are_refused(plain: Path, tmp_path: Path) -> None:
    assert_zip_refused(plain, f"takes {INPUTS} inputs, 'belief' of 'legged-2001' has 100", observe="belief")
    said = f"takes {INPUTS} inputs, 'truth' of 'middle-size-2006' has 101"
    assert_zip_refused(plain, said, league="middle-size-2006")
    for changes in ({"league": "none"}, {"observe": "all"}, {"activation": "gelu"}, {"action_repeat": 0}, {"name": ""}):
        with pytest.raises(ValueError, match=f"{next(iter(changes))}"):
            read(plain, **changes)


def test_the_activation_is_the_zips_own(plain: Path, tmp_path: Path) -> None:
    assert read(plain, activation="relu").activation == "relu"  # this zip does not say
    said = {"activation_fn": "<class 'torch.nn.modules.activation.ReLU'>"}
    path = rewrite_zip(plain, tmp_path / "a.zip", data=data_of(plain, policy_kwargs=said))
    assert read(path).activation == "relu"
    assert_zip_refused(path, "its activation is relu, not tanh", activation="tanh")


def test_the_rules_of_the_training_are_kept_where_they_are_said(plain: Path, tmp_path: Path) -> None:
    assert read(plain).rules == {}
    asked = {"league": "legged-2001", "observe": "truth", "rules": "simple:pushing=True"}
    kept = convert_sb3(plain, tmp_path / "a.safetensors", **asked).rules
    assert kept["name"] == "simple:pushing=True" and kept["pushing"] is True
    team: Any = make_team(f"{plain}:rules=simple")
    assert team.policy.rules["name"] == "simple"


def wrong_states(state: dict[str, Any]) -> dict[str, tuple[Any, str]]:
    """Return tables of parameters that are no policy, and the reason."""
    bias, huge = state["action_net.bias"], torch.zeros(1).expand(2**40)
    return {
        "NaN": ({**state, "action_net.bias": bias * np.nan}, "must be finite"),
        "double": ({**state, "action_net.bias": bias.double()}, "torch DoubleStorage', which is no tensor"),
        "half": ({**state, "action_net.bias": bias.to(torch.bfloat16)}, "BFloat16Storage', which is no tensor"),
        "lacking": (without_key(state, "action_net.bias"), "action_net must have a weight and a bias"),
        "no log_std": (without_key(state, "log_std"), "is not of the kind that its net"),
        "other": ({**state, "q_net.0.weight": bias}, "parameter 'q_net.0.weight': only MlpPolicy"),
        "gap": ({**state, "mlp_extractor.policy_net.5.weight": bias}, "of mlp_extractor.policy_net must be 0, 2,"),
        "shape": ({**state, "action_net.bias": bias[None]}, "a weight of two axes and a bias"),
        "broadcast": ({**state, "action_net.bias": huge}, "a weight of two axes and a bias"),
        "list": ([bias], "pickle has EMPTY_LIST"),
        "negated": ({**state, "action_net.bias": torch._neg_view(bias)}, "negative bit"),
        "one tensor": (bias, "must be a table of parameters"),
        "numbers": ({3: bias}, "must hold tensors with names, got 3"),
        "no tensors": ({"a": "b"}, "lacks the tensors|must hold tensors with names"),
        "empty": ({}, "only|lacks|log_std"),
    }


def test_wrong_parameters_are_refused(plain: Path, tmp_path: Path) -> None:
    for table, reason in wrong_states(staged_zips.state_of(plain)).values():
        assert_zip_refused(rewrite_zip(plain, tmp_path / "a.zip", policy_pth=pth_of(table)), reason)


def test_wrong_data_is_refused(plain: Path, tmp_path: Path) -> None:
    box = "<class 'gymnasium.spaces.box.Box'>"
    for content, reason in (
        (b"", "data is not JSON"),
        (b"[]", "data must be a JSON object"),
        (b"[" * 100_000, "nested too deeply|not JSON"),
        (b"\xff", "data is not JSON"),
        (b'{"a":1,"a":2}', "the key 'a' twice"),
        (b"{}", "observation_space must be a Box, got None"),
        (data_of(plain, action_space=[box]), "action_space must be a Box"),
        (data_of(plain, policy_kwargs=None), "data says no policy_kwargs: it is no model"),
        (data_of(plain, policy_kwargs={"lstm_size": 2}), "policy_kwargs has 'lstm_size'"),
        (data_of(plain, action_space={":type:": box, "low": "[-1. nan]"}), "must lie in"),
    ):
        assert_zip_refused(rewrite_zip(plain, tmp_path / "a.zip", data=content), reason)


def test_without_torch_the_message_says_what_to_install(plain: Path) -> None:
    load = f"load_sb3({str(plain)!r}, league='legged-2001', observe='truth')"
    program = f"import sys; sys.modules['torch'] = None\nfrom soccer_env.agents.sb3_zip import load_sb3; {load}"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert "ImportError: reading a stable-baselines3 zip needs torch: pip install soccer_env[train]" in run.stderr
