"""AgileRL's IPPO over its vector of PettingZoo envs: two robots that share a policy learn to score.

Needs: agilerl==2.58.0 peft==0.21.0 pettingzoo==1.26.1 tensordict==0.13.0
Reached: they score in none of 200 episodes after 60,000 steps of seed 1, 73 s, 34 s of the processor without workers;
with torch 2.13.0.
"""

from typing import Any

import numpy as np
import torch
from agilerl.algorithms import IPPO
from agilerl.training.train_multi_agent_on_policy import train_multi_agent_on_policy
from agilerl.vector import AsyncPettingZooVecEnv

from soccer_env import soccer_v0
from soccer_env.train.examples.empty_goal import EMPTY_GOAL, share_scored


def make_env() -> soccer_v0.ParallelSoccer:
    """Return the env of one process."""
    return soccer_v0.parallel_env(**EMPTY_GOAL, home=2, infos="none")


def main(steps: int = 60_000, copies: int = 2, batch: int = 2_000, seed: int = 1) -> float:
    """Learn for `steps` steps of two robots, and return the share of episodes in which they score."""
    torch.manual_seed(seed)
    np.random.seed(seed)
    torch.set_num_threads(1)
    env = make_env()
    spaces: list[list[Any]] = [
        [of(agent) for agent in env.possible_agents] for of in (env.observation_space, env.action_space)
    ]
    layers = {"hidden_size": [64], "activation": "Tanh"}
    learner = IPPO(
        *spaces, agent_ids=env.possible_agents, lr=1e-3, batch_size=500, learn_step=batch, update_epochs=10,
        ent_coef=0.0, net_config={"latent_dim": 64, "encoder_config": layers, "head_config": layers},
    )  # fmt: skip
    envs = AsyncPettingZooVecEnv([make_env] * copies)
    train_multi_agent_on_policy(
        envs, "empty-goal", "IPPO", [learner], max_steps=steps, evo_steps=steps, eval_steps=1, verbose=False
    )
    envs.close()
    return share_scored(lambda seen: act(learner, seen), home=2)


def act(learner: Any, seen: np.ndarray) -> np.ndarray:
    """Return the learner's mean actions (n, 4)."""
    actor = learner.actors["home"]
    with torch.no_grad():
        actor(torch.as_tensor(seen))
        return actor.head_net.dist.mu.numpy()
