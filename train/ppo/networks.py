"""The actor and the critic that PPO trains, and the export of the actor to a policy file.

The actor sees the robot's own observation; the critic sees this, optionally followed by the true state of the match
(`state()`). With `mirror` the actor is the mean of a network and of its left-right mirror image: for a mirrored
observation it returns exactly the mirrored action. Actions of an actor with a memory depend on earlier observations,
too (`recurrent.py`).
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import torch
from torch import nn

from soccer_env.actions import action_mirror
from soccer_env.agents.policy import ACTIONS, Policy, training_fields
from soccer_env.agents.recurrent import memory_shapes
from soccer_env.leagues.league import League
from soccer_env.observations import Entry
from soccer_env.observations import layout as entries_of
from soccer_env.observations.reflection import observation_signs
from soccer_env.train.ppo.recurrent import Memory
from soccer_env.train.ppo.settings import TrainSettings

ACTIVATIONS = {"tanh": nn.Tanh, "relu": nn.ReLU}
TEMPERATURE = 0.3  # of a policy that chooses skills, when it plays: the greatest output alone dithers between equals
ACTION_GAIN = 0.01  # of the actor's last layer: an untrained actor stands still, but for the noise


def layers(sizes: Sequence[int], activation: str) -> nn.Sequential:
    """Return linear layers of the given sizes, each followed by the activation."""
    parts: list[nn.Module] = []
    for wide, out in zip(sizes, sizes[1:], strict=False):
        parts += [linear(wide, out, 2.0**0.5), ACTIVATIONS[activation]()]
    return nn.Sequential(*parts)


def linear(inputs: int, outputs: int, gain: float) -> nn.Linear:
    """Return a linear layer with orthogonal weights of this gain and no bias at first [Saxe et al. 2014]."""
    layer = nn.Linear(inputs, outputs)
    nn.init.orthogonal_(layer.weight, gain)
    nn.init.zeros_(layer.bias)
    return layer


class MirrorHead(nn.Module):
    """The last layer of a mirrored actor: the mean of the outputs and the mirrored-back outputs of the mirror image."""

    places: torch.Tensor
    signs: torch.Tensor

    def __init__(self, linear: nn.Module, kind: str) -> None:
        super().__init__()
        self.linear = linear
        places, signs = action_mirror(kind)
        self.register_buffer("places", torch.tensor(places), persistent=False)
        self.register_buffer("signs", torch.tensor(signs, dtype=torch.float32), persistent=False)

    def forward(self, latent: torch.Tensor) -> torch.Tensor:
        """Return outputs (B, a) for the last hidden layer (2 B, h)."""
        plain, mirrored = self.linear(latent).chunk(2)
        outputs: torch.Tensor = 0.5 * (plain + mirrored[:, self.places] * self.signs)
        return outputs


class SoccerPolicy(nn.Module):
    """Actor and critic: the actor sees a robot's own observation, described by `entries`; the critic sees more.

    features: numbers that the critic sees, of which the first are the robot's own observation; actions: "box" or
    "full", or "skills", which are chosen; noise: initial standard deviation of the numbers of an action; memory: units
    of a recurrent memory, 0 for none.
    """

    signs: torch.Tensor | None

    def __init__(
        self, entries: Sequence[Entry], features: int, actions: str = "box", *, hidden: Sequence[int] = (64, 64),
        critic: Sequence[int] = (64, 64), activation: str = "tanh", mirror: bool = False, noise: float = 1.0,
        memory: int = 0,
    ) -> None:  # fmt: skip
        super().__init__()
        self.entries, self.actions, self.activation, self.mirror = entries, actions, activation, mirror
        inputs, outputs = len(entries), ACTIONS[actions]
        signs = torch.tensor(observation_signs(entries), dtype=torch.float32) if mirror else None
        self.register_buffer("signs", signs, persistent=False)
        self.memory = Memory(entries, inputs, memory) if memory else None
        self.policy_net = layers([inputs + memory, *hidden], activation)
        head = linear(hidden[-1], outputs, ACTION_GAIN)
        self.action_net: nn.Module = MirrorHead(head, actions) if mirror else head
        self.critic_net = nn.Sequential(*layers([features, *critic], activation), linear(critic[-1], 1, 1.0))
        self.log_std = nn.Parameter(torch.full((outputs,), float(np.log(noise))))
        self._ignore_players()

    def _ignore_players(self) -> None:
        """Set the weights of all slots for other players to 0, from which training moves those that it fills.

        Random weights of slots that training leaves empty would disturb the policy wherever they are filled: in a
        larger team always, and before that by each ghost, a player who is not there.
        """
        players = [i for i, entry in enumerate(self.entries) if entry.slot is not None]
        weights, _, memory = actor_tensors(self)
        with torch.no_grad():
            for part in (weights[0], *memory[:1]):
                part[:, players] = 0.0

    @property
    def chooses_skills(self) -> bool:
        """Tell whether an action is a choice among skills, and not numbers."""
        return self.actions == "skills"

    @property
    def device(self) -> torch.device:
        """Return the device of the parameters."""
        return self.log_std.device

    def no_states(self, rows: int) -> torch.Tensor:
        """Return the states (images, rows, units) of the memory at the beginning of episodes; 0 units without."""
        units = self.memory.units if self.memory else 0
        return torch.zeros(1 + self.mirror, rows, units, device=self.device)

    def outputs(
        self, features: torch.Tensor, states: torch.Tensor | None = None, begins: torch.Tensor | None = None
    ) -> tuple[torch.Tensor, torch.Tensor]:
        """Return the actor's outputs (T, N, a), such as mean actions that are not clipped, and the states after them.

        features: (T, N, n or more) of T decisions of N rows; states: (images, N, units) before them, None for 0;
        begins: (T, N) flags of decisions that begin an episode, None for none.
        """
        steps, rows = features.shape[:2]
        own = features[..., : len(self.entries)].flatten(0, 1)
        images = own if self.signs is None else torch.cat([own, own * self.signs])
        states = self.no_states(rows) if states is None else states
        if self.memory:
            images, states = self.memory(images, states, features, begins)
        return self.action_net(self.policy_net(images)).view(steps, rows, -1), states

    def values(self, features: torch.Tensor) -> torch.Tensor:
        """Return the critic's values (B,) of features (B, n)."""
        values: torch.Tensor = self.critic_net(features)[:, 0]
        return values

    def actor_parameters(self) -> list[nn.Parameter]:
        """Return the parameters of the actor alone, its exploration noise last."""
        parts = [self.memory, self.policy_net, self.action_net]
        return [*(parameter for part in parts if part is not None for parameter in part.parameters()), self.log_std]


