"""Logs of a training run by stable-baselines3's own logger: CSV, TensorBoard, Weights & Biases.

Names are those of log.jsonl in groups (`train/kl`, `rollout/goals_for`, `points/chaser`, `rating/chaser`,
`seconds/matches`, `evaluation/goal_difference_3v3_chaser`). Each kind has a folder of the
run; a run that goes on adds to it: TensorBoard shows the parts as one, CSV has a file for each, named by the step that
it begins at, and Weights & Biases goes on with the same run.
"""

from collections.abc import Callable, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from uuid import uuid4

from stable_baselines3.common.logger import Logger, make_output_format

from soccer_env.train.ppo.options import LOGS
from soccer_env.train.ppo.run_folder import RunFolder
from soccer_env.train.ppo.settings import TrainSettings

CSV, TENSORBOARD, WANDB = LOGS
PACKAGES: dict[str, tuple[str, ...]] = {CSV: (), TENSORBOARD: ("tensorboard",), WANDB: ("wandb", "tensorboard")}
ROLLOUT = ("stage", "episodes", "goals_for", "goals_against")  # names in log.jsonl, by group
UPDATE = ("kl", "clipped", "explained", "value_loss", "entropy", "noise", "learning_rate")
PROJECT, RUN = "soccer_env", "run.txt"  # of Weights & Biases: the project, and the file with the run's name there


def check_packages(kinds: Sequence[str]) -> None:
    """Raise ImportError for a log whose package is missing, with the package to install."""
    for kind in kinds:
        if any(find_spec(package) is None for package in PACKAGES[kind]):
            raise ImportError(f'--log {kind} needs another package: pip install "soccer_env[{kind}]"')


class Logs:
    """The optional logs of a run, written by stable-baselines3's `logger`."""

    def __init__(self, settings: TrainSettings, folder: RunFolder, step: int) -> None:
        kinds = settings.logs
        check_packages(kinds)
        self._end: Callable[[], None] = lambda: None
        if WANDB in kinds:
            self._end = begin_wandb(settings, folder.path / WANDB)
        formats = [make_output_format(CSV, str(folder.path / CSV), f"-{step}")] if CSV in kinds else []
        if TENSORBOARD in kinds or WANDB in kinds:  # Weights & Biases reads TensorBoard's log
            formats.append(make_output_format(TENSORBOARD, str(folder.path / TENSORBOARD)))
        self.logger = Logger(None, formats)

    def write(self, record: Mapping[str, Any]) -> None:
        """Write a line of the run's log to all optional logs."""
        for group in ("points", "rating", "seconds"):
            for name, value in record[group].items():
                self.logger.record(f"{group}/{name}", value)
        for group, names in (("rollout", ROLLOUT), ("train", UPDATE)):
            for name in names:
                self.logger.record(f"{group}/{name}", record[name])
        self.logger.dump(record["step"])

    def write_evaluation(self, step: int, rows: Sequence[Mapping[str, Any]]) -> None:
        """Write the results of an evaluation, one row per opponent, to all optional logs."""
        for row in rows:
            for name in ("goal_difference", "low", "high", "points"):
                self.logger.record(f"evaluation/{name}_{row['players']}_{row['opponent']}", row[name])
        self.logger.dump(step)

    def close(self) -> None:
        """Close the logs."""
        self.logger.close()
        self._end()


def begin_wandb(settings: TrainSettings, folder: Path) -> Callable[[], None]:
    """Start or resume a Weights & Biases run; return the function that ends it. WANDB_MODE=offline needs no network."""
    import wandb

    folder.mkdir(exist_ok=True)
    name = folder / RUN
    if not name.exists():
        name.write_text(uuid4().hex[:12], encoding="utf-8")
    wandb.init(
        project=PROJECT, name=settings.out.name, id=name.read_text(encoding="utf-8"), resume="allow",
        dir=str(folder), config=settings.as_dict(), sync_tensorboard=True,
    )  # fmt: skip
    end: Callable[[], None] = wandb.finish
    return end
