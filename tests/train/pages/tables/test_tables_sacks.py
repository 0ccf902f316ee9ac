"""The README of sacks-2001 is what the stored results and the settings say; what was not measured is shown so."""

import dataclasses
import json
import re
from dataclasses import fields
from pathlib import Path

import pytest

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.train.pages.tables import heinemann
from soccer_env.train.pages.tables.paper_page import PaperPage, bound_in_signs, claims_table
from soccer_env.train.pages.tables.sacks import PAGE
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.settings import ReproduceSettings


def rows_of(text: str) -> dict[str, list[str]]:
    """Return the cells of each row of a table by the first."""
    lines = [line.strip("|").split(" | ") for line in text.splitlines() if line.startswith("|")]
    return {cells[0].strip(): [cell.strip() for cell in cells] for cells in lines}


def test_the_readme_of_the_team_shows_what_was_measured() -> None:
    readme = (PAGE.folder / "README.md").read_text(encoding="utf-8")
    assert PAGE.with_tables(readme, PAGE.stored()) == readme


def test_every_claim_of_the_paper_has_a_row_and_what_was_not_measured_says_so() -> None:
    rows = rows_of(claims_table({}, PAGE.claims))
    assert [name for name in rows if name in PAGE.claims] == list(PAGE.claims)
    assert all(rows[name][3] == "not measured" for name in PAGE.claims)
    assert set(PAGE.claims) <= set(all_claims())
    assert all(all_claims()[name].statement == rows[name][1] for name in PAGE.claims)


def test_a_row_shows_the_number_that_decides_with_what_it_is_and_its_bound() -> None:
    rows = rows_of(claims_table(PAGE.stored(), PAGE.claims))
    assert rows["S63"][2:] == ["73.8 % (70.3 to 77.7)", "**not**", "clean, at 3 and 6 cm/s [≥80]"]
    assert bound_in_signs("at least 35 and at most 45") == " [≥35 ≤45]" and bound_in_signs("below 0.25") == " [<0.25]"
    assert bound_in_signs("") == ""


def test_a_claim_is_one_short_sentence() -> None:
    assert [name for name, claim in all_claims().items() if len(claim.statement.split()) > 17] == []


@pytest.mark.parametrize(("page", "words"), [(PAGE, 3500), (heinemann.PAGE, 2000)])
def test_a_page_of_claims_is_short_enough_to_be_read(page: PaperPage, words: int) -> None:
    assert len((page.folder / "README.md").read_text(encoding="utf-8").split()) <= words


def test_the_page_names_the_constants_of_the_paper_and_counts_the_assumed_ones() -> None:
    text = " ".join(PAGE.tables["constants"]().split())
    assert "`player_gain` 0.8 m^exponent, `player_range` 1 m, `wall_gain` 0.2 m^exponent, `wall_range` 0.35 m" in text
    assert "`step_length` 0.035 m" in text and "`goal_limit` 1.22 rad (70 degrees)" in text
    assert "stuck_count" not in text, "assumed"
    settings, numbers, rules, assumed = (int(word) for word in re.findall(r"\b(\d+) (?:settings|are)", text))
    assert settings == len(fields(SacksSettings)) == numbers + rules + 1 + assumed


def test_a_run_is_taken_in_with_its_verdict_and_interval(tmp_path: Path) -> None:
    (result,) = reproduce(ReproduceSettings(claims=("S15",), quick=True, out=tmp_path / "run"))
    markers = (f"<!-- table: {name} -->\n<!-- end of table: {name} -->" for name in ("claims", *PAGE.tables))
    (tmp_path / "README.md").write_text("\n".join(markers))
    page = dataclasses.replace(PAGE, folder=tmp_path)
    assert page.main(["run", str(tmp_path / "run")]) == 0
    written = (tmp_path / "README.md").read_text()
    row = rows_of(written)["S15"]
    assert row[3] == f"{result.verdict} (quick)" and row[2].startswith(f"{result.estimate:.1f}")
    assert (
        "72 claims: 1 " in (tmp_path / "README.md").read_text()
        and "71 not measured" in (tmp_path / "README.md").read_text()
    )
    assert list(json.loads((tmp_path / "claims.json").read_text())) == ["S15"]
    with pytest.raises(ValueError, match="holds no"):
        PAGE.take(empty_run(tmp_path))
    assert page.main(["nonsense"]) == 2


def empty_run(path: Path) -> Path:
    """Return a folder of a run without claims of the paper."""
    found = path / "empty"
    found.mkdir()
    (found / "settings.json").write_text(json.dumps({"conditions": {}, "made_with": {}, "about": {}}))
    (found / "claims.jsonl").write_text("")
    return found
