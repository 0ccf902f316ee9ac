"""A Lineup: several teams, one of which is drawn to play each episode."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.random_numbers import draw_uniform, start_streams
from soccer_env.teams.registry import make_team, result_name
from soccer_env.teams.team import Team
from soccer_env.types import AWAY, NOISE_STREAMS

# Owner of the stream that home's lineup draws from; away's is the next; robots are 1 + 2 number + team.
CHOOSER = 1 << 20


class Lineup:
    """Several teams, one of which is drawn to play each episode; usable wherever a team is expected.

    teams: names as `make_team` takes them, or team objects. weights: relative frequencies, equal by default;
    `lineup.weights` (teams,) may be changed between steps, and counts from the next episode on; so does `add`. names:
    names of the teams in infos and results, all different; by default their own. The match's seed, the number of the
    episode, the side and the weights decide which team plays. ValueError says what is wrong.

        soccer_v0.parallel_env(opponents=Lineup(["chaser@0.2", "sacks-2001", "runs/a.safetensors"], weights=[1, 2, 3]))
    """

    def __init__(self, teams: Sequence[str | Team], weights: Any = None, names: Sequence[str] | None = None) -> None:
        if isinstance(teams, str) or not isinstance(teams, Sequence) or not teams:
            raise ValueError(f"a Lineup needs a list of one team at least, got {teams!r}")
        if any(isinstance(team, Lineup) for team in teams):
            raise ValueError("a Lineup is made of teams, not of lineups")
        self.teams = tuple(make_team(team) for team in teams)
        self.names = team_names(teams, self.teams) if names is None else tuple(names)
        self.weights = np.ones(len(teams)) if weights is None else np.array(weights)
        if len(set(self.names)) != len(teams) or len(self.names) != len(teams):
            raise ValueError(f"the {len(teams)} teams of a Lineup must have different names, got {self.names}")
        check_weights(self.weights, len(teams))
        self.weights = self.weights.astype(np.float64)

    def __repr__(self) -> str:
        shares = ", ".join(f"{name!r}: {weight:g}" for name, weight in zip(self.names, self.weights, strict=True))
        return f"Lineup({{{shares}}})"

    def add(self, team: str | Team, weight: float = 1.0, name: str | None = None) -> str:
        """Add a team, which may play from the next episode on, in running matches too; return its name in infos.

        ValueError, and no change, for a name that another team has, a lineup, or a weight that is no number from 0.
        """
        added = Lineup([team], names=None if name is None else [name])
        if added.names[0] in self.names:
            raise ValueError(f"a team of the Lineup has the name {added.names[0]!r}: give the new one another name")
        weights = np.append(self.weights, weight)
        check_weights(weights, len(self.teams) + 1)
        self.teams, self.names, self.weights = self.teams + added.teams, self.names + added.names, weights
        return added.names[0]

    def choose(self, seed: int, episode: int, side: int = AWAY) -> int:
        """Return the index of the team that plays an episode on a side (HOME or AWAY)."""
        noise = np.zeros(NOISE_STREAMS, np.uint64)
        with np.errstate(over="ignore"):
            start_streams(noise, np.uint64(seed), episode, CHOOSER + side)
            drawn = draw_uniform(noise, 0)
        check_weights(self.weights, len(self.teams))
        edges = np.cumsum(self.weights)
        return int(min(np.searchsorted(edges, drawn * edges[-1], side="right"), np.flatnonzero(self.weights)[-1]))


def team_names(given: Sequence[str | Team], made: Sequence[Team]) -> tuple[str, ...]:
    """Return names for the teams in results: each team's own name, or its given text where names are equal."""
    own = [result_name(*pair) for pair in zip(given, made, strict=True)]
    return tuple(
        text if isinstance(text, str) and own.count(name) > 1 else name for text, name in zip(given, own, strict=True)
    )


def check_weights(weights: np.ndarray, count: int) -> None:
    """Raise ValueError unless there are `count` finite weights, none negative and not all 0."""
    numbers = weights.dtype.kind in "fiu" and weights.shape == (count,)
    if not numbers or not (weights >= 0.0).all() or not 0.0 < weights.sum() < np.inf:
        raise ValueError(f"weights of a Lineup must be {count} numbers from 0, not all 0, got {weights}")
