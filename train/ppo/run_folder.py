"""The folder of a training run: locked for one process, with logs that continue and files written atomically.

settings.json  log.jsonl  progress.csv  evaluations.jsonl  best.safetensors  last.safetensors  learning_curve.png
checkpoint-0.pt  checkpoint-1.pt  latest.json  report.html
csv tensorboard wandb (further logs)  replays (kept replays)
"""

import csv
import io
import json
from pathlib import Path
from typing import Any

from soccer_env.guards.whole_files import write_atomically
from soccer_env.train.evaluate.results import KEPT_FILES
from soccer_env.train.files import read_lines
from soccer_env.train.ppo.checkpoints import LATEST, NAMES
from soccer_env.train.ppo.options import LOGS
from soccer_env.train.ppo.settings import LAST, TrainSettings
from soccer_env.train.provenance import module_hashes
from soccer_env.train.results_folder import SETTINGS, ResultsFolder, RunKind

LOG = "log.jsonl"
TABLE = "progress.csv"
EVALUATIONS = "evaluations.jsonl"
BEST = "best.safetensors"
CURVE = "learning_curve.png"
REPORT = "report.html"
BY_SIZE = ("goals", "minute")  # parts of a log line whose names change with the stage: no columns of a table
TRAINING = RunKind(
    "a training", ("league", "matches", "opponents", "past", "rollout", "epochs"),
    (LOG, TABLE, EVALUATIONS, BEST, LAST, CURVE, REPORT, LATEST, *NAMES),
    lambda _: [*LOGS, *KEPT_FILES], alone=True,
)  # fmt: skip


class RunFolder(ResultsFolder):
    """The folder of a run; ValueError if another process uses it, or if its run has other settings."""

    path: Path

    def __init__(self, settings: TrainSettings) -> None:
        conditions, every = settings.decisive(), settings.as_dict()
        free = {name: every[name] for name in every if name not in conditions and name != "anew"}
        defaults = TrainSettings().decisive()  # a setting that came after the run began was at its default
        made = module_hashes(settings.named)
        super().__init__(settings.out, TRAINING, conditions, made, free, settings.anew, defaults)
        whole = {"conditions": conditions, "made_with": made, "about": free}
        self.write(SETTINGS, json.dumps(whole, indent=2) + "\n")  # settings that may differ have their latest values

    def check_new(self) -> None:
        """Raise ValueError if the log has rollouts but the checkpoint is missing."""
        if self.lines():
            raise ValueError(f"{self.path} holds the log of a run without its {LATEST}; --anew starts again")

    def cut_logs_after(self, step: int) -> None:
        """Cut the logs back to the step at which the run resumes."""
        for name in (LOG, EVALUATIONS):
            path = self.path / name
            records = read_lines(path)
            if not all(isinstance(record.get("step"), int) for record in records):
                raise ValueError(f"{path} is damaged: it holds a line without its step; --anew starts again")
            kept = [record for record in records if record["step"] <= step]
            if len(kept) < len(records):
                write_atomically(path, "".join(json.dumps(record) + "\n" for record in kept))
        self._write_table()

    def log(self, record: dict[str, Any]) -> None:
        """Append the record of a rollout to log.jsonl and progress.csv."""
        self.add(LOG, [record])
        path = self.path / TABLE
        flat = flattened(record)
        header = "" if path.exists() else csv_lines([list(flat)])
        with path.open("a", encoding="utf-8", newline="") as file:
            file.write(header + csv_lines([list(flat.values())]))

    def log_evaluation(self, record: dict[str, Any]) -> None:
        """Append an evaluation to evaluations.jsonl."""
        self.add(EVALUATIONS, [record])

    def lines(self) -> list[dict[str, Any]]:
        """Return the log records of all rollouts so far."""
        return read_lines(self.path / LOG)

    def evaluations(self) -> list[dict[str, Any]]:
        """Return the records of all evaluations so far."""
        return read_lines(self.path / EVALUATIONS)

    def _write_table(self) -> None:
        """Rewrite progress.csv from log.jsonl."""
        lines = [flattened(record) for record in self.lines()]
        if lines:
            write_atomically(self.path / TABLE, csv_lines([list(lines[0]), *(list(line.values()) for line in lines)]))
        else:
            (self.path / TABLE).unlink(missing_ok=True)


def flattened(record: dict[str, Any]) -> dict[str, Any]:
    """Flatten nested dicts: {"points": {"chaser": 1}} becomes {"points_chaser": 1}; leave out those BY_SIZE."""
    flat: dict[str, Any] = {}
    for name, value in record.items():
        if name in BY_SIZE:
            continue
        if isinstance(value, dict):
            flat |= {f"{name}_{key}": part for key, part in value.items()}
        else:
            flat[name] = value
    return flat


def csv_lines(rows: list[list[Any]]) -> str:
    """Return rows as CSV text."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()
