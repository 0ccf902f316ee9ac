"""The layers of a torch module: its Linear layers in order, and the single activation used between them."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from soccer_env.actions import BOX, FULL
from soccer_env.agents.policy import ACTIVATIONS
from soccer_env.guards.checking import check_choice

SKIPPED = ("Identity", "Flatten", "Dropout")  # layers without effect when a policy plays
HALVED = (2 * len(BOX), 2 * len(FULL))  # outputs: means, then deviations
OTHERWISE = "; team_of_function lets any module play"


class Network(NamedTuple):
    """A plain feed-forward network, read from a torch module."""

    weights: tuple[np.ndarray, ...]  # (out, in) float32
    biases: tuple[np.ndarray, ...]  # (out,) float32
    activation: str
    squash: bool  # True: a Tanh follows the last layer


def network_of(module: Any, activation: str | None) -> Network:
    """Read the network of a torch module, or of several modules in a row; ValueError if it is not supported."""
    import torch

    if activation is not None:
        check_choice("activation", activation, ACTIVATIONS)
    parts = list(iterate_layers(module))
    layers: list[Any] = [part for part in parts if isinstance(part, torch.nn.Linear)]
    if not layers or parts[0] is not layers[0]:
        raise ValueError(f"the module must begin with a Linear layer, got {class_names(parts[:1])}{OTHERWISE}")
    used, squash = activations_of(parts, activation)
    weights = [parameter_array(layer.weight) for layer in layers]
    biases = [
        np.zeros(len(w), np.float32) if x.bias is None else parameter_array(x.bias) for x, w in zip(layers, weights)
    ]
    if len(weights[-1]) in HALVED:
        half = len(weights[-1]) // 2
        weights[-1], biases[-1] = weights[-1][:half], biases[-1][:half]
    return Network(tuple(weights), tuple(biases), used, squash)


def activations_of(parts: list[Any], given: str | None) -> tuple[str, bool]:
    """Return the activation between the Linear layers of a network, and whether a Tanh follows the last layer."""
    words = "".join(" " if type(part).__name__ == "Linear" else f"{type(part).__name__.lower()}," for part in parts)
    *between, last = words[1:].split(" ")  # the parts after each layer
    used = {one.removesuffix(",") or given for one in between} or {given or "tanh"}
    if not used <= set(ACTIVATIONS) or len(used) > 1 or last not in ("", "tanh,"):
        raise ValueError(
            f"the module must have one activation, Tanh or ReLU, between its Linear layers and at most a Tanh behind "
            f"the last, got {class_names(parts)}; give activation= if `forward` applies it{OTHERWISE}"
        )
    return str(used.pop()), last != ""


def iterate_layers(module: Any) -> Iterator[Any]:
    """Yield the Linear layers and activations of a module, or of several modules in a row, in order."""
    import torch

    if isinstance(module, (list, tuple)):
        for part in module:
            yield from iterate_layers(part)
    elif not isinstance(module, torch.nn.Module):
        raise ValueError(f"module must be a torch module, or several in a list, got {type(module).__name__}")
    elif isinstance(module, (torch.nn.Linear, torch.nn.Tanh, torch.nn.ReLU)):
        yield module
    elif type(module).__name__ not in SKIPPED:
        children = list(module.children())
        if not children or isinstance(module, torch.nn.ModuleDict):
            kind = type(module).__name__
            raise ValueError(f"a policy file holds Linear layers with Tanh or ReLU between, no {kind}{OTHERWISE}")
        yield from iterate_layers(children)


def class_names(parts: list[Any]) -> str:
    """Return the class names of modules as one text."""
    return ", ".join(type(part).__name__ for part in parts) or "nothing"


def parameter_array(tensor: Any) -> np.ndarray:
    """Return a torch parameter as an array of float32."""
    numbers: np.ndarray = tensor.detach().cpu().float().numpy()
    return numbers


def apply_module(function: Any, rows: np.ndarray, module: Any) -> np.ndarray:
    """Return the outputs of `function`, often a torch module, for observations (B, n), in evaluation mode.

    Of several outputs the first counts; of a distribution its mean.
    """
    import torch

    parts = module if isinstance(module, (list, tuple)) else [module]
    parameter = next(parameter for part in parts for parameter in part.parameters())
    training = [(inner, inner.training) for part in parts for inner in part.modules()]
    values = torch.as_tensor(rows, dtype=parameter.dtype, device=parameter.device)
    try:
        for part in parts:
            part.eval()
        with torch.no_grad():
            for step in function if isinstance(function, (list, tuple)) else [function]:
                values = tensor_of(step(values))
    finally:
        for inner, was in training:
            inner.training = was
    numbers: np.ndarray = values.detach().cpu().double().numpy()
    return numbers


def tensor_of(output: Any) -> Any:
    """Return the tensor in a module's output; ValueError for an output of an unknown kind."""
    import torch

    if isinstance(output, (list, tuple)) and output:
        output = output[0]
    if not isinstance(output, torch.Tensor):
        output = getattr(output, "mean", output)  # of a distribution
    if not isinstance(output, torch.Tensor):
        raise ValueError(f"the module must give a tensor of outputs, got {type(output).__name__}: give outputs=")
    return output
