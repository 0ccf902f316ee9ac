"""Claims that are measured in processes of their own give the same results, and a process that fails says so."""

import io
import json
from pathlib import Path

import pytest

from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.settings import ReproduceSettings
from soccer_env.train.papers.workers import as_json, examine_in_processes, work

SETTINGS = ReproduceSettings(claims=("S15", "S20"), quick=True, seeds=(1, 2), threads=2)


def test_processes_change_no_result(tmp_path: Path) -> None:
    for threads in (1, 2):
        settings = ReproduceSettings(
            claims=SETTINGS.claims, quick=True, seeds=(1, 2), threads=threads, out=tmp_path / f"{threads}"
        )
        assert [result.id for result in reproduce(settings)] == ["S15", "S20"]
    one, two = ((tmp_path / name / "results.json").read_bytes() for name in ("1", "2"))
    assert one == two


def test_a_process_that_fails_ends_the_run_with_its_claim(capfd: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(RuntimeError, match="the process that measured claim S99 ended with code 1"):
        list(examine_in_processes({"S99": 1}, SETTINGS, "hash"))
    assert "KeyError: 'S99'" in capfd.readouterr().err


def test_a_worker_answers_a_line_for_each_claim_and_is_told_nothing_of_folders() -> None:
    told = as_json(ReproduceSettings(claims=("S15",), quick=True, out=Path("somewhere"), anew=True, threads=3))
    assert not {"out", "anew", "threads"} & set(told)
    answers = io.StringIO()
    work([json.dumps({"settings": told, "hash": "h"}), json.dumps(["S15", 1])], answers)
    (answer,) = map(json.loads, answers.getvalue().splitlines())
    assert (answer["id"], answer["settings"], answer["seeds"]) == ("S15", "h", [1, 2, 3])
