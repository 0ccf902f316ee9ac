"""The finished rounds of advice on disk, from which an interrupted run resumes."""

import io
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import torch

from soccer_env.guards.whole_files import write_atomically
from soccer_env.train.ppo.run_folder import ROUNDS
from soccer_env.train.ppo.teaching.imitation import Rows

ROWS = ("observations", "advice")
NETWORK = "network/"


class KeptRounds:
    """The recorded rows of each round, with the network after it, in a run's folder until teaching ends."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / ROUNDS

    def path(self, number: int) -> Path:
        """Return the path of a round's file."""
        return self.folder / f"round-{number:03d}.npz"

    def keep(self, number: int, rows: Rows, network: torch.nn.Module) -> None:
        """Write the rows of a round and the network after it, atomically; an OSError leaves earlier rounds intact."""
        weights = {NETWORK + name: tensor.cpu().numpy() for name, tensor in network.state_dict().items()}
        buffer = io.BytesIO()
        np.savez(buffer, **dict(zip(ROWS, rows, strict=True)), **weights)  # type: ignore[arg-type]  # of arrays by name
        self.folder.mkdir(exist_ok=True)
        write_atomically(self.path(number), buffer.getvalue())

    def restore(self, network: torch.nn.Module) -> list[Rows]:
        """Return the rows of all stored rounds, and load the last weights into `network`; ValueError if damaged."""
        kept: list[Rows] = []
        weights: dict[str, Any] = {}
        while (path := self.path(len(kept))).exists():
            try:
                with np.load(path) as file:
                    kept.append((file[ROWS[0]], file[ROWS[1]]))
                    weights = {name: file[name] for name in file.files if name.startswith(NETWORK)}
            except Exception as error:  # a damaged archive may raise whatever its parts do
                raise ValueError(f"{path} is damaged ({error}); --anew starts again") from error
        if weights:
            tensors = {name.removeprefix(NETWORK): torch.as_tensor(value) for name, value in weights.items()}
            network.load_state_dict(tensors)
        return kept

    def forget(self) -> None:
        """Remove all stored rounds."""
        shutil.rmtree(self.folder, ignore_errors=True)
