"""The table of the learned team: a row for each kind of match, a column for each opponent."""

from typing import Any

from soccer_env.train.pages.tables.learned import learned_table
from soccer_env.train.pages.tables.teams import scripted_table

ROW: dict[str, Any] = {
    "command": "play", "league": "legged-2001", "home": "learned", "away": "chaser", "senses": "sensors",
    "rules": "league", "players": 3, "matches": 200, "minutes": 4.0, "whistles": [300.0, 200.0],
    "goal_difference": {"mean": 0.5, "low": 0.4, "high": 0.6}, "clean_goals": [9.0, 12.0],
    "points": {"mean": 0.62, "low": 0.6, "high": 0.7},
}  # fmt: skip


def test_a_learned_team_has_a_row_a_team_size_and_a_column_an_opponent() -> None:
    others = [{"away": "weigel-2001"}, {"players": 1}]
    lines = learned_table({"rows": [ROW, *(ROW | change for change in others)]}).splitlines()
    value = "+0.50 (+0.40 to +0.60), 62 %"
    assert lines[0].startswith("| players | `chaser` | clean goals, of all | whistles")
    assert lines[2:4] == [
        f"| 3v3 | {value} | 9 of 12 | 1.5 : 1.0 | {value} |",
        f"| 1v1 | {value} | 9 of 12 | 1.5 : 1.0 | - |",
    ]
    assert lines[5].startswith("Goal difference a match and share of the points, in 200 matches a cell, of 4 minutes")


def test_the_chasers_table_says_how_many_matches_a_column_has() -> None:
    long = ROW | {"away": "still", "senses": "ideal", "matches": 100, "minutes": 10.0}
    text = scripted_table({"rows": [ROW, long]})
    assert "| `chaser` | +0.50 (+0.40 to +0.60), 62 % | - |\n| `still` | - | +0.50 (+0.40 to +0.60), 62 % |" in text
    assert "Columns: 200 matches of 4 minutes, 100 matches of 10 minutes." in text
