"""The actor and the critic that PPO trains, and the export of the actor to a policy file.

The actor sees the robot's own observation; the critic sees this, optionally followed by the true state of the match
(`state()`). With the kind "attention" other players are pooled before the actor's layers; the critic stays plain. With
`mirror` the actor is the mean of a network and of its left-right mirror image: for a mirrored observation it returns
exactly the mirrored action. An actor with a memory learns from sequences (`recurrent.py`).
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import torch
from stable_baselines3.common.policies import ActorCriticPolicy
from torch import nn

from soccer_env.agents.attention import Layout, attention_width, layout_of
from soccer_env.agents.policy import Policy, training_fields
from soccer_env.agents.recurrent import memory_shapes
from soccer_env.leagues.league import League
from soccer_env.observations import Entry
from soccer_env.observations import layout as entries_of
from soccer_env.observations.reflection import action_signs, observation_signs
from soccer_env.train.ppo.settings import TrainSettings

ACTIVATIONS = {"tanh": nn.Tanh, "relu": nn.ReLU}
ABSENT = -1e38  # logit of an empty slot: below all that a policy may reach, and finite, for the gradient's sake


def layers(sizes: Sequence[int], activation: str) -> nn.Sequential:
    """Return linear layers of the given sizes, each followed by the activation."""
    parts: list[nn.Module] = []
    for wide, out in zip(sizes, sizes[1:], strict=False):
        parts += [nn.Linear(wide, out), ACTIVATIONS[activation]()]
    return nn.Sequential(*parts)


class Attention(nn.Module):
    """The attention that pools other players in networks of kind "attention"; equations in `agents.attention`."""

    def __init__(self, layout: Layout, width: int, activation: str) -> None:
        super().__init__()
        self.layout = layout
        self.features = layout.features(width)
        self.activation = ACTIVATIONS[activation]()
        self.encoders = nn.ModuleList(nn.Linear(entries, width) for entries in layout.entries)
        self.queries = nn.ModuleList(nn.Linear(layout.fixed, width, bias=False) for _ in layout.entries)

    def forward(self, own: torch.Tensor) -> torch.Tensor:
        """Return the fixed entries of an observation, followed by the pooled team-mates and opponents."""
        layout = self.layout
        sizes = [slots * entries for slots, entries in zip(layout.slots, layout.entries, strict=True)]
        fixed, *players = torch.split(own, [layout.fixed, *sizes], dim=1)
        pooled = [fixed]
        for rows, entries, encoder, query in zip(players, layout.entries, self.encoders, self.queries, strict=True):
            rows = rows.reshape(len(rows), -1, entries)
            encoded, absent = self.activation(encoder(rows)), rows[..., 0] <= 0.0
            logits = (encoded * query(fixed).unsqueeze(1)).sum(-1).masked_fill(absent, ABSENT)
            weights = logits.softmax(1).masked_fill(absent, 0.0)
            pooled.append((weights.unsqueeze(-1) * encoded).sum(1))
        return torch.cat(pooled, dim=1)

    def tensors(self) -> list[torch.Tensor]:
        """Return the parameters, in the order of `attention.TENSORS`."""
        pairs: Any = zip(self.encoders, self.queries, strict=True)
        return [part for encoder, query in pairs for part in (encoder.weight, encoder.bias, query.weight)]


class ActorAndCritic(nn.Module):
    """Actor and critic networks over features (B, n + s); the actor sees the first n, and their mirror image."""

    signs: torch.Tensor | None

    def __init__(
        self, inputs: int, features: int, hidden: Sequence[int], critic: Sequence[int], activation: str, signs: Any,
        attention: Attention | None = None, units: int = 0,
    ) -> None:  # fmt: skip
        super().__init__()
        self.inputs = inputs
        self.latent_dim_pi = hidden[-1]
        self.latent_dim_vf = critic[-1]
        self.register_buffer("signs", signs, persistent=False)
        self.attention = attention
        width = attention.features if attention else inputs
        self.memory = nn.GRUCell(width, units) if units else None
        self.policy_net = layers([width + units, *hidden], activation)
        self.value_net = layers([features, *critic], activation)

    def forward(self, features: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        """Return the last hidden layers of the actor (B or 2 B, h) and of the critic (B, h)."""
        return self.forward_actor(features), self.forward_critic(features)

    def forward_actor(self, features: torch.Tensor) -> torch.Tensor:
        """Return the actor's last hidden layer (B, h); with a mirror (2 B, h), the mirrored observations last."""
        latent: torch.Tensor = self.policy_net(self.read(features))
        return latent

    def read(self, features: torch.Tensor) -> torch.Tensor:
        """Return what memory or layers of the actor read, (B, f) or with a mirror (2 B, f)."""
        own = features[:, : self.inputs]
        own = own if self.signs is None else torch.cat([own, own * self.signs])
        return self.attention(own) if self.attention else own

    def forward_critic(self, features: torch.Tensor) -> torch.Tensor:
        """Return the critic's last hidden layer (B, h)."""
        latent: torch.Tensor = self.value_net(features)
        return latent


