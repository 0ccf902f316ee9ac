"""The README of the teams of 2006 is what the stored results and the settings say, its figure our own run."""

from soccer_env.teams import make_team
from soccer_env.train.pages.tables import heinemann
from soccer_env.train.pages.tables.paper_page import claims_table
from soccer_env.train.pages.tables.teams import heinemann_rows, heinemann_table
from tests.train.pages.tables.test_tables_sacks import rows_of


def test_the_readme_of_the_team_shows_what_was_measured() -> None:
    readme = (heinemann.PAGE.folder / "README.md").read_text(encoding="utf-8")
    assert heinemann.PAGE.with_tables(readme, heinemann.PAGE.stored()) == readme


def test_every_claim_of_the_paper_has_a_row_but_those_that_nothing_can_measure() -> None:
    assert set(heinemann.PAGE.claims) == {f"H{n:02}" for n in range(1, 29)} - {"H25"}
    rows = rows_of(claims_table({}, heinemann.PAGE.claims))
    assert all(rows[name][3] == "not measured" for name in heinemann.PAGE.claims)


def test_the_papers_figure_is_drawn_from_our_own_runs_the_same_each_time() -> None:
    drawn = heinemann.draw_paths()
    assert drawn.startswith(b"\x89PNG") and drawn == heinemann.draw_paths()


def test_unknown_words_are_refused() -> None:
    assert heinemann.main(["nonsense"]) == 2


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
