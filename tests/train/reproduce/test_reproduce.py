"""The reproduction bench: stops when a claim is decided, resumes, refuses what does not belong together."""

import dataclasses
import io
import json
import sys
from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

from soccer_env.train.reproduce.claim import (
    NO_MATCH,
    PLAYED,
    PLAYED_AND_STAGED,
    SACKS,
    STAGED,
    Batch,
    Claim,
    Curve,
    Figure,
    Without,
)
from soccer_env.train.reproduce.examination import looks_at
from soccer_env.train.reproduce.report import row, screen_table, section
from soccer_env.train.reproduce.reproduction import reproduce
from soccer_env.train.reproduce.results import ClaimResult
from soccer_env.train.reproduce.settings import ReproduceSettings
from soccer_env.train.reproduce.verdicts import Criterion, Samples, counted, measured, reported

CALLS: list[tuple[str, int]] = []  # claim, batch
POSES: list[str] = []  # of the same batches


def draw(batch: Batch, mean: float = 0.0, count: int = 20) -> Samples:
    CALLS.append((batch.claim, batch.index))
    POSES.append(batch.pose)
    return {"x": batch.rng().normal(mean, 1.0, count), "one": np.ones(count), "up": batch.rng().random(count) < 0.9}


def mean(samples: Samples) -> float:
    return float(samples["x"].mean())


def plot(samples: Samples) -> tuple[Figure, ...]:
    return (Figure("A title", "place [m]", "value", (Curve("a", [0.0, 1.0], [mean(samples), np.nan]),), rules=(0.5,)),)


def claim(name: str, expected: float, *criteria: Criterion, **changes: object) -> Claim:
    made = Claim(
        id=name, paper=SACKS, section="0", statement=f"What {name} says.", method="Draws.",
        rules=NO_MATCH, criteria=criteria or (measured("mean above 0", mean, unit="cm", above=0.0),),
        measure=lambda batch: draw(batch, expected), batches=8, figures=plot,
    )  # fmt: skip
    return dataclasses.replace(made, **changes)  # type: ignore[arg-type]


KNOWN = {
    made.id: made
    for made in (
        claim("A1", 3.0),
        claim("A2", -3.0),
        claim("A3", 0.0, measured("mean above -0.01", mean, above=-0.01)),
        claim("A4", 3.0, without=Without("the shift", lambda batch: draw(batch, -3.0))),
        claim("A5", 0.0, reported("mean", mean)),
        claim("A6", 0.0, counted("at least 60 %", "up", "one", at_least=60.0), measured("mean < -1", mean, below=-1.0)),
        claim("look", 0.0, study=True),
        claim("lost", 0.0, study=True, pose="particles"),
    )
}


@pytest.fixture(autouse=True)
def no_calls() -> None:
    CALLS.clear()
    POSES.clear()


def run(*names: str, **settings: object) -> list[ClaimResult]:
    return reproduce(ReproduceSettings(claims=names, **{"seeds": (0,), **settings}), known=KNOWN)  # type: ignore[arg-type]


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
    assert looks_at(1) == [1]
    assert looks_at(8) == [1, 2, 4, 8]
    assert looks_at(11) == [1, 2, 4, 8, 11]
    assert looks_at(11, least=3) == [3, 6, 11]
    assert looks_at(1, least=3) == [1]


def test_what_was_put_in_is_by_construction_and_is_shown_without_it() -> None:
    (result,) = run("A4")
    assert result.verdict == "by construction"
    assert result.without == "the shift"
    assert [found["verdict"] for found in result.without_findings] == ["not"]
    assert result.findings[0]["verdict"] == "reproduced"


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
    known = {"A8": claim("A8", 0.0, *criteria, measure=few, changed="Before: x above 9.")}
    (result,) = reproduce(ReproduceSettings(claims=("A8",), seeds=(1, 2)), known=known)
    assert [found["n"] for found in result.findings] == [14, 14, 30, 40]
    assert (result.n, result.n_used) == (40, 14)
    assert "Changed after a first look. Before: x above 9." in section(result, [])
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
    assert result.n == 20 and result.quick and result.marked == "undecided (quick)"
    report = (tmp_path / "report.md").read_text()
    assert "| undecided (quick) | u |" in report and "## A3: undecided (quick)" in report
    (record,) = json.loads((tmp_path / "results.json").read_text())
    names = list(record)
    assert (record["verdict"], record["shown"], record["quick"]) == ("undecided", "undecided (quick)", True)
    assert names[names.index("verdict") :][:3] == ["verdict", "shown", "quick"]


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


def test_results_hold_what_was_agreed(tmp_path: Path) -> None:
    run("A1", "A4", "A5", out=tmp_path)
    records = json.loads((tmp_path / "results.json").read_text())
    assert [record["id"] for record in records] == ["A1", "A4", "A5"]
    fields = {"id", "paper", "verdict", "estimate", "low", "high", "criterion", "n", "seeds", "command", "ingredients"}
    assert all(fields | {"note"} <= set(record) for record in records)
    assert records[0]["command"] == "soccer reproduce A1 --seeds 0"


def test_the_report_shows_each_claim_and_draws_its_figures(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    run("A1", "A4", "A6", out=tmp_path)
    report = (tmp_path / "report.md").read_text()
    assert "3 claims: 1 reproduced, 1 not, 1 by construction." in report
    assert "| A1 | What A1 says. | no match | reproduced | r |" in report
    assert "With the ingredient off (the shift)" in report
    assert "![A title](plots/A1-1.png)" in report
    assert (tmp_path / "plots" / "A1-1.png").read_bytes().startswith(b"\x89PNG")


def test_without_matplotlib_the_report_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    run("A1", out=tmp_path)
    report = (tmp_path / "report.md").read_text()
    assert 'pip install "soccer_env[plot]"' in report
    assert "| place [m] | a |" in report and "plots/" not in report


def test_drawing_is_repeatable(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    for name in ("a", "b"):
        run("A1", out=tmp_path / name)
    one, two = ((tmp_path / name / "plots" / "A1-1.png").read_bytes() for name in ("a", "b"))
    assert one == two


def test_all_leaves_out_studies_which_can_be_named() -> None:
    results = reproduce(ReproduceSettings(all=True, quick=True), known=KNOWN)
    assert [result.id for result in results] == ["A1", "A2", "A3", "A4", "A5", "A6"]
    assert [result.id for result in run("look", "look", quick=True)] == ["look"]


def test_an_unknown_claim_says_which_exist() -> None:
    with pytest.raises(ValueError, match="unknown claim 'S99'; known: A1, A2"):
        run("A1", "S99")


def test_batches_draw_from_seeds_of_their_own() -> None:
    draws = {
        tuple(Batch(name, seed, index).seeds(2).tolist()) for name in ("A", "B") for seed in (0, 1) for index in (0, 1)
    }
    assert len(draws) == 8
    assert Batch("A", 0, 0).seeds(4)[:2].tolist() == Batch("A", 0, 0, threads=2).seeds(2).tolist()
    assert Batch("A", 0, 0).rng().random() != Batch("A", 0, 0).rng(1).random()
