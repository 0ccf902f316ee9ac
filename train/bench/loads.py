"""Timed loads: the core in random and chaser play, the bare physics of this play, a reference scene, pictures.

Every load is live play: finished matches restart, their clocks are spread over a half, and they play for WARM_UP
seconds before the first timing.
"""

from time import perf_counter, process_time
from typing import Any, Protocol

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.match.variation import THEMSELVES, names_of
from soccer_env.physics.engine import reference
from soccer_env.physics.engine.space_batch import SpaceBatch

PLAYERS = 3  # a side
PICTURED = 960  # [px] width of a picture
TEAMS = {"legged-2001": "sacks-2001", "middle-size-2006": "heinemann-2006"}  # in a picture
OVERLAYS = "belief,trail,roles"
HOLD = 0.5  # [s] that a random action lasts: shorter ones cancel out and robots stand still
WARM_UP = 10.0  # [s] of play before the first timing
DRAWS = 32  # sets of random actions, used in turn

REFERENCE_STEPS = 25  # control steps until the bodies of the reference get new velocities, untimed


def senses_for(pose: str | None) -> dict[str, Any]:
    """Return the settings of a Match with ideal senses, or with sensors, beliefs and the kind of own pose."""
    return {"senses": "ideal"} if pose is None else {"senses": "sensors", "observe": "belief", "pose": pose}


class Load(Protocol):
    """A load that can be timed."""

    def sample(self, steps: int) -> float:
        """Play `steps` control steps of all matches; return the seconds per match step."""
        ...


class CoreLoad:
    """The batched core: random actions of learners, or one team against itself; `pose`: None for ideal senses.

    With a pose, as "percept", all robots have sensors and beliefs. varied: all numbers that can vary do so a little.
    """

    kind: type[Match] = Match

    def __init__(
        self, league: str, team: str | None, matches: int, threads: int, seed: int, pose: str | None = None,
        players: int = PLAYERS, varied: bool = False,
    ) -> None:  # fmt: skip
        self.rng = np.random.default_rng(seed)
        settings = find_league(league)
        ranges = {name: (0.0, 0.01) if name in THEMSELVES else (0.95, 1.05) for name in names_of(settings)}
        self.match = self.kind(
            league, home=players, away=players, matches=matches, threads=threads, seed=seed, autoreset="same_step",
            controllers=None if team is None else {"home": team, "away": team}, minutes=settings.evaluation_minutes,
            variation=ranges if varied else None, **senses_for(pose),
        )  # fmt: skip
        self.draws = None if team is not None else self.rng.uniform(-1.0, 1.0, (DRAWS, matches, 2 * players, 4))
        self.hold, self.steps = round(HOLD * settings.control_rate), 0
        self.match.matches["clock"] = self.rng.uniform(0.0, self.match.settings.half_length, matches)
        self.run(round(WARM_UP * settings.control_rate))

    def run(self, steps: int) -> None:
        """Play `steps` control steps of all matches."""
        for _ in range(steps):
            actions = None if self.draws is None else self.draws[self.steps // self.hold % DRAWS]
            self.match.step(actions)
            self.steps += 1

    def sample(self, steps: int) -> float:
        """Return the seconds per match step."""
        start = perf_counter()
        self.run(steps)
        return (perf_counter() - start) / (steps * self.match.count)


class BareMatch(Match):
    """A Match that also measures the time spent in cpSpaceStep."""

    def __init__(self, *arguments: Any, **settings: Any) -> None:
        self.bare = 0.0  # [s] in cpSpaceStep since the start
        super().__init__(*arguments, **settings)
        self.batch.act = self._act_bare  # type: ignore[method-assign]  # the same stages, one of them timed

    def _act_bare(self, first: int, last: int) -> None:
        self.batch.act_in_stages(first, last, self._advance_bare)

    def _advance_bare(self, dt: float, substeps: np.ndarray, first: int, last: int) -> None:
        """Advance the Spaces and time cpSpaceStep alone."""
        links = self.batch.physics.links
        reference.write_slice(links, first, last)
        start = perf_counter()
        reference.step_bare_slice(links, substeps, dt, first, last)
        self.bare += perf_counter() - start
        reference.read_slice(links, first, last)


class OwnPhysicsLoad(CoreLoad):
    """Time cpSpaceStep alone, in the league's own Spaces, with the play and the substeps of the core."""

    kind = BareMatch

    def sample(self, steps: int) -> float:
        """Return the seconds of cpSpaceStep per match step."""
        assert isinstance(self.match, BareMatch)
        before = self.match.bare
        self.run(steps)
        return (self.match.bare - before) / (steps * self.match.count)


class ReferencePhysicsLoad:
    """Time cpSpaceStep alone in a fixed scene, the same for every league: 6 discs, a ball, 7 wall segments."""

    def __init__(self, matches: int, seed: int) -> None:
        self.rng = np.random.default_rng(seed)
        self.batch = SpaceBatch(matches, 1 + reference.REFERENCE_DISCS, "c")
        self.substeps = np.full(matches, reference.REFERENCE_SUBSTEPS)
        for m in range(matches):
            self.batch.set_space(m, reference.reference_space(self.rng))

    def sample(self, steps: int) -> float:
        """Return the seconds per match step, averaged over at least `steps` steps."""
        spent, matches = 0.0, len(self.substeps)
        rounds = -(-steps // REFERENCE_STEPS)
        for _ in range(rounds):
            self.batch.velocities[:, : 1 + reference.REFERENCE_DISCS] = self.rng.uniform(
                -1.0, 1.0, (matches, 1 + reference.REFERENCE_DISCS, 3)
            )
            reference.write_slice(self.batch.links, 0, matches)
            start = perf_counter()
            for _ in range(REFERENCE_STEPS):
                reference.step_bare_slice(self.batch.links, self.substeps, reference.REFERENCE_DT, 0, matches)
            spent += perf_counter() - start
        return spent / (rounds * REFERENCE_STEPS * matches)


class PictureLoad:
    """A match of a team against itself, drawn after every control step."""

    def __init__(self, league: str, seed: int) -> None:
        from soccer_env.render import Picture
        from soccer_env.render.overlays.onlooker import Onlooker

        team = TEAMS[league]
        self.match = Match(league, controllers={"home": team, "away": team}, seed=seed, autoreset="same_step")
        self.picture, self.onlooker = Picture(league, PICTURED), Onlooker(self.match, OVERLAYS)
        self.sample(2, True)

    def sample(self, frames: int, overlays: bool) -> list[float]:
        """Return the processor seconds of each of `frames` frames, drawn by one thread."""
        spent, match = [], self.match
        for _ in range(frames):
            match.step()
            start = process_time()
            over = self.onlooker.see(match, PICTURED) if overlays else []
            self.picture.draw(match.matches[0], match.balls[0], match.robots[0], overlays=over)
            spent.append(process_time() - start)
        return spent
