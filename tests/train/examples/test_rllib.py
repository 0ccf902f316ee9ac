"""The example of RLlib in a shortened form: the policy made of its checkpoint acts as RLlib's network does."""

from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("ray.rllib.algorithms.ppo", exc_type=ImportError)

import ray
import torch
from ray.rllib.core.rl_module import RLModule

from soccer_env.agents.policy_file import load
from soccer_env.train.examples import ppo_rllib


@pytest.mark.slow
def test_a_checkpoint_of_rllib_becomes_a_policy_that_acts_alike(tmp_path: Path) -> None:
    ray.init(address="local", num_cpus=2, include_dashboard=False, object_store_memory=100 << 20)
    assert ppo_rllib.main(steps=1, out=tmp_path) < 50.0  # one rollout, then matches
    ray.shutdown()
    policy = load(tmp_path / "policy.safetensors")
    seen = np.random.default_rng(1).uniform(-1.0, 1.0, (8, len(policy.inputs))).astype(np.float32)
    acted = seen
    for weight, bias in zip(policy.weights, policy.biases, strict=True):
        acted = acted @ weight.T + bias
        acted = acted if bias is policy.biases[-1] else np.tanh(acted)
    module = RLModule.from_checkpoint(tmp_path / ppo_rllib.MODULE)
    inputs = module.forward_inference({"obs": torch.tensor(seen)})["action_dist_inputs"]
    assert np.allclose(inputs[:, : acted.shape[1]].detach(), acted, atol=1e-5) and acted.std() > 0.0
