"""A result follows from its lines; a folder goes on where it was and refuses other settings."""

import json
from dataclasses import replace

import pytest
from markdown_it import MarkdownIt

from soccer_env.leagues import find_league
from soccer_env.train.evaluate.report import markdown, plain, sentence
from soccer_env.train.evaluate.results import EvaluationResult, MatchLine, summarise
from soccer_env.train.evaluate.settings import Conditions, EvaluateSettings, conditions_of

MADE = {"soccer_env": "1.0", "code": "abc"}
ABOUT = {"command": "soccer evaluate --seed 3", "date": "2026-01-02", "commit": "1234567"}
KEYS = {
    "league",
    "home",
    "away",
    "matches",
    "minutes",
    "seed",
    "senses",
    "wins",
    "draws",
    "losses",
    "goals_for",
    "goals_against",
    "goal_difference",
    "win_rate",
    "points",
}


def conditions(matches: int = 20) -> Conditions:
    return conditions_of(EvaluateSettings(matches=matches, seed=3), find_league("legged-2001"))


def lines(scores: list[tuple[int, int]], settings: str = "s") -> list[MatchLine]:
    return [
        MatchLine(n, n // 2, 100 + n // 2, ("home", "away")[n % 2], ours, theirs, 9600, "f" * 32, settings)
        for n, (ours, theirs) in enumerate(scores)
    ]


def result_of(scores: list[tuple[int, int]]) -> EvaluationResult:
    return summarise(conditions(len(scores)), MADE, lines(scores))


def test_what_is_counted() -> None:
    result = result_of([(3, 0), (1, 1), (0, 2), (2, 1)])
    assert (result.wins, result.draws, result.losses) == (2, 1, 1)
    assert (result.goals_for, result.goals_against) == (6, 4)
    assert result.goal_difference.mean == pytest.approx(0.5)
    assert result.win_rate.mean == pytest.approx(0.5)
    assert result.points.mean == pytest.approx(0.625)
    record = result.as_dict()
    assert set(record) >= KEYS
    assert set(record["points"]) == {"mean", "low", "high"}
    assert record["points"]["low"] <= 0.625 <= record["points"]["high"]
    assert json.loads(json.dumps(record)) == record


def test_the_pair_is_the_unit() -> None:
    """Home advantage alone: each team wins at home by 5. Every pair is even, so nothing is unsure."""
    result = result_of([(5, 0), (0, 5)] * 10)
    assert (result.goal_difference.low, result.goal_difference.high) == (0.0, 0.0)
    assert (result.points.low, result.points.high) == (0.5, 0.5)


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


def test_a_swapped_evaluation_is_the_negative() -> None:
    scores = [(3, 0), (1, 1), (0, 2), (2, 1)] * 5
    there, back = result_of(scores), result_of([(theirs, ours) for ours, theirs in scores])
    assert there.goal_difference.mean == -back.goal_difference.mean
    assert there.points.mean == 1 - back.points.mean
    assert there.goal_difference.low == pytest.approx(-back.goal_difference.high, abs=0.1)


def test_order_of_the_lines_is_of_no_account() -> None:
    ordered = lines([(3, 0), (1, 1), (0, 2), (2, 1)])
    one, other = (summarise(conditions(4), MADE, chosen) for chosen in (ordered, ordered[::-1]))
    assert one == other
    assert markdown(one, ABOUT) == markdown(other, ABOUT)


def test_missing_and_extra_matches_are_refused() -> None:
    with pytest.raises(ValueError, match="expected matches 0 to 3, got 2 lines"):
        summarise(conditions(4), MADE, lines([(1, 0), (1, 0)]))


def test_the_report_says_who_won_and_how_to_make_it_again() -> None:
    result = result_of([(2, 0), (1, 0)] * 10)
    text = markdown(result, ABOUT)
    assert sentence(result) == "chaser beats random clearly."
    assert "chaser beats random clearly." in text
    assert "```bash\nsoccer evaluate --seed 3\n```" in text
    assert "| won, drawn, lost | 20, 0, 0 |  |" in text
    assert "| 9 | 109 | 2 : 0 | 1 : 0 |" in text
    assert "1234567" in text and "2026-01-02" in text


def test_a_long_report_leaves_pairs_out() -> None:
    text = markdown(result_of([(1, 0), (0, 1)] * 150), ABOUT)
    assert "50 more pairs" in text


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (99.7, 2, "100"), (99.4, 2, "99"), (100.0, 2, "100"), (123.4, 2, "123"), (3.02, 2, "3"), (0.0, 2, "0"),
        (999.7, 3, "1000"), (-999.7, 3, "-1000"), (0.00404, 3, "0.00404"), (0.0000123, 3, "0.0000123"),
        (81.04, 3, "81"), (float("nan"), 2, "nan"), (float("inf"), 3, "inf"),
    ],
)  # fmt: skip
def test_numbers_of_tables_are_plain(value: float, digits: int, text: str) -> None:
    assert plain(value, digits) == text


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
