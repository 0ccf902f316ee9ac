"""Actions of a learner: box (4 numbers), full (7, with the head), discrete (an index), multi (4 indices), skills.

Numbers in [-1, 1] are shares of the league's limits; finite numbers outside are clipped, other values refused. The
indices of "multi" choose levels of forward, left and turn, and a kick. The index of "skills" chooses a skill of the
scripted players with its target, which the robot carries out by its own belief. A mask tells which indices have an
effect now; a masked one is obeyed as far as the robot can, and a masked skill becomes the search for the ball.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.guards.checking import check_choice
from soccer_env.leagues.league import League
from soccer_env.skills.choices import SKILLS

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
LEVELS = (-1.0, -0.5, 0.0, 0.5, 1.0)  # of forward, left and turn in "multi"
SOFT = 0.4  # [1] strength of a soft kick, assumed: that of "pass"
ASIDE = 0.56  # [1] pan of a kick aside: 50 degrees of 89.6, as the kick aside of the legged league goes
KICKS: dict[str, tuple[float, float, float]] = {  # of "multi": kick, head, pan
    "none": (0, -1, 0),
    "soft": (SOFT, -1, 0),
    "full": (1, -1, 0),
    "aside left": (1, 1, ASIDE),
    "aside right": (1, 1, -ASIDE),
}
WALK = len(BOX) - 1  # the parts of "multi" before the kick
PARTS = {"discrete": (len(DISCRETE),), "multi": (*(len(LEVELS),) * WALK, len(KICKS))}  # choices of each index
KINDS = ("box", "full", *PARTS, "skills")
FLOAT = np.dtype(np.float64)
SIGNS = (1.0, -1.0, -1.0, 1.0, 1.0, -1.0, 1.0)  # of the numbers of FULL in a left-right mirror
DISCRETE_TABLE = np.array(list(DISCRETE.values()), dtype=np.float64)
LEVEL_TABLE, KICK_TABLE = np.array(LEVELS), np.array(list(KICKS.values()), dtype=np.float64)
NO_KICK = np.zeros(WALK * len(LEVELS), bool)  # of the levels of "multi"
KICKING = {"discrete": DISCRETE_TABLE[:, WALK] > 0.0, "multi": np.concatenate([NO_KICK, KICK_TABLE[:, 0] > 0.0])}
STANDING = {
    "discrete": ~DISCRETE_TABLE.any(axis=1),
    "multi": np.concatenate([*[LEVEL_TABLE == 0.0] * WALK, KICK_TABLE[:, 0] == 0.0]),
}
NAMES = {"discrete": list(DISCRETE), "skills": list(SKILLS)}  # of the choices
STANDING_SKILL = list(SKILLS).index("stand")
KICKING_ASIDE = np.concatenate([NO_KICK, KICK_TABLE[:, 2] != 0.0])  # of "multi"


@dataclass(frozen=True)
class ActionKind:
    """How a learner's actions are given."""

    name: str

    def __post_init__(self) -> None:
        check_choice("actions", self.name, KINDS)

    @property
    def size(self) -> int:
        """Return how many numbers an action has.

        An index of "discrete" is expanded to four numbers, those of "multi" to seven; a skill remains one number.
        """
        if self.name == "skills":
            return 1
        return len(FULL) if self.name in ("full", "multi") else len(BOX)

    @property
    def parts(self) -> tuple[int, ...]:
        """Return how many choices each index of an action has; () for numbers."""
        return (len(SKILLS),) if self.name == "skills" else PARTS.get(self.name, ())

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of the choices of an index; () for numbers, and for "multi", whose choices are levels."""
        return tuple(NAMES.get(self.name, ()))

    @property
    def shape(self) -> tuple[int, ...]:
        """Return the shape of one robot's action: () for a single index."""
        return (self.size,) if not self.parts else () if len(self.parts) == 1 else (len(self.parts),)

    def still(self, matches: int, robots: int) -> np.ndarray:
        """Return actions (M, R, *shape) with which robots stand and their heads track the ball."""
        actions = np.zeros((matches, robots, *self.shape), np.int64 if self.parts else np.float64)
        if self.name == "multi":
            actions[..., :WALK] = LEVELS.index(0.0)
        elif self.name == "full":
            actions[..., FULL.index("head")] = -1.0
        return actions

    def space(self) -> Any:
        """Return a new gymnasium space of one robot's actions."""
        from gymnasium import spaces

        if self.parts:
            return spaces.MultiDiscrete(list(self.parts)) if self.shape else spaces.Discrete(self.parts[0])
        return spaces.Box(-1.0, 1.0, (self.size,), np.float32)

    def given(self, action: Any, agent: str) -> np.ndarray:
        """Return an agent's action as an array of `shape`, checked; ValueError names the agent and the value."""
        return self.indices(action, agent) if self.parts else self.numbers(action, agent)

    def indices(self, action: Any, agent: str) -> np.ndarray:
        """Convert an agent's indices to an array of `shape`; ValueError names the agent and the value."""
        number = np.asarray(action)
        if number.dtype.kind not in "iu" or number.shape not in (self.shape, (len(self.parts),)):
            what = f"{len(self.parts)} integers" if self.shape else "one integer"
            raise ValueError(f"action of {agent} must be {what}, got {action!r}")
        indices = number.reshape(self.shape)
        if (indices < 0).any() or (indices >= np.reshape(self.parts, self.shape)).any():
            raise ValueError(f"action of {agent} must be 0 to {max(self.parts) - 1}, got {indices.tolist()}")
        return indices

    def expand(self, indices: np.ndarray) -> np.ndarray:
        """Convert checked indices (..., *shape) to numbers (..., size)."""
        if self.name == "skills":
            return indices[..., None].astype(np.float64)
        if self.name == "discrete":
            rows: np.ndarray = DISCRETE_TABLE[indices]
            return rows
        kick, head, pan = np.moveaxis(KICK_TABLE[indices[..., WALK]], -1, 0)
        walk = LEVEL_TABLE[indices[..., :WALK]]
        return np.concatenate([walk, np.stack([kick, head, pan, np.zeros_like(pan)], axis=-1)], axis=-1)

    def choose(self, values: np.ndarray) -> np.ndarray:
        """Return the indices (B, *shape) of the choices with the largest values (B, n) of each part."""
        parts = np.split(values, np.cumsum(self.parts)[:-1], axis=1)
        return np.stack([part.argmax(axis=1) for part in parts], axis=-1).reshape(-1, *self.shape)

    def numbers(self, action: Any, agent: str) -> np.ndarray:
        """Convert an agent's action to (size,) float64 numbers; ValueError names the agent and the value."""
        if self.parts:
            return self.expand(self.indices(action, agent))
        try:
            numbers = np.asarray(action)
        except (TypeError, ValueError) as error:
            raise ValueError(f"action of {agent} must be {self.size} numbers, got {action!r}") from error
        if numbers.dtype.kind not in "fiu" or numbers.shape != (self.size,):
            raise ValueError(
                f"action of {agent} must be {self.size} numbers, got {numbers.dtype} of shape {numbers.shape}"
            )
        return numbers.astype(np.float64)


