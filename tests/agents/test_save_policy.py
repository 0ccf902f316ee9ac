"""Policies of other libraries become policy files: what fits plays as torch says, the rest is refused."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, make_team
from soccer_env.actions import DISCRETE_TABLE, FULL, ActionKind
from soccer_env.agents.policy_file import dump, load
from soccer_env.leagues import find_league
from soccer_env.observations import entry_names

torch = pytest.importorskip("torch")
from torch import nn  # noqa: E402

from soccer_env.agents import save_policy  # noqa: E402

INPUTS = len(entry_names(find_league("legged-2001"), "belief"))
TRAINED: dict[str, Any] = {"league": "legged-2001", "observe": "belief"}


def mlp(*sizes: int, activation: Any = nn.Tanh, inputs: int = INPUTS) -> Any:
    """Return Linear layers of so many outputs with an activation between, with weights that use the whole range."""
    torch.manual_seed(3)
    layers: list[Any] = []
    for number, (a, b) in enumerate(zip((inputs, *sizes), sizes, strict=False)):
        layers += [activation()] * (number > 0) + [nn.Linear(a, b)]
        nn.init.normal_(layers[-1].weight, std=1.5 / a**0.5)
    return nn.Sequential(*layers)


class CleanSac(nn.Module):  # type: ignore[misc]
    """The actor of CleanRL's SAC: activations in `forward`, a mean and a deviation."""

    def __init__(self) -> None:
        super().__init__()
        self.fc1, self.fc2 = nn.Linear(INPUTS, 16), nn.Linear(16, 16)
        self.fc_mean, self.fc_logstd = nn.Linear(16, 4), nn.Linear(16, 4)

    def forward(self, x: Any) -> Any:
        x = torch.relu(self.fc2(torch.relu(self.fc1(x))))
        return self.fc_mean(x), torch.tanh(self.fc_logstd(x))


class CleanAgent(nn.Module):  # type: ignore[misc]
    def __init__(self) -> None:
        super().__init__()
        self.critic, self.actor_mean = mlp(8, 1), mlp(12, 12, 4)
        self.actor_logstd = nn.Parameter(torch.zeros(1, 4))


class TorchRl(nn.Module):  # type: ignore[misc]
    """An MLP with a head that splits its outputs into mean and deviation, as TorchRL's NormalParamExtractor."""

    def __init__(self) -> None:
        super().__init__()
        self.network = mlp(10, 14, activation=nn.ReLU)

    def forward(self, x: Any) -> Any:
        mean, deviation = self.network(x).chunk(2, dim=-1)
        return torch.distributions.Normal(mean, nn.functional.softplus(deviation))


class Scale:
    """The running mean of Gymnasium's NormalizeObservation."""

    def __init__(self, **more: Any) -> None:
        rng = np.random.default_rng(1)
        self.obs_rms = type("Rms", (), {"mean": rng.normal(0, 0.4, INPUTS), "var": rng.uniform(1e-6, 1.0, INPUTS)})()
        self.__dict__.update(more)

    def __call__(self, rows: np.ndarray) -> np.ndarray:
        scaled = (rows - self.obs_rms.mean) / np.sqrt(self.obs_rms.var + 1e-8)
        limit = getattr(self, "clip_obs", np.inf)
        return np.clip(scaled, -limit, limit).astype(np.float32)


def head(outputs: np.ndarray, kind: str) -> np.ndarray:
    if kind == "discrete":
        return DISCRETE_TABLE[outputs.argmax(axis=-1)]
    if kind == "multi":
        parts = np.split(outputs, [5, 10, 15], axis=-1)
        return ActionKind("multi").expand(np.stack([part.argmax(axis=-1) for part in parts], axis=-1))
    return np.tanh(outputs) if kind == "squashed" else np.clip(outputs, -1.0, 1.0)


SAC = CleanSac()
OF_SAC = {"activation": "relu", "squash": True, "outputs": SAC}
CASES: dict[str, tuple[Any, dict[str, Any], Any, str]] = {
    "CleanRL's PPO": (CleanAgent().actor_mean, {}, None, "clipped"),
    "CleanRL's SAC": ([SAC.fc1, SAC.fc2, SAC.fc_mean], OF_SAC, lambda x: SAC(x)[0], "squashed"),
    "stable-baselines3's TD3": (nn.Sequential(mlp(9, 4, activation=nn.ReLU), nn.Tanh()), {}, None, "clipped"),
    "a DQN": (mlp(11, 7, 12, activation=nn.ReLU), {}, None, "discrete"),
    "RLlib: encoder and head": ([nn.Sequential(mlp(9, 8), nn.Tanh()), nn.Linear(8, 8)], {}, None, "clipped"),
    "TorchRL: mean and deviation": (TorchRl(), {}, lambda x: TorchRl.forward(TORCHRL, x).mean, "clipped"),
    "the head as well": (mlp(8, 7), {}, None, "clipped"),
    "one layer without a bias": (nn.Linear(INPUTS, 4, bias=False), {}, None, "clipped"),
    "dropout in training": (nn.Sequential(*mlp(8, 4)[:1], nn.Dropout(0.5), *mlp(8, 4)[1:]), {}, None, "clipped"),
    "double precision": (mlp(8, 4).double(), {}, None, "clipped"),
    "normalised": (mlp(12, 4), {"normalise": Scale(clip_obs=10.0)}, None, "clipped"),
    "choices of multi": (mlp(16, 20), {}, None, "multi"),
    "normalised without a limit": (mlp(12, 12), {"normalise": Scale()}, None, "discrete"),
}
TORCHRL = CASES["TorchRL: mean and deviation"][0]


