"""Ask for a user's own reward terms and functions that play, and check what user code returns, where it enters."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from soccer_env.function_teams import ask_functions
from soccer_env.rewards import COUNT, OwnTerm, Rewards

Match = Any  # soccer_env.match.Match, which stands above this file


def checked(values: Any, shape: tuple[int, ...], what: str, limit: float = np.inf) -> np.ndarray:
    """Return what user code returned as numbers of a shape; ValueError says which code returned what instead."""
    try:
        numbers = np.broadcast_to(np.asarray(values, np.float64), shape)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{what} must return numbers of shape {shape}, got shape {np.shape(values)}") from error
    with np.errstate(invalid="ignore"):
        wrong = ~(np.abs(numbers) <= limit) | ~np.isfinite(numbers)
    if wrong.any():
        at = tuple(int(i) for i in np.argwhere(wrong)[0])
        allowed = "finite numbers" if limit == np.inf else f"numbers in [{-limit:g}, {limit:g}]"
        raise ValueError(f"{what} must return {allowed}, got {numbers[at]} at {at}")
    return numbers


class OwnTerms:
    """The reward terms of a user's own, in the columns behind those of every match."""

    def __init__(self, rewards: Rewards) -> None:
        self._terms = cast("dict[str, OwnTerm]", rewards.extra)  # Rewards has made terms of plain functions
        self._waiting: np.ndarray = np.zeros(0, bool)  # (M,) matches that were over before the control step
        self._before: dict[str, np.ndarray] = {}  # potentials (M, R) before it, by name

    def begin(self, match: Match) -> None:
        """Ask what a user's code says before a control step: functions that play, and potentials.

        Of the records as they are now, whoever wrote them.
        """
        ask_functions(match)
        if self._terms:
            self._waiting = match.matches["over"] == 1
            shaping = {name: term for name, term in self._terms.items() if term.kind == "potential"}
            self._before = {name: ask(match, name, term) for name, term in shaping.items()}

    def pay(self, match: Match) -> None:
        """Add what a control step pays to `terms` and `rewards`; a match that was over gets nothing."""
        if not self._terms:  # the usual case: the lines below would cost a match alone 1 us of the 15 us of a step
            return
        over, gamma = match.matches["over"] == 1, float(match.batch.weights["gamma"][0])
        for column, (name, term) in enumerate(self._terms.items(), start=COUNT):
            value = ask(match, name, term)
            if term.kind == "potential":
                value = gamma * np.where(over[:, None], 0.0, value) - self._before[name]
            value = -term.weight * value if term.kind == "cost" else term.weight * value
            match.terms[..., column] = np.where(self._waiting[:, None], 0.0, value)
            match.rewards += match.terms[..., column]


def ask(match: Match, name: str, term: OwnTerm) -> np.ndarray:
    """Return the numbers (M, R) of a term; ValueError names the term and what it returned instead."""
    return checked(term.function(match), match.rewards.shape, f"reward term {name!r}")
