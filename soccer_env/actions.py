"""Actions of a learner: box (4 numbers), full (7 numbers, with the head) and discrete (an index).

Numbers in [-1, 1] are shares of the league's limits; finite numbers outside are clipped, other values refused.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.guards.checking import check_choice

BOX = ("forward", "left", "turn", "kick")
FULL = (*BOX, "head", "pan", "tilt")
MEANINGS = {
    "forward": "speed ahead (back below 0), of the top speed",
    "left": "speed to the left, of the top speed",
    "turn": "turn rate counter-clockwise, of the top rate",
    "kick": "0 or less no kick, above that its strength",
    "head": "below 0 the head tracks the ball by itself, else pan and tilt are obeyed",
    "pan": "pan of the head, left positive, of its limit",
    "tilt": "tilt of the head, -1 the lowest, 1 the highest",
}
DISCRETE: dict[str, tuple[float, float, float, float]] = {
    "stand": (0, 0, 0, 0),
    "forward": (1, 0, 0, 0),
    "back": (-1, 0, 0, 0),
    "left": (0, 1, 0, 0),
    "right": (0, -1, 0, 0),
    "turn left": (0, 0, 1, 0),
    "turn right": (0, 0, -1, 0),
    "curve left": (1, 0, 0.5, 0),
    "curve right": (1, 0, -0.5, 0),
    "forward slowly": (0.4, 0, 0, 0),
    "kick": (0, 0, 0, 1),
    "pass": (0, 0, 0, 0.4),
}
KINDS = ("box", "full", "discrete")
FLOAT = np.dtype(np.float64)
DISCRETE_TABLE = np.array(list(DISCRETE.values()), dtype=np.float64)


@dataclass(frozen=True)
class ActionKind:
    """How a learner's actions are given."""

    name: str

    def __post_init__(self) -> None:
        check_choice("actions", self.name, KINDS)

    @property
    def size(self) -> int:
        """Return how many numbers an action has (a discrete action is expanded to four)."""
        return len(FULL) if self.name == "full" else len(BOX)

    def space(self) -> Any:
        """Return a new gymnasium space of one robot's actions."""
        from gymnasium import spaces

        if self.name == "discrete":
            return spaces.Discrete(len(DISCRETE))
        return spaces.Box(-1.0, 1.0, (self.size,), np.float32)

    def numbers(self, action: Any, agent: str) -> np.ndarray:
        """Convert an agent's action to (size,) float64 numbers; ValueError names the agent and the value."""
        if self.name == "discrete":
            row: np.ndarray = DISCRETE_TABLE[discrete_index(action, agent)]
            return row
        try:
            numbers = np.asarray(action)
        except (TypeError, ValueError) as error:
            raise ValueError(f"action of {agent} must be {self.size} numbers, got {action!r}") from error
        if numbers.dtype.kind not in "fiu" or numbers.shape != (self.size,):
            raise ValueError(
                f"action of {agent} must be {self.size} numbers, got {numbers.dtype} of shape {numbers.shape}"
            )
        return numbers.astype(np.float64)


def discrete_index(action: Any, agent: str) -> int:
    """Convert an agent's discrete action to an index; ValueError names the agent and the value."""
    number = np.asarray(action)
    if number.shape not in ((), (1,)) or number.dtype.kind not in "iu":
        raise ValueError(f"action of {agent} must be one integer, got {action!r}")
    index = int(number.reshape(()))
    if not 0 <= index < len(DISCRETE):
        raise ValueError(f"action of {agent} must be 0 to {len(DISCRETE) - 1}, got {index}")
    return index


def actions_to_numbers(
    kind: ActionKind, actions: Any, agents: list[str], learns: np.ndarray, matches: int
) -> np.ndarray:
    """Convert the actions of M matches to (M, R, 4 or 7) float64; ValueError names the first agent with a wrong action.

    Rows of robots that teams play (`learns` (R,) is 0) may hold anything.
    """
    if kind.name == "discrete":
        return expand_discrete(actions, agents, matches)
    shape = (matches, len(agents), kind.size)
    numbers = np.asarray(actions)
    if numbers.dtype.kind not in "fiu" or numbers.shape != shape:
        raise ValueError(f"actions must be numbers of shape {shape}, got {numbers.dtype} of shape {numbers.shape}")
    if numbers.dtype is not FLOAT or not numbers.flags.carray:  # kernels are compiled for this kind of array alone
        numbers = np.array(numbers, FLOAT, order="C")
    if not all_finite(numbers):
        finite = np.isfinite(numbers)
        bad = np.argwhere(~finite & (learns[:, None] == 1))
        if len(bad):
            m, r, _ = bad[0]
            raise ValueError(f"action of {agents[r]} in match {m} is not finite: {numbers[m, r].tolist()}")
        numbers = np.where(finite, numbers, 0.0)
    return numbers


def expand_discrete(actions: Any, agents: list[str], matches: int) -> np.ndarray:
    """Convert discrete actions (M, R) to numbers (M, R, 4)."""
    shape = (matches, len(agents))
    numbers = np.asarray(actions)
    if numbers.shape != shape:
        raise ValueError(f"actions must be integers of shape {shape}, got shape {numbers.shape}")
    if numbers.dtype.kind not in "iu" or numbers.min() < 0 or numbers.max() >= len(DISCRETE_TABLE):
        for m, r in np.ndindex(*shape):
            discrete_index(numbers[m, r], f"{agents[r]} in match {m}")
        raise ValueError(f"actions must be integers of shape {shape}, got {numbers.dtype}")
    expanded: np.ndarray = DISCRETE_TABLE[numbers]
    return expanded


@compiled
def all_finite(numbers):
    """Tell whether all numbers (M, R, n) are finite; twice as fast as numpy for one match."""
    total = 0.0
    for number in numbers.flat:
        total += 0.0 * number
    return total == 0.0


@compiled
def write_learner_commands(robots, actions, first, last, learns):
    """Clip actions (M, R, 4 or 7) into the commands of the robots that learn (R,); the rest keep their command."""
    full = actions.shape[2] > 4
    for m in range(first, last):
        for r in range(robots.shape[1]):
            if learns[r] == 0:
                continue
            command, action = robots[m, r].command, actions[m, r]
            command.forward, command.left = clip(action[0], -1.0, 1.0), clip(action[1], -1.0, 1.0)
            command.turn, command.kick = clip(action[2], -1.0, 1.0), clip(action[3], -1.0, 1.0)
            command.head = clip(action[4], -1.0, 1.0) if full else -1.0
            command.pan = clip(action[5], -1.0, 1.0) if full else 0.0
            command.tilt = clip(action[6], -1.0, 1.0) if full else 0.0
