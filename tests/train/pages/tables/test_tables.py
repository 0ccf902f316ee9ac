"""The tables of the pages are those of tables.json; their matches play again, beside published figures and in drills"""

import copy
import json
from itertools import pairwise

import pytest

from soccer_env.scenes import SCENES
from soccer_env.teams import make_team
from soccer_env.train.casting import controllers_of
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.evaluate.drills import run_drill
from soccer_env.train.pages.tables import pages as tables
from soccer_env.train.pages.tables import teams as tables_teams
from soccer_env.train.pages.tables.drills import TEAMS, drills_of, drills_table
from soccer_env.train.pages.tables.headlines import headlines
from soccer_env.train.pages.tables.plausibility import PUBLISHED, SHOWN, line_of, plausibility_rows, play_of, verdict
from soccer_env.train.pages.tables.teams import row_of

DATA = json.loads(tables.DATA.read_text(encoding="utf-8"))
SAME = all(DATA["scripted"]["about"][name] == tables.about()[name] for name in (*tables.LIBRARIES, "machine"))


@pytest.mark.parametrize("page", sorted(set(tables.PAGES.values())))
def test_every_page_shows_what_was_measured(page: str) -> None:
    assert tables.with_tables(tables.page_text(page), page, DATA) == tables.page_text(page)


def test_every_table_stands_in_its_page_and_in_no_other() -> None:
    assert set(tables.PAGES) == {"headlines", *tables.MEASURE} == {"headlines", *tables.SHOW}
    for name, page in tables.PAGES.items():
        marker = f"<!-- table: {name} -->"
        assert [other for other in set(tables.PAGES.values()) if marker in tables.page_text(other)] == [page]


def test_another_result_changes_its_page_and_the_headlines() -> None:
    changed = copy.deepcopy(DATA)
    asked = {"away": "chaser", "minutes": 10.0, "senses": "sensors", "players": 3}
    (row,) = (row for row in changed["learned"]["rows"] if row.items() >= asked.items())
    row["goal_difference"]["mean"] = -1.23
    shown = {page: tables.with_tables(tables.page_text(page), page, changed) for page in tables.PAGES.values()}
    differ = [page for page, text in shown.items() if text != tables.page_text(page)]
    assert differ == ["README.md", "agents/policies/README.md"]
    assert "-1.23 goals a match" in shown["README.md"]


def test_the_check_names_a_page_that_shows_something_else(monkeypatch: pytest.MonkeyPatch) -> None:
    changed = copy.deepcopy(DATA)
    changed["scripted"]["rows"][0]["points"]["mean"] = 0.123
    monkeypatch.setattr(tables, "replay_row", lambda row: [])
    (problem,) = tables.check(changed, quick=True)
    assert problem.startswith("baselines/README.md does not show")


def test_states_are_taken_anew_where_the_scores_agree_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = [{"command": name, "first_pair": [[1, 0, "old"], [2, 2, "old"]]} for name in ("same", "other")]
    ends = {"same": [[1, 0, "new"], [2, 2, "newer"]], "other": [[1, 0, "new"], [2, 3, "new"]]}
    monkeypatch.setattr(tables, "first_pair", lambda row: ends[row["command"]])
    (problem,) = tables.take_states({"sacks": {"rows": rows}})
    assert problem.startswith("other: ")
    assert rows[0]["first_pair"] == ends["same"] and rows[1]["first_pair"] == [[1, 0, "old"], [2, 2, "old"]]


def test_the_headlines_have_a_command_each() -> None:
    rows = list(headlines(DATA))
    assert len(rows) == 6
    assert {row.command.split()[0] for row in rows} == {"soccer", "make"}


@pytest.mark.skipif(not SAME, reason="other versions or another kind of machine than the table's")
@pytest.mark.parametrize("index", [1, 7, -1])
def test_the_first_pair_of_a_row_plays_again(index: int) -> None:
    row = DATA["scripted"]["rows"][index]
    assert tables.replay_row(row) == []
    wrong = {**row, "first_pair": [[9, 9, "0"], [9, 9, "0"]]}
    assert len(tables.replay_row(wrong)) == 1


@pytest.mark.parametrize("league", tables_teams.LEAGUES)
def test_no_step_of_strength_loses_points_in_the_table(league: str) -> None:
    """Under the rule books neighbours draw most matches: a step may win too little to be told, the whole ladder not."""
    rows = [row for row in DATA["scripted"]["rows"] if (row["league"], row["senses"]) == (league, "ideal")]
    ladder = [row["points"] for n in ("0", "0.25", "0.5", "0.75") for row in rows if row["away"] == f"chaser@{n}"]
    assert all(weaker["high"] >= stronger["mean"] for weaker, stronger in pairwise(ladder))
    assert ladder[0]["low"] > ladder[-1]["high"] and ladder[-1]["mean"] > 0.5


