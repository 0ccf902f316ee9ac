"""Episodes that stop by time: truncated unless the clock is observed, no potential paid back, a last observation."""

from typing import Any

import gymnasium
import numpy as np
import pytest

from soccer_env import Match, OwnTerm, Rewards, Scene, WholeTruth, soccer_v0
from tests.scenes.staging import LEAGUES

SHAPED = Rewards.only(approach=1.0, gamma=1.0)
MINUTES = 0.02  # both halves together
SIZES: dict[str, Any] = {"home": 1, "away": 1}


class Blind:
    """An observation of the ball alone, without a clock."""

    names = ("ball_x", "ball_y")

    def __call__(self, match: Match) -> np.ndarray:
        place = np.stack([match.balls["x"], match.balls["y"]], axis=-1) / match.league.pitch.length
        return np.repeat(place[:, None], len(match.agents), axis=1)


def approach_of(match: Match) -> np.ndarray:
    """Return the potential of the approach of home's only robot (M,), worked out from the records."""
    robot, ball, pitch = match.robots[:, 0], match.balls, match.league.pitch
    return -np.hypot(robot["x"] - ball["x"], robot["y"] - ball["y"]) / np.hypot(pitch.length, pitch.width)


def played(match: Match) -> tuple[float, float]:
    """Play a single match to its end; return what home was paid, and the potential before."""
    before, total, rng = float(approach_of(match)[0]), 0.0, np.random.default_rng(1)
    while not (match.terminated[0] or match.truncated[0]):
        total += match.step(rng.uniform(-1.0, 1.0, (1, 2, 4)))[1][0, 0]
    return total, before


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize(("observe", "sees"), [
    ("truth", True), ("belief", True), ("percepts", True), (WholeTruth(1), True), (Blind(), False),
    ({"home": "truth", "away": Blind()}, False),
])  # fmt: skip
def test_the_final_whistle_terminates_only_where_the_clock_is_observed(league: str, observe: Any, sees: bool) -> None:
    match = Match(league, seed=3, minutes=MINUTES, observe=observe, rewards=SHAPED, **SIZES)
    paid, before = played(match)
    assert (match.terminated[0], match.truncated[0]) == (sees, not sees) and match.matches["over"][0] == 1
    assert paid == pytest.approx((0.0 if sees else approach_of(match)[0]) - before)
    assert approach_of(match)[0] < -0.01, "else nothing would be seen of it"
    place, step = match.robots["x"].copy(), int(match.matches["step"][0])
    assert not match.step(np.ones((1, 2, 4)))[1].any() and match.truncated[0] == (not sees)
    assert (match.robots["x"] == place).all() and match.matches["step"][0] == step, "a match that is over stands still"


@pytest.mark.parametrize(("observe", "sees"), [("truth", True), (Blind(), False)])
def test_a_potential_of_ones_own_is_not_paid_back_either(observe: Any, sees: bool) -> None:
    own = OwnTerm(lambda match: np.repeat(approach_of(match)[:, None], 2, axis=1), kind="potential")
    rewards = Rewards.only(gamma=1.0, extra={"own": own})
    match = Match(seed=3, minutes=MINUTES, observe=observe, rewards=rewards, **SIZES)
    paid, before = played(match)
    assert paid == pytest.approx((0.0 if sees else approach_of(match)[0]) - before)


@pytest.mark.parametrize("league", LEAGUES)
def test_a_limit_of_steps_and_the_limit_of_a_drill_pay_no_potential_back(league: str) -> None:
    scene = Scene("wait", "nothing happens", success="home scores", time_limit=0.5, in_play=True)
    for settings in ({"max_cycles": 12}, {"scene": scene, "episode": "drill"}):
        match = Match(league, seed=3, rewards=SHAPED, **settings, **SIZES)
        paid, before = played(match)
        assert match.truncated[0] and not match.terminated[0]
        assert paid == pytest.approx(approach_of(match)[0] - before)


def test_the_last_observation_of_a_truncated_episode_is_that_of_the_match_going_on() -> None:
    settings: dict[str, Any] = {"matches": 2, "seed": 5, **SIZES}
    cut, whole = Match(max_cycles=10, autoreset="same_step", **settings), Match(**settings)
    rng = np.random.default_rng(2)
    for _ in range(10):
        actions = rng.uniform(-1.0, 1.0, (2, 2, 4))
        _, rewards, terminated, truncated = cut.step(actions)
        _, others, _, _ = whole.step(actions)
        assert (rewards == others).all()
    assert truncated.all() and not terminated.any() and cut.ended.tolist() == [0, 1]
    assert (cut.final["observations"] == whole.observations).all() and (cut.final["state"] == whole.state()).all()
    assert (cut.observations != whole.observations).any(), "a new episode has begun"


def test_every_api_truncates_at_an_unobserved_whistle_and_keeps_the_last_observation() -> None:
    settings: dict[str, Any] = {"minutes": MINUTES, "observe": Blind(), **SIZES}
    env = soccer_v0.parallel_env(**settings)
    env.reset(seed=1)
    while env.agents:
        seen, _, terminated, truncated, _ = env.step({agent: np.ones(4) for agent in env.agents})
    assert all(truncated.values()) and not any(terminated.values()) and seen["home_0"].shape == (2,)
    vector = gymnasium.make_vec(
        "soccer_env/Legged2001-Match-1v1-v0", num_envs=2, opponents="still", autoreset_mode="SameStep", **settings
    )
    vector.reset(seed=1)
    truncated = np.zeros(2, bool)
    while not truncated.any():
        seen, _, terminated, truncated, infos = vector.step(np.ones((2, 4)))
    assert truncated.all() and not terminated.any() and infos["final_obs"][0].shape == (2,)


def test_a_learner_of_stable_baselines_is_told_to_bootstrap() -> None:
    pytest.importorskip("stable_baselines3")
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

    for observe, told in ((Blind(), True), ("truth", False)):
        env = SoccerVecEnv(players=[(1, 1)], matches=2, opponents="still", minutes=MINUTES, observe=observe)
        env.reset()
        dones = np.zeros(2, bool)
        while not dones.any():
            _, _, dones, infos = env.step(np.ones((2, 4)))
        assert [info["TimeLimit.truncated"] for info in infos] == [told, told]
        assert all(info["terminal_observation"].shape == env.observation_space.shape for info in infos)