def actions_to_numbers(
    kind: ActionKind, actions: Any, agents: list[str], learns: np.ndarray, matches: int
) -> np.ndarray:
    """Convert the actions of M matches to (M, R, size) float64; ValueError names the first agent with a wrong action.

    Rows of robots that teams play (`learns` (R,) is 0) may hold anything.
    """
    if kind.parts:
        return expand_indices(kind, actions, agents, matches)
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


def expand_indices(kind: ActionKind, actions: Any, agents: list[str], matches: int) -> np.ndarray:
    """Convert indices (M, R, *kind.shape) to numbers (M, R, size)."""
    shape = (matches, len(agents), *kind.shape)
    numbers = np.asarray(actions)
    if numbers.shape != shape:
        raise ValueError(f"actions must be integers of shape {shape}, got shape {numbers.shape}")
    most = np.reshape(kind.parts, kind.shape)
    if numbers.dtype.kind not in "iu" or (numbers < 0).any() or (numbers >= most).any():
        for m, r in np.ndindex(matches, len(agents)):
            kind.indices(numbers[m, r], f"{agents[r]} in match {m}")
        raise ValueError(f"actions must be integers of shape {shape}, got {numbers.dtype}")
    return np.ascontiguousarray(kind.expand(numbers))


def action_masks(
    kind: ActionKind, matches: np.ndarray, robots: np.ndarray, league: League, skills: np.ndarray | None = None
) -> np.ndarray:
    """Return masks (M, R, n) int8 of matches (M,) and robots (M, R): 1 for each choice with an effect now.

    The choices of all indices follow one another: n is 12 for "discrete", 20 for "multi". A robot that may not act (it
    is out, has fallen, or is steered by the referee) can only stand. A robot whose kicker is not ready cannot kick, nor
    a goalkeeper without a kicker, and none aside in a league without such kicks. `skills` (M, R, n): those that apply
    by the robots' beliefs, for the kind "skills". ValueError for actions in numbers.
    """
    if not kind.parts:
        raise ValueError(
            f"actions in numbers have no masks: give actions='discrete', 'multi' or 'skills', not {kind.name!r}"
        )
    acts = (robots["active"] == 1) & (robots["fallen"] <= 0.0) & (matches["placing"] == 0)[:, None]
    if skills is not None:
        return np.where(acts[..., None], skills, np.arange(skills.shape[-1]) == STANDING_SKILL).astype(np.int8)
    kicks = acts & (robots["kick_clock"] == 0.0) & (league.kicker.keeper_kicks | (robots["keeper"] == 0))
    masks = np.where(KICKING[kind.name], kicks[..., None], acts[..., None]) | STANDING[kind.name]
    if league.kicker.aside <= 0.0 and kind.name == "multi":
        masks &= ~KICKING_ASIDE
    allowed: np.ndarray = masks.astype(np.int8)
    return allowed


def mask_for_space(kind: ActionKind, mask: np.ndarray) -> Any:
    """Return one robot's mask (n,) in the form that its gymnasium space samples by: a tuple of arrays for "multi"."""
    return tuple(np.split(mask, np.cumsum(kind.parts)[:-1])) if kind.shape else mask


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


def action_mirror(kind: str) -> tuple[np.ndarray, np.ndarray]:
    """Return which output (n,) of a policy each one becomes in a left-right mirror, and with which sign (n,).

    kind: "box" and "full", whose numbers keep their places, or "skills", of which left and right ones change places.
    """
    if kind == "skills":
        sides = {"left": "right", "right": "left"}
        turned = (" ".join(sides.get(word, word) for word in name.split()) for name in SKILLS)
        return np.array([*map(list(SKILLS).index, turned)]), np.ones(len(SKILLS))
    size = len(BOX) if kind == "box" else len(FULL)
    return np.arange(size), np.array(SIGNS[:size])