@pytest.mark.parametrize("case", CASES)
def test_a_policy_plays_what_its_module_says(case: str, tmp_path: Path) -> None:
    module, settings, ask, kind = CASES[case]
    path = tmp_path / "mine.safetensors"
    policy = save_policy(module, path, **TRAINED, **settings)
    assert dump(load(path)) == path.read_bytes() == dump(policy)
    match = Match(home=2, away=1, matches=4, observe="belief", controllers={"home": str(path), "away": "still"}, seed=1)
    for _ in range(20):
        seen = match.observations[:, :2].copy()
        match.step()
        commands = np.stack([match.robots["command"][name] for name in FULL], axis=-1)[:, :2]
        wanted = head(said(module, ask, settings["normalise"](seen) if "normalise" in settings else seen), kind)
        assert np.abs(commands[..., : wanted.shape[-1]] - wanted).max() < 1e-4
    assert len(np.unique(commands.reshape(-1, len(FULL)), axis=0)) > 1


def said(module: Any, ask: Any, rows: np.ndarray) -> np.ndarray:
    """Return the means or values that a module gives for observations (..., n), without its deviations."""
    parts = [ask] if ask else module if isinstance(module, list) else [module.eval()]
    double = next((module[0] if isinstance(module, list) else module).parameters()).dtype
    with torch.no_grad():
        outputs = torch.as_tensor(rows, dtype=double)
        for part in parts:
            outputs = part(outputs)
    return outputs[..., : {8: 4, 14: 7}.get(outputs.shape[-1], outputs.shape[-1])].double().numpy()


def test_a_saved_policy_decides_as_it_did_in_training(tmp_path: Path) -> None:
    for at_once, first in ((True, 0), (False, -find_league("legged-2001").delay_steps % 8)):
        path = tmp_path / f"{at_once}.safetensors"
        save_policy(mlp(8, 4), path, **TRAINED, action_repeat=8, at_once=at_once)
        match = Match(home=1, away=1, opponents=str(path), seed=1)
        moved = []
        for _ in range(8):
            match.step(np.zeros((1, 2, 4)))
            moved.append(bool(match.robots["command"]["forward"][0, 1]))
        assert moved == [step >= first for step in range(8)]


def test_what_a_file_says_of_its_making(tmp_path: Path) -> None:
    said: dict[str, Any] = {"rules": "simple", "name": "first", "pose": "particles", "senses": "sensors"}
    policy = save_policy(mlp(4), tmp_path / "a.safetensors", **TRAINED, **said)
    found = policy.name, policy.rules["name"], policy.pose, policy.senses
    assert found == ("first", "simple", "particles", "sensors")
    assert save_policy(mlp(4), tmp_path / "a.safetensors", **TRAINED).pose == "", "nobody said"
    with pytest.raises(ValueError, match="pose must be one of"):
        save_policy(mlp(4), tmp_path / "a.safetensors", **TRAINED, pose="compass")
    assert set(policy.made) == {"from", "torch", "soccer_env"}
    save_policy(mlp(4), tmp_path / "a.safetensors", **TRAINED, name="first")
    assert make_team(str(tmp_path / "a.safetensors")).name == "first"


def test_training_mode_and_random_numbers_are_left_alone(tmp_path: Path) -> None:
    module = nn.Sequential(nn.Linear(INPUTS, 8), nn.Dropout(0.5), nn.Tanh(), nn.Linear(8, 4)).train()
    module[1].eval()
    before = torch.get_rng_state()
    save_policy(module, tmp_path / "a.safetensors", **TRAINED)
    assert [part.training for part in module] == [True, False, True, True]
    assert torch.equal(before, torch.get_rng_state())


class Skip(nn.Module):  # type: ignore[misc]
    """Layers with a connection past them."""

    def __init__(self) -> None:
        super().__init__()
        self.one, self.middle, self.two = nn.Linear(INPUTS, 4), nn.Tanh(), nn.Linear(4, 4)

    def forward(self, x: Any) -> Any:
        h = self.one(x)
        return h + self.two(self.middle(h))


