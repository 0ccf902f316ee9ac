"""Teams from ONNX files: networks that any library exports, run by onnxruntime (the extra `onnx`).

    input     one: observations (B, n), or (1, n)
    output    the first: actions (B, 4 or 7); twice as many numbers, the first half being means; values of our discrete
              actions (B, 12) or of the choices of "multi" (B, 20); or the chosen actions (B,), whole numbers

A file is read once; `onnx_checks.py` checks its contents.
"""

from collections.abc import Callable
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.actions import BOX, FULL, PARTS, ActionKind
from soccer_env.agents.onnx_checks import MAX_FILE, check_sizes, checked_model, declared_axes, inputs_of
from soccer_env.agents.policy_file import one_line, read_limited_file, short_path
from soccer_env.teams.function_teams import FunctionTeam, team_of_function

HALVES = (2 * len(BOX), 2 * len(FULL))


class OnnxPolicy:
    """A function of observations (B, n) that runs an ONNX network; ValueError if inputs or outputs do not fit."""

    def __init__(self, content: bytes, where: str) -> None:
        try:
            import onnx
            import onnxruntime
        except ImportError:
            raise ImportError("an ONNX file plays by onnxruntime and onnx: pip install soccer_env[onnx]") from None
        self.content, self.where = content, where
        self.runtime = f"onnxruntime {onnxruntime.__version__}"
        self._model = self._asked(partial(checked_model, content))
        self._input = inputs_of(self._model)[0]
        self._size, self._width = (axis.dim_value for axis in declared_axes(self._input))  # 0: any number of rows
        self._known: set[int] = set()  # numbers of rows with checked sizes
        self._check(self._size or 1)
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1  # a match has threads of its own
        options.log_severity_level = 4  # what is wrong is said by the errors
        sound = self._model.SerializeToString()
        providers = ["CPUExecutionProvider"]
        self._session = self._asked(lambda: onnxruntime.InferenceSession(sound, options, providers=providers))
        self._kind = np.float64 if self._input.type.tensor_type.elem_type == onnx.TensorProto.DOUBLE else np.float32

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return OnnxPolicy, (self.content, self.where)

    def __call__(self, observations: np.ndarray) -> np.ndarray:
        """Return actions (B, 4 or 7), or indices of discrete actions (B,), as the network gives them for (B, n)."""
        if self._width != observations.shape[1]:
            taken = f"takes {self._width} inputs, the observation has {observations.shape[1]}"
            raise ValueError(f"policy file {self.where!r}: {taken}: give observe= as in its training")
        parts = [observations] if self._size != 1 else list(observations[:, None])  # of exports for one robot at a time
        runs = [self._run(part.astype(self._kind)) for part in parts]
        outputs = np.concatenate(runs)
        for kind in map(ActionKind, PARTS):
            if outputs.dtype.kind == "f" and outputs.shape[1:] == (sum(kind.parts),):
                return kind.expand(kind.choose(outputs))
        if outputs.shape[1:] and outputs.shape[1] in HALVES:
            return np.asarray(outputs[:, : outputs.shape[1] // 2])
        return outputs

    def _run(self, rows: np.ndarray) -> np.ndarray:
        """Return the first output of the network for rows (B, n)."""
        self._check(len(rows))
        first: np.ndarray = self._asked(lambda: self._session.run(None, {self._input.name: rows})[0])
        return first

    def _check(self, rows: int) -> None:
        """Raise ValueError unless time and memory for this number of rows are limited."""
        if rows not in self._known:
            self._asked(partial(check_sizes, self._model, rows))
            self._known.add(rows)

    def _asked(self, ask: Callable[[], Any]) -> Any:
        """Call onnxruntime and return the result; any of its errors becomes a ValueError of one line."""
        try:
            return ask()
        except Exception as error:
            raise ValueError(f"policy file {self.where!r}: {one_line(error)}") from None


def from_onnx(path: str | Path, observe: str = "belief", action_repeat: int = 1, at_once: bool = True) -> FunctionTeam:
    """Return a team that plays an ONNX file, with the settings of `team_of_function`."""
    content = read_limited_file(path, MAX_FILE)
    policy = OnnxPolicy(content, short_path(path))
    fingerprint = f"{policy.runtime} {observe} {action_repeat} {at_once} {sha256(content).hexdigest()}"
    return team_of_function(
        policy, observe=observe, action_repeat=action_repeat, at_once=at_once, flat=True,
        name=Path(path).stem, fingerprint=fingerprint,
    )  # fmt: skip
