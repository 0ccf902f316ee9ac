"""Explanations of a team for viewers: words for its memory, its planned path, the forces on a robot.

A team names its explanation as "MODULE:NAME" in `CompiledTeam.explains`; the module is imported when a viewer asks.
Nothing here runs while a match is played, and nothing here changes a match: all arguments are copies.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from typing import NamedTuple

import numpy as np

from soccer_env.teams.registry import NAMES, import_factory, make_team
from soccer_env.teams.team import Team


class DecisionInputs(NamedTuple):
    """Copies of all inputs to one player's decision, as records of shape (1,) that a kernel takes."""

    beliefs: np.ndarray  # (1,) BELIEF
    tracks: np.ndarray  # (1, slots) TRACK
    memory: np.ndarray  # (1,) of the team's `memory_dtype`
    noise: np.ndarray  # (1, streams)
    constants: np.ndarray  # (1,) CONSTANTS
    settings: np.ndarray  # of the team


Plan = Callable[[DecisionInputs], np.ndarray]
Forces = Callable[[DecisionInputs, np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Explanation:
    """The explanations that a team offers, each None if it has none; places and vectors in the team frame."""

    shown: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Fields of the memory to show, with words for their values, () for a number."""
    plan: Plan | None = None
    """plan(mind): points (N, 2) [m] of the way that it would take now, none if it plans no way."""
    forces: Forces | None = None
    """forces(mind, target (2,), points (P, 2)): the force on a robot at each point, (P, 2), of no unit."""
    needs_target: bool = False
    """Whether the forces pull to the end of the plan, not to a goal of their own."""


def explanation_of(team: object) -> Explanation | None:
    """Return a team's explanation, None if it has none."""
    module, _, name = str(getattr(team, "explains", "")).partition(":")
    explanation: Explanation | None = getattr(import_module(module), name) if module else None
    return explanation


def shipped_team(name: str) -> Team | None:
    """Return the team of this name that comes with the package, None for any other name from a file.

    A strength or settings after the name are ignored if the team does not have them.
    """
    plain = name.partition(":")[0].partition("@")[0]
    if plain not in NAMES:
        return None
    try:
        return make_team(name)
    except ValueError:
        return make_team(plain)


def team_description(where: str) -> str:
    """Return the first line of the description of the team MODULE:NAME, or of its variant's own function."""
    module, _, function = where.partition(":")
    if function == "team":
        return docstring_first_line(module)
    try:
        text = (import_factory(where).__doc__ or "").strip().partition("\n")[0]
    except (ImportError, AttributeError):
        return ""
    return f"A variant of {docstring_first_line(module).partition(':')[0]}: {text.removeprefix('Return ')}"


def docstring_first_line(module: str) -> str:
    """Return the first line of a module's docstring, "" if it has none or cannot be imported."""
    try:
        return (import_module(module).__doc__ or "").strip().partition("\n")[0]
    except ImportError:
        return ""
