"""A result and the statistics of its play follow from its lines, and the report shows them."""

import json
from dataclasses import replace

import numpy as np
import pytest
from markdown_it import MarkdownIt

from soccer_env.leagues import find_league
from soccer_env.statistics.figures import FIGURES
from soccer_env.statistics.records import BINS, GoalKind
from soccer_env.train.evaluate import evaluate
from soccer_env.train.evaluate.report import markdown, verdict_sentence
from soccer_env.train.evaluate.results import EvaluationResult, MatchLine, summarise
from soccer_env.train.evaluate.settings import Conditions, EvaluateSettings, conditions_of
from soccer_env.train.evaluate.statistics import goal_rows, play_rows, statistics_by_name, totals

KEYS = {
    "league", "home", "away", "matches", "minutes", "seed", "senses", "wins", "draws", "losses", "goals_for",
    "goals_against", "goal_difference", "win_rate", "points",
}  # fmt: skip
MADE = {"soccer_env": "1.0", "code": "abc"}
ABOUT = {"command": "soccer evaluate --seed 3", "date": "2026-01-02", "commit": "1234567"}


def conditions(matches: int = 20) -> Conditions:
    return conditions_of(EvaluateSettings(matches=matches, seed=3), find_league("legged-2001"))


def lines(scores: list[tuple[int, int]], settings: str = "s") -> list[MatchLine]:
    return [
        MatchLine(n, n // 2, 100 + n // 2, ("home", "away")[n % 2], ours, theirs, 9600, "f" * 32, settings)
        for n, (ours, theirs) in enumerate(scores)
    ]


def result_of(scores: list[tuple[int, int]]) -> EvaluationResult:
    return summarise(conditions(len(scores)), MADE, lines(scores))


NUMBERS = [
    (99.7, 2, "100"), (99.4, 2, "99"), (100.0, 2, "100"), (123.4, 2, "123"), (3.02, 2, "3"), (0.0, 2, "0"),
    (999.7, 3, "1000"), (-999.7, 3, "-1000"), (0.00404, 3, "0.00404"), (0.0000123, 3, "0.0000123"),
    (81.04, 3, "81"), (float("nan"), 2, "nan"), (float("inf"), 3, "inf"),
]  # fmt: skip


def test_what_is_counted() -> None:
    result = result_of([(3, 0), (1, 1), (0, 2), (2, 1)])
    assert (result.wins, result.draws, result.losses, result.goals_for, result.goals_against) == (2, 1, 1, 6, 4)
    means = [interval.mean for interval in (result.goal_difference, result.win_rate, result.points)]
    assert means == pytest.approx([0.5, 0.5, 0.625])
    record = result.as_dict()
    assert set(record) >= KEYS and set(record["points"]) == {"mean", "low", "high"}
    assert record["points"]["low"] <= 0.625 <= record["points"]["high"]
    assert json.loads(json.dumps(record)) == record


@pytest.mark.parametrize(
    ("scores", "verdict"),
    [
        ([(2, 0), (1, 0)] * 10, "beats clearly"),
        ([(2, 0), (1, 0)] * 8 + [(1, 1)] * 4, "beats"),  # 90 % of the points
        ([(0, 2), (0, 1)] * 10, "loses clearly"),
        ([(0, 2), (0, 1)] * 8 + [(1, 1)] * 4, "loses"),
        ([(2, 0), (2, 0), (0, 2), (0, 2)] * 5, "no difference shown"),
        ([(9, 0)] * 8, "no verdict from fewer than 10 matches"),
    ],
)
def test_the_verdict(scores: list[tuple[int, int]], verdict: str) -> None:
    assert result_of(scores).verdict == verdict


def test_home_less_away_of_a_team_against_itself_has_an_interval_and_no_verdict() -> None:
    scores = [(3, 0), (1, 0), (0, 1), (2, 1)] * 5
    result = summarise(replace(conditions(len(scores)), away="chaser"), MADE, lines(scores))
    assert result.goal_difference.mean == 1.0 and result.goal_difference.low < 1.0 < result.goal_difference.high
    assert verdict_sentence(result).startswith("There is no verdict on a team against itself")
    assert "| matches | 20 | a seed each |" in markdown(result, ABOUT)


def test_a_swapped_evaluation_is_the_negative() -> None:
    scores = [(3, 0), (1, 1), (0, 2), (2, 1)] * 5
    there, back = result_of(scores), result_of([(theirs, ours) for ours, theirs in scores])
    assert there.goal_difference.mean == -back.goal_difference.mean
    assert there.points.mean == 1 - back.points.mean
    assert there.goal_difference.low == pytest.approx(-back.goal_difference.high, abs=0.1)


def test_order_of_the_lines_is_of_no_account_but_missing_matches_are_refused() -> None:
    ordered = lines([(3, 0), (1, 1), (0, 2), (2, 1)])
    one, other = (summarise(conditions(4), MADE, chosen) for chosen in (ordered, ordered[::-1]))
    assert one == other
    assert markdown(one, ABOUT) == markdown(other, ABOUT)
    with pytest.raises(ValueError, match="expected matches 0 to 3, got 2 lines"):
        summarise(conditions(4), MADE, lines([(1, 0), (1, 0)]))


def test_the_report_says_who_won_and_how_to_make_it_again() -> None:
    result = result_of([(2, 0), (1, 0)] * 10)
    text = markdown(result, ABOUT)
    assert verdict_sentence(result) == "chaser beats random clearly."
    assert "chaser beats random clearly." in text
    assert "```bash\nsoccer evaluate --seed 3\n```" in text
    assert "| won, drawn, lost | 20, 0, 0 |  |" in text
    assert "| 9 | 109 | 2 : 0 | 1 : 0 |" in text
    assert "1234567" in text and "2026-01-02" in text
    assert "50 more pairs" in markdown(result_of([(1, 0), (0, 1)] * 150), ABOUT)


def test_a_name_is_shown_in_the_report_as_it_is() -> None:
    """A file of a stranger may be called anything."""
    name = "<img src=x onerror=alert(1)>&amp; `a` **b** [c](d) | _e_ sacks_2001.onnx\n```\n# f"
    result = result_of([(3, 0), (1, 1)])
    result = replace(result, conditions=replace(result.conditions, home=name, league=name), trained={name: name})
    shown = markdown(result, {**ABOUT, "command": f"soccer evaluate --home '{name}'"})
    parsed = MarkdownIt("commonmark").enable("table").parse(shown)
    inner = [token for token in parsed if token.type == "inline"]
    kinds = {child.type for token in inner for child in token.children or ()}
    assert {token.type for token in parsed}.isdisjoint({"html_block"})
    assert kinds <= {"text", "text_special", "softbreak", "code_inline"}, kinds
    words = ["".join(child.content for child in token.children or ()) for token in inner]
    plain_name = " ".join(name.split())
    assert words[0] == f"{plain_name} against random"
    assert plain_name in words and f"{plain_name} was trained with" in words
    assert [token.content for token in parsed if token.type == "fence"] == [f"soccer evaluate --home '{name}'\n"]


PLAY = {"home": "chaser", "away": "still", "matches": 4, "minutes": 0.5, "players": 2, "senses": "ideal", "seed": 2}


def line(**given):
    """Return the statistics of a minute, all in play, in which nothing happened but what is given."""
    empty = dict.fromkeys([name for name, _ in statistics_by_name()], 0) | {"played": 60.0, "in_play": 60.0}
    return {**empty, "spell_lengths_for": [0] * BINS, "spell_lengths_against": [0] * BINS, **given}


def test_the_interval_is_that_of_pairs() -> None:
    """Each pair has two shots, in one of its matches or in the other: nothing is unsure."""
    even = totals([line(shots_for=2), line(), line(), line(shots_for=2)] * 5)["shots_for"]
    assert (even.low, even.value, even.high) == (1.0, 1.0, 1.0)
    uneven = totals([line(shots_for=2), line(shots_for=2), line(), line()] * 5)["shots_for"]
    assert uneven.low < 0.8 < uneven.value == 1.0 < 1.2 < uneven.high


def test_every_statistic_has_a_total_and_lines_without_any_have_none() -> None:
    assert [*totals([line()] * 2)] == [name for name, _ in statistics_by_name()]
    assert len(statistics_by_name()) == sum(2 if figure.team else 1 for figure in FIGURES)
    assert totals([{}, {}]) == {}
    assert totals([line(), {}]) == {}


def test_an_evaluation_keeps_them_by_match_and_shows_them(tmp_path) -> None:
    result = evaluate(EvaluateSettings(**PLAY, out=tmp_path))
    lines = [json.loads(text) for text in (tmp_path / "matches.jsonl").read_text().splitlines()]
    for one in lines:
        play = one["statistics"]
        assert (play["goals_for"], play["goals_against"]) == (one["goals_for"], one["goals_against"])
        assert play["played"] == pytest.approx(30.0)
        assert sum(play[f"goals_{kind.name.lower()}_for"] for kind in GoalKind) == one["goals_for"]
    record = json.loads((tmp_path / "result.json").read_text())
    assert record["statistics"]["touches_for"]["total"] == sum(one["statistics"]["touches_for"] for one in lines) > 0
    assert record["statistics"]["touches_against"]["total"] < record["statistics"]["touches_for"]["total"]
    assert {"statistics", "maps"}.isdisjoint(record["results"][0])
    assert record["maps"]["heat_ball"] == np.sum([one["maps"]["heat_ball"] for one in lines], axis=0).tolist()
    shots = [len(record["maps"][f"shots_{side}"]) for side in ("for", "against")]
    assert shots == [record["statistics"][f"shots_{side}"]["total"] for side in ("for", "against")]
    assert record["maps"]["pitch"]["length"] == 3.0
    report = (tmp_path / "report.md").read_text()
    rows = ("shots on target", "shots: saved", "ball in the middle third", "pushed in")
    assert all(f"| {row} |" in report for row in rows)
    assert {row[0] for row in play_rows(result.statistics)} >= {"ball in play", "whistles", "saves"}
    assert len(goal_rows(result.statistics)) == len(GoalKind) + 3
    assert evaluate(EvaluateSettings(**PLAY, out=tmp_path)).statistics == result.statistics


def test_a_folder_whose_lines_lack_statistics_is_refused_in_words(tmp_path) -> None:
    evaluate(EvaluateSettings(**PLAY, out=tmp_path))
    file = tmp_path / "matches.jsonl"
    lines = [json.loads(text) for text in file.read_text().splitlines()]
    lines = [{name: line[name] for name in line.keys() - {"statistics", "maps"}} for line in lines]
    file.write_text("".join(json.dumps(line) + "\n" for line in lines))
    with pytest.raises(ValueError, match="a line has the fields .*statistics"):
        evaluate(EvaluateSettings(**PLAY, out=tmp_path))
