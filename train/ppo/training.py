"""`soccer train`: PPO over the batched core, against opponents of growing strength, that survives being cut.

teacher -> fit the actor     (once, if there is a teacher)
matches -> rollout -> PPO update -> results, past selves, evaluation -> checkpoint     (again and again)
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from stable_baselines3.common.callbacks import BaseCallback

from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import dump
from soccer_env.leagues import find_league
from soccer_env.observations import names_of
from soccer_env.train.ppo.checkpoints import generators, read_checkpoint, restore_generators, write_checkpoint
from soccer_env.train.ppo.checks import check_playable, made_by, make_matches
from soccer_env.train.ppo.curriculum import Curriculum
from soccer_env.train.ppo.imitation import teach
from soccer_env.train.ppo.learner import begin, check_weights, learner_state, make_model, make_rewards, restore_learner
from soccer_env.train.ppo.networks import SoccerPolicy, blank_policy, policy_from
from soccer_env.train.ppo.reports import Board, evaluate_policy, learning_curve
from soccer_env.train.ppo.run_folder import BEST, CURVE, LAST, RunFolder
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.progress import Progress


@dataclass(frozen=True)
class TrainResult:
    """What a run came to."""

    steps: int
    seconds: float  # of this call
    policy: Policy  # the last one
    evaluations: list[dict[str, Any]]  # all, oldest first


def train(settings: TrainSettings) -> TrainResult:
    """Train, or go on with the run in `settings.out`; ValueError for settings that do not fit it or each other."""
    check_playable(settings)  # whatever cannot be played is found before a folder is made
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
        blank = blank_policy(settings, self.league)
        self.curriculum = Curriculum(settings.opponent_names, settings.past, blank, settings.curriculum)
        self.matches = make_matches(settings, self.curriculum)
        self.rewards = make_rewards(settings, self.matches)
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
            self.folder.check_new()
            self._begin()
        else:
            self._restore(saved)
        left = self.settings.steps - self.model.num_timesteps
        with Progress("training", self.settings.steps) as progress:
            self.board.progress = progress
            progress.advance(self.model.num_timesteps)
            if left > 0:
                self._learn(left)
        evaluations = self.folder.evaluations()
        return TrainResult(self.model.num_timesteps, time.perf_counter() - self.started, self.policy(), evaluations)

    def _learn(self, steps: int) -> None:
        """Go on for so many steps, whole rollouts."""
        try:
            self.model.learn(steps, callback=Steps(self), log_interval=None, reset_num_timesteps=False)  # type: ignore[arg-type]
        except ValueError:
            check_weights(self.model)  # torch complains of NaN in the middle of an update, at length
            raise
        self.after_update(last=True)

    def policy(self) -> Policy:
        """Return the policy as it is now."""
        settings = self.settings
        return policy_from(
            self.network, name=settings.name, league=self.league, observe=settings.observe,
            action_repeat=settings.action_repeat, made=made_by(settings, self.model.num_timesteps),
        )  # fmt: skip

    def _begin(self) -> None:
        """Learn from the teacher, if there is one, see what that is worth and reset the matches."""
        self.folder.forget_after(-1)
        if self.settings.teacher:
            teach(self.network, self.settings)
        self._evaluate()
        begin(self.model, self.rewards.reset())  # type: ignore[arg-type]

    def before_rollout(self) -> None:
        """Do what belongs between an update and the next rollout; the actor waits while the critic alone learns."""
        if self.board.collected:
            self.after_update()
        self._save()
        for parameter in self.network.actor_parameters():
            parameter.requires_grad_(self.rollouts >= self.settings.critic_first)

    def after_update(self, last: bool = False) -> None:
        """Take in the results of a rollout and its update."""
        check_weights(self.model)
        self.rollouts += 1
        step, settings = self.model.num_timesteps, self.settings
        results, self.matches.results = self.matches.results, []
        self.curriculum.take(results)
        if self.rollouts % settings.past_every == 0:
            playing = [name for names in self.matches.opponents for name in names]
            self.curriculum.add_past(self.policy(), step, playing)
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
        curve = learning_curve(self.folder.evaluations(), self.settings)
        if curve:
            self.folder.write(CURVE, curve)
        self.board.told_evaluation(rows, time.perf_counter() - start)

    # Checkpoints

    def _save(self) -> None:
        """Write a checkpoint: the run goes on from here as if it had not been cut."""
        start = time.perf_counter()
        state = {
            **learner_state(self.model, self.rewards),
            "matches": self.matches.save(),
            "curriculum": self.curriculum.state(),
            "generators": generators(),
            "best": float(self.best),
            "rollouts": self.rollouts,
        }
        write_checkpoint(self.folder.path, state, self.model.num_timesteps)
        self.board.saving = time.perf_counter() - start

    def _restore(self, saved: dict[str, Any]) -> None:
        """Go on from a checkpoint; ValueError, with the logs as they were, if it is of another kind of run."""
        try:
            self.curriculum.restore(saved["curriculum"])  # first: saved matches know whom they are played against
            restore_learner(self.model, self.rewards, saved, self.matches.load(saved["matches"]))
            self.best, self.rollouts = saved["best"], saved["rollouts"]
            restore_generators(saved["generators"])
        except (ValueError, RuntimeError, LookupError, TypeError, AttributeError) as error:
            raise ValueError(
                f"the checkpoint in {self.folder.path} is not of this run as it is now ({error}); --anew starts again"
            ) from error
        self.folder.forget_after(self.model.num_timesteps)

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
