"""The README of sacks-2001 is what the stored results and the settings say; what was not measured is shown so."""

import dataclasses
import json
import re
from dataclasses import fields
from pathlib import Path

import pytest

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.train.pages.tables.paper_page import claims_table, with_notes
from soccer_env.train.pages.tables.sacks import PAGE
from soccer_env.train.pages.tables.sacks_settings import settings_table
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
    assert all(rows[name][4] == "not measured" for name in PAGE.claims)
    assert set(PAGE.claims) <= set(all_claims())
    assert all(all_claims()[name].statement in rows[name][1] for name in PAGE.claims)


def test_every_setting_of_the_team_stands_in_its_table() -> None:
    rows = rows_of(settings_table())
    assert {f"`{field.name}`" for field in fields(SacksSettings)} <= set(rows)
    assert rows["`player_range`"][1] == "1 m" and rows["`goal_limit`"][1] == "1.22 rad (70 degrees)"
    assert "4.3.2" in rows["`player_gain`"][3]


def test_the_page_names_the_constants_of_the_paper_and_counts_the_assumed_ones() -> None:
    text = " ".join(PAGE.tables["constants"]().split())
    assert "`player_gain` 0.8 m^exponent, `player_range` 1 m, `wall_gain` 0.2 m^exponent, `wall_range` 0.35 m" in text
    assert "`step_length` 0.035 m" in text and "`goal_limit` 1.22 rad (70 degrees)" in text
    assert "stuck_count" not in text, "assumed"
    settings, numbers, rules, assumed = (int(word) for word in re.findall(r"\b(\d+) (?:settings|are)", text))
    assert settings == len(fields(SacksSettings)) == numbers + rules + 1 + assumed


def test_a_note_that_was_written_anew_replaces_the_one_of_the_run() -> None:
    stored = PAGE.stored()
    (name, row), *_ = ((name, row) for name, row in stored.items() if row["note"])
    assert with_notes({name: {**row, "note": "old"}})[name] == row


def test_a_run_is_taken_in_with_its_verdict_and_interval(tmp_path: Path) -> None:
    (result,) = reproduce(ReproduceSettings(claims=("S15",), quick=True, out=tmp_path / "run"))
    markers = (f"<!-- table: {name} -->\n<!-- end of table: {name} -->" for name in ("claims", *PAGE.tables))
    (tmp_path / "README.md").write_text("\n".join(markers))
    page = dataclasses.replace(PAGE, folder=tmp_path)
    assert page.main(["run", str(tmp_path / "run")]) == 0
    written = (tmp_path / "README.md").read_text()
    row = rows_of(written)["S15"]
    assert row[4] == f"{result.verdict} (quick)" and "**" in row[2]
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
