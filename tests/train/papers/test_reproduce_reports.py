"""What a reproduction writes and shows: results, reports, tables and pictures, the same from processes of their own."""

import dataclasses
import io
import json
import sys
from pathlib import Path

import pytest
from rich.console import Console

from soccer_env.train.papers.claim import NO_MATCH, PLAYED, PLAYED_AND_STAGED, STAGED, Batch
from soccer_env.train.papers.report import row, screen_table
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.settings import ReproduceSettings
from soccer_env.train.papers.verdicts import Samples
from soccer_env.train.papers.workers import answer_requests, as_json, examine_in_processes
from tests.train.papers.staged_claims import CALLS, POSES, claim, draw, run


@pytest.fixture(autouse=True)
def no_calls() -> None:
    CALLS.clear(), POSES.clear()


def test_the_printed_table_marks_quick_verdicts_and_names_the_own_pose() -> None:
    printed = io.StringIO()
    Console(file=printed, width=200).print(screen_table(run("A1", quick=True, pose="percept")))
    assert "reproduced (quick)" in printed.getvalue() and "Own pose: percept." in printed.getvalue()


def test_every_result_names_the_own_pose_that_it_was_measured_with(tmp_path: Path) -> None:
    run("A1", "lost", out=tmp_path / "a")
    run("A1", "lost", pose="percept", out=tmp_path / "b")
    assert list(POSES) == ["particles", *["particles"] * 8, "percept", *["particles"] * 8]
    for name, poses, sentence in (
        ("a", ["particles", "particles"], "Own pose: particles.\n"),
        ("b", ["percept", "particles"], "Own pose: particles; percept for A1.\n"),
    ):
        records = json.loads((tmp_path / name / "results.json").read_text())
        assert [record["pose"] for record in records] == poses
        report = (tmp_path / name / "report.md").read_text()
        assert sentence in report and report.count(f"Own pose: {poses[0]}. Rules: ") >= 1
    assert records[0]["command"] == "soccer reproduce A1 --pose percept --seeds 0"
    with pytest.raises(ValueError, match="pose 'percept' there, 'particles' now"):
        run("A1", "lost", out=tmp_path / "b")


def test_every_result_states_its_rules_and_whether_others_can_be_asked_for(tmp_path: Path) -> None:
    rules = {"play": PLAYED, "both": PLAYED_AND_STAGED, "staged": STAGED, "none": NO_MATCH}
    told: dict[str, tuple[str, ...]] = {}

    def measure(batch: Batch) -> Samples:
        told[batch.claim] = batch.rules
        return draw(batch, 3.0)

    known = {name: claim(name, 3.0, rules=stated, measure=measure) for name, stated in rules.items()}
    asked = ReproduceSettings(claims=tuple(known), seeds=(0,), rules="simple", out=tmp_path)
    results = reproduce(asked, known=known)
    staged = "simple:dropped_ball=False"
    assert told == {"play": ("simple",), "both": ("simple", staged), "staged": (staged,), "none": ()}
    assert [result.rules for result in results] == [list(told[name]) for name in known]
    assert [row(result)[2] for result in results] == ["simple", "simple, staged", "staged", "no match"]
    report = (tmp_path / "report.md").read_text()
    assert "Rules of play: simple.\n" in report and f"Rules of play: simple; of staged scenes: {staged}.\n" in report
    assert f"Rules: staged scenes alone, {staged}; --rules changes nothing.\n" in report
    assert "Rules: it makes no match; --rules changes nothing.\n" in report
    assert results[0].command == "soccer reproduce play --rules simple --seeds 0"
    with pytest.raises(ValueError, match="rules 'simple' there, 'league' now"):
        reproduce(dataclasses.replace(asked, rules="league"), known=known)


def test_the_report_shows_each_claim_and_draws_its_figures(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    run("A1", "A4", "A6", out=tmp_path)
    report = (tmp_path / "report.md").read_text()
    assert "3 claims: 1 reproduced, 1 not, 1 by construction." in report
    assert "| A1 | What A1 says. | no match | reproduced | r |" in report
    assert "With the ingredient off (the shift)" in report
    assert "![A title](plots/A1-1.png)" in report
    drawn = (tmp_path / "plots" / "A1-1.png").read_bytes()
    run("A1", out=tmp_path / "again")
    assert drawn.startswith(b"\x89PNG") and (tmp_path / "again" / "plots" / "A1-1.png").read_bytes() == drawn
    page = (tmp_path / "report.html").read_text()
    assert "3 claims: 1 reproduced, 1 not, 1 by construction." in page and "With the ingredient off (the shift)" in page
    assert "Paper against measured" in page and page.count("<svg") == page.count("</svg>") > 1


def test_without_matplotlib_the_report_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    run("A1", out=tmp_path)
    report = (tmp_path / "report.md").read_text()
    assert 'pip install "soccer_env[plot]"' in report
    assert "| place [m] | a |" in report and "plots/" not in report


SETTINGS = ReproduceSettings(claims=("S15", "S20"), quick=True, seeds=(1, 2), threads=2)


def test_processes_change_no_result(tmp_path: Path) -> None:
    for threads in (1, 2):
        settings = dataclasses.replace(SETTINGS, threads=threads, out=tmp_path / f"{threads}")
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
    answer_requests([json.dumps({"settings": told, "hash": "h", "claim": "S15", "cap": 1})], answers)
    (answer,) = map(json.loads, answers.getvalue().splitlines())
    assert (answer["id"], answer["settings"], answer["seeds"]) == ("S15", "h", [1, 2])
