"""Train a policy: `soccer train`. PPO over the batched core; `train` below is the outline.

    settings.py        the options of the command                  toml_file.py      options from a file
    options.py         their texts and ranges                      training.py       a run: its state and its output
    checks.py          check that a run is playable                updating/         rollouts and updates of PPO
    vec_env.py         many matches as one VecEnv                  match_blocks.py   blocks of team sizes
    curriculum.py      the choice of opponents                     stages.py         stages of team sizes and opponents
    networks.py        actor and critic                            recurrent.py      the actor's memory
    critic_state.py    the critic's view of the truth              reporting/        other logs, the report as a page
    learner.py         both: their start, turns and state          checkpoints.py    save and resume a run
    run_folder.py      the files of a run                          reports.py        its log, evaluations and curve

Importing this package is quick: torch comes with the first training.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.ppo.settings import TrainSettings
    from soccer_env.train.ppo.training import TrainResult
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

__all__ = ["SoccerVecEnv", "TrainSettings", "train"]
__getattr__, __dir__ = lazy_names(__name__, {"SoccerVecEnv": "vec_env", "TrainSettings": "settings"})


def train(settings: TrainSettings) -> TrainResult:
    """Train, or resume the run in `settings.out`; ValueError for settings that fit neither the run nor each other.

    A run that was interrupted at any moment resumes from its last checkpoint with identical results.
    """
    from soccer_env.train.cluster import open_workers
    from soccer_env.train.ppo.checks import check_playable, make_curriculum, make_matches
    from soccer_env.train.ppo.learner import Learner
    from soccer_env.train.ppo.run_folder import RunFolder
    from soccer_env.train.ppo.training import Training

    check_playable(settings)  # every team, size and time, before a folder is made
    with RunFolder(settings) as folder, open_workers(settings.threads, settings.ray) as workers:
        curriculum = make_curriculum(settings)  # the opponents, and how often each is met
        matches = make_matches(settings, curriculum, settings.stages[0].sizes, workers)  # a row for each robot
        learner = Learner(settings, matches)
        with Training(settings, folder, curriculum, learner, workers) as run:
            if not run.restore_checkpoint():
                run.begin()  # from nothing, as a policy file, or as another run
            while learner.steps < settings.steps:
                with run.timed("rollout"):
                    learner.collect_rollout(run.show_step)
                with run.timed("update"):
                    learner.update(actor=run.rollouts >= settings.critic_first)  # the critic alone learns first
                curriculum.take(results := learner.matches.take_results())  # even opponents are met the most often
                run.count_rollout()
                if run.rollouts % settings.past_every == 0:
                    curriculum.add_past(run.policy(), learner.steps, learner.matches.playing())
                run.log(results)
                if run.evaluation_is_due():
                    run.evaluate()  # and keep the best policy
                run.move_on(results)  # to the next stage, if the present one is over
                run.save_checkpoint()
            return run.result()
