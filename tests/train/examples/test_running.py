"""The pages that need no more than the extra `train`, in a shortened form."""

from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("torch")
pytest.importorskip("stable_baselines3")

from soccer_env import Match
from soccer_env.train.examples import ppo_cleanrl, ppo_sb3
from soccer_env.train.examples.empty_goal import EMPTY_GOAL, share_scored


@pytest.mark.slow
def test_what_stable_baselines3_learned_is_saved_and_plays(tmp_path: Path) -> None:
    out = tmp_path / "runs" / "ppo_sb3.zip"
    assert 0.0 <= ppo_sb3.main(steps=1, out=out) <= 1.0  # one rollout
    team = f"{out}:league=middle-size-2006,observe=belief,action_repeat=8,at_once=False"
    match = Match("middle-size-2006", home=1, away=1, controllers={"home": team, "away": "still"}, seed=1)
    for _ in range(20):
        match.step()
    assert np.abs(match.robots["command"]["forward"][0, 0]) > 0.0


@pytest.mark.slow
def test_the_one_file_of_ppo_learns_the_same_from_the_same_seed() -> None:
    assert ppo_cleanrl.main(steps=4096, seed=3) == ppo_cleanrl.main(steps=4096, seed=3)


def test_the_measure_tells_a_robot_that_scores_from_one_that_stands() -> None:
    assert share_scored(lambda seen: np.zeros((len(seen), 4)), episodes=20) == 0.0
    names = Match(home=1, matches=1, **EMPTY_GOAL).observation_names
    ahead, left = names.index("ball_x"), names.index("ball_y")

    def chase(seen: np.ndarray) -> np.ndarray:
        turn = np.clip(3.0 * np.arctan2(seen[:, left], seen[:, ahead]), -1.0, 1.0)
        one = np.ones(len(seen))
        return np.stack([one, 0.0 * one, turn, one], axis=1)

    assert share_scored(chase, episodes=20) > 0.0
