"""A team that on a given node waits to be killed, and functions that tasks call."""

import contextlib
import os
import time
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.teams.kernels import NO_MEMORY
from soccer_env.types import COMMAND

LONG = 60.0  # [s] that a victim waits for its end


class Victim:
    """A team that walks; on the node named, if any, the first process that plays it waits for its death."""

    name, memory_dtype, fingerprint = "victim", NO_MEMORY, "1"

    def __init__(self, folder: Path, node: str = "") -> None:
        self.folder, self.node, self.steps = folder, node, 0

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        """Return commands (M, P, fields) that walk; wait first, if this is the victim."""
        self.steps += 1
        if self.node and self.steps > 1:  # one step alone compiles, while other workers wait
            wait_for_death(self.folder, self.node)
        commands = np.zeros((*view.beliefs.shape, len(COMMAND.names or ())), np.float32)
        commands[..., 0] = 1.0
        return commands


def wait_for_death(folder: Path, node: str) -> None:
    """Leave the pid in a file and wait, in the first process of a node; elsewhere go on once the victim waits."""
    import ray

    if ray.get_runtime_context().get_node_id() == node:
        with contextlib.suppress(FileExistsError), (folder / "begun").open("x"):
            (folder / "pid.new").write_text(str(os.getpid()))
            os.rename(folder / "pid.new", folder / "pid")
            time.sleep(LONG)
    while not (folder / "pid").exists():
        time.sleep(0.05)


def note(folder: Path) -> None:
    """Add a line to a file."""
    with (folder / "notes").open("a") as file:
        file.write("here\n")


def end_process() -> None:
    """End the process as a crash does."""
    os._exit(1)


def say_where() -> str:
    """Return the file from which a worker has the package."""
    import soccer_env

    return str(soccer_env.__file__)
