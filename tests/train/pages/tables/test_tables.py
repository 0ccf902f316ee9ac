"""The tables of the pages are those of tables.json, and the matches behind them play again."""

import copy
import json
from itertools import pairwise

import pytest

from soccer_env.train.evaluate.settings import EvaluateSettings
from soccer_env.train.pages.tables import pages as tables
from soccer_env.train.pages.tables import teams as tables_teams
from soccer_env.train.pages.tables.headlines import headlines
from soccer_env.train.provenance import play_facts

DATA = json.loads(tables.DATA.read_text(encoding="utf-8"))
SAME = all(DATA["scripted"]["about"].get(name, "1") == fact for name, fact in play_facts().items())


@pytest.mark.parametrize("page", sorted(set(tables.PAGES.values())))
def test_every_page_shows_what_was_measured(page: str) -> None:
    assert tables.fill_page_tables(tables.page_text(page), page, DATA) == tables.page_text(page)


def test_every_table_stands_in_its_page_and_in_no_other() -> None:
    assert set(tables.PAGES) == {"headlines", *tables.TABLES}
    for name, page in tables.PAGES.items():
        holders = [one for one in set(tables.PAGES.values()) if f"<!-- table: {name} -->" in tables.page_text(one)]
        assert holders == [page]


def test_another_result_changes_its_page_and_the_headlines() -> None:
    changed = copy.deepcopy(DATA)
    (row,) = (
        row
        for row in changed["learned"]["rows"]
        if (row["away"], row["minutes"], row["senses"], row["players"]) == ("chaser", 20.0, "sensors", 3)
    )
    row["goal_difference"]["mean"] = -1.23
    differ = [
        page
        for page in dict.fromkeys(tables.PAGES.values())
        if tables.fill_page_tables(tables.page_text(page), page, changed) != tables.page_text(page)
    ]
    assert differ == ["README.md", "agents/policies/README.md"]
    assert "-1.23 (" in tables.fill_page_tables(tables.page_text("README.md"), "README.md", changed)


def test_the_check_names_a_page_that_shows_something_else(monkeypatch: pytest.MonkeyPatch) -> None:
    changed = copy.deepcopy(DATA)
    changed["scripted"]["rows"][0]["points"]["mean"] = 0.123  # shown as 12 %
    monkeypatch.setattr(tables, "replay_row", lambda row: [])
    (problem,) = tables.check(changed, quick=True)
    assert problem.startswith("baselines/README.md does not show")


def test_states_are_taken_anew_where_the_scores_agree_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = [{"command": name, "first_pair": [[1, 0, "old"], [2, 2, "old"]]} for name in ("same", "other")]
    ends = {"same": [[1, 0, "new"], [2, 2, "newer"]], "other": [[1, 0, "new"], [2, 3, "new"]]}
    monkeypatch.setattr(tables, "first_pair", lambda row: ends[row["command"]])
    (problem,) = tables.update_final_states({"sacks": {"rows": rows}})
    assert problem.startswith("other: ")
    assert rows[0]["first_pair"] == ends["same"] and rows[1]["first_pair"] == [[1, 0, "old"], [2, 2, "old"]]


def test_the_headlines_have_a_command_each() -> None:
    rows = list(headlines(DATA))
    assert len(rows) == 7
    assert {row.command.split()[0] for row in rows} == {"soccer", "make"}


@pytest.mark.skipif(not SAME, reason="other versions, machine or world than the table's")
@pytest.mark.parametrize("index", [1, 7, -1])
def test_the_first_pair_of_a_row_plays_again(index: int) -> None:
    row = DATA["scripted"]["rows"][index]
    assert tables.replay_row(row) == []
    wrong = {**row, "first_pair": [[9, 9, "0"], [9, 9, "0"]]}
    assert len(tables.replay_row(wrong)) == 1


@pytest.mark.parametrize("league", tables_teams.LEAGUES)
def test_no_step_of_strength_loses_points_in_the_table(league: str) -> None:
    """Under the rule books neighbours draw most matches: a step may win too little to be told, the whole ladder not."""
    ladder = [
        row["points"]
        for strength in ("0", "0.25", "0.5", "0.75")
        for row in DATA["scripted"]["rows"]
        if row["league"] == league and row["senses"] == "ideal" and row["away"] == f"chaser@{strength}"
    ]
    assert all(weaker["high"] >= stronger["mean"] for weaker, stronger in pairwise(ladder))
    assert ladder[0]["low"] > ladder[-1]["high"] and ladder[-1]["mean"] > 0.5


def test_a_missing_marker_is_named() -> None:
    with pytest.raises(ValueError, match="markers of table sensors"):
        tables.fill_page_tables("no markers here", "soccer_env/perception/README.md", DATA)


@pytest.mark.parametrize(("words", "ray"), [(["scripted"], None), (["scripted", "--ray", "head:6379"], "head:6379")])
def test_a_table_is_measured_on_the_cluster_that_is_named(
    words: list[str], ray: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = []

    def refuse(settings: EvaluateSettings) -> None:
        asked.append((settings.ray, settings.threads))
        raise LookupError

    monkeypatch.setattr(tables_teams, "evaluate", refuse)
    with pytest.raises(LookupError):
        tables.main(words)
    assert asked == [(ray, 2 if ray is None else 1)]
    assert tables.main(["--check", "--ray"]) == 2
