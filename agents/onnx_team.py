"""Policies in ONNX files as teams: whatever network a library exports plays, by onnxruntime (the extra `onnx`).

    inputs    one: observations (B, n), or (1, n)
    outputs   the first: actions (B, 4 or 7); twice as many, of which the first half are means; values of our discrete
              actions (B, 12); or the chosen ones (B,), whole numbers

A file is read once, and only numbers are computed: onnxruntime runs no code out of it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.actions import BOX, DISCRETE, FULL
from soccer_env.agents.policy_file import file_name, one_line, read_plain
from soccer_env.function_teams import FunctionTeam, team_of_function

MAX_FILE = 256 * 2**20  # [bytes]
HALVES = (2 * len(BOX), 2 * len(FULL))


class OnnxPolicy:
    """The network of an ONNX file as a function of observations (B, n); ValueError says what does not fit."""

    def __init__(self, content: bytes, where: str) -> None:
        try:
            import onnxruntime
        except ImportError:
            raise ImportError("an ONNX file plays by onnxruntime: pip install soccer_env[onnx]") from None
        self.content, self.where = content, where
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1  # a match has threads of its own
        options.log_severity_level = 4  # what is wrong is said by the errors
        self._session = self._asked(
            lambda: onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])
        )
        inputs = self._session.get_inputs()
        if len(inputs) != 1 or len(inputs[0].shape) != 2:
            got = ", ".join(f"{one.name} {one.shape}" for one in inputs)
            raise ValueError(f"policy file {where!r}: must have one input (B, n), got {got}; see team_of_function")
        self._input = inputs[0]

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return OnnxPolicy, (self.content, self.where)

    def __call__(self, observations: np.ndarray) -> np.ndarray:
        """Return actions (B, 4 or 7), or discrete ones (B,)."""
        size, width = self._input.shape
        if isinstance(width, int) and width != observations.shape[1]:
            taken = f"takes {width} inputs, the observation has {observations.shape[1]}"
            raise ValueError(f"policy file {self.where!r}: {taken}: give observe= as in its training")
        parts = [observations] if size != 1 else list(observations[:, None])  # of exports for one robot at a time
        kind = np.float64 if "double" in self._input.type else np.float32
        runs = [self._asked(partial(self._run, part.astype(kind))) for part in parts]
        found = np.concatenate(runs)
        if found.dtype.kind == "f" and found.shape[1:] == (len(DISCRETE),):
            return np.asarray(found.argmax(axis=1))
        if found.shape[1:] and found.shape[1] in HALVES:
            return np.asarray(found[:, : found.shape[1] // 2])
        return found

    def _run(self, rows: np.ndarray) -> np.ndarray:
        """Return the first output for rows (B, n)."""
        first: np.ndarray = self._session.run(None, {self._input.name: rows})[0]
        return first

    def _asked(self, ask: Callable[[], Any]) -> Any:
        """Return what onnxruntime answers; ValueError in one line instead of its many kinds of errors."""
        try:
            return ask()
        except Exception as error:
            raise ValueError(f"policy file {self.where!r}: {one_line(error)}") from None


def from_onnx(path: str | Path, observe: str = "belief", action_repeat: int = 1, at_once: bool = True) -> FunctionTeam:
    """Return the team of an ONNX file; the settings are those of `team_of_function`."""
    content = read_plain(path, MAX_FILE)
    return team_of_function(
        OnnxPolicy(content, file_name(path)), observe=observe, action_repeat=action_repeat, at_once=at_once, flat=True,
        name=Path(path).stem, fingerprint=f"onnx {observe} {action_repeat} {at_once} {sha256(content).hexdigest()}",
    )  # fmt: skip
