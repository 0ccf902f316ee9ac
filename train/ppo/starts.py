"""What the networks of a run begin as: untrained, the actor of a policy file, or the networks of another run."""

from pathlib import Path

from soccer_env.agents.policy_file import load
from soccer_env.train.ppo.checkpoints import read_checkpoint
from soccer_env.train.ppo.networks import SoccerPolicy, copy_actor
from soccer_env.train.ppo.settings import TrainSettings


def begin_networks(network: SoccerPolicy, settings: TrainSettings) -> None:
    """Let the networks begin as `settings.start` says; "" leaves them untrained."""
    if settings.start_file is None:
        return
    if Path(settings.start).is_dir():
        take_over(network, Path(settings.start))
    else:
        copy_actor(network, load(settings.start_file))


def take_over(network: SoccerPolicy, run: Path) -> None:
    """Copy actor, noise and critic from the newest checkpoint of a run's folder; ValueError if they do not fit."""
    saved = read_checkpoint(run)
    try:
        network.load_state_dict((saved or {})["network"])
    except (KeyError, RuntimeError) as error:
        raise ValueError(f"start: the networks of the run in {run} are not those of this run ({error})") from error