class Scaled(nn.Sequential):  # type: ignore[misc]
    """An actor whose actions are scaled in `forward`."""

    def forward(self, x: Any) -> Any:
        return 0.5 * super().forward(x)


class Split(nn.Module):  # type: ignore[misc]
    """A module that gives a dict."""

    def __init__(self) -> None:
        super().__init__()
        self.inner = mlp(4)

    def forward(self, x: Any) -> Any:
        return {"action": self.inner(x)}


SHORT = {"mean": [0.0], "deviation": [1.0], "limit": 5.0}
FLAT = {"mean": [0.0] * INPUTS, "deviation": [0.0] * INPUTS}
REFUSED: dict[str, tuple[Any, dict[str, Any], str]] = {
    "no module": (3, {}, "module must be a torch module, or several in a list, got int"),
    "nothing": ([], {}, "the module must begin with a Linear layer, got nothing"),
    "a recurrent one": (nn.GRU(INPUTS, 4), {}, "a policy file holds Linear layers with Tanh or ReLU between, no GRU"),
    "another activation": (mlp(8, 4, activation=nn.SiLU), {}, "Tanh or ReLU between, no SiLU; team_of_function lets"),
    "a norm": (nn.Sequential(nn.Linear(INPUTS, 4), nn.LayerNorm(4)), {}, "Tanh or ReLU between, no LayerNorm"),
    "two activations": (nn.Sequential(mlp(8, 8), nn.ReLU(), nn.Linear(8, 4)), {}, "one activation, Tanh or ReLU, betw"),
    "a ReLU at the end": (nn.Sequential(mlp(8, 4), nn.ReLU()), {}, "at most a Tanh behind the last, got Linear, Tanh"),
    "no activation": ([nn.Linear(INPUTS, 8), nn.Linear(8, 4)], {}, "give activation= if `forward` applies it"),
    "activations in forward": (CleanSac(), {}, "give activation= if `forward` applies it"),
    "more than its layers": (CleanSac(), {"activation": "relu"}, "layer3 must have a weight (4, 4) and a bias (4,), "),
    "a connection past layers": (Skip(), {}, "the module computes something else than its layers in their order"),
    "scaled actions": (Scaled(*mlp(8, 4)), {}, "the module computes something else than its layers in their order"),
    "a dict": (Split(), {}, "the module must give a tensor of outputs, got dict: give outputs="),
    "NaN": (nn.Sequential(nn.Linear(INPUTS, 4)), {"spoil": np.nan}, "layer0 must be finite, it holds NaN or infinity"),
    "other inputs": (mlp(8, 4, inputs=7), {}, f"the module takes 7 inputs, 'belief' of 'legged-2001' has {INPUTS}"),
    "other outputs": (mlp(8, 5), {}, "the module must have 4, 7, 12, 20, 26 outputs, or 8 or 14, got 5"),
    "another file": (mlp(4), {"path": "a.pt"}, "a policy file must end in .safetensors, got"),
    "an unknown league": (mlp(4), {"league": "legged"}, "unknown league 'legged'"),
    "an unknown observation": (mlp(4), {"observe": "all"}, "observe must be one of truth, percepts, belief, got 'all'"),
    "an unknown activation": (mlp(4), {"activation": "gelu"}, "activation must be one of tanh, relu, got 'gelu'"),
    "too long a repeat": (mlp(4), {"action_repeat": 0}, "action_repeat must be 1 to 1000, got 0"),
    "no normaliser": (mlp(4), {"normalise": 3}, "normalise must be a table of mean, deviation, limit, or have obs_rms"),
    "another size": (mlp(4), {"normalise": SHORT}, f"normalise['mean'] must have {INPUTS} numbers, got [0.0]"),
    "deviation 0": (mlp(4), {"normalise": FLAT}, "normalise['deviation'] must hold numbers from 1e-12 to 1e+30, got 0"),
    "squashed discrete ones": (
        mlp(12),
        {"squash": True},
        "mirror and squash must be False where actions are 'discrete'",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_no_file_can_hold_is_refused_and_nothing_written(case: str, tmp_path: Path) -> None:
    module, changes, message = REFUSED[case]
    settings = {**TRAINED, **changes}
    if "spoil" in settings:
        with torch.no_grad():
            module[0].weight[0, 0] = settings.pop("spoil")
    with pytest.raises(ValueError, match=re.escape(message)):
        save_policy(module, tmp_path / settings.pop("path", "a.safetensors"), **settings)
    assert not list(tmp_path.iterdir())


def test_a_module_that_is_given_as_a_team_is_told_how_to_become_one() -> None:
    with pytest.raises(ValueError, match=r"write save_policy\(module, 'mine.safetensors', league=..., observe=...\), "):
        Match(opponents=mlp(4))
