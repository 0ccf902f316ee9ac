"""`soccer reproduce` as it is typed: mistakes in one line, the command that asks for the same, all claims complete."""

import json
import re
import subprocess
import sys

import pytest

from soccer_env.train.command.command_line import main
from soccer_env.train.papers import reproduction
from soccer_env.train.papers.claims import all_claims, find_claims
from soccer_env.train.papers.settings import ReproduceSettings, command_of
from soccer_env.train.papers.stored import FOLDERS, read_stored


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (["reproduce"], "give the ids of claims, or --all"),
        (["reproduce", "S05", "--all"], "give the ids of claims, or --all"),
        (["reproduce", "X99"], "unknown claim 'X99'; known: "),
        (["reproduce", "S05", "--minutes", "0"], "minutes must be a number above 0"),
        (["reproduce", "S05", "--minutes", "3", "--quick"], "give quick or minutes, not both"),
        (["reproduce", "S05", "--seed", "-1"], "seeds must be a whole number"),
        (["reproduce", "S05", "--seeds", "1", "2", "1"], "seeds must be whole numbers, at least one and each once"),
        (["reproduce", "S05", "--pose", "compass"], "unknown --pose 'compass'"),
        (["reproduce", "S05", "--rules", "street"], "unknown --rules 'street'"),
        (
            ["reproduce", "S05", "--stored", "--quick"],
            "stored measures nothing: give it without quick, minutes and out",
        ),
        (["reproduce", "sensors", "--stored"], "no result of sensors is stored; measure it without --stored"),
    ],
)
def test_a_mistake_is_one_line(words: list[str], complaint: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(words) == 2
    printed = capsys.readouterr().err
    assert complaint in printed and printed.count("\n") == 1


def test_the_command_is_the_one_that_asks_for_the_same() -> None:
    settings = ReproduceSettings(claims=("S05", "S06"), quick=True, seeds=(3,), threads=2, out="runs/a")
    assert command_of(settings) == "soccer reproduce S05 S06 --quick --seeds 3 --threads 2 --out runs/a"
    assert command_of(settings, "S06") == "soccer reproduce S06 --quick --seeds 3"
    assert command_of(ReproduceSettings(all=True, minutes=9.0), "S06") == "soccer reproduce --all --minutes 9"


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


def test_claims_can_be_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "claims"]) == 0
    printed = capsys.readouterr().out
    assert "S05" in printed and "median range error" in printed and "league, staged" in printed


def test_stored_results_are_printed_with_every_criterion_and_nothing_is_measured(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reproduction, "measure_missing", None)
    assert main(["reproduce", "S63", "H12", "--stored"]) == 0
    printed = " ".join(capsys.readouterr().out.split())
    stored = {name: row for folder in FOLDERS.values() for name, row in read_stored(folder).items()}
    for name in ("S63", "H12"):
        found, claim = stored[name], all_claims()[name]
        assert all(one["shown"] in printed for one in found["findings"] + found["without_findings"])
        assert claim.statement in printed and claim.method in printed and str(claim.note).strip() in printed
        assert f"Measured {found['about']['date']}, commit {found['about']['commit']}." in printed
    assert "With the ingredient off (one speed for both" in printed and "at least 80" in printed


def test_all_stored_results_are_a_table_alone(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reproduce", "--all", "--stored"]) == 0
    printed = capsys.readouterr().out
    assert len(re.findall(r"│ [SH]\d\d │", printed)) == 72 + 27 and "Measured 2" not in printed
    assert main(["reproduce", "S63", "--stored", "--json"]) == 0
    (record,) = json.loads(capsys.readouterr().out)
    assert record["verdict"] == "not" and record["findings"][0]["shown"] == "73.8 % (70.3 to 77.7)"


def test_settings_import_nothing_heavy() -> None:
    program = (
        "import sys\nimport soccer_env.train.papers.settings\n"
        "print(sorted({'numba', 'matplotlib', 'scipy', 'pymunk'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
