"""A training run: its state, its output, and how to resume it.

`soccer_env.train.ppo.train` shows the order of the calls.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any

from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import dump
from soccer_env.agents.trained_with import warn_if_observing_truth
from soccer_env.train.cluster import Workers
from soccer_env.train.ppo.checkpoints import generator_states, read_checkpoint, restore_generators, write_checkpoint
from soccer_env.train.ppo.checks import make_matches, policy_origin
from soccer_env.train.ppo.curriculum import Curriculum
from soccer_env.train.ppo.learner import Learner, begin_networks
from soccer_env.train.ppo.match_blocks import Result
from soccer_env.train.ppo.networks import export_policy
from soccer_env.train.ppo.reporting.page import page_of
from soccer_env.train.ppo.reporting.tally import per_minute
from soccer_env.train.ppo.reports import (
    ProgressBoard,
    evaluate_policy,
    goals_a_minute,
    learning_curve,
    merit,
    rounded,
)
from soccer_env.train.ppo.run_folder import BEST, CURVE, REPORT, RunFolder
from soccer_env.train.ppo.settings import LAST, TrainSettings
from soccer_env.train.ppo.stages import StageClock
from soccer_env.train.ppo.updating.matches import Matches

CHECKPOINT_SHARE = 0.05  # of a run's time, at most


@dataclass(frozen=True)
class TrainResult:
    """The result of a training run."""

    steps: int
    seconds: float  # of this call
    policy: Policy  # the last one
    evaluations: list[dict[str, Any]]  # all, oldest first


class Training:
    """One training run; a context manager that shows a progress bar and closes threads and logs."""

    def __init__(
        self, settings: TrainSettings, folder: RunFolder, curriculum: Curriculum, learner: Learner, workers: Workers
    ) -> None:
        self.settings, self.folder, self.workers = settings, folder, workers
        self.curriculum = curriculum
        self.learner = learner
        self.clock = StageClock(settings.stages, settings.stage_share, settings.stage_steps)
        self.board = ProgressBoard(settings, folder)
        self.rollouts = 0  # so far
        self.next_checkpoint = 0.0  # [s] of the clock of `time.perf_counter`
        self.started = time.perf_counter()

    def __enter__(self) -> Training:
        return self

    def __exit__(self, *error: object) -> None:
        self.learner.close()
        self.board.close()

    def timed(self, stage: str) -> AbstractContextManager[None]:
        """Return a context manager that adds the time of its block to a stage in the rollout's log record."""
        return self.board.timed(stage)

    def show_step(self) -> None:
        """Advance the progress bar by one step of all matches."""
        self.board.show(self.learner.steps)

    def count_rollout(self) -> None:
        """Count one more rollout with its update."""
        self.rollouts += 1

    def policy(self) -> Policy:
        """Return the present actor as a policy."""
        settings = self.settings
        return export_policy(
            self.learner.network, name=settings.name, league=self.learner.league, observe=settings.observe,
            action_repeat=settings.action_repeat, made=policy_origin(settings, self.learner.steps),
            **settings.own_senses,
        )  # fmt: skip

    def log(self, results: Sequence[Result]) -> None:
        """Write the log record of a rollout and its update, with the results of the episodes that ended in it."""
        matches, standings = self.learner.matches, self.curriculum.standings
        self.board.log(
            {
                "step": self.learner.steps, "rollout": self.rollouts, "stage": self.clock.number + 1,
                "episodes": len(results),
                "goals_for": sum(result.goals_for for result in results),
                "goals_against": sum(result.goals_against for result in results),
                "points": {name: round(standings[name].points, 4) for name in self.curriculum.names},
                "rating": {name: round(standing.mu, 3) for name, standing in standings.items()},
                **{name: rounded(value) for name, value in self.learner.noted.items()},
                "goals": goals_a_minute(results),
                "minute": per_minute(matches.take_tallies()),
                "playing": self.learner.seconds,
            }
        )  # fmt: skip

    def move_on(self, results: Sequence[Result]) -> None:
        """Count the goals of finished episodes; begin the next stage, if the present one is over."""
        self.clock.take(results)
        if self.clock.move_on(self.learner.steps):
            self.learner.begin_matches(self._matches_of_stage())

    def _matches_of_stage(self) -> Matches:
        """Make the matches of the present stage, and meet its opponents in them."""
        self.curriculum.begin_stage(self.clock.stage.opponents)
        return make_matches(self.settings, self.curriculum, self.clock.stage.sizes, self.workers)

    def evaluation_is_due(self) -> bool:
        """Tell whether the last rollout passed a multiple of `evaluate_every`, or ended the run."""
        step, every = self.learner.steps, self.settings.evaluate_every
        before = step - self.settings.rollout * self.learner.matches.num_envs
        return self._is_over() or step // every > before // every

    def begin(self) -> None:
        """Let the networks begin as the settings say, evaluate the policy, and start the matches."""
        begin_networks(self.learner.network, self.settings)
        self.evaluate()
        self.learner.begin_matches()
        self.save_checkpoint()

    def evaluate(self) -> None:
        """Evaluate the policy without noise; save it if it is the best so far, and draw the learning curve."""
        with self.timed("evaluation"):
            policy = self.policy()
            best = max(map(merit, self.folder.evaluations()), default=None)
            rows = evaluate_policy(policy, self.settings, self.workers)
            record = {"step": self.learner.steps, "rows": rows}
            data = dump(policy)
            self.folder.write(LAST, data)
            warn_if_observing_truth(policy)
            if best is None or merit(record) > best:
                self.folder.write(BEST, data)
            self.folder.log_evaluation(record)
            curve = learning_curve(self.folder.evaluations(), self.settings)
            if curve:
                self.folder.write(CURVE, curve)
            self.report()
        self.board.note_evaluation(self.learner.steps, rows)

    def report(self) -> None:
        """Write the HTML report of the run."""
        page = page_of(self.settings, self.folder.lines(), self.folder.evaluations())
        self.folder.write(REPORT, page)

    def result(self) -> TrainResult:
        """Return the result of the run."""
        seconds = time.perf_counter() - self.started
        return TrainResult(self.learner.steps, seconds, self.policy(), self.folder.evaluations())

    # Checkpoints

    def save_checkpoint(self) -> None:
        """Write a checkpoint from which the run resumes with identical results, if the last one is old enough.

        Matches are rebuilt as by a save in any case, so that results do not depend on how fast a checkpoint is written.
        """
        with self.timed("checkpoint"):
            started = time.perf_counter()
            if started < self.next_checkpoint and not self._is_over():
                self.learner.matches.rebuild()
                return
            state = {
                **self.learner.state(),
                "matches": self.learner.matches.save(),
                "curriculum": self.curriculum.state(),
                "stage": self.clock.state(),
                "generators": generator_states(),
                "rollouts": self.rollouts,
            }
            write_checkpoint(self.folder.path, state, self.learner.steps)
            ended = time.perf_counter()
            self.next_checkpoint = ended + (ended - started) / CHECKPOINT_SHARE

    def _is_over(self) -> bool:
        """Tell whether the run has all its steps."""
        return self.learner.steps >= self.settings.steps

    def restore_checkpoint(self) -> bool:
        """Resume from the newest checkpoint; return False if there is none.

        ValueError, with the logs unchanged, for a checkpoint of another kind of run.
        """
        saved = read_checkpoint(self.folder.path)
        if saved is None:
            self.folder.check_new()
        else:
            self._restore(saved)
        self.folder.cut_logs_after(self.learner.steps if saved else -1)
        self.board.open_logs(self.learner.steps)
        return saved is not None

    def _restore(self, saved: dict[str, Any]) -> None:
        """Restore the run from the state that `save_checkpoint` wrote."""
        try:
            self.clock.restore(saved["stage"])
            self.curriculum.restore(saved["curriculum"])  # first: saved matches refer to their opponents
            if self.clock.number:
                self.learner.begin_matches(self._matches_of_stage())
            self.learner.restore(saved, self.learner.matches.load(saved["matches"]))
            self.rollouts = saved["rollouts"]
            restore_generators(saved["generators"])
        except (ValueError, RuntimeError, LookupError, TypeError, AttributeError) as error:
            raise ValueError(
                f"the checkpoint in {self.folder.path} is not of this run as it is now ({error}); --anew starts again"
            ) from error