class MirrorHead(nn.Module):
    """The last layer of a mirrored actor: the mean of the action and the mirrored-back action of the mirror image."""

    signs: torch.Tensor

    def __init__(self, linear: nn.Module, signs: torch.Tensor) -> None:
        super().__init__()
        self.linear = linear
        self.register_buffer("signs", signs, persistent=False)

    def forward(self, latent: torch.Tensor) -> torch.Tensor:
        """Return actions (B, a) for the last hidden layer (2 B, h)."""
        plain, mirrored = self.linear(latent).chunk(2)
        actions: torch.Tensor = 0.5 * (plain + mirrored * self.signs)
        return actions


class SoccerPolicy(ActorCriticPolicy):
    """The policy class for stable-baselines3's PPO; `entries` describe a robot's own observation."""

    states: torch.Tensor | None = None  # of a memory, in the running matches

    def __init__(
        self,
        observation_space: Any,
        action_space: Any,
        lr_schedule: Any,
        *,
        entries: Sequence[Entry],
        hidden: Sequence[int] = (64, 64),
        critic: Sequence[int] = (64, 64),
        activation: str = "tanh",
        mirror: bool = False,
        kind: str = "slots",
        memory: int = 0,
        **settings: Any,
    ) -> None:
        self.entries = entries
        self.hidden = hidden
        self.critic = critic
        self.kind = kind
        self.activation = activation
        self.mirror = mirror
        self.memory = memory
        super().__init__(
            observation_space, action_space, lr_schedule, activation_fn=ACTIVATIONS[activation], **settings
        )

    def _build_mlp_extractor(self) -> None:
        signs = torch.tensor(observation_signs(self.entries), dtype=torch.float32) if self.mirror else None
        sizes = (len(self.entries), self.features_dim, self.hidden, self.critic)
        attention = None
        if self.kind == "attention":
            attention = Attention(layout_of(self.entries), attention_width(self.hidden), self.activation)
        self.mlp_extractor: Any = ActorAndCritic(*sizes, self.activation, signs, attention, self.memory)

    def _build(self, lr_schedule: Any) -> None:
        super()._build(lr_schedule)
        if self.mirror:
            signs = torch.tensor(action_signs(self.action_space.shape[0]), dtype=torch.float32)  # type: ignore[index]
            self.action_net: nn.Module = MirrorHead(self.action_net, signs)
        self.optimizer = self.optimizer_class(self.parameters(), lr=lr_schedule(1), **self.optimizer_kwargs)  # type: ignore[call-arg]

    def mean_actions(self, observations: torch.Tensor) -> torch.Tensor:
        """Return the actor's mean actions (B, a), without exploration noise and not clipped."""
        actions: torch.Tensor = self.action_net(self.mlp_extractor.forward_actor(observations))
        return actions

    def answers(
        self, observations: torch.Tensor, asked: torch.Tensor, batch: int, generator: torch.Generator
    ) -> Iterator[tuple[torch.Tensor, torch.Tensor]]:
        """Yield (mean actions, asked actions) of `batch` decisions (n, ...) after another, in a random order."""
        order = torch.randperm(len(observations), generator=generator)
        for chosen in torch.split(order, batch):
            seen, wanted = (part[chosen].to(self.device) for part in (observations, asked))
            yield self.mean_actions(seen), wanted

    def actor_parameters(self) -> list[nn.Parameter]:
        """Return the parameters of the actor alone, including those of its exploration noise."""
        actor = self.mlp_extractor
        parts = [actor.attention, actor.memory, actor.policy_net, self.action_net]
        return [*(parameter for part in parts if part is not None for parameter in part.parameters()), self.log_std]


