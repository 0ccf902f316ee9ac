"""Teams from ONNX files: networks that any library exports, run by onnxruntime (the extra `onnx`).

    input     observations (B, n), or (1, n); the state of a recurrent memory (B, m) may follow, 0 at first
    output    the first: actions (B, 4 or 7); twice as many numbers, the first half being means; values of our discrete
              actions (B, 12) or of the choices of "multi" (B, 20); or the chosen actions (B,), whole numbers;
              the second: the new state (B, m), in [-1, 1] as that of a GRU, if there is one

A file is read once; `onnx_checks.py` checks its contents.
"""

from collections.abc import Callable
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.actions import BOX, FULL, PARTS, ActionKind
from soccer_env.agents.onnx_checks import MAX_FILE, check_sizes, checked_model, declared_axes, element_type, inputs_of
from soccer_env.agents.policy_file import one_line, read_limited_file, short_path
from soccer_env.teams.function_teams import FunctionTeam, team_of_function

HALVES = (2 * len(BOX), 2 * len(FULL))


class OnnxPolicy:
    """A function of observations (B, n), and of a state (B, m) if it has one, that runs an ONNX network.

    ValueError if inputs or outputs do not fit.
    """

    def __init__(self, content: bytes, where: str) -> None:
        try:
            import onnx
            import onnxruntime
        except ImportError:
            raise ImportError("an ONNX file plays by onnxruntime and onnx: pip install soccer_env[onnx]") from None
        self.content, self.where = content, where
        self.runtime = f"onnxruntime {onnxruntime.__version__}"
        self._model = self._asked(partial(checked_model, content))
        self._inputs = inputs_of(self._model)
        self._size, self._width = (axis.dim_value for axis in declared_axes(self._inputs[0]))  # 0: any number of rows
        self._known: set[int] = set()  # numbers of rows with checked sizes
        self._check(self._size or 1)
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1  # a match has threads of its own
        options.log_severity_level = 4  # what is wrong is said by the errors
        sound = self._model.SerializeToString()
        providers = ["CPUExecutionProvider"]
        self._session = self._asked(lambda: onnxruntime.InferenceSession(sound, options, providers=providers))
        self._kind = np.float64 if element_type(self._inputs[0]) == onnx.TensorProto.DOUBLE else np.float32
        widths = [declared_axes(one)[1].dim_value for one in self._inputs[1:]]
        self.memory = np.dtype((self._kind, (widths[0],))) if widths else None  # of a player's state

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return OnnxPolicy, (self.content, self.where)

    def __call__(self, observations: np.ndarray, state: np.ndarray | None = None) -> np.ndarray:
        """Return actions (B, 4 or 7), or indices of discrete actions (B,), as the network gives them for (B, n).

        state: (B, m), which this call updates, of a network that has one; None: 0.
        """
        if self._width != observations.shape[1]:
            taken = f"takes {self._width} inputs, the observation has {observations.shape[1]}"
            raise ValueError(f"policy file {self.where!r}: {taken}: give observe= as in its training")
        if state is None and self.memory is not None:
            state = np.zeros((len(observations), *self.memory.shape), self._kind)
        given = [observations] if state is None else [observations, state]
        step = len(observations) if self._size != 1 else 1  # of exports for one robot at a time
        runs = [self._run([part[i : i + step] for part in given]) for i in range(0, len(observations), step)]
        outputs, *states = (np.concatenate(parts) for parts in zip(*runs, strict=True))
        if state is not None:
            state[...] = states[0]
        for kind in map(ActionKind, PARTS):
            if outputs.dtype.kind == "f" and outputs.shape[1:] == (sum(kind.parts),):
                return kind.expand(kind.choose(outputs))
        if outputs.shape[1:] and outputs.shape[1] in HALVES:
            return np.asarray(outputs[:, : outputs.shape[1] // 2])
        return outputs

    def _run(self, parts: list[np.ndarray]) -> list[np.ndarray]:
        """Return as many outputs of the network as it has inputs, for rows (B, n) and perhaps states (B, m)."""
        self._check(len(parts[0]))
        named = {one.name: part.astype(self._kind) for one, part in zip(self._inputs, parts, strict=True)}
        outputs: list[np.ndarray] = self._asked(lambda: self._session.run(None, named))[: len(parts)]
        if len(parts) == 2 and outputs[1].shape != parts[1].shape:
            got = f"a state of shape {parts[1].shape}, and returns one of {outputs[1].shape}"
            raise ValueError(f"policy file {self.where!r}: takes {got}")
        return outputs

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
        policy, observe=observe, action_repeat=action_repeat, at_once=at_once, flat=True, memory=policy.memory,
        name=Path(path).stem, fingerprint=fingerprint,
    )  # fmt: skip
