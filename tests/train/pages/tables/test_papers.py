"""The README of each paper's team is what stored results and settings say; what was not measured is shown so."""

import dataclasses
import json
import re
from dataclasses import fields
from pathlib import Path

import pytest

from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.baselines.weigel_2001.planner import PlannerSettings
from soccer_env.teams import make_team
from soccer_env.train.pages.tables import heinemann
from soccer_env.train.pages.tables.paper_page import claims_table, with_notes
from soccer_env.train.pages.tables.sacks import PAGE
from soccer_env.train.pages.tables.sacks_settings import settings_table
from soccer_env.train.pages.tables.teams import heinemann_rows, heinemann_table
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.settings import ReproduceSettings


def rows_of(text: str) -> dict[str, list[str]]:
    lines = [line.strip("|").split(" | ") for line in text.splitlines() if line.startswith("|")]
    return {cells[0].strip(): [cell.strip() for cell in cells] for cells in lines}


@pytest.mark.parametrize("page", [PAGE, heinemann.PAGE])
def test_the_readme_of_the_team_shows_what_was_measured(page) -> None:
    readme = (page.folder / "README.md").read_text(encoding="utf-8")
    assert page.with_tables(readme, page.stored()) == readme


@pytest.mark.parametrize("page", [PAGE, heinemann.PAGE])
def test_every_claim_of_the_paper_has_a_row_and_what_was_not_measured_says_so(page) -> None:
    rows = rows_of(claims_table({}, page.claims))
    assert [name for name in rows if name in page.claims] == list(page.claims)
    assert all(rows[name][4] == "not measured" for name in page.claims)
    assert all(all_claims()[name].statement in rows[name][1] for name in page.claims)
    assert PAGE.main(["nonsense"]) == heinemann.main(["nonsense"]) == 2


def test_every_claim_is_built_but_one_that_nothing_can_measure() -> None:
    assert set(PAGE.claims) == {f"S{n:02}" for n in range(1, 73)}
    assert set(heinemann.PAGE.claims) == {f"H{n:02}" for n in range(1, 29)} - {"H25"}
    assert all_claims()["S26"].without is not None


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
    assert "72 claims: 1 " in written and "71 not measured" in written
    assert list(json.loads((tmp_path / "claims.json").read_text())) == ["S15"]
    with pytest.raises(ValueError, match="holds no"):
        PAGE.take(empty_run(tmp_path))


def empty_run(path: Path) -> Path:
    """Return a folder of a run without claims of the paper."""
    found = path / "empty"
    found.mkdir()
    (found / "settings.json").write_text(json.dumps({"conditions": {}, "made_with": {}, "about": {}}))
    (found / "claims.jsonl").write_text("")
    return found


def test_every_setting_of_team_and_planner_stands_in_its_table() -> None:
    for part, settings in (("settings", HeinemannSettings), ("planner", PlannerSettings)):
        rows = rows_of(heinemann.PAGE.tables[part]())
        assert {f"`{field.name}`" for field in fields(settings)} <= set(rows)


def test_the_papers_figure_is_drawn_from_our_own_runs_the_same_each_time() -> None:
    drawn = heinemann.draw_paths()
    assert drawn.startswith(b"\x89PNG") and drawn == heinemann.draw_paths()


def test_the_teams_of_2006_play_each_other_the_chaser_and_themselves_without_a_part() -> None:
    rows = list(heinemann_rows())
    assert all(make_team(name) for row in rows for name in (row.home, row.away))
    asked = {(row.home, row.away, row.players) for row in rows}
    assert {("heinemann-2006", "chaser", 3), ("heinemann-2006", "chaser", 5)} <= asked
    assert {("heinemann-2006", away, 5) for away in ("weigel-2001", "heinemann-2006:keeper=passive")} <= asked
    spread = {"mean": 0.5, "low": 0.4, "high": 0.6}
    row = {"home": "a", "away": "b", "players": 5, "matches": 2, "minutes": 4.0, "points": spread, "goals": [1, 0],
           "goal_difference": spread, "settings_hash": "f", "command": "play", "passes": [1.25, 1.0]}  # fmt: skip
    assert "| `a` | b | 5 v 5 | 2 | 1.25 : 1.00 | 50.0 % (40.0 to 60.0) |" in heinemann_table({"rows": [row]})
