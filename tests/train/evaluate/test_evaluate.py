"""An evaluation: pairs with sides swapped, the same whatever the threads, going on where it stopped."""

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.random_numbers import seeds_for
from soccer_env.statistics.records import FRESH
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.evaluate import contest as module
from soccer_env.train.evaluate.results import EvaluationResult

SHORT: dict[str, Any] = {"home": "random", "away": "still", "matches": 10, "minutes": 0.1, "seed": 5}


def short(**changes: Any) -> EvaluationResult:
    return evaluate(EvaluateSettings(**{**SHORT, **changes}))


class Follower:
    """A user's own team: run to the ball, or away from it."""

    name = "follower"
    memory_dtype = np.dtype([])

    def __init__(self, speed: float = 1.0) -> None:
        self.speed = speed

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        commands = view.stand()
        commands[..., 0], commands[..., 2] = self.speed, np.clip(2.0 * view.ball["bearing"], -1.0, 1.0)
        commands[..., 3] = 1.0
        return commands


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_the_result_does_not_depend_on_threads_or_batches(league: str, monkeypatch: pytest.MonkeyPatch) -> None:
    one = short(league=league)
    assert short(league=league, threads=2) == one
    monkeypatch.setattr(module, "BATCH", 1)
    assert short(league=league) == one
    monkeypatch.setattr(module, "BATCH", 3)
    assert short(league=league, threads=2) == one
    assert len({line.state for line in one.lines}) == 10


def test_matches_are_added_to_a_finished_evaluation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    played: list[int] = []
    play = module.play
    monkeypatch.setattr(module, "play", lambda *given: played.extend(given[1]) or play(*given))
    short(matches=4, out=tmp_path / "a")
    assert sorted(played) == [0, 1, 2, 3]
    grown = short(matches=8, out=tmp_path / "a", threads=2)
    assert sorted(played[4:]) == [4, 5, 6, 7]
    whole = short(matches=8, out=tmp_path / "b")
    assert grown == whole
    first, second = ((tmp_path / name / "result.json").read_bytes() for name in "ab")
    assert first == second
    assert short(matches=8, out=tmp_path / "a") == whole and len(played) == 16, "nothing is left to play"
    with pytest.raises(ValueError, match="matches 8 there, 6 now"):
        short(matches=6, out=tmp_path / "a")


def test_every_match_can_be_played_alone() -> None:
    for line in short(matches=4).lines:
        sides = {"home": "random", "away": "still"} if line.side == "home" else {"home": "still", "away": "random"}
        match = Match("legged-2001", seeds=[line.seed], minutes=0.1, controllers=sides, pose="particles")
        while not match.terminated[0]:
            match.step(None)
        assert match.state_hash(0) == line.state
        assert match.matches["step"][0] == line.steps == 0.1 * 60 * 16


def test_pairs_share_a_seed_and_swap_sides() -> None:
    found = [(line.pair, line.seed, line.side) for line in short().lines]
    assert found == [(n, seed, side) for n, seed in enumerate(seeds_for(5, 5).tolist()) for side in ("home", "away")]


def test_a_team_against_itself_plays_no_match_twice() -> None:
    """With sides swapped the second match of a pair would be the first one again."""
    result = short(home="chaser", away="chaser", players=2)
    assert [(line.seed, line.side) for line in result.lines] == [(seed, "home") for seed in seeds_for(5, 10).tolist()]
    assert len({line.state for line in result.lines}) == 10
    assert result.verdict == "no verdict on a team against itself: the goal difference is home less away"
    assert {line.side for line in short(home="chaser", away="chaser", players="1v2").lines} == {"home", "away"}


def test_goals_count_for_the_team_that_scored_them() -> None:
    """5 : 2 for the side called home is 5 : 2 for the first team in an even match and 2 : 5 in an odd one."""
    record = np.zeros(1, [("score", "i8", (2,)), ("step", "i8")])
    record["score"] = (5, 2)
    match: Any = SimpleNamespace(
        matches=record, seeds=[7], statistics=np.full(1, FRESH), state_hash=lambda m: "f",
        settings=SimpleNamespace(rows=(1, 1)),
    )  # fmt: skip
    first, second = (module.line_of_match(match, 0, number, side, "s") for number, side in ((8, "home"), (9, "away")))
    assert (first.side, first.goals_for, first.goals_against) == ("home", 5, 2)
    assert (second.side, second.goals_for, second.goals_against) == ("away", 2, 5)


