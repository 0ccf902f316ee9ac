"""What the networks of a run begin as: a policy file, or another run with its critic and noise."""

from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.policy_file import load
from soccer_env.leagues import find_league
from soccer_env.observations import entry_names
from tests.agents.staged_policies import decide, random_policy, random_recurrent_policy

pytest.importorskip("stable_baselines3")

from soccer_env.train.ppo.checkpoints import read_checkpoint
from soccer_env.train.ppo.networks import widened_policy
from tests.train.ppo.staged_training import ROLLOUT, as_plain_values, tiny_settings, train_plainly, weights


@pytest.mark.parametrize("change", [{}, {"memory": 4, "mirror": False}])
def test_an_actor_may_begin_with_the_weights_of_a_policy_file(tmp_path: Path, change: dict[str, Any]) -> None:
    """As long as the critic learns alone they stay what they are in the file."""
    train_plainly(tiny_settings(tmp_path / "first", steps=3 * ROLLOUT, past=0, **change))
    first = tmp_path / "first" / "last.safetensors"
    train_plainly(tiny_settings(tmp_path / "next", steps=2 * ROLLOUT, past=0, start=str(first), seed=4, **change))
    assert weights(tmp_path / "next" / "last.safetensors") == weights(first)
    made = load(tmp_path / "next" / "last.safetensors").made
    assert str(tmp_path) not in str(made) and made["start"] == sha256(first.read_bytes()).hexdigest()


def test_a_run_may_go_on_with_actor_critic_and_noise_of_another_run(tmp_path: Path) -> None:
    """Of other team sizes: the critic has room for five a side. Nothing is learned in a run of no steps."""
    train_plainly(tiny_settings(tmp_path / "first", steps=ROLLOUT, past=0, critic_first=0, players="1v1"))
    changes = {"past": 0, "start": str(tmp_path / "first"), "seed": 4, "players": "2v2", "noise": 0.9}
    train_plainly(tiny_settings(tmp_path / "next", steps=0, **changes))
    one, other = (read_checkpoint(tmp_path / name) for name in ("first", "next"))
    assert one is not None and other is not None
    assert as_plain_values(one["network"]) == as_plain_values(other["network"])
    assert float(other["network"]["log_std"].exp().mean()) < 0.7
    with pytest.raises(ValueError, match=r"start: .* has hidden layers of 8, the run 9"):
        train_plainly(tiny_settings(tmp_path / "wide", steps=0, hidden="9", **changes))
    with pytest.raises(ValueError, match="start: the networks of the run in .* are not those of this run"):
        train_plainly(tiny_settings(tmp_path / "wise", steps=0, critic="9", **changes))


CLOCKS = ("own_pushing", "own_holding", "own_penalty", "ball_still")


@pytest.mark.parametrize("make", [random_policy, random_recurrent_policy])
def test_an_actor_of_fewer_inputs_begins_as_it_was_and_sees_the_new_ones_with_weight_0(make: Any) -> None:
    names = tuple(entry_names(find_league("legged-2001"), "belief"))
    old = make(16, mirror=True, inputs=tuple(name for name in names if name not in CLOCKS))
    new = widened_policy(old, names)
    rows = np.random.default_rng(2).uniform(-1.0, 1.0, (50, len(names))).astype(np.float32)
    read = [names.index(name) for name in old.inputs]
    assert new.inputs == names and (decide(new, rows) == decide(old, rows[:, read])).all()
    assert widened_policy(new, names).inputs == names
    with pytest.raises(ValueError, match="policy 'lively' reads the entry 'own_x', which is not observed"):
        widened_policy(old, names[1:])