def export_policy(
    network: SoccerPolicy, *, name: str, league: League, observe: str, action_repeat: int, made: Mapping[str, str],
    senses: str = "", pose: str = "",
) -> Policy:  # fmt: skip
    """Return the actor of a trained network as a Policy, to be written to a file."""
    weights, biases, pooling, memory = (
        tuple(part.detach().cpu().numpy().astype(np.float32) for part in parts) for parts in actor_tensors(network)
    )
    inputs, actions = tuple(entry.name for entry in network.entries), {4: "box", 7: "full"}[len(biases[-1])]
    return Policy(
        name=name, **training_fields(league), observe=observe, inputs=inputs, actions=actions,
        action_repeat=action_repeat, kind=network.kind, activation=network.activation, mirror=network.mirror,
        weights=weights, biases=biases, made=made, attention=pooling, senses=senses, pose=pose, memory=memory,
    )  # fmt: skip


def actor_tensors(network: SoccerPolicy) -> tuple[list[torch.Tensor], ...]:
    """Return the weights, biases, attention and memory tensors of an actor, in the order of `Policy`."""
    head = network.action_net.linear if isinstance(network.action_net, MirrorHead) else network.action_net
    linear: list[Any] = [part for part in network.mlp_extractor.policy_net if isinstance(part, nn.Linear)]
    linear.append(head)
    attention, cell = network.mlp_extractor.attention, network.mlp_extractor.memory
    memory = [cell.weight_ih, cell.bias_ih, cell.weight_hh, cell.bias_hh] if cell else []
    pooling = attention.tensors() if attention else []
    return [part.weight for part in linear], [part.bias for part in linear], pooling, memory


def widened_policy(policy: Policy, inputs: tuple[str, ...]) -> Policy:
    """Return a policy of more inputs that plays as before: the weights of entries that it did not read are 0.

    ValueError names an entry that `inputs` lack.
    """
    missing = [name for name in policy.inputs if name not in inputs]
    if missing:
        raise ValueError(f"policy {policy.name!r} reads the entry {missing[0]!r}, which is not observed")
    old = layout_of(policy.entries).fixed if policy.attention else len(policy.inputs)
    new = old + len(inputs) - len(policy.inputs)
    columns = [*map(inputs.index, policy.inputs[:old])]

    def widen(array: np.ndarray) -> np.ndarray:
        wide = np.zeros((len(array), new + array.shape[1] - old), np.float32)
        wide[:, columns], wide[:, new:] = array[:, :old], array[:, old:]
        return wide

    attention = tuple(widen(part) if index % 3 == 2 else part for index, part in enumerate(policy.attention))  # Q
    memory = tuple(widen(part) if index == 0 else part for index, part in enumerate(policy.memory))
    weights = (widen(policy.weights[0]), *policy.weights[1:])
    return replace(policy, inputs=inputs, weights=weights, attention=attention, memory=memory)


def copy_actor(network: SoccerPolicy, policy: Policy) -> None:
    """Copy a policy's actor into a network, which may observe more; its noise and critic stay unchanged."""
    policy = widened_policy(policy, tuple(entry.name for entry in network.entries))
    given = (policy.weights, policy.biases, policy.attention, policy.memory)
    with torch.no_grad():
        for parts, arrays in zip(actor_tensors(network), given, strict=True):
            for part, array in zip(parts, arrays, strict=True):
                part.copy_(torch.tensor(array))


def blank_policy(settings: TrainSettings, league: League) -> Policy:
    """Return a policy of the shape that a run trains, with all weights 0, so that its robots stand still."""
    entries = entries_of(league, settings.observe)
    names = tuple(entry.name for entry in entries)
    actions = 4
    features = len(entries)
    pooling: tuple[tuple[int, ...], ...] = ()
    if settings.kind == "attention":
        layout, width = layout_of(entries), attention_width(settings.hidden_sizes)
        features, pooling = layout.features(width), layout.shapes(width)
    remembering = memory_shapes(settings.memory, features) if settings.memory else ()
    sizes = (features + settings.memory, *settings.hidden_sizes, actions)
    shapes = list(zip(sizes[1:], sizes, strict=False))
    return Policy(
        name=settings.name, **training_fields(league), observe=settings.observe, inputs=names, actions="box",
        action_repeat=settings.action_repeat, activation=settings.activation, mirror=settings.mirror,
        kind=settings.kind,
        weights=tuple(np.zeros(shape, np.float32) for shape in shapes),
        biases=tuple(np.zeros(out, np.float32) for out, _ in shapes), made={},
        attention=tuple(np.zeros(shape, np.float32) for shape in pooling),
        memory=tuple(np.zeros(shape, np.float32) for shape in remembering), **settings.own_senses,
    )  # fmt: skip
