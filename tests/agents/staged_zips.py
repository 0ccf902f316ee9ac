"""Zips of stable-baselines3 for tests: real ones, changed ones and hostile ones; torch is imported on first use."""

import io
import json
import os
import zipfile
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np

from soccer_env.agents.policy import Policy
from soccer_env.agents.sb3_zip import load_sb3
from soccer_env.leagues import find_league
from soccer_env.observations import entry_names
from tests.agents.staged_files import assert_refused_by

INPUTS = len(entry_names(find_league("legged-2001"), "truth"))


class Canary:
    """What a pickle does to those who load it."""

    def __init__(self, file: Path) -> None:
        self.file = file

    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
        return os.mkdir, (str(self.file),)


class Noise(gymnasium.Env):
    """Observations without meaning, of the right size."""

    def __init__(self, actions: gymnasium.Space | int = 4, inputs: int = INPUTS) -> None:
        self.observation_space = gymnasium.spaces.Box(-1.0, 1.0, (inputs,), np.float32)
        box = isinstance(actions, int)
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (actions,), np.float32) if box else actions

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[np.ndarray, dict[str, Any]]:
        super().reset(seed=seed)
        return self.observation_space.sample(), {}

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        return self.observation_space.sample(), 1.0, False, False, {}


def save_zip(
    folder: Path, env: gymnasium.Env, algorithm: Any = None, policy: str = "MlpPolicy", **settings: Any
) -> Any:
    import stable_baselines3 as sb3

    kind = algorithm or sb3.PPO
    limits = {"batch_size": 16, "n_epochs": 1} if kind is sb3.PPO else {}
    model = kind(policy, env, n_steps=16, seed=1, device="cpu", **limits, **settings)
    model.learn(16)
    model.save(folder / "model.zip")
    return model


def plain_zip(folder: Path) -> Path:
    save_zip(folder, Noise(), policy_kwargs={"net_arch": [4]})
    return folder / "model.zip"


def read(path: Path, **changes: Any) -> Policy:
    return load_sb3(path, **{"league": "legged-2001", "observe": "truth", **changes})


def rewrite_zip(source: Path, target: Path, pack: int = zipfile.ZIP_STORED, **members: bytes | None) -> Path:
    """Return a copy of a zip with some members replaced (None: left out); policy_pth stands for policy.pth."""
    new = {name.replace("_pth", ".pth"): content for name, content in members.items()}
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w", pack) as archive:
        for name in {**dict.fromkeys(old.namelist()), **new}:
            content = new.get(name, old.read(name) if name in old.namelist() else None)
            if content is not None:
                archive.writestr(name, content)
    return target


def assert_zip_refused(path: Path, reason: str, **changes: Any) -> None:
    assert_refused_by(lambda: read(path, **changes), reason, f"policy file {str(path)!r}: ")


def data_of(source: Path, **changes: Any) -> bytes:
    """Return the `data` of a zip with some keys replaced."""
    with zipfile.ZipFile(source) as archive:
        return json.dumps({**json.loads(archive.read("data")), **changes}).encode()


def pth_of(table: Any) -> bytes:
    import torch

    stream = io.BytesIO()
    torch.save(table, stream)
    return stream.getvalue()


def state_of(source: Path) -> dict[str, Any]:
    import torch

    with zipfile.ZipFile(source) as archive:
        state: dict[str, Any] = torch.load(io.BytesIO(archive.read("policy.pth")), weights_only=True)
    return dict(state)


def replace_data_pkl(state: dict[str, Any], content: bytes) -> bytes:
    """Return policy.pth with another data.pkl."""
    copy = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(pth_of(state))) as old, zipfile.ZipFile(copy, "w") as new:
        for name in old.namelist():
            new.writestr(name, content if name.endswith("data.pkl") else old.read(name))
    return copy.getvalue()
