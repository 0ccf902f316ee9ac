"""The README's tables are those of tables.json, and the matches behind them play again."""

import copy
import json

import pytest

from soccer_env.train.tables import pages as tables
from soccer_env.train.tables import teams as tables_teams

DATA = json.loads(tables.DATA.read_text(encoding="utf-8"))
SAME = all(DATA["scripted"]["about"][name] == tables.about()[name] for name in (*tables.LIBRARIES, "machine"))


def test_the_readme_shows_what_was_measured() -> None:
    readme = tables.README.read_text(encoding="utf-8")
    assert tables.with_tables(readme, DATA) == readme
    changed = copy.deepcopy(DATA)
    changed["scripted"]["rows"][0]["points"]["mean"] = 0.123
    assert tables.with_tables(readme, changed) != readme


@pytest.mark.skipif(not SAME, reason="other versions or another kind of machine than the table's")
@pytest.mark.parametrize("index", [1, 7, -1])
def test_the_first_pair_of_a_row_plays_again(index: int) -> None:
    row = DATA["scripted"]["rows"][index]
    assert tables.replay_row(row) == []
    wrong = {**row, "first_pair": [[9, 9, "0"], [9, 9, "0"]]}
    assert len(tables.replay_row(wrong)) == 1


def test_every_step_of_strength_wins_points_in_the_table() -> None:
    for league in tables_teams.LEAGUES:
        ladder = [
            row["points"]["mean"]
            for strength in ("0", "0.25", "0.5", "0.75")
            for row in DATA["scripted"]["rows"]
            if row["league"] == league and row["senses"] == "ideal" and row["away"] == f"chaser@{strength}"
        ]
        assert ladder == sorted(ladder, reverse=True) and ladder[-1] > 0.5


def test_a_missing_marker_is_named() -> None:
    with pytest.raises(ValueError, match="markers of table sensors"):
        tables.with_tables("no markers here", DATA)
