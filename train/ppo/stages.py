"""The stages of a run: which team sizes and opponents are trained together, and when the run moves on."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from soccer_env.train.written_settings import split_distinct_names, split_players

MEMORY = 0.999  # weight of the goals so far after an episode: about the last thousand episodes count
DOUBT = 10.0  # goals of each side that are assumed before the first one
Sizes = tuple[int, int]  # robots of home, of away


@dataclass(frozen=True)
class Stage:
    """A stage of a run: the team sizes (home, away) and the opponents that are trained together."""

    sizes: tuple[Sizes, ...]
    opponents: tuple[str, ...]


def parse_stages(players: str, opponents: str) -> tuple[Stage, ...]:
    """Return the stages of "1v1;1v1,2v2" and "still;chaser,random"; a text of one stage holds for all of them."""
    sizes, names = str(players).split(";"), str(opponents).split(";")
    count = max(len(sizes), len(names))
    if not {len(sizes), len(names)} <= {1, count}:
        raise ValueError(
            f"players and opponents must have equally many stages, or one of them a single stage, "
            f"got {len(sizes)} and {len(names)}"
        )
    sizes, names = (texts * (count // len(texts)) for texts in (sizes, names))
    return tuple(
        Stage(
            tuple(split_players(part, 3) for part in split_distinct_names("players", players)),
            split_distinct_names("opponents", opponents),
        )
        for players, opponents in zip(sizes, names, strict=True)
    )


class StageClock:
    """Which stage a run is in, and whether it is over: by the share of goals at each team size, or by decisions."""

    def __init__(self, stages: Sequence[Stage], share: float, most: int) -> None:
        self.stages, self.share, self.most = stages, share, most
        self.number, self.began = 0, 0  # of the stage; the step at which it began
        self.goals = self._no_goals()

    @property
    def stage(self) -> Stage:
        """Return the present stage."""
        return self.stages[self.number]

    def take(self, results: Iterable[Any]) -> None:
        """Count the goals of finished episodes."""
        for result in results:
            goals = self.goals[result.players]
            goals[:] = [MEMORY * goals[0] + result.goals_for, MEMORY * goals[1] + result.goals_against]

    def shares(self) -> dict[Sizes, float]:
        """Return the share of recent goals that the run has scored, by team size; one half before the first goal."""
        return {
            sizes: (scored + DOUBT) / (scored + conceded + 2.0 * DOUBT)
            for sizes, (scored, conceded) in self.goals.items()
        }

    def move_on(self, step: int) -> bool:
        """Begin the next stage if the present one is over and there is one; tell whether it began."""
        if self.number + 1 == len(self.stages):
            return False
        if min(self.shares().values()) < self.share and step - self.began < self.most:
            return False
        self.number, self.began = self.number + 1, step
        self.goals = self._no_goals()
        return True

    def _no_goals(self) -> dict[Sizes, list[float]]:
        return {sizes: [0.0, 0.0] for sizes in self.stage.sizes}

    def state(self) -> dict[str, Any]:
        """Return the state for a checkpoint."""
        return {"number": self.number, "began": self.began, "goals": [list(goals) for goals in self.goals.values()]}

    def restore(self, state: dict[str, Any]) -> None:
        """Restore a state that `state` returned."""
        self.number, self.began = state["number"], state["began"]
        self.goals = {sizes: list(goals) for sizes, goals in zip(self.stage.sizes, state["goals"], strict=True)}
