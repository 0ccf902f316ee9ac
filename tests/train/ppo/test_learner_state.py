"""What a checkpoint keeps of a learner: after it everything goes on as if there had been none."""

from copy import deepcopy
from pathlib import Path

import numpy as np
import pytest

from tests.train.evaluate.staged_rows import rows
from tests.train.ppo.staged_training import plain, tiny

pytest.importorskip("stable_baselines3")


def test_a_learner_from_a_checkpoint_divides_rewards_as_the_one_that_went_on(tmp_path: Path) -> None:
    """By the deviation of the discounted returns: of a row that is in the middle of an episode its return counts."""
    from soccer_env.train.ppo.learner import Learner

    settings = tiny(
        tmp_path, observe="truth", senses="ideal", mirror=False, central_critic=False, normalise_rewards=True
    )
    one, other = (Learner(settings, rows(action_repeat=settings.action_repeat)) for _ in range(2))
    one.reset_matches()
    one.collect_rollout(lambda: None)
    saved = deepcopy(one.state())
    other.restore(saved, one.model._last_obs)
    assert plain(other.state()) == plain(saved) and np.abs(saved["rewards"]["returns"]).min() > 0.0
    for paid in np.random.default_rng(1).normal(0.0, 0.1, (5, one.model.n_envs)):
        found = []
        for learner in (one, other):
            learner.rewards._update_reward(paid)
            found.append(learner.rewards.normalize_reward(paid))
        assert (found[0] == found[1]).all()
    one.close(), other.close()
