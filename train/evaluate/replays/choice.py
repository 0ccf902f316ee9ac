"""Choose the matches whose replays are kept: the first team's best and worst, and all matches with goals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from soccer_env.guards.names import unknown

if TYPE_CHECKING:
    from soccer_env.train.evaluate.results import MatchLine

BEST, WORST, GOALS = "best", "worst", "goals"
KINDS = (BEST, WORST, GOALS)
ORDER: dict[str, Callable[[MatchLine], Any]] = {  # the least is kept: by goal difference, goals, number of the match
    BEST: lambda line: (line.goals_against - line.goals_for, -line.goals_for, line.match),
    WORST: lambda line: (line.goals_for - line.goals_against, -line.goals_against, line.match),
}


@dataclass(frozen=True)
class Keep:
    """The replays to keep: `kinds`, words of KINDS separated by commas; `pages`: write a browser page for each as well.

    ValueError for an unknown word.
    """

    kinds: str = ""
    pages: bool = False

    def __post_init__(self) -> None:
        for kind in self.kinds_in_order:
            if kind not in KINDS:
                raise ValueError(unknown("keep", kind, KINDS))

    @property
    def kinds_in_order(self) -> list[str]:
        """Return the kinds of replays to keep in the order of KINDS, without duplicates."""
        words = [word.strip() for word in self.kinds.split(",") if word.strip()]
        return [kind for kind in KINDS if kind in words] + [word for word in words if word not in KINDS]

    def joined_with(self, before: Keep) -> Keep:
        """Return the union of this choice and an earlier choice of replays."""
        return Keep(
            ",".join(kind for kind in KINDS if kind in {*self.kinds_in_order, *before.kinds_in_order}),
            self.pages or before.pages,
        )

    def matches_to_keep(self, lines: Sequence[MatchLine]) -> list[tuple[str, MatchLine]]:
        """Return the matches whose replays should be kept, each as (kind, result line)."""
        chosen: list[tuple[str, MatchLine]] = []
        for kind in self.kinds_in_order if lines else ():
            if kind == GOALS:
                chosen += [(GOALS, line) for line in lines if line.goals_for + line.goals_against]
            else:
                chosen.append((kind, min(lines, key=ORDER[kind])))
        return chosen
