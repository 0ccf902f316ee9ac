"""A run's folder belongs to one training at a time and to one set of settings; its logs, and those of others."""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from soccer_env.train.ppo.checkpoints import as_tensors, from_tensors
from soccer_env.train.ppo.reporting import loggers
from soccer_env.train.ppo.reporting.loggers import UPDATE, Logs
from soccer_env.train.ppo.run_folder import TRAINING, RunFolder, flattened
from soccer_env.train.ppo.settings import TrainSettings
from tests.train.ppo.staged_training import records, tiny_settings

ROOT = Path(__file__).parents[3]


def opened(settings: TrainSettings) -> RunFolder:
    folder = RunFolder(settings)
    folder.close()
    return folder


def test_two_trainings_cannot_share_a_folder(tmp_path: Path) -> None:
    folder = RunFolder(tiny_settings(tmp_path))
    with pytest.raises(ValueError, match="another run uses .*give another folder"):
        RunFolder(tiny_settings(tmp_path, anew=True))
    assert (tmp_path / "settings.json").exists(), "--anew of the second one must not touch the first one's files"
    folder.close()
    opened(tiny_settings(tmp_path))


HOLDER = """
import sys, time
from pathlib import Path
from soccer_env.train.results_folder import lock
handle = lock(Path(sys.argv[1]) / ".lock")
print("mine", flush=True)
time.sleep(60)
"""


@pytest.mark.skipif(os.name != "posix", reason="needs SIGKILL")
def test_the_lock_ends_with_the_process(tmp_path: Path) -> None:
    words = [sys.executable, "-c", HOLDER, str(tmp_path)]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, cwd=ROOT) as holder:
        assert holder.stdout is not None and holder.stdout.readline() == "mine\n"
        with pytest.raises(ValueError, match="another run uses"):
            RunFolder(tiny_settings(tmp_path))
        holder.kill()
    opened(tiny_settings(tmp_path))


def test_what_decides_is_refused_and_named_and_all_else_may_change(tmp_path: Path) -> None:
    opened(tiny_settings(tmp_path))
    with pytest.raises(ValueError, match="seed 3 there, 4 now; .*noise 0.6 there, 0.9 now"):
        RunFolder(tiny_settings(tmp_path, seed=4, noise=0.9))
    for name, value in {"steps": 900, "threads": 2, "torch_threads": 2, "device": "auto", "log": "csv"}.items():
        opened(tiny_settings(tmp_path, **{name: value}))
        assert json.loads((tmp_path / "settings.json").read_text())["about"][name] == value


def test_anew_starts_again_and_leaves_what_is_not_of_the_run(tmp_path: Path) -> None:
    opened(tiny_settings(tmp_path))
    for name in TRAINING.files:
        (tmp_path / name).write_text("old")
    (tmp_path / "tensorboard").mkdir()
    (tmp_path / "tensorboard" / "events").write_text("old")
    (tmp_path / "notes.txt").write_text("mine")
    opened(tiny_settings(tmp_path, seed=4, anew=True))
    assert {path.name for path in tmp_path.iterdir()} == {".lock", "notes.txt", "settings.json"}


def test_anew_mends_damaged_settings_beside_a_log_and_removes_what_a_kill_left_half_written(tmp_path: Path) -> None:
    (tmp_path / "settings.json").write_text("{")
    (tmp_path / "log.jsonl").write_text("")  # without a run's log it may be anybody's
    opened(tiny_settings(tmp_path, anew=True))
    for name in (".checkpoint-0.pt.123.tmp", ".latest.json.9.tmp", ".notes.tmp"):
        (tmp_path / name).write_text("half")
    opened(tiny_settings(tmp_path))
    assert {path.name for path in tmp_path.iterdir()} == {".lock", ".notes.tmp", "settings.json"}


