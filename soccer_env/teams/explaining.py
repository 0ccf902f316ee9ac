"""How a team explains itself to people who watch it: words for what it remembers, where it plans to go, what pulls it.

A team names the module of its explanation as "MODULE:NAME" in `CompiledTeam.explains`; it is imported when somebody
looks. Nothing here is asked while a match is played, and nothing that is asked changes a match: all arguments are
copies.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from typing import NamedTuple

import numpy as np

from soccer_env.teams.registry import NAMES, found, make_team
from soccer_env.teams.team import Team


class Mind(NamedTuple):
    """What one player decides from, in copies of its own: records of shape (1,), as a kernel takes them."""

    beliefs: np.ndarray  # (1,) BELIEF
    tracks: np.ndarray  # (1, slots) TRACK
    memory: np.ndarray  # (1,) of the team's `memory_dtype`
    noise: np.ndarray  # (1, streams)
    constants: np.ndarray  # (1,) CONSTANTS
    settings: np.ndarray  # of the team


Plan = Callable[[Mind], np.ndarray]
Forces = Callable[[Mind, np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Explanation:
    """What a team can tell of itself; None: it does not work that way. Places and vectors are of the team frame."""

    shown: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Fields of the memory that people want to see, with words for their values, () for a number."""
    plan: Plan | None = None
    """plan(mind): points (N, 2) [m] of the way that it would take now, none where it does not plan."""
    forces: Forces | None = None
    """forces(mind, target (2,), points (P, 2)): the force on a robot at each point, (P, 2), of no unit."""
    needs_target: bool = False
    """Whether the forces pull to the end of the plan; else to a goal of their own."""


def explanation_of(team: object) -> Explanation | None:
    """Return what a team tells of itself, None for one that tells nothing."""
    module, _, name = str(getattr(team, "explains", "")).partition(":")
    found: Explanation | None = getattr(import_module(module), name) if module else None
    return found


def shipped_team(name: str) -> Team | None:
    """Return a shipped team by its name, None for any other: a name out of a file must import nothing else.

    A strength or settings behind the name that no team has are left out.
    """
    plain = name.partition(":")[0].partition("@")[0]
    if plain not in NAMES:
        return None
    try:
        return make_team(name)
    except ValueError:
        return make_team(plain)


def what_it_is(where: str) -> str:
    """Return the first line about a team that MODULE:NAME makes: that of its own function for a variant of another."""
    module, _, function = where.partition(":")
    if function == "team":
        return first_line(module)
    try:
        text = (found(where).__doc__ or "").strip().partition("\n")[0]
    except (ImportError, AttributeError):
        return ""
    return f"A variant of {first_line(module).partition(':')[0]}: {text.removeprefix('Return ')}"


def first_line(module: str) -> str:
    """Return the first line of a module's docstring, "" if it has none or cannot be imported."""
    try:
        return (import_module(module).__doc__ or "").strip().partition("\n")[0]
    except ImportError:
        return ""
