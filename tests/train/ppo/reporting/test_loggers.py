"""Further logs of a training: what stable-baselines3 writes, with the run's own numbers; missing packages are named."""

import csv
from pathlib import Path
from typing import Any

import pytest

from soccer_env.train.command.command_line import main
from soccer_env.train.ppo.reporting import loggers
from soccer_env.train.ppo.reporting.loggers import Logs
from soccer_env.train.ppo.run_folder import RunFolder
from tests.train.ppo.staged_training import tiny

RECORD: dict[str, Any] = {
    "step": 128, "episodes": 3, "goals_for": 2, "goals_against": 1,
    "points": {"chaser": 0.5}, "rating": {"chaser": 25.0},
    "seconds": {"matches": 1.0},
}  # fmt: skip
ROW = {"opponent": "chaser", "goal_difference": 0.5, "low": 0.0, "high": 1.0, "points": 0.75}


def written(out: Path, log: str, step: int = 0) -> Path:
    settings = tiny(out, log=log)
    with RunFolder(settings) as folder:
        logs = Logs(settings, folder, step)
        logs.logger.record("train/approx_kl", 0.01)
        logs.write(RECORD)
        logs.write_evaluation(256, [ROW])
        logs.close()
    return out


def test_csv_holds_both_and_a_run_that_goes_on_adds_a_file(tmp_path: Path) -> None:
    for step in (0, 256):
        written(tmp_path, "csv", step)
    assert {path.name for path in (tmp_path / "csv").iterdir()} == {"progress-0.csv", "progress-256.csv"}
    first, second = csv.DictReader((tmp_path / "csv" / "progress-0.csv").read_text().splitlines())
    assert first["train/approx_kl"] == "0.01" and first["rollout/goals_for"] == "2" and first["points/chaser"] == "0.5"
    assert second["evaluation/goal_difference_chaser"] == "0.5"


def test_tensorboard_holds_both(tmp_path: Path) -> None:
    pytest.importorskip("tensorboard")
    from tensorboard.backend.event_processing.event_accumulator import EventAccumulator

    found = EventAccumulator(str(written(tmp_path, "tensorboard") / "tensorboard"))
    found.Reload()
    told = {name: [(one.step, one.value) for one in found.Scalars(name)] for name in found.Tags()["scalars"]}
    assert told["rollout/goals_for"] == [(128, 2.0)] and told["train/approx_kl"][0][0] == 128
    assert told["evaluation/goal_difference_chaser"] == [(256, 0.5)]


def test_nothing_is_written_that_nobody_asked_for(tmp_path: Path) -> None:
    assert {path.name for path in written(tmp_path, "").iterdir()} <= {"settings.json", ".lock"}


@pytest.mark.parametrize("kind", ["tensorboard", "wandb"])
def test_a_missing_package_is_one_line_and_no_folder(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(loggers, "find_spec", lambda name: None)
    assert main(["train", "--log", f"csv,{kind}", "--out", str(tmp_path / "a")]) == 2
    said = capsys.readouterr().err
    assert said == f'soccer: --log {kind} needs another package: pip install "soccer_env[{kind}]"\n'
    assert not (tmp_path / "a").exists()


def test_an_unknown_log_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["train", "--log", "tensorbord"]) == 2
    assert "unknown log 'tensorbord', did you mean 'tensorboard'?" in capsys.readouterr().err
