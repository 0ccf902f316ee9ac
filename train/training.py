"""`soccer train`: PPO over the batched core, against opponents of growing strength, that survives being cut.

teacher -> fit the actor     (once, if there is a teacher)
matches -> rollout -> PPO update -> results, past selves, evaluation -> checkpoint     (again and again)
"""

from __future__ import annotations

import datetime
import time
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import VecNormalize

from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import dump
from soccer_env.leagues import find_league
from soccer_env.observations import names_of
from soccer_env.rewards import Rewards
from soccer_env.train.checkpoints import generators, read_checkpoint, restore_generators, write_checkpoint
from soccer_env.train.curriculum import Curriculum
from soccer_env.train.imitation import teach
from soccer_env.train.networks import SoccerPolicy, blank_policy, policy_from
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import commit, version_of
from soccer_env.train.run_folder import BEST, CURVE, LAST, RunFolder
from soccer_env.train.train_settings import TrainSettings, command_of, senses_of
from soccer_env.train.training_reports import Board, evaluate_policy, learning_curve
from soccer_env.train.vec_env import SoccerVecEnv, per_step

LEAST_RATE = 0.05  # [1] of the learning rate that is left at the end
SPREAD = 10.0  # [1] rewards over the deviation of the return are cut off there


@dataclass(frozen=True)
class TrainResult:
    """What a run came to."""

    steps: int
    seconds: float  # of this call
    policy: Policy  # the last one
    evaluations: list[dict[str, Any]]  # all, oldest first


def train(settings: TrainSettings) -> TrainResult:
    """Train, or go on with the run in `settings.out`; ValueError for settings that do not fit it or each other."""
    folder = RunFolder(settings)
    try:
        training = Training(settings, folder)
        try:
            return training.run()
        finally:
            training.close()
    finally:
        folder.close()


class Training:
    """One run: its environment, its learner and what it has come to."""

    def __init__(self, settings: TrainSettings, folder: RunFolder) -> None:
        self.settings, self.folder = settings, folder
        torch.set_num_threads(settings.torch_threads)
        self.league = find_league(settings.league)
        self.names = names_of(self.league, settings.observe)
        blank = blank_policy(settings, self.names)
        self.curriculum = Curriculum(settings.opponent_names, settings.past, blank, settings.curriculum)
        self.matches = make_matches(settings, self.curriculum)
        self.rewards = VecNormalize(
            self.matches, norm_obs=False, norm_reward=settings.normalise_rewards, gamma=settings.gamma,
            clip_reward=SPREAD,
        )  # fmt: skip
        self.model = make_model(settings, self.rewards, self.names)
        self.board = Board(settings, folder)
        self.best, self.rollouts, self.started = -np.inf, 0, time.perf_counter()

    @property
    def network(self) -> SoccerPolicy:
        """Return the network that is trained."""
        assert isinstance(self.model.policy, SoccerPolicy)
        return self.model.policy

    def run(self) -> TrainResult:
        """Train to the end."""
        saved = read_checkpoint(self.folder.path)
        if saved is None:
            self._begin()
        else:
            self._restore(saved)
        left = self.settings.steps - self.model.num_timesteps
        with Progress("training", self.settings.steps) as progress:
            self.board.progress = progress
            progress.advance(self.model.num_timesteps)
            if left > 0:
                self.model.learn(left, callback=Steps(self), log_interval=None, reset_num_timesteps=False)  # type: ignore[arg-type]
                self.after_update(last=True)
        evaluations = self.folder.evaluations()
        return TrainResult(self.model.num_timesteps, time.perf_counter() - self.started, self.policy(), evaluations)

    def policy(self) -> Policy:
        """Return the policy as it is now."""
        settings = self.settings
        made = {
            "command": command_of(settings),
            "date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
            "commit": commit(),
            "step": str(self.model.num_timesteps),
            **{name: version_of(name) for name in ("soccer_env", "torch", "stable_baselines3", "pymunk", "numba")},
        }
        return policy_from(
            self.network, name=settings.name, league=self.league.name, observe=settings.observe,
            action_repeat=settings.action_repeat, made=made,
        )  # fmt: skip

    def _begin(self) -> None:
        """Learn from the teacher, if there is one, and reset the matches."""
        self.folder.forget_after(-1)
        if self.settings.teacher:
            teach(self.network, self.settings)
        self.model._last_obs = self.rewards.reset()  # type: ignore[assignment]
        self.model._last_episode_starts = np.ones(self.rewards.num_envs, bool)

    def before_rollout(self) -> None:
        """Do what belongs between an update and the next rollout; the actor waits while the critic alone learns."""
        if self.board.collected:
            self.after_update()
        elif self.rollouts == 0:
            self._evaluate()
        self._save()
        for parameter in self.network.actor_parameters():
            parameter.requires_grad_(self.rollouts >= self.settings.critic_first)

    def after_update(self, last: bool = False) -> None:
        """Take in the results of a rollout and its update."""
        self.rollouts += 1
        step, settings = self.model.num_timesteps, self.settings
        results, self.matches.results = self.matches.results, []
        self.curriculum.take(results)
        if self.rollouts % settings.past_every == 0:
            self.curriculum.add_past(self.policy(), step)
        self.board.log(step, self.rollouts, results, self.curriculum, self.model.logger, self.matches)
        before = step - settings.rollout * self.matches.num_envs
        if last or step // settings.evaluate_every > before // settings.evaluate_every:
            self._evaluate()
        if last:
            self._save()

    def _evaluate(self) -> None:
        """Play the policy without noise; keep it if it is the best so far, and draw the learning curve."""
        start, step, policy = time.perf_counter(), self.model.num_timesteps, self.policy()
        rows = evaluate_policy(policy, self.settings)
        mean = float(np.mean([row["goal_difference"] for row in rows]))
        data = dump(policy)
        self.folder.write(LAST, data)
        if mean > self.best:
            self.best = mean
            self.folder.write(BEST, data)
        self.folder.log_evaluation({"step": step, "mean": mean, "rows": rows})
        self.folder.write(CURVE, learning_curve(self.folder.evaluations(), self.settings))
        self.board.told_evaluation(rows, time.perf_counter() - start)

    # Checkpoints

    def _save(self) -> None:
        """Write a checkpoint: the run goes on from here as if it had not been cut."""
        start, model = time.perf_counter(), self.model
        running = {} if not self.settings.normalise_rewards else {
            "mean": float(self.rewards.ret_rms.mean), "var": float(self.rewards.ret_rms.var),
            "count": float(self.rewards.ret_rms.count), "returns": self.rewards.returns,
        }  # fmt: skip
        state = {
            "network": self.network.state_dict(),
            "optimizer": self.network.optimizer.state_dict(),
            "step": model.num_timesteps,
            "updates": model._n_updates,
            "starts": np.asarray(model._last_episode_starts),
            "matches": self.matches.save(),
            "rewards": running,
            "curriculum": self.curriculum.state(),
            "generators": generators(),
            "best": float(self.best),
            "rollouts": self.rollouts,
        }
        write_checkpoint(self.folder.path, state, model.num_timesteps)
        self.board.saving = time.perf_counter() - start

    def _restore(self, saved: dict[str, Any]) -> None:
        """Go on from a checkpoint."""
        model, running = self.model, saved["rewards"]
        self.network.load_state_dict(saved["network"])
        self.network.optimizer.load_state_dict(saved["optimizer"])
        model.num_timesteps, model._n_updates = saved["step"], saved["updates"]
        self.curriculum.restore(saved["curriculum"])
        model._last_obs = self.matches.load(saved["matches"])  # type: ignore[assignment]
        model._last_episode_starts = saved["starts"]
        if running:
            statistics = self.rewards.ret_rms
            statistics.mean, statistics.var, statistics.count = (
                np.float64(running[n]) for n in ("mean", "var", "count")
            )
            self.rewards.returns = running["returns"]
        self.best, self.rollouts = saved["best"], saved["rollouts"]
        self.folder.forget_after(model.num_timesteps)
        restore_generators(saved["generators"])

    def close(self) -> None:
        """End the threads and the logs."""
        self.rewards.close()
        self.board.close()


