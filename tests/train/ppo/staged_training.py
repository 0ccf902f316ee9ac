"""A training so small that it takes a second or two, with everything in it that a run may have.

Its learning curve and its page are not drawn (`train_plainly`), which would take longer than all the rest.
"""

import json
import shutil
import zlib
from functools import cache
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
from safetensors.numpy import load_file

from soccer_env.train.ppo import train, training
from soccer_env.train.ppo.checkpoints import read_checkpoint
from soccer_env.train.ppo.settings import TrainSettings

TINY: dict[str, Any] = {
    "steps": 336, "players": "1v1,2v2", "matches": 3, "minutes": 0.1, "opponents": "still,chaser@0.5", "past": 2,
    "past_every": 2, "critic_first": 2, "hidden": "8", "critic": "8", "mirror": True, "central_critic": True,
    "rollout": 12, "batch": 20, "epochs": 2, "learning_rate": 0.01, "evaluate_every": 150, "evaluate_matches": 2,
    "evaluate_minutes": 0.1, "evaluate_against": "still", "noise": 0.6, "seed": 3, "device": "cpu",
}  # fmt: skip
ROLLOUT = 48  # decisions: 12 of each of 4 robots


def tiny_settings(out: Path, **changes: Any) -> TrainSettings:
    return TrainSettings(out=out, **{**TINY, **changes})


def train_plainly(settings: TrainSettings) -> training.TrainResult:
    with mock.patch.multiple(training, learning_curve=lambda *_: b"", page_of=lambda *_: ""):
        return train(settings)


@cache
def _whole(base: Path, changes: tuple[tuple[str, Any], ...]) -> Path:
    """Train once for all tests; return the folder."""
    folder = base / f"whole-{zlib.crc32(repr(changes).encode())}"
    train_plainly(tiny_settings(folder, **dict(changes)))
    return folder


def whole_run(tmp_path_factory: Any, **changes: Any) -> Path:
    """Return the folder of a tiny run that nothing disturbed; it is not to be changed."""
    return _whole(tmp_path_factory.getbasetemp(), tuple(changes.items()))


def copy_of(run: Path, to: Path) -> Path:
    shutil.copytree(run, to / "run")
    return to / "run"


def weights(path: Path) -> dict[str, bytes]:
    return {name: array.tobytes() for name, array in load_file(path).items()}


def outcome(folder: Path) -> dict[str, Any]:
    state = read_checkpoint(folder)
    assert state is not None
    return {
        "best": weights(folder / "best.safetensors"),
        "last": weights(folder / "last.safetensors"),
        "checkpoint": as_plain_values({name: state[name] for name in state if name != "generators"}),
        "log": [without_times(line) for line in records(folder / "log.jsonl")],
        "evaluations": records(folder / "evaluations.jsonl"),
    }


def records(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def without_times(line: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in line.items() if name != "seconds"}


def as_plain_values(value: Any) -> Any:
    """Return a tree with its arrays and tensors as bytes, to be compared."""
    if isinstance(value, dict):
        return {name: as_plain_values(part) for name, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [as_plain_values(part) for part in value]
    return np.asarray(value).tobytes() if hasattr(value, "shape") else value
