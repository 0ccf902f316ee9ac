"""Any order of reset, step, save, load and look keeps a match finite, a save's future single and a replay exact."""

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule

from soccer_env import Match
from soccer_env.replay import Recorder

ANYTHING = st.one_of(
    st.none(), st.floats(), st.text(max_size=3), st.lists(st.floats(), max_size=4), st.binary(max_size=9)
)


class AnyOrder(RuleBasedStateMachine):
    """A match under every call that a user can make."""

    @initialize(
        league=st.sampled_from(["legged-2001", "middle-size-2006"]),
        mode=st.sampled_from(["off", "next_step", "same_step"]),
        placement=st.sampled_from(["instant", "drive"]),
        seed=st.integers(0, 2**32),
    )
    def begin(self, league: str, mode: str, placement: str, seed: int) -> None:
        self.match = Match(
            league, home=2, away=1, matches=2, seed=seed, autoreset=mode, placement=placement, max_cycles=60,
            minutes=0.05, controllers={"home_0": "chaser", "away": "random"},
        )  # fmt: skip
        self.recorder = Recorder(self.match)
        self.saved = self.match.save()
        self.after: str | None = None
        self.rng = np.random.default_rng(seed)

    @rule(steps=st.integers(1, 40), scale=st.floats(0.0, 1e6))
    def step(self, steps: int, scale: float) -> None:
        for _ in range(steps):
            self.match.step(self.rng.uniform(-scale, scale, (2, 3, 4)))

    @rule(actions=ANYTHING)
    def step_badly(self, actions: object) -> None:
        before = self.match.state_hash()
        with pytest.raises(ValueError):
            self.match.step(actions)
        assert self.match.state_hash() == before

    @rule(seed=st.one_of(st.none(), st.integers(0, 9)))
    def reset(self, seed: int | None) -> None:
        self.match.reset(seed=seed)

    @rule()
    def save(self) -> None:
        self.saved, self.after = self.match.save(), None

    @rule(steps=st.integers(1, 20))
    def load_and_go_on(self, steps: int) -> None:
        hashes = []
        for _ in range(2):
            self.match.load(self.saved)
            rng = np.random.default_rng(steps)
            for _ in range(steps):
                self.match.step(rng.uniform(-1.0, 1.0, (2, 3, 4)))
            hashes.append(self.match.state_hash())
        assert hashes[0] == hashes[1]

    @rule(saved=ANYTHING)
    def load_badly(self, saved: object) -> None:
        before = self.match.state_hash()
        with pytest.raises(ValueError):
            self.match.load(saved)  # type: ignore[arg-type]
        assert self.match.state_hash() == before

    @rule()
    def look(self) -> None:
        before = self.match.state_hash()
        assert np.isfinite(self.match.state()).all()
        for belief in (self.match.beliefs["ball"]["x"], self.match.tracks["distance"]):
            assert np.isfinite(belief).all()
        assert self.match.state_hash() == before

    @invariant()
    def everything_is_finite_and_inside(self) -> None:
        match = self.match
        pitch = match.league.pitch
        assert np.isfinite(match.observations).all() and np.abs(match.observations).max() <= 1.0
        assert np.isfinite(match.rewards).all()
        assert (np.abs(match.balls["x"]) < pitch.length / 2 + pitch.goal_depth + 0.3).all()
        assert (np.abs(match.robots["y"]) < pitch.width / 2 + pitch.band_side + 0.3).all()

    def teardown(self) -> None:
        if hasattr(self, "recorder"):
            self.recorder.stop().check()
            self.match.close()


AnyOrder.TestCase.settings = settings(
    max_examples=15, stateful_step_count=12, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True
)
test_any_order = AnyOrder.TestCase
