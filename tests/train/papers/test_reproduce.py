"""The reproduction bench stops when a claim is decided, resumes, refuses what does not belong together; its command."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.train.papers import reproduction
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.claims import all_claims, find_claims
from soccer_env.train.papers.examination import examination_points
from soccer_env.train.papers.report import row, section
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.results import FOLDERS, measured_where, read_stored
from soccer_env.train.papers.settings import ReproduceSettings, command_of
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported
from tests.train.papers.staged_claims import CALLS, KNOWN, POSES, claim, draw, run


@pytest.fixture(autouse=True)
def no_calls() -> None:
    CALLS.clear(), POSES.clear()


def test_sampling_stops_when_the_interval_decides() -> None:
    (up,), (down,) = run("A1"), run("A2")
    assert (up.verdict, down.verdict) == ("reproduced", "not")
    assert CALLS == [("A1", 0), ("A2", 0)]
    assert up.n == 20 and up.cap == 160
    assert up.low > 0.0 > down.high


def test_the_cap_ends_what_stays_undecided_and_n_says_so() -> None:
    (result,) = run("A3")
    assert result.verdict == "undecided"
    assert (result.n, result.cap, len(CALLS)) == (160, 160, 8)
    assert result.low < -0.01 < result.high


def test_looks_double_and_share_the_five_per_cent() -> None:
    (once,), (often,) = run("A1", quick=True), run("A1")
    assert once.estimate == often.estimate and often.low < once.low < once.high < often.high
    assert [examination_points(cap) for cap in (1, 8, 11)] == [[1], [1, 2, 4, 8], [1, 2, 4, 8, 11]]
    assert [examination_points(cap, least=3) for cap in (11, 1)] == [[3, 6, 11], [1]]


def test_what_was_put_in_is_by_construction_and_is_shown_without_it() -> None:
    (result,) = run("A4")
    assert (result.verdict, result.without) == ("by construction", "the shift")
    assert [found["verdict"] for found in result.findings + result.without_findings] == ["reproduced", "not"]


def test_three_seeds_are_put_together_and_each_speaks_for_itself(tmp_path: Path) -> None:
    (result,) = run("A1", seeds=(4, 5, 6), out=tmp_path)
    assert result.n == 60 and result.seeds == [4, 5, 6] and result.by_seed == ["reproduced"] * 3
    assert [index for _, index in CALLS] == [0, 0, 0]
    alone = [run("A1", seeds=(seed,))[0].estimate for seed in (4, 5, 6)]
    assert result.estimate == pytest.approx(np.mean(alone))  # type: ignore[arg-type]
    assert "| reproduced | r r r |" in (tmp_path / "report.md").read_text()


def test_seeds_that_contradict_each_other_are_marked() -> None:
    signs = claim("A7", 0.0, measure=lambda batch: draw(batch, {1: 3.0, 2: -3.0, 3: 0.0}[batch.seed]))
    (result,) = reproduce(ReproduceSettings(claims=("A7",), seeds=(1, 2, 3)), known={"A7": signs})
    assert result.by_seed == ["reproduced", "not", "undecided"] and result.verdict == "undecided"
    assert result.alone == "r n u, they disagree"
    assert run("A1", seeds=(1, 2))[0].alone == "r r"


def test_a_decided_claim_is_asked_on_until_each_seed_has_an_answer_or_a_third_of_the_cap_is_taken() -> None:
    weak = claim("A9", 0.45, measure=lambda batch: draw(batch, 0.45), batches=32)
    (result,) = reproduce(ReproduceSettings(claims=("A9",), seeds=(1, 2, 3)), known={"A9": weak})
    assert result.verdict == "reproduced" and result.by_seed == ["reproduced"] * 3
    assert 60 < result.n < 20 * 3 * 32 / 3, "it was decided by all seeds together before"
    near = claim("A10", 0.12, measure=lambda batch: draw(batch, {1: 0.4, 2: 0.4, 3: 0.0}[batch.seed]), batches=32)
    (result,) = reproduce(ReproduceSettings(claims=("A10",), seeds=(1, 2, 3)), known={"A10": near})
    assert result.verdict == "reproduced" and result.by_seed == ["reproduced", "reproduced", "undecided"]
    assert result.n == 20 * 3 * 16, "of the looks at 1, 2, 4, 8, 16, 32 batches 16 is the first beyond a third"


def test_units_without_a_value_do_not_count() -> None:
    def few(batch: Batch) -> Samples:
        x = draw(batch, 3.0)["x"]
        return {"x": np.where(np.arange(20) < 7, x, np.nan), "y": x[:, None], "trials": np.arange(20) % 4}

    criteria = (
        measured("x", lambda samples: float(np.nanmean(samples["x"])), above=0.0),
        reported("both", lambda samples: float(np.nanmean(samples["x"]) + samples["y"].mean())),
        counted("share", "trials", "trials", at_least=50.0),
        reported("all", lambda samples: float(samples["y"].mean())),
    )
    known = {"A8": claim("A8", 0.0, *criteria, measure=few)}
    (result,) = reproduce(ReproduceSettings(claims=("A8",), seeds=(1, 2)), known=known)
    assert [found["n"] for found in result.findings] == [14, 14, 30, 40]
    assert (result.n, result.n_used) == (40, 14)
    assert "| x | above 0 |" in section(result, []) and "| 14 of 40 | reproduced |" in section(result, [])
    assert row(result)[-1] == "14 of 40"


def test_context_decides_nothing_but_shows_its_numbers() -> None:
    (result,) = run("A5")
    assert result.verdict == "context" and result.criterion == "mean"
    assert result.findings[0]["estimate"] is not None


def test_one_violated_criterion_is_enough_and_each_is_shown() -> None:
    (result,) = run("A6")
    assert result.verdict == "not" and result.criterion == "mean < -1"
    assert [found["criterion"] for found in result.findings] == ["at least 60 %", "mean < -1"]


def test_quick_takes_few_samples_and_marks_its_verdicts(tmp_path: Path) -> None:
    (result,) = run("A3", quick=True, out=tmp_path)
    assert result.n == 20 and result.quick and result.marked_verdict == "undecided (quick)"
    report = (tmp_path / "report.md").read_text()
    assert "| undecided (quick) | u |" in report and "## A3: undecided (quick)" in report
    (record,) = json.loads((tmp_path / "results.json").read_text())
    names = list(record)
    assert (record["verdict"], record["shown"], record["quick"]) == ("undecided", "undecided (quick)", True)
    assert names[names.index("verdict") :][:3] == ["verdict", "shown", "quick"]


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("{}", "is of something else than a reproduction run; give another folder"),
        ("[1]", "is of something else"),
        ('{"conditions": {"claims": [], "budget": ""}, "made_with": {}, "about": 3}', "is of something else"),
        ('{"conditions": ', "cannot be read as JSON"),
        ("", "cannot be read as JSON"),
    ],
)
def test_a_damaged_settings_file_is_a_plain_complaint(tmp_path: Path, text: str, complaint: str) -> None:
    run("A1", out=tmp_path)
    (tmp_path / "settings.json").write_text(text)
    with pytest.raises(ValueError, match=f"settings.json {complaint}"):
        run("A1", out=tmp_path)
    if "something else" in complaint:
        with pytest.raises(ValueError, match=complaint):
            run("A1", out=tmp_path, anew=True)
        assert (tmp_path / "settings.json").read_text() == text
    else:
        assert run("A1", out=tmp_path, anew=True)[0].verdict == "reproduced"


def test_minutes_choose_numbers_of_batches_not_times() -> None:
    (result,) = run("A3", minutes=0.5)  # 30 s at 3 s a batch
    assert result.cap == 200
    run("A3", "A5", minutes=0.1)
    assert CALLS[-2:] == [("A3", 0), ("A5", 0)]


def test_batches_draw_from_seeds_of_their_own() -> None:
    asked = [(name, seed, index) for name in ("A", "B") for seed in (0, 1) for index in (0, 1)]
    assert len({tuple(Batch(*one).seeds(2).tolist()) for one in asked}) == 8
    assert Batch("A", 0, 0).seeds(4)[:2].tolist() == Batch("A", 0, 0, threads=2).seeds(2).tolist()
    assert Batch("A", 0, 0).rng().random() != Batch("A", 0, 0).rng(1).random()


def test_same_seed_same_results_another_seed_others(tmp_path: Path) -> None:
    for name, threads in (("a", 1), ("b", 4)):
        run("A1", "A3", seeds=(5,), threads=threads, out=tmp_path / name)
    one, two = ((tmp_path / name / "results.json").read_bytes() for name in ("a", "b"))
    assert one == two
    alone, beside, other = run("A1", seeds=(5,)), run("A1", "A3", seeds=(5,)), run("A1", seeds=(6,))
    assert alone[0].as_dict() == beside[0].as_dict() != other[0].as_dict()


def test_a_stopped_run_goes_on_where_it_was(tmp_path: Path) -> None:
    whole = run("A1", "A2", "A3", out=tmp_path / "whole")
    torn = tmp_path / "torn"
    run("A1", "A2", "A3", out=torn)
    lines = (torn / "claims.jsonl").read_bytes().splitlines(keepends=True)
    (torn / "claims.jsonl").write_bytes(lines[0] + lines[1][:40])
    CALLS.clear()
    assert run("A1", "A2", "A3", out=torn) == whole
    assert {name for name, _ in CALLS} == {"A2", "A3"}
    assert (torn / "results.json").read_bytes() == (tmp_path / "whole" / "results.json").read_bytes()


@pytest.mark.parametrize("change", [{"seeds": (1,)}, {"quick": True}, {"claims": ("A1", "A2")}])
def test_another_run_is_refused_unless_anew(tmp_path: Path, change: dict[str, object]) -> None:
    settings = {"claims": ("A1",), "out": tmp_path}
    reproduce(ReproduceSettings(**settings), known=KNOWN)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="holds a reproduction run with other settings"):
        reproduce(ReproduceSettings(**(settings | change)), known=KNOWN)  # type: ignore[arg-type]
    assert reproduce(ReproduceSettings(**(settings | change), anew=True), known=KNOWN)  # type: ignore[arg-type]


def test_all_leaves_out_studies_which_can_be_named() -> None:
    results = reproduce(ReproduceSettings(all=True, quick=True), known=KNOWN)
    assert [result.id for result in results] == ["A1", "A2", "A3", "A4", "A5", "A6"]
    assert [result.id for result in run("look", "look", quick=True)] == ["look"]
    with pytest.raises(ValueError, match="unknown claim 'S99'; known: A1, A2"):
        run("A1", "S99")


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (["reproduce"], "give the ids of claims, or --all"),
        (["reproduce", "S05", "--all"], "give the ids of claims, or --all"),
        (["reproduce", "X99"], "unknown claim 'X99'; known: "),
        (["reproduce", "S05", "--minutes", "0"], "minutes must be a number above 0"),
        (["reproduce", "S05", "--minutes", "3", "--quick"], "give quick or minutes, not both"),
        (["reproduce", "S05", "--stored", "--quick"], "stored measures nothing: give it without quick"),
        (["reproduce", "sensors", "--stored"], "no result of sensors is stored; measure it without --stored"),
        (["reproduce", "S05", "--seed", "-1"], "seeds must be a whole number"),
        (["reproduce", "S05", "--seeds", "1", "2", "1"], "seeds must be whole numbers, each once"),
        (["reproduce", "S05", "--pose", "compass"], "unknown --pose 'compass'"),
        (["reproduce", "S05", "--rules", "street"], "unknown --rules 'street'"),
    ],
)
def test_a_mistake_is_one_line(words: list[str], complaint: str, soccer: Any) -> None:
    assert complaint in soccer(*words, code=2)


def test_the_command_is_the_one_that_asks_for_the_same() -> None:
    settings = ReproduceSettings(claims=("S05", "S06"), quick=True, seeds=(3,), threads=2, out="runs/a")
    assert command_of(settings) == "soccer reproduce S05 S06 --quick --seeds 3 --threads 2 --out runs/a"
    assert command_of(settings, "S06") == "soccer reproduce S06 --quick --seeds 3"
    assert command_of(ReproduceSettings(all=True, minutes=9.0), "S06") == "soccer reproduce --all --minutes 9"


def test_stored_results_are_printed_with_every_criterion_and_nothing_is_measured(soccer: Any, monkeypatch: Any) -> None:
    monkeypatch.setattr(reproduction, "measure_missing", None)
    printed = " ".join(soccer("reproduce", "S63", "H26", "--stored").split())
    stored = {name: row for folder in FOLDERS.values() for name, row in read_stored(folder).items()}
    for name in ("S63", "H26"):
        found, claim = stored[name], all_claims()[name]
        assert all(one["shown"] in printed for one in found["findings"] + found["without_findings"])
        assert claim.statement in printed and claim.method in printed and str(claim.note).strip() in printed
        assert f"Measured {measured_where(found)}." in printed
    assert "With the ingredient off (the own pose" in printed and "at least 80" in printed


def test_all_stored_results_are_a_table_alone(soccer: Any) -> None:
    printed = soccer("reproduce", "--all", "--stored")
    stored = sum(len(read_stored(folder)) for folder in FOLDERS.values())
    assert len(re.findall(r"│ [SH]\d\d │", printed)) == stored > 60 and "Measured 2" not in printed
    (record,) = json.loads(soccer("reproduce", "S63", "--stored", "--json"))
    assert record["verdict"] == "not" and record["findings"][0]["shown"] == "73.3 % (69.7 to 77.1)"


def test_every_built_claim_is_complete() -> None:
    claims = all_claims()
    for name, found in claims.items():
        texts = (found.paper, found.statement, found.method, *(criterion.text for criterion in found.criteria))
        assert name == found.id and all(texts), name
        assert found.study or found.section, name
        assert 1 <= found.quick <= found.batches >= found.least >= 1 and found.seconds > 0.0, name
        assert found.quick * found.seconds <= 15.0 and found.batches * found.seconds <= 150.0, f"{name} takes too long"
    assert find_claims(["S05", "S05"], claims) == [claims["S05"]]
    measured_by_all = [found for found in claims.values() if not found.study]
    assert sum(found.quick * found.seconds for found in measured_by_all) <= 385.0  # [s] on one core: 5 minutes on two
    assert sum(found.batches * found.seconds for found in measured_by_all) <= 5400.0
