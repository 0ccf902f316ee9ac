"""Checkpoints of a training run: all data needed to resume with identical results.

Two files take turns; `latest.json` names the newer one with its sha256 and is replaced last, so that a kill or a full
disk at any moment leaves a whole checkpoint. They hold only tensors and plain values; reading them runs no code.
"""

import hashlib
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import torch

from soccer_env.guards.whole_files import read_regular_file, write_atomically
from soccer_env.train.files import LARGEST

LATEST = "latest.json"
NAMES = ("checkpoint-0.pt", "checkpoint-1.pt")


def write_checkpoint(folder: Path, state: dict[str, Any], step: int) -> None:
    """Write a checkpoint beside the previous one, then point latest.json to it; an OSError keeps the previous one."""
    name = NAMES[1] if read_latest(folder).get("file") == NAMES[0] else NAMES[0]
    buffer = io.BytesIO()
    torch.save(as_tensors(state), buffer)
    data = buffer.getvalue()
    write_atomically(folder / name, data)
    about = {"file": name, "sha256": hashlib.sha256(data).hexdigest(), "step": step}
    write_atomically(folder / LATEST, json.dumps(about) + "\n")


def read_checkpoint(folder: Path) -> dict[str, Any] | None:
    """Return the newest checkpoint of a folder, None if there is none; ValueError if it is damaged."""
    if not (folder / LATEST).exists():
        return None
    about = read_latest(folder)
    name = about.get("file")
    if name not in NAMES or not (folder / name).is_file():
        raise ValueError(f"{folder / LATEST} names {name!r}, which is not there; --anew starts again")
    path = folder / name
    data = path.read_bytes()
    if hashlib.sha256(data).hexdigest() != about.get("sha256"):
        raise ValueError(f"{path} is damaged: its sha256 is not the one in {LATEST}; --anew starts again")
    try:
        state = from_tensors(torch.load(io.BytesIO(data), weights_only=True, map_location="cpu"))
    except Exception as error:  # torch promises no kind; what is not plain is refused here, before any code of it runs
        reason = " ".join(str(error).split())[:200]
        raise ValueError(f"{path} is no checkpoint of plain values ({reason}); --anew starts again") from error
    if not isinstance(state, dict):
        raise ValueError(f"{path} is no checkpoint; --anew starts again")
    return state


def read_latest(folder: Path) -> dict[str, Any]:
    """Return the contents of latest.json, {} without the file; ValueError if it cannot be read."""
    path = folder / LATEST
    if not path.exists():
        return {}
    try:
        about = json.loads(read_regular_file(path, LARGEST))
    except (OSError, ValueError, RecursionError) as error:
        raise ValueError(f"{path} cannot be read ({error}); --anew starts again") from error
    if not isinstance(about, dict):
        raise ValueError(f"{path} is not what a training wrote; --anew starts again")
    return about


def as_tensors(value: Any) -> Any:
    """Convert arrays and bytes in nested plain values to tensors, which torch can read without running code."""
    if isinstance(value, dict):
        return {key: as_tensors(part) for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [as_tensors(part) for part in value]
    if isinstance(value, bytes):
        return {"bytes": torch.from_numpy(np.frombuffer(value, np.uint8).copy())}
    if isinstance(value, np.ndarray):
        return {"array": torch.from_numpy(np.ascontiguousarray(value).copy())}
    if isinstance(value, np.generic):
        return value.item()
    return value


def from_tensors(value: Any) -> Any:
    """Convert nested values that `as_tensors` returned back to arrays and bytes."""
    if isinstance(value, dict) and value.keys() == {"bytes"}:
        return value["bytes"].numpy().tobytes()
    if isinstance(value, dict) and value.keys() == {"array"}:
        return value["array"].numpy()
    if isinstance(value, dict):
        return {key: from_tensors(part) for key, part in value.items()}
    if isinstance(value, list):
        return [from_tensors(part) for part in value]
    return value


def generator_states() -> dict[str, Any]:
    """Return the states of torch's random generators, the only ones from which training draws."""
    return {
        "torch": torch.get_rng_state(),
        "cuda": torch.cuda.get_rng_state_all() if torch.cuda.is_available() else [],
    }


def restore_generators(state: dict[str, Any]) -> None:
    """Restore the random generators to the states that `generator_states` returned."""
    torch.set_rng_state(state["torch"])
    if len(state["cuda"]) == (torch.cuda.device_count() if torch.cuda.is_available() else 0):
        torch.cuda.set_rng_state_all(state["cuda"])  # on another machine the draws differ, the run goes on