def test_a_missing_marker_is_named() -> None:
    with pytest.raises(ValueError, match="markers of table sensors"):
        tables.with_tables("no markers here", "soccer_env/perception/README.md", DATA)


def test_an_interval_that_meets_the_range_is_inside() -> None:
    assert (PUBLISHED["legged-2001", "goals"].low, PUBLISHED["legged-2001", "goals"].high) == (0.05, 0.7)
    for low, high in ((0.1, 0.3), (0.01, 0.05), (0.70, 2.0)):
        assert verdict("legged-2001", "goals", low, high) == "inside"
    for low, high in ((0.71, 2.0), (0.0, 0.04)):
        assert verdict("legged-2001", "goals", low, high) == "outside"
    assert verdict("legged-2001", "passes", 0.1, 0.3) == ""


def test_published_figures_are_those_of_the_games_they_name() -> None:
    legged = (3, 3, 6, 3, 2, 3, 14, 2, 6, 11, 1, 9)
    assert (sum(legged), len(legged), min(legged) / 20, max(legged) / 20) == (63, 12, 0.05, 0.7)
    middle = (6, 10, 3, 4, 12, 6, 5, 8, 12, 6)
    assert (sum(middle), len(middle), max(middle) / 30) == (72, 10, PUBLISHED["middle-size-2006", "goals"].high)
    assert all((row.league, "goals") in PUBLISHED for row in plausibility_rows())


def test_a_row_shows_what_both_teams_did_together() -> None:
    """So few matches say little: the bound is twice the goals of the richest real game."""
    settings = EvaluateSettings(home="chaser", away="chaser", matches=8, minutes=3.0, senses="ideal", seed=5)
    result = evaluate(settings)
    play = play_of(result)
    assert [*play] == [*SHOWN]
    value, low, high, unit = play["goals"]
    assert value == pytest.approx((result.goals_for + result.goals_against) / (8 * 3.0))
    assert unit == "/min"
    assert low <= value <= high
    assert value < 2 * PUBLISHED["legged-2001", "goals"].high
    assert 50.0 < play["in_play"][0] <= 100.0
    row = row_of(settings, result) | {"play": play}
    assert line_of(row, "goals", "goals").endswith(("| inside |", "| outside |"))
    assert line_of(row, "passes", "passes").endswith("| none found |  |")


def test_every_drill_is_played_in_every_league_that_it_is_for() -> None:
    everybody = {"empty-goal", "shot-at-keeper"}
    middle = {"far-post-shot", "near-post-shot", "receive-pass", "challenge-2003", "three-v-one", "counter-attack"}
    legged = {name for name, scene in SCENES.items() if scene.success != "none"} - middle
    assert {scene.name for scene in drills_of("legged-2001")} == legged > everybody
    assert {scene.name for scene in drills_of("middle-size-2006")} == middle | everybody


def test_every_scripted_team_plays_every_drill() -> None:
    assert {"still", "random", "walker", "chaser", "sacks-2001"} <= set(TEAMS["legged-2001"])
    for teams in TEAMS.values():
        for team in teams:
            make_team(team)


def test_a_save_is_the_business_of_aways_goalkeeper_and_all_else_of_homes_robot() -> None:
    assert controllers_of(SCENES["shot-at-keeper"], "chaser") == {"home": "still", "away": "chaser"}
    assert controllers_of(SCENES["gap-500"], "chaser") == {"home": "chaser", "away_0": "still", "away_1": "still"}


def test_who_stands_still_scores_nothing_and_lets_shots_in() -> None:
    assert run_drill("legged-2001", SCENES["ball-in-corner"], "still", 8) == 0
    assert run_drill("middle-size-2006", SCENES["shot-at-keeper"], "still", 16) < 12


def test_a_table_has_a_row_a_drill_and_a_column_a_team() -> None:
    row = {"league": "legged-2001", "drill": "facing-wall", "rules": "simple", "runs": 100}
    rows = [row | {"team": "still", "successes": 0}, row | {"team": "chaser", "successes": 97}]
    other = rows[1] | {"league": "middle-size-2006", "drill": "empty-goal"}
    text = drills_table({"seed": 1, "rows": [*rows, other]})
    assert "| legged-2001 | `facing-wall` | `simple` | 0 % (0 to 4) | 97 % (92 to 99) |" in text
    assert "| middle-size-2006 | `empty-goal` | `simple` | - | 97 % (92 to 99) |" in text
