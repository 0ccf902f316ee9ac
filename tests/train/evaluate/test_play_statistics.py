"""Statistics of play in evaluations: lines, totals with intervals, tables, and folders of before."""

import json

import numpy as np
import pytest

from soccer_env.statistics.figures import FIGURES
from soccer_env.statistics.records import BINS, GoalKind
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.evaluate.statistics import goal_rows, named, play_rows, totals

PLAY = {"home": "chaser", "away": "still", "matches": 4, "minutes": 0.5, "players": 2, "senses": "ideal", "seed": 2}


def line(**given):
    """Return the statistics of a minute, all in play, in which nothing happened but what is given."""
    empty = dict.fromkeys([name for name, _ in named()], 0) | {"played": 60.0, "in_play": 60.0}
    return {**empty, "spell_lengths_for": [0] * BINS, "spell_lengths_against": [0] * BINS, **given}


def test_counts_are_given_a_minute_and_times_as_shares() -> None:
    lines = [line(shots_for=3, still=15.0), line(shots_for=1, still=15.0, in_play=30.0), line(), line(carried=0.4)]
    found = totals(lines)
    assert (found["shots_for"].total, found["shots_for"].value, found["shots_for"].unit) == (4, 1.0, "/min")
    assert found["still"].value == pytest.approx(100 * 30.0 / 210.0)
    assert found["still"].unit == "%"
    assert found["carried"].total == 0.4
    assert found["idle_for"].value is None  # of no mates


def test_the_interval_is_that_of_pairs() -> None:
    """Each pair has two shots, in one of its matches or in the other: nothing is unsure."""
    even = totals([line(shots_for=2), line(), line(), line(shots_for=2)] * 5)["shots_for"]
    assert (even.low, even.value, even.high) == (1.0, 1.0, 1.0)
    uneven = totals([line(shots_for=2), line(shots_for=2), line(), line()] * 5)["shots_for"]
    assert uneven.low < 0.8 < uneven.value == 1.0 < 1.2 < uneven.high


def test_every_statistic_has_a_total_and_lines_without_any_have_none() -> None:
    assert [*totals([line()] * 2)] == [name for name, _ in named()]
    assert len(named()) == sum(2 if figure.team else 1 for figure in FIGURES)
    assert totals([{}, {}]) == {}
    assert totals([line(), {}]) == {}


def test_an_evaluation_keeps_them_by_match_and_shows_them(tmp_path) -> None:
    result = evaluate(EvaluateSettings(**PLAY, out=tmp_path))
    lines = [json.loads(text) for text in (tmp_path / "matches.jsonl").read_text().splitlines()]
    for one in lines:
        assert one["statistics"]["goals_for"] == one["goals_for"]
        assert one["statistics"]["goals_against"] == one["goals_against"]
        assert one["statistics"]["played"] == pytest.approx(30.0)
        kinds = [one["statistics"][f"goals_{kind.name.lower()}_for"] for kind in GoalKind]
        assert sum(kinds) == one["goals_for"]
    record = json.loads((tmp_path / "result.json").read_text())
    assert record["statistics"]["touches_for"]["total"] == sum(one["statistics"]["touches_for"] for one in lines) > 0
    assert record["statistics"]["touches_against"]["total"] < record["statistics"]["touches_for"]["total"]
    assert "statistics" not in record["results"][0]
    assert record["maps"]["heat_ball"] == np.sum([one["maps"]["heat_ball"] for one in lines], axis=0).tolist()
    shots = [len(record["maps"][f"shots_{side}"]) for side in ("for", "against")]
    assert shots == [record["statistics"][f"shots_{side}"]["total"] for side in ("for", "against")]
    assert record["maps"]["pitch"]["length"] == 3.0
    assert "maps" not in record["results"][0]
    report = (tmp_path / "report.md").read_text()
    assert "| shots on target |" in report
    assert "| shots: saved |" in report
    assert "| ball in the middle third |" in report
    assert "| pushed in |" in report
    assert {row[0] for row in play_rows(result.statistics)} >= {"ball in play", "whistles", "saves"}
    assert len(goal_rows(result.statistics)) == len(GoalKind) + 3
    assert evaluate(EvaluateSettings(**PLAY, out=tmp_path)).statistics == result.statistics


def test_a_folder_whose_lines_lack_statistics_is_refused_in_words(tmp_path) -> None:
    evaluate(EvaluateSettings(**PLAY, out=tmp_path))
    file = tmp_path / "matches.jsonl"
    lines = [json.loads(text) for text in file.read_text().splitlines()]
    file.write_text(
        "".join(json.dumps({k: v for k, v in x.items() if k not in ("statistics", "maps")}) + "\n" for x in lines)
    )
    with pytest.raises(ValueError, match="a line has the fields .*statistics"):
        evaluate(EvaluateSettings(**PLAY, out=tmp_path))
