"""Checks of the arrays of a policy: float32, finite, of the right shape, and too small to overflow."""

from collections.abc import Sequence

import numpy as np

MAX_ACTIVITY = 1e37  # largest value of a unit; float32 ends at 3.4e38


def check_array(what: str, array: object) -> None:
    """Raise ValueError unless `array` is an array of float32."""
    if not isinstance(array, np.ndarray) or array.dtype != np.float32:
        kind = array.dtype if isinstance(array, np.ndarray) else type(array).__name__
        raise ValueError(f"{what} must be an array of float32, got {kind}")


def check_tensors(names: Sequence[str], arrays: Sequence[np.ndarray], shapes: Sequence[tuple[int, ...]]) -> None:
    """Raise ValueError unless all arrays are finite and of the given shapes."""
    for name, array, shape in zip(names, arrays, shapes, strict=True):
        if array.shape != shape:
            raise ValueError(f"{name} must have the shape {shape}, got {array.shape}")
        if not np.isfinite(array).all():
            raise ValueError(f"{name} must be finite, it holds NaN or infinity")


def check_below_limit(what: str, reached: float) -> None:
    """Raise ValueError unless the largest value that units can reach stays below the limit."""
    if not reached < MAX_ACTIVITY:
        raise ValueError(f"{what} must stay below {MAX_ACTIVITY:g}, its units could reach {reached:g}")
