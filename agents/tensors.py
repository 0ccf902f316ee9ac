"""Checks of a policy's tensors: their shapes fit together, they are finite, and no observation makes them overflow."""

from collections.abc import Sequence

import numpy as np

from soccer_env.agents.attention import TENSORS, layout_of
from soccer_env.agents.recurrent import GATES, MAX_MEMORY, memory_shapes, memory_units
from soccer_env.agents.recurrent import TENSORS as MEMORY_TENSORS
from soccer_env.observations import Entry

MAX_LAYERS = 8
MAX_UNITS = 1024
MAX_NUMBERS = 3_900_000  # of all layers together, so that a policy file stays below its 16 MiB
MAX_ACTIVITY = 1e37  # largest value of a unit; float32 ends at 3.4e38


def check_array(what: str, array: object) -> None:
    """Raise ValueError unless `array` is an array of float32."""
    if not isinstance(array, np.ndarray) or array.dtype != np.float32:
        kind = array.dtype if isinstance(array, np.ndarray) else type(array).__name__
        raise ValueError(f"{what} must be an array of float32, got {kind}")


def check_attention(kind: str, attention: object, inputs: Sequence[Entry]) -> int:
    """Return the number of inputs to the first layer; ValueError unless attention fits kind and inputs."""
    if not isinstance(attention, tuple) or len(attention) != (len(TENSORS) if kind == "attention" else 0):
        size = f"{len(attention)} arrays" if isinstance(attention, tuple) else type(attention).__name__
        wanted = f"of {', '.join(TENSORS)}" if kind == "attention" else "without arrays"
        raise ValueError(f"attention of kind {kind!r} must be a tuple {wanted}, got {size}")
    if kind == "slots":
        return len(inputs)
    layout = layout_of(inputs)
    for name, array in zip(TENSORS, attention, strict=True):
        check_array(name, array)
    width = len(attention[1]) if attention[1].ndim == 1 else 0
    if not 1 <= width <= MAX_UNITS:
        raise ValueError(f"{TENSORS[1]} must have the shape (1 to {MAX_UNITS},), got {attention[1].shape}")
    check_tensors(TENSORS, attention, layout.shapes(width))
    return layout.features(width)


def check_tensors(names: Sequence[str], arrays: Sequence[np.ndarray], shapes: Sequence[tuple[int, ...]]) -> None:
    """Raise ValueError unless all arrays are finite and of the given shapes."""
    for name, array, shape in zip(names, arrays, shapes, strict=True):
        if array.shape != shape:
            raise ValueError(f"{name} must have the shape {shape}, got {array.shape}")
        if not np.isfinite(array).all():
            raise ValueError(f"{name} must be finite, it holds NaN or infinity")


def check_memory(memory: object, features: int) -> int:
    """Return the units of the memory, 0 without; ValueError unless its tensors fit the features that it reads."""
    if not isinstance(memory, tuple) or len(memory) not in (0, len(MEMORY_TENSORS)):
        size = f"{len(memory)} arrays" if isinstance(memory, tuple) else type(memory).__name__
        raise ValueError(f"memory must be an empty tuple or one of {', '.join(MEMORY_TENSORS)}, got {size}")
    for name, array in zip(MEMORY_TENSORS, memory):
        check_array(name, array)
    if not memory:
        return 0
    units = memory_units(memory) if memory[1].ndim == 1 else 0
    if not 1 <= units <= MAX_MEMORY:
        allowed = f"({GATES} times 1 to {MAX_MEMORY},)"
        raise ValueError(f"{MEMORY_TENSORS[1]} must have the shape {allowed}, got {memory[1].shape}")
    check_tensors(MEMORY_TENSORS, memory, memory_shapes(units, features))
    return units


def check_layers(weights: object, biases: object, inputs: int, outputs: int, numbers: int) -> None:
    """Raise ValueError unless the layers connect inputs to outputs, within the limits and with finite numbers."""
    if not (isinstance(weights, tuple) and isinstance(biases, tuple) and len(weights) == len(biases)):
        raise ValueError("weights and biases must be tuples of the same length, one array for each layer")
    if not 1 <= len(weights) <= MAX_LAYERS:
        raise ValueError(f"a policy must have 1 to {MAX_LAYERS} layers, got {len(weights)}")
    width, last = inputs, len(weights) - 1
    for number, (weight, bias) in enumerate(zip(weights, biases)):
        for what, array in (("weight", weight), ("bias", bias)):
            check_array(f"layer{number}.{what}", array)
        out = outputs if number == last else len(bias) if bias.ndim == 1 else 0
        if not 1 <= out <= MAX_UNITS:
            raise ValueError(f"layer{number}.bias must have the shape (1 to {MAX_UNITS},), got {bias.shape}")
        if weight.shape != (out, width) or bias.shape != (out,):
            raise ValueError(
                f"layer{number} must have a weight {(out, width)} and a bias {(out,)}, got {weight.shape}, {bias.shape}"
            )
        width, numbers = out, numbers + weight.size + bias.size
        if numbers > MAX_NUMBERS:
            raise ValueError(f"a policy must have at most {MAX_NUMBERS} weights and biases, layer{number} is too much")
        if not (np.isfinite(weight).all() and np.isfinite(bias).all()):
            raise ValueError(f"layer{number} must be finite, it holds NaN or infinity")


def check_attention_overflow(attention: tuple[np.ndarray, ...], activation: str, entering: float) -> float:
    """Return the largest possible input to the first layer; ValueError if attention could overflow."""
    largest = entering
    for first in range(0, len(attention), 3):
        weight, bias, query = (np.abs(array.astype(np.float64)) for array in attention[first : first + 3])
        encoded = weight.sum(axis=1) * entering + bias
        bounded = np.minimum(encoded, 1.0) if activation == "tanh" else encoded
        for name, reached in (
            (TENSORS[first], encoded.max()),
            (TENSORS[first + 2], query.sum(axis=1) @ bounded * entering),
        ):
            check_below_limit(name, reached)
        largest = max(largest, float(bounded.max()))
    return largest


def check_memory_overflow(memory: tuple[np.ndarray, ...], largest: float) -> None:
    """Raise ValueError if features up to `largest`, with a state in [-1, 1], could make a gate overflow."""
    if memory:
        inputs, states = (np.abs(weight).sum(axis=1, dtype=np.float64) for weight in memory[::2])
        reached = inputs * largest + states + np.abs(memory[1]) + np.abs(memory[3])
        check_below_limit("memory", reached.max())


def check_unit_overflow(
    weights: tuple[np.ndarray, ...], biases: tuple[np.ndarray, ...], activation: str, largest: float
) -> None:
    """Raise ValueError if inputs up to `largest` could make a unit of the network overflow."""
    for number, (weight, bias) in enumerate(zip(weights, biases)):
        reached = np.abs(weight).sum(axis=1, dtype=np.float64) * largest + np.abs(bias)
        check_below_limit(f"layer{number}", reached.max())
        largest = 1.0 if activation == "tanh" else float(reached.max())


def check_below_limit(what: str, reached: float) -> None:
    """Raise ValueError unless the largest value that units can reach stays below the limit."""
    if not reached < MAX_ACTIVITY:
        raise ValueError(f"{what} must stay below {MAX_ACTIVITY:g}, its units could reach {reached:g}")