class Steps(BaseCallback):
    """What stable-baselines3 calls while it learns."""

    def __init__(self, training: Training) -> None:
        super().__init__()
        self.training = training

    def _on_rollout_start(self) -> None:
        self.training.before_rollout()
        self.training.board.rollout_starts()

    def _on_step(self) -> bool:
        self.training.board.step_done(self.training.matches.num_envs)
        return True

    def _on_rollout_end(self) -> None:
        self.training.board.rollout_ends()


def make_matches(settings: TrainSettings, curriculum: Curriculum) -> SoccerVecEnv:
    """Return the environment of a run."""
    weights = Rewards(
        goal=settings.goal, progress=settings.progress, approach=settings.approach, effort=settings.effort
    )
    return SoccerVecEnv(
        settings.league, players=settings.sizes, matches=settings.matches, opponents=curriculum.lineup,
        action_repeat=settings.action_repeat, rewards=per_step(weights, settings.gamma, settings.action_repeat),
        state=settings.central_critic, stagger=True, seed=settings.seed, threads=settings.threads,
        observe=settings.observe, senses=senses_of(settings.senses), pose=settings.pose, minutes=settings.minutes,
    )  # fmt: skip


def make_model(settings: TrainSettings, matches: VecNormalize, names: list[str]) -> PPO:
    """Return the learner."""
    shape = {
        "names": names, "kind": settings.kind, "hidden": settings.hidden_sizes, "critic": settings.critic_sizes,
        "activation": settings.activation, "mirror": settings.mirror, "log_std_init": float(np.log(settings.noise)),
    }  # fmt: skip

    def rate(left: float) -> float:
        return settings.learning_rate * (LEAST_RATE + (1.0 - LEAST_RATE) * max(left, 0.0) if settings.decay else 1.0)

    model = PPO(
        SoccerPolicy, matches, learning_rate=rate, n_steps=settings.rollout, batch_size=settings.batch,
        n_epochs=settings.epochs, gamma=settings.gamma, gae_lambda=settings.gae_lambda, clip_range=settings.clip,
        ent_coef=settings.entropy, vf_coef=settings.value_weight, max_grad_norm=settings.gradient_limit,
        target_kl=settings.target_kl or None, policy_kwargs=shape, seed=settings.seed, device=settings.device,
    )  # fmt: skip
    model.set_logger(Logger(folder=None, output_formats=[]))
    return model
