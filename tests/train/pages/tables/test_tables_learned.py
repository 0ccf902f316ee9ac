"""The table of the learned team: a row for each kind of match, a column for each opponent."""

from typing import Any

from soccer_env.train.pages.tables.learned import learned_2006_table, learned_table
from soccer_env.train.pages.tables.teams import scripted_table

ROW: dict[str, Any] = {
    "command": "play", "league": "legged-2001", "home": "learned", "away": "chaser", "senses": "sensors",
    "rules": "league", "players": 3, "matches": 200, "minutes": 4.0, "whistles": [300.0, 200.0],
    "goal_difference": {"mean": 0.5, "low": 0.4, "high": 0.6}, "points": {"mean": 0.62, "low": 0.6, "high": 0.7},
}  # fmt: skip


def test_what_is_unusual_about_a_match_stands_beside_the_team_sizes() -> None:
    others = [{"minutes": 10.0}, {"players": "1v3", "senses": "ideal", "rules": "none"}, {"away": "random"}]
    lines = learned_table({"rows": [ROW, *(ROW | change for change in others)]}).splitlines()
    assert lines[0].startswith("| players | `chaser` | `random` | whistles")
    assert lines[2:5] == [
        "| 3v3 | +0.50 (+0.40 to +0.60) | +0.50 (+0.40 to +0.60) | 1.50 : 1.00 |",
        "| 3v3, 10 minutes | +0.50 (+0.40 to +0.60) | - | 1.50 : 1.00 |",
        "| 1v3, ideal senses, rules none | +0.50 (+0.40 to +0.60) | - | 1.50 : 1.00 |",
    ]


def test_a_weaker_opponent_stands_below_the_table() -> None:
    text = learned_table({"rows": [ROW, ROW | {"away": "sacks-2001@0.5"}]})
    assert "Against weaker teams at 3v3: `sacks-2001@0.5` +0.50 (+0.40 to +0.60)." in text


def test_the_chasers_table_says_how_many_matches_a_column_has() -> None:
    long = ROW | {"away": "still", "senses": "ideal", "matches": 100, "minutes": 10.0}
    text = scripted_table({"rows": [ROW, long]})
    assert "| `chaser` | +0.50 (+0.40 to +0.60), 62 % | - |\n| `still` | - | +0.50 (+0.40 to +0.60), 62 % |" in text
    assert "Columns: 200 matches of 4 minutes, 100 matches of 10 minutes." in text


def test_the_middle_size_has_a_row_a_size_and_a_column_an_opponent() -> None:
    row = ROW | {"clean_goals": [9.0, 12.0]}
    lines = learned_2006_table({"rows": [row, row | {"away": "weigel-2001"}, row | {"players": 1}]}).splitlines()
    assert lines[2] == ("| 3v3 | +0.50 (+0.40 to +0.60), 62 % | 9 of 12 | 1.5 : 1.0 | +0.50 (+0.40 to +0.60), 62 % |")
    assert lines[3] == "| 1v1 | +0.50 (+0.40 to +0.60), 62 % | 9 of 12 | 1.5 : 1.0 | - |"
