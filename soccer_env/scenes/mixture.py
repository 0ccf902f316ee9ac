"""A mixture of scenes: each episode begins in one of them, drawn by their shares."""

from dataclasses import dataclass, field
from math import isfinite

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.random_numbers import draw_uniform, start_streams
from soccer_env.scenes.scene import Scene
from soccer_env.types import NOISE_STREAMS

CHOOSER = (1 << 20) + 2  # owner of its random-number stream; lower owners belong to `teams.lineup.CHOOSER`


@dataclass(frozen=True, repr=False)
class Mixture(Scene):
    """A scene that is drawn anew for each episode from several scenes, by the match's seed."""

    parts: tuple[Scene, ...] = ()  # the scenes
    shares: tuple[float, ...] = field(default=())  # relative frequencies of the parts

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.parts or len(self.shares) != len(self.parts):
            raise ValueError(f"a Mixture needs a share for each of its scenes, got {len(self.shares)} and {self.parts}")
        if not all(share > 0.0 and isfinite(share) for share in self.shares):
            raise ValueError(f"shares of a Mixture must be above 0, got {self.shares}")

    def of_episode(self, seed: int, episode: int) -> Scene:
        """Return the scene that was drawn for an episode."""
        noise = np.zeros(NOISE_STREAMS, np.uint64)
        with np.errstate(over="ignore"):
            start_streams(noise, np.uint64(seed), episode, CHOOSER)
            drawn = draw_uniform(noise, 0)
        edges = np.cumsum(self.shares)
        return self.parts[min(int(np.searchsorted(edges, drawn * edges[-1], side="right")), len(self.parts) - 1)]

    def check(self, league: League, home: int, away: int) -> None:
        """Raise ValueError if any scene of the mixture does not fit the league or the team sizes."""
        for part in self.parts:
            part.check(league, home, away)