def export_policy(
    network: SoccerPolicy, *, name: str, league: League, observe: str, action_repeat: int, made: Mapping[str, str],
    senses: str = "", pose: str = "",
) -> Policy:  # fmt: skip
    """Return the actor of a trained network as a Policy, to be written to a file."""
    weights, biases, memory = (
        tuple(part.detach().cpu().numpy().astype(np.float32) for part in parts) for parts in actor_tensors(network)
    )
    inputs = tuple(entry.name for entry in network.entries)
    return Policy(
        name=name, **training_fields(league), observe=observe, inputs=inputs, actions=network.actions,
        action_repeat=action_repeat, activation=network.activation, mirror=network.mirror,
        weights=weights, biases=biases, made=made, senses=senses, pose=pose, memory=memory,
        temperature=TEMPERATURE if network.chooses_skills else 0.0,
    )  # fmt: skip


def actor_tensors(network: SoccerPolicy) -> tuple[list[torch.Tensor], ...]:
    """Return the weights, biases and memory tensors of an actor, in the order of `Policy`."""
    head = network.action_net.linear if isinstance(network.action_net, MirrorHead) else network.action_net
    linear: list[Any] = [part for part in network.policy_net if isinstance(part, nn.Linear)]
    linear.append(head)
    memory = network.memory.tensors() if network.memory else []
    return [part.weight for part in linear], [part.bias for part in linear], memory


def widened_policy(policy: Policy, inputs: tuple[str, ...]) -> Policy:
    """Return a policy of more inputs that plays as before: the weights of entries that it did not read are 0.

    ValueError names an entry that `inputs` lack.
    """
    missing = [name for name in policy.inputs if name not in inputs]
    if missing:
        raise ValueError(f"policy {policy.name!r} reads the entry {missing[0]!r}, which is not observed")
    old, new = len(policy.inputs), len(inputs)
    columns = [*map(inputs.index, policy.inputs)]

    def widen(array: np.ndarray) -> np.ndarray:
        wide = np.zeros((len(array), new + array.shape[1] - old), np.float32)
        wide[:, columns], wide[:, new:] = array[:, :old], array[:, old:]
        return wide

    memory = tuple(widen(part) if index == 0 else part for index, part in enumerate(policy.memory))
    weights = (widen(policy.weights[0]), *policy.weights[1:])
    return replace(policy, inputs=inputs, weights=weights, memory=memory)


def copy_actor(network: SoccerPolicy, policy: Policy) -> None:
    """Copy a policy's actor into a network, which may observe more; its noise and critic stay unchanged."""
    policy = widened_policy(policy, tuple(entry.name for entry in network.entries))
    given = (policy.weights, policy.biases, policy.memory)
    with torch.no_grad():
        for parts, arrays in zip(actor_tensors(network), given, strict=True):
            for part, array in zip(parts, arrays, strict=True):
                part.copy_(torch.tensor(array))


def blank_policy(settings: TrainSettings, league: League) -> Policy:
    """Return a policy of the shape that a run trains, with all weights 0, so that its robots stand still."""
    entries = entries_of(league, settings.observe)
    names = tuple(entry.name for entry in entries)
    remembering = memory_shapes(settings.memory, len(names)) if settings.memory else ()
    sizes = (len(names) + settings.memory, *settings.hidden_sizes, ACTIONS[settings.actions])
    shapes = list(zip(sizes[1:], sizes, strict=False))
    return Policy(
        name=settings.name, **training_fields(league), observe=settings.observe, inputs=names, actions=settings.actions,
        action_repeat=settings.action_repeat, activation=settings.activation, mirror=settings.mirror,
        weights=tuple(np.zeros(shape, np.float32) for shape in shapes),
        biases=tuple(np.zeros(out, np.float32) for out, _ in shapes), made={},
        memory=tuple(np.zeros(shape, np.float32) for shape in remembering), **settings.own_senses,
    )  # fmt: skip
