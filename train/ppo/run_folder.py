"""The folder of a training run: one training at a time, logs that go on, files written whole.

settings.json  log.jsonl  progress.csv  evaluations.jsonl  best.safetensors  last.safetensors  learning_curve.png
checkpoint-0.pt  checkpoint-1.pt  latest.json  tensorboard (if the package is installed)
"""

from __future__ import annotations

import csv
import io
import json
import shutil
from pathlib import Path
from typing import Any

from filelock import FileLock, Timeout

from soccer_env.train.files import append_lines, read_lines
from soccer_env.train.ppo.checkpoints import LATEST, NAMES
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.whole_files import write_whole

LOCK, SETTINGS = ".lock", "settings.json"
LOG, TABLE, EVALUATIONS = "log.jsonl", "progress.csv", "evaluations.jsonl"
BEST, LAST, CURVE = "best.safetensors", "last.safetensors", "learning_curve.png"
TENSORBOARD = "tensorboard"  # a folder
OWN = ("league", "steps", "matches", "opponents", "past", "rollout", "epochs")  # what only a training's settings have
FILES = (SETTINGS, LOG, TABLE, EVALUATIONS, BEST, LAST, CURVE, LATEST, *NAMES)


class RunFolder:
    """The folder of a run; ValueError if another training uses it, or if it holds a run of other settings."""

    def __init__(self, settings: TrainSettings) -> None:
        self.path = settings.out
        if self.path.exists() and not self.path.is_dir():
            raise ValueError(f"out: {self.path} is a file; give a folder")
        self.path.mkdir(parents=True, exist_ok=True)
        self._lock = lock(self.path / LOCK)
        try:
            self._check_owner()
            self._tidy(settings.anew)
            self._check_settings(settings)
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Let another training use the folder."""
        self._lock.release()

    def _check_owner(self) -> None:
        """Raise ValueError if settings.json is of something else, an evaluation say: --anew must not remove that."""
        before = self._settings_before()
        if not (self.path / SETTINGS).exists() and any((self.path / name).exists() for name in (*FILES, TENSORBOARD)):
            raise ValueError(f"{self.path} holds files, but no {SETTINGS} of a training; give another --out")
        if before is not None and not before.keys() >= set(OWN):
            raise ValueError(f"{self.path} holds {SETTINGS} of something else than a training; give another --out")

    def _tidy(self, anew: bool) -> None:
        """Remove what a kill left half written; with `anew` all that is of an earlier run."""
        for name in FILES:
            for torn in self.path.glob(f".{name}.*.tmp"):
                torn.unlink(missing_ok=True)
            if anew:
                (self.path / name).unlink(missing_ok=True)
        if anew:
            shutil.rmtree(self.path / TENSORBOARD, ignore_errors=True)

    def _settings_before(self) -> dict[str, Any] | None:
        """Return the settings that a run began with, None if there are none to read."""
        try:
            before = json.loads((self.path / SETTINGS).read_text(encoding="utf-8"))
        except (FileNotFoundError, ValueError, RecursionError):
            return None
        return before if isinstance(before, dict) else None

    def _check_settings(self, settings: TrainSettings) -> None:
        """Write the settings down, or compare them with those of the run that began here."""
        path, before = self.path / SETTINGS, self._settings_before()
        if before is None and path.exists():
            raise ValueError(f"{path} cannot be read, it is damaged; --anew starts again")
        now = settings.decisive()
        added = TrainSettings().decisive()  # a setting that came after the run began was at its default
        before = None if before is None else added | before
        differ = [name for name in now if before is not None and before.get(name) != now[name]]
        if before is not None and differ:
            told = ", ".join(f"{name} = {before.get(name)!r}, now {now[name]!r}" for name in differ)
            raise ValueError(
                f"{self.path} holds a run with other settings ({told}); give another --out, or --anew to start again"
            )
        write_whole(path, json.dumps(settings.as_dict(), indent=1) + "\n")

    def check_new(self) -> None:
        """Raise ValueError if rollouts were logged, and so a checkpoint written, which is not there any more."""
        if self.lines():
            raise ValueError(f"{self.path} holds the log of a run without its {LATEST}; --anew starts again")

    def forget_after(self, step: int) -> None:
        """Cut the logs back to what was known at a step, from which the run goes on."""
        for name in (LOG, EVALUATIONS):
            path = self.path / name
            records = read_lines(path)
            if not all(isinstance(record.get("step"), int) for record in records):
                raise ValueError(f"{path} is damaged: it holds a line without its step; --anew starts again")
            kept = [record for record in records if record["step"] <= step]
            if len(kept) < len(records):
                write_whole(path, "".join(json.dumps(record) + "\n" for record in kept))
        self._write_table()

    def log(self, record: dict[str, Any]) -> None:
        """Add the line of a rollout to log.jsonl and progress.csv."""
        append_lines(self.path / LOG, [record])
        path = self.path / TABLE
        flat = flattened(record)
        header = "" if path.exists() else csv_lines([list(flat)])
        with path.open("a", encoding="utf-8", newline="") as file:
            file.write(header + csv_lines([list(flat.values())]))

    def log_evaluation(self, record: dict[str, Any]) -> None:
        """Add an evaluation to evaluations.jsonl."""
        append_lines(self.path / EVALUATIONS, [record])

    def lines(self) -> list[dict[str, Any]]:
        """Return the lines of all rollouts so far."""
        return read_lines(self.path / LOG)

    def evaluations(self) -> list[dict[str, Any]]:
        """Return all evaluations so far."""
        return read_lines(self.path / EVALUATIONS)

    def write(self, name: str, content: str | bytes) -> None:
        """Write one of the other files, whole or not at all."""
        write_whole(self.path / name, content)

    def _write_table(self) -> None:
        """Write progress.csv anew from log.jsonl."""
        lines = [flattened(record) for record in self.lines()]
        if lines:
            write_whole(self.path / TABLE, csv_lines([list(lines[0]), *(list(line.values()) for line in lines)]))
        else:
            (self.path / TABLE).unlink(missing_ok=True)


def lock(path: Path) -> FileLock:
    """Return the lock of a folder, held; ValueError if another training holds it. It ends with the process."""
    held = FileLock(path)
    try:
        held.acquire(timeout=0)
    except Timeout as error:
        raise ValueError(f"another training uses {path.parent}; give another --out") from error
    return held


def flattened(record: dict[str, Any]) -> dict[str, Any]:
    """Return a record with the entries of its parts as part_entry."""
    flat: dict[str, Any] = {}
    for name, value in record.items():
        if isinstance(value, dict):
            flat |= {f"{name}_{key}": part for key, part in value.items()}
        else:
            flat[name] = value
    return flat


def csv_lines(rows: list[list[Any]]) -> str:
    """Return rows as lines of CSV."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()