def test_a_team_of_ones_own_wins_on_both_sides() -> None:
    settings = EvaluateSettings(
        league="middle-size-2006", home="mine", away="still", matches=10, minutes=2.0, players=1, placement="instant",
        rules="simple",
    )  # fmt: skip
    result = evaluate(settings, teams={"mine": Follower()})
    for side in ("home", "away"):
        lines = [line for line in result.lines if line.side == side]
        assert sum(line.goals_for for line in lines) > sum(line.goals_against for line in lines)


def test_a_stopped_run_goes_on_and_ends_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "BATCH", 2)
    whole = short(out=tmp_path / "whole")
    played: list[list[int]] = []
    play = module.play

    def stop_at_the_third(contest: Any, batch: list[int], *rest: Any) -> Any:
        if len(played) == 3:
            raise KeyboardInterrupt
        played.append(batch)
        return play(contest, batch, *rest)

    monkeypatch.setattr(module, "play", stop_at_the_third)
    with pytest.raises(KeyboardInterrupt):
        short(out=tmp_path / "parts")
    path = tmp_path / "parts" / "matches.jsonl"
    path.write_bytes(path.read_bytes()[:-20])  # and the last line was torn
    assert not (tmp_path / "parts" / "result.json").exists()
    played.clear()
    monkeypatch.setattr(module, "play", lambda *given: played.append(given[1]) or play(*given))
    assert short(out=tmp_path / "parts", threads=2) == whole
    assert sum(map(len, played)) == 5, "five of ten matches were on disk whole"
    one, other = (json.loads((tmp_path / name / "result.json").read_text()) for name in ("whole", "parts"))
    assert one == other


def test_a_finished_evaluation_is_not_played_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = short(out=tmp_path)
    files = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    monkeypatch.setattr(module, "play", None)
    assert short(out=tmp_path) == first
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == files
    assert set(files) == {"settings.json", "matches.jsonl", "result.json", "report.md", "report.html"}


def test_other_settings_in_the_same_folder_are_refused_unless_anew(tmp_path: Path) -> None:
    short(matches=2, out=tmp_path)
    before = (tmp_path / "matches.jsonl").read_bytes()
    with pytest.raises(ValueError, match="seed 5 there, 6 now"):
        short(matches=2, seed=6, out=tmp_path)
    assert (tmp_path / "matches.jsonl").read_bytes() == before
    assert short(matches=2, seed=6, out=tmp_path, anew=True).lines[0].seed == seeds_for(6, 1)[0]


def test_what_cannot_be_played_leaves_no_folder(tmp_path: Path) -> None:
    for wrong in ({"senses": "eyes"}, {"home": "nobody"}, {"scene": "empty-goal"}):
        with pytest.raises(ValueError):
            short(out=tmp_path / "new", matches=2, **wrong)
        assert not (tmp_path / "new").exists()


def test_result_json_is_the_contract(tmp_path: Path) -> None:
    short(out=tmp_path, players="2v3", matches=2)
    record = json.loads((tmp_path / "result.json").read_text())
    expected = {
        "league": "legged-2001", "home": "random", "away": "still", "matches": 2, "minutes": 0.1, "seed": 5,
        "senses": "sensors", "pose": "particles", "players": "2v3", "placement": "instant",
    }  # fmt: skip
    assert {name: record[name] for name in expected} == expected
    assert record["wins"] + record["draws"] + record["losses"] == 2
    for name in ("goal_difference", "win_rate", "points"):
        assert list(record[name]) == ["mean", "low", "high"]
    assert [line["match"] for line in record["results"]] == [0, 1]


def test_pictures_of_the_first_match(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    def missing() -> None:
        raise ImportError("pictures need pygame")

    pytest.importorskip("pygame")
    short(out=tmp_path / "drawn", matches=2, picture=True)
    assert (tmp_path / "drawn" / "match.png").read_bytes().startswith(b"\x89PNG")
    monkeypatch.setattr("soccer_env.render.canvas.require_pygame", missing)
    short(out=tmp_path / "without", matches=2, picture=True)
    assert "no picture: pictures need pygame" in capsys.readouterr().err
    assert not (tmp_path / "without" / "match.png").exists()


def test_the_command_prints_a_table_and_judges(tmp_path: Path, soccer: Any) -> None:
    words = ["evaluate", "--home", "still", "--away", "still", "--matches", "2", "--minutes", "0.05", "--out", tmp_path]
    printed = soccer(*words, quiet=True)
    assert "still against still" in printed and "goal difference" in printed
    assert "points 0.500 are below 0.6" in soccer(*words, "--at-least", "0.6", code=1)
