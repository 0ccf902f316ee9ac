"""Train a policy: `soccer train`. PPO of stable-baselines3 over the batched core.

    settings.py        what the command line asks for              toml_file.py      or a file
    checks.py          found playable before a run begins          training.py       the run
    vec_env.py         many matches as one VecEnv                  match_blocks.py   shared out among sizes and senses
    curriculum.py      who the learners meet                       imitation.py      a scripted teacher, before rewards
    networks.py        actor and critic                            critic_state.py   what the critic sees besides
    learner.py         PPO, and what of it has to be kept          checkpoints.py    so that a cut run goes on
    run_folder.py      what a run leaves behind                    reports.py        its log, evaluations and curve
    compare_kinds.py   the two kinds of networks on the same task

Importing this package is quick: torch comes with the first name that needs it.
"""

from typing import TYPE_CHECKING

from soccer_env.lazy_names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.ppo.settings import TrainSettings
    from soccer_env.train.ppo.training import train
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

__all__ = ["SoccerVecEnv", "TrainSettings", "train"]
__getattr__, __dir__ = lazy_names(
    __name__,
    {
        "SoccerVecEnv": "soccer_env.train.ppo.vec_env",
        "TrainSettings": "soccer_env.train.ppo.settings",
        "train": "soccer_env.train.ppo.training",
    },
)
