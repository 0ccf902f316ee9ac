"""Replays that evaluations keep: of the right matches, proved step by step, right still as matches are added."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.replay import Replay
from soccer_env.train.command.command_line import main
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.evaluate.replays import Keep, kept_in
from soccer_env.train.evaluate.results import MatchLine

SHORT: dict[str, Any] = {"home": "chaser", "away": "still", "matches": 4, "minutes": 0.4, "players": 1, "seed": 1}


def short(out: Path, **changes: Any) -> Any:
    return evaluate(EvaluateSettings(**{**SHORT, "out": out, **changes}))


def line(match: int, ours: int, theirs: int) -> MatchLine:
    return MatchLine(match, match // 2, 7, "home", ours, theirs, 9, f"state {match}", "")


def files(out: Path) -> set[str]:
    return {path.name for path in (out / "replays").iterdir()}


def test_best_and_worst_are_by_goal_difference_then_goals_then_who_came_first() -> None:
    lines = [line(0, 1, 1), line(1, 3, 1), line(2, 4, 2), line(3, 0, 1), line(4, 1, 2), line(5, 1, 2)]
    assert [(kind, one.match) for kind, one in Keep("worst, best").chosen(lines)] == [("best", 2), ("worst", 4)]
    assert [one.match for _, one in Keep("goals").chosen([line(0, 0, 0), line(1, 0, 2)])] == [1]
    assert Keep("goals,best").chosen([]) == []


def test_what_is_kept_is_what_was_played(tmp_path: Path) -> None:
    result = short(tmp_path, keep="best,worst,goals")
    kept = kept_in(tmp_path)
    lines = {one.match: one for one in result.lines}
    goals = sum(one.goals_for + one.goals_against for one in result.lines)
    assert goals > 0 and [one.kind for one in kept] == ["best", "worst"] + ["goals"] * goals
    for one in kept:
        replay = Replay.read(tmp_path / one.file)
        of = lines[one.match]
        assert replay.check() == len(replay) and (tmp_path / one.file).stat().st_size == one.bytes
        assert f"match-{of.match}-seed-{of.seed}" in one.file and (one.seed, one.state) == (of.seed, of.state)
        last = list(replay.play())[-1]
        if one.kind != "goals":
            assert last.matches["score"][0].tolist()[:: 1 if of.side == "home" else -1] == [
                of.goals_for,
                of.goals_against,
            ]
            assert len(replay) == of.steps
    assert main(["replay", str(tmp_path / kept[0].file), "--verify"]) == 0


def test_a_clip_of_a_goal_ends_after_it(tmp_path: Path) -> None:
    short(tmp_path, keep="goals")
    for one in kept_in(tmp_path):
        scored = [
            step for step, match in enumerate(Replay.read(tmp_path / one.file).play()) if match.events["goal"][0] >= 0
        ]
        rate = 16  # [1/s] of the legged league
        assert scored and one.seconds - scored[-1] / rate <= 1.5


def test_more_matches_bring_what_is_kept_up_to_date(tmp_path: Path) -> None:
    short(tmp_path, keep="best,goals")
    before = {one.file: (tmp_path / one.file).stat().st_mtime_ns for one in kept_in(tmp_path)}
    result = short(tmp_path, matches=10)  # nothing is asked for: as before
    kept = kept_in(tmp_path)
    best = Keep("best").chosen(result.lines)[0][1].match
    assert [one.match for one in kept if one.kind == "best"] == [best]
    assert sum(one.kind == "goals" for one in kept) == sum(x.goals_for + x.goals_against for x in result.lines)
    assert files(tmp_path) == {Path(one.file).name for one in kept} | {"kept.json"}
    for one in kept:  # what was there is not played again
        if one.file in before:
            assert (tmp_path / one.file).stat().st_mtime_ns == before[one.file]


def test_files_that_are_damaged_or_gone_are_made_again(tmp_path: Path) -> None:
    short(tmp_path, keep="best,worst")
    whole = {one.file: (tmp_path / one.file).read_bytes() for one in kept_in(tmp_path)}
    first, second = whole
    (tmp_path / first).write_bytes(b"cut")
    (tmp_path / second).unlink()
    short(tmp_path)
    assert {one.file for one in kept_in(tmp_path)} == set(whole)
    assert all(Replay.read(tmp_path / name).check() for name in whole)


@pytest.mark.parametrize(
    "text", ["", "[1]", '{"asked": {}, "replays": [{}]}', '{"asked": {"kinds": 7}, "replays": []}', "[" * 100_000, "7"]
)
def test_a_damaged_list_is_made_again(tmp_path: Path, text: str) -> None:
    (tmp_path / "replays").mkdir()
    (tmp_path / "replays" / "kept.json").write_text(text)
    assert kept_in(tmp_path) == []


def test_a_list_names_no_file_elsewhere(tmp_path: Path) -> None:
    short(tmp_path, keep="best")
    path = tmp_path / "replays" / "kept.json"
    found = json.loads(path.read_text())
    for name in ("file", "page"):
        path.write_text(json.dumps(found | {"replays": [found["replays"][0] | {name: "../../precious.replay"}]}))
        assert kept_in(tmp_path) == []


def test_anew_removes_replays_and_nothing_else(tmp_path: Path) -> None:
    short(tmp_path, keep="best", keep_pages=True)
    (tmp_path / "replays" / "mine.txt").write_text("mine")
    assert any(name.endswith(".html") for name in files(tmp_path))
    short(tmp_path, seed=2, anew=True)
    assert files(tmp_path) == {"mine.txt"}


def test_what_cannot_be_kept_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", "--keep", "besd", "--out", str(tmp_path / "a")]) == 2
    assert "unknown keep 'besd'" in capsys.readouterr().err and not (tmp_path / "a").exists()
    assert main(["evaluate", "--keep", "best"]) == 2
    assert "replays are kept in a folder: give out as well" in capsys.readouterr().err


class Forgetful:
    """A team that plays every match differently."""

    name = "forgetful"
    memory_dtype = np.dtype([])
    fingerprint = "1"

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        commands = view.stand()
        commands[..., 0] = np.random.default_rng().uniform(-1.0, 1.0)
        return commands


def test_a_team_that_does_not_repeat_itself_is_named(tmp_path: Path) -> None:
    settings = EvaluateSettings(**{**SHORT, "home": "forgetful", "matches": 2, "out": tmp_path, "keep": "best"})
    with pytest.raises(ValueError, match="match 0 .* cannot be kept: played again, it ended differently"):
        evaluate(settings, teams={"forgetful": Forgetful()})
    assert evaluate(replace(settings, keep=""), teams={"forgetful": Forgetful()}).lines
