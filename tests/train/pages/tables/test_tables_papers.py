"""The READMEs of the papers' teams show the stored results and the settings; what was not measured is shown so."""

import dataclasses
import json
import re
from dataclasses import fields
from pathlib import Path

import pytest

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.teams import make_team
from soccer_env.train.pages.tables import heinemann
from soccer_env.train.pages.tables.paper_page import PaperPage, bound_in_signs, claims_table
from soccer_env.train.pages.tables.sacks import PAGE
from soccer_env.train.pages.tables.teams import heinemann_rows, heinemann_table
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.results import REMARKS, read_json, remarks_on
from soccer_env.train.papers.settings import ReproduceSettings
from soccer_env.train.papers.verdicts import CONTEXT, NOT


def rows_of(text: str) -> dict[str, list[str]]:
    """Return the cells of each row of a table by the first."""
    lines = [line.strip("|").split(" | ") for line in text.splitlines() if line.startswith("|")]
    return {cells[0].strip(): [cell.strip() for cell in cells] for cells in lines}


PAGES = pytest.mark.parametrize("page", [PAGE, heinemann.PAGE])


@PAGES
def test_the_readme_of_the_team_shows_what_was_measured(page: PaperPage) -> None:
    readme = (page.folder / "README.md").read_text(encoding="utf-8")
    assert page.with_tables(readme, page.stored()) == readme


@PAGES
def test_every_claim_of_the_paper_has_a_row_and_what_was_not_measured_says_so(page: PaperPage) -> None:
    rows = rows_of(claims_table({}, page.claims))
    assert [name for name in rows if name in page.claims] == list(page.claims)
    assert all(rows[name][3] == "not measured" for name in page.claims)
    assert set(page.claims) <= set(all_claims())
    assert all(all_claims()[name].statement == rows[name][1] for name in page.claims)
    numbers = (1, 74) if page is PAGE else (1, 31)
    assert set(page.claims) == {f"{page.claims[0][0]}{n:02}" for n in range(*numbers)}


def test_a_row_shows_the_number_that_decides_with_what_it_is_and_its_bound() -> None:
    rows = rows_of(claims_table(PAGE.stored(), PAGE.claims))
    assert rows["S63"][2:] == ["73.3 % (69.7 to 77.1)", "**not**", "clean, at 3 and 6 cm/s [≥80]"]
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
    page = dataclasses.replace(PAGE, folder=tmp_path, drawn=tmp_path / "figures.json")
    assert page.main(["run", str(tmp_path / "run")]) == 0
    written = (tmp_path / "README.md").read_text()
    row = rows_of(written)["S15"]
    assert row[3] == f"{result.verdict} (quick)" and row[2].startswith(f"{result.estimate:.1f}")
    assert all(said in written for said in ("73 claims: 1 ", "72 not measured", "player_gain"))
    assert list(json.loads((tmp_path / "claims.json").read_text())) == ["S15"]
    ((figure,),) = json.loads((tmp_path / "figures.json").read_text()).values()
    assert figure["title"] == "One pixel of the ball's width" and figure["rules"] == [5.0, 10.0]
    with pytest.raises(ValueError, match="holds no"):
        PAGE.take(empty_run(tmp_path))
    assert page.main(["nonsense"]) == 2


@PAGES
def test_a_claim_that_is_not_reproduced_names_its_likely_cause(page: PaperPage) -> None:
    refuted = [name for name, row in page.stored().items() if row["verdict"] == NOT]
    causes = {name: remarks_on(name, page.paper).get("cause", "") for name in refuted}
    known = ("the paper;", "the simulator;", "our reading;")
    assert [name for name, cause in causes.items() if not cause.startswith(known)] == []


@PAGES
def test_remarks_are_a_line_on_a_claim_with_the_date_of_a_change(page: PaperPage) -> None:
    remarks = read_json(page.folder / REMARKS)
    assert set(remarks) <= set(page.claims)
    changes = [remark["changed"] for remark in remarks.values() if "changed" in remark]
    assert all(re.match(r"2026-\d\d-\d\d: ", change) and len(change.split()) <= 35 for change in changes)
    assert f"{len(changes)} questions changed" in " ".join((page.folder / "README.md").read_text("utf-8").split())


def empty_run(path: Path) -> Path:
    """Return a folder of a run without claims of the paper."""
    found = path / "empty"
    found.mkdir()
    (found / "settings.json").write_text(json.dumps({"conditions": {}, "made_with": {}, "about": {}}))
    (found / "claims.jsonl").write_text("")
    return found


def test_the_teams_of_2006_play_each_other_the_chaser_and_themselves_without_a_part() -> None:
    rows = list(heinemann_rows())
    assert all(make_team(name) for row in rows for name in (row.home, row.away))
    asked = {(row.home, row.away, row.players) for row in rows}
    assert {("heinemann-2006", "chaser", 3), ("heinemann-2006", "chaser", 5)} <= asked
    assert {("heinemann-2006", away, 5) for away in ("weigel-2001", "heinemann-2006:keeper=passive")} <= asked
    spread = {"mean": 0.5, "low": 0.4, "high": 0.6}
    row = {"home": "a", "away": "b", "players": 5, "matches": 2, "minutes": 4.0, "points": spread, "goals": [1, 0],
           "goal_difference": spread, "settings_hash": "f", "command": "play", "passes": [1.25, 1.0]}  # fmt: skip
    assert "| `a` | b | 5v5 | 2 | 1.25 : 1.00 | 50.0 % (40.0 to 60.0) |" in heinemann_table({"rows": [row]})


@PAGES
def test_a_stored_row_was_judged_by_the_criteria_that_the_claim_asks_now(page: PaperPage) -> None:
    for name, row in page.stored().items():
        judged = {found["criterion"]: found for found in row["findings"] if found["verdict"] != CONTEXT}
        asked = {criterion.text: criterion.asked for criterion in all_claims()[name].criteria if criterion.decides}
        assert set(judged) == set(asked), name
        assert all(found.get("asked", asked[text]) == asked[text] for text, found in judged.items()), name