def test_logs_are_cut_back_to_a_step(tmp_path: Path) -> None:
    folder = opened(tiny_settings(tmp_path))
    for step in (48, 96, 144):
        folder.log({"step": step, "points": {"still": 0.5, "a,b": 1.0}})
        folder.log_evaluation({"step": step})
    folder.cut_logs_after(96)
    folder.log({"step": 120, "points": {"still": 0.6, "a,b": 0.0}})
    assert [line["step"] for line in records(tmp_path / "log.jsonl")] == [48, 96, 120]
    assert [line["step"] for line in records(tmp_path / "evaluations.jsonl")] == [48, 96]
    with (tmp_path / "progress.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["step"] for row in rows] == ["48", "96", "120"]
    assert [row["points_a,b"] for row in rows] == ["1.0", "1.0", "0.0"]
    folder.cut_logs_after(-1)
    assert folder.lines() == [] and not (tmp_path / "progress.csv").exists()


def test_plain_values_survive_as_tensors() -> None:
    import numpy as np

    tree = {"a": [1, 2.5, None, "x", True], "b": b"\x00\xff", "c": {"d": np.arange(6.0).reshape(2, 3)}, "e": b""}
    back = from_tensors(as_tensors(tree))
    assert back["a"] == tree["a"] and back["b"] == tree["b"] and back["e"] == b""
    assert back["c"]["d"].tolist() == [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]] and back["c"]["d"].dtype == np.float64


RECORD: dict[str, Any] = {
    "step": 128, "stage": 1, "episodes": 3, "goals_for": 2, "goals_against": 1,
    "points": {"chaser": 0.5}, "rating": {"chaser": 25.0},
    "seconds": {"matches": 1.0}, **dict.fromkeys(UPDATE, 0.01),
}  # fmt: skip
ROW = {"players": "3v3", "opponent": "chaser", "goal_difference": 0.5, "low": 0.0, "high": 1.0, "points": 0.75}


def written(out: Path, log: str, step: int = 0) -> Path:
    settings = tiny_settings(out, log=log)
    with RunFolder(settings) as folder:
        logs = Logs(settings, folder, step)
        logs.write(RECORD)
        logs.write_evaluation(256, [ROW])
        logs.close()
    return out


def test_csv_holds_both_and_a_run_that_goes_on_adds_a_file(tmp_path: Path) -> None:
    for step in (0, 256):
        written(tmp_path, "csv", step)
    assert {path.name for path in (tmp_path / "csv").iterdir()} == {"progress-0.csv", "progress-256.csv"}
    first, second = csv.DictReader((tmp_path / "csv" / "progress-0.csv").read_text().splitlines())
    assert first["train/kl"] == "0.01" and first["rollout/goals_for"] == "2" and first["points/chaser"] == "0.5"
    assert second["evaluation/goal_difference_3v3_chaser"] == "0.5"


def test_tensorboard_holds_both(tmp_path: Path) -> None:
    pytest.importorskip("tensorboard")
    from tensorboard.backend.event_processing.event_accumulator import EventAccumulator

    found = EventAccumulator(str(written(tmp_path, "tensorboard") / "tensorboard"))
    found.Reload()
    told = {name: [(one.step, one.value) for one in found.Scalars(name)] for name in found.Tags()["scalars"]}
    assert told["rollout/goals_for"] == [(128, 2.0)] and told["train/kl"][0][0] == 128
    assert told["evaluation/goal_difference_3v3_chaser"] == [(256, 0.5)]


def test_nothing_is_written_that_nobody_asked_for(tmp_path: Path) -> None:
    assert {path.name for path in written(tmp_path, "").iterdir()} <= {"settings.json", ".lock"}
    record = {"step": 1, "seconds": {"a": 2, "b": 3}, "goals": {"1v1 still": {"for": 1.0}}}
    assert flattened(record) == {"step": 1, "seconds_a": 2, "seconds_b": 3}, "same columns at each stage"


@pytest.mark.parametrize("kind", ["tensorboard", "wandb"])
def test_a_missing_package_is_one_line_and_no_folder(kind: str, tmp_path: Path, monkeypatch: Any, soccer: Any) -> None:
    monkeypatch.setattr(loggers, "find_spec", lambda name: None)
    said = soccer("train", "--log", f"csv,{kind}", "--out", tmp_path / "a", code=2)
    assert said == f'soccer: --log {kind} needs another package: pip install "soccer_env[{kind}]"\n'
    assert not (tmp_path / "a").exists()
    assert "unknown log 'tensorbord', did you mean 'tensorboard'?" in soccer("train", "--log", "tensorbord", code=2)
