"""PPO of RLlib learns at 1 v 1 in the middle size, in a vector environment, against a pool of its own past selves.

Needs: ray[rllib]==2.60.0 torch==2.13.0
Reached: a draw with `still`, 0 : 0 goals, after 81,920 decisions of seed 1, 140 s of the processor on a very busy
machine. That is too short to learn to score; how far the default takes it is not measured yet.
RLlib takes Gymnasium 1.2.2 alone. With `num_env_runners` above 0 other workers of Ray play.
"""

from functools import partial
from pathlib import Path
from typing import Any

from ray.rllib.algorithms.ppo import PPOConfig
from ray.rllib.core.rl_module import RLModule
from ray.rllib.core.rl_module.default_model_config import DefaultModelConfig
from ray.tune import register_env

from soccer_env import Lineup
from soccer_env.agents.learned import team_from_policy
from soccer_env.agents.policy import Policy, training_fields
from soccer_env.agents.policy_file import dump
from soccer_env.api.gymnasium_vector import SoccerVectorEnv
from soccer_env.leagues import find_league
from soccer_env.observations import entry_names
from soccer_env.train.evaluate import EvaluateSettings, evaluate

LEAGUE, REPEAT = find_league("middle-size-2006"), 8  # control steps of a decision, 0.16 s
GAME: dict[str, Any] = {
    "league": LEAGUE, "home": 1, "away": 1, "observe": "belief", "senses": "ideal", "action_repeat": REPEAT,
    "rewards": "training", "scene": "scattered", "minutes": 16 / 15, "max_cycles": 199,
}  # fmt: skip
FIRST, BATCH = ["still", "chaser@0.1"], 4096  # opponents at the start; decisions of a rollout
MODULE = "learner_group/learner/rl_module/default_policy"  # in a checkpoint


def read_policy(checkpoint: Path, name: str) -> Policy:
    """Return the actor of a checkpoint as a policy."""
    state = RLModule.from_checkpoint(checkpoint / MODULE).get_state()
    layers = [f"encoder.actor_encoder.net.mlp.{place}" for place in (0, 2)] + ["pi.net.mlp.0"]
    return Policy(
        name, **training_fields(LEAGUE), observe="belief", inputs=tuple(entry_names(LEAGUE, "belief")), actions="box",
        action_repeat=REPEAT, activation="tanh", mirror=False, made={}, at_once=True, senses="ideal",
        weights=tuple(state[f"{layer}.weight"] for layer in layers),
        biases=tuple(state[f"{layer}.bias"] for layer in layers),
    )  # fmt: skip


def add_self(policy: Policy, runner: Any) -> None:
    """Add a policy to the opponents of a worker."""
    runner.env.unwrapped.arguments.opponents.add(team_from_policy(policy))


def main(steps: int = 2_000_000, seed: int = 1, out: Path = Path("runs/ppo_rllib")) -> float:
    """Learn for `steps` decisions; return the goal difference of the last checkpoint in matches against `still`."""
    register_env("soccer", lambda given: SoccerVectorEnv(**GAME, num_envs=given["num_envs"], opponents=Lineup(FIRST)))
    config = PPOConfig().environment("soccer").debugging(seed=seed)
    config.env_runners(num_env_runners=0, num_envs_per_env_runner=64, gym_env_vectorize_mode="vector_entry_point")
    config.training(train_batch_size_per_learner=BATCH, minibatch_size=1024, num_epochs=4, lr=5e-4, gamma=0.996)
    config.training(lambda_=0.95, clip_param=0.2, use_kl_loss=False, grad_clip=1.0, vf_loss_coeff=0.5)
    net = DefaultModelConfig(fcnet_hiddens=[64, 64], fcnet_activation="tanh", free_log_std=True, vf_share_layers=False)
    algorithm = config.rl_module(model_config=net).build_algo()
    for turn in range(1, -(-steps // BATCH) + 1):
        algorithm.train()
        if turn % 20 == 0 or turn * BATCH >= steps:  # the newest self joins the pool
            policy = read_policy(Path(algorithm.save_to_path(str(out.absolute()))), f"self-{turn}")
            algorithm.env_runner_group.foreach_env_runner(partial(add_self, policy))
    algorithm.stop()
    file = out / "policy.safetensors"
    file.write_bytes(dump(policy))
    asked = {"home": str(file), "away": "still", "players": 1, "matches": 40, "minutes": 2, "senses": "ideal"}
    result = evaluate(EvaluateSettings(league=LEAGUE.name, **asked))
    print(f"goals {result.goals_for} : {result.goals_against}, {result.wins} wins of {result.conditions.matches}")
    return result.goal_difference.mean
